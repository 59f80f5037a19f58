// Where the names of many curves stand, and what few points look like.
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/report/layout.h"
#include "cromer/report/palette.h"

namespace cromer::core {
namespace CROMER_FILE {

Figure of(std::vector<Panel> panels) {
  Figure figure;
  figure.panels = std::move(panels);
  return figure;
}

/// Nested curves with a common peak, as spectra of several damping ratios; names inside.
Panel nested(int count) {
  Panel panel;
  panel.names_inside = true;
  for (int k = 0; k < count; ++k) {
    Curve curve;
    for (int i = 0; i <= 200; ++i) {
      const double x = 0.05 * i;
      curve.x.push_back(x);
      curve.y.push_back((1 + 3 * std::exp(-(x - 4) * (x - 4)) * (1 + 0.4 * std::sin(9 * x))) / (1 + 0.5 * k) *
                        std::exp(-0.3 * std::max(0.0, x - 6)));
    }
    curve.role = family_role(static_cast<std::size_t>(k), static_cast<std::size_t>(count));
    curve.name = "member " + std::to_string(k);
    curve.label_x = 4.0;
    panel.curves.push_back(curve);
  }
  // Asked for in no order.
  for (int k = 0; k + 1 < count; k += 2)
    std::swap(panel.curves[static_cast<std::size_t>(k)], panel.curves[static_cast<std::size_t>(k) + 1]);
  return panel;
}

bool cross(const PlacedLine& a, const PlacedLine& b) {
  const auto side = [](Spot p, Spot q, Spot r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  return side(a.from, a.to, b.from) * side(a.from, a.to, b.to) < 0 &&
         side(b.from, b.to, a.from) * side(b.from, b.to, a.to) < 0;
}

TEST(FigureLayout, NoLeaderLinesCrossAndNoNameLiesOnACurve) {
  for (const int count : {1, 2, 3, 5, 6, 7, 8, 14}) {
    const Layout layout = lay_out(of({nested(count)}), Typeface::lato);
    const PlacedPanel& panel = layout.panels[0];
    EXPECT_FALSE(panel.crowded) << count;
    for (std::size_t i = 0; i < panel.leaders.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(cross(panel.leaders[i], panel.leaders[k])) << count;
    int names = 0;
    for (const PlacedText& text : panel.texts) {
      if (!text.text.starts_with("member")) continue;
      ++names;
      for (const PlacedCurve& curve : panel.curves)
        for (const auto& piece : curve.pieces)
          for (const Spot& p : piece) {
            const bool on =
                p.x > text.box.x && p.x < text.box.right() && p.y > text.box.y && p.y < text.box.bottom();
            EXPECT_FALSE(on) << count << " " << text.text;
          }
    }
    EXPECT_EQ(names, count);
  }
}

TEST(FigureLayout, MoreThanSixNamesStandInAListInTheOrderOfTheCurves) {
  for (const int count : {7, 8, 14}) {
    const PlacedPanel panel = lay_out(of({nested(count)}), Typeface::lato).panels[0];
    std::vector<std::string> names;
    double last = 0;
    for (const PlacedText& text : panel.texts) {
      if (!text.text.starts_with("member")) continue;
      EXPECT_GT(text.box.x, panel.frame.right());
      EXPECT_GT(text.at.y, last);
      last = text.at.y;
      names.push_back(text.text);
    }
    ASSERT_EQ(names.size(), static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k)
      EXPECT_EQ(names[static_cast<std::size_t>(k)], "member " + std::to_string(k));
    // A piece of each line stands beside its name, in its colour.
    ASSERT_EQ(panel.leaders.size(), names.size());
    EXPECT_EQ(panel.leaders.front().colour, style_of("family:0").line);
    EXPECT_EQ(panel.leaders.back().colour, style_of("family:4").line);
  }
}

TEST(FigureLayout, AListThatDoesNotFitNamesEvenlyChosenCurves) {
  const Layout layout = lay_out(of({nested(100)}), Typeface::lato);
  int names = 0, said = 0;
  for (const PlacedText& text : layout.panels[0].texts) {
    EXPECT_LE(text.box.bottom(), layout.height);
    names += text.text.starts_with("member");
    said += text.text.find("is named") != std::string::npos;
  }
  EXPECT_GE(names, 15);
  EXPECT_EQ(said, 1);
}

TEST(FigureLayout, APointAloneIsADotAndFewPointsHaveDotsOnTheirLine) {
  Panel panel;
  Curve one, two, many;
  one.x = {1}, one.y = {2};
  two.x = {1, 3}, two.y = {1, 2}, two.with_dots = true;
  many.x = {1, 2, 3, 4}, many.y = {1, std::nan(""), 1, 2};  // its first point stands alone
  panel.curves = {one, two, many};
  const auto curves = lay_out(of({panel}), Typeface::lato).panels[0].curves;
  EXPECT_EQ(curves[0].dots.size(), 1u);
  EXPECT_EQ(curves[1].dots.size(), 2u);
  EXPECT_EQ(curves[2].dots.size(), 1u);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
