// What is taken in a panel, and places that are free and belong to their curve without doubt.
#include "cromer/report/labels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cromer/report/enhanced_text.h"

namespace cromer::core {
namespace CROMER_FILE {

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
  // Bold by a factor: not too small, not far too large.
  for (const auto& [text, bold_dejavu, lato, bold_lato] :
       {std::tuple{"forward Euler", 7.68, 6.01, 6.09}, {"dashed: where the peak is", 14.91, 11.38, 11.52}}) {
    EXPECT_NEAR(text_width(text, 1, true, Typeface::dejavu_sans) / bold_dejavu, 1.0, 0.03);
    EXPECT_NEAR(text_width(text, 1, false, Typeface::lato), lato, 0.01);
    const double bold_ratio = text_width(text, 1, true, Typeface::lato) / bold_lato;
    EXPECT_TRUE(bold_ratio >= 1 && bold_ratio < 1.03) << bold_ratio;
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

const Box frame{10, 20, 400, 300};

std::vector<Spot> level(double y, double from = 10, double to = 410) {
  std::vector<Spot> spots;
  for (double x = from; x <= to; x += 2) spots.push_back({x, y});
  return spots;
}

TEST(Box, NearestIsInsideItOrAtItsEdge) {
  const Box box{10, 20, 30, 40};
  EXPECT_EQ(box.right(), 40);
  EXPECT_EQ(box.bottom(), 60);
  EXPECT_EQ(box.nearest({0, 0}), (Spot{10, 20}));
  EXPECT_EQ(box.nearest({50, 70}), (Spot{40, 60}));
  EXPECT_EQ(box.nearest({15, 30}), (Spot{15, 30}));
}

TEST(Occupancy, WhatIsDrawnIsTakenAndNothingElse) {
  Occupancy drawn(frame);
  EXPECT_EQ(drawn.taken(frame), 0);
  drawn.add_box({100, 100, 8, 4});
  EXPECT_EQ(drawn.taken({100, 100, 8, 4}), 15);  // five by three squares of 2 px
  EXPECT_EQ(drawn.taken(frame), 15);
  EXPECT_EQ(drawn.taken({90, 90, 7, 7}), 0);
  EXPECT_EQ(drawn.taken({110, 106, 7, 7}), 0);
  Occupancy corners(frame);
  for (const Spot& p : {Spot{10, 20}, {410, 20}, {10, 320}, {410, 320}}) {
    EXPECT_EQ(corners.taken({p.x, p.y, 0, 0}), 0);
    corners.add_box({p.x, p.y, 0, 0});
    EXPECT_EQ(corners.taken({p.x, p.y, 0, 0}), 1);
  }
  corners.add_box({0, 0, 9, 400});
  corners.add_box({0, 0, 500, 19});
  corners.add_box({420, 0, 50, 400});
  corners.add_box({0, 330, 500, 50});
  EXPECT_EQ(corners.taken({-50, -50, 600, 600}), 4);
}

TEST(Occupancy, LinesAreTakenAlongTheirLength) {
  Occupancy drawn(frame);
  drawn.add_line(std::vector<Spot>{{50, 60}, {150, 60}}, 1);
  EXPECT_EQ(drawn.taken(frame), 51);
  for (double x = 50; x <= 150; x += 10) EXPECT_EQ(drawn.taken({x, 60, 0, 0}), 1) << x;
  EXPECT_EQ(drawn.taken({48, 60, 0, 0}) + drawn.taken({152, 60, 0, 0}), 0);
  drawn.add_line(std::vector<Spot>{{50, 100}, {50, 200}}, 6);
  for (const double x : {46.9, 47.0, 50.0, 53.0})
    EXPECT_EQ(drawn.taken({x, 150, 0, 0}), x >= 46 ? 1 : 0) << x;
  EXPECT_EQ(drawn.taken({45, 150, 0, 0}) + drawn.taken({55, 150, 0, 0}), 0);
  EXPECT_EQ(drawn.taken({50, 97, 0, 0}), 1);
  EXPECT_EQ(drawn.taken({50, 203, 0, 0}), 1);
  Occupancy slanted(frame);
  slanted.add_line(std::vector<Spot>{{20, 30}, {120, 130}}, 2);
  EXPECT_EQ(slanted.taken({70, 80, 0, 0}), 1);
  EXPECT_EQ(slanted.taken(frame), 51);
  slanted.add_line(std::vector<Spot>{{1e9, 50}, {2e9, 60}}, 2);  // never in sight
  EXPECT_EQ(slanted.taken(frame), 51);
}

TEST(Occupancy, CountsWhatALineCrosses) {
  Occupancy drawn(frame);
  drawn.add_line(level(100), 1);
  EXPECT_GT(drawn.crossed({200, 50}, {200, 150}), 0);
  EXPECT_GT(drawn.crossed({200, 50}, {200, 100}), 0);
  EXPECT_EQ(drawn.crossed({200, 50}, {200, 97}), 0);
  EXPECT_EQ(drawn.crossed({200, 104}, {200, 150}), 0);
  EXPECT_GE(drawn.crossed({100, 100}, {200, 100}), 50);
  EXPECT_LE(drawn.crossed({100, 100}, {200, 100}), 52);  // one a square of 2 px, both ends
  EXPECT_GT(drawn.crossed({100, 50}, {300, 150}), 0);
}

TEST(FreePlace, StandsInsideTheFrameAndNearItsTarget) {
  const Occupancy drawn(frame);
  for (const Spot& target : {Spot{10, 20}, {410, 320}, {200, 150}, {410, 20}, {10, 320}}) {
    const FreePlace place = free_place(drawn, frame, 60, 20, std::vector<Spot>{target});
    EXPECT_GE(place.box.x, frame.x + 6);
    EXPECT_GE(place.box.y, frame.y + 2);
    EXPECT_LE(place.box.right(), frame.right() - 2);
    EXPECT_LE(place.box.bottom(), frame.bottom() - 2);
    EXPECT_EQ(place.box.width, 60);
    EXPECT_EQ(place.box.height, 20);
    EXPECT_EQ(place.target, target);
    EXPECT_EQ(place.covered, 0);
    const Spot edge = place.box.nearest(target);
    EXPECT_NEAR(place.distance, std::hypot(edge.x - target.x, edge.y - target.y), 1e-9);
    EXPECT_LT(place.distance, 9);
  }
  const FreePlace nearest = free_place(drawn, frame, 60, 20, std::vector<Spot>{{900, 900}, {300, 300}});
  EXPECT_EQ(nearest.target, (Spot{300, 300}));
  // One that exactly fills the frame has its place.
  EXPECT_EQ(free_place(drawn, frame, 392, 296, {}).box.x, 16);
  EXPECT_EQ(free_place(drawn, frame, 392, 296, {}).box.y, 22);
  EXPECT_EQ(free_place(drawn, frame, 393, 296, {}).box.x, 14);  // the corner
  EXPECT_EQ(free_place(drawn, frame, 392, 297, {}).box.y, 24);
}

TEST(FreePlace, KeepsClearOfWhatIsDrawnAndCrossesNothing) {
  Occupancy drawn(frame);
  drawn.add_line(level(150), 1);
  const FreePlace place = free_place(drawn, frame, 60, 20, std::vector<Spot>{{200, 150}});
  EXPECT_EQ(place.covered, 0);
  EXPECT_TRUE(place.box.bottom() <= 146 || place.box.y >= 154) << place.box.y;
  EXPECT_LT(place.distance, 10);
  // A wall between the target and the nearest room: the way round it is dearer than its length.
  Occupancy wall(frame);
  wall.add_box({10, 100, 190, 60});
  wall.add_box({100, 170, 100, 6});
  const FreePlace behind = free_place(wall, frame, 60, 20, std::vector<Spot>{{150, 180}});
  EXPECT_GT(behind.box.y, 176);
}

Drawn two_curves(double mine, double other) {
  Drawn drawn{Occupancy(frame), Occupancy(frame), {level(mine), level(other)}};
  for (const auto& curve : drawn.curves) drawn.all.add_line(curve, 1), drawn.inked.add_line(curve, 1);
  return drawn;
}

double gap(const Box& box, double y) {
  return y < box.y ? box.y - y : y > box.bottom() ? y - box.bottom() : 0;
}

TEST(ClearPlace, IsNearerToItsOwnCurveThanToAnother) {
  for (const double other : {40.0, 100.0, 125.0, 175.0, 200.0, 300.0}) {
    const Drawn drawn = two_curves(150, other);
    const std::vector<Spot> own = level(150);
    const ClearPlace found = clear_place(drawn, frame, 60, 20, 0, own, own);
    EXPECT_TRUE(found.clear) << other;
    EXPECT_EQ(found.place.covered, 0) << other;
    EXPECT_GE(gap(found.place.box, other), gap(found.place.box, 150) + 4) << other;
    EXPECT_LE(gap(found.place.box, 150), 14) << other;
  }
}

TEST(ClearPlace, StandsWhereTheCurveIsAlone) {
  // Both lie together in the right half; only at the left is the curve alone.
  std::vector<Spot> own = level(150), other = level(153, 210, 410);
  Drawn drawn{Occupancy(frame), Occupancy(frame), {own, other}};
  for (const auto& curve : drawn.curves) drawn.all.add_line(curve, 1), drawn.inked.add_line(curve, 1);
  const std::vector<Spot> wanted{{360, 150}};
  const ClearPlace found = clear_place(drawn, frame, 60, 20, 0, wanted, own);
  EXPECT_TRUE(found.clear);
  EXPECT_LT(found.place.target.x, 210);
  // Nowhere alone: the least bad one, and it says so.
  const Drawn together = two_curves(150, 153);
  EXPECT_FALSE(clear_place(together, frame, 60, 20, 0, wanted, own).clear);
}

TEST(ClearPlace, CoversLinesToReadByOnlyWhereNothingElseIsLeft) {
  std::vector<Spot> own = level(150);
  Drawn drawn{Occupancy(frame), Occupancy(frame), {own, {}}};
  drawn.all.add_line(own, 1), drawn.inked.add_line(own, 1);
  for (double y = 24; y < 320; y += 8) drawn.all.add_line(level(y), 1);
  const ClearPlace found = clear_place(drawn, frame, 60, 20, 0, own, own);
  EXPECT_TRUE(found.clear);
  EXPECT_EQ(drawn.inked.taken(found.place.box), 0);
  EXPECT_LE(gap(found.place.box, 150), 14);
  Drawn open = drawn;
  open.all = open.inked;
  for (double y = 24; y < 150; y += 8) open.all.add_line(level(y), 1);
  EXPECT_GT(clear_place(open, frame, 60, 20, 0, own, own).place.box.y, 150);
}

TEST(ClearPlace, ALeaderLineIsShortAndCrossesNothing) {
  // Room begins `below` px under the point; a shaft leads there, or a wall is in between.
  const std::vector<Spot> own{{200, 30}};
  const auto found = [&](double below, bool wall) {
    Drawn drawn{Occupancy(frame), Occupancy(frame), {own, {}}};
    for (Occupancy* each : {&drawn.all, &drawn.inked}) {
      each->add_box({10, 20, 182, 10 + below - 4});
      each->add_box({208, 20, 202, 10 + below - 4});
      if (wall) each->add_box({190, 60, 20, 4});
    }
    return clear_place(drawn, frame, 150, 20, 0, own, own);
  };
  for (const double below : {30.0, 60.0, 82.0}) {
    EXPECT_TRUE(found(below, false).clear) << below;
    EXPECT_FALSE(found(below + 30, true).clear) << below;
  }
  EXPECT_GT(found(82, false).place.distance, 80);
  EXPECT_FALSE(found(96, false).clear);  // more than 90 px
}

/// In a frame with one place only, from (6, 2) to (66, 22).
class OnlyPlace : public testing::Test {
 protected:
  ClearPlace found(const std::vector<Spot>& own, const std::vector<Spot>& other,
                   const std::vector<Spot>& wanted, const std::vector<Spot>& anywhere) const {
    const Drawn drawn{all_, inked_, {own, other}};
    return clear_place(drawn, narrow_, 60, 20, 0, wanted, anywhere);
  }
  bool clear(const std::vector<Spot>& own, const std::vector<Spot>& other) const {
    return found(own, other, own, own).clear;
  }
  Box narrow_{0, 0, 68, 24};
  Occupancy all_{narrow_}, inked_{narrow_};
};

TEST_F(OnlyPlace, IsClearWhereTheOwnCurveIsNearerByFourPx) {
  const std::vector<Spot> own{{0, 32}, {60, 32}};  // 10 px below
  EXPECT_TRUE(clear(own, {{0, -12}, {60, -12}}));
  EXPECT_FALSE(clear(own, {{0, -11.9}, {60, -11.9}}));
  EXPECT_TRUE(clear(own, {{0, -12}, {30, NAN}, {60, -11}}) == false);  // each point counts
  EXPECT_FALSE(clear(own, {{-60, 80}, {120, -100}}));                  // and what lies between two
  EXPECT_TRUE(clear(own, {}));
}

TEST_F(OnlyPlace, FromFourteenPxOnALeaderLineSaysWhichCurveIsMeant) {
  const std::vector<Spot> near{{30, -2}, {40, -2}};  // closer than the own curve
  EXPECT_FALSE(clear({{36, 35.9}}, near));
  EXPECT_TRUE(clear({{36, 36}}, near));
  EXPECT_TRUE(clear({{36, 112}}, near));  // 90 px
  EXPECT_FALSE(clear({{36, 112.1}}, near));
  EXPECT_TRUE(clear({{80, 12}}, near));
  inked_.add_box({66, 12, 0, 0});
  EXPECT_FALSE(clear({{96, 12}}, near));
}

TEST_F(OnlyPlace, IsNotClearWithinTwoPxOfInk) {
  const std::vector<Spot> own{{36, 34}};
  for (const auto& [x, y, free] : {std::tuple{2.0, 12.0, true},
                                   {4.0, 12.0, false},
                                   {69.0, 12.0, false},
                                   {70.0, 12.0, true},
                                   {36.0, 0.0, false},
                                   {36.0, 24.0, false},
                                   {36.0, 26.0, true}}) {
    inked_ = Occupancy(narrow_);
    inked_.add_box({x, y, 0, 0});
    EXPECT_EQ(clear(own, {}), free) << x << ' ' << y;
  }
  inked_ = Occupancy(narrow_);
  // What it would rather not cover reaches 4 px further on every side.
  for (const auto& [x, y, covered] : {std::tuple{0.0, 12.0, 0},
                                      {2.0, 12.0, 1},
                                      {36.0, 12.0, 1},
                                      {70.0, 12.0, 1},
                                      {72.0, 12.0, 0},
                                      {36.0, 26.0, 1},
                                      {36.0, 28.0, 0},
                                      {36.0, 0.0, 1}}) {
    Occupancy drawn(Box{0, 0, 200, 100});
    drawn.add_box({x, y, 0, 0});
    EXPECT_EQ(free_place(drawn, narrow_, 60, 20, own).covered, covered) << x << ' ' << y;
  }
}

TEST_F(OnlyPlace, LooksAgainWhereNoOtherCurveIsWithinEightPx) {
  const std::vector<Spot> far{{36, 150}}, point{{36, 72}};
  EXPECT_FALSE(found(far, {}, far, far).clear);
  EXPECT_TRUE(found(far, {{44, 72}}, far, point).clear);
  EXPECT_EQ(found(far, {{44, 72}}, far, point).place.target, point[0]);
  EXPECT_FALSE(found(far, {{43.9, 72}}, far, point).clear);
  EXPECT_EQ(found(far, {{43.9, 72}}, far, point).place.target, far[0]);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
