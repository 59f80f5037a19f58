#include "cromer/figures/network_drawing.h"

#include <fmt/format.h>

#include <algorithm>
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

/// Masses in a row, links between them, over their heads and to the ground below; with values, or with the
/// masses out of their places.
class NetworkPicture {
 public:
  NetworkPicture(const Network& network, const std::vector<double>& moved)
      : network_(network),
        moved_(moved),
        spacing_(whole_width / static_cast<double>(network.masses.size())),
        top_(moved.empty() ? 75 : 45),
        grounded_(network.masses.size()) {
    for (const NetworkLink& link : network.links) draw_link(link);
    panel_.bare = true;
    panel_.names_inside = true;
    panel_.x.low = 0;
    panel_.x.high = whole_width;
    panel_.y.low = on_ground_ ? ground_height - 15 : -45;
    panel_.y.high = top_;
    if (on_ground_) draw_ground();
    for (std::size_t i = 0; i < network.masses.size(); ++i) draw_mass(i);
    for (const auto& [at, text] : labels_) write(text, at);
  }

  Panel take() {
    for (Strokes* strokes : {&floor_, &at_rest_, &ink_})
      if (Curve curve = strokes->take(); !curve.x.empty()) panel_.curves.push_back(std::move(curve));
    return std::move(panel_);
  }

 private:
  struct Label {
    DrawnAt at;
    std::string text;
  };
  struct Ends {
    DrawnAt a, b;
  };

  bool has_values() const { return moved_.empty(); }
  double middle(std::size_t i) const { return (static_cast<double>(i) + 0.5) * spacing_; }
  DrawnAt place(std::size_t i) const {
    return {middle(i) + (has_values() ? 0 : farthest * spacing_ * moved_[i]), 0};
  }
  void label(const DrawnAt& at, const NetworkLink& link) {
    if (has_values()) labels_.push_back({at, values_of(link.law, network_.angles)});
  }

  void draw_link(const NetworkLink& link) {
    const std::vector<Pieces> parts = parts_of(link.law);
    const bool upright = link.from == ground || link.to == ground;
    const auto [a, b] = upright ? to_ground(link, parts.size()) : between_masses(link);
    const double slant = upright ? std::hypot(b.x - a.x, b.y - a.y) / (b.y - a.y) : 1;
    constexpr double farthest_off = box_half_width - cup;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const double side = beside * (static_cast<double>(p) - 0.5 * static_cast<double>(parts.size() - 1));
      const DrawnAt off =
          upright ? DrawnAt{std::clamp(-side * slant, -farthest_off, farthest_off), 0} : DrawnAt{0, side};
      draw_part(ink_, {a.x + off.x, a.y + off.y}, {b.x + off.x, b.y + off.y}, parts[p]);
    }
  }
  Ends to_ground(const NetworkLink& link, std::size_t parts) {
    const std::size_t mass = link.from == ground ? link.to : link.from;
    on_ground_ = true;
    const double right_of = beside * 0.5 * static_cast<double>(parts) + 4;
    label({middle(mass) + right_of, -62 - 28.0 * grounded_[mass]++}, link);
    return {{middle(mass), ground_height}, {place(mass).x, -box_half_height}};
  }
  Ends between_masses(const NetworkLink& link) {
    const std::size_t left = std::min(link.from, link.to), right = std::max(link.from, link.to);
    DrawnAt a = place(left), b = place(right);
    if (right - left == 1) {
      a.x += box_half_width;
      b.x -= box_half_width;
      label({(a.x + b.x) / 2 - 40, over_links}, link);
      return {a, b};
    }
    // Over the heads of masses that stand between its ends, at a height of its own.
    const double height = (has_values() ? arc_height : arc_height / 2) + arc_rise * arcs_++;
    top_ = std::max(top_, height + 34);
    for (DrawnAt* end : {&a, &b}) {
      ink_.line({{end->x, box_half_height}, {end->x, height}});
      end->y = height;
    }
    label({(a.x + b.x) / 2 - 40, height + 18}, link);
    return {a, b};
  }

  void draw_ground() {
    constexpr double left = 10, right = whole_width - 10, hatch = 14;
    floor_.line({{left, ground_height}, {right, ground_height}});
    for (double x = left + hatch; x <= right; x += hatch)
      floor_.line({{x, ground_height}, {x - 8, ground_height - 9}});
  }

  void draw_mass(std::size_t i) {
    const NetworkMass& mass = network_.masses[i];
    if (!has_values()) at_rest_.box(middle(i), 0);
    ink_.box(place(i).x, 0);
    const double left = place(i).x - box_half_width + 6;
    write(figure_text(mass.name), {left, has_values() ? 8.0 : 0.0});
    if (has_values()) write(format_quantity({mass.mass, 0}, network_.angles ? "kg m²" : "kg"), {left, -8});
  }

  void write(std::string text, const DrawnAt& at) {
    if (text.empty()) return;
    Note& note = panel_.notes.emplace_back();
    note.text = std::move(text);
    note.leader = false;
    note.text_x = (at.x - panel_.x.low) / (panel_.x.high - panel_.x.low);
    note.text_y = (at.y - panel_.y.low) / (panel_.y.high - panel_.y.low);
  }

  const Network& network_;
  const std::vector<double>& moved_;  ///< in [-1, 1], of each mass; empty where values are shown
  double spacing_;
  double top_;
  Panel panel_;
  Strokes ink_{""}, at_rest_{"grid"}, floor_{"one-of-many"};
  std::vector<Label> labels_;
  std::vector<int> grounded_;  ///< links of each mass to the ground so far
  bool on_ground_ = false;
  int arcs_ = 0;
};

}  // namespace

Panel network_drawing(const Network& network, const std::vector<double>& moved) {
  return NetworkPicture(network, moved).take();
}

}  // namespace cromer::core
