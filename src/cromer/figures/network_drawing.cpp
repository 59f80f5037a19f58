#include "cromer/figures/network_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "cromer/base/quantity.h"
#include "cromer/model/law_force.h"
#include "cromer/report/enhanced_text.h"

namespace cromer::core {
namespace {

// About pixels of a wide figure; the masses stand at height 0.
constexpr double whole_width = 1000;
constexpr double box_half_width = 46, box_half_height = 21;
constexpr double ground_height = -115;
constexpr double over_links = 50;                   // of words over the link of two neighbours
constexpr double arc_height = 90, arc_rise = 34;    // of links over the heads of others
constexpr double farthest = 0.3;                    // a mass out of its place, of the distance between two
constexpr double beside = 15;                       // between parts of one link
constexpr double turn = 6, cup = 7, surface = 2.5;  // half the width of a spring, a damper, a slider

struct DrawnAt {
  double x = 0, y = 0;
};

/// Pieces of lines, all of one look.
class Strokes {
 public:
  explicit Strokes(std::string role) { curve_.role = std::move(role); }

  void line(const std::vector<DrawnAt>& points) {
    for (const auto& [x, y] : points) {
      curve_.x.push_back(x);
      curve_.y.push_back(y);
    }
    curve_.x.push_back(std::numeric_limits<double>::quiet_NaN());
    curve_.y.push_back(std::numeric_limits<double>::quiet_NaN());
  }
  void box(double x, double y) {
    const double w = box_half_width, h = box_half_height;
    line({{x - w, y - h}, {x + w, y - h}, {x + w, y + h}, {x - w, y + h}, {x - w, y - h}});
  }
  Curve take() { return std::move(curve_); }

 private:
  Curve curve_;
};

/// One part of a link from a to b, drawn along its way: `along` from 0 to 1, `across` to the side.
template <class Shape>
void draw_part(Strokes& strokes, const DrawnAt& a, const DrawnAt& b, const Shape& shape) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  const auto at = [&](double along, double across) {
    return DrawnAt{a.x + along * dx - across * dy / length, a.y + along * dy + across * dx / length};
  };
  for (const auto& piece : shape) {
    std::vector<DrawnAt> points;
    for (const auto& [along, across] : piece) points.push_back(at(along, across));
    strokes.line(points);
  }
}

using Pieces = std::vector<std::vector<DrawnAt>>;

Pieces spring_shape() {
  constexpr int turns = 5;
  constexpr double first = 0.22, last = 0.78, wide = turn;
  std::vector<DrawnAt> points{{0, 0}, {first, 0}};
  for (int i = 0; i < 2 * turns; ++i)
    points.push_back({first + (last - first) * (i + 0.5) / (2 * turns), i % 2 ? -wide : wide});
  points.insert(points.end(), {{last, 0}, {1, 0}});
  return {points};
}

Pieces damper_shape() {
  constexpr double wide = cup;
  return {{{0, 0}, {0.38, 0}},
          {{0.62, wide}, {0.38, wide}, {0.38, -wide}, {0.62, -wide}},
          {{0.5, 0.7 * wide}, {0.5, -0.7 * wide}},
          {{0.5, 0}, {1, 0}}};
}

/// Two surfaces that rub.
Pieces slider_shape() {
  constexpr double gap = surface;
  return {{{0, 0}, {0.35, 0}, {0.35, gap}, {0.65, gap}}, {{0.35, -gap}, {0.65, -gap}, {0.65, 0}, {1, 0}}};
}

/// What a link is made of, one part beside the other.
std::vector<Pieces> parts_of(const Oscillator<double>& law) {
  const Law present = law_of(law);
  std::vector<Pieces> parts;
  const bool spring = law.stiffness != 0 || present.shares(terms_of_position.without(law_with<Spring>));
  if (spring || present.has<Hysteresis>()) parts.push_back(spring_shape());
  if (present.shares(terms_of_velocity)) parts.push_back(damper_shape());
  if (present.has<Friction>()) parts.push_back(slider_shape());
  return parts;
}

/// "k = 0.05 N m" for each value of a link, below each other.
std::string values_of(const Oscillator<double>& law, bool angles) {
  std::string text;
  for_each_term([&]<class T>() {
    const CoefficientInfo& info = T::coefficients[0];
    const double value = law.*T::template members<double>[0];
    if (value == 0) return;
    const std::string unit = angles ? unit_of_powers({{"N", 1}, {"m", 1}, {"s", info.time}}) : unit_of(info);
    text += (text.empty() ? "{/:Italic " : "\n{/:Italic ") + std::string(info.symbol) +
            "} = " + format_quantity({value, 0}, unit);
  });
  return text;
}

}  // namespace

Panel network_drawing(const Network& network, const std::vector<double>& moved) {
  const std::size_t count = network.masses.size();
  const bool values = moved.empty();
  Panel panel;
  panel.bare = true;
  panel.names_inside = true;
  panel.x.low = 0;
  panel.x.high = whole_width;
  const double spacing = whole_width / static_cast<double>(count);
  const auto middle = [&](std::size_t i) { return (static_cast<double>(i) + 0.5) * spacing; };

  // Links over the heads of masses that stand between their ends, each at a height of its own.
  double top = values ? 75 : 45;
  const auto place = [&](std::size_t i) {
    return DrawnAt{middle(i) + (values ? 0 : farthest * spacing * moved[i]), 0};
  };
  Strokes ink(""), at_rest("grid"), floor("one-of-many");
  std::vector<std::array<double, 3>> labels;  // x, y and the link
  std::vector<int> grounded(count);
  bool on_ground = false;
  int arcs = 0;
  for (std::size_t l = 0; l < network.links.size(); ++l) {
    const auto& [from, to, law] = network.links[l];
    const std::vector<Pieces> parts = parts_of(law);
    DrawnAt a, b;
    if (from == ground || to == ground) {
      const std::size_t mass = from == ground ? to : from;
      on_ground = true;
      a = {middle(mass), ground_height};
      b = place(mass);
      b.y -= box_half_height;
      const double right_of = beside * 0.5 * static_cast<double>(parts.size()) + 4;
      labels.push_back({middle(mass) + right_of, -62 - 28.0 * grounded[mass]++, static_cast<double>(l)});
    } else {
      const std::size_t left = std::min(from, to), right = std::max(from, to);
      a = place(left);
      b = place(right);
      if (right - left == 1) {
        a.x += box_half_width;
        b.x -= box_half_width;
        labels.push_back({(a.x + b.x) / 2 - 40, over_links, static_cast<double>(l)});
      } else {
        const double height = (values ? arc_height : arc_height / 2) + arc_rise * arcs++;
        top = std::max(top, height + 34);
        for (DrawnAt* end : {&a, &b}) {
          ink.line({{end->x, box_half_height}, {end->x, height}});
          end->y = height;
        }
        labels.push_back({(a.x + b.x) / 2 - 40, height + 18, static_cast<double>(l)});
      }
    }
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const double side = beside * (static_cast<double>(p) - 0.5 * static_cast<double>(parts.size() - 1));
      const DrawnAt off = from == ground || to == ground ? DrawnAt{-side, 0} : DrawnAt{0, side};
      draw_part(ink, {a.x + off.x, a.y + off.y}, {b.x + off.x, b.y + off.y}, parts[p]);
    }
  }
  panel.y.low = on_ground ? ground_height - 15 : -45;
  panel.y.high = top;
  const auto write = [&](std::string text, double x, double y) {
    if (text.empty()) return;
    Note& note = panel.notes.emplace_back();
    note.text = std::move(text);
    note.leader = false;
    note.text_x = (x - panel.x.low) / (panel.x.high - panel.x.low);
    note.text_y = (y - panel.y.low) / (panel.y.high - panel.y.low);
  };

  if (on_ground) {
    const double left = 10, right = whole_width - 10;
    floor.line({{left, ground_height}, {right, ground_height}});
    constexpr double hatch = 14;
    for (double x = left + hatch; x <= right; x += hatch)
      floor.line({{x, ground_height}, {x - 8, ground_height - 9}});
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!values) at_rest.box(middle(i), 0);
    ink.box(place(i).x, 0);
    write(figure_text(network.masses[i].name), place(i).x - box_half_width + 6, values ? 8 : 0);
    if (values)
      write(format_quantity({network.masses[i].mass, 0}, network.angles ? "kg m²" : "kg"),
            middle(i) - box_half_width + 6, -8);
  }
  if (values)
    for (const auto& [x, y, link] : labels)
      write(values_of(network.links[static_cast<std::size_t>(link)].law, network.angles), x, y);
  for (Strokes* strokes : {&floor, &at_rest, &ink})
    if (Curve curve = strokes->take(); !curve.x.empty()) panel.curves.push_back(std::move(curve));
  return panel;
}

}  // namespace cromer::core
