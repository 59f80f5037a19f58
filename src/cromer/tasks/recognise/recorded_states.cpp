#include "cromer/tasks/recognise/recorded_states.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "cromer/base/number.h"
#include "cromer/base/quantity.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/columns.h"
#include "cromer/read/in_file.h"
#include "cromer/read/time.h"

namespace cromer::core {
namespace {

/// A number as it is written: d.ddd times ten to the exponent.
struct Written {
  int digits = 0;    ///< significant ones; 0 of zero
  int exponent = 0;  ///< of the first digit

  int last_place() const { return exponent - digits + 1; }
};

Written written(double value) {
  if (value == 0) return {};
  std::array<char, 32> buffer;
  const std::string_view text(buffer.data(),
                              static_cast<std::size_t>(write_shortest(buffer.data(), value) - buffer.data()));
  const std::string_view mantissa = text.substr(0, std::min(text.find('e'), text.size()));
  Written number{.exponent = static_cast<int>(std::floor(std::log10(std::abs(value))))};
  int zeros = 0;
  for (const char c : mantissa) {
    if (c < '0' || c > '9' || (number.digits == 0 && c == '0')) continue;
    zeros = c == '0' ? zeros + 1 : 0;
    ++number.digits;
  }
  number.digits -= zeros;
  return number;
}

/// How finely each value of a column is written, in the column's unit: to a decimal place, or to so many
/// digits.
std::vector<double> rounding_steps(const std::vector<double>& values) {
  constexpr int of_a_double = 16;
  std::vector<Written> all;
  int most_digits = 1, last_place = std::numeric_limits<int>::max();
  int largest = std::numeric_limits<int>::min();
  for (const double value : values) {
    const Written each = all.emplace_back(written(value));
    if (each.digits == 0) continue;
    most_digits = std::max(most_digits, each.digits);
    largest = std::max(largest, each.exponent);
    last_place = std::min(last_place, each.last_place());
  }
  if (largest == std::numeric_limits<int>::min())
    return std::vector<double>(values.size(), 0.0);  // zeros alone
  // Written to a decimal place, no value has a digit beyond that of the largest.
  const bool to_a_place = last_place >= largest - (most_digits - 1);
  std::vector<double> steps;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double of_double = std::numeric_limits<double>::epsilon() * std::abs(values[i]);
    double step = of_double;
    if (most_digits < of_a_double && to_a_place)
      step = std::pow(10.0, last_place);
    else if (most_digits < of_a_double && all[i].digits > 0)
      step = std::pow(10.0, all[i].exponent - most_digits + 1);
    steps.push_back(std::max(step, of_double));
  }
  return steps;
}

/// The rms of what rounding to these steps does.
double rms_rounding(const std::vector<double>& steps) {
  double sum = 0;
  for (const double step : steps) sum += step * step / 12;
  return std::sqrt(sum / static_cast<double>(steps.size()));
}

/// Whether the values are numbers in single precision, written to more digits than those have.
bool all_single(const std::vector<double>& values, const std::vector<double>& steps) {
  constexpr double single = std::numeric_limits<float>::epsilon();
  std::size_t telling = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto nearest = static_cast<double>(static_cast<float>(values[i]));
    if (std::abs(nearest - values[i]) > 0.51 * steps[i]) return false;
    if (steps[i] < 0.1 * single * std::abs(values[i])) ++telling;
  }
  return telling >= fewest_states;
}

/// The number of fewest digits within `error` of `value` > 0, if it has so few that another like it would not
/// stand there by chance; `likely`: if no other stands there.
std::optional<double> round_number_near(double value, double error, bool likely) {
  for (int digits = 1; digits <= 15; ++digits) {
    const double rounded = leading_number(fmt::format("{:.{}e}", value, digits - 1))->value;
    if (std::abs(rounded - value) > error) continue;
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - digits + 1);
    const double by_chance = likely ? 1 : 0.05;
    return 2 * error < by_chance * unit ? std::optional(rounded) : std::nullopt;
  }
  return std::nullopt;
}

/// The line through the times by least squares.
struct EvenTimes {
  double start = 0, spacing = 0;  // [s]
};

EvenTimes even_times(const std::vector<double>& t) {
  const auto n = static_cast<double>(t.size());
  const double middle = (n - 1) / 2;
  double mean = 0, slope = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    mean += t[i] / n;
    slope += (static_cast<double>(i) - middle) * (t[i] - t.front());
  }
  slope /= n * (n * n - 1) / 12;
  return {mean - slope * middle, slope};
}

/// The column of a quantity, or the one asked for; the Error says how to name it.
Result<std::size_t> column_of(const Recording& recording, const std::string& name, int run,
                              std::pair<std::string_view, std::string_view> quantities, bool is_velocity) {
  const Table& table = recording.table;
  if (!name.empty()) return find_column(table, name, run);
  std::vector<std::size_t> alike, others;
  for (const std::string_view quantity : {quantities.first, quantities.second}) {
    for (std::size_t j = 0; j < table.columns.size(); ++j)
      if (table.columns[j].run == run && table.columns[j].quantity == quantity) alike.push_back(j);
    if (!alike.empty()) break;
  }
  if (alike.size() == 1) return alike.front();
  for (std::size_t j = 0; j < table.columns.size(); ++j)
    if (table.columns[j].run == run && table.columns[j].quantity != "time" &&
        table.columns[j].quantity != "index")
      others.push_back(j);
  // Without names, the columns stand in the usual order.
  if (!recording.named && alike.empty() && others.size() == 2) return others[is_velocity ? 1 : 0];
  return Error{is_velocity ? "which_column_is_the_velocity" : "which_column_is_the_position",
               {{"columns", quoted_titles(table.columns, alike.empty() ? others : alike)}}};
}

/// The spacing of the times; an Error where they are not even to their rounding.
Result<void> set_spacing(const std::vector<double>& t, const std::vector<double>& steps,
                         const std::vector<long>& lines, RecordedStates& states) {
  const EvenTimes even = even_times(t);
  const double rounding = *std::max_element(steps.begin(), steps.end());
  const double single = states.single ? std::numeric_limits<float>::epsilon() * std::abs(t.back()) : 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double expected = even.start + static_cast<double>(i) * even.spacing;
    // Times that a simulator adds up drift from the line.
    const double most = 1.01 * rounding + single + (states.single ? 1e-3 : 1e-6) * even.spacing;
    if (!(even.spacing > 0) || std::abs(t[i] - expected) > most)
      return Error{"states_not_even",
                   {{"line", lines[i]}, {"t", t[i]}, {"even", expected}, {"spacing", even.spacing}}};
  }
  const double length = t.back() - t.front(), error = (rounding + single) / length;
  states.spacing = even.spacing;
  // A step is a round number, or so many make a second: all the more where all times are its multiples.
  const auto are_multiples = [&](double spacing) {
    for (std::size_t i = 0; i < t.size(); ++i)
      if (std::abs(t[i] - t.front() - static_cast<double>(i) * spacing) > 1e-9 * spacing) return false;
    return true;
  };
  const auto nearest = round_number_near(even.spacing, error * even.spacing, true);
  const bool likely = nearest && are_multiples(*nearest);
  if (const auto spacing = round_number_near(even.spacing, error * even.spacing, likely))
    states.spacing = *spacing;
  else if (const auto rate = round_number_near(1 / even.spacing, error / even.spacing, false))
    states.spacing = 1 / *rate;
  else
    states.spacing_error = error;
  return {};
}

}  // namespace

Result<RecordedStates> recorded_states(const Recording& recording, const StateColumns& columns,
                                       const ReadOptions& options) {
  const auto refuse = [&](const Notice& why) { return Error{in_file(recording.file, why)}; };
  const std::vector<int> all = runs(recording);
  if (all.empty()) return refuse(Notice{"no_column_of_numbers"});
  if (columns.run == 0 && all.size() > 1) return refuse(Notice{"which_run", {{"runs", all.size()}}});
  const int run = columns.run > 0 ? columns.run : all.front();
  if (const auto known = check_run(recording, run); !known) return known.error();
  const auto x = column_of(recording, columns.position, run, {"position", "angle"}, false);
  if (!x) return refuse(x.error().notice);
  const auto v = column_of(recording, columns.velocity, run, {"velocity", "angular velocity"}, true);
  if (!v) return refuse(v.error().notice);
  const auto time = dialects::time_column_of(recording.table, *x);
  if (!time && options.rate <= 0) return refuse(Notice{"no_time_column"});

  const auto& table = recording.table.columns;
  RecordedStates states;
  states.position = column_title(table[*x]);
  states.velocity = column_title(table[*v]);
  std::vector<double> t, xs, vs;
  std::vector<long> lines;
  const std::size_t rows = rows_of_run(recording.table, run);
  for (std::size_t i = 0; i < rows; ++i) {
    const long line = line_of(recording, *x, i);
    const double at = time ? table[*time].values[i] : static_cast<double>(i) / options.rate;
    for (const double value : {at, table[*x].values[i], table[*v].values[i]})
      if (!std::isfinite(value)) return refuse(Notice{"state_is_missing", {{"line", line}}});
    t.push_back(at);
    xs.push_back(table[*x].values[i]);
    vs.push_back(table[*v].values[i]);
    lines.push_back(line);
  }
  if (t.size() < fewest_states)
    return refuse(Notice{"too_few_states", {{"rows", t.size()}, {"fewest", fewest_states}}});

  const auto in_si = [](std::vector<double>& values, double factor) {
    for (double& value : values) value *= factor;
  };
  const std::size_t used = std::min(t.size(), most_recorded_states);
  xs.resize(used);
  vs.resize(used);
  std::vector<double> t_steps = time ? rounding_steps(t) : std::vector<double>(t.size(), 0.0);
  std::vector<double> x_steps = rounding_steps(xs), v_steps = rounding_steps(vs);
  states.single = all_single(xs, x_steps) && all_single(vs, v_steps);
  if (time)
    for (auto* values : {&t, &t_steps}) in_si(*values, to_si(table[*time]).factor);
  for (auto* values : {&xs, &x_steps}) in_si(*values, to_si(table[*x]).factor);
  for (auto* values : {&vs, &v_steps}) in_si(*values, to_si(table[*v]).factor);
  if (const auto good = set_spacing(t, t_steps, lines, states); !good) return refuse(good.error().notice);
  states.x_rounding = rms_rounding(x_steps);
  states.v_rounding = rms_rounding(v_steps);
  t.resize(used);
  states.rows = {std::move(t), std::move(xs), std::move(vs)};
  return states;
}

}  // namespace cromer::core
