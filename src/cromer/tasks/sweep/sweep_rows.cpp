#include "cromer/tasks/sweep/sweep_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "cromer/analysis/effective_oscillator.h"
#include "cromer/analysis/frequency_response.h"
#include "cromer/base/ascii.h"
#include "cromer/base/nearest.h"
#include "cromer/base/pi.h"
#include "cromer/ensemble/group.h"
#include "cromer/ensemble/point.h"
#include "cromer/methods/all.h"
#include "cromer/model/law.h"
#include "cromer/model/law_force.h"
#include "cromer/model/linear_quantities.h"

namespace cromer::core {
namespace {

constexpr std::uint64_t group_size = cromer_group::size;

/// Per unit mass, with its drive.
LinearLaw<double> linear_law(const Point& point) { return linear_law(point.oscillator, point.drive); }

/// Whether the free motion of a linear law, as the method simulates it, grows without end. A method that is
/// exact, or chooses its steps, has the law's own motion.
template <class M>
bool grows(const M& method, const Point& point) {
  if constexpr (M::info.takes_fixed_steps()) {
    LinearLaw<double> law = linear_law(point);
    law.drive_amplitude = 0;
    const EffectiveOscillator effective = effective_oscillator(method, law, point.step);
    // For a free mass x grows linearly in time: both eigenvalues are 1, to the root of rounding.
    const double rounding = law.stiffness == 0 ? 1e-8 : 1e-12;
    return effective.spectral_radius > 1 + rounding;
  } else {
    return point.oscillator.stiffness < 0 || point.oscillator.damping < 0;
  }
}

/// Corrects the status of a stepped result where stepping alone cannot tell. A linear law that grows is
/// unstable, not just unsettled, run away, or measured after --settle. If the law takes no energy, the free
/// motion stays, though the amplitude at the drive's frequency may not show it: the point has settled only if
/// the method's own damping had the time for it.
void name_status(const SweepWork& work, const MethodSettings& settings, const Point& point,
                 PointResult& result) {
  if (work.runs_to_end()) return;
  const Oscillator<double>& o = point.oscillator;
  if (o.friction != 0 || result.status == PointStatus::no_convergence) return;
  if (is_linear(law_of(o)) &&
      visit_method(work.method, settings, [&](const auto& method) { return grows(method, point); })) {
    result.status = PointStatus::unstable;
    return;
  }
  if (law_of(o).shares(terms_of_velocity) || work.settling.dropped || !has_numbers(result.status)) return;
  // For a law that is not linear, the decay of small motions.
  const double rate = o.stiffness > 0 ? own_decay_rate(work, settings, point).value_or(0) : 0;
  const bool decayed = rate * result.end_time > -std::log(work.settling.tolerance);
  result.status = decayed ? PointStatus::own_damping : PointStatus::not_settled;
}

/// A point without numbers has no settled motion to measure.
void write_measures(const SweepWork& work, const PointResult& found, const Point& point, double* to) {
  const PointResult result = has_numbers(found.status) ? found : PointResult{.status = found.status};
  for (const Measure* measure : work.measures) {
    measure->write(result, point, to);
    to += measure->columns.size();
  }
  *to = static_cast<double>(result.status);
}

/// A law that cannot be stepped (no period to choose a step by) has no numbers.
PointResult without_numbers() {
  PointResult result;
  result.status = PointStatus::not_finite;
  return result;
}

/// Where the motion of a linear law settles, or why it does not.
template <class M>
PointResult in_closed_form(const M& method, const SweepPoint& at) {
  const Point& point = at.point;
  PointResult result;
  const Oscillator<double>& o = point.oscillator;
  std::optional<MethodSteadyState> steady;
  const double w = point.drive.frequency;
  if (at.loss_factor > 0) {
    const SteadyState answer = hysteretic_response(o, at.loss_factor, point.drive.amplitude, w);
    steady = MethodSteadyState{answer, answer.amplitude * w};
  } else if constexpr (M::info.takes_fixed_steps()) {
    steady = method_steady_state(method, linear_law(point), point.step);
  } else if (o.damping > 0 && o.stiffness > 0) {
    const SteadyState answer = frequency_response(o, point.drive.amplitude, w);
    steady = MethodSteadyState{answer, answer.amplitude * w};
  }
  if (!steady) {
    result.status = grows(method, point) ? PointStatus::unstable : PointStatus::not_settled;
    return result;
  }
  if (o.damping <= 0 && at.loss_factor == 0) result.status = PointStatus::own_damping;
  const double x = steady->position.amplitude, v = steady->velocity;
  result.amplitude = result.peak = x;
  result.phase_lag = steady->position.phase_lag;
  result.mean = 0;
  result.rms = x / std::numbers::sqrt2;
  result.energy = (o.mass * v * v + o.stiffness * x * x) / 4;
  return result;
}

bool make_in_closed_form(const SweepWork& work, SweepPoints& points, std::uint64_t first, std::uint64_t count,
                         double* rows) {
  const std::size_t width = work.columns(), axes = work.axes.size();
  // The method's name is looked up once.
  return visit_method(work.method, points.settings_of(first), [&](const auto& method) {
    for (std::uint64_t i = 0; i < count; ++i) {
      double* row = rows + i * width;
      points.values_of(first + i, row);
      const auto at = points.at(row);
      if (at)
        write_measures(work, in_closed_form(method, *at), at->point, row + axes);
      else
        write_measures(work, without_numbers(), {}, row + axes);
    }
    return true;
  });
}

bool make_in_groups(const SweepWork& work, SweepPoints& points, std::uint64_t first, std::uint64_t count,
                    double* rows, const Watch& watch) {
  const MethodSettings settings = points.settings_of(first);
  const std::size_t width = work.columns(), axes = work.axes.size();
  for (std::uint64_t begin = 0; begin < count; begin += group_size) {
    const std::uint64_t size = std::min(group_size, count - begin);
    std::vector<Point> group;
    std::vector<double> until;
    std::vector<std::uint64_t> place;
    for (std::uint64_t i = begin; i < begin + size; ++i) {
      double* row = rows + i * width;
      points.values_of(first + i, row);
      if (const auto at = points.at(row)) {
        group.push_back(at->point);
        until.push_back(at->until);
        place.push_back(i);
      } else {
        write_measures(work, without_numbers(), {}, row + axes);
      }
    }
    if (group.empty()) continue;
    std::vector<PointResult> results(group.size());
    const bool made =
        work.way == SweepWay::settled
            ? settle_group(work.unit, group, work.stepping(settings), work.settling, results, watch)
            : run_group(work.unit, group, work.stepping(settings), until, results, watch);
    if (!made) return false;
    for (std::size_t k = 0; k < results.size(); ++k) {
      name_status(work, settings, group[k], results[k]);
      write_measures(work, results[k], group[k], rows + place[k] * width + axes);
    }
  }
  return true;
}

/// Goes on from where a motion ended, at the drive's phase there.
void continue_from(const PointResult& ended, const Point& before, Point& next) {
  if (ended.status != PointStatus::not_settled && !has_numbers(ended.status)) return;
  next.start = ended.end;
  next.drive.phase = std::fmod(before.drive.frequency * ended.end_time + before.drive.phase, two_pi);
}

/// Chains side by side, each along the last axis.
bool make_chains(const SweepWork& work, SweepPoints& points, std::uint64_t first, std::uint64_t count,
                 double* rows, const Watch& watch) {
  const MethodSettings settings = points.settings_of(first);
  const std::size_t width = work.columns(), axes = work.axes.size();
  const std::uint64_t length = work.axes.back().grid.size(), chains = count / length;
  const bool rising = work.axes.back().grid[0] <= work.axes.back().grid[length - 1];
  const bool both = work.direction == SweepDirection::both;
  std::vector<Point> before(chains);
  std::vector<PointResult> ended(chains);
  for (std::uint64_t j = 0; j < length; ++j) {
    std::vector<Point> group(chains);
    std::vector<std::uint64_t> places(chains);
    for (std::uint64_t c = 0; c < chains; ++c) {
      double* row = rows + c * length * width;
      points.values_of(first + c * length, row);
      const bool up = both ? row[0] > 0 : work.direction == SweepDirection::up;
      places[c] = c * length + (up == rising ? j : length - 1 - j);
      row = rows + places[c] * width;
      points.values_of(first + places[c], row);
      const auto at = points.at(row);
      if (!at) return true;  // cannot be: plan_sweep has checked them
      group[c] = at->point;
      if (j > 0) continue_from(ended[c], before[c], group[c]);
    }
    if (!settle_group(work.unit, group, work.stepping(settings), work.settling, ended, watch)) return false;
    for (std::uint64_t c = 0; c < chains; ++c) {
      name_status(work, settings, group[c], ended[c]);
      write_measures(work, ended[c], group[c], rows + places[c] * width + axes);
    }
    before = group;
  }
  return true;
}

bool make_one_by_one(const SweepWork& work, SweepPoints& points, std::uint64_t first, std::uint64_t count,
                     double* rows, const Watch& watch) {
  const std::size_t width = work.columns(), axes = work.axes.size();
  for (std::uint64_t i = 0; i < count; ++i) {
    double* row = rows + i * width;
    points.values_of(first + i, row);
    const auto at = points.at(row);
    auto result = at ? run_point(work, *at, watch) : std::optional(without_numbers());
    if (!result) return false;
    if (at) name_status(work, at->settings, at->point, *result);
    write_measures(work, *result, at ? at->point : Point{}, row + axes);
  }
  return true;
}

/// Rows of equal settings.
bool make_stretch(const SweepWork& work, SweepPoints& points, std::uint64_t first, std::uint64_t count,
                  double* rows, const Watch& watch) {
  if (work.direction != SweepDirection::none) return make_chains(work, points, first, count, rows, watch);
  switch (work.way) {
    case SweepWay::closed_form:
      return make_in_closed_form(work, points, first, count, rows);
    case SweepWay::one_by_one:
      return make_one_by_one(work, points, first, count, rows, watch);
    case SweepWay::settled:
    case SweepWay::to_end:
      return make_in_groups(work, points, first, count, rows, watch);
  }
  return true;
}

/// [m] Amplitude of the base whose shaking is this drive, m Y w^2 cos(w t).
double base_displacement(const Point& point) {
  const double w = point.drive.frequency;
  return point.drive.amplitude / (point.oscillator.mass * w * w);
}

/// All that --measure knows.
const std::vector<Measure>& measures() {
  static const std::vector<Measure> all{
      {"amplitude",
       true,
       true,
       {"amplitude (m)"},
       [](const PointResult& r, const Point&, double* to) { to[0] = r.amplitude; }},
      {"phase",
       true,
       true,
       {"phase (rad)"},
       [](const PointResult& r, const Point&, double* to) { to[0] = r.phase_lag; }},
      {"peak",
       false,
       true,
       {"peak (m)"},
       [](const PointResult& r, const Point&, double* to) { to[0] = r.peak; }},
      {"final",
       false,
       false,
       {"x (m)", "v (m/s)"},
       [](const PointResult& r, const Point&, double* to) { to[0] = r.end.x, to[1] = r.end.v; }},
      {"mean",
       true,
       true,
       {"mean (m)"},
       [](const PointResult& r, const Point&, double* to) { to[0] = r.mean; }},
      {"rms", true, true, {"rms (m)"}, [](const PointResult& r, const Point&, double* to) { to[0] = r.rms; }},
      {"energy",
       false,
       true,
       {"energy (J)"},
       [](const PointResult& r, const Point&, double* to) { to[0] = r.energy; }},
      {"transmissibility",
       true,
       true,
       {"transmissibility"},
       [](const PointResult& r, const Point& point, double* to) {
         to[0] = transmitted_motion(base_displacement(point), {r.amplitude, r.phase_lag}).amplitude;
       },
       true},
  };
  return all;
}

}  // namespace

Result<std::vector<const Measure*>> find_measures(const std::vector<std::string>& names, bool driven) {
  std::vector<std::string> words;
  for (const std::string& name : names)
    for (const std::string_view word : split(name, ',')) words.emplace_back(word);
  if (words.empty())
    words = driven ? std::vector<std::string>{"amplitude", "phase"}
                   : std::vector<std::string>{"peak", "final", "energy"};

  std::vector<std::string_view> known;
  for (const Measure& measure : measures()) known.push_back(measure.name);
  std::vector<const Measure*> found;
  for (const std::string& word : words) {
    const auto at = std::find(known.begin(), known.end(), word);
    if (at == known.end()) {
      const std::string near = nearest(word, known);
      return Error{"no_such_measure",
                   {{"typed", word},
                    {"near", near.empty() ? Notice{} : Notice{"perhaps_measure", {{"near", near}}}},
                    {"measures", std::vector<std::string>(known.begin(), known.end())}}};
    }
    const Measure* measure = &measures()[static_cast<std::size_t>(at - known.begin())];
    if (std::find(found.begin(), found.end(), measure) != found.end())
      return Error{"measure_twice", {{"measure", word}}};
    if (measure->of_settled_motion && !driven) return Error{"measure_undriven", {{"measure", word}}};
    found.push_back(measure);
  }
  return found;
}

std::size_t SweepWork::columns() const {
  std::size_t columns = axes.size() + 1;
  for (const Measure* measure : measures) columns += measure->columns.size();
  return columns;
}

std::uint64_t SweepWork::rows_per_chunk() const {
  std::uint64_t few = 4;  // run by run
  if (direction != SweepDirection::none)
    few = axes.back().grid.size() * group_size;
  else if (way == SweepWay::closed_form)
    few = 8192;
  else if (way != SweepWay::one_by_one)
    few = 4 * group_size;
  // Handing out a chunk costs at most 20 us: all of them take some seconds, however long the sweep.
  constexpr double most_chunks = 262144;
  double rows = 1;
  for (const SweepAxis& axis : axes) rows *= static_cast<double>(axis.grid.size());
  const double times = std::ceil(rows / static_cast<double>(few) / most_chunks);
  return few * static_cast<std::uint64_t>(std::max(1.0, times));
}

std::uint64_t SweepWork::rows_of_equal_settings() const {
  std::uint64_t rows = 1;
  for (std::size_t i = axes.size(); i-- > 0 && !is_method_setting(axes[i].name);) rows *= axes[i].grid.size();
  return rows;
}

PointResult closed_form(const SweepWork& work, const SweepPoint& at) {
  return visit_method(work.method, at.settings,
                      [&](const auto& method) { return in_closed_form(method, at); });
}

std::optional<PointResult> settle_one(const SweepWork& work, const SweepPoint& at, const Watch& watch) {
  PointResult result;
  if (!settle_group(work.unit, std::span(&at.point, 1), work.stepping(at.settings), work.settling,
                    std::span(&result, 1), watch))
    return std::nullopt;
  name_status(work, at.settings, at.point, result);
  return result;
}

bool make_rows(const SweepWork& work, std::uint64_t first, std::uint64_t count, double* rows,
               const Watch& watch) {
  SweepPoints points(work.base, work.axes);
  const std::uint64_t same = work.rows_of_equal_settings(), end = first + count;
  const std::size_t width = work.columns();
  while (first < end) {
    const std::uint64_t stretch = std::min(end - first, same - first % same);
    if (!make_stretch(work, points, first, stretch, rows, watch)) return false;
    first += stretch;
    rows += stretch * width;
  }
  return true;
}

std::optional<double> own_decay_rate(const SweepWork& work, const MethodSettings& settings,
                                     const Point& point) {
  LinearLaw<double> law = linear_law(point);
  law.drive_amplitude = 0;
  return visit_method(work.method, settings, [&]<class M>(const M& method) -> std::optional<double> {
    if constexpr (M::info.takes_fixed_steps())
      return effective_oscillator(method, law, point.step).decay_rate;
    else
      return 0.0;
  });
}

}  // namespace cromer::core
