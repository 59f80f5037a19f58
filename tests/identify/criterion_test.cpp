// The choice among laws, on candidates made by hand: who is admissible, and who wins at, below and above each
// limit.
#include "cromer/identify/choose/criterion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/choose_law.h"
#include "cromer/identify/diagnose/mean_decay.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double independent = 1000;

/// A fit whose criterion is `bic`; every term's interval is far from zero.
LawFit candidate(const char* law, double bic, FitStatus status = FitStatus::converged) {
  LawFit fit;
  fit.law = law_of(law);
  fit.status = status;
  fit.independent_samples = independent;
  fit.names = {"angular_frequency", "equilibrium", "position", "velocity"};
  fit.estimates.assign(4, {1, 0.01, 0.98, 1.02});
  for_each_term([&]<class T>() {
    if (!fit.law.has<T>() || springs.has<T>()) return;
    fit.names.emplace_back(T::coefficients[0].parameter);
    fit.estimates.push_back({1, 0.01, 0.98, 1.02});
  });
  fit.fitted = static_cast<int>(fit.names.size());
  fit.residual.rms = std::exp((bic - fit.fitted * std::log(independent)) / (2 * independent));
  return fit;
}

LawFit unsure(LawFit fit, const std::string& name) {
  *fit.find(name) = {1, 0.6, -0.2, 2.2};
  return fit;
}

std::size_t choose(std::vector<LawFit> candidates) { return choose_candidate(candidates); }

std::string choice(std::vector<LawFit> candidates) {
  return to_text(candidates[choose_candidate(candidates)].law);
}

TEST(Criterion, IsSchwarzs) {
  EXPECT_DOUBLE_EQ(bayesian_criterion(1000, 0.5, 3, 0), 2000 * std::log(0.5) + 3 * std::log(1000.0));
  // What is below the rounding only follows its pattern.
  EXPECT_DOUBLE_EQ(bayesian_criterion(1000, 1e-9, 3, std::sqrt(12.0)), 3 * std::log(1000.0));
  std::vector<LawFit> candidates{candidate("viscous", -123), candidate("viscous+drag", -456)};
  candidates[1].residual.rms *= 0.5;
  const double twice = candidates[1].bic = -456 - 2000 * std::log(2.0);
  (void)choose_candidate(candidates);
  EXPECT_NEAR(candidates[0].bic, -123, 1e-9);
  EXPECT_NEAR(candidates[1].bic, twice, 1e-9);
}

// What is left of a noisy force's fits is judged by their own likelihoods.
TEST(Criterion, IsTheNoisesWhereAForceIsNoisy) {
  const auto with_noise = [](LawFit fit, bool shows, double bic) {
    fit.force_noise = ForceNoiseSeen{.deviation = 0.1, .shows = shows, .counts = true, .bic = bic};
    return fit;
  };
  const LawFit viscous = candidate("viscous", 0), drag = candidate("viscous+drag", -40),
               rough = candidate("viscous+cubic", -25);
  const auto of = [](const LawFit& fit, const std::vector<LawFit>& all) {
    std::vector<const LawFit*> fits;
    for (const LawFit& each : all) fits.push_back(&each);
    return Criterion(fits, 0).of(fit);
  };
  const std::vector<LawFit> noisy{with_noise(viscous, true, -500), with_noise(drag, true, -497), rough};
  EXPECT_EQ(of(noisy[0], noisy), -500);
  EXPECT_EQ(of(noisy[1], noisy), -497);
  // One without a likelihood keeps its distance from the closest that has one.
  EXPECT_NEAR(of(rough, noisy), -497 + 15, 1e-9);
  EXPECT_EQ(choose(noisy), 0u);
  // Where none shows, or another law is far closer, the plain one.
  const std::vector<LawFit> quiet{with_noise(viscous, false, -500), with_noise(drag, false, -497)};
  EXPECT_NEAR(of(quiet[1], quiet), -40, 1e-9);
  LawFit hysteretic = candidate("viscous+hysteresis", -40);
  hysteretic.residual.rms *= 0.5;
  const std::vector<LawFit> far{with_noise(viscous, true, -500), hysteretic};
  EXPECT_NEAR(of(far[0], far), 0, 1e-9);
}

TEST(ChooseCandidate, OfTwoAlikeTakesTheOneExpected) {
  std::vector<LawFit> all{candidate("viscous", 0), candidate("viscous+pendulum", 3)};
  all[1].fitted = all[0].fitted;
  EXPECT_EQ(choose_candidate(all), 0u);
  EXPECT_EQ(choose_candidate(all, 0, law_with<Pendulum>), 1u);
}

TEST(ChooseCandidate, TakesNoneThatDidNotConverge) {
  for (const FitStatus status : {FitStatus::iteration_limit, FitStatus::undetermined, FitStatus::too_noisy})
    EXPECT_EQ(choice({candidate("viscous", 0), candidate("viscous+drag", -100, status)}), "viscous");
  EXPECT_EQ(choice({candidate("viscous", 0), candidate("viscous+drag", -100)}), "viscous+drag");
}

// One that ran away leaves nothing, and has no samples.
TEST(ChooseCandidate, ComparesByOneThatConverged) {
  LawFit ran_away;
  ran_away.law = law_of("viscous");
  ran_away.status = FitStatus::iteration_limit;
  EXPECT_EQ(choice({ran_away, candidate("viscous+cubic", 0), candidate("viscous+drag", -100)}),
            "viscous+drag");
  EXPECT_EQ(choice({ran_away, candidate("viscous+drag", -100), candidate("viscous+cubic", 0)}),
            "viscous+drag");
  // Nor is it the simpler law that a term must beat.
  EXPECT_EQ(
      choice({ran_away, candidate("viscous+cubic", 0), unsure(candidate("viscous+drag", -100), "drag")}),
      "viscous+cubic");
  EXPECT_EQ(choice({candidate("viscous", 0), unsure(candidate("viscous+drag", -100), "drag")}),
            "viscous+drag");
  std::vector<LawFit> none{ran_away, ran_away};
  EXPECT_EQ(choose_candidate(none), 0u);
}

// Damping that is less the wider the swing stands in for something else.
TEST(ChooseCandidate, TakesNoVanDerPolTermBelowZero) {
  LawFit falling = candidate("viscous+van-der-pol", -100);
  EXPECT_EQ(choice({candidate("viscous", 0), falling}), "viscous+van-der-pol");
  *falling.find("van_der_pol") = {-1, 0.4, -1.8, -0.2};
  EXPECT_EQ(choice({candidate("viscous", 0), falling}), "viscous");
  EXPECT_EQ(choice({candidate("viscous", 0), falling, candidate("viscous+drag", -50)}), "viscous+drag");
}

TEST(ChooseCandidate, TakesTheSimplerOfTwoWithinSix) {
  EXPECT_EQ(choice({candidate("viscous", 0), candidate("viscous+drag", -5.9)}), "viscous");
  EXPECT_EQ(choice({candidate("viscous", 0), candidate("viscous+drag", -6.1)}), "viscous+drag");
  // Two terms more, and one between.
  EXPECT_EQ(
      choice({candidate("viscous", 0), candidate("viscous+drag", -20), candidate("viscous+drag+cubic", -25)}),
      "viscous+drag");
  EXPECT_EQ(
      choice({candidate("viscous", 0), candidate("viscous+drag", -20), candidate("viscous+drag+cubic", -27)}),
      "viscous+drag+cubic");
}

TEST(ChooseCandidate, OfAsManyTermsTheOneMetOftenUnlessTheOtherIsClearlyBetter) {
  EXPECT_EQ(
      choice({candidate("viscous", 50), candidate("viscous+drag", 0), candidate("viscous+cubic", -4.9)}),
      "viscous+drag");
  EXPECT_EQ(
      choice({candidate("viscous", 50), candidate("viscous+drag", 0), candidate("viscous+cubic", -5.1)}),
      "viscous+cubic");
}

TEST(ChooseCandidate, ATermThatMayBeNoneMustBeWorthSix) {
  const LawFit drag = unsure(candidate("viscous+drag", -20), "drag");
  EXPECT_EQ(choice({candidate("viscous", -14.1), drag}), "viscous");
  EXPECT_EQ(choice({candidate("viscous", -13.9), drag}), "viscous+drag");
  // A law whose simpler ones were not tried is not admissible.
  EXPECT_EQ(choice({candidate("friction", 100), drag}), "friction");
  // Nor one with two such terms of which one is worth nothing, however low it is.
  const LawFit both = unsure(unsure(candidate("viscous+drag+cubic", -60), "drag"), "cubic");
  EXPECT_EQ(
      choice({candidate("viscous", 0), candidate("viscous+drag", -58), candidate("viscous+cubic", 0), both}),
      "viscous+drag");
}

TEST(WithoutUnsureTerms, LeavesOutWhatMayBeNoneAndCanBeLeftOut) {
  EXPECT_THAT(without_unsure_terms(candidate("viscous+drag+cubic", 0)), IsEmpty());
  EXPECT_THAT(without_unsure_terms(unsure(candidate("viscous+drag", 0), "drag")),
              ElementsAre(law_of("viscous")));
  EXPECT_THAT(without_unsure_terms(unsure(candidate("viscous+drag", 0), "decay_rate")),
              ElementsAre(law_of("drag")));
  // A lone damping may be as small as it is.
  EXPECT_THAT(without_unsure_terms(unsure(candidate("viscous+cubic", 0), "decay_rate")), IsEmpty());
  EXPECT_THAT(without_unsure_terms(unsure(candidate("viscous+cubic", 0), "cubic")),
              ElementsAre(law_of("viscous")));
}

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

SyntheticRecord record_of(const TrueSwing& truth, std::size_t n, double h, double noise, unsigned seed) {
  SyntheticRecord record{even_times(n, h), {}, 0};
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0, noise);
  for (const double x : free_motion(truth, record.t, 0.01).x) record.y.push_back(x + normal(engine));
  return record;
}

// Viscous damping and drag over so short a time that each could be the other: the coefficients are off by
// many of their errors, and what the record does know holds.
TEST(RivalLaws, AShortRecordDoesNotTellViscousFromDrag) {
  const TrueSwing truth{.angular_frequency = 8.944, .decay_rate = 0.01, .drag = 0.15, .position = 0.05};
  int said = 0, simple = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const SyntheticRecord record = record_of(truth, 701, 0.02, 1e-3, seed);
    Record metres = record.record();
    metres.unit = "m";
    const LawChoice choice = choose_law(metres, {});
    if (choice.chosen.law == law_of("viscous+drag")) continue;
    ++simple;
    for (const std::string& notice : in_words(choice.chosen.notices))
      if (notice.find("cannot tell") != std::string::npos) {
        ++said;
        EXPECT_THAT(notice, testing::ContainsRegex("\u00a01/(s|m)[,)]"));
      }
    const MeanDecay decay = mean_decay(choice.chosen, record.record()).value();
    const double amplitude = decay.amplitude;
    const double true_rate = 0.01 + 4 * 0.15 * 8.944 / (3 * 3.14159265) * amplitude;
    EXPECT_NEAR(decay.rate.value, true_rate, 4 * decay.rate.standard_error + 0.02 * true_rate) << seed;
  }
  EXPECT_GE(simple, 5);
  EXPECT_GE(said, simple - 1);
}

TEST(RivalLaws, OfAsManyTermsTheClearlyLowestWins) {
  const TrueSwing truth{.angular_frequency = 8.944, .drag = 0.3, .position = 0.05};
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const LawChoice choice = choose_law(record_of(truth, 500, 0.02, 1e-3, seed).record(), {});
    for (const LawFit& other : choice.candidates)
      if (other.names.size() == choice.chosen.names.size() && other.status == FitStatus::converged) {
        EXPECT_GE(other.bic, choice.chosen.bic - 5) << seed << " " << to_text(other.law);
      }
  }
}

TEST(RivalLaws, NoneWhereTheRecordTells) {
  const TrueSwing truth{.angular_frequency = 8.944, .decay_rate = 0.02, .drag = 0.5, .position = 0.05};
  const LawChoice choice = choose_law(record_of(truth, 12000, 0.02, 2e-4, 1).record(), {});
  EXPECT_EQ(to_text(choice.chosen.law), "viscous+drag");
  EXPECT_THAT(in_words(choice.chosen.notices), Not(Contains(HasSubstr("cannot tell"))));
}

// A rival is named where another number or another damping would follow from it, not for its name alone.
TEST(RivalLaws, NoneWhereNoNumberWouldMove) {
  const SyntheticRecord record = viscous_record({}, even_times(2000, 0.01), 1e-3);
  std::vector<LawFit> candidates{fit_law(record.record(), {.law = law_of("viscous+cubic")})};
  ASSERT_EQ(candidates[0].status, FitStatus::converged);
  LawFit rival = candidates[0];
  rival.law = law_of("viscous+odd-quadratic");
  *std::find(rival.names.begin(), rival.names.end(), "cubic") = "odd_quadratic";
  rival.bic = candidates[0].bic + 1;
  candidates.push_back(rival);
  EXPECT_EQ(in_words(rival_laws(record.record(), candidates, 0)), "");
  candidates[1].find("decay_rate")->value += 4 * rival.decay_rate().standard_error;
  EXPECT_THAT(in_words(rival_laws(record.record(), candidates, 0)), HasSubstr("viscous+odd-quadratic"));
  candidates[1].bic = candidates[0].bic + 6.1;
  EXPECT_EQ(in_words(rival_laws(record.record(), candidates, 0)), "");
  // Another damping is another number.
  candidates[1] = rival;
  candidates[1].law = law_of("drag+cubic");
  EXPECT_THAT(in_words(rival_laws(record.record(), candidates, 0)), HasSubstr("drag+cubic"));
}

// The rate that drag makes is proportional to the amplitude: noise of a quarter of it must not count.
TEST(MeanDecay, IsThatAtTheSwingsAmplitudeWhateverTheNoise) {
  const TrueSwing truth{.angular_frequency = 8.944, .decay_rate = 0, .drag = 2, .position = 0.05};
  const SyntheticRecord quiet = record_of(truth, 1201, 0.03, 1e-6, 1);
  const double amplitude = sinusoid_amplitude(quiet.y), rate = 4 * 2 * 8.944 / (3 * 3.14159265) * amplitude;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const SyntheticRecord record = record_of(truth, 1201, 0.03, 0.0125, seed);
    const LawFit fit = fit_law(record.record(), {.law = law_of("drag")});
    ASSERT_EQ(fit.status, FitStatus::converged) << seed;
    const MeanDecay decay = mean_decay(fit, record.record()).value();
    EXPECT_NEAR(decay.amplitude, amplitude, 0.15 * amplitude) << seed;
    EXPECT_NEAR(decay.rate.value, rate, 3.5 * decay.rate.standard_error) << seed;
  }
}

TEST(MeanDecay, IsKnownWhereItsPartsAreNot) {
  const SyntheticRecord record =
      viscous_record({.w0 = 9.09, .g = 0.005, .position = 0.03, .velocity = 0}, even_times(2001, 0.01), 3e-4);
  const LawFit fit = fit_law(record.record(), {.law = law_of("viscous+drag")});
  ASSERT_EQ(fit.status, FitStatus::converged);
  EXPECT_TRUE(dampings_are_collinear(fit));
  const MeanDecay decay = mean_decay(fit, record.record()).value();
  EXPECT_NEAR(decay.rate.value, 0.005, 4 * decay.rate.standard_error);
  EXPECT_LT(decay.rate.standard_error, 2e-4);
  EXPECT_THAT(in_words(fit.notices), Not(Contains(HasSubstr("shows no viscous"))));
  EXPECT_THAT(in_words(fit.notices), Contains(HasSubstr("cannot be told apart")));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
