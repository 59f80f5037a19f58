#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "cromer/base/length_unit.h"
#include "cromer/documents/text/words.h"
#include "cromer/figures/figures.h"
#include "cromer/figures/network_drawing.h"
#include "cromer/figures/panels.h"
#include "cromer/report/enhanced_text.h"
#include "cromer/report/palette.h"

namespace cromer::core {
namespace {

/// The masses that are drawn: all of few, else evenly chosen ones from the first to the last.
std::vector<std::size_t> drawn_masses(std::size_t count, std::size_t most) {
  std::vector<std::size_t> all;
  for (std::size_t k = 0; k < std::min(count, most); ++k)
    all.push_back(count <= most ? k : k * (count - 1) / (most - 1));
  return all;
}

/// In which units positions and times are drawn.
struct DrawnUnits {
  LengthUnit length;
  TimeUnit time;

  Panel panel(const std::string& quantity) const {
    Panel panel;
    panel.x.name = fmt::format("time {{/:Italic t}} ({})", time.symbol);
    panel.y.name = fmt::format("{} {{/:Italic x}} ({})", quantity, length.symbol);
    return panel;
  }
  Curve curve(const NetworkRun& run, std::size_t mass, std::string role, std::string name) const {
    Curve curve;
    curve.role = std::move(role);
    curve.name = std::move(name);
    for (const double t : run.states.t) curve.x.push_back(t / time.seconds);
    for (const double x : run.states.x[mass]) curve.y.push_back(x / length.metres);
    return curve;
  }
};

}  // namespace

Figure network_figure(std::span<const NetworkRun> runs) {
  const NetworkRun& first = runs.front();
  const Network& network = first.network;
  const bool several = runs.size() > 1;
  const std::vector<std::size_t> drawn = drawn_masses(network.masses.size(), several ? 3 : 5);
  // A run that grows without end is cut off: the calmest one sets the scale.
  double largest = std::numeric_limits<double>::infinity(), end = 0;
  for (const NetworkRun& run : runs) {
    double of_run = 0;
    for (const std::size_t i : drawn)
      for (const double x : run.states.x[i]) of_run = std::max(of_run, std::abs(x));
    largest = std::min(largest, of_run);
    end = std::max(end, run.states.t.back());
  }
  const DrawnUnits units{network.angles ? LengthUnit{"rad", 1} : length_unit(largest), time_unit(end)};
  const std::string quantity = network.angles ? "angle" : "position";

  Figure figure;
  figure.id = "network";
  figure.size = FigureSize::wide;
  std::string methods;
  for (const NetworkRun& run : runs) methods += (methods.empty() ? "" : ", ") + method_in_words(run.method);
  figure.title = fmt::format("{} by {}", network.angles ? "Angles" : "Positions", methods);
  const bool steps = std::any_of(runs.begin(), runs.end(), std::mem_fn(&NetworkRun::takes_steps));
  figure.caption = fmt::format("{}: {} of {} masses, {} {:.4g} s.", first.file, drawn.size(),
                               network.masses.size(), steps ? "steps of" : "a state every", first.step);
  if (network.masses.size() <= most_masses_drawn) {
    figure.panels.push_back(network_drawing(network));
    figure.panels.back().title = figure_text(short_name(first.file));
  }
  if (!several) {
    Panel& panel = figure.panels.emplace_back(units.panel(quantity));
    panel.title = figure.title;
    for (std::size_t k = 0; k < drawn.size(); ++k)
      panel.curves.push_back(units.curve(first, drawn[k], family_role(k, drawn.size()),
                                         figure_text(network.masses[drawn[k]].name)));
    return figure;
  }
  for (const std::size_t mass : drawn) {
    Panel& panel = figure.panels.emplace_back(units.panel(quantity));
    panel.title = figure_text(network.masses[mass].name);
    for (const NetworkRun& run : runs) {
      Curve curve = units.curve(run, mass, run.method, method_in_words(run.method));
      constexpr double most = 3;  // times the calmest
      const double height = most * largest / units.length.metres;
      curve.sets_axes =
          std::all_of(curve.y.begin(), curve.y.end(), [&](double y) { return std::abs(y) <= height; });
      if (!curve.sets_axes) curve.remark = grows;
      panel.curves.push_back(std::move(curve));
    }
    // The exact solution lies below the others.
    std::stable_partition(panel.curves.begin(), panel.curves.end(),
                          [](const Curve& curve) { return curve.role == "exact"; });
  }
  return figure;
}

}  // namespace cromer::core
