// The choice among laws, on candidates made by hand: who is admissible, and who wins at, below and above each
// limit.
#include "cromer/identify/choose/criterion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace cromer::core {
namespace {

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

TEST(ChooseCandidate, TakesNoneThatDidNotConverge) {
  for (const FitStatus status : {FitStatus::iteration_limit, FitStatus::undetermined, FitStatus::too_noisy})
    EXPECT_EQ(choice({candidate("viscous", 0), candidate("viscous+drag", -100, status)}), "viscous");
  EXPECT_EQ(choice({candidate("viscous", 0), candidate("viscous+drag", -100)}), "viscous+drag");
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

}  // namespace
}  // namespace cromer::core
