#include "bench/calibration/coverage_figure.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace cromer::core::bench {
namespace {

// Names in the order of their first appearance.
std::vector<std::string> names_of(const std::vector<Tally>& tallies, const char* Tally::*member) {
  std::vector<std::string> names;
  for (const Tally& tally : tallies)
    if (std::find(names.begin(), names.end(), tally.*member) == names.end()) names.push_back(tally.*member);
  return names;
}

double place_of(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<double>(std::find(names.begin(), names.end(), name) - names.begin());
}

}  // namespace

Figure coverage_figure(const std::vector<Tally>& tallies) {
  const std::vector<std::string> conditions = names_of(tallies, &Tally::condition);
  const std::vector<std::string> laws = names_of(tallies, &Tally::law);
  const auto rows = static_cast<double>(conditions.size());
  constexpr double lowest = 91, highest = 100, names_from = 87.4;
  // One hue for the smooth laws, one for those with friction, dark to light.
  constexpr const char* roles[] = {"family:0",          "family:1",       "family:3",         "family:4",
                                   "implicit-family:0", "implicit-euler", "implicit-family:4"};

  Panel panel;
  panel.x = {"95 % intervals that hold the truth (%)", names_from, highest, 1};
  panel.y = {"", 0.01, rows + 0.6, 99 * rows};  // no ticks: the rows have words; room for the markers' ones
  panel.names_inside = false;
  const double part = 0.7 / static_cast<double>(laws.size());
  for (const std::string& law : laws) {
    Curve curve;
    curve.role = roles[static_cast<std::size_t>(place_of(laws, law)) % std::size(roles)];
    curve.name = law;
    // From the last row to the first, where the names then stand.
    for (auto each = tallies.rbegin(); each != tallies.rend(); ++each) {
      const Tally& tally = *each;
      if (tally.law != law) continue;
      double least = 1, most = 0;
      for (const ParameterTally& parameter : tally.parameters) {
        least = std::min(least, parameter.coverage);
        most = std::max(most, parameter.coverage);
      }
      const double y =
          rows - place_of(conditions, tally.condition) - 0.15 - part * (place_of(laws, law) + 0.5);
      for (const double x :
           {std::max(lowest, 100 * least - 0.04), std::max(lowest, 100 * most + 0.04), std::nan("")}) {
        curve.x.push_back(x);
        curve.y.push_back(y);
      }
    }
    panel.curves.push_back(std::move(curve));
  }
  for (std::size_t i = 0; i < conditions.size(); ++i)
    panel.notes.push_back({.text = conditions[i],
                           .text_x = 0.01,
                           .text_y = (rows - static_cast<double>(i) - 0.5) / (rows + 0.6),
                           .leader = false});
  panel.markers = {{.x = 93, .text = "93"}, {.x = 97, .text = "97"}};

  Figure figure;
  figure.id = "calibration";
  figure.title = "How many of the 95 % intervals hold the truth";
  figure.size = FigureSize::wide;
  figure.panels = {std::move(panel)};
  return figure;
}

}  // namespace cromer::core::bench
