#include "cromer/figures/network_drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cromer::core {
namespace {

struct Point {
  double x, y;
};
using Line = std::vector<Point>;

std::vector<Line> lines_of(const Curve& curve) {
  std::vector<Line> lines(1);
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (std::isnan(curve.x[i]))
      lines.emplace_back();
    else
      lines.back().push_back({curve.x[i], curve.y[i]});
  lines.pop_back();
  return lines;
}

// A spring is one line, a damper four, and the mass is drawn after the links.
TEST(NetworkDrawing, PartsOfASlantingLinkKeepTheirDistance) {
  Network network;
  network.masses = {{.name = "cart"}};
  network.links = {{ground, 0, {.stiffness = 9, .damping = 0.1}}};
  double upright = 0;
  for (const std::vector<double>& moved : {std::vector<double>{}, {1}, {-0.4}}) {
    const Panel panel = network_drawing(network, moved);
    const std::vector<Line> lines = lines_of(panel.curves.back());
    ASSERT_EQ(lines.size(), 1u + 4u + 1u);
    const Point from = lines[0].front(), to = lines[0].back(), other = lines[1].front();
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const double distance =
        std::abs((to.x - from.x) * (other.y - from.y) - (to.y - from.y) * (other.x - from.x)) / length;
    if (moved.empty()) upright = distance;
    EXPECT_GT(distance, 0);
    EXPECT_NEAR(distance, upright, 1e-9);
    for (const Point& end : {to, lines[4].back()}) {
      EXPECT_GT(end.x, lines[5][0].x);
      EXPECT_LT(end.x, lines[5][1].x);
    }
  }
}

}  // namespace
}  // namespace cromer::core
