#include "cromer/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cromer/analysis/envelope.h"
#include "cromer/base/quantity.h"
#include "cromer/figures/length_unit.h"
#include "cromer/report/palette.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

/// Largest |x| between the times `from` and `until`.
double largest(const Trajectory& trajectory, double from, double until) {
  double size = 0;
  for (std::size_t i = 0; i < trajectory.size(); ++i)
    if (trajectory.t[i] >= from && trajectory.t[i] <= until) size = std::max(size, std::abs(trajectory.x[i]));
  return size;
}

/// The first period, or a twentieth of the run if there is none [s]: a run has not grown yet by then.
double first_part(const SimulatedRun& run) {
  const double period = natural_period(run.oscillator);
  return period > 0 ? period : run.until / 20;
}

/// Half the height of the plot [m]. All runs fit in, unless one grows far beyond the others or its own start.
double frame(const std::vector<SimulatedRun>& runs) {
  double smallest = std::numeric_limits<double>::infinity(), greatest = 0;
  for (const auto& run : runs) {
    const double whole = largest(run.trajectory, 0, run.until);
    const double early = largest(run.trajectory, 0, first_part(run));
    const bool diverged = run.outcome.status == Status::not_finite || whole > 1e3 * early;
    smallest = std::min(smallest, diverged && early > 0 ? 10 * early : whole);
    greatest = std::max(greatest, whole);
  }
  return greatest > 20 * smallest && smallest > 0 ? 4 * smallest : greatest;
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

std::string remark(const SimulatedRun& run, double height, const LengthUnit& unit) {
  if (run.outcome.status == Status::not_finite || largest(run.trajectory, 0, run.until) > height)
    return "grows without end";
  if (run.outcome.status != Status::reached_end) return fmt::format("ends at {:.4g} s", run.outcome.t);
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

/// One panel with all these runs.
Panel panel_of(const std::vector<const SimulatedRun*>& runs, const SimulateResult& result, double height,
               const LengthUnit& unit, bool one_method, bool name_frequency) {
  Panel panel;
  panel.x.name = "time {/:Italic t} (s)";
  panel.y.name = fmt::format("position {{/:Italic x}} ({})", unit.symbol);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SimulatedRun& run = *runs[i];
    Curve curve;
    curve.x = run.trajectory.t;
    for (const double x : run.trajectory.x)
      curve.y.push_back(std::clamp(x, -3 * height, 3 * height) / unit.metres);
    curve.role = one_method && result.runs.size() > 1 ? family_role(i, runs.size()) : run.method;
    curve.name = name_of(run, one_method, name_frequency);
    curve.remark = remark(run, height, unit);
    panel.curves.push_back(std::move(curve));
  }
  // The exact solution lies below all others.
  std::stable_partition(panel.curves.begin(), panel.curves.end(),
                        [](const Curve& c) { return c.role == "exact"; });
  const bool cut = std::any_of(runs.begin(), runs.end(), [&](const SimulatedRun* run) {
    return largest(run->trajectory, 0, run->until) > height;
  });
  if (cut) {
    panel.y.low = -1.1 * height / unit.metres;
    panel.y.high = 1.1 * height / unit.metres;
  }
  return panel;
}

}  // namespace

Figure simulate_figure(const SimulateResult& result) {
  const auto& runs = result.runs;
  const double height = frame(runs);
  const LengthUnit unit = length_unit(height);
  const bool one_method = all_one_method(runs);
  const std::size_t frequencies = std::max<std::size_t>(1, result.options.drive_frequency.size());

  Figure figure;
  figure.id = "simulate";
  figure.title = one_method ? fmt::format("Position against time by {}", runs.front().method)
                            : std::string("Position against time by several methods");
  figure.size = FigureSize::wide;
  if (one_method || frequencies == 1) {
    std::vector<const SimulatedRun*> all;
    for (const SimulatedRun& run : runs) all.push_back(&run);
    figure.panels.push_back(panel_of(all, result, height, unit, one_method, frequencies > 1));
    return figure;
  }
  // Several methods at several frequencies: a colour for each method, a panel for each frequency.
  for (std::size_t f = 0; f < frequencies; ++f) {
    std::vector<const SimulatedRun*> same;
    for (std::size_t i = f; i < runs.size(); i += frequencies) same.push_back(&runs[i]);
    Panel panel = panel_of(same, result, height, unit, false, false);
    panel.title = format_quantity({same.front()->drive.frequency, 0}, "rad/s");
    figure.panels.push_back(std::move(panel));
  }
  figure.shared_x = true;
  return figure;
}

}  // namespace cromer::core
