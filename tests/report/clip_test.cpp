// Lines, dots and bands end where the frame does.
#include "cromer/report/clip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace cromer::core {
namespace {

using Pieces = std::vector<std::vector<Spot>>;

constexpr Box frame{10, 20, 100, 50};

void expect_near(const Pieces& pieces, const Pieces& expected) {
  ASSERT_EQ(pieces.size(), expected.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    ASSERT_EQ(pieces[i].size(), expected[i].size()) << i;
    for (std::size_t k = 0; k < pieces[i].size(); ++k) {
      EXPECT_NEAR(pieces[i][k].x, expected[i][k].x, 0.03) << i << " " << k;
      EXPECT_NEAR(pieces[i][k].y, expected[i][k].y, 0.03) << i << " " << k;
    }
  }
}

TEST(Clip, WhatLiesInsideStaysToTheBit) {
  std::vector<Spot> line{{10, 20}, {110, 70}};
  for (int i = 0; i < 100; ++i)
    line.push_back({60 + 49.9 * std::cos(0.7 * i), 45 + 24.9 * std::sin(0.3 * i)});
  EXPECT_EQ(pieces_inside(line, frame), Pieces{line});
}

TEST(Clip, ALineIsCutAtEachEdge) {
  expect_near(pieces_inside({{0, 30}, {20, 30}}, frame), {{{10, 30}, {20, 30}}});
  expect_near(pieces_inside({{100, 30}, {120, 40}}, frame), {{{100, 30}, {110, 35}}});
  expect_near(pieces_inside({{50, 0}, {50, 40}}, frame), {{{50, 20}, {50, 40}}});
  expect_near(pieces_inside({{50, 60}, {50, 3000}}, frame), {{{50, 60}, {50, 70}}});
}

TEST(Clip, ALineThatCrossesTheFrameBetweenTwoSpotsIsSeen) {
  expect_near(pieces_inside({{0, 45}, {120, 45}}, frame), {{{10, 45}, {110, 45}}});
  expect_near(pieces_inside({{0, 10}, {120, 70}}, frame), {{{20, 20}, {110, 65}}});
}

TEST(Clip, ALineThatComesBackHasTwoPieces) {
  expect_near(pieces_inside({{20, 60}, {30, 80}, {40, 60}, {50, 60}}, frame),
              {{{20, 60}, {25, 70}}, {{35, 70}, {40, 60}, {50, 60}}});
}

TEST(Clip, NothingIsLeftOfWhatPassesBeside) {
  EXPECT_EQ(pieces_inside({{0, 28}, {20, 10}}, frame), Pieces{});  // round a corner
  EXPECT_EQ(pieces_inside({{0, 80}, {120, 80}}, frame), Pieces{});
  EXPECT_EQ(pieces_inside({{0, 19.98}, {120, 19.98}}, frame), Pieces{});
  EXPECT_EQ(pieces_inside({{50, 50}}, frame), Pieces{});
  EXPECT_EQ(pieces_inside(std::vector<Spot>{}, frame), Pieces{});
}

TEST(Clip, ALineAlongTheEdgeIsSeenInSpiteOfRounding) {
  expect_near(pieces_inside({{10, 70 + 1e-9}, {110, 70 + 1e-9}}, frame), {{{10, 70}, {110, 70}}});
  EXPECT_TRUE(inside({10 - 1e-9, 70 + 1e-9}, frame));
  EXPECT_TRUE(inside({110, 20}, frame));
}

TEST(Clip, DotsBeyondAnyEdgeAreOutside) {
  for (const Spot p : {Spot{9.9, 40}, {110.1, 40}, {50, 19.9}, {50, 70.1}, {NAN, 40}})
    EXPECT_FALSE(inside(p, frame)) << p.x << " " << p.y;
}

TEST(Clip, ABandIsHeldAtTheUpperAndLowerEdge) {
  const Band band =
      band_inside(Band{{0, 20, NAN, 30, 120}, {90, 65, NAN, 80, 60}, {10, 30, NAN, 15, 30}}, frame);
  ASSERT_EQ(band.x.size(), 3u);
  EXPECT_EQ(band.x[0], 20);
  EXPECT_TRUE(std::isnan(band.x[1]));
  EXPECT_EQ(band.x[2], 30);
  EXPECT_EQ(band.low[0], 65);
  EXPECT_EQ(band.high[0], 30);
  EXPECT_EQ(band.low[2], 70);
  EXPECT_EQ(band.high[2], 20);
}

}  // namespace
}  // namespace cromer::core
