// Grids of a sweep: the method's settings, one point, either direction, and what is said of points.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <set>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/sweep/sweep.h"
#include "sweep_options.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(SweepGrids, TheMethodsOwnSettingsTakeGrids) {
  // Newmark's gamma above 1/2 damps: each row against a run of its own, whatever else is in the grid.
  SweepOptions options = options_with({{"position", "0.5,1"},
                                       {"cubic", "0.3"},
                                       {"until", "10"},
                                       {"step", "0.05"},
                                       {"beta", "0.25,0.4"},
                                       {"gamma", "0.5,0.6,0.7"}},
                                      "newmark");
  options.measure = {"final"};
  const SweepResult result = swept(options);
  EXPECT_THAT(result.plan.rows.columns,
              ElementsAre("beta", "gamma", "position (m)", "x (m)", "v (m/s)", "status"));
  ASSERT_EQ(result.rows.size(), 12u * 5);
  std::set<double> ends;
  for (std::size_t at = 0; at < result.rows.size(); at += 5) {
    const double* row = &result.rows[at];
    SimulateOptions one{.law = {.cubic = 0.3}, .position = row[2]};
    one.method = {"newmark"};
    one.beta = row[0];
    one.gamma = row[1];
    one.step = 0.05;
    one.until = 10;
    const auto run = simulate(one);
    ASSERT_TRUE(run);
    EXPECT_NEAR(row[3], run->runs[0].outcome.y.x, 1e-12);
    EXPECT_NEAR(row[4], run->runs[0].outcome.y.v, 1e-12);
    ends.insert(row[3]);
  }
  EXPECT_EQ(ends.size(), 12u);
}

TEST(SweepGrids, ClosedFormsFollowTheSettingsOfTheirPoint) {
  // Each against the sweep with that setting alone, through the boundaries of chunks.
  const Values law = with(driven, {{"drive-frequency", "0.2:3:3001"}, {"step", "0.1"}});
  const SweepResult all = swept(options_with(with(law, {{"rho-inf", "0,0.5,1"}}), "generalized-alpha"));
  EXPECT_EQ(in_words(all.plan.way), "closed form");
  EXPECT_LT(all.plan.rows.rows_per_chunk, all.plan.rows.rows);
  const char* const values[] = {"0", "0.5", "1"};
  for (std::size_t k = 0; k < 3; ++k) {
    const SweepResult one = swept(options_with(with(law, {{"rho-inf", values[k]}}), "generalized-alpha"));
    for (std::size_t i = 0; i < 3001; ++i)
      ASSERT_EQ(all.rows[4 * (3001 * k + i) + 2], one.rows[3 * i + 1]) << k << " " << i;
  }
  EXPECT_GT(std::abs(all.rows[4 * 1000 + 2] / all.rows[4 * 7002 + 2] - 1), 1e-6);
}

TEST(SweepGrids, ATighterToleranceIsNearerTheTruth) {
  SweepOptions options =
      options_with({{"damping", "0.1"}, {"until", "20"}, {"tolerance", "1e-3,1e-6,1e-9"}}, "dormand-prince");
  options.measure = {"final"};
  const SweepResult result = swept(options);
  const double w = std::sqrt(1 - 0.05 * 0.05);
  const double truth = std::exp(-1.0) * (std::cos(20 * w) + 0.05 / w * std::sin(20 * w));
  double before = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double error = std::abs(result.rows[3 * i + 1] - truth);
    EXPECT_LT(error, before / 100);
    before = error;
  }
  EXPECT_LT(before, 1e-7);
}

TEST(SweepGrids, ChainsKeepToTheSettingsOfTheirPoint) {
  const Values law{{"damping", "0.1"},
                   {"cubic", "0.3"},
                   {"drive-amplitude", "0.3"},
                   {"step", "0.05"},
                   {"drive-frequency", "0.9:1.3:9"}};
  const auto chains = [&](const std::string& gamma, int threads) {
    SweepOptions options = options_with(with(law, {{"gamma", gamma}}), "newmark");
    options.direction = "up";
    options.threads = threads;
    return swept(options);
  };
  const SweepResult both = chains("0.5,0.6", 1), other = chains("0.5,0.6", 3), second = chains("0.6", 1);
  EXPECT_EQ(std::memcmp(both.rows.data(), other.rows.data(), both.rows.size() * sizeof(double)), 0);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(both.rows[4 * (9 + i) + 2], second.rows[3 * i + 1]);
  EXPECT_NE(both.rows[4 * 4 + 2], both.rows[4 * 13 + 2]);
}

TEST(SweepGrids, AGridOfOneValueIsASweepOfOnePoint) {
  for (const char* grid : {"1", "1:1:1"}) {
    const SweepResult one = swept(options_with(with(driven, {{"drive-frequency", grid}}), "exact"));
    EXPECT_EQ(one.plan.rows.rows, 1u);
    EXPECT_THAT(one.plan.rows.columns,
                ElementsAre("drive_frequency (rad/s)", "amplitude (m)", "phase (rad)", "status"));
    EXPECT_NEAR(one.rows[1], 5, 1e-13);
  }
  // A range stays a column beside others; a value alone does not.
  const SweepResult both =
      swept(options_with(with(driven, {{"damping", "0.1:0.1:1"}, {"drive-phase", "0.2"}}), "exact"));
  EXPECT_EQ(both.plan.rows.columns[0], "damping (kg/s)");
  EXPECT_EQ(both.plan.rows.rows, 57u);
  // A term that is swept only at 0 is absent.
  EXPECT_EQ(in_words(swept(options_with(with(driven, {{"cubic", "0:0:1"}}))).plan.way), "closed form");
  const SweepResult free = swept(options_with({{"position", "0.5"}, {"until", "3"}}, "exact"));
  EXPECT_THAT(free.plan.rows.columns, ElementsAre("position (m)", "until (s)", "peak (m)", "x (m)", "v (m/s)",
                                                  "energy (J)", "status"));
  EXPECT_NEAR(free.rows[3], 0.5 * std::cos(3), 1e-14);
}

TEST(SweepGrids, GridsThatRunDownKeepTheirOrder) {
  const SweepResult up = swept(options_with(with(driven, {{"drive-frequency", "0.2:5:9:log"}})));
  const SweepResult down = swept(options_with(with(driven, {{"drive-frequency", "5:0.2:9:log"}})));
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(down.rows[3 * i] / up.rows[3 * (8 - i)], 1, 1e-14);
    EXPECT_NEAR(down.rows[3 * i + 1] / up.rows[3 * (8 - i) + 1], 1, 1e-12);
  }
  // Where points follow each other it is the values that rise or fall, not the rows.
  const Values law{{"damping", "0.05"}, {"cubic", "0.3"}, {"drive-amplitude", "0.3"}, {"step", "0.05"}};
  for (const char* direction : {"up", "down"}) {
    SweepOptions rising = options_with(with(law, {{"drive-frequency", "1:2:21"}}), "rk4");
    SweepOptions falling = options_with(with(law, {{"drive-frequency", "2:1:21"}}), "rk4");
    rising.direction = falling.direction = direction;
    const SweepResult a = swept(rising), b = swept(falling);
    for (std::size_t i = 0; i < 21; ++i)
      EXPECT_NEAR(a.rows[3 * i + 1], b.rows[3 * (20 - i) + 1], 1e-5 * a.rows[3 * i + 1]) << direction << i;
  }
}

TEST(SweepGrids, TheEndsOfAGridAreItsLowestAndHighestValues) {
  // Rising, falling, or with the end in the middle: what is driven, refused and said is the same.
  for (const char* amplitudes : {"0:1:3", "1:0:3", "1,0,2"})
    EXPECT_THAT(refusal(options_with(with(driven, {{"drive-amplitude", amplitudes}}))),
                HasSubstr("--drive-amplitude: at 0 nothing swings"))
        << amplitudes;
  for (const char* frequencies : {"0:2:3", "2:0:3", "1,0,2"})
    EXPECT_THAT(refusal(options_with(with(driven, {{"drive-frequency", frequencies}}))),
                HasSubstr("--drive-frequency: at 0 nothing swings"))
        << frequencies;
  for (const char* frequencies : {"1:50:3", "50:1:3", "1,50,2"})
    EXPECT_THAT(in_words(swept(options_with(
                                   with(driven, {{"drive-frequency", frequencies}, {"step", "0.05"}}), "rk4"))
                             .plan.notices),
                Contains(HasSubstr("has only 2.5 steps")))
        << frequencies;
  for (const char* steps : {"0.01,0.5", "0.5,0.01", "0.01,0.5,0.02"})
    EXPECT_THAT(in_words(swept(options_with(with(driven, {{"step", steps}}), "forward-euler")).plan.notices),
                Contains(HasSubstr("--step: 0.5 s is beyond the stability limit")))
        << steps;
}

TEST(SweepGrids, SaysHowLongStepsAndRunsAre) {
  const auto steps = [](const Values& values, std::string method = "") {
    return in_words(swept(options_with(values, std::move(method))).plan.steps);
  };
  const std::string usual = "200 steps in a natural or a drive period, whichever is shorter";
  EXPECT_EQ(steps(driven), usual);
  EXPECT_EQ(steps(with(driven, {{"step", "0.05"}})), "steps of 0.05 s");
  EXPECT_EQ(steps(with(driven, {{"step", "0.05,0.1"}})), "");
  EXPECT_EQ(steps(driven, "exact"), "");
  const Values free{{"position", "1,2"}};
  EXPECT_EQ(steps(free), "200 steps in a natural period, for 20 natural periods");
  EXPECT_EQ(steps(with(free, {{"until", "3"}, {"step", "0.1"}})), "steps of 0.1 s, to 3 s");
  EXPECT_EQ(steps(with(free, {{"until", "3,4"}, {"step", "0.1"}})), "steps of 0.1 s");
  // The defaults are these: a point of its own at that step and end has the same bits.
  const double period = 2 * std::acos(-1.0), step = period / 200, until = 20 * period;
  const SweepResult named = swept(options_with(
      with(free, {{"step", fmt::format("{:.17g}", step)}, {"until", fmt::format("{:.17g}", until)}})));
  EXPECT_EQ(swept(options_with(free)).rows, named.rows);
  // Once such a default has changed, a file cannot be continued: it belongs to another sweep.
  EXPECT_THAT(swept(options_with(free)).plan.rows.description,
              AllOf(HasSubstr("\"steps_per_period\": 200"), HasSubstr("\"periods\": 20")));
}

TEST(SweepGrids, ARunToItsEndMayHaveNoDrive) {
  for (const char* amplitudes : {"0:1:3", "1:0:3"}) {
    SweepOptions options = options_with(
        with(driven, {{"drive-amplitude", amplitudes}, {"drive-frequency", "1"}, {"until", "3"}}));
    options.measure = {"final"};
    EXPECT_EQ(refusal(options), "not refused") << amplitudes;
    EXPECT_THAT(in_words(swept(options).plan.notices), IsEmpty()) << amplitudes;
    options.simulate.law.friction = 0.1;
    EXPECT_EQ(refusal(options), "not refused") << amplitudes << ", rubbing";
  }
}

TEST(SweepGrids, SaysWhichOfStepAndEndAPointLacks) {
  const auto said = [](const Values& more) {
    return refusal(options_with(with({{"stiffness", "1,0,2"}}, more)));
  };
  EXPECT_THAT(said({}), HasSubstr("give --step and --until"));
  EXPECT_THAT(said({{"until", "100"}}), EndsWith("give --step"));
  EXPECT_THAT(said({{"step", "0.1"}}), EndsWith("give --until"));
  EXPECT_THAT(said({{"step", "0.1"}}), HasSubstr("--stiffness 0 N/m"));
  EXPECT_EQ(said({{"step", "0.1"}, {"until", "100"}}), "not refused");
  EXPECT_THAT(refusal(options_with({{"stiffness", "-1,0,1"}, {"until", "100"}})), EndsWith("give --step"));
}

TEST(SweepGrids, SaysWhatItCannotCheck) {
  const auto said = [](SweepOptions options) {
    options.check = true;
    const SweepResult result = swept(options);
    EXPECT_FALSE(result.check && result.check->points > 0);
    std::string all;
    for (const auto& notice : in_words(result.plan.notices)) all += notice + "\n";
    return all + (result.check ? in_words(result.check->why) : "");
  };
  const Values two = with(driven, {{"drive-frequency", "0.5,2"}});
  EXPECT_THAT(said(options_with(two, "exact")), HasSubstr("exact is the closed form"));
  EXPECT_THAT(said(options_with(with(two, {{"cubic", "0.1"}}))), HasSubstr("the law is not linear"));
  EXPECT_THAT(said(options_with({{"position", "1,2"}})), HasSubstr("stepped to an end"));
  SweepOptions settle = options_with(two);
  settle.settle = 20;
  EXPECT_THAT(said(settle), HasSubstr("--settle asks for stepping"));
  SweepOptions final = options_with(two);
  final.measure = {"final"};
  EXPECT_THAT(said(final), HasSubstr("final comes from stepping alone"));
  EXPECT_THAT(said(options_with(with(two, {{"damping", ""}}))), HasSubstr("without damping"));
  SweepOptions some = options_with(with(two, {{"damping", "0,0.1"}}));
  some.check = true;
  const SweepResult half = swept(some);
  EXPECT_EQ(half.check->points, 2u);
  EXPECT_EQ(half.check->left_out, 2u);
  EXPECT_EQ(half.check->first_left_out, 0u);
}

TEST(SweepGrids, GridsMultiplyAndTheFrequencyRunsFastest) {
  const SweepResult result = swept(options_with(with(driven, {{"drive-frequency", "1,2"},
                                                              {"drive-phase", "0,1"},
                                                              {"damping-ratio", "0.1,0.2,0.3"},
                                                              {"damping", ""}})));
  EXPECT_EQ(result.plan.rows.rows, 12u);
  EXPECT_EQ(result.plan.swept[0].name, "damping-ratio");
  EXPECT_EQ(result.plan.swept[2].name, "drive-frequency");
  EXPECT_EQ(result.rows[2], 1);
  EXPECT_EQ(result.rows[5 + 2], 2);
  EXPECT_EQ(result.rows[5 + 1], 0);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
