#include "cromer/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cromer/base/length_unit.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/text/words.h"
#include "cromer/figures/motion_curves.h"
#include "cromer/report/enhanced_text.h"
#include "cromer/tasks/fit/fitted_motion.h"
#include "cromer/tasks/fit/used_samples.h"

namespace cromer::core {
namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

/// How the end of a law compares with the measured one, in words.
std::string beside_measured(const ComparedCurve& curve) {
  if (curve.measured_at_rest) return curve.at_rest ? "stops as measured" : "swings on after the stop";
  const double ratio = curve.amplitude_ratio_end, off = std::abs(ratio - 1);
  if (off < 5e-3) return "within 0.5 % at the end";
  return fmt::format("{} % too {} at the end", rounded(100 * off, 2), ratio > 1 ? "large" : "small");
}

/// What the method makes of the law by the end, in words.
std::string beside_law(const ComparedCurve& curve) {
  if (curve.diverged) return std::string(grows) + ": step too long";
  if (!curve.complete) return "ends early";
  if (std::isnan(curve.method_amplitude_ratio)) return "";
  const double off = std::abs(curve.method_amplitude_ratio - 1), phase = std::abs(curve.method_phase);
  std::string words;
  if (off >= 5e-3)
    words = fmt::format("{} % too {}", rounded(100 * off, 2),
                        curve.method_amplitude_ratio > 1 ? "large" : "small");
  if (phase >= 0.01)
    words += fmt::format("{}{} rad {} the law", words.empty() ? "" : ",\n", rounded(phase, 2),
                         curve.method_phase > 0 ? "ahead of" : "behind");
  return words.empty() ? "as the law" : words;
}

/// The three kinds of curves, the law first.
enum class Kind { law, one_rate, method };
Kind kind_of(const ComparedCurve& curve) {
  if (curve.label.code == "one_constant_decay_rate") return Kind::one_rate;
  return curve.label.code == "law_by_method" ? Kind::method : Kind::law;
}

/// What the panels show of one recording.
class Compared {
 public:
  explicit Compared(const CompareResult& comparison)
      : recording_(comparison.recording), position_(measured_axis(recording_)), velocity_(position_) {
    for (const ComparedCurve& curve : comparison.curves) curves_.push_back(&curve);
    std::stable_sort(curves_.begin(), curves_.end(), [](const ComparedCurve* a, const ComparedCurve* b) {
      return kind_of(*a) < kind_of(*b);
    });
    if (curves_.empty()) return;
    const Trajectory& law = curves_.front()->trajectory;
    largest_x_ = largest_of(law.x);
    largest_v_ = largest_of(law.v);
    set_velocity_axis();
    set_energy_axis(largest_of(energies_of(recording_, law.x, law.v)));
  }

  Panel panel(MotionPanel what) const {
    Panel panel = what == MotionPanel::phase      ? portrait()
                  : what == MotionPanel::energy   ? energy()
                  : what == MotionPanel::velocity ? velocity()
                                                  : position();
    constexpr std::size_t most_at_curves = 6;
    const auto named = std::count_if(panel.curves.begin(), panel.curves.end(),
                                     [](const Curve& curve) { return !curve.name.empty(); });
    if (static_cast<std::size_t>(named) > most_at_curves) panel.names_listed = true;
    return panel;
  }

 private:
  void set_velocity_axis() {
    velocity_.equilibrium = 0;
    if (recording_.series.quantity == "position" && recording_.series.to_si == 1) {
      const LengthUnit unit = length_unit(largest_v_);
      velocity_.unit = unit.symbol;
      velocity_.unit_size = unit.metres;
    }
    velocity_.name = recording_.series.quantity == "angle" ? "angular velocity" : "velocity {/:Italic v}";
    if (!velocity_.unit.empty()) velocity_.name += fmt::format(" ({}/s)", velocity_.unit);
  }

  void set_energy_axis(double largest) {
    const std::string unit = motion_units(recording_).energy;
    const EnergyUnit scale = unit.empty() ? EnergyUnit{"", 1} : energy_unit(largest);
    joules_ = scale.joules;
    energy_name_ = "energy {/:Italic E}";
    if (!unit.empty())
      energy_name_ += fmt::format(" ({})", figure_text(std::string(scale.symbol) + unit.substr(1)));
  }

  /// A run that leaves the frame of the others is cut at it.
  bool leaves(const ComparedCurve& curve) const {
    constexpr double most = 4;  // times the law's own motion
    return curve.diverged || largest_of(curve.trajectory.x) > most * largest_x_;
  }

  /// The law is the road that the methods stay on or leave.
  Curve look_of(const ComparedCurve& compared, bool remarks) const {
    Curve look;
    switch (kind_of(compared)) {
      case Kind::law:
        look.role = "fitted";
        look.road = true;
        look.name = to_text(compared.law);
        break;
      case Kind::one_rate:
        look.role = "constant-rate";
        look.name = "one constant rate";
        look.dashed = true;
        break;
      case Kind::method:
        look.role = compared.method;
        look.name = method_in_words(compared.method);
        break;
    }
    if (remarks)
      look.remark = kind_of(compared) == Kind::method ? beside_law(compared) : beside_measured(compared);
    look.sets_axes = !leaves(compared);
    return look;
  }

  /// A run that leaves the frame, until it has left it for good.
  Trajectory in_sight(const ComparedCurve& compared) const {
    Trajectory motion = compared.trajectory;
    if (!leaves(compared)) return motion;
    const std::size_t end = end_of_line(motion.t, motion.x, largest_x_, period());
    for (std::vector<double>* values : {&motion.t, &motion.x, &motion.v}) values->resize(end);
    return motion;
  }

  double period() const { return two_pi / recording_.fit.angular_frequency().value; }

  Panel on_time(std::string name) const {
    Panel panel;
    panel.x.name = position_.time_name;
    panel.y.name = std::move(name);
    return panel;
  }

  Panel position() const {
    Panel panel = on_time(position_.name);
    add_measured(panel, recording_, position_);
    for (const ComparedCurve* curve : curves_) {
      const Trajectory seen = in_sight(*curve);
      add_motion(panel, recording_, position_, {seen.t, position_.scaled(seen.x)}, look_of(*curve, true));
    }
    return panel;
  }

  /// Adds the measured values at the samples, in SI units, as dots.
  void add_dots(Panel& panel, std::vector<double> values, double unit) const {
    for (double& value : values) value /= unit;
    panel.curves.push_back(measured_dots(recording_, position_, {measured().t, std::move(values)}));
    panel.curves.back().name = "measured";
  }

  Panel velocity() const {
    Panel panel = on_time(velocity_.name);
    add_dots(panel, measured().local_velocity, velocity_.unit_size);
    for (const ComparedCurve* curve : curves_) {
      const Trajectory seen = in_sight(*curve);
      add_motion(panel, recording_, position_, {seen.t, velocity_.scaled(seen.v)}, look_of(*curve, false));
    }
    return panel;
  }

  Panel energy() const {
    Panel panel = on_time(energy_name_);
    add_dots(panel, energies_of(recording_, displacement(), measured().local_velocity), joules_);
    for (const ComparedCurve* curve : curves_) {
      Trajectory seen = in_sight(*curve);
      std::vector<double> values = energies_of(recording_, seen.x, seen.v);
      for (double& value : values) value /= joules_;
      add_line(panel, recording_, position_, {std::move(seen.t), std::move(values)}, look_of(*curve, false));
    }
    return panel;
  }

  Panel portrait() const {
    Panel panel;
    panel.phase_portrait = true;
    panel.names_listed = true;
    panel.x.name = position_.name;
    panel.y.name = velocity_.name;
    const std::vector<double>& t = recording_.series.t;
    const PortraitPart part = portrait_part(t.front(), t.back(), period());
    panel.title = part.title;
    const auto orbit = [&](Curve look, const std::vector<double>& at, const std::vector<double>& x,
                           const std::vector<double>& v) {
      constexpr double room = 1.5;  // for a run that leaves
      for (std::size_t i = 0; i < std::min(x.size(), v.size()); ++i) {
        const bool seen =
            part.has(at[i]) &&
            (look.sets_axes || (std::abs(x[i]) <= room * largest_x_ && std::abs(v[i]) <= room * largest_v_));
        if (!seen && !look.y.empty() && std::isnan(look.y.back())) continue;
        look.x.push_back(seen ? x[i] / position_.unit_size : gap);
        look.y.push_back(seen ? v[i] / velocity_.unit_size : gap);
      }
      panel.curves.push_back(std::move(look));
    };
    Curve dots;
    dots.role = dots.name = "measured";
    dots.mark = Mark::dots;
    orbit(std::move(dots), measured().t, displacement(), measured().local_velocity);
    for (const ComparedCurve* curve : curves_)
      orbit(look_of(*curve, false), curve->trajectory.t, curve->trajectory.x, curve->trajectory.v);
    return panel;
  }

  const FittedMotion& measured() const {
    if (measured_.t.empty()) measured_ = fitted_motion(recording_);
    return measured_;
  }

  std::vector<double> displacement() const {
    std::vector<double> x = measured().measured;
    for (double& each : x) each -= recording_.fit.equilibrium().value;
    return x;
  }

  const FittedRecording& recording_;
  MeasuredAxis position_, velocity_;
  std::vector<const ComparedCurve*> curves_{};  ///< the law first
  double largest_x_ = 0, largest_v_ = 0;        ///< of the law
  double joules_ = 1;                           ///< of the energy's unit
  std::string energy_name_{};
  mutable FittedMotion measured_{};  ///< made where it is first needed
};

}  // namespace

Figure compare_figure(std::span<const CompareResult> comparisons, std::span<const MotionPanel> asked) {
  Figure figure;
  figure.id = "compare";
  figure.title = panels_in_words(asked) + ", measured and simulated";
  figure.size = FigureSize::wide;
  constexpr std::size_t most_in_full = 3, most_panels = 24;
  const auto drawable = static_cast<std::size_t>(
      std::count_if(comparisons.begin(), comparisons.end(),
                    [](const CompareResult& each) { return !each.recording.series.t.empty(); }));
  figure.shared_x = drawable == 1;
  const bool grid = drawable > most_in_full;
  const std::size_t most_runs = most_panels / asked.size();
  if (grid) {
    figure.columns = asked.size() == 1 ? 3 : static_cast<int>(asked.size());
    if (drawable > most_runs) figure.note = fmt::format("The first {} of {} runs.", most_runs, drawable);
  }
  std::size_t runs = 0;
  for (const auto& comparison : comparisons) {
    if (comparison.recording.series.t.empty() || runs == most_runs) continue;
    ++runs;
    const Compared compared(comparison);
    // What could not be fitted has no velocity and no energy either.
    const std::span<const MotionPanel> possible =
        comparison.curves.empty() ? std::span<const MotionPanel>(position_alone) : asked;
    for (const MotionPanel each : possible) {
      Panel panel = compared.panel(each);
      if (comparisons.size() > 1) {
        const std::string run = fmt::format("Run {}", comparison.recording.series.run);
        panel.title = panel.title.empty() ? run : run + ": " + panel.title;
      }
      if (grid) {
        if (!panel.phase_portrait) panel.title += ": " + law_found(comparison.recording);
        for (Curve& curve : panel.curves)
          if (curve.role == "fitted" && !curve.name.empty()) curve.name = "law";
      }
      figure.panels.push_back(std::move(panel));
    }
  }
  if (grid) move_names_to_key(figure);
  set_portrait_size(figure);
  return figure;
}

}  // namespace cromer::core
