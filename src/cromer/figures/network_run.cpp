#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/base/length_unit.h"
#include "cromer/figures/figures.h"
#include "cromer/figures/panels.h"
#include "cromer/report/palette.h"

namespace cromer::core {
namespace {

/// The masses that are drawn: all of few, else evenly chosen ones from the first to the last.
std::vector<std::size_t> drawn_masses(std::size_t count) {
  constexpr std::size_t most = 5;
  std::vector<std::size_t> all;
  for (std::size_t k = 0; k < std::min(count, most); ++k)
    all.push_back(count <= most ? k : k * (count - 1) / (most - 1));
  return all;
}

}  // namespace

Figure network_figure(const NetworkRun& run) {
  const std::vector<std::size_t> drawn = drawn_masses(run.network.masses.size());
  double largest = 0;
  for (const std::size_t i : drawn)
    for (const double x : run.states.x[i]) largest = std::max(largest, std::abs(x));
  const LengthUnit length = run.network.angles ? LengthUnit{"rad", 1} : length_unit(largest);
  const TimeUnit time = time_unit(run.states.t.back());

  Panel panel;
  panel.x.name = fmt::format("time {{/:Italic t}} ({})", time.symbol);
  panel.y.name =
      fmt::format("{} {{/:Italic x}} ({})", run.network.angles ? "angle" : "position", length.symbol);
  std::vector<double> t = run.states.t;
  for (double& each : t) each /= time.seconds;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    Curve curve;
    curve.x = t;
    curve.role = family_role(k, drawn.size());
    curve.name = run.network.masses[drawn[k]].name;
    for (const double x : run.states.x[drawn[k]]) curve.y.push_back(x / length.metres);
    panel.curves.push_back(std::move(curve));
  }
  Figure figure;
  figure.id = "network";
  figure.title = fmt::format("{} by {}", run.network.angles ? "Angles" : "Positions", run.method);
  figure.caption = fmt::format("{}: {} of {} masses, steps of {:.4g} s.", run.file, drawn.size(),
                               run.network.masses.size(), run.step);
  figure.size = FigureSize::wide;
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace cromer::core
