// A recorded swing that negative damping feeds and van der Pol's term bounds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/compare/compare.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

// From 0.05 to its limit cycle of 0.1414 m.
Series growing() {
  Motion motion{.law = law_of("viscous+van-der-pol"), .position = 0.05};
  motion.set_angular_frequency(6);
  motion.set_decay_rate(-0.1);
  motion.per_mass.van_der_pol = 40;
  Series series;
  series.quantity = "position";
  series.column = "x";
  series.rate = 100;
  series.t = even_times(4000, 0.01);
  std::mt19937_64 engine(3);
  std::normal_distribution<double> normal(0, 1e-3);
  for (const double x : observed_motion(motion, {}, series.t, 0, 0.002))
    series.y.push_back(x + normal(engine));
  return series;
}

TEST(SelfSustainedTask, SegmentsMayGrow) {
  const Result<FittedRecording> fit = fit_series(growing(), "growing.csv", {.segments = 8});
  ASSERT_TRUE(fit.ok());
  EXPECT_EQ(to_text(fit->fit.law), "viscous+van-der-pol");
  ASSERT_EQ(fit->segments.size(), 8u);
  // -b + e A²/8 at about 0.06 m.
  EXPECT_NEAR(fit->segments[0].rate.value, -0.08, 0.01);
  EXPECT_LT(fit->segments[0].rate.high, 0);
  EXPECT_THAT(in_words(fit->notices), Not(Contains(HasSubstr("rises"))));
}

TEST(SelfSustainedTask, GrowsInWords) {
  CompareOptions options;
  options.method = {"rk4"};
  const Result<FittedRecording> fit = fit_series(growing(), "growing.csv", {});
  ASSERT_TRUE(fit.ok());
  const Result<CompareResult> comparison = compare_fitted(*fit, options);
  ASSERT_TRUE(comparison.ok());
  EXPECT_THAT(in_words(explanation(*comparison)), HasSubstr("1/s as the swing grows from 5.4"));
}

TEST(SelfSustainedTask, NeverDiesDown) {
  const Result<FittedRecording> fit = fit_series(growing(), "growing.csv", {.goal = "decay_rate 0.01 %"});
  ASSERT_TRUE(fit.ok());
  ASSERT_TRUE(fit->plan);
  EXPECT_THAT(in_words(fit->plan->text), HasSubstr("not even a record of"));
  EXPECT_THAT(in_words(fit->plan->text), Not(HasSubstr("died down")));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
