#include "cromer/identify/choose/choose_law.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace {

TEST(ChooseLaw, ALongRecordIsJudgedByAPartAndFittedWhole) {
  const FreeSwing truth{.angular_frequency = 8.849,
                        .decay_rate = 0.002,
                        .drag = 0.1,
                        .equilibrium = 0.2,
                        .position = 0.036,
                        .velocity = 0};
  SyntheticRecord record{even_times(400'000, 0.001), {}, 0};
  std::mt19937_64 engine(4);
  std::normal_distribution<double> normal(0, 3e-4);
  for (const double x : free_motion(truth, record.t, 0.01).x)
    record.y.push_back(truth.equilibrium + x + normal(engine));
  const LawChoice choice = choose_law(record.record(), {});
  const LawFit& fit = choice.chosen;
  EXPECT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  EXPECT_EQ(to_text(fit.law), "viscous+drag");
  EXPECT_LE(choice.candidates.size(), 23u);  // with van-der-pol in the place of drag, and with quadratic
  EXPECT_NEAR(fit["drag"].value, 0.1, 4 * fit["drag"].standard_error);
  EXPECT_NEAR(fit.decay_rate().value, 0.002, 4 * fit.decay_rate().standard_error);
  EXPECT_THAT(in_words(fit.notices), testing::Contains(testing::HasSubstr("one in 10 up to 399.99 s")));
  // The uncertainties are those of all samples, half of the candidate's.
  EXPECT_LT(fit["drag"].standard_error, 0.6 * choice.candidates[1]["drag"].standard_error);
}

// Its second harmonic and the middle that moves as the swing dies down stand apart from the swing's
// frequency.
TEST(ChooseLaw, ASpringThatIsNotSymmetricIsFound) {
  Motion truth{.law = law_of("viscous+quadratic"), .position = 0.05};
  truth.set_angular_frequency(6);
  truth.set_decay_rate(0.06);
  truth.per_mass.quadratic = 36;
  const std::vector<double> t = even_times(600, 0.0419);
  const std::vector<double> x = free_motion(truth, t, 0.005).x;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(0, 5e-4);
    std::vector<double> y = x;
    for (double& each : y) each += normal(engine);
    EXPECT_EQ(to_text(choose_law({t, y}, {}).chosen.law), "viscous+quadratic") << seed;
  }
}

}  // namespace
}  // namespace cromer::core
