#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/figures/figures.h"
#include "cromer/figures/network_drawing.h"
#include "cromer/figures/panels.h"
#include "cromer/report/enhanced_text.h"
#include "cromer/report/palette.h"

namespace cromer::core {
namespace {

/// Each singular value against frequency; of many channels the first ones.
Panel spectrum_panel(const ModalSource& source) {
  const SpectralMatrix& spectrum = source.found.spectrum;
  Panel panel;
  panel.title = "Spectrum of all channels";
  const bool quotient = source.unit.find('/') != std::string::npos;
  panel.y.name = fmt::format("singular value ({}²/Hz)", quotient ? "(" + source.unit + ")" : source.unit);
  panel.y.logarithmic = true;
  constexpr std::size_t most = 4;
  // There are no more than segments that were averaged.
  const std::size_t count = std::min(
      {most, spectrum.singular.front().size(), static_cast<std::size_t>(std::max(1, spectrum.averages))});
  constexpr const char* names[] = {"first", "second", "third", "fourth"};
  for (std::size_t c = 0; c < count; ++c) {
    Curve curve;
    curve.role = family_role(c, count);
    curve.name = names[c];
    // What lies at frequency 0 is the mean, which was taken off.
    for (std::size_t k = 1; k < spectrum.singular.size(); ++k) {
      curve.x.push_back(spectrum.frequency(k));
      curve.y.push_back(spectrum.singular[k][c]);
    }
    panel.curves.push_back(std::move(curve));
  }
  return panel;
}

/// The poles of all orders.
Panel stabilisation_panel(const ModalSource& source) {
  Panel panel;
  panel.title = "Stabilisation diagram";
  panel.y.name = "order of the model";
  panel.y.low = 0;
  panel.y.high = source.found.highest_order + 2;
  Curve stable, others;
  stable.role = "fitted";
  stable.name = "stable";
  stable.mark = Mark::dots;
  others.role = "set-aside";
  others.name = "not stable";
  others.mark = Mark::crosses;
  for (const StabilityPole& pole : source.found.poles) {
    Curve& curve = pole.stable ? stable : others;
    curve.x.push_back(pole.frequency);
    curve.y.push_back(pole.order);
  }
  for (Curve* each : {&others, &stable})
    if (!each->x.empty()) panel.curves.push_back(std::move(*each));
  return panel;
}

/// A line for each mode. Words that would lie on each other stand together at the last of their lines.
void mark_modes(Panel& panel, const std::vector<MeasuredMode>& modes) {
  constexpr double width = 0.08;  // of a word, in panels
  std::string words;
  for (std::size_t j = 0; j < modes.size(); ++j) {
    const double frequency = modes[j].frequency.value;
    words += fmt::format("{}{:#.4g}", words.empty() ? "" : ", ", frequency);
    const bool room =
        j + 1 == modes.size() || modes[j + 1].frequency.value - frequency > width * panel.x.high;
    panel.markers.push_back({frequency, room ? words + " Hz" : ""});
    if (room) words.clear();
  }
}

/// How far each mass is out of its place where the largest is farthest, 1; with the sign of its phase.
std::vector<double> swing_of(const NaturalMode& mode) {
  std::vector<double> moved;
  for (const std::complex<double>& each : mode.shape) moved.push_back(each.real());
  return moved;
}

Panel shape_panel(const ModesResult& result, const NaturalMode& mode) {
  const Network& network = *result.network;
  if (network.masses.size() <= most_masses_drawn) return network_drawing(network, swing_of(mode));
  Panel panel;
  panel.x.name = "mass, in the order of the file";
  panel.y.name = "shape";
  Curve& curve = panel.curves.emplace_back();
  curve.role = family_role(0, 1);
  curve.y = swing_of(mode);
  for (std::size_t i = 1; i <= curve.y.size(); ++i) curve.x.push_back(static_cast<double>(i));
  return panel;
}

constexpr std::size_t most_shapes = 4;

/// The shapes of the first modes on the network.
void add_shapes(Figure& figure, const ModesResult& result) {
  for (std::size_t j = 0; j < std::min(most_shapes, result.modes.size()); ++j) {
    const NaturalMode& mode = result.modes[j];
    Panel& panel = figure.panels.emplace_back(shape_panel(result, mode));
    panel.title = fmt::format("Mode {}", j + 1);
    if (std::isfinite(mode.frequency.value)) panel.title += fmt::format(": {:.4g} Hz", mode.frequency.value);
    if (std::isfinite(mode.damping_ratio.value))
      panel.title += fmt::format(", damping ratio {:.3g} %", 100 * mode.damping_ratio.value);
    if (mode.of_network)
      panel.title +=
          fmt::format(", MAC {:.3f} with the network's mode {}", mode.of_network->mac, mode.of_network->mode);
  }
}

Figure network_modes_figure(const ModesResult& result) {
  Figure figure;
  figure.id = "modes";
  figure.title = "Modes";
  figure.caption =
      fmt::format("{}: {} masses, the shapes of {} of {} modes.", result.file, result.names.size(),
                  std::min(most_shapes, result.modes.size()), result.modes.size());
  figure.size = FigureSize::wide;
  if (result.names.size() <= most_masses_drawn) {
    figure.panels.push_back(network_drawing(*result.network));
    figure.panels.back().title = figure_text(short_name(result.file));
  }
  add_shapes(figure, result);
  return figure;
}

}  // namespace

Figure modes_figure(const ModesResult& result) {
  if (!result.recording) return network_modes_figure(result);
  const ModalSource& source = *result.recording;
  Figure figure;
  figure.id = "modes";
  figure.title = "Modes";
  figure.caption =
      fmt::format("{}: {} channels, {} modes.", result.file, result.names.size(), result.modes.size());
  figure.size = FigureSize::wide;
  figure.shared_x = !result.network;
  figure.panels.push_back(spectrum_panel(source));
  if (!source.found.poles.empty()) figure.panels.push_back(stabilisation_panel(source));
  const double highest_searched = source.found.lag_step > 0 ? 0.5 / source.found.lag_step : source.rate;
  for (Panel& panel : figure.panels) {
    panel.x.name = "frequency {/:Italic f} (Hz)";
    panel.x.low = 0;
    panel.x.high = std::min(source.rate / 2, highest_searched);
  }
  mark_modes(figure.panels.front(), source.found.modes);
  if (result.network) add_shapes(figure, result);
  return figure;
}

}  // namespace cromer::core
