#include "cromer/read/channels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/read/reading.h"

namespace cromer::core {
namespace CROMER_FILE {

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
    text += std::to_string(0.01 * i) + "," +
            std::to_string(i == 50 || i == 120 || i == 160 ? 30 : 0.1 * std::sin(0.06 * i)) + "," +
            std::to_string(0.1 * std::cos(0.06 * i)) + "\n";
  const auto channels = take_channels(read(text), 1, {});
  ASSERT_TRUE(channels.ok()) << in_words(channels.error());
  ASSERT_EQ(channels->t.size(), 200u);
  for (const std::size_t i : {50u, 120u, 160u}) EXPECT_THAT(channels->each[0].y[i], IsNan()) << i;
  EXPECT_EQ(channels->each[0].missing, 3u);
  EXPECT_EQ(channels->each[1].missing, 0u);
}

TEST(Channels, AColumnWithoutNumbersIsMissingAndTheNextAreNot) {
  const auto channels = take_channels(
      read("Time (s),Position (m),Position 2 (m),Position 3 (m)\n0,,1,5\n0.1,,2,4\n0.2,,3,2\n"), 1, {});
  ASSERT_TRUE(channels.ok()) << in_words(channels.error());
  ASSERT_EQ(channels->each.size(), 3u);
  EXPECT_EQ(channels->each[0].column, "Position (m)");
  EXPECT_THAT(channels->each[0].y, ElementsAre(IsNan(), IsNan(), IsNan()));
  EXPECT_EQ(channels->each[0].missing, 3u);
  EXPECT_THAT(channels->each[1].y, ElementsAre(1, 2, 3));
  EXPECT_THAT(channels->each[2].y, ElementsAre(5, 4, 2));
  EXPECT_EQ(channels->unit, "m");
  EXPECT_DOUBLE_EQ(channels->rate, 10);
}

TEST(Channels, AColumnThatNoNameCallsAMotionIsTheOnlyOne) {
  const auto channels = take_channels(read("Time (s),Reading\n0,1\n0.1,2\n0.2,4\n"), 1, {});
  ASSERT_TRUE(channels.ok()) << in_words(channels.error());
  ASSERT_EQ(channels->each.size(), 1u);
  EXPECT_EQ(channels->each[0].column, "Reading");
  EXPECT_THAT(channels->each[0].y, ElementsAre(1, 2, 4));
  EXPECT_EQ(channels->each[0].missing, 0u);
}

TEST(Channels, AreRefusedWhereNothingMoves) {
  EXPECT_FALSE(take_channels(read("Time (s),Position (m)\n0,1\n1,2\n"), 2, {}).ok());
}

const std::string two_with_holes =
    "Time (s),Position (m),Position 2 (m)\n0,1,5\n0.1,,6\n0.2,3,7\n0.3,4,\n0.4,5,9\n0.5,6,10\n";

TEST(Channels, AreCroppedBetweenTwoTimes) {
  Channels channels = *take_channels(read(two_with_holes), 1, {});
  ASSERT_TRUE(crop(channels, 0.1, 0.4).ok());
  EXPECT_THAT(channels.t, ElementsAre(0.1, 0.2, 0.3, 0.4));
  EXPECT_THAT(channels.each[1].y, ElementsAre(6, 7, IsNan(), 9));
  EXPECT_EQ(channels.each[0].missing, 1u);
  EXPECT_EQ(channels.each[1].missing, 1u);
  ASSERT_TRUE(crop(channels, {}, 0.25).ok());
  EXPECT_EQ(channels.each[1].missing, 0u);
  EXPECT_THAT(channels.t, ElementsAre(0.1, 0.2));
  EXPECT_TRUE(crop(channels, {}, {}).ok());
  const auto none = [&](std::optional<double> from, std::optional<double> to) {
    const auto done = crop(channels, from, to);
    return done ? "" : in_words(done.error());
  };
  EXPECT_EQ(none(0.15, 0.18),
            "--from 0.15 --to 0.18: no sample is left, the recording goes from 0.1 to 0.2 s");
  EXPECT_EQ(none(0.3, {}).substr(0, 30), "--from 0.3: no sample is left,");
  EXPECT_EQ(none({}, 0.05).substr(0, 29), "--to 0.05: no sample is left,");
  // To a millionth of a step, and one sample is a part.
  EXPECT_EQ(none(0.2 + 1e-8, {}), "");
  EXPECT_THAT(channels.t, ElementsAre(0.2));
  EXPECT_EQ(none({}, {}), "");
}

TEST(Channels, TimesThatOneLacksAreLeftOutOfAll) {
  Channels channels = *take_channels(read(two_with_holes), 1, {});
  EXPECT_EQ(leave_out_incomplete(channels), 2u);
  EXPECT_THAT(channels.t, ElementsAre(0, 0.2, 0.4, 0.5));
  EXPECT_THAT(channels.each[0].y, ElementsAre(1, 3, 5, 6));
  EXPECT_THAT(channels.each[1].y, ElementsAre(5, 7, 9, 10));
  EXPECT_EQ(channels.each[0].missing, 0u);
  EXPECT_EQ(leave_out_incomplete(channels), 0u);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
