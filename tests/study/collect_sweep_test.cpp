// The named results of a sweep: every number of a handmade one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/study/collected.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;

/// Two values of the damping ratio and three of the frequency, given in Hz.
SweepResult sweep_of_six() {
  SweepResult all;
  all.plan.swept = {{"damping-ratio", "damping_ratio", 2, "damping_ratio", 1},
                    {"drive-frequency", "drive_frequency (rad/s)", 3, "drive_frequency (Hz)", 0.5}};
  all.plan.measured = {"amplitude (m)"};
  all.plan.rows.columns = {"damping_ratio", "drive_frequency (rad/s)", "amplitude (m)", "status"};
  all.plan.rows.rows = 6;
  all.plan.method = "exact";
  all.plan.way = Notice{"closed_form"};
  all.plan.steps = Notice{"steps_of", {{"step", 0.1}}};
  all.rows = {0.1, 1, 5, 0.1, 2, 7, 0.1, 3, 4, 0.2, 1, nothing, 0.2, 2, 8, 0.2, 3, 8};
  all.counts.not_settled = 2;
  all.counts.not_finite = 1;
  return all;
}

TEST(CollectSweep, HasACurveAlongTheInnermostOptionForEachOfTheOthers) {
  Results results;
  collect("w", sweep_of_six(), results);
  EXPECT_EQ(fact(results, "w.points"), "6");
  EXPECT_EQ(fact(results, "w.not_settled"), "2");
  EXPECT_EQ(fact(results, "w.not_finite"), "1");
  EXPECT_EQ(fact(results, "w.method"), "exact");
  EXPECT_EQ(fact(results, "w.way"), "closed form");
  EXPECT_EQ(fact(results, "w.steps"), "steps of 0.1 s");
  EXPECT_EQ(fact(results, "w.1.label"), "damping ratio 0.1");
  EXPECT_EQ(fact(results, "w.2.label"), "damping ratio 0.2");
  EXPECT_EQ(fact(results, "w.3.label"), "none");
  EXPECT_EQ(fact(results, "w.2.damping_ratio"), "0.2");
  EXPECT_THAT(column(results, "w.1.drive_frequency").values, ElementsAre(1, 2, 3));
  EXPECT_EQ(column(results, "w.1.drive_frequency").unit, "rad/s");
  EXPECT_EQ(column(results, "w.1.drive_frequency").name, "drive frequency");
  EXPECT_THAT(column(results, "w.1.amplitude").values, ElementsAre(5, 7, 4));
  EXPECT_FALSE(results.column("w.1.status"));
  EXPECT_EQ(fact(results, "w.1.amplitude.largest"), "7 m");
  EXPECT_EQ(fact(results, "w.1.amplitude.largest_at"), "2 rad/s");
  EXPECT_EQ(fact(results, "w.1.amplitude.smallest"), "4 m");
  EXPECT_EQ(fact(results, "w.1.amplitude.smallest_at"), "3 rad/s");
  EXPECT_EQ(fact(results, "w.2.amplitude.smallest"), "8 m");
  EXPECT_EQ(fact(results, "w.2.amplitude.largest_at"), "2 rad/s");
  EXPECT_EQ(fact(results, "w.1.drive_frequency.largest"), "none");
}

TEST(CollectSweep, NamesEachPointOfAThousand) {
  Results results;
  SweepResult all = sweep_of_six();
  collect("w", all, results);
  EXPECT_EQ(fact(results, "w.point.1.label"), "damping ratio 0.1, drive frequency 2 Hz");
  EXPECT_EQ(fact(results, "w.point.6.amplitude"), "8 m");
  EXPECT_EQ(fact(results, "w.point.6.drive_frequency"), "3 rad/s");
  EXPECT_EQ(fact(results, "w.point.7.label"), "none");
  for (const std::uint64_t rows : {1000u, 1001u}) {
    all.plan.swept = {{"position", "position (m)", rows, "position (m)", 1}};
    all.plan.rows.columns = {"position (m)", "x (m)", "status"};
    all.plan.rows.rows = rows;
    all.rows.assign(2 * rows, 1);
    Results many;
    collect("w", all, many);
    EXPECT_EQ(many.fact("w.point.1000.label").ok(), rows == 1000) << rows;
    EXPECT_EQ(fact(many, "w.1.label"), "exact");
    EXPECT_EQ(column(many, "w.1.x").name, "*x*");
    EXPECT_EQ(column(many, "w.1.x").values.size(), rows);
  }
}

TEST(CollectSweep, WhereNothingHasANumberThereIsNoExtreme) {
  SweepResult all = sweep_of_six();
  for (std::size_t i = 2; i < all.rows.size(); i += 3) all.rows[i] = nothing;
  Results results;
  collect("w", all, results);
  EXPECT_TRUE(std::isnan(value(results, "w.1.amplitude.largest")));
  EXPECT_TRUE(std::isnan(value(results, "w.1.amplitude.largest_at")));
  EXPECT_TRUE(std::isnan(value(results, "w.2.amplitude.smallest")));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
