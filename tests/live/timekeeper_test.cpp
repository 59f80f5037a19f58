#include "cromer/live/timekeeper.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

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
  EXPECT_EQ(reset.notice->kind, RemarkKind::clock);
  EXPECT_THAT(in_words(reset.notice->what), HasSubstr("jumped back by 5.99 s"));
  const Stamp next = clock.of_device(0.01, 0.99 + 1.51);
  EXPECT_NEAR(next.t, 5.99 + 1.51, 1e-6);
  EXPECT_FALSE(next.notice);
}

TEST(Timekeeper, AForwardJumpIsToldFromAGap) {
  Timekeeper jumping, pausing;
  for (int i = 0; i < 100; ++i) jumping.of_device(i * 0.01, i * 0.01), pausing.of_device(i * 0.01, i * 0.01);
  const Stamp jump = jumping.of_device(60.99, 1.0);
  ASSERT_TRUE(jump.notice);
  EXPECT_THAT(in_words(jump.notice->what), HasSubstr("jumped forward by 60 s"));
  EXPECT_NEAR(jump.t, 1.0, 1e-6);
  const Stamp gap = pausing.of_device(60.99, 61.0);
  ASSERT_TRUE(gap.notice);
  EXPECT_EQ(gap.notice->kind, RemarkKind::gap);
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
    EXPECT_THAT(in_words(replaced.notice->what), HasSubstr("which is no time"));
    const Stamp next = keeper.of_device(12.03, 100.03);
    EXPECT_EQ(next.t, 12.03);
    EXPECT_FALSE(next.notice);
  }
  // A huge time that repeats still rises.
  Timekeeper keeper;
  const double first = keeper.of_device(9e14, 100).t, second = keeper.of_device(9e14, 100.01).t;
  EXPECT_GT(second, first);
  EXPECT_GT(keeper.of_device(9e14, 100.02).t, second);
  // So does what stands in for no time behind it, though the step is lost in rounding.
  Timekeeper late;
  EXPECT_EQ(late.of_device(17900009047372, 100).t, 17900009047372);
  EXPECT_GT(late.of_device(1.1e73, 100).t, 17900009047372);
}

/// After a hundred samples, each 0.01 s, of a device whose clock begins at 5 s.
Timekeeper running(double arrival_step = 0.01, int samples = 100) {
  Timekeeper clock;
  for (int i = 0; i < samples; ++i) clock.of_device(5 + i * 0.01, i * arrival_step);
  return clock;
}

std::string said(const Stamp& stamp) { return stamp.notice ? in_words(stamp.notice->what) : ""; }

TEST(Timekeeper, AGapIsLongerThanATenthOfASecondAndFiveSteps) {
  EXPECT_EQ(said(running().of_device(6.095, 1.1)), "nothing for 0.105 s from 5.99 s on");
  EXPECT_EQ(said(running().of_device(6.085, 1.1)), "");
  Timekeeper slow;
  for (int i = 0; i < 20; ++i) slow.of_device(i, i);
  EXPECT_EQ(said(Timekeeper(slow).of_device(23.9, 23.9)), "");
  EXPECT_EQ(said(slow.of_device(24.1, 24.1)), "nothing for 5.1 s from 19 s on");
  EXPECT_EQ(said(running(0.01, 3).of_device(5.2, 0.2)), "nothing for 0.18 s from 5.02 s on");
  EXPECT_EQ(said(running(0.01, 2).of_device(5.2, 0.2)), "");
}

TEST(Timekeeper, AJumpForwardIsHalfASecondMoreThanPassed) {
  EXPECT_EQ(
      said(running().of_device(5.99 + 0.52, 1.0)),
      "the device's clock jumped forward by 0.52 s at 5.99 s; the times go on from the computer's clock");
  EXPECT_EQ(said(running().of_device(5.99 + 0.50, 1.0)), "nothing for 0.5 s from 5.99 s on");
  // Nor where five usual steps are more, or the clocks do not keep pace.
  Timekeeper slow;
  for (int i = 0; i < 20; ++i) slow.of_device(i, i);
  EXPECT_EQ(slow.of_device(23.9, 20).t, 23.9);
  for (const double pace : {0.0051, 0.0199})
    EXPECT_EQ(running(pace).of_device(66, 100 * pace).notice->kind, RemarkKind::clock);
  for (const double pace : {0.0049, 0.0201})
    EXPECT_EQ(running(pace).of_device(66, 100 * pace).notice->kind, RemarkKind::gap);
  EXPECT_EQ(running(0.01, 9).of_device(66, 0.09).notice->kind, RemarkKind::clock);
  EXPECT_EQ(running(0.01, 8).of_device(66, 0.08).notice->kind, RemarkKind::gap);
}

TEST(Timekeeper, BehindAJumpTheTimesGoOnByTheDevicesSteps) {
  Timekeeper clock = running();
  const Stamp jump = clock.of_device(66, 1.0);
  EXPECT_NEAR(jump.t, 6.0, 1e-9);
  EXPECT_NEAR(clock.of_device(66.01, 1.05).t, 6.01, 1e-9);
  // At least a usual step passes.
  Timekeeper back = running();
  EXPECT_NEAR(back.of_device(0, 0.99).t, 6.0, 1e-9);
  EXPECT_EQ(said(back.of_device(0, 1.0)), "the device gave the time 0 s twice");
  EXPECT_NEAR(back.of_device(0.01, 1.01).t, 6.02, 1e-9);
}

TEST(Timekeeper, ATimeOfAThousandTrillionSecondsIsNone) {
  Timekeeper clock = running();
  EXPECT_EQ(said(clock.of_device(1e15, 1.0)),
            "the device gave 1e+15 s, which is no time; 6 s is taken instead");
  Timekeeper first;
  EXPECT_EQ(first.of_device(1e15, 7).t, 0);
  Timekeeper late = running();
  EXPECT_NEAR(late.of_device(-1e15, 1.49).t, 6.49, 1e-9);
  EXPECT_EQ(late.of_device(6.5, 1.5).t, 6.5);
  EXPECT_EQ(running().of_device(9.9e14, 1e15).t, 9.9e14);
}

// The pause before a burst, as of USB and networks, was taken for a step of the device's clock: that seemed
// to jump back behind it.
TEST(Timekeeper, AGarbledTimeInABurstMovesNoOther) {
  for (const int burst : {16, 200}) {
    for (const int garbled : {3 * burst, 3 * burst + 1, 4 * burst - 1, 4 * burst}) {
      Timekeeper clock;
      for (int i = 0; i < 6 * burst; ++i) {
        const double device = 7 + i * 0.001, arrival = 100 + (i / burst + 1) * burst * 0.001;
        const Stamp stamp = clock.of_device(i == garbled ? 1e73 : device, arrival);
        EXPECT_NEAR(stamp.t, device, i == garbled ? 1e-9 : 0) << burst << " " << garbled << " " << i;
        EXPECT_EQ(stamp.notice.has_value(), i == garbled) << burst << " " << garbled << " " << said(stamp);
      }
    }
  }
}

TEST(Timekeeper, BehindAGarbledTimeTheDevicesClockGoesOn) {
  // The next true time is nearer than usual.
  Timekeeper near = running();
  EXPECT_NEAR(near.of_device(1e73, 1.0).t, 6, 1e-9);
  const Stamp soon = near.of_device(5.995, 1.0);
  EXPECT_GT(soon.t, 6);
  EXPECT_EQ(said(soon), "");
  EXPECT_EQ(near.of_device(6.01, 1.01).t, 6.01);
  // A silence that ends with it is not said again.
  Timekeeper silent = running();
  EXPECT_NEAR(silent.of_device(1e73, 4.0).t, 9, 1e-9);
  EXPECT_EQ(said(silent.of_device(9.01, 4.01)), "");
  // One that may be no silence, as samples came as late before, is.
  Timekeeper late = running();
  late.of_device(6, 3.0);
  EXPECT_NEAR(late.of_device(1e73, 6.0).t, 6.01, 1e-9);
  EXPECT_EQ(said(late.of_device(9.01, 6.01)), "nothing for 3 s from 6.01 s on");
  // A device that begins anew behind it loses no time.
  Timekeeper anew = running();
  EXPECT_NEAR(anew.of_device(1e73, 1.49).t, 6.49, 1e-9);
  EXPECT_NEAR(anew.of_device(0, 1.6).t, 6.6, 1e-9);
  // The pace is that of true times.
  Timekeeper paced;
  paced.of_device(3, 100);
  paced.of_device(7, 102);
  paced.of_device(1e73, 104);
  EXPECT_EQ(paced.pace(), 2);
}

TEST(Timekeeper, TheUsualStepIsOfTheLastSixtyFour) {
  Timekeeper clock;
  double device = 0;
  for (int i = 0; i < 100; ++i, device += 1) clock.of_device(device, device);
  for (int i = 0; i < 32; ++i, device += 0.01) clock.of_device(device, device);
  // Half of them are long, then half are short.
  EXPECT_EQ(said(Timekeeper(clock).of_device(device + 1, device + 1)), "");
  for (int i = 0; i < 3; ++i, device += 0.01) clock.of_device(device, device);
  EXPECT_NE(said(clock.of_device(device + 1, device + 1)), "");
}

TEST(Timekeeper, CountingBeginsAnewHalfASecondOff) {
  const auto late = [](double by) {
    Timekeeper clock(100);
    for (int i = 0; i < 100; ++i) clock.of_count(50 + i * 0.01);
    return clock.of_count(51 + by);
  };
  EXPECT_EQ(late(0.49).t, 1);
  EXPECT_EQ(said(late(0.49)), "");
  EXPECT_NEAR(late(0.51).t, 1.51, 1e-9);
  EXPECT_EQ(said(late(0.51)),
            "at 0.99 s a sample came 0.51 s later than --rate predicts; counting begins anew");
  // What comes too fast is counted: its arrival may not lie before the last time.
  Timekeeper fast(100);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(said(fast.of_count(50 + i * 0.001)), "");
  EXPECT_EQ(fast.of_count(50.1).t, 1);
  // Early, after a pause.
  Timekeeper early(1);
  early.of_count(50);
  EXPECT_EQ(said(early.of_count(50.4)),
            "at 0 s a sample came 0.6 s earlier than --rate predicts; counting begins anew");
  EXPECT_NEAR(early.of_count(51.4).t, 1.4, 1e-9);
}

TEST(Timekeeper, ThePaceIsKnownAfterTwoSeconds) {
  Timekeeper clock;
  clock.of_device(3, 100);
  EXPECT_EQ(clock.pace(), 0);
  clock.of_device(9, 101.9);
  EXPECT_EQ(clock.pace(), 0);
  clock.of_device(11, 102);
  EXPECT_EQ(clock.pace(), 4);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
