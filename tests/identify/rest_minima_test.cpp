// Records of motions that friction brings to rest: the number of half swings before it is found, and where it
// cannot be found the intervals say so.
#include "cromer/identify/rest_minima.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cromer/documents/words/words.h"
#include "cromer/identify/motion/motion_model.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double noise = 1e-3;

SyntheticRecord record_of(const TrueSwing& motion, unsigned seed) {
  const std::vector<double> t = even_times(3000, 0.021);
  SyntheticRecord record{t, free_motion(motion, t, 5e-3).x, 0};
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  for (double& y : record.y) y += motion.equilibrium + noise * normal(engine);
  return record;
}

TEST(RestMinima, NoFitStartedAtTheTruthIsCloser) {
  const TrueSwing truth{
      .angular_frequency = 6, .decay_rate = 0.04, .friction = 0.006, .equilibrium = 0.2, .position = -0.05};
  const Law law = law_of("viscous+friction");
  int covered = 0, said = 0;
  constexpr int trials = 24;
  for (unsigned seed = 1; seed <= trials; ++seed) {
    const SyntheticRecord record = record_of(truth, seed);
    const LawFit fit = fit_law(record.record(), {.law = law});
    ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
    const LawFit informed =
        fit_law(record.record(), {.law = law, .start = KnownMotion{truth, record.t.size(), 0.1}});
    EXPECT_LE(fit.residual.rms, informed.residual.rms * (1 + 1e-7)) << seed;
    covered += fit["friction"].low <= truth.friction && truth.friction <= fit["friction"].high;
    said += !in_words(fit.notices).empty();
  }
  EXPECT_GE(covered, 21);
  EXPECT_GE(said, 1);
  EXPECT_LT(said, trials);
}

TEST(RestMinima, ARestBeyondTheBandSettlesAtItsEnd) {
  TrueSwing truth{.angular_frequency = 6, .friction = 0.012, .position = 0, .velocity = -0.3};
  const double band = truth.friction / 36;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SyntheticRecord record = record_of(truth, seed);
    const Trajectory motion = free_motion(truth, record.t, 5e-3);
    const double rest = motion.x.back();
    for (std::size_t i = 0; i < record.t.size(); ++i)
      if (motion.v[i] == 0) record.y[i] += (rest > 0 ? 1.3 : -1.3) * band - rest;
    const LawFit fit = fit_law(record.record(), {.law = law_of("friction")});
    EXPECT_EQ(fit.status, FitStatus::converged) << seed << ": " << in_words(fit.message);
    EXPECT_NEAR(fit["friction"].value, truth.friction, 0.02 * truth.friction);
  }
}

TEST(RestMinima, EqualMinimaCountEqually) {
  LawFit fit;
  fit.law = law_of("friction");
  const FittedParameters fitted = fitted_parameters(fit.law);
  const auto n = static_cast<std::size_t>(fitted.count);
  fit.names.clear();
  for (int i = 0; i < fitted.count; ++i) fit.names.emplace_back(fitted.of[i].name);
  fit.estimates.assign(n, {});
  fit.find("friction")->value = 20;
  LeastSquaresSummary one, other;
  one.equations.size = fitted.count;
  one.equations.sum_of_squares = 1000;
  for (int i = 0; i < fitted.count; ++i) one.equations.matrix[i][i] = 1;
  one.parameters[1] = fit["friction"].value;
  other = one;
  other.parameters[1] = 30;
  fit.covariance.assign(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) fit.covariance[i * n + i] = 1;
  fit.independent_samples = 1e6;
  spread_over(fit, fitted, {one, other});
  // Two normal distributions ten deviations apart: a twentieth of each lies outside, at 1.645 deviations.
  EXPECT_NEAR(fit["friction"].low, 20 - 1.645, 1e-3);
  EXPECT_NEAR(fit["friction"].high, 30 + 1.645, 1e-3);
  EXPECT_NEAR(fit["friction"].standard_error, std::sqrt(1 + 0.5 * 100), 1e-9);
  EXPECT_NEAR(fit.equilibrium().high, 1.960, 1e-3);
  EXPECT_EQ(in_words(fit.notices).size(), 1u);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
