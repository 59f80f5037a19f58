// Samples that a fit sets aside count in no other result.
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/base/extent.h"
#include "cromer/tasks/fit/fit.h"
#include "tests/tasks/disc_recording.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(SetAside, NeitherStretchesNorTextbookRulesSeeThem) {
  const Series clean = disc_recording(4, 60);
  Series spoilt = clean;
  for (std::size_t i = 100; i < spoilt.y.size(); i += 211) spoilt.y[i] += i % 2 == 0 ? 0.05 : -0.05;
  FitOptions options;
  options.law = "viscous+drag";
  options.textbook = true;
  const Result<FittedRecording> a = fit_series(clean, "clean", options), b = fit_series(spoilt, "b", options);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ(b->series.outliers.size(), 28u);
  ASSERT_FALSE(a->decay_by_amplitude.empty());
  ASSERT_EQ(b->decay_by_amplitude.size(), a->decay_by_amplitude.size());
  for (std::size_t i = 0; i < a->decay_by_amplitude.size(); ++i) {
    const Estimate &with = b->decay_by_amplitude[i].rate, &without = a->decay_by_amplitude[i].rate;
    EXPECT_LT(with.standard_error, 1.3 * without.standard_error);
    EXPECT_NEAR(with.value, without.value, without.standard_error);
  }
  ASSERT_TRUE(a->textbook->decrement && b->textbook->decrement);
  EXPECT_NEAR(b->textbook->decrement->value, a->textbook->decrement->value,
              2 * a->textbook->decrement->standard_error);
}

TEST(SetAside, TheMotionBeginsAtTheFirstSampleThatTheFitSees) {
  Series late = disc_recording(4, 30);
  for (std::size_t i = 0; i < 20; ++i) {
    late.outliers.push_back({late.t[i], 7, 0});
    late.y[i] = 7;
  }
  FitOptions options;
  options.law = "viscous+drag";
  const Result<FittedRecording> fit = fit_series(late, "late", options);
  ASSERT_TRUE(fit.ok());
  EXPECT_DOUBLE_EQ(fit->series.t.front(), 0.2);
  EXPECT_EQ(fit->series.outliers.size(), 20u);
  EXPECT_NEAR(fit->fit.position().value, 0.036 * std::cos(std::sqrt(17.04 / 0.2176) * 0.2), 1e-3);
}

// A sensor that is out of its range tells all but the tops.
TEST(SetAside, TopsThatAreCutOffLeaveTheRestToTellTheLaw) {
  const Series whole = disc_recording(4, 60);
  FitOptions options;
  options.law = "viscous+drag";
  const Result<FittedRecording> known = fit_series(whole, "whole", options);
  ASSERT_TRUE(known.ok());
  const auto [low, high] = extent_of(whole.y);
  for (const double share : {0.9, 0.6, 0.4})
    for (const bool above : {true, false}) {
      Series cut = whole;
      const double middle = 0.5 * (low + high), level = middle + share * ((above ? high : low) - middle);
      std::size_t cut_off = 0;
      for (double& y : cut.y)
        if (above ? y > level : y < level) y = level, ++cut_off;
      ASSERT_GT(cut_off, 20u);
      const Result<FittedRecording> fit = fit_series(cut, "cut", options);
      ASSERT_TRUE(fit.ok());
      EXPECT_EQ(fit->fit.status, FitStatus::converged) << share << above;
      EXPECT_TRUE(fit->says("cut_tops_aside"));
      EXPECT_EQ(fit->series.outliers.size(), cut_off) << share << above;
      for (const char* name : {"angular_frequency", "decay_rate", "drag"}) {
        const Estimate found = fit->fit[name], all = known->fit[name];
        EXPECT_NEAR(found.value, all.value, 2 * found.standard_error) << name << share << above;
      }
      // Of a later part, where none is cut off, nothing is said.
      FitOptions later = options;
      later.from = 55;
      if (share > 0.5) {
        EXPECT_FALSE(fit_series(cut, "cut", later)->says("cut_tops_aside")) << share;
      }
    }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
