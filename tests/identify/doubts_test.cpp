#include "cromer/identify/doubts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cromer/identify/choose_law.h"
#include "tests/identify/synthetic.h"

namespace cromer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> doubts_about(const SyntheticRecord& record) {
  const FreeDecay fit = choose_law(record.record(), {}).chosen;
  EXPECT_EQ(fit.status, FitStatus::converged) << fit.message;
  return doubts(record.record(), fit);
}

TEST(Doubts, NoneAboutAFreeDecay) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    EXPECT_THAT(doubts_about(viscous_record({}, even_times(6000, 0.01), 3e-4, 1e-4, seed)), IsEmpty());
    EXPECT_THAT(doubts_about(viscous_record({.g = 0.3}, even_times(6000, 0.01), 3e-4, 1e-4, seed)),
                IsEmpty());
    EXPECT_THAT(doubts_about(viscous_record({}, even_times(3000, 0.01), 2e-4, 1e-2, seed)), IsEmpty());
    EXPECT_THAT(doubts_about(viscous_record({.g = 0.05}, even_times(300, 0.1), 1e-3, 0, seed)), IsEmpty());
  }
}

TEST(Doubts, ASwingThatDoesNotDieDownMayBeDriven) {
  const SyntheticRecord record = viscous_record({.g = 0}, even_times(6000, 0.01), 3e-4, 1e-4);
  EXPECT_THAT(doubts_about(record), ElementsAre(HasSubstr("does not die down over 84 periods")));
  const SyntheticRecord few = viscous_record({.g = 0}, even_times(1000, 0.01), 3e-4, 1e-4);
  EXPECT_THAT(doubts_about(few), IsEmpty());  // fourteen periods prove nothing
}

TEST(Doubts, AnAmplitudeThatRisesIsNoFreeSwing) {
  SyntheticRecord beats = viscous_record({.g = 0.02}, even_times(6000, 0.01), 3e-4);
  for (std::size_t i = 0; i < beats.t.size(); ++i) beats.y[i] += 0.012 * std::sin(9.3 * beats.t[i]);
  EXPECT_THAT(doubts_about(beats), testing::Contains(HasSubstr("the amplitude rises")));
}

TEST(Doubts, FrictionIsNotDescribedByTheViscousLaw) {
  // x'' = -w0² x - f sgn(x'): half waves about ±f/w0², the amplitude falling by 2 f/w0² in each.
  constexpr double w0 = 8.849, shift = 1e-4;
  std::mt19937_64 engine(3);
  std::normal_distribution<double> normal(0, 5e-5);
  SyntheticRecord record{even_times(8000, 0.01), {}, 0};
  for (const double t : record.t) {
    const double half = std::floor(w0 * t / std::numbers::pi);
    const double side = std::fmod(half, 2) == 0 ? 1 : -1;
    const double amplitude = std::max(0.0, 0.05 - (2 * half + 1) * shift);
    record.y.push_back(side * shift + amplitude * std::cos(w0 * t) + normal(engine));
  }
  const FreeDecay viscous = fit_free_decay(record.record(), {.law = {}});
  EXPECT_THAT(doubts(record.record(), viscous), testing::Contains(HasSubstr("no law tried describes")));
  EXPECT_THAT(doubts_about(record), testing::IsEmpty());
}

}  // namespace
}  // namespace cromer
