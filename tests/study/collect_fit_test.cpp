// The named results of fits and comparisons: every number of handmade ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "tests/study/collected.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::NanSensitiveDoubleEq;

Estimate estimate(double of) { return {of, 0.1, of - 0.2, of + 0.2}; }

FittedRecording fitted() {
  FittedRecording lab;
  lab.file = "lab.csv";
  lab.series.quantity = "position";
  lab.samples = 3;
  lab.series.t = {0, 1, 2};
  lab.series.y = {3, 5, 4};
  lab.fit.names = {"angular_frequency", "equilibrium"};
  lab.fit.estimates = {estimate(2), estimate(4)};
  lab.fit.residual.rms = 0.5;
  lab.parameters = {{"angular_frequency", estimate(2), "rad/s"}, {"equilibrium", estimate(4), "m"}};
  lab.derived = {{"stiffness", estimate(8), "N/m"}};
  return lab;
}

TEST(CollectFit, HasEveryEstimateWithItsInterval) {
  FittedRecording lab = fitted();
  lab.options.mass = {Quantity{2, 0.5}};
  lab.keulegan_carpenter = estimate(6);
  Results results;
  collect("lab", lab, results);
  EXPECT_EQ(fact(results, "lab.file"), "lab.csv");
  EXPECT_EQ(fact(results, "lab.law"), "viscous");
  EXPECT_EQ(fact(results, "lab.samples"), "3");
  EXPECT_EQ(fact(results, "lab.rms"), "0.5 m");
  EXPECT_EQ(fact(results, "lab.angular_frequency"), "2 +- 0.1 rad/s");
  EXPECT_EQ(fact(results, "lab.stiffness.low"), "7.8 N/m");
  EXPECT_EQ(fact(results, "lab.stiffness.high"), "8.2 N/m");
  EXPECT_EQ(fact(results, "lab.mass"), "2 +- 0.5 kg");
  EXPECT_EQ(fact(results, "lab.disc_diameter"), "none");
  EXPECT_EQ(fact(results, "lab.keulegan_carpenter.max"), "6 +- 0.1");
  EXPECT_THAT(column(results, "lab.t").values, ElementsAre(0, 1, 2));
  EXPECT_THAT(column(results, "lab.measured").values, ElementsAre(3, 5, 4));
  EXPECT_EQ(column(results, "lab.measured").name, "measured position");
  EXPECT_THAT(column(results, "lab.displacement").values, ElementsAre(-1, 1, 0));
  EXPECT_EQ(column(results, "lab.displacement").name, "position *x*");
  EXPECT_THAT(column(results, "lab.mean").values, ElementsAre(4, 4, 4));
  for (const char* absent :
       {"lab.decay_rate_mean", "lab.reynolds_last", "lab.first_rate", "lab.segment.1.from"})
    EXPECT_EQ(fact(results, absent), "none") << absent;
  lab.series.quantity = "velocity";
  collect("lab", lab, results);
  EXPECT_EQ(column(results, "lab.displacement").name, "velocity");
  EXPECT_EQ(fact(results, "lab.rms"), "0.5 m/s");
}

TEST(CollectFit, HasEachSegmentAndTheDampingOfTheirMean) {
  FittedRecording lab = fitted();
  lab.segments = {{0, 1, estimate(1)}, {1, 2, estimate(3)}};
  Results results;
  collect("lab", lab, results);
  EXPECT_EQ(fact(results, "lab.segment.1.from"), "0 s");
  EXPECT_EQ(fact(results, "lab.segment.2.to"), "2 s");
  EXPECT_EQ(fact(results, "lab.segment.2.rate"), "3 +- 0.1 1/s");
  EXPECT_EQ(fact(results, "lab.segment.3.rate"), "none");
  EXPECT_EQ(fact(results, "lab.damping_mean"), "none");
  lab.decay_rate_mean = estimate(3);
  collect("lab", lab, results);
  EXPECT_EQ(fact(results, "lab.decay_rate_mean"), "3 +- 0.1 1/s");
  // 2 gamma k/w^2 = 2 * 3 * 8/4
  EXPECT_EQ(fact(results, "lab.damping_mean"), "12 kg/s");
  lab.derived.clear();
  Results massless;
  collect("lab", lab, massless);
  EXPECT_EQ(fact(massless, "lab.damping_mean"), "none");
}

TEST(CollectFit, SamplesThatAreSetAsideAreNoMotion) {
  FittedRecording lab = fitted();
  lab.series.outliers = {{1, 5, 3}, {1.5, 7, 4}};
  Results results;
  collect("lab", lab, results);
  for (const char* name : {"lab.measured", "lab.displacement"}) {
    const auto& values = column(results, name).values;
    ASSERT_EQ(values.size(), 3u) << name;
    EXPECT_TRUE(std::isnan(values[1])) << name;
    EXPECT_FALSE(std::isnan(values[0]) || std::isnan(values[2])) << name;
  }
  EXPECT_FALSE(std::isnan(column(results, "lab.fitted_displacement").values[1]));
}

TEST(CollectFit, HasWindowsAndStretchesWithTheirBars) {
  FittedRecording lab = fitted();
  lab.reynolds = {{0, 100}, {0.5, 200}, {1, 150}};
  lab.reynolds_max_t = 0.75;
  lab.decay_by_amplitude = {{0, 1, 0.5, {2, 0.5, 0, 0}, {two_pi, 0.5 * two_pi, 0, 0}, 2.25, two_pi},
                            {1, 2, 0.25, {1, 0.25, 0, 0}, {2 * two_pi, two_pi, 0, 0}, 1.5, two_pi}};
  Results results;
  collect("lab", lab, results);
  EXPECT_EQ(fact(results, "lab.reynolds_last"), "150");
  EXPECT_EQ(fact(results, "lab.reynolds.max"), "none");
  EXPECT_THAT(column(results, "lab.window_t").values, ElementsAre(0, 0.5, 1));
  EXPECT_THAT(column(results, "lab.reynolds").values, ElementsAre(100, 200, 150));
  EXPECT_EQ(fact(results, "lab.first_rate"), "2.25 1/s");
  EXPECT_EQ(fact(results, "lab.last_rate"), "1.5 1/s");
  EXPECT_EQ(fact(results, "lab.stretches"), "2");
  EXPECT_THAT(column(results, "lab.amplitude").values, ElementsAre(0.5, 0.25));
  EXPECT_THAT(column(results, "lab.rate").values, ElementsAre(2, 1));
  EXPECT_THAT(column(results, "lab.law_rate").values, ElementsAre(2.25, 1.5));
  EXPECT_THAT(column(results, "lab.stretch_frequency").values, ElementsAre(1, 2));
  EXPECT_THAT(column(results, "lab.bar_frequency").values,
              ElementsAre(0.5, 1.5, NanSensitiveDoubleEq(nothing), 1, 3, NanSensitiveDoubleEq(nothing)));
  EXPECT_EQ(column(results, "lab.law_frequency").values.size(),
            column(results, "lab.law_amplitude").values.size());
  EXPECT_EQ(fact(results, "lab.last_stretch.frequency"), "2 +- 1 Hz");
  EXPECT_EQ(column(results, "lab.law_amplitude").values.front(), 0.25);
  EXPECT_EQ(column(results, "lab.law_amplitude").values.back(), 0.5);
  EXPECT_EQ(column(results, "lab.law_curve").values.size(),
            column(results, "lab.law_amplitude").values.size());
  EXPECT_THAT(column(results, "lab.bar_amplitude").values, ElementsAre(0.5, 0.5, 0.5, 0.25, 0.25, 0.25));
  EXPECT_THAT(column(results, "lab.bar_rate").values, ElementsAre(1.5, 2.5, NanSensitiveDoubleEq(nothing),
                                                                  0.75, 1.25, NanSensitiveDoubleEq(nothing)));
  lab.reynolds_max = estimate(200);
  collect("lab", lab, results);
  EXPECT_EQ(fact(results, "lab.reynolds.max"), "200 +- 0.1");
  EXPECT_EQ(fact(results, "lab.reynolds.t"), "0.75 s");
}

TEST(CollectCompare, SaysWhereASimulationExceedsTheLawMost) {
  CompareResult both;
  both.recording = fitted();
  ComparedCurve more, law;
  more.label = Notice{"one_constant_decay_rate"};
  law.label = Notice{"law_by_name", {{"law", "the law"}}};
  const double tops[] = {1, 1.2, 1.5, 1.1};
  for (int i = 0; i < 4 * 40; ++i) {
    const double t = i * std::numbers::pi / 20, x = std::cos(t - std::numbers::pi / 2);
    law.trajectory.t.push_back(t);
    law.trajectory.x.push_back(x);
    more.trajectory.t.push_back(t);
    more.trajectory.x.push_back(tops[i / 40] * x);
  }
  more.rms = 0.5;
  more.r_squared = 0.75;
  more.amplitude_ratio_end = 1.25;
  more.phase_drift = -0.5;
  both.curves = {more, law};
  Results results;
  collect("c", both, results);
  EXPECT_EQ(fact(results, "c.1.label"), "one constant decay rate");
  EXPECT_EQ(fact(results, "c.2.label"), "the law");
  EXPECT_EQ(fact(results, "c.1.rms"), "0.5 m");
  EXPECT_EQ(fact(results, "c.1.r_squared"), "0.75");
  EXPECT_EQ(fact(results, "c.1.amplitude_error_end"), "0.25");
  EXPECT_EQ(fact(results, "c.1.phase_drift"), "-0.5 rad");
  EXPECT_EQ(fact(results, "c.samples"), "3");
  EXPECT_EQ(fact(results, "c.explanation"), in_words(explanation(both)));
  EXPECT_NEAR(value(results, "c.1.excess_max"), 0.5, 1e-9);
  EXPECT_NEAR(value(results, "c.1.excess_max_t"), 4.5 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(value(results, "c.2.excess_max"), 0, 1e-12);
  EXPECT_EQ(column(results, "c.1.top").values.size(), 4u);
  EXPECT_NEAR(column(results, "c.1.bottom").values[1], -1.2, 1e-9);
  EXPECT_EQ(column(results, "c.1.x").values.size(), 160u);
}

TEST(CollectFit, HasTheHoldsAndTheirLine) {
  StaticStiffness found;
  found.stiffness = estimate(12);
  found.gravity = {9.81, 0.01};
  found.line.slope = 0.8;
  found.line.intercept = 0.1;
  found.line.extra_scatter = 0.003;
  found.holds = {{.file = "a/one.csv", .position = 0.2, .standard_error = 0.004, .mass = {0.1, 0.001}},
                 {.file = "a/one.csv", .run = 2, .position = 0.25, .mass = {0.2, 0}}};
  Results results;
  collect("held", found, results);
  EXPECT_EQ(fact(results, "held.stiffness"), "12 +- 0.1 N/m");
  EXPECT_EQ(fact(results, "held.stiffness.low"), "11.8 N/m");
  EXPECT_EQ(fact(results, "held.gravity"), "9.81 +- 0.01 m/s²");
  EXPECT_EQ(fact(results, "held.1.label"), "one.csv, run 1");
  EXPECT_EQ(fact(results, "held.1.mass"), "0.1 +- 0.001 kg");
  EXPECT_EQ(fact(results, "held.2.position"), "0.25 m");
  EXPECT_THAT(column(results, "held.mass").values, ElementsAre(0.1, 0.2));
  EXPECT_THAT(column(results, "held.residual").values,
              ElementsAre(testing::DoubleNear(0.02, 1e-12), testing::DoubleNear(-0.01, 1e-12)));
  // A twentieth beyond both ends.
  const std::vector<double>&along = column(results, "held.line_mass").values,
        &line = column(results, "held.line").values;
  ASSERT_EQ(line.size(), along.size());
  EXPECT_NEAR(along.front(), 0.095, 1e-12);
  EXPECT_NEAR(along.back(), 0.205, 1e-12);
  for (std::size_t i = 0; i < line.size(); ++i) EXPECT_NEAR(line[i], 0.1 + 0.8 * along[i], 1e-12);
  EXPECT_NEAR(column(results, "held.bar_residual").values[1] - column(results, "held.bar_residual").values[0],
              0.01, 1e-12);
  found.holds[1].run = 1;
  found.holds[1].file = "a/two.csv";
  collect("files", found, results);
  EXPECT_EQ(fact(results, "files.2.label"), "two.csv");
  found.holds[1].file = "a/one.csv";
  found.holds[1].from = 5;
  found.holds[1].to = 9;
  collect("stairs", found, results);
  EXPECT_EQ(fact(results, "stairs.2.label"), "5 to 9 s");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
