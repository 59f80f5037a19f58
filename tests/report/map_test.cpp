// Colours of maps: even steps, or even ratios where the values span decades.
#include <gtest/gtest.h>

#include "cromer/report/place_map.h"

namespace cromer {
namespace {

HeatMap map_of(std::vector<double> z, bool decades) {
  return {.x = {0, 1}, .y = {0, 1}, .z = std::move(z), .name = "amplitude (m)", .decades = decades};
}

TEST(MapScale, ValuesOverDecadesGetEvenRatios) {
  const MapScale scale = map_scale(map_of({2e-3, 1, 30, 0.1}, true));
  EXPECT_TRUE(scale.range.logarithmic);
  EXPECT_DOUBLE_EQ(scale.share(2e-3), 0);
  EXPECT_DOUBLE_EQ(scale.share(30), 1);
  EXPECT_NEAR(scale.share(0.1) - scale.share(0.01), scale.share(10) - scale.share(1), 1e-15);
  // Powers of ten alone have labels.
  std::vector<std::string> labels;
  for (const Tick& tick : scale.ticks)
    if (!tick.label.empty()) labels.push_back(tick.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"10^{\u22122}", "10^{\u22121}", "10^{0}", "10^{1}"}));
  EXPECT_GT(scale.ticks.size(), labels.size());
}

TEST(MapScale, OthersGetEvenSteps) {
  for (const HeatMap& map : {map_of({2e-3, 1, 30, 0.1}, false), map_of({0, 1, 30, 0.1}, true),
                             map_of({-1, 1, 30, 0.1}, true), map_of({0.31, 1, 30, 2}, true)}) {
    const MapScale scale = map_scale(map);
    EXPECT_FALSE(scale.range.logarithmic);
    for (const Tick& tick : scale.ticks) EXPECT_NE(tick.label, "");
    EXPECT_DOUBLE_EQ(scale.share((scale.range.low + scale.range.high) / 2), 0.5);
  }
}

TEST(MapScale, ReachesToWhatIsBesideIt) {
  HeatMap map = map_of({1, 2, 3, 4}, true);
  map.reach = {0.01, 8};
  EXPECT_EQ(map_scale(map).range.low, 0.01);
  EXPECT_EQ(map_scale(map).range.high, 8);
}

TEST(MapScale, TheMapIsColouredByIt) {
  const HeatMap map = map_of({0.01, 0.1, 1, 10}, true);
  Panel panel;
  panel.map = map;
  const PlacedMap placed = place_map(map, map_x_range(panel), map_y_range(panel), {0, 0, 2, 2});
  ASSERT_EQ(placed.values.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(placed.values[i], static_cast<double>(i) / 3, 1e-14);
}

}  // namespace
}  // namespace cromer
