#include "cromer/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/analysis/envelope.h"
#include "cromer/base/length_unit.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/text/words.h"
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

/// Whether the law, as the method simulates it, lets every motion grow.
bool is_unstable(const SimulatedRun& run) { return run.effect && !run.effect->stable; }

/// All runs fit in, unless one runs away far beyond the others or its own `early` size: a driven motion may
/// grow into resonance. `power` of the amplitude, by which the quantity grows: 1, of an energy 2.
Framed framed(const std::vector<SimulatedRun>& runs, std::vector<std::vector<double>> values,
              const std::vector<double>& early_sizes, double power) {
  const auto times = [&](double amplitudes) { return std::pow(amplitudes, power); };
  double smallest = std::numeric_limits<double>::infinity(), greatest = 0, greatest_steady = 0;
  std::vector<double> wholes;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SimulatedRun& run = runs[i];
    const double whole = largest(run.trajectory, values[i], 0, run.until);
    const double early = early_sizes[i];
    const bool diverged = run.outcome.status == Status::not_finite || whole > times(1e3) * early;
    const bool driven = run.drive.amplitude > 0 || run.general;
    if (!diverged && !is_unstable(run) && (driven || whole <= times(20) * early))
      greatest_steady = std::max(greatest_steady, whole);
    smallest = std::min(smallest, diverged && early > 0 ? times(10) * early : whole);
    greatest = std::max(greatest, whole);
    wholes.push_back(whole);
  }
  bool cut = false;  // what is unstable need not be seen for long
  for (std::size_t i = 0; i < runs.size() && smallest > 0; ++i)
    cut = cut || wholes[i] > std::max(greatest_steady, times(is_unstable(runs[i]) ? 8 : 20) * smallest);
  Framed all{std::move(values)};
  all.height = cut ? std::max(greatest_steady, times(4) * smallest) : greatest;
  for (const double whole : wholes) all.leaves.push_back(whole > all.height);
  return all;
}

struct Ends {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  double first = 0, last = 0;

  bool no_turn_between() const { return std::min(first, last) == low && std::max(first, last) == high; }
};

/// The extremes of the motion from a time on.
Ends ends_from(const Trajectory& motion, double from) {
  Ends ends;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    if (motion.t[i] < from) continue;
    if (!(ends.low <= ends.high)) ends.first = motion.x[i];
    ends.last = motion.x[i];
    ends.low = std::min(ends.low, motion.x[i]);
    ends.high = std::max(ends.high, motion.x[i]);
  }
  return ends;
}

/// Whether it swings freely about 0, as far to one side as to the other.
bool swings_about_zero(const SimulatedRun& run) {
  const Oscillator<double>& o = run.oscillator;
  return run.drive.amplitude == 0 && !run.general && o.quadratic == 0 && o.friction == 0 &&
         o.hysteresis_stiffness == 0;
}

/// The amplitude [m] of such a swing at its end, by the ratio of its last two turning points; NaN if it does
/// not turn any more.
double amplitude_at_end(const Trajectory& motion) {
  const Envelope turns = envelope(motion.t, motion.x);
  if (turns.top.empty() || turns.bottom.empty()) return std::nan("");
  const double top = turns.top.back(), bottom = -turns.bottom.back(), top_t = turns.top_t.back(),
               bottom_t = turns.bottom_t.back(), half_period = std::abs(top_t - bottom_t);
  const double since = motion.t.back() - std::max(top_t, bottom_t);
  if (!(top > 0 && bottom > 0) || since > 1.5 * half_period) return std::nan("");
  const double last = top_t > bottom_t ? top : bottom, before = top_t > bottom_t ? bottom : top;
  return last * std::pow(last / before, since / half_period);
}

/// What is said of a run that does not stay in the frame until its end; else "". `values` are those in the
/// frame, in `unit`.
std::string early_end(const SimulatedRun& run, bool leaves, const std::vector<double>& values, double unit,
                      std::string_view symbol) {
  if (run.outcome.status == Status::not_finite || (leaves && is_unstable(run))) return grows;
  if (leaves)
    return fmt::format("reaches {} {}", rounded(largest(run.trajectory, values, 0, run.until) / unit, 3),
                       symbol);
  if (run.outcome.status != Status::reached_end) return fmt::format("ends at {:.4g} s", run.outcome.t);
  return "";
}

/// "±1.2 cm at the end" of a run that stays in the frame, "0.1 cm at the end" of one that does not swing any
/// more; "from −1.4 to 1.8 cm in the last 3 s" of one that does not swing evenly.
std::string swing_at_end(const SimulatedRun& run, const LengthUnit& unit, const TimeUnit& time) {
  const auto in_unit = [&](double x) { return rounded(x / unit.metres, 3); };
  const auto amplitude = [&](double x) { return fmt::format("±{} {} at the end", in_unit(x), unit.symbol); };
  if (swings_about_zero(run))
    if (const double at_end = amplitude_at_end(run.trajectory); std::isfinite(at_end))
      return amplitude(at_end);
  // The extremes tell the amplitude only over at least one period.
  const bool harmonic = run.drive.amplitude > 0 && run.drive.frequency > 0;
  const double period = natural_period(run.oscillator);
  const double of_drive = harmonic ? two_pi / run.drive.frequency : run.general ? 0.1 * run.until : 0;
  const double window = std::max(period > 0 ? period : 0.1 * run.until, of_drive);
  if (window > 0.5 * run.until) return "";
  const Ends ends = ends_from(run.trajectory, run.until - window);
  if (!(ends.high >= ends.low)) return "";
  const std::string low = in_unit(ends.low), high = in_unit(ends.high);
  if (low == high || ends.no_turn_between()) {
    constexpr double nothing = 1e-6;  // of the largest
    const bool seen = std::abs(ends.last) > nothing * largest(run.trajectory, run.trajectory.x, 0, run.until);
    return fmt::format("{} {} at the end", in_unit(seen ? ends.last : 0), unit.symbol);
  }
  if (std::abs(ends.high + ends.low) < 0.01 * (ends.high - ends.low))
    return amplitude((ends.high - ends.low) / 2);
  return fmt::format("from {} to {} {}\nin the last {} {}", low, high, unit.symbol,
                     rounded(window / time.seconds, 2), time.symbol);
}

std::string name_of(const SimulatedRun& run, bool by_frequency) {
  return by_frequency ? fmt::format("{:.6g} rad/s", run.drive.frequency) : method_in_words(run.method);
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
    angle_ = std::any_of(runs_.begin(), runs_.end(),
                         [](const SimulatedRun& run) { return run.oscillator.pendulum != 0; });
    length_ = unit_of(position_.height);
    double duration = 0;
    for (const SimulatedRun& run : runs_) duration = std::max(duration, run.until);
    time_ = time_unit(duration);
    if (asks(MotionPanel::velocity) || asks(MotionPanel::phase)) {
      auto v = each([](const SimulatedRun& run) { return run.trajectory.v; });
      // A run in long steps has only its start in the first part, where it may be at rest.
      std::vector<double> early = sizes_at_first(runs_, v);
      for (std::size_t i = 0; i < early.size(); ++i)
        if (const double period = natural_period(runs_[i].oscillator); period > 0)
          early[i] = std::max(early[i], two_pi / period * early_x[i]);
      velocity_ = framed(runs_, std::move(v), early, 1);
    }
    if (asks(MotionPanel::energy)) {
      auto energy = each(energies);
      const std::vector<double> early = sizes_at_first(runs_, energy);
      energy_ = framed(runs_, std::move(energy), early, 2);
    }
  }

  bool one_method() const { return one_method_; }

  /// One panel with the runs of these numbers, named by their frequencies or their methods.
  Panel panel(MotionPanel what, const std::vector<std::size_t>& which, bool by_frequency) const {
    Panel panel = what == MotionPanel::phase      ? portrait(which)
                  : what == MotionPanel::energy   ? against_time(energy_, energy_axis(), which)
                  : what == MotionPanel::velocity ? against_time(velocity_, velocity_axis(), which)
                                                  : against_time(position_, position_axis(), which);
    for (std::size_t i = 0; i < which.size(); ++i) {
      const SimulatedRun& run = runs_[which[i]];
      Curve& curve = panel.curves[i];
      curve.role = one_method_ && runs_.size() > 1 ? family_role(i, which.size()) : run.method;
      curve.name = name_of(run, by_frequency);
      if (what == MotionPanel::position || what == MotionPanel::energy) {
        const bool energy = what == MotionPanel::energy;
        const Framed& framed = energy ? energy_ : position_;
        const EnergyUnit joules = energy_unit(energy_.height);
        curve.remark =
            early_end(run, framed.leaves[which[i]], framed.values[which[i]],
                      energy ? joules.joules : length_.metres, energy ? joules.symbol : length_.symbol);
        if (curve.remark.empty())
          curve.remark = energy ? energy_at_end(which[i]) : swing_at_end(run, length_, time_);
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
    for (const double t : over.t) curve.x.push_back(t / time_.seconds);
    for (const double x : over.x) curve.y.push_back(x / length_.metres);
    curve.role = "measured";
    curve.name = "measured";
    curve.remark = samples_in_words(over.t.size());
    curve.mark = Mark::dots;
    return curve;
  }

 private:
  struct Scale {
    std::string name;  ///< of the axis, with unit
    double unit = 1;   ///< in SI units
  };

  /// Of a pendulum x is an angle.
  LengthUnit unit_of(double largest) const { return angle_ ? LengthUnit{"rad", 1} : length_unit(largest); }

  Scale position_axis() const {
    return {fmt::format("{} ({})", angle_ ? "angle" : "position {/:Italic x}", length_.symbol),
            length_.metres};
  }
  Scale velocity_axis() const {
    const LengthUnit unit = unit_of(velocity_.height);
    return {fmt::format("{} ({}/s)", angle_ ? "angular velocity" : "velocity {/:Italic v}", unit.symbol),
            unit.metres};
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
    panel.x.name = fmt::format("time {{/:Italic t}} ({})", time_.symbol);
    panel.y.name = scale.name;
    for (const std::size_t run : which) {
      Curve& curve = panel.curves.emplace_back();
      const std::vector<double>&t = runs_[run].trajectory.t, &values = framed.values[run];
      const std::size_t end =
          framed.leaves[run] ? end_of_line(t, values, framed.height, first_part(runs_[run])) : values.size();
      for (std::size_t i = 0; i < end; ++i) {
        curve.x.push_back(t[i] / time_.seconds);
        curve.y.push_back(std::clamp(values[i], -3 * framed.height, 3 * framed.height) / scale.unit);
      }
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
  bool angle_ = false;
  LengthUnit length_{};
  TimeUnit time_{"s", 1};
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
  figure.title =
      panels_in_words(asked) + " by " +
      (panels.one_method() ? method_in_words(runs.front().method) : std::string("several methods"));
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
