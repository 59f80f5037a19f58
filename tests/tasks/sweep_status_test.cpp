// Points that do not simply settle: each has its status, and notices say what is odd.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Values = std::map<std::string_view, std::string>;

SweepResult swept(Values values, std::string method, std::optional<double> settle = {},
                  std::vector<std::string> measure = {}) {
  SweepOptions options;
  options.values = std::move(values);
  options.simulate.method = {std::move(method)};
  options.settle = settle;
  options.measure = std::move(measure);
  auto result = sweep(options);
  if (!result) throw std::runtime_error(in_words(result.error()));
  return *std::move(result);
}

std::vector<std::string> words(const SweepResult& result) {
  std::vector<std::string> words;
  for (const unsigned char status : result.statuses) words.emplace_back(status_word(result.plan, status));
  return words;
}

const Values drive{{"drive-amplitude", "1"}, {"drive-frequency", "0.5,2"}};

Values with(Values values, const Values& more) {
  for (const auto& [name, value] : more) values[name] = value;
  return values;
}

TEST(SweepStatus, ADamperThatFeedsSettlesByTheMethodsOwnDampingAlone) {
  const Values fed = with(drive, {{"stiffness", "9"}, {"damping", "-0.02"}, {"step", "0.05"}});
  EXPECT_THAT(words(swept(fed, "exact")), ElementsAre("unstable", "unstable"));
  const SweepResult held = swept(fed, "implicit-euler");
  EXPECT_EQ(held.counts.own_damping, 2u);
}

TEST(SweepStatus, ASpringThatPushesAwayIsUnstableByAnyMethod) {
  for (const char* method : {"exact", "verlet", "rk4", "euler-cromer", "dormand-prince", "newmark"})
    for (const std::optional<double> settle : {std::optional<double>(), std::optional<double>(4)}) {
      const SweepResult away =
          swept(with(drive, {{"stiffness", "-1"}, {"damping", "0.1"}, {"step", "0.05"}}), method, settle);
      EXPECT_THAT(words(away), ElementsAre("unstable", "unstable")) << method << settle.has_value();
      EXPECT_EQ(away.counts.unstable, 2u) << method;
      EXPECT_EQ(away.counts.not_settled, 0u) << method;
      EXPECT_FALSE(away.counts.ok());
      EXPECT_TRUE(std::isnan(away.rows[1])) << method;
    }
}

TEST(SweepStatus, BeyondItsStabilityLimitAMethodIsUnstable) {
  // verlet: w h < 2.
  const SweepResult steps =
      swept({{"drive-amplitude", "1"}, {"drive-frequency", "0.3"}, {"damping", "0.01"}, {"step", "1.9,2.1"}},
            "verlet");
  EXPECT_THAT(words(steps), ElementsAre("settled", "unstable"));
  EXPECT_EQ(status_counts(steps), "2 points: 1 settled, 1 unstable");
}

TEST(SweepStatus, UndampedNothingSettlesButByTheMethodsOwnDamping) {
  for (const char* method :
       {"exact", "verlet", "euler-cromer", "yoshida4", "implicit-midpoint", "gauss-legendre4", "newmark"}) {
    const SweepResult free = swept(drive, method);
    EXPECT_THAT(words(free), ElementsAre("not_settled", "not_settled")) << method;
  }
  // A free mass is pushed along: that is no runaway of the method.
  EXPECT_THAT(words(swept(with(drive, {{"stiffness", "0"}, {"step", "0.01"}}), "verlet")),
              ElementsAre("not_settled", "not_settled"));
  // With a damper its motion settles, about a place that depends on the start: F/(w sqrt(m^2 w^2 + c^2)).
  for (const char* method : {"exact", "rk4"}) {
    const SweepResult pushed = swept(with(drive, {{"stiffness", "0"}, {"damping", "0.3"}, {"step", "0.01"}}),
                                     method, {}, {"amplitude,phase,mean"});
    EXPECT_THAT(words(pushed), ElementsAre("settled", "settled")) << method;
    for (std::size_t at = 0; at < pushed.rows.size(); at += 4) {
      const double w = pushed.rows[at];
      EXPECT_NEAR(pushed.rows[at + 1] * w * std::hypot(w, 0.3), 1, 1e-4) << method;
      EXPECT_NEAR(pushed.rows[at + 2], std::numbers::pi - std::atan(0.3 / w), 1e-4) << method;
      // From rest at 0 momentum and damping balance: m v + c x = F sin(w t)/w, whose mean is 0.
      EXPECT_NEAR(pushed.rows[at + 3], 0, 1e-4) << method;
    }
  }
  const SweepResult own = swept(with(drive, {{"drive-frequency", "0.5,0.9"}, {"step", "0.1"}}), "rk4");
  EXPECT_THAT(words(own), ElementsAre("settled_by_own_damping", "settled_by_own_damping"));
  EXPECT_TRUE(own.counts.ok());
  EXPECT_NEAR(own.rows[1], 4.0 / 3, 1e-5);
  // |R(i y)|^2 = 1 - y^6/72 + y^8/576 (Hairer & Wanner II, IV.2): the decay rate is -ln |R| / h.
  const double h = 0.1, y6 = std::pow(h, 6);
  const double rate = -std::log1p(-y6 / 72 + y6 * h * h / 576) / (2 * h);
  const auto said = in_words(notices_of(own));
  ASSERT_EQ(said.size(), 1u);
  char number[100];
  std::snprintf(number, sizeof number, "decay rate %.2g 1/s at drive-frequency 0.5", rate);
  EXPECT_THAT(said[0], HasSubstr(number));
  EXPECT_THAT(said[0], HasSubstr("2 of 2 points have no damping in the law"));
  // Stepped, the amplitude at the drive's frequency stands still while the free motion goes on.
  const std::vector<std::string> with_end{"amplitude", "final"};
  const SweepResult stepped = swept(with(drive, {{"drive-frequency", "0.3,0.5"}}), "rk4", {}, with_end);
  EXPECT_EQ(in_words(stepped.plan.way), "stepped until settled");
  EXPECT_THAT(words(stepped), ElementsAre("not_settled", "not_settled"));
  EXPECT_TRUE(std::isnan(stepped.rows[2]));
  EXPECT_THAT(words(swept(with(drive, {{"step", "0.1"}}), "implicit-euler", {}, with_end)),
              ElementsAre("settled_by_own_damping", "settled_by_own_damping"));
  // With damping there is nothing to say.
  EXPECT_THAT(in_words(notices_of(swept(with(drive, {{"damping", "0.1"}}), "rk4"))), IsEmpty());
}

TEST(SweepStatus, LagsOutsideZeroToPiAreKeptAndCounted) {
  // Forward Euler's resonance curve: x lags the force by the argument of w0^2 + q^2 + c q with
  // q = (e^{i W h} - 1)/h, which beyond resonance is pi and some.
  const double h = 0.02, c = 0.2;
  const Values law{
      {"damping", "0.2"}, {"drive-amplitude", "1"}, {"drive-frequency", "0.5,3,40"}, {"step", "0.02"}};
  const SweepResult result = swept(law, "forward-euler");
  std::uint64_t outside = 0;
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::complex<double> q = (std::polar(1.0, result.rows[3 * i] * h) - 1.0) / h;
    double lag = std::arg(1.0 + q * q + c * q);
    if (lag < -std::numbers::pi / 2) lag += 2 * std::numbers::pi;  // the branch around pi/2
    EXPECT_NEAR(result.rows[3 * i + 2], lag, 1e-11);
    outside += lag < 0 || lag > std::numbers::pi;
    most = std::max(most, lag - std::numbers::pi);
  }
  ASSERT_GE(outside, 1u);
  EXPECT_GT(most, 0.3);
  EXPECT_EQ(result.counts.phase_outside, outside);
  EXPECT_NEAR(result.counts.phase_excess, most, 1e-11);
  EXPECT_THAT(in_words(notices_of(result).back()), HasSubstr("of 3 points lies outside 0 to pi"));
  EXPECT_THAT(in_words(notices_of(result).back()), HasSubstr("at drive-frequency 40"));
  // Stepped, the same branch.
  const SweepResult stepped = swept(law, "forward-euler", 200);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(stepped.rows[3 * i + 2], result.rows[3 * i + 2], 1e-6);
  EXPECT_EQ(swept(law, "exact").counts.phase_outside, 0u);
  // The lag of a motion that has not settled can be anything; the method alone is not to blame.
  const SweepResult early = swept(
      {{"damping", "0.01"}, {"drive-amplitude", "1"}, {"drive-frequency", "0.8:0.99:20"}, {"velocity", "1"}},
      "rk4", 1);
  ASSERT_GT(early.counts.phase_outside, 0u);
  EXPECT_THAT(in_words(notices_of(early).back()),
              HasSubstr("after 1 cycles the free motion may still be there"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
