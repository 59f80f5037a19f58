// Every term beside stiffness and viscous damping is found again in the motion that it makes: free, under a
// harmonic drive and under a recorded force; and so is every pair without hysteresis.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string_view>
#include <type_traits>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "tests/identify/forced_truth.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

// A coefficient that changes a swing of 1 at 6 rad/s by a few percent. A term for which none is chosen has
// one that does about as much.
double coefficient_of(const CoefficientInfo& info, bool damps) {
  static const std::map<std::string_view, double> chosen = {{"drag", 0.03},
                                                            {"friction", 0.15},
                                                            {"cubic", 3},
                                                            {"quadratic", 2},
                                                            {"odd_quadratic", -3},
                                                            {"quintic", 3},
                                                            {"van_der_pol", 0.1},
                                                            {"hysteresis_stiffness", 12},
                                                            {"hysteresis_beta", 1.5},
                                                            {"hysteresis_gamma", -0.5}};
  const auto found = chosen.find(info.parameter);
  return found != chosen.end() ? found->second : damps ? 0.05 : 2;
}

Motion with_terms_of(const Law& law) {
  Motion motion{.law = law, .position = 1, .velocity = 0.3};
  motion.set_angular_frequency(6);
  if (law.has<Viscous>()) motion.set_decay_rate(0.04);
  for_each_term([&]<class T>() {
    if (!law.has<T>() || springs.has<T>() || std::is_same_v<T, Viscous>) return;
    for (std::size_t i = 0; i < coefficients_of<T>; ++i)
      motion.per_mass.*T::template members<double>[i] = coefficient_of(T::coefficients[i], T::info.damps);
  });
  return motion;
}

enum class Kind { free, harmonic, recorded };

// The fit of the law to 40 s of its own motion with noise; every coefficient within 4.5 of its standard
// errors.
void expect_found(const Law& law, Kind kind) {
  SCOPED_TRACE(to_text(law) + (kind == Kind::free       ? ", free"
                               : kind == Kind::harmonic ? ", harmonic"
                                                        : ", recorded"));
  Motion motion = with_terms_of(law);
  const std::vector<double> t = even_times(2000, 0.02);
  std::vector<double> force;
  const auto acting = multisine(15, 3);
  for (const double each : t) force.push_back(acting(each));
  Drive drive;
  if (kind == Kind::harmonic) {
    drive = Drive::harmonic();
    motion.cosine = 8;
    motion.sine = 3;
    motion.drive_frequency = 4.7;
  } else if (kind == Kind::recorded) {
    drive = Drive::recorded({force, 0, 0.02, BetweenSamples::linear});
    motion.force_gain = 5;
  }
  std::vector<double> y = observed_motion(motion, drive, t, 0, 0.002);
  ASSERT_EQ(y.size(), t.size());
  std::mt19937_64 engine(law.terms);
  std::normal_distribution<double> normal(0, 1e-3);
  for (double& each : y) each += normal(engine);
  LawFitOptions options{.law = law, .drive = drive};
  if (kind == Kind::harmonic) options.drive_frequency = 4.7;
  const LawFit fit = fit_law({t, y}, options);
  ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  EXPECT_LT(fit.residual.rms, 1.1e-3);
  const FittedParameters fitted = fitted_parameters(law, drive.kind, {}, motion);
  for (int i = 0; i < fitted.count; ++i) {
    const Estimate* estimate = fit.find(fitted.of[i].name);
    if (!fitted.of[i].coefficient) continue;
    ASSERT_NE(estimate, nullptr) << fitted.of[i].name;
    EXPECT_NEAR(estimate->value, fitted.of[i].of(motion), 4.5 * estimate->standard_error)
        << fitted.of[i].name;
  }
}

// The reading of the force that leaves least under a bent spring need not be that of the right law: both are
// chosen again together.
TEST(TermsFit, AHystereticForceIsChosenUnderARecordedOne) {
  Motion motion{.law = law_of("viscous+hysteresis")};
  motion.set_angular_frequency(5);
  motion.set_decay_rate(0.1);
  motion.per_mass.hysteresis_stiffness = 20;
  motion.per_mass.hysteresis_beta = 30;
  motion.per_mass.hysteresis_gamma = 10;
  motion.force_gain = 1;
  const std::vector<double> t = even_times(3000, 0.01);
  const auto acting = multisine(15, 5, 19);
  std::vector<double> force;
  for (const double each : t) force.push_back(1.2 * acting(each));
  const Drive drive = Drive::recorded({force, 0, 0.01, BetweenSamples::linear});
  for (unsigned seed = 1; seed <= 2; ++seed) {
    std::vector<double> y = observed_motion(motion, drive, t, 0, 0.002);
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(0, 5e-4);
    for (double& each : y) each += normal(engine);
    const LawChoice choice = choose_law({t, y}, {.drive = drive});
    EXPECT_EQ(to_text(choice.chosen.law), "viscous+hysteresis");
    EXPECT_LT(choice.chosen.residual.rms, 5.2e-4);
    EXPECT_NEAR(choice.chosen["hysteresis_beta"].value, 30,
                4 * choice.chosen["hysteresis_beta"].standard_error);
  }
}

// A joint that slips: what drag and bent springs leave of it dies down with the motion, and is no noise.
TEST(TermsFit, AFreeHystereticForceIsChosen) {
  struct Joint {
    double w0, g, stiffness, beta, gamma, position;
  };
  for (const Joint& joint : {Joint{5, 0.02, 20, 30, 10, 0.1}, Joint{8, 0.05, 10, 20, -5, 0.05}}) {
    Motion motion{.law = law_of("viscous+hysteresis"), .position = joint.position};
    motion.set_angular_frequency(joint.w0);
    motion.set_decay_rate(joint.g);
    motion.per_mass.hysteresis_stiffness = joint.stiffness;
    motion.per_mass.hysteresis_beta = joint.beta;
    motion.per_mass.hysteresis_gamma = joint.gamma;
    const std::vector<double> t = even_times(3000, 0.02);
    std::vector<double> y = observed_motion(motion, {}, t, 0, 0.002);
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal(0, 3e-4);
    for (double& each : y) each += normal(engine);
    EXPECT_EQ(to_text(choose_law({t, y}, {}).chosen.law), "viscous+hysteresis") << joint.w0;
  }
}

// In metres and in millimetres, whose z^n differ by a thousand to the n.
TEST(TermsFit, AHystereticForceOfExponentTwoIsFoundAtAnySize) {
  for (const double size : {1e-3, 1.0}) {
    Motion motion{.law = law_of("viscous+hysteresis"), .position = size, .velocity = 0.3 * size};
    motion.set_angular_frequency(6);
    motion.set_decay_rate(0.04);
    motion.per_mass.hysteresis_stiffness = 12;
    motion.per_mass.hysteresis_beta = 0.4 / (size * size);
    motion.per_mass.hysteresis_gamma = -0.1 / (size * size);
    motion.per_mass.hysteresis_exponent = 2;
    const std::vector<double> t = even_times(2000, 0.02);
    std::vector<double> y = observed_motion(motion, {}, t, 0, 0.002);
    std::mt19937_64 engine(3);
    std::normal_distribution<double> normal(0, 1e-3 * size);
    for (double& each : y) each += normal(engine);
    const LawFit fit = fit_law({t, y}, {.law = motion.law, .hysteresis_exponent = 2});
    ASSERT_EQ(fit.status, FitStatus::converged) << size << ": " << in_words(fit.message);
    EXPECT_LT(fit.residual.rms, 1.1e-3 * size);
    for (const auto& [name, truth] : {std::pair{"hysteresis_stiffness", 12.0},
                                      {"hysteresis_beta", 0.4 / (size * size)},
                                      {"hysteresis_gamma", -0.1 / (size * size)}})
      EXPECT_NEAR(fit[name].value, truth, 4 * fit[name].standard_error) << size << ' ' << name;
    // What swings is spring and hysteretic force together, known far better than each.
    EXPECT_NEAR(fit.swing_frequency().value, std::sqrt(48), 4 * fit.swing_frequency().standard_error);
    EXPECT_LT(fit.swing_frequency().standard_error, 0.3 * fit.angular_frequency().standard_error);
  }
}

std::vector<Law> terms_to_add() {
  std::vector<Law> list;
  for (std::size_t i = 0; i < term_count; ++i) {
    const Law term{std::uint32_t{1} << i};
    if (!springs.contains(term) && !law_with<Viscous>.contains(term)) list.push_back(term);
  }
  return list;
}

TEST(TermsFit, EachTermIsFoundAgain) {
  for (const Law& term : terms_to_add())
    for (const Kind kind : {Kind::free, Kind::harmonic, Kind::recorded})
      expect_found(law_of("viscous").with(term), kind);
}

TEST(TermsFit, EveryPairIsFoundAgain) {
  const std::vector<Law> terms = terms_to_add();
  for (std::size_t i = 0; i < terms.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      // A body that sticks has no loop to tell of.
      if (terms[i].with(terms[j]) == law_with<Friction, Hysteresis>) continue;
      expect_found(law_of("viscous").with(terms[i]).with(terms[j]), Kind::free);
      expect_found(law_of("viscous").with(terms[i]).with(terms[j]), Kind::harmonic);
      expect_found(law_of("viscous").with(terms[i]).with(terms[j]), Kind::recorded);
    }
}

// Beside which other terms a term was tried does not matter: what is not sure is left out again.
TEST(TermsFit, EachTermIsChosen) {
  std::vector<Law> laws{law_of("viscous+drag+odd-quadratic")};
  for (const Law& term : terms_to_add())
    if (term != law_with<Hysteresis>)
      laws.push_back(law_of("viscous").with(term));  // so small a loop looks like drag
  for (const Law& law : laws) {
    const Motion motion = with_terms_of(law);
    const std::vector<double> t = even_times(3000, 0.02);
    std::vector<double> y = observed_motion(motion, {}, t, 0, 0.005);
    std::mt19937_64 engine(7);
    std::normal_distribution<double> normal(0, 2e-3);
    for (double& each : y) each += normal(engine);
    const LawChoice choice = choose_law({t, y}, {});
    EXPECT_EQ(to_text(choice.chosen.law), to_text(law));
  }
}

// A whole turn further on it swings in the same way.
TEST(TermsFit, APendulumsRestIsTheOneThatItSwingsAbout) {
  TrueSwing motion{.angular_frequency = 4, .decay_rate = 0.05, .position = 2.2, .pendulum = true};
  SyntheticRecord record{even_times(600, 0.02), {}, 0};
  record.y = free_motion(motion, record.t, 1e-3).x;
  for (double& y : record.y) y += 0.1;
  for (const double turns : {0.0, 1.0, -2.0}) {
    motion.position = 2.2 + turns * two_pi;
    motion.equilibrium = 0.1 - turns * two_pi;
    LawFitOptions options{.law = law_of("viscous+pendulum")};
    options.start = KnownMotion{.motion = motion, .samples = record.t.size()};
    const LawFit fit = fit_law(record.record(), options);
    ASSERT_TRUE(fit.is_usable()) << turns;
    EXPECT_NEAR(fit["equilibrium"].value, 0.1, 1e-6) << turns;
    EXPECT_NEAR(fit["position"].value, 2.2, 1e-6) << turns;
    EXPECT_NEAR(fit.motion.position, 2.2, 1e-6) << turns;
    EXPECT_LE(fit["equilibrium"].low, 0.1 + 1e-6) << turns;
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
