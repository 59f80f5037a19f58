#include "cromer/documents/csv/fit.h"
#include "cromer/documents/words/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/read/column_kind.h"
#include "cromer/report/csv.h"

namespace cromer::core {
namespace {

/// A quantity of the table's head: one of another unit (the equilibrium of an angle) is another column.
struct Quantity {
  std::string name, unit;

  friend bool operator==(const Quantity&, const Quantity&) = default;
  std::string heading(std::string_view what) const {
    return name + std::string(what) + (unit.empty() || unit == "1" ? "" : " (" + unit + ")");
  }
};

/// All quantities of one recording, in the order of the JSON document.
std::vector<Parameter> numbers_of(const FittedRecording& fitted) {
  std::vector<Parameter> all = fitted.parameters;
  all.insert(all.end(), fitted.derived.begin(), fitted.derived.end());
  for (std::size_t i = 0; i < fitted.segments.size(); ++i)
    all.push_back({fmt::format("decay_rate_segment_{}", i + 1), fitted.segments[i].rate, "1/s"});
  if (fitted.decay_rate_mean) all.push_back({"decay_rate_mean", *fitted.decay_rate_mean, "1/s"});
  if (fitted.reynolds_max) all.push_back({"reynolds_max", *fitted.reynolds_max, "1"});
  if (fitted.keulegan_carpenter) all.push_back({"keulegan_carpenter_max", *fitted.keulegan_carpenter, "1"});
  return all;
}

/// A quantity takes its place behind the one that stands before it in its own recording.
void add_quantities(std::vector<Quantity>& head, const FittedRecording& fitted) {
  std::size_t place = 0;
  for (const auto& number : numbers_of(fitted)) {
    const Quantity quantity{number.name, number.unit};
    const auto known = std::find(head.begin(), head.end(), quantity);
    if (known != head.end()) {
      place = static_cast<std::size_t>(known - head.begin()) + 1;
      continue;
    }
    head.insert(head.begin() + static_cast<std::ptrdiff_t>(place), quantity);
    ++place;
  }
}

double or_empty(double value) {
  return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
}

void append_row(std::string& out, const FittedRecording& fitted, const std::vector<Quantity>& head) {
  const std::vector<Parameter> numbers = numbers_of(fitted);
  std::vector<double> cells;
  for (const auto& quantity : head) {
    const auto found = std::find_if(numbers.begin(), numbers.end(), [&](const Parameter& number) {
      return number.name == quantity.name && number.unit == quantity.unit;
    });
    const Estimate estimate =
        found == numbers.end() ? Estimate{HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL} : found->estimate;
    cells.push_back(or_empty(estimate.value));
    cells.push_back(or_empty(estimate.standard_error));
    cells.push_back(or_empty(estimate.low));
    cells.push_back(or_empty(estimate.high));
  }
  cells.push_back(or_empty(fitted.parameters.empty() ? HUGE_VAL : fitted.fit.residual.rms));
  const auto cell = [&](std::size_t i) { return std::span<const double>(&cells[i], 1); };

  std::vector<CsvColumn> columns{{"file", fitted.file},
                                 {"run", fmt::format("{}", fitted.series.run)},
                                 {"column", fitted.series.column},
                                 {"law", fitted.parameters.empty() ? "" : to_text(fitted.fit.law)},
                                 {"status", std::string(fitted.status())}};
  for (std::size_t i = 0; i < head.size(); ++i) {
    columns.push_back({head[i].heading(""), cell(4 * i)});
    columns.push_back({head[i].heading(" standard error"), cell(4 * i + 1)});
    columns.push_back({head[i].heading(" 95 % low"), cell(4 * i + 2)});
    columns.push_back({head[i].heading(" 95 % high"), cell(4 * i + 3)});
  }
  columns.push_back({"residual rms (SI unit of the column)", cell(cells.size() - 1)});
  columns.push_back({"message", in_words(fitted.fit.message)});
  append_csv(out, columns, {}, out.empty());
}

}  // namespace

std::string fit_csv(const std::vector<FittedRecording>& fits) {
  std::vector<Quantity> head;
  for (const auto& fitted : fits) add_quantities(head, fitted);
  std::string out;
  for (const auto& fitted : fits) append_row(out, fitted, head);
  return out;
}

}  // namespace cromer::core
