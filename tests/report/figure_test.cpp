#include "cromer/report/figure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/report/layout.h"
#include "tests/report/example_figures.h"
#include "tests/report/overlap.h"

namespace cromer::core {
namespace CROMER_FILE {

std::vector<PlacedText> texts_of(const Layout& layout) {
  std::vector<PlacedText> texts;
  for (const PlacedPanel& panel : layout.panels)
    texts.insert(texts.end(), panel.texts.begin(), panel.texts.end());
  return texts;
}

TEST(FigureLayout, NoTwoWordsOverlapAndNoneIsClipped) {
  for (const Typeface typeface : {Typeface::lato, Typeface::dejavu_sans}) {
    for (const Figure& figure : examples()) {
      const Layout layout = lay_out(figure, typeface);
      const auto texts = texts_of(layout);
      for (std::size_t i = 0; i < texts.size(); ++i) {
        const Box& a = texts[i].box;
        EXPECT_GE(a.x, -0.5) << texts[i].text;
        EXPECT_LE(a.right(), layout.width + 0.5) << texts[i].text;
        EXPECT_GE(a.y, -0.5) << texts[i].text;
        EXPECT_LE(a.bottom(), layout.height + 0.5) << texts[i].text;
        for (std::size_t j = 0; j < i; ++j) {
          Box b = texts[j].box;  // lines of one block touch
          b.y += 0.5, b.height -= 1;
          EXPECT_FALSE(overlap(a, b)) << texts[i].text << " / " << texts[j].text;
        }
      }
    }
  }
}

TEST(FigureLayout, NamesAtTheRightStandInTheOrderOfTheCurves) {
  const auto texts = texts_of(lay_out(of({three_methods()}), Typeface::lato));
  const auto height = [&](const std::string& word) {
    for (const PlacedText& text : texts) {
      if (text.text == word) return text.at.y;
    }
    ADD_FAILURE() << word;
    return 0.0;
  };
  EXPECT_LT(height("forward Euler"), height("exact"));
  EXPECT_LT(height("exact"), height("Euler-Cromer"));
  EXPECT_LT(height("Euler-Cromer"), height("implicit Euler"));
  EXPECT_GE(height("Euler-Cromer") - height("exact"), 14);
}

TEST(FigureLayout, TheExactRoadLiesLowest) {
  const Layout layout = lay_out(of({three_methods()}), Typeface::lato);
  EXPECT_EQ(layout.panels[0].curves[0].colour, "#8A93A0");
  EXPECT_DOUBLE_EQ(layout.panels[0].curves[0].width, 4.5);
  EXPECT_NEAR(layout.panels[0].curves[1].width, 1.3, 1e-12);
}

TEST(FigureLayout, APhasePortraitIsSquare) {
  const Box frame = lay_out(of({phase_portrait()}, FigureSize::phase), Typeface::lato).panels[0].frame;
  EXPECT_DOUBLE_EQ(frame.width, frame.height);
}

TEST(FigureLayout, DenseDotsBecomeABandAndFewStayDots) {
  EXPECT_EQ(lay_out(of({dense(Mark::dots)}), Typeface::lato).panels[0].curves[0].mark, Mark::band);
  Panel few = dense(Mark::dots);
  few.curves[0].x.resize(300);
  few.curves[0].y.resize(300);
  EXPECT_EQ(lay_out(of({few}), Typeface::lato).panels[0].curves[0].mark, Mark::dots);
  few.curves[0].mark = Mark::band;
  EXPECT_EQ(lay_out(of({few}), Typeface::lato).panels[0].curves[0].mark, Mark::line);
}

TEST(FigureLayout, CrossesStayInTheFrameAndSetNoAxis) {
  Panel panel = three_methods();
  const PlacedPanel without = lay_out(of({panel}), Typeface::lato).panels[0];
  Curve aside;
  aside.role = "set-aside";
  aside.x = {1, 2, 3};
  aside.y = {50, 0, -1e6};
  aside.mark = Mark::crosses;
  aside.sets_axes = false;
  panel.curves.push_back(aside);
  const PlacedPanel placed = lay_out(of({panel}), Typeface::lato).panels[0];
  ASSERT_EQ(placed.y_ticks.size(), without.y_ticks.size());
  const PlacedCurve& crosses = placed.curves.back();
  ASSERT_EQ(crosses.pieces.size(), 6u);  // two strokes each
  for (const auto& stroke : crosses.pieces)
    for (const Spot& p : stroke) {
      EXPECT_GT(p.y, placed.frame.y);
      EXPECT_LT(p.y, placed.frame.bottom());
    }
}

TEST(FigureLayout, ABandIsBrokenWhereNothingWasMeasured) {
  Panel panel = dense(Mark::dots);
  Curve& curve = panel.curves[0];
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (curve.x[i] > 40 && curve.x[i] < 60) curve.y[i] = std::nan("");
  const PlacedPanel placed = lay_out(of({panel}), Typeface::lato).panels[0];
  const Band& band = placed.curves[0].band;
  ASSERT_EQ(placed.curves[0].mark, Mark::band);
  EXPECT_EQ(std::count_if(band.x.begin(), band.x.end(), [](double x) { return std::isnan(x); }), 1);
  const double from = placed.frame.x + placed.frame.width * 41 / 120,
               to = placed.frame.x + placed.frame.width * 59 / 120;
  for (const double x : band.x) EXPECT_FALSE(x > from && x < to) << x;
}

TEST(FigureLayout, LettersGoOnAfterZAndTheNoteStandsBelow) {
  Figure figure = of(std::vector<Panel>(28, three_methods()));
  figure.columns = 4;
  const double height = lay_out(figure, Typeface::lato).height;
  figure.note = "The first 28 of 40";
  const Layout layout = lay_out(figure, Typeface::lato);
  EXPECT_GT(layout.height, height);
  std::vector<std::string> words;
  for (const PlacedText& text : texts_of(layout)) words.push_back(text.text);
  EXPECT_THAT(words, testing::IsSupersetOf({"a", "z", "aa", "ab", "The first 28 of 40"}));
  EXPECT_GT(layout.panels.back().texts.back().at.y, height);
}

TEST(FigureLayout, TicksAreFewAndTheAxisReachesTheLast) {
  for (const Figure& figure : examples()) {
    for (const PlacedPanel& panel : lay_out(figure, Typeface::dejavu_sans).panels) {
      EXPECT_LE(std::count_if(panel.y_ticks.begin(), panel.y_ticks.end(),
                              [](const PlacedTick& t) { return !t.minor; }),
                6);
      EXPECT_GE(panel.x_ticks.size(), 2u);
    }
  }
  const PlacedPanel panel = lay_out(of({dense(Mark::band)}), Typeface::lato).panels[0];
  EXPECT_NEAR(panel.x_ticks.back().at, panel.frame.right(), 1e-6);  // 120 s
}

TEST(FigureLayout, AStepBeyondTheAxisLeavesItWithoutTicks) {
  Figure figure = of({three_methods()});
  figure.panels[0].y.low = 0.01;
  figure.panels[0].y.high = 3;
  figure.panels[0].y.step = 99;
  EXPECT_TRUE(lay_out(figure, Typeface::lato).panels[0].y_ticks.empty());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
