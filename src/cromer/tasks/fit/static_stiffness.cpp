#include "cromer/tasks/fit/static_stiffness.h"

#include <algorithm>
#include <cmath>

#include "cromer/base/median.h"
#include "cromer/identify/least_squares/residual.h"
#include "cromer/identify/least_squares/uncertainty.h"
#include "cromer/tasks/fit/used_samples.h"

namespace cromer::core {
namespace {

Hold hold_of(const Series& series, std::size_t first, std::size_t last, std::string_view file) {
  Hold hold;
  hold.file = file;
  hold.run = series.run;
  hold.from = series.t[first];
  hold.to = series.t[last - 1];
  hold.samples = last - first;
  const auto n = static_cast<double>(hold.samples);
  std::vector<double> y(series.y.begin() + static_cast<std::ptrdiff_t>(first),
                        series.y.begin() + static_cast<std::ptrdiff_t>(last));
  for (const double each : y) hold.position += each / n;
  for (double& each : y) each -= hold.position;
  double square = 0, steps = 0;
  for (const double each : y) square += each * each;
  for (std::size_t i = 1; i < y.size(); ++i) steps += 0.5 * (y[i] - y[i - 1]) * (y[i] - y[i - 1]);
  hold.scatter = n > 1 ? std::sqrt(square / (n - 1)) : 0;
  // Noise is as large from sample to sample as over the whole; a swing is much larger over the whole.
  hold.moves = hold.scatter > 2 * series.resolution && square > 6 * steps;
  const double widening = square > 0 && y.size() > 3 ? correlation_factor(y, 0) : 1;
  // A mean of rounded values is not known better than rounding leaves it.
  const double rounding = series.resolution / std::sqrt(12.0);
  hold.standard_error = std::hypot(hold.scatter * std::sqrt(widening / n), rounding);
  return hold;
}

struct Plateau {
  std::size_t first, last;  // one past the end
  double level;
};

/// The middle value of samples [first, last).
double median(const std::vector<double>& y, std::size_t first, std::size_t last) {
  std::vector<double> part(y.begin() + static_cast<std::ptrdiff_t>(first),
                           y.begin() + static_cast<std::ptrdiff_t>(last));
  return upper_median(part);
}

/// Stretches that stay at a level. In blocks of a fiftieth of the record for each mass a quiet block spans
/// little; neighbouring quiet blocks of one level are one plateau, which must last for three of them.
std::vector<Plateau> plateaus(const Series& series, std::size_t masses) {
  const std::size_t n = series.y.size(), block = std::max<std::size_t>(5, n / (50 * masses));
  const auto [low, high] = std::minmax_element(series.y.begin(), series.y.end());
  const double whole = *high - *low;
  std::vector<Plateau> blocks;
  std::vector<double> spans;
  for (std::size_t first = 0; first + block <= n; first += block) {
    const auto begin = series.y.begin() + static_cast<std::ptrdiff_t>(first);
    const auto [least, most] = std::minmax_element(begin, begin + static_cast<std::ptrdiff_t>(block));
    spans.push_back(*most - *least);
    blocks.push_back({first, first + block, median(series.y, first, first + block)});
  }
  if (spans.empty()) return {};
  // Most blocks are quiet: moving a mass takes less time than holding it.
  const double quiet = std::max(3 * median(spans, 0, spans.size()), 2 * series.resolution);
  const double same = std::max(quiet, 0.02 * whole);
  std::vector<Plateau> found;
  bool open = false;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (spans[i] > quiet) {
      open = false;
      continue;
    }
    if (open && std::abs(blocks[i].level - found.back().level) < same)
      found.back().last = blocks[i].last;
    else
      found.push_back(blocks[i]);
    open = true;
  }
  // A disturbance in the middle of a hold leaves two plateaus of one level.
  std::vector<Plateau> joined;
  for (const Plateau& each : found) {
    if (each.last - each.first < 3 * block) continue;
    if (!joined.empty() && std::abs(joined.back().level - each.level) < same)
      joined.back().last = each.last;
    else
      joined.push_back(each);
  }
  return joined;
}

/// More mass, more extension, as far as the positions are known: the sensor may look from either side.
bool goes_one_way(std::vector<UncertainPoint> points) {
  std::sort(points.begin(), points.end(),
            [](const UncertainPoint& one, const UncertainPoint& other) { return one.x < other.x; });
  bool up = false, down = false;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double change = points[i].y - points[i - 1].y;
    const double error = 3 * std::hypot(points[i].y_error, points[i - 1].y_error);
    up = up || change > error;
    down = down || change < -error;
  }
  return !(up && down);
}

}  // namespace

Result<std::vector<Hold>> find_holds(const std::vector<Series>& runs, std::string_view file,
                                     const std::vector<Quantity>& masses) {
  for (const Series& series : runs) {
    if (series.quantity != "position")
      return Error{"static_needs_positions",
                   {{"file", file}, {"column", series.column}, {"kind", kind_of(series.quantity)}}};
    if (series.y.empty()) return Error{"run_has_no_values", {{"file", file}, {"run", series.run}}};
  }
  std::vector<Hold> holds;
  if (runs.size() == 1 && masses.size() > 1) {
    const Series& series = runs.front();
    const std::vector<Plateau> found = plateaus(series, masses.size());
    if (found.size() != masses.size()) {
      std::vector<Notice> list;
      for (const Plateau& each : found)
        list.push_back(Notice{"stretch", {{"from", series.t[each.first]}, {"to", series.t[each.last - 1]}}});
      return Error{"plateaus_unlike_masses",
                   {{"file", file},
                    {"masses", masses.size()},
                    {"found", found.size()},
                    {"where", list.empty() ? Notice{} : Notice{"stretches", {{"stretches", list}}}}}};
    }
    for (const Plateau& each : found) holds.push_back(hold_of(series, each.first, each.last, file));
  } else {
    for (const Series& series : runs) holds.push_back(hold_of(series, 0, series.y.size(), file));
  }
  if (holds.size() != masses.size())
    return Error{"masses_unlike_runs", {{"file", file}, {"masses", masses.size()}, {"runs", holds.size()}}};
  for (std::size_t i = 0; i < holds.size(); ++i) holds[i].mass = masses[i];
  return holds;
}

Result<StaticStiffness> static_stiffness(std::vector<Hold> holds, const Quantity& gravity) {
  std::vector<UncertainPoint> points;
  for (const Hold& hold : holds)
    points.push_back({hold.mass.value, hold.position, hold.mass.uncertainty, hold.standard_error});
  const auto line = fit_line_with_errors(points);
  if (!line) return Error{"too_few_holds"};
  StaticStiffness result;
  result.line = *line;
  result.gravity = gravity;
  // The sensor may look from below or from above: the extension is the distance.
  const double slope = std::abs(line->slope);
  const double k = gravity.value / slope;
  const double relative = std::hypot(line->slope_error / slope, gravity.uncertainty / gravity.value);
  const double t = line->extra_scatter > 0 ? student_95(line->degrees) : student_95(1e9);
  result.stiffness = make_estimate(k, relative * k, t);
  if (line->extra_scatter > 0)
    result.notices.push_back(
        Notice{"holds_scatter", {{"scatter", line->extra_scatter}, {"degrees", line->degrees}}});
  for (const Hold& hold : holds)
    if (hold.moves)
      result.notices.push_back(Notice{"hold_moves",
                                      {{"file", hold.file},
                                       {"run", hold.run},
                                       {"from", hold.from},
                                       {"to", hold.to},
                                       {"scatter", hold.scatter}}});
  if (!goes_one_way(points)) result.notices.push_back(Notice{"holds_out_of_order"});
  if (holds.size() == 2) result.notices.push_back(Notice{"line_of_two"});
  result.holds = std::move(holds);
  return result;
}

}  // namespace cromer::core
