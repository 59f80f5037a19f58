#include "cromer/record/live/timekeeper.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cromer {
namespace {

using ::testing::HasSubstr;

TEST(Timekeeper, KeepsTheDevicesTimes) {
  Timekeeper clock;
  for (int i = 0; i < 100; ++i) {
    const double device = 17.25 + i * 0.01, late = i % 7 * 0.003;
    const Stamp stamp = clock.of_device(device, 1000 + i * 0.01 + late);
    EXPECT_EQ(stamp.t, device);
    EXPECT_FALSE(stamp.notice);
  }
}

TEST(Timekeeper, ADeviceThatBeginsAnewGoesOnByTheComputersClock) {
  Timekeeper clock;
  for (int i = 0; i < 100; ++i) clock.of_device(5 + i * 0.01, i * 0.01);
  const Stamp reset = clock.of_device(0, 0.99 + 1.5);
  EXPECT_NEAR(reset.t, 5.99 + 1.5, 1e-6);
  ASSERT_TRUE(reset.notice);
  EXPECT_EQ(reset.notice->kind, NoticeKind::clock);
  EXPECT_THAT(reset.notice->text, HasSubstr("jumped back by 5.99 s"));
  const Stamp next = clock.of_device(0.01, 0.99 + 1.51);
  EXPECT_NEAR(next.t, 5.99 + 1.51, 1e-6);
  EXPECT_FALSE(next.notice);
}

TEST(Timekeeper, AForwardJumpIsToldFromAGap) {
  Timekeeper jumping, pausing;
  for (int i = 0; i < 100; ++i) jumping.of_device(i * 0.01, i * 0.01), pausing.of_device(i * 0.01, i * 0.01);
  const Stamp jump = jumping.of_device(60.99, 1.0);
  ASSERT_TRUE(jump.notice);
  EXPECT_THAT(jump.notice->text, HasSubstr("jumped forward by 60 s"));
  EXPECT_NEAR(jump.t, 1.0, 1e-6);
  const Stamp gap = pausing.of_device(60.99, 61.0);
  ASSERT_TRUE(gap.notice);
  EXPECT_EQ(gap.notice->kind, NoticeKind::gap);
  EXPECT_EQ(gap.t, 60.99);
}

TEST(Timekeeper, AFilePipedInKeepsItsGaps) {
  Timekeeper clock;
  for (int i = 0; i < 100; ++i) clock.of_device(i * 0.01, i * 1e-6);
  EXPECT_EQ(clock.of_device(60.99, 100e-6).t, 60.99);
}

TEST(Timekeeper, ARepeatedTimeStillRises) {
  Timekeeper clock;
  clock.of_device(1, 0);
  clock.of_device(1.01, 0.01);
  const Stamp again = clock.of_device(1.01, 0.02);
  EXPECT_GT(again.t, 1.01);
  EXPECT_LT(again.t, 1.03);
  ASSERT_TRUE(again.notice);
}

TEST(Timekeeper, CountsWhereTheRateIsKnown) {
  Timekeeper clock(100);
  for (int i = 0; i < 1000; ++i) {
    const Stamp stamp = clock.of_count(50 + i * 0.01 + (i % 5) * 0.02);
    EXPECT_DOUBLE_EQ(stamp.t, i / 100.0);
    EXPECT_FALSE(stamp.notice);
  }
  // Ten seconds without a sample: counting begins anew.
  const Stamp late = clock.of_count(50 + 10 + 10);
  ASSERT_TRUE(late.notice);
  EXPECT_NEAR(late.t, 20, 1e-6);
  EXPECT_NEAR(clock.of_count(70.01).t, 20.01, 1e-6);
}

TEST(Timekeeper, SeesADeviceInMilliseconds) {
  Timekeeper clock;
  for (int i = 0; i < 500; ++i) clock.of_device(i * 10, i * 0.01);
  EXPECT_NEAR(clock.pace(), 1000, 1);
}

// One garbled digit made all later times one and the same.
TEST(Timekeeper, ANumberThatIsNoTimeIsReplaced) {
  for (const double garbled : {1.2e73, -1e15}) {
    Timekeeper keeper;
    EXPECT_EQ(keeper.of_device(12.00, 100.00).t, 12.00);
    EXPECT_EQ(keeper.of_device(12.01, 100.01).t, 12.01);
    const Stamp replaced = keeper.of_device(garbled, 100.02);
    EXPECT_DOUBLE_EQ(replaced.t, 12.02);
    ASSERT_TRUE(replaced.notice);
    EXPECT_THAT(replaced.notice->text, HasSubstr("which is no time"));
    const Stamp next = keeper.of_device(12.03, 100.03);
    EXPECT_EQ(next.t, 12.03);
    EXPECT_FALSE(next.notice);
  }
  // A huge time that repeats still rises.
  Timekeeper keeper;
  const double first = keeper.of_device(9e14, 100).t, second = keeper.of_device(9e14, 100.01).t;
  EXPECT_GT(second, first);
  EXPECT_GT(keeper.of_device(9e14, 100.02).t, second);
}

}  // namespace
}  // namespace cromer
