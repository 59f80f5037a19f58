#include "cromer/base/interrupt.h"

#include <gtest/gtest.h>

namespace cromer::core {
namespace CROMER_FILE {

TEST(Watch, AnEmptyOneNeverStops) {
  const Watch watch;
  watch.take_steps(1e300);
  EXPECT_FALSE(watch.out_of_steps());
  EXPECT_FALSE(watch.interrupted());
}

TEST(Watch, StopsWhenItIsTold) {
  std::atomic<bool> stop = false;
  Watch watch;
  watch.interrupt = &stop;
  EXPECT_FALSE(watch.interrupted());
  stop = true;
  EXPECT_TRUE(watch.interrupted());
  EXPECT_FALSE(watch.out_of_steps());
}

TEST(Watch, StopsWhenMoreStepsAreTakenThanThereAre) {
  Watch watch;
  watch.steps_left = std::make_shared<std::atomic<double>>(10);
  watch.take_steps(4);
  EXPECT_EQ(watch.steps_left->load(), 6);
  watch.take_steps(6);
  EXPECT_FALSE(watch.out_of_steps());
  EXPECT_FALSE(watch.interrupted());
  watch.take_steps(1);
  EXPECT_TRUE(watch.out_of_steps());
  EXPECT_TRUE(watch.interrupted());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
