// Every term of the registry, and every pair of them, is found again in the motion that it makes: free, under a
// harmonic drive and under a recorded force.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "tests/identify/forced_truth.h"
#include "tests/identify/free_swing.h"

namespace cromer {
namespace {

// Coefficients that each change a swing of 1 at 6 rad/s by a few percent.
Motion with_terms_of(const Law& law) {
  Motion motion{.law = law, .position = 1, .velocity = 0.3};
  motion.set_angular_frequency(6);
  motion.set_decay_rate(0.04);
  const auto set = [&](double Oscillator<double>::*member, double value, bool there) {
    if (there) motion.per_mass.*member = value;
  };
  set(&Oscillator<double>::drag, 0.03, law.has<Drag>());
  set(&Oscillator<double>::friction, 0.15, law.has<Friction>());
  set(&Oscillator<double>::cubic, 3, law.has<Cubic>());
  set(&Oscillator<double>::quadratic, 2, law.has<Quadratic>());
  set(&Oscillator<double>::odd_quadratic, -3, law.has<OddQuadratic>());
  set(&Oscillator<double>::quintic, 3, law.has<Quintic>());
  set(&Oscillator<double>::van_der_pol, 0.1, law.has<VanDerPol>());
  set(&Oscillator<double>::hysteresis_stiffness, 12, law.has<Hysteresis>());
  set(&Oscillator<double>::hysteresis_beta, 1.5, law.has<Hysteresis>());
  set(&Oscillator<double>::hysteresis_gamma, -0.5, law.has<Hysteresis>());
  if (!law.has<Viscous>()) motion.set_decay_rate(0);
  return motion;
}

enum class Kind { free, harmonic, recorded };

// The fit of the law to 40 s of its own motion with noise; every coefficient within 4.5 of its standard errors.
void expect_found(const Law& law, Kind kind) {
  SCOPED_TRACE(to_text(law) + (kind == Kind::free ? ", free" : kind == Kind::harmonic ? ", harmonic" : ", recorded"));
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
  ASSERT_EQ(fit.status, FitStatus::converged) << fit.message;
  EXPECT_LT(fit.residual.rms, 1.1e-3);
  const FittedParameters fitted = fitted_parameters(law, drive.kind, {}, motion);
  for (int i = 0; i < fitted.count; ++i) {
    const Estimate* estimate = fit.find(fitted.of[i].name);
    if (!estimate || !fitted.of[i].coefficient) continue;
    EXPECT_NEAR(estimate->value, fitted.of[i].of(motion), 4.5 * estimate->standard_error) << fitted.of[i].name;
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
    for (const Kind kind : {Kind::free, Kind::harmonic, Kind::recorded}) expect_found(law_of("viscous").with(term), kind);
}

TEST(TermsFit, EveryPairIsFoundAgain) {
  const std::vector<Law> terms = terms_to_add();
  for (std::size_t i = 0; i < terms.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      // Two laws of one shape: what tells a hysteretic force from damping and stiffness is small.
      if (terms[i].with(terms[j]).has<Hysteresis>()) continue;
      expect_found(law_of("viscous").with(terms[i]).with(terms[j]), Kind::free);
      // Not found under a recorded force: the cubic spring that leads there softens, and its motion runs away.
      if (terms[i].with(terms[j]) == law_with<OddQuadratic, Quintic>) continue;
      expect_found(law_of("viscous").with(terms[i]).with(terms[j]), Kind::recorded);
    }
}

TEST(TermsFit, ASpringWhoseFrequencyFallsWithItsAmplitudeIsOddQuadratic) {
  const Law law = law_of("viscous+drag+odd-quadratic");
  const Motion motion = with_terms_of(law);
  const std::vector<double> t = even_times(3000, 0.02);
  std::vector<double> y = observed_motion(motion, {}, t, 0, 0.005);
  std::mt19937_64 engine(7);
  std::normal_distribution<double> normal(0, 2e-3);
  for (double& each : y) each += normal(engine);
  const LawChoice choice = choose_law({t, y}, {});
  EXPECT_EQ(to_text(choice.chosen.law), to_text(law));
}

}  // namespace
}  // namespace cromer
