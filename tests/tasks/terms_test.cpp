// The registry's terms through the tasks: options, every method, sweeps, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "cromer/documents/words/words.h"
#include "cromer/methods/all.h"
#include "cromer/model/law.h"
#include "cromer/model/terms/term.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/simulate/simulate_setup.h"
#include "cromer/tasks/sweep/sweep.h"
#include "sweep_options.h"
#include "tests/support/simulated.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::HasSubstr;

std::string refused(const SimulateOptions& options) {
  const auto result = simulate(options);
  return result ? "" : in_words(result.error());
}

const SimulateOptions yielding{
    .law = {.hysteresis_stiffness = 5, .hysteresis_beta = 3, .hysteresis_gamma = 1}, .velocity = 2};

TEST(TermsInTasks, AreOptionsOfSimulate) {
  for_each_term([]<class T>() {
    for (std::size_t i = 0; i < coefficients_of<T>; ++i) {
      SimulateOptions options;
      bool found = false;
      for (const Option& option : options_of(options)) {
        if (option.name != T::coefficients[i].option) continue;
        found = true;
        EXPECT_EQ(option.unit, unit_of(T::coefficients[i]));
        EXPECT_TRUE(assign(option, "0.25"));
        const auto oscillator = oscillator_of(options);
        ASSERT_TRUE(oscillator);
        EXPECT_EQ((*oscillator).*T::template members<double>[i], 0.25) << option.name;
        EXPECT_EQ(bool(assign(option, "-0.25")), T::coefficients[i].sign != Sign::not_negative)
            << option.name;
      }
      EXPECT_TRUE(found) << T::coefficients[i].option;
    }
  });
}

TEST(TermsInTasks, AreSteppedByEveryMethodAndRefusedByExact) {
  for_each_term([]<class T>() {
    if constexpr (!linear_terms.has<T>() && !std::is_same_v<T, Friction>) {
      SimulateOptions options;
      for (std::size_t i = 0; i < coefficients_of<T>; ++i) options.law.*T::template members<double>[i] = 0.3;
      options.until = 6;
      options.step = 0.002;
      std::optional<State<double>> reference;
      options.method = {"dormand-prince"};
      reference = simulated(options).runs.front().outcome.y;
      for (const MethodInfo& info : method_infos) {
        options.method = {std::string(info.name)};
        if (info.is_exact()) {
          EXPECT_THAT(refused(options), HasSubstr("no closed form with " + std::string(T::info.name)));
          EXPECT_THAT(refused(options), HasSubstr("0.3 " + unit_of(T::coefficients[0])));
          continue;
        }
        const State<double> y = simulated(options).runs.front().outcome.y;
        const double off = std::hypot(y.x - reference->x, y.v - reference->v);
        EXPECT_LT(off, info.order == 1 ? 0.03 : 1e-5) << T::info.name << ' ' << info.name;
      }
    }
  });
}

TEST(TermsInTasks, SetTheNaturalPeriod) {
  const double turn = 2 * std::numbers::pi;
  EXPECT_DOUBLE_EQ(natural_period({.mass = 2, .stiffness = 0, .pendulum = 18}), turn / 3);
  EXPECT_DOUBLE_EQ(natural_period({.stiffness = 4, .hysteresis_stiffness = 5}), turn / 3);
  // -x + x^5: at x = 1 the stiffness is 4.
  EXPECT_NEAR(natural_period({.stiffness = -1, .quintic = 1}), turn / 2, 1e-12);
  // -x - x^2: the well lies at x = -1, and its stiffness is 1.
  EXPECT_NEAR(natural_period({.stiffness = -1, .quadratic = -1}), turn, 1e-12);
  EXPECT_EQ(natural_period({.stiffness = 0, .quintic = 1}), 0);
  EXPECT_THAT(refused({.stiffness = 0, .law = {.quintic = 2}}), HasSubstr("quintic 2 N/m^5"));
}

TEST(TermsInTasks, HysteresisSaysWhatItIsNotRunWith) {
  SimulateOptions options = yielding;
  EXPECT_EQ(refused(options), "");
  EXPECT_FALSE(simulated(options).runs.front().energy_balance);
  options.law.friction = 0.1;
  EXPECT_THAT(refused(options), HasSubstr("--friction"));
  options = yielding;
  options.compensated = true;
  EXPECT_THAT(refused(options), HasSubstr("--compensated"));
  options = yielding;
  options.event = {"turning-point"};
  EXPECT_THAT(refused(options), HasSubstr("--event"));
  options = yielding;
  options.law.hysteresis_exponent = 0.5;
  EXPECT_THAT(refused(options), HasSubstr("--hysteresis-exponent: it must be at least 1"));
}

TEST(TermsInTasks, HysteresisWithoutItsStiffnessIsNone) {
  SimulateOptions options = yielding;
  options.law.hysteresis_stiffness = 0;
  EXPECT_THAT(in_words(simulated(options).notices),
              testing::Contains("--hysteresis-beta has no effect without --hysteresis-stiffness"));
}

TEST(TermsInTasks, HysteresisTakesAPulseAndStays) {
  // After a pulse that made it slip the body rests where no spring alone would hold it.
  SimulateOptions options = yielding;
  options.velocity.reset();
  options.damping = 1;
  options.drive = "rectangular";
  options.drive_amplitude = 4;
  options.drive_start = 1;
  options.drive_duration = 2;
  options.until = 60;
  options.step = 0.01;
  options.method = {"dormand-prince", "rk4"};
  const auto result = simulated(options);
  const double rest = result.runs[0].outcome.y.x;
  EXPECT_GT(rest, 0.05);
  EXPECT_NEAR(result.runs[0].outcome.y.v, 0, 1e-6);
  EXPECT_NEAR(result.runs[1].outcome.y.x, rest, 1e-4);
}

TEST(TermsInTasks, HysteresisKeepsToTheJumpsOfEachDrive) {
  // Next to no hysteresis changes nothing, wherever the drive jumps or bends between two steps or at one.
  const SimulateOptions still{
      .stiffness = 9, .damping = 0.4, .drive_amplitude = 4, .position = 0, .until = 2};
  std::vector<SimulateOptions> drives(8, still);
  drives[0].drive = "step";
  drives[0].drive_start = 0.37;
  drives[1].drive = "rectangular";
  drives[1].drive_start = 0.31;
  drives[1].drive_duration = 0.06;  // between two steps
  drives[2].drive = "half-sine";
  drives[2].drive_start = 0.31;
  drives[2].drive_duration = 0.47;
  drives[3].drive = "chirp";
  drives[3].drive_frequency = {2};
  drives[3].drive_to = 9;
  drives[3].drive_start = 0.21;
  drives[3].drive_duration = 1.1;
  drives[4].drive_frequency = {3};
  for (const std::size_t i : {5u, 6u, 7u}) {
    drives[i].drive_amplitude = 0;
    drives[i].drive_file = "force.csv";
    drives[i].drive_record = DriveRecord{{0, 4, -1, 2, 0, 3, 1, 0, -4, 0, 0, 0}, i == 7 ? 0.23 : 0.2, {}};
  }
  drives[6].between_samples = "hold";
  for (SimulateOptions& options : drives) {
    options.step = 0.1;
    options.method = {"rk4", "newmark", "euler-cromer", "dormand-prince", "gauss-legendre4"};
    const SimulateResult plain = simulated(options);
    options.law.hysteresis_stiffness = 1e-9;
    const SimulateResult with = simulated(options);
    ASSERT_EQ(with.runs.size(), 5u);
    for (std::size_t m = 0; m < 5; ++m) {
      const Trajectory &one = with.runs[m].trajectory, &other = plain.runs[m].trajectory;
      ASSERT_EQ(one.t, other.t);
      for (std::size_t n = 0; n < one.size(); ++n)
        EXPECT_NEAR(one.x[n], other.x[n], 1e-8) << &options - drives.data() << ' ' << one.t[n] << ' ' << m;
    }
  }
}

TEST(TermsInTasks, RunLongInCompensatedSums) {
  for_each_term([]<class T>() {
    if constexpr (smooth_terms.has<T>()) {
      SimulateOptions options{.stiffness = 2};
      options.law.*T::template members<double>[0] = 0.3;
      options.method = {"rk4"};
      options.step = 0.01;
      options.until = 10;
      const State<double> plain = simulated(options).runs.front().outcome.y;
      options.compensated = true;
      const State<double> exact = simulated(options).runs.front().outcome.y;
      EXPECT_NEAR(exact.x, plain.x, 1e-13) << T::info.name;
      EXPECT_NEAR(exact.v, plain.v, 1e-13) << T::info.name;
    }
  });
}

TEST(TermsInTasks, AreSweptAsTheyAreRun) {
  for_each_term([]<class T>() {
    if constexpr (smooth_terms.has<T>() && !linear_terms.has<T>()) {
      const std::string name(T::coefficients[0].option);
      const SweepResult result = swept(options_with(
          {{"stiffness", "2"}, {"damping", "0.1"}, {name, "0.1,0.4"}, {"step", "0.01"}, {"until", "7"}},
          "rk4"));
      EXPECT_EQ(in_words(result.plan.way), "stepped to the end") << name;
      for (std::size_t i = 0; i < 2; ++i) {
        SimulateOptions one{.stiffness = 2, .damping = 0.1};
        const double value = result.rows[i * (result.rows.size() / 2)];
        one.law.*T::template members<double>[0] = value;
        one.method = {"rk4"};
        one.step = 0.01;
        one.until = 7;
        const State<double> y = simulated(one).runs.front().outcome.y;
        EXPECT_NEAR(result.rows[i * (result.rows.size() / 2) + 2], y.x, 1e-13) << name;
      }
    }
  });
  EXPECT_THAT(in_words(sweep_refusal("hysteresis-stiffness", "1,2")), HasSubstr("run it with simulate"));
  EXPECT_THAT(in_words(sweep_refusal("hysteresis-exponent", "2")), HasSubstr("run it with simulate"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
