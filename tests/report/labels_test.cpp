#include "cromer/report/labels.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "cromer/report/text_width.h"

namespace cromer::core {
namespace {

TEST(Spread, LeavesWhatHasRoom) {
  const std::vector<double> centres{10, 50, 90}, heights{14, 14, 14}, gaps{0, 0, 0};
  EXPECT_EQ(spread(centres, heights, gaps, 0, 100), centres);
}

TEST(Spread, MovesApartByLeastSquares) {
  const auto placed =
      spread(std::vector<double>{50, 50}, std::vector<double>{14, 14}, std::vector<double>{0, 0}, 0, 100);
  EXPECT_NEAR(placed[0], 43, 1e-9);
  EXPECT_NEAR(placed[1], 57, 1e-9);
}

TEST(Spread, NothingOverlapsAndOrderStays) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 400), height(12, 32);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> centres(8), heights(8), gaps(8, 2);
    for (std::size_t i = 0; i < 8; ++i) centres[i] = place(random), heights[i] = height(random);
    const auto placed = spread(centres, heights, gaps, 0, 400);
    for (std::size_t i = 0; i < 8; ++i) {
      ASSERT_GE(placed[i] - heights[i] / 2, -1e-9);
      ASSERT_LE(placed[i] + heights[i] / 2, 400 + 1e-9);
      for (std::size_t j = 0; j < 8; ++j) {
        if (i == j) continue;
        ASSERT_GE(std::abs(placed[i] - placed[j]), (heights[i] + heights[j]) / 2 - 1e-9);
        if (centres[i] < centres[j]) {
          ASSERT_LT(placed[i], placed[j]);
        }
      }
    }
  }
}

TEST(FreePlace, FindsTheOnlyGap) {
  const Box frame{0, 0, 400, 300};
  Occupancy drawn(frame);
  drawn.add_box({0, 0, 400, 180});
  drawn.add_box({0, 260, 400, 40});
  const std::vector<Spot> targets{{200, 100}};
  const FreePlace place = free_place(drawn, frame, 80, 30, targets);
  EXPECT_EQ(place.covered, 0);
  EXPECT_GE(place.box.y, 180);
  EXPECT_LE(place.box.bottom(), 260);
  EXPECT_EQ(place.target, targets[0]);
}

TEST(FreePlace, SaysWhatItCoversWhereThereIsNoRoom) {
  const Box frame{0, 0, 100, 100};
  Occupancy drawn(frame);
  drawn.add_box(frame);
  EXPECT_GT(free_place(drawn, frame, 50, 20, {}).covered, 0);
  const FreePlace wide = free_place(drawn, frame, 500, 20, {});
  EXPECT_EQ(wide.box.width, 500);
}

TEST(TextWidth, IsTheFontsOwn) {
  // DejaVu Sans, from the font's own advance widths.
  EXPECT_NEAR(text_width("forward Euler", 1, false, Typeface::dejavu_sans), 6.74, 0.01);
  EXPECT_NEAR(text_width("Reynolds number Re", 1, false, Typeface::dejavu_sans), 10.43, 0.01);
  // Bold and Lato by a factor: not too small, not far too large.
  for (const auto& [text, bold_dejavu, lato, bold_lato] :
       {std::tuple{"forward Euler", 7.68, 6.01, 6.09}, {"dashed: where the peak is", 14.91, 11.38, 11.52}}) {
    EXPECT_NEAR(text_width(text, 1, true, Typeface::dejavu_sans) / bold_dejavu, 1.0, 0.03);
    const double lato_ratio = text_width(text, 1, false, Typeface::lato) / lato,
                 bold_ratio = text_width(text, 1, true, Typeface::lato) / bold_lato;
    EXPECT_TRUE(lato_ratio >= 1 && lato_ratio < 1.08) << lato_ratio;
    EXPECT_TRUE(bold_ratio >= 1 && bold_ratio < 1.08) << bold_ratio;
  }
}

TEST(TextWidth, MarkupTakesNoRoom) {
  const double plain = text_width("time t (s)", 12, false, Typeface::dejavu_sans);
  EXPECT_DOUBLE_EQ(text_width("time {/:Italic t} (s)", 12, false, Typeface::dejavu_sans), plain);
  EXPECT_LT(text_width("x_{00}", 12, false, Typeface::dejavu_sans),
            text_width("x00", 12, false, Typeface::dejavu_sans));
}

TEST(TextWidth, WrapsAtSpacesOutsideBraces) {
  const auto lines = wrapped("one {/:Italic two} three\nfour", 10, false, Typeface::dejavu_sans, 60);
  EXPECT_EQ(lines, (std::vector<std::string>{"one {/:Italic two}", "three", "four"}));
}

TEST(Spread, WeighsAllMembersOfAGroupAlike) {
  const std::vector<double> heights{20, 20, 10}, gaps{0, 0, 0};
  const auto placed = spread(std::vector<double>{50, 50, 65}, heights, gaps, 0, 200);
  EXPECT_NEAR(placed[0], 110.0 / 3, 1e-9);
  EXPECT_NEAR(placed[1], 170.0 / 3, 1e-9);
  EXPECT_NEAR(placed[2], 215.0 / 3, 1e-9);
}

TEST(Spread, LeavesTheGapsAndStaysWithinItsEnds) {
  const std::vector<double> heights{10, 10}, gaps{4, 4};
  using Places = std::vector<double>;
  EXPECT_EQ(spread(Places{5, 6}, heights, gaps, 0, 100), (Places{5, 19}));
  EXPECT_EQ(spread(Places{95, 96}, heights, gaps, 0, 100), (Places{77, 91}));
  EXPECT_EQ(spread(Places{50, 64}, heights, gaps, 0, 100), (Places{50, 64}));
  EXPECT_EQ(spread(Places{50, 63}, heights, gaps, 0, 100), (Places{49.5, 63.5}));
  EXPECT_EQ(spread(Places{63, 50}, heights, gaps, 0, 100), (Places{63.5, 49.5}));
  EXPECT_EQ(spread(Places{50, 50}, heights, gaps, 40, 50),
            (Places{45, 59}));  // too little room: from the top
  EXPECT_TRUE(spread({}, {}, {}, 0, 100).empty());
}

}  // namespace
}  // namespace cromer::core
