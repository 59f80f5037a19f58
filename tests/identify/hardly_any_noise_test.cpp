// Records whose noise is so small, or whose motion is such, that the steps of the integration decide.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "cromer/identify/choose/choose_law.h"
#include "cromer/identify/law_fit.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

// In coarse steps the method's own error is a hundred times the noise, and any term more takes some of it up.
TEST(HardlyAnyNoise, TheLawIsNotOneTermTooMany) {
  const TrueSwing swings[] = {
      {.angular_frequency = 3, .drag = 0.5, .position = 0.05},
      {.angular_frequency = 3, .decay_rate = 0.01, .drag = 0.5, .position = 0.05},
      {.angular_frequency = 5, .decay_rate = 0.02, .position = 1.2, .pendulum = true},
      {.angular_frequency = 5, .decay_rate = 0.05, .cubic = 2000, .position = 0.05},
  };
  const std::vector<double> t = even_times(3000, 0.03);
  for (const Motion truth : swings) {
    const std::vector<double> y = noisy(free_motion(truth, t, 0.002).x, 1e-5 * truth.position);
    LawFitOptions options;
    options.angle = truth.law.has<Pendulum>();
    const Law expected = truth.decay_rate() > 0 ? truth.law : truth.law.without(law_with<Viscous>);
    EXPECT_EQ(to_text(choose_law({t, y}, options).chosen.law), to_text(expected));
  }
}

// A long recording with hardly any noise asks for fine steps: laws are compared on fewer swings of it then.
TEST(HardlyAnyNoise, ALongRecordingIsComparedOnItsBeginning) {
  const TrueSwing truth{.angular_frequency = 9.4, .decay_rate = 1e-3, .drag = 0.05, .position = 0.03};
  const std::vector<double> t = even_times(260'000, 0.008);
  const std::vector<double> y = noisy(free_motion(truth, t, 0.005).x, 3e-6 * truth.position);
  const LawFit fit = choose_law({t, y}, {}).chosen;
  ASSERT_EQ(fit.status, FitStatus::converged);
  EXPECT_EQ(to_text(fit.law), "viscous+drag");
  EXPECT_NEAR(fit["drag"].value, 0.05, 1e-6);
  ASSERT_EQ(fit.notices.at(0).code, "laws_compared_on_a_part");
  const Notice& said = fit.notices[0];
  const auto time = std::find_if(said.values.begin(), said.values.end(),
                                 [](const NoticeValue& each) { return each.name == "time"; });
  ASSERT_NE(time, said.values.end());
  EXPECT_LT(std::get<double>(time->value), 500);
}

// A hysteretic force has corners where the body turns.
TEST(HardlyAnyNoise, StepsThroughHysteresisAreShortEnough) {
  Motion truth{.law = law_of("viscous+hysteresis"), .position = 0.03};
  truth.set_angular_frequency(6);
  truth.set_decay_rate(0.03);
  truth.per_mass.hysteresis_stiffness = 12;
  truth.per_mass.hysteresis_beta = 20;
  truth.per_mass.hysteresis_gamma = 8;
  truth.per_mass.hysteresis_exponent = 1;
  const std::vector<double> t = even_times(2000, 0.01);
  const std::vector<double> x = free_motion(truth, t, 2e-4).x;
  double squares = 0, count = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(0, 1e-5 * truth.position);
    std::vector<double> y = x;
    for (double& each : y) each += normal(engine);
    LawFitOptions options;
    options.law = truth.law;
    const LawFit fit = fit_law({t, y}, options);
    ASSERT_EQ(fit.status, FitStatus::converged);
    const std::pair<const char*, double> known[] = {{"hysteresis_stiffness", 12.0},
                                                    {"hysteresis_beta", 20.0},
                                                    {"hysteresis_gamma", 8.0},
                                                    {"angular_frequency", 6.0}};
    for (const auto& [name, value] : known) {
      squares += std::pow((fit[name].value - value) / fit[name].standard_error, 2);
      count += 1;
    }
  }
  EXPECT_LT(std::sqrt(squares / count), 1.5);
}

// Where friction stops the motion after few half swings, a search may end at another number of them: the law
// is not given up there for one of a term more.
TEST(HardlyAnyNoise, ALawIsNotGivenUpForItsNumberOfHalfSwings) {
  const std::vector<double> t = even_times(1500, 0.00673);
  for (const double friction : {0.017, 0.0194, 0.022}) {
    const TrueSwing truth{.angular_frequency = 3.91,
                          .decay_rate = 0.0725,
                          .friction = friction,
                          .position = 0.0122,
                          .velocity = -0.0149};
    for (unsigned seed = 1; seed <= 6; ++seed) {
      std::mt19937_64 engine(seed);
      std::normal_distribution<double> normal(0, 1.9e-5);
      std::vector<double> y = free_motion(truth, t, 0.002).x;
      for (double& each : y) each += normal(engine);
      EXPECT_EQ(to_text(choose_law({t, y}, {}).chosen.law), "viscous+friction") << friction << " " << seed;
    }
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
