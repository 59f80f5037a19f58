#include "simulate_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cromer/base/quantity.h"
#include "cromer/study/task/simulate_setup.h"
#include "length_unit.h"

namespace cromer::cli {
namespace {

/// Largest |x| from the first state to the one at `until`.
double largest(const Trajectory& trajectory, double from, double until) {
  double size = 0;
  for (std::size_t i = 0; i < trajectory.size(); ++i)
    if (trajectory.t[i] >= from && trajectory.t[i] <= until) size = std::max(size, std::abs(trajectory.x[i]));
  return size;
}

/// A first period (or a twentieth of the run where there is none): what a run does before it grows.
double first_part(const SimulatedRun& run) {
  const double period = natural_period(run.oscillator);
  return period > 0 ? period : run.until / 20;
}

/// Half the height of the plot [m]: all of every run, unless one outgrows the others, or itself, by far.
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

std::string remark(const SimulatedRun& run, double height, const LengthUnit& unit) {
  if (run.outcome.status == Status::not_finite || largest(run.trajectory, 0, run.until) > height)
    return "grows without end";
  if (run.outcome.status != Status::reached_end) return fmt::format("ends at {:.4g} s", run.outcome.t);
  // The largest excursion says something only where at least a period of the drive is looked at.
  const double drive_period =
      run.drive.amplitude > 0 && run.drive.frequency > 0 ? 2 * std::numbers::pi / run.drive.frequency : 0;
  const double window = std::max(0.1 * run.until, drive_period);
  if (window > 0.5 * run.until) return "";
  const double last = largest(run.trajectory, run.until - window, run.until);
  return fmt::format("±{} {} at the end", rounded(last / unit.metres, 3), unit.symbol);
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

}  // namespace

Figure simulate_figure(const SimulateResult& result) {
  const auto& runs = result.runs;
  const double height = frame(runs);
  const LengthUnit unit = length_unit(height);
  const bool one_method = all_one_method(runs);
  const bool family = one_method && runs.size() > 1;

  Panel panel;
  panel.x.name = "time {/:Italic t} (s)";
  panel.y.name = fmt::format("position {{/:Italic x}} ({})", unit.symbol);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SimulatedRun& run = runs[i];
    Curve curve;
    curve.x = run.trajectory.t;
    for (const double x : run.trajectory.x)
      curve.y.push_back(std::clamp(x, -3 * height, 3 * height) / unit.metres);
    curve.role = family ? fmt::format("family:{}", std::min<std::size_t>(i, 4)) : run.method;
    curve.name = name_of(run, one_method, result.options.drive_frequency.size() > 1);
    curve.remark = remark(run, height, unit);
    panel.curves.push_back(std::move(curve));
  }
  // The exact solution is the road under everything.
  std::stable_partition(panel.curves.begin(), panel.curves.end(),
                        [](const Curve& c) { return c.role == "exact"; });
  const bool cut = std::any_of(runs.begin(), runs.end(), [&](const auto& run) {
    return largest(run.trajectory, 0, run.until) > height;
  });
  if (cut) {
    panel.y.low = -1.1 * height / unit.metres;
    panel.y.high = 1.1 * height / unit.metres;
  }

  Figure figure;
  figure.id = "simulate";
  figure.title = one_method ? fmt::format("Position against time by {}", runs.front().method)
                            : std::string("Position against time by several methods");
  figure.size = FigureSize::wide;
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace cromer::cli
