// Figures of every kind.
#pragma once

#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "cromer/report/figure.h"

namespace cromer::core {

inline Curve swing(const std::string& role, double rate, double seconds = 8, double step = 0.01) {
  Curve curve;
  curve.role = role;
  for (int i = 0; i * step <= seconds; ++i) {
    const double t = i * step;
    curve.x.push_back(t);
    curve.y.push_back(3 * std::exp(-rate * t) * std::cos(6 * t));
  }
  return curve;
}

inline Panel three_methods() {
  Panel panel;
  panel.x.name = "time {/:Italic t} (s)";
  panel.y.name = "position {/:Italic x} (cm)";
  panel.curves = {swing("forward-euler", -0.06), swing("exact", 0.12), swing("euler-cromer", 0.12),
                  swing("implicit-euler", 0.3)};
  const char* names[] = {"forward Euler", "exact", "Euler-Cromer", "implicit Euler"};
  const char* remarks[] = {"grows, −0.060 1/s", "", "decays, 0.120 1/s", "too much, 0.299 1/s"};
  for (std::size_t i = 0; i < 4; ++i) panel.curves[i].name = names[i], panel.curves[i].remark = remarks[i];
  return panel;
}

inline Panel phase_portrait() {
  Panel panel;
  panel.phase_portrait = true;
  panel.x.name = "position (cm)";
  panel.y.name = "velocity (cm/s)";
  for (const auto& [role, rate, name] :
       {std::tuple{"forward-euler", -0.06, "forward Euler"}, {"euler-cromer", 0.12, "Euler-Cromer"}}) {
    Curve curve;
    curve.role = role, curve.name = name;
    for (int i = 0; i < 800; ++i) {
      curve.x.push_back(3 * std::exp(-rate * 0.01 * i) * std::cos(0.06 * i));
      curve.y.push_back(-18 * std::exp(-rate * 0.01 * i) * std::sin(0.06 * i));
    }
    panel.curves.push_back(curve);
  }
  panel.notes.push_back({"start", 3, 0, 0.9, 0.5, false, true, true});
  return panel;
}

inline Panel dense(Mark mark) {
  Panel panel;
  Curve curve = swing("measured", 0.01, 120);
  for (double& x : curve.y) x *= std::cos(0.001);
  curve.mark = mark;
  curve.name = "measured";
  panel.curves = {curve};
  return panel;
}

inline Figure of(std::vector<Panel> panels, FigureSize size = FigureSize::single) {
  Figure figure;
  figure.id = "figure-1";
  figure.title = "What is seen: {/:Italic x} & more";
  figure.size = size;
  figure.panels = std::move(panels);
  return figure;
}

inline std::vector<Figure> examples() {
  Panel log = three_methods();
  for (Curve& curve : log.curves) {
    for (double& x : curve.y) x = 1 + x * x;
  }
  log.y.logarithmic = true;
  log.markers.push_back({4, "end of part 1", "drive"});
  Figure grid = of({three_methods(), phase_portrait(), log}, FigureSize::wide);
  grid.columns = 2;
  grid.panels[0].span = 2;
  grid.panels[0].title = "Three methods";
  Figure shared = of({three_methods(), three_methods()});
  shared.shared_x = true;
  return {of({three_methods()}),
          of({three_methods()}, FigureSize::half),
          of({phase_portrait()}, FigureSize::phase),
          of({dense(Mark::dots)}),
          of({dense(Mark::band)}, FigureSize::half),
          of({log}),
          grid,
          shared,
          of({}),
          of({Panel{}})};
}

}  // namespace cromer::core
