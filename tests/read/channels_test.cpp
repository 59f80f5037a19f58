#include "cromer/read/channels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/read/reading.h"

namespace cromer::core {
namespace {

using testing::ElementsAre;
using testing::IsNan;

TEST(Channels, AreAllColumnsOfTheMotion) {
  const Recording recording = read(
      "Time (s),Angle 1 (deg),Force (N),Angle 2 (rad)\n"
      "0,180,7,0.5\n0.1,,7,0.25\n0.2,90,7,\n0.3,45,7,0.125\n");
  const auto channels = take_channels(recording, 1, {});
  ASSERT_TRUE(channels.ok()) << in_words(channels.error());
  EXPECT_EQ(channels->quantity, "angle");
  EXPECT_THAT(channels->t, ElementsAre(0, 0.1, 0.2, 0.3));
  ASSERT_EQ(channels->each.size(), 2u);
  EXPECT_EQ(channels->each[0].column, "Angle 1 (deg)");
  EXPECT_NEAR(channels->each[0].y[0], 3.14159265358979, 1e-12);
  EXPECT_THAT(channels->each[0].y[1], IsNan());
  EXPECT_EQ(channels->each[0].missing, 1u);
  EXPECT_THAT(channels->each[1].y[2], IsNan());
  EXPECT_EQ(channels->each[1].y[3], 0.125);
}

TEST(Channels, SamplesThatStickOutAreMissing) {
  std::string text = "Time (s),Position (m),Position 2 (m)\n";
  for (int i = 0; i < 200; ++i)
    text += std::to_string(0.01 * i) + "," + std::to_string(i == 50 ? 30 : 0.1 * std::sin(0.06 * i)) + "," +
            std::to_string(0.1 * std::cos(0.06 * i)) + "\n";
  const auto channels = take_channels(read(text), 1, {});
  ASSERT_TRUE(channels.ok()) << in_words(channels.error());
  ASSERT_EQ(channels->t.size(), 200u);
  EXPECT_THAT(channels->each[0].y[50], IsNan());
  EXPECT_EQ(channels->each[0].missing, 1u);
  EXPECT_EQ(channels->each[1].missing, 0u);
}

TEST(Channels, AreRefusedWhereNothingMoves) {
  EXPECT_FALSE(take_channels(read("Time (s),Position (m)\n0,1\n1,2\n"), 2, {}).ok());
}

}  // namespace
}  // namespace cromer::core
