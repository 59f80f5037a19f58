// What a figure of simulated runs holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cromer/base/quantity.h"
#include "cromer/figures/figures.h"
#include "cromer/report/layout.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::ElementsAre;

SimulateResult run_of(const SimulateOptions& options) {
  auto result = simulate(options);
  EXPECT_TRUE(result.ok());
  return *std::move(result);
}

SimulateOptions swing(std::vector<std::string> methods) {
  SimulateOptions options;
  options.mass = 0.2;
  options.stiffness = 20;
  options.damping = 0.05;
  options.position = 0.05;
  options.method = std::move(methods);
  return options;
}

Figure drawn(const SimulateOptions& options, const char* panels) {
  return simulate_figure(run_of(options), *parse_panels(panels));
}

const Curve& curve(const Panel& panel, const std::string& name) {
  const auto found = std::find_if(panel.curves.begin(), panel.curves.end(),
                                  [&](const Curve& each) { return each.name == name; });
  EXPECT_NE(found, panel.curves.end()) << name;
  return *found;
}

TEST(SimulateFigure, HasAPanelForEachQuantityInTheOrderAsked) {
  const SimulateOptions options = swing({"exact"});
  const SimulateResult result = run_of(options);
  const Figure figure = simulate_figure(result, *parse_panels("energy,phase,velocity,position"));
  std::vector<std::string> names;
  for (const Panel& panel : figure.panels) names.push_back(panel.x.name + " | " + panel.y.name);
  EXPECT_THAT(names, ElementsAre("time {/:Italic t} (s) | energy {/:Italic E} (mJ)",
                                 "position {/:Italic x} (cm) | velocity {/:Italic v} (cm/s)",
                                 "time {/:Italic t} (s) | velocity {/:Italic v} (cm/s)",
                                 "time {/:Italic t} (s) | position {/:Italic x} (cm)"));
  const Trajectory& motion = result.runs[0].trajectory;
  ASSERT_EQ(figure.panels[0].curves[0].y.size(), motion.size());
  for (const std::size_t i : {std::size_t{0}, motion.size() / 3, motion.size() - 1}) {
    const double x = motion.x[i], v = motion.v[i];
    EXPECT_NEAR(figure.panels[0].curves[0].y[i], 1e3 * (0.1 * v * v + 10 * x * x), 1e-9);
    EXPECT_NEAR(figure.panels[1].curves[0].x[i], 100 * x, 1e-12);
    EXPECT_NEAR(figure.panels[1].curves[0].y[i], 100 * v, 1e-12);
    EXPECT_NEAR(figure.panels[2].curves[0].y[i], 100 * v, 1e-12);
    EXPECT_NEAR(figure.panels[3].curves[0].y[i], 100 * x, 1e-12);
  }
}

TEST(SimulateFigure, PanelsAgainstTimeShareTheirAxisAndAPortraitHasItsOwn) {
  const Figure figure = drawn(swing({"exact", "rk4"}), "position,velocity,phase,energy");
  const Layout layout = lay_out(figure, Typeface::lato);
  const auto has_name_of_time = [&](std::size_t panel) {
    const auto& texts = layout.panels[panel].texts;
    return std::any_of(texts.begin(), texts.end(),
                       [](const PlacedText& text) { return text.text == "time {/:Italic t} (s)"; });
  };
  EXPECT_FALSE(has_name_of_time(0));
  EXPECT_TRUE(has_name_of_time(1));
  EXPECT_TRUE(has_name_of_time(3));
  for (const std::size_t i : {std::size_t{1}, std::size_t{3}}) {
    EXPECT_DOUBLE_EQ(layout.panels[0].frame.x, layout.panels[i].frame.x);
    EXPECT_DOUBLE_EQ(layout.panels[0].frame.right(), layout.panels[i].frame.right());
  }
  const Box& portrait = layout.panels[2].frame;
  EXPECT_NEAR(portrait.width, portrait.height, 1e-9);
  EXPECT_GT(portrait.height, 300);
}

TEST(SimulateFigure, CutsEveryPanelWhereARunGrowsWithoutEnd) {
  SimulateOptions options = swing({"exact", "forward-euler"});
  options.step = 0.02;
  for (const char* panels : {"position", "velocity", "energy"}) {
    const Panel panel = drawn(options, panels).panels[0];
    const Curve &grows = curve(panel, "forward Euler"), &exact = curve(panel, "exact");
    const double reached = *std::max_element(exact.y.begin(), exact.y.end());
    EXPECT_GT(*std::max_element(grows.y.begin(), grows.y.end()), panel.y.high) << panels;
    EXPECT_GT(panel.y.high, reached) << panels;
    EXPECT_LT(panel.y.high, 20 * reached) << panels;
    if (std::string_view(panels) != "velocity") {
      EXPECT_EQ(grows.remark, "grows without end");
    }
  }
  const Panel portrait = drawn(options, "phase").panels[0];
  const Curve& spiral = curve(portrait, "forward Euler");
  for (std::size_t i = 0; i < spiral.x.size(); ++i) {
    if (std::isfinite(spiral.x[i])) {
      EXPECT_LT(std::abs(spiral.x[i]), 3 * portrait.x.high);
    }
  }
}

// What grows beyond all bounds within the two periods that are drawn is cut at three heights of the frame.
TEST(SimulateFigure, DrawsNothingFarOutsideTheFrame) {
  SimulateOptions options = swing({"exact", "forward-euler"});
  options.step = 0.2;  // two radians: it more than doubles at each step
  const Panel panel = drawn(options, "position").panels[0];
  const Curve& grows = curve(panel, "forward Euler");
  const double height = panel.y.high / 1.1;
  EXPECT_NEAR(*std::max_element(grows.y.begin(), grows.y.end()), 3 * height, 1e-9);
  EXPECT_NEAR(*std::min_element(grows.y.begin(), grows.y.end()), -3 * height, 1e-9);
}

/// The remark of the only run's position.
std::string remark_of(const SimulateOptions& options) {
  return drawn(options, "position").panels[0].curves[0].remark;
}

TEST(SimulateFigure, SaysTheAmplitudeAtTheVeryEnd) {
  SimulateOptions options = swing({"exact"});  // 10 rad/s
  for (const double until : {3.0, 3.1, 3.25}) {
    options.until = until;
    EXPECT_EQ(remark_of(options), "±" + rounded(5 * std::exp(-0.125 * until), 3) + " cm at the end");
  }
  options.method = {"implicit-euler"};  // each step divides it by sqrt(1 + 0.1 * 0.025 + 0.1^2)
  options.step = 0.01;
  options.until = 6;
  EXPECT_EQ(remark_of(options), "±" + rounded(5 * std::pow(1.0125, -300), 3) + " cm at the end");
}

TEST(SimulateFigure, OfAnUnevenSwingSaysHowFarItGoes) {
  SimulateOptions uneven = swing({"rk4"});
  uneven.damping = 0;
  uneven.law.quadratic = 100;
  EXPECT_THAT(remark_of(uneven), testing::MatchesRegex("from −[67].* to 5.00 cm\nin the last 0.63 s"));
  SimulateOptions sticks = swing({"rk4"});
  sticks.law.friction = 0.3;
  EXPECT_THAT(remark_of(sticks), testing::MatchesRegex("[−.0-9]+ cm at the end"));
  SimulateOptions rests = swing({"rk4"});
  rests.position = 0;
  rests.velocity = 0;
  rests.until = 10;
  EXPECT_EQ(remark_of(rests), "0 µm at the end");
  SimulateOptions creeps = swing({"exact"});
  creeps.damping = 20;
  creeps.until = 2;
  EXPECT_THAT(remark_of(creeps), testing::MatchesRegex("0[.].* cm at the end"));
  creeps.until = 40;
  EXPECT_EQ(remark_of(creeps), "0 cm at the end");
  SimulateOptions driven = swing({"exact"});
  driven.drive_amplitude = 1;
  driven.drive_frequency = {8};
  driven.until = 100;
  EXPECT_THAT(remark_of(driven), testing::MatchesRegex("±13[.].* cm at the end"));
}

TEST(SimulateFigure, ALineEndsTwoPeriodsAfterItLeavesTheFrame) {
  SimulateOptions options = swing({"exact", "forward-euler"});
  options.step = 0.01;  // grows by exp((0.5 - 0.125) t): to 4 times 5 cm in 3.7 s, to 8 times in 5.5 s
  options.until = 6;
  const Panel panel = drawn(options, "position").panels[0];
  const Curve& grows = curve(panel, "forward Euler");
  EXPECT_EQ(grows.remark, "grows without end");
  EXPECT_NEAR(grows.x.back(), 3.7 + 2 * 0.628, 0.4);
  EXPECT_EQ(curve(panel, "exact").x.back(), 6);
  // A resonance that fills the frame is no such run.
  SimulateOptions driven = swing({"exact"});
  driven.drive_amplitude = 1;
  driven.drive_frequency = {10, 20};
  driven.damping = 0.001;
  driven.until = 100;
  const Panel resonance = drawn(driven, "position").panels[0];
  for (const Curve& each : resonance.curves) {
    EXPECT_THAT(each.remark, testing::Not(testing::HasSubstr("without end")));
    EXPECT_EQ(each.x.back(), 100);
  }
}

TEST(SimulateFigure, HasTheUnitsThatSuit) {
  SimulateOptions quick = swing({"exact"});
  quick.until = 0.4;
  const Panel in_ms = drawn(quick, "position").panels[0];
  EXPECT_EQ(in_ms.x.name, "time {/:Italic t} (ms)");
  EXPECT_NEAR(in_ms.curves[0].x.back(), 400, 1e-9);
  SimulateOptions pendulum = swing({"rk4"});
  pendulum.stiffness = 0;
  pendulum.law.pendulum = 9.81;
  const Panel portrait = drawn(pendulum, "phase").panels[0];
  EXPECT_EQ(portrait.x.name, "angle (rad)");
  EXPECT_EQ(portrait.y.name, "angular velocity (rad/s)");
}

TEST(SimulateFigure, CutsTheVelocityOfARunInStepsLongerThanAPeriod) {
  SimulateOptions options = swing({"forward-euler"});
  options.step = 1;
  const Panel panel = drawn(options, "velocity").panels[0];
  EXPECT_LT(panel.y.high, 5000);  // [cm/s], of 50 at a spring's swing
}

TEST(SimulateFigure, OfALongRunThePortraitIsItsFirstAndLastPeriods) {
  SimulateOptions options = swing({"exact"});
  options.until = 400;
  const Panel panel = drawn(options, "phase").panels[0];
  EXPECT_EQ(panel.title, "Phase portrait of the first 5 and the last 3 periods");
  const std::vector<double>& x = panel.curves[0].x;
  EXPECT_EQ(std::count_if(x.begin(), x.end(), [](double each) { return std::isnan(each); }), 1);
  EXPECT_NEAR(static_cast<double>(x.size()), 8 * 200, 5);
}

TEST(SimulateFigure, ListsMoreThanSixNames) {
  const std::vector<std::string> six{"exact", "euler-cromer", "verlet", "rk4", "heun", "newmark"};
  std::vector<std::string> seven = six;
  seven.push_back("implicit-euler");
  for (const char* panels : {"position", "energy,velocity"}) {
    EXPECT_FALSE(drawn(swing(six), panels).panels[0].names_listed);
    EXPECT_TRUE(drawn(swing(seven), panels).panels[0].names_listed);
  }
}

TEST(SimulateFigure, SeveralMethodsAtSeveralFrequenciesHaveTheirPanelsForEach) {
  SimulateOptions options = swing({"exact", "rk4"});
  options.drive_amplitude = 1;
  options.drive_frequency = {5, 8};
  const Figure figure = drawn(options, "position,phase");
  std::vector<std::string> titles;
  for (const Panel& panel : figure.panels) titles.push_back(panel.title);
  EXPECT_THAT(titles, ElementsAre("5\u00a0rad/s", "Phase portrait at 5\u00a0rad/s", "8\u00a0rad/s",
                                  "Phase portrait at 8\u00a0rad/s"));
}

TEST(SimulateFigure, HasTheRecordingAsDotsInThePanelOfPositions) {
  const LaidOver over{"x (mm)", "m", {0, 0.1, 0.2}, {0.05, 0.031, -0.012}};
  const Figure figure =
      simulate_figure(run_of(swing({"exact"})), *parse_panels("position,velocity,phase"), &over);
  ASSERT_EQ(figure.panels.size(), 3u);
  const Curve& dots = curve(figure.panels[0], "measured");
  EXPECT_EQ(dots.mark, Mark::dots);
  EXPECT_EQ(dots.remark, "3 samples");
  EXPECT_EQ(dots.x, over.t);
  ASSERT_EQ(dots.y.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(dots.y[i], 100 * over.x[i], 1e-12);  // cm, as the run
  for (const std::size_t other : {1u, 2u}) EXPECT_EQ(figure.panels[other].curves.size(), 1u);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
