#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "cromer/base/length_unit.h"
#include "cromer/figures/figures.h"
#include "cromer/figures/panels.h"
#include "cromer/report/palette.h"

namespace cromer::core {
namespace {

/// The values that are not missing, in one unit.
Curve known_curve(const std::vector<double>& t, const std::vector<double>& y, double seconds, double unit) {
  Curve curve;
  for (std::size_t n = 0; n < t.size(); ++n) {
    if (std::isnan(y[n])) continue;
    curve.x.push_back(t[n] / seconds);
    curve.y.push_back(y[n] / unit);
  }
  return curve;
}

LengthUnit unit_for(bool angles, double largest) {
  if (!angles) return length_unit(largest);
  return largest < 0.02 ? LengthUnit{"mrad", 1e-3} : LengthUnit{"rad", 1};
}

double largest_known(const std::vector<double>& y) {
  double largest = 0;
  for (const double each : y)
    if (!std::isnan(each)) largest = std::max(largest, std::abs(each));
  return largest;
}

}  // namespace

Figure network_fit_figure(const FittedNetwork& fitted) {
  constexpr std::size_t most = 4;
  const Channels& channels = fitted.channels;
  const std::size_t drawn = std::min(most, fitted.fit.columns.size());
  const bool angles = fitted.asked.network.angles;
  double largest = 0, rest = 0;
  for (std::size_t i = 0; i < drawn; ++i) {
    largest = std::max(largest, largest_known(channels.each[i].y));
    rest = std::max(rest, largest_known(fitted.fit.columns[i].residual));
  }
  const LengthUnit length = unit_for(angles, largest), small = unit_for(angles, rest);
  const TimeUnit time = time_unit(channels.t.back());
  const std::string of_time = fmt::format("time {{/:Italic t}} ({})", time.symbol);

  Figure figure;
  figure.id = "network-fit";
  figure.title = "What the masses did, and what the network leaves of it";
  const std::string of_file = fitted.network_file == given_network ? "" : " " + fitted.network_file;
  const std::string part = drawn == fitted.fit.columns.size()
                               ? ""
                               : fmt::format(" ({} of {} masses)", drawn, fitted.fit.columns.size());
  figure.caption =
      fmt::format("{} and the network{}{}; at the bottom measured less fitted.", fitted.file, of_file, part);
  figure.size = FigureSize::wide;
  Panel residual;
  residual.x.name = of_time;
  residual.y.name = fmt::format("residual ({})", small.symbol);
  for (std::size_t i = 0; i < drawn; ++i) {
    const std::string& name = fitted.asked.network.masses[i].name;
    Panel panel;
    panel.x.name = of_time;
    panel.y.name = fmt::format("{} ({})", name, length.symbol);
    panel.curves.push_back(known_curve(channels.t, channels.each[i].y, time.seconds, length.metres));
    panel.curves.back().role = panel.curves.back().name = "measured";
    panel.curves.back().mark = Mark::dots;
    std::vector<double> law = channels.each[i].y;
    for (std::size_t n = 0; n < law.size(); ++n) law[n] -= fitted.fit.columns[i].residual[n];
    panel.curves.push_back(known_curve(channels.t, law, time.seconds, length.metres));
    panel.curves.back().role = panel.curves.back().name = "fitted";
    figure.panels.push_back(std::move(panel));
    residual.curves.push_back(
        known_curve(channels.t, fitted.fit.columns[i].residual, time.seconds, small.metres));
    residual.curves.back().role = family_role(i, drawn);
    residual.curves.back().name = name;
  }
  figure.panels.push_back(std::move(residual));
  return figure;
}

}  // namespace cromer::core
