#include "cromer/tasks/fit/spring_constant.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "cromer/base/ascii.h"
#include "cromer/base/extent.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantile.h"
#include "cromer/identify/least_squares/residual.h"
#include "cromer/identify/least_squares/uncertainty.h"
#include "cromer/identify/record.h"
#include "cromer/read/column_kind.h"
#include "cromer/tasks/fit/fit_options.h"
#include "cromer/tasks/fit/lab_quantities.h"
#include "cromer/tasks/fit/used_samples.h"
#include "cromer/tasks/inspect/take_motion.h"

namespace cromer::core {
namespace {

/// Takes out values that lie ten times as far from the middle as half of all do, if they are few; their
/// number.
std::size_t remove_outliers(std::vector<double>& t, std::vector<double>& y, double resolution) {
  constexpr double far = 10, few = 0.1;
  std::vector<double> sorted = y;
  const double middle = upper_median(sorted);
  std::vector<double> off;
  for (const double each : y) off.push_back(std::abs(each - middle));
  std::vector<double> sizes = off;
  const double limit = far * std::max(upper_median(sizes), resolution);
  const auto count = static_cast<std::size_t>(
      std::count_if(off.begin(), off.end(), [&](double each) { return each > limit; }));
  if (count == 0 || !(limit > 0) || static_cast<double>(count) > few * static_cast<double>(y.size()))
    return 0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (off[i] > limit) continue;
    t[kept] = t[i];
    y[kept++] = y[i];
  }
  t.resize(kept);
  y.resize(kept);
  return count;
}

/// How far a straight line through values about their mean goes, where that is four times its error, widened
/// for correlation, and more than rounding; else 0.
double drift_of(const std::vector<double>& t, const std::vector<double>& y, double resolution) {
  constexpr std::size_t fewest = 8;
  if (y.size() < fewest) return 0;
  const Line line = fit_line(t, y);
  const double duration = t.back() - t.front(), middle = 0.5 * (t.front() + t.back());
  std::vector<double> left = y;
  double square = 0, spread = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    left[i] -= line.at(t[i]);
    square += left[i] * left[i];
    spread += (t[i] - middle) * (t[i] - middle);
  }
  const double variance = square / static_cast<double>(y.size() - 2);
  const double widening = square > 0 ? correlation_factor(left, 0) : 1;
  constexpr double surely = 4;
  const double drift = line.slope * duration, error = duration * std::sqrt(variance * widening / spread);
  return std::abs(drift) > std::max(surely * error, resolution) ? drift : 0;
}

Hold hold_of(const Series& series, std::size_t first, std::size_t last, std::string_view file) {
  Hold hold;
  hold.file = file;
  hold.run = series.run;
  hold.from = series.t[first];
  hold.to = series.t[last - 1];
  std::vector<double> t(series.t.begin() + static_cast<std::ptrdiff_t>(first),
                        series.t.begin() + static_cast<std::ptrdiff_t>(last)),
      y(series.y.begin() + static_cast<std::ptrdiff_t>(first),
        series.y.begin() + static_cast<std::ptrdiff_t>(last));
  hold.set_aside = remove_outliers(t, y, series.resolution);
  hold.samples = y.size();
  const auto n = static_cast<double>(hold.samples);
  for (const double each : y) hold.position += each / n;
  for (double& each : y) each -= hold.position;
  double square = 0, steps = 0;
  for (const double each : y) square += each * each;
  for (std::size_t i = 1; i < y.size(); ++i) steps += 0.5 * (y[i] - y[i - 1]) * (y[i] - y[i - 1]);
  hold.scatter = n > 1 ? std::sqrt(square / (n - 1)) : 0;
  // Noise is as large from sample to sample as over the whole; a swing is much larger over the whole.
  const double rounding_of_doubles = 1e-12 * std::abs(hold.position);  // and of sums of many
  hold.moves = hold.scatter > std::max(2 * series.resolution, rounding_of_doubles) && square > 6 * steps;
  const double widening = square > 0 && y.size() > 3 ? correlation_factor(y, 0) : 1;
  // A mean of rounded values is not known better than rounding leaves it.
  const double rounding = series.resolution / std::sqrt(12.0);
  hold.standard_error = std::hypot(hold.scatter * std::sqrt(widening / n), rounding);
  hold.drift = drift_of(t, y, series.resolution);
  // Where on its way it was when the others were measured is not known.
  hold.standard_error = std::hypot(hold.standard_error, hold.drift / std::sqrt(12.0));
  return hold;
}

struct Plateau {
  std::size_t first, last;  // one past the end
  double level;
};

/// The middle value of samples [first, last).
double middle_value(const std::vector<double>& y, std::size_t first, std::size_t last) {
  std::vector<double> part(y.begin() + static_cast<std::ptrdiff_t>(first),
                           y.begin() + static_cast<std::ptrdiff_t>(last));
  return upper_median(part);
}

/// How far the plateau's second half lies from its first.
double rise_within(const std::vector<double>& y, const Plateau& plateau) {
  const std::size_t middle = (plateau.first + plateau.last) / 2;
  return std::abs(middle_value(y, middle, plateau.last) - middle_value(y, plateau.first, middle));
}

/// Without the blocks at its ends that lie away from the others by four times what those scatter: it was
/// still on its way there.
Plateau without_transitions(const std::vector<double>& y, Plateau plateau, std::size_t block,
                            double resolution) {
  constexpr double away = 4;
  std::vector<double> levels;
  for (std::size_t first = plateau.first; first + block <= plateau.last; first += block)
    levels.push_back(middle_value(y, first, first + block));
  constexpr std::size_t fewest = 5;
  if (levels.size() < fewest) return plateau;
  std::vector<double> sorted = levels;
  const double middle = upper_median(sorted);
  for (double& each : sorted) each = std::abs(each - middle);
  constexpr double of_normal = 1.4826;  // standard deviation over the median of the distances
  const double limit = std::max(away * of_normal * upper_median(sorted), resolution);
  const auto is_off = [&](double level) { return std::abs(level - middle) > limit; };
  std::size_t first = 0, last = levels.size();
  while (first + fewest < last && is_off(levels[first])) ++first;
  while (first + fewest < last && is_off(levels[last - 1])) --last;
  if (last < levels.size()) plateau.last = plateau.first + last * block;
  plateau.first += first * block;
  return plateau;
}

/// A record cut into blocks, fifty for each mass.
struct RecordBlocks {
  std::size_t length = 0;  ///< of each, in samples
  std::vector<Plateau> all{};
  std::vector<double> spans{};  ///< of their values
  double usual_span = 0;        ///< the middle one of them
  double whole = 0;             ///< what all values span
  bool move = false;            ///< most of them by a good part of the whole, and not as noise does
};

RecordBlocks blocks_of(const Series& series, std::size_t masses) {
  const std::size_t n = series.y.size();
  RecordBlocks blocks{.length = std::max<std::size_t>(5, n / (50 * masses))};
  const auto [low, high] = extent_of(series.y);
  blocks.whole = high - low;
  for (std::size_t first = 0; first + blocks.length <= n; first += blocks.length) {
    const std::size_t last = first + blocks.length;
    const auto [least, most] = extent_of(std::span(series.y).subspan(first, blocks.length));
    blocks.spans.push_back(most - least);
    blocks.all.push_back({first, last, middle_value(series.y, first, last)});
  }
  if (blocks.all.empty()) return blocks;
  blocks.usual_span = middle_value(blocks.spans, 0, blocks.spans.size());
  constexpr double good_part = 0.1, mostly_noise = 0.5;
  blocks.move = blocks.usual_span > good_part * blocks.whole &&
                noise_of(series.y) < mostly_noise * sinusoid_amplitude(series.y) / std::sqrt(2.0);
  return blocks;
}

/// Stretches that stay at a level. A quiet block spans little; neighbouring quiet blocks at one level are a
/// plateau, which must last for three blocks. Where there are more plateaus than masses, those that rise most
/// between two others are dropped: a mass is moved there.
std::vector<Plateau> plateaus(const Series& series, const RecordBlocks& cut, std::size_t masses) {
  const std::vector<Plateau>& blocks = cut.all;
  const std::size_t block = cut.length;
  // Most blocks are quiet: moving a mass takes less time than holding it.
  const double quiet = std::max(3 * cut.usual_span, 2 * series.resolution);
  const double same = std::max(quiet, 0.02 * cut.whole);
  std::vector<Plateau> found;
  bool open = false;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (cut.spans[i] > quiet) {
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
  while (joined.size() > std::max<std::size_t>(masses, 2)) {
    auto way = joined.end();
    double furthest = 0.25 * same;
    for (auto each = joined.begin() + 1; each + 1 != joined.end(); ++each) {
      const bool between = (each->level - (each - 1)->level) * ((each + 1)->level - each->level) > 0;
      if (const double rise = rise_within(series.y, *each); between && rise >= furthest)
        way = each, furthest = rise;
    }
    if (way == joined.end()) break;
    joined.erase(way);
  }
  for (Plateau& each : joined) each = without_transitions(series.y, each, block, series.resolution);
  return joined;
}

/// Whether more mass gives more extension, as far as the positions are known. The sensor may look from either
/// side.
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

Result<std::vector<Series>> runs_of(const Recording& recording, const FitOptions& options) {
  // How fast the samples came does not matter to a mass at rest.
  ReadOptions read = options.read;
  const auto& columns = recording.table.columns;
  const bool timed =
      std::any_of(columns.begin(), columns.end(), [](const Column& c) { return c.quantity == "time"; });
  if (!timed && read.rate == 0) read.rate = 1;
  std::vector<Series> found;
  for (const int run : options.run ? std::vector<int>{*options.run} : runs(recording)) {
    auto series = take_motion(recording, options.column, run, read);
    if (!series) return series.error();
    auto part = used_part(*std::move(series), options);
    if (!part) return part.error();
    found.push_back(*std::move(part));
  }
  return found;
}

/// The first given option that has a meaning for a motion only; empty if there is none.
std::string_view of_a_motion(const FitOptions& o) {
  if (!o.mass.empty() || o.spring_mass) return o.spring_mass ? "spring-mass" : "mass";
  if (law_is_chosen(o)) return "law";
  if (o.disc_diameter || o.temperature) return o.disc_diameter ? "disc-diameter" : "temperature";
  if (o.segment || o.segments) return o.segment ? "segment" : "segments";
  if (!o.force_column.empty() || o.hold_out) return o.hold_out ? "hold-out" : "force-column";
  if (!o.drive_frequency.empty()) return "drive-frequency";
  if (o.no_spring || o.hysteresis_exponent != 1) return o.no_spring ? "no-spring" : "hysteresis-exponent";
  if (!o.goal.empty() || o.textbook) return o.textbook ? "textbook" : "goal";
  if (o.seed_given) return "seed";
  return o.monte_carlo ? "monte-carlo" : "";
}

}  // namespace

std::size_t levels_at_rest(const Series& series) {
  constexpr std::size_t supposed = 4, any = 1000;  // masses
  constexpr double mostly = 0.7, clearly = 5, hardly = 0.1;
  const RecordBlocks blocks = blocks_of(series, supposed);
  if (series.quantity != "position" || blocks.move) return 0;
  const std::vector<Plateau> found = plateaus(series, blocks, any);
  double samples = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    samples += static_cast<double>(found[i].last - found[i].first);
    if (i == 0) continue;
    const double step = std::abs(found[i].level - found[i - 1].level);
    if (step < clearly * blocks.usual_span || rise_within(series.y, found[i]) > hardly * step ||
        rise_within(series.y, found[i - 1]) > hardly * step)
      return 0;
  }
  return samples < mostly * static_cast<double>(series.y.size()) ? 0 : found.size();
}

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
    const RecordBlocks blocks = blocks_of(series, masses.size());
    const std::vector<Plateau> found = plateaus(series, blocks, masses.size());
    if (found.size() < masses.size() && blocks.move)
      return Error{"holds_move", {{"file", file}, {"span", blocks.whole}}};
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
  if (holds.size() != masses.size()) return unlike_runs("masses", file, masses.size(), holds.size());
  for (std::size_t i = 0; i < holds.size(); ++i) holds[i].mass = masses[i];
  return holds;
}

double residual_of(const StaticStiffness& found, const Hold& hold) {
  return hold.position - found.line.at(hold.mass.value);
}

double error_about_line(const StaticStiffness& found, const Hold& hold) {
  return std::hypot(hold.standard_error, found.line.extra_scatter);
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
  const double of_slope = line->slope_error / slope, of_gravity = gravity.uncertainty / gravity.value;
  // Only the slope's part has few degrees of freedom (Welch and Satterthwaite).
  const double squares = of_slope * of_slope + of_gravity * of_gravity;
  const double degrees = line->extra_scatter > 0 && of_slope > 0
                             ? line->degrees * squares * squares / std::pow(of_slope, 4)
                             : 1e9;
  result.stiffness = make_estimate(k, std::sqrt(squares) * k, student_95(degrees));
  if (line->extra_scatter > 0)
    result.notices.push_back(
        Notice{"holds_scatter", {{"scatter", line->extra_scatter}, {"degrees", line->degrees}}});
  for (const Hold& hold : holds) {
    const auto say = [&](const char* code, NoticeValue what) {
      result.notices.push_back(Notice{
          code,
          {{"file", hold.file}, {"run", hold.run}, {"from", hold.from}, {"to", hold.to}, std::move(what)}});
    };
    if (hold.drift != 0)
      say("hold_drifts", {"drift", std::abs(hold.drift)});
    else if (hold.moves)
      say("hold_moves", {"scatter", hold.scatter});
    if (hold.set_aside > 0) say("hold_with_outliers", {"samples", hold.set_aside});
  }
  if (!goes_one_way(points)) result.notices.push_back(Notice{"holds_out_of_order"});
  if (holds.size() == 2) result.notices.push_back(Notice{"line_of_two"});
  result.holds = std::move(holds);
  return result;
}

Result<StaticStiffness> fit_static(const std::vector<Recording>& recordings, const StaticOptions& options) {
  const std::vector<Quantity>& masses = options.masses;
  if (const std::string_view unused = of_a_motion(options.fit); !unused.empty())
    return Error{"no_meaning_with_static", {{"option", unused}}};
  if (const Result<void> checked = check_fit_options(options.fit); !checked) return checked.error();
  std::vector<Hold> holds;
  std::size_t next = 0;
  for (const Recording& recording : recordings) {
    const auto series = runs_of(recording, options.fit);
    if (!series) return series.error();
    const bool plateaus = recordings.size() == 1 && series->size() == 1;
    const std::size_t count = plateaus ? masses.size() : series->size();
    if (next + count > masses.size())
      return Error{"more_holds_than_masses",
                   {{"masses", masses.size()}, {"file", recording.file}, {"runs", series->size()}}};
    const auto first = masses.begin() + static_cast<std::ptrdiff_t>(next);
    const auto found =
        find_holds(*series, recording.file, {first, first + static_cast<std::ptrdiff_t>(count)});
    if (!found) return found.error();
    holds.insert(holds.end(), found->begin(), found->end());
    next += count;
  }
  if (next < masses.size())
    return Error{"more_masses_than_holds", {{"masses", masses.size()}, {"holds", next}}};
  return static_stiffness(std::move(holds), options.gravity);
}

Result<MassLine> mass_line(const std::vector<FittedRecording>& fits, const std::vector<Quantity>& masses) {
  if (fits.size() != masses.size())
    return Error{"masses_unlike_recordings", {{"masses", masses.size()}, {"recordings", fits.size()}}};
  MassLine result;
  std::vector<UncertainPoint> points;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const FittedRecording& fitted = fits[i];
    if (!fitted.succeeded()) {
      result.notices.push_back(
          Notice{"run_left_out_of_line",
                 {{"file", fitted.file}, {"run", fitted.series.run}, {"why", fitted.fit.message}}});
      continue;
    }
    const Estimate w = angular_frequency_of(fitted);
    const double T2 = two_pi * two_pi / (w.value * w.value);
    const Estimate square = make_estimate(T2, 2 * T2 * w.standard_error / w.value, fitted.fit.student);
    result.points.push_back({fitted.file, fitted.series.run, masses[i], square});
    points.push_back({masses[i].value, T2, masses[i].uncertainty, square.standard_error});
  }
  const auto line = fit_line_with_errors(points);
  if (!line) return Error{"mass_line_of_one_mass"};
  if (!(line->slope > 0)) return Error{"period_does_not_grow"};
  result.line = *line;
  const double t = line->extra_scatter > 0 ? student_95(line->degrees) : student_95(1e9);
  const double s = line->slope, a = line->intercept, k = two_pi * two_pi / s;
  result.stiffness = make_estimate(k, k * line->slope_error / s, t);
  const double by_a = 1 / s, by_s = -a / (s * s);
  const double variance = by_a * by_a * line->intercept_error * line->intercept_error +
                          by_s * by_s * line->slope_error * line->slope_error +
                          2 * by_a * by_s * line->covariance;
  const double error = std::sqrt(std::max(0.0, variance));
  result.effective_mass = make_estimate(a / s, error, t);
  result.spring_mass = make_estimate(3 * a / s, 3 * error, t);
  if (points.size() == 2) result.notices.push_back(Notice{"line_of_two"});
  if (line->extra_scatter > 0)
    result.notices.push_back(
        Notice{"points_scatter", {{"scatter", line->extra_scatter}, {"degrees", line->degrees}}});
  return result;
}

}  // namespace cromer::core
