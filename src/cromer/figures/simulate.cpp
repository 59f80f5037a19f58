#include "cromer/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cromer/analysis/envelope.h"
#include "cromer/base/length_unit.h"
#include "cromer/base/quantity.h"
#include "cromer/figures/panels.h"
#include "cromer/report/palette.h"
#include "cromer/tasks/simulate/run_energy.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

/// Largest |value| between the times `from` and `until`.
double largest(const Trajectory& trajectory, const std::vector<double>& values, double from, double until) {
  double size = 0;
  for (std::size_t i = 0; i < trajectory.size(); ++i)
    if (trajectory.t[i] >= from && trajectory.t[i] <= until) size = std::max(size, std::abs(values[i]));
  return size;
}

/// The first period, or a twentieth of the run if there is none [s]: a run has not grown yet by then.
double first_part(const SimulatedRun& run) {
  const double period = natural_period(run.oscillator);
  return period > 0 ? period : run.until / 20;
}

/// A quantity of each run, in the order of the runs, and how much of it the plot shows.
struct Framed {
  std::vector<std::vector<double>> values;
  double height = 0;           ///< the largest |value| in the frame
  std::vector<bool> leaves{};  ///< whether the run goes beyond
};

/// The largest |value| of each run's first part.
std::vector<double> sizes_at_first(const std::vector<SimulatedRun>& runs,
                                   const std::vector<std::vector<double>>& values) {
  std::vector<double> sizes;
  for (std::size_t i = 0; i < runs.size(); ++i)
    sizes.push_back(largest(runs[i].trajectory, values[i], 0, first_part(runs[i])));
  return sizes;
}

/// All runs fit in, unless one grows far beyond the others or its own `early` size. `power` of the amplitude,
/// by which the quantity grows: 1, of an energy 2.
Framed framed(const std::vector<SimulatedRun>& runs, std::vector<std::vector<double>> values,
              const std::vector<double>& early_sizes, double power) {
  double smallest = std::numeric_limits<double>::infinity(), greatest = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SimulatedRun& run = runs[i];
    const double whole = largest(run.trajectory, values[i], 0, run.until);
    const double early = early_sizes[i];
    const bool diverged = run.outcome.status == Status::not_finite || whole > std::pow(1e3, power) * early;
    smallest = std::min(smallest, diverged && early > 0 ? std::pow(10, power) * early : whole);
    greatest = std::max(greatest, whole);
  }
  Framed all{std::move(values)};
  const bool cut = greatest > std::pow(20, power) * smallest && smallest > 0;
  all.height = cut ? std::pow(4, power) * smallest : greatest;
  for (std::size_t i = 0; i < runs.size(); ++i)
    all.leaves.push_back(largest(runs[i].trajectory, all.values[i], 0, runs[i].until) > all.height);
  return all;
}

struct Ends {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

/// The extremes of the motion from a time on.
Ends ends_from(const Trajectory& motion, double from) {
  Ends ends;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    if (motion.t[i] < from) continue;
    ends.low = std::min(ends.low, motion.x[i]);
    ends.high = std::max(ends.high, motion.x[i]);
  }
  return ends;
}

/// The last turning points of a free motion.
Ends last_turns(const Trajectory& motion) {
  const Envelope turns = envelope(motion.t, motion.x);
  if (turns.top.empty() || turns.bottom.empty()) return {};
  return {turns.bottom.back(), turns.top.back()};
}

/// "±1.2 cm at the end", "100 ± 4 cm at the end".
std::string swing(const Ends& ends, const LengthUnit& unit) {
  if (!(ends.high >= ends.low)) return "";
  const double middle = (ends.high + ends.low) / 2 / unit.metres,
               half = (ends.high - ends.low) / 2 / unit.metres;
  const std::string about =
      std::abs(middle) > 0.1 * half ? format_quantity({middle, half}, "") : "±" + rounded(half, 3);
  return fmt::format("{} {} at the end", about, unit.symbol);
}

/// What is said of a run that does not stay in the frame until its end; else "".
std::string early_end(const SimulatedRun& run, bool leaves) {
  if (run.outcome.status == Status::not_finite || leaves) return "grows without end";
  if (run.outcome.status != Status::reached_end) return fmt::format("ends at {:.4g} s", run.outcome.t);
  return "";
}

/// The swing at the end of a run that stays in the frame.
std::string swing_at_end(const SimulatedRun& run, const LengthUnit& unit) {
  const bool harmonic = run.drive.amplitude > 0 && run.drive.frequency > 0;
  if (!harmonic && !run.general) return swing(last_turns(run.trajectory), unit);
  // The extremes tell the amplitude only over at least one period.
  const double period = natural_period(run.oscillator);
  const double window = std::max(period > 0 ? period : 0.1 * run.until,
                                 harmonic ? 2 * std::numbers::pi / run.drive.frequency : 0.1 * run.until);
  if (window > 0.5 * run.until) return "";
  return swing(ends_from(run.trajectory, run.until - window), unit);
}

std::string name_of(const SimulatedRun& run, bool one_method, bool several_frequencies) {
  const std::string frequency = fmt::format("{:.6g} rad/s", run.drive.frequency);
  if (!several_frequencies) return run.method;
  return one_method ? frequency : run.method + ", " + frequency;
}

bool all_one_method(const std::vector<SimulatedRun>& runs) {
  return std::all_of(runs.begin(), runs.end(),
                     [&](const auto& run) { return run.method == runs.front().method; });
}

/// What the panels show of all runs.
class Panels {
 public:
  Panels(const SimulateResult& result, std::span<const MotionPanel> asked)
      : runs_(result.runs), one_method_(all_one_method(result.runs)) {
    const auto each = [&](auto values) {
      std::vector<std::vector<double>> all;
      for (const SimulatedRun& run : runs_) all.push_back(values(run));
      return all;
    };
    const auto asks = [&](MotionPanel panel) {
      return std::find(asked.begin(), asked.end(), panel) != asked.end();
    };
    auto x = each([](const SimulatedRun& run) { return run.trajectory.x; });
    const std::vector<double> early_x = sizes_at_first(runs_, x);
    position_ = framed(runs_, std::move(x), early_x, 1);
    length_ = length_unit(position_.height);
    if (asks(MotionPanel::velocity) || asks(MotionPanel::phase)) {
      auto v = each([](const SimulatedRun& run) { return run.trajectory.v; });
      // A run in long steps has only its start in the first part, where it may be at rest.
      std::vector<double> early = sizes_at_first(runs_, v);
      for (std::size_t i = 0; i < early.size(); ++i)
        if (const double period = natural_period(runs_[i].oscillator); period > 0)
          early[i] = std::max(early[i], 2 * std::numbers::pi / period * early_x[i]);
      velocity_ = framed(runs_, std::move(v), early, 1);
    }
    if (asks(MotionPanel::energy)) {
      auto energy = each(energies);
      const std::vector<double> early = sizes_at_first(runs_, energy);
      energy_ = framed(runs_, std::move(energy), early, 2);
    }
  }

  bool one_method() const { return one_method_; }

  /// One panel with the runs of these numbers.
  Panel panel(MotionPanel what, const std::vector<std::size_t>& which, bool name_frequency) const {
    Panel panel = what == MotionPanel::phase      ? portrait(which)
                  : what == MotionPanel::energy   ? against_time(energy_, energy_axis(), which)
                  : what == MotionPanel::velocity ? against_time(velocity_, velocity_axis(), which)
                                                  : against_time(position_, position_axis(), which);
    for (std::size_t i = 0; i < which.size(); ++i) {
      const SimulatedRun& run = runs_[which[i]];
      Curve& curve = panel.curves[i];
      curve.role = one_method_ && runs_.size() > 1 ? family_role(i, which.size()) : run.method;
      curve.name = name_of(run, one_method_, name_frequency);
      if (what == MotionPanel::position || what == MotionPanel::energy) {
        curve.remark = early_end(run, (what == MotionPanel::energy ? energy_ : position_).leaves[which[i]]);
        if (curve.remark.empty())
          curve.remark = what == MotionPanel::position ? swing_at_end(run, length_) : energy_at_end(which[i]);
      }
    }
    constexpr std::size_t most_at_curves = 6;
    panel.names_listed = panel.names_listed || which.size() > most_at_curves;
    // The exact solution lies below all others.
    std::stable_partition(panel.curves.begin(), panel.curves.end(),
                          [](const Curve& c) { return c.role == "exact"; });
    return panel;
  }

  /// The recorded samples, in the unit of the positions.
  Curve dots(const LaidOver& over) const {
    Curve curve;
    curve.x = over.t;
    for (const double x : over.x) curve.y.push_back(x / length_.metres);
    curve.role = "measured";
    curve.name = "measured";
    curve.remark = fmt::format("{} samples", over.t.size());
    curve.mark = Mark::dots;
    return curve;
  }

 private:
  struct Scale {
    std::string name;  ///< of the axis, with unit
    double unit = 1;   ///< in SI units
  };

  Scale position_axis() const {
    return {fmt::format("position {{/:Italic x}} ({})", length_.symbol), length_.metres};
  }
  Scale velocity_axis() const {
    const LengthUnit unit = length_unit(velocity_.height);
    return {fmt::format("velocity {{/:Italic v}} ({}/s)", unit.symbol), unit.metres};
  }
  Scale energy_axis() const {
    const EnergyUnit unit = energy_unit(energy_.height);
    return {fmt::format("energy {{/:Italic E}} ({})", unit.symbol), unit.joules};
  }

  std::string energy_at_end(std::size_t run) const {
    if (energy_.values[run].empty()) return "";
    const EnergyUnit unit = energy_unit(energy_.height);
    return fmt::format("{} {} at the end", rounded(energy_.values[run].back() / unit.joules, 3), unit.symbol);
  }

  /// Sets the axis to the frame where a run goes beyond it.
  static void cut(Axis& axis, const Framed& framed, const std::vector<std::size_t>& which, double unit) {
    double lowest = 0;
    bool leaves = false;
    for (const std::size_t run : which) {
      leaves = leaves || framed.leaves[run];
      for (const double value : framed.values[run]) lowest = std::min(lowest, value);
    }
    if (!leaves) return;
    axis.low = 1.1 * std::max(lowest, -framed.height) / unit;
    axis.high = 1.1 * framed.height / unit;
  }

  Panel against_time(const Framed& framed, const Scale& scale, const std::vector<std::size_t>& which) const {
    Panel panel;
    panel.x.name = "time {/:Italic t} (s)";
    panel.y.name = scale.name;
    for (const std::size_t run : which) {
      Curve& curve = panel.curves.emplace_back();
      curve.x = runs_[run].trajectory.t;
      for (const double value : framed.values[run])
        curve.y.push_back(std::clamp(value, -3 * framed.height, 3 * framed.height) / scale.unit);
    }
    cut(panel.y, framed, which, scale.unit);
    return panel;
  }

  Panel portrait(const std::vector<std::size_t>& which) const {
    const Scale x = position_axis(), v = velocity_axis();
    Panel panel;
    panel.phase_portrait = true;
    panel.names_listed = true;
    panel.x.name = x.name;
    panel.y.name = v.name;
    for (const std::size_t run : which) {
      const Trajectory& motion = runs_[run].trajectory;
      const PortraitPart part = portrait_part(0, runs_[run].until, natural_period(runs_[run].oscillator));
      panel.title = part.title;
      Curve& curve = panel.curves.emplace_back();
      for (std::size_t i = 0; i < motion.size(); ++i) {
        const bool near = std::abs(motion.x[i]) <= 3 * position_.height &&
                          std::abs(motion.v[i]) <= 3 * velocity_.height && part.has(motion.t[i]);
        constexpr double gap = std::numeric_limits<double>::quiet_NaN();
        if (!near && !curve.y.empty() && std::isnan(curve.y.back())) continue;
        curve.x.push_back(near ? motion.x[i] / x.unit : gap);
        curve.y.push_back(near ? motion.v[i] / v.unit : gap);
      }
    }
    cut(panel.x, position_, which, x.unit);
    cut(panel.y, velocity_, which, v.unit);
    return panel;
  }

  const std::vector<SimulatedRun>& runs_;
  bool one_method_;
  Framed position_, velocity_, energy_;
  LengthUnit length_{};
};

}  // namespace

Figure simulate_figure(const SimulateResult& result, std::span<const MotionPanel> asked,
                       const LaidOver* over) {
  const auto& runs = result.runs;
  const Panels panels(result, asked);
  const std::size_t frequencies = std::max<std::size_t>(1, result.options.drive_frequency.size());
  const bool apart = !panels.one_method() && frequencies > 1;

  Figure figure;
  figure.id = "simulate";
  figure.title = panels_in_words(asked) + " by " +
                 (panels.one_method() ? runs.front().method : std::string("several methods"));
  figure.size = FigureSize::wide;
  figure.shared_x = true;
  // Several methods at several frequencies: a colour for each method, panels for each frequency.
  const std::size_t groups = apart ? frequencies : 1;
  for (std::size_t group = 0; group < groups; ++group) {
    std::vector<std::size_t> which;
    for (std::size_t i = group; i < runs.size(); i += groups) which.push_back(i);
    for (const MotionPanel each : asked) {
      Panel panel = panels.panel(each, which, frequencies > 1 && !apart);
      if (over && each == MotionPanel::position) panel.curves.push_back(panels.dots(*over));
      if (apart) {
        const std::string frequency = format_quantity({runs[group].drive.frequency, 0}, "rad/s");
        panel.title = panel.title.empty() ? frequency : panel.title + " at " + frequency;
      }
      figure.panels.push_back(std::move(panel));
    }
  }
  set_portrait_size(figure);
  return figure;
}

}  // namespace cromer::core
