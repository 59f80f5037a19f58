#include "cromer/tasks/fit/fit_forced.h"
#include "cromer/tasks/fit/fit_driven.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "cromer/identify/motion/motion_model.h"
#include "cromer/tasks/fit/fitted_motion.h"
#include "tests/identify/forced_truth.h"
#include "tests/support/cases.h"
#include "tests/support/shared_data.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::HasSubstr;

// A rig in SI units: 0.25 kg, and a force sensor in newtons, so that the gain is 1/mass.
std::string rig(std::size_t n = 3000, double noise = 1e-4) {
  const ForcedTruth truth{.w0 = 12, .g = 0.35, .cubic = 2e3, .gain = 4, .position = 0.01, .velocity = 0};
  const auto record = forced_synthetic(truth, multisine(40, 1), n, 0.03, noise, 1);
  std::ostringstream file;
  file.precision(12);
  file << "Time (s),Force (N),Position (m)\n";
  for (std::size_t i = 0; i < n; ++i)
    file << record.t[i] << ',' << record.force[i] << ',' << record.y[i] << '\n';
  return file.str();
}

FitOptions forced_options() {
  FitOptions options;
  options.force_column = "Force";
  options.law = "viscous+cubic";
  return options;
}

std::string message(const std::string& bytes, const FitOptions& options) {
  const auto result = fit(bytes, "rig.csv", options);
  return result.ok() ? "fitted" : in_words(result.error());
}

FittedRecording fitted(const std::string& bytes, const FitOptions& options) {
  const auto result = fit(bytes, "rig.csv", options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : in_words(result.error()));
  return result.ok() ? result->front() : FittedRecording{};
}

TEST(FitForced, NamesFollowTheContract) {
  FitOptions options = forced_options();
  options.law = "viscous+cubic+quadratic";
  options.mass = {Quantity{0.25, 0.001}};
  const FittedRecording result = fitted(rig(), options);
  ASSERT_EQ(result.fit.status, FitStatus::converged) << in_words(result.fit.message);
  std::vector<std::string> names;
  for (const Parameter& number : result.parameters) names.push_back(number.name + " " + number.unit);
  EXPECT_THAT(names,
              testing::ElementsAre("angular_frequency rad/s", "decay_rate 1/s", "cubic 1/(m² s²)",
                                   "quadratic 1/(m s²)", "force_gain m/(s² N)", "force_offset N",
                                   "equilibrium m", "position m", "velocity m/s", "stiffness N/m",
                                   "damping kg/s", "cubic_stiffness N/m³", "quadratic_stiffness N/m²"));
  EXPECT_EQ(result.between_samples, "band-limited");
  EXPECT_NEAR(result.find("force_gain")->value, 4, 4 * result.find("force_gain")->standard_error);
  EXPECT_NEAR(result.find("stiffness")->value, 0.25 * 144, 0.3);
  EXPECT_GE(result.find("stiffness")->standard_error, 36 * 0.004 * 0.99);  // the mass's own
  EXPECT_NEAR(result.find("cubic_stiffness")->value, 500, 4 * result.find("cubic_stiffness")->standard_error);
  // At the motion's amplitude the spring is stiffer than at rest: rate over frequency there, not over 12
  // rad/s.
  const double ratio = result.find("damping_ratio")->value;
  const double there = 2 * std::numbers::pi * result.find("frequency")->value / std::sqrt(1 - ratio * ratio);
  EXPECT_NEAR(ratio * there, result.find("decay_rate")->value, 1e-9);
  EXPECT_NEAR(ratio * there, 0.35, 0.012);
  EXPECT_GT(there, 12.3);
  EXPECT_EQ(result.driven->motion.size(), result.series.t.size());
}

TEST(FitForced, TestsTheLawOnWhatWasHeldOut) {
  FitOptions options = forced_options();
  options.hold_out = 0.25;
  const FittedRecording result = fitted(rig(), options);
  ASSERT_TRUE(result.held_out.has_value());
  EXPECT_EQ(result.series.t.size(), 2250u);
  EXPECT_EQ(result.held_out->samples, 750u);
  EXPECT_NEAR(result.held_out->from, 67.5, 1e-9);
  EXPECT_LT(result.held_out->rms, 1.2e-4);
  EXPECT_GT(result.held_out->rms, 0.9e-4);
  // What is held out changes nothing in the fit.
  FitOptions cut = forced_options();
  cut.to = 67.47;
  EXPECT_NEAR(fitted(rig(), cut).find("cubic")->value, result.find("cubic")->value,
              0.1 * result.find("cubic")->standard_error);
}

TEST(FitForced, TakesThePartAskedForWithTheForceAroundIt) {
  FitOptions options = forced_options();
  options.from = 30;
  options.to = 60;
  const FittedRecording result = fitted(rig(), options);
  EXPECT_EQ(result.series.t.size(), 1001u);
  EXPECT_NEAR(result.fit.residual.rms, 1e-4, 1e-5);  // the sinc series is not cut off at 30 and 60 s
}

TEST(FitForced, SaysWhatIsWrongWithTheForce) {
  FitOptions options = forced_options();
  const std::string good = rig(300);
  options.force_column = "Kraft";
  EXPECT_THAT(message(good, options), testing::AllOf(HasSubstr("--force-column"), HasSubstr("Kraft")));
  options.force_column = "Position";
  EXPECT_THAT(message(good, options), HasSubstr("is the column that is fitted"));

  const auto edited = [&](auto edit) {
    std::istringstream lines(good);
    std::string line, result;
    std::getline(lines, line);
    result = line + '\n';
    for (int i = 0; std::getline(lines, line); ++i) {
      const auto a = line.find(','), b = line.find(',', a + 1);
      std::string t = line.substr(0, a), u = line.substr(a + 1, b - a - 1), y = line.substr(b + 1);
      edit(i, t, u, y);
      result += t + ',' + u + ',' + y + '\n';
    }
    return result;
  };
  options = forced_options();
  using S = std::string;
  EXPECT_THAT(message(edited([](int, S&, S& u, S&) { u = "2"; }), options),
              HasSubstr("is 2 throughout: a force that never changes drives nothing"));
  EXPECT_THAT(message(edited([](int i, S&, S& u, S&) { u = i > 100 && i < 110 ? "" : u; }), options),
              HasSubstr("has a gap"));
  EXPECT_THAT(message(edited([](int i, S&, S& u, S&) { u = i < 200 ? u : ""; }), options),
              HasSubstr("choose the part that both have"));
  EXPECT_THAT(message(edited([](int i, S& t, S&, S&) { t = std::to_string(0.03 * i + (i % 2 ? 0.008 : 0)); }),
                      options),
              HasSubstr("not evenly spaced"));
  // A value of the motion may be missing.
  EXPECT_EQ(message(edited([](int i, S&, S&, S& y) { y = i % 50 == 9 ? "" : y; }), options), "fitted");
}

TEST(FitForced, SaysWhatIsWrongWithTheOptions) {
  const std::string good = rig(300);
  FitOptions options = forced_options();
  options.between_samples = "cubic";
  EXPECT_THAT(message(good, options), HasSubstr("--between-samples"));
  options = forced_options();
  options.law = "viscous+friktion";
  EXPECT_THAT(message(good, options), HasSubstr("friktion"));
  options = forced_options();
  options.drive_frequency = "2 Hz";
  EXPECT_THAT(message(good, options), HasSubstr("exclude each other"));
  options = forced_options();
  options.hold_out = 0.95;
  EXPECT_THAT(message(good, options), HasSubstr("--hold-out"));
  EXPECT_THAT(message(good, {.between_samples = "hold"}),
              HasSubstr("--between-samples needs --force-column"));
  EXPECT_THAT(message(good, {.hold_out = 0.2}), HasSubstr("--hold-out needs --force-column"));
  EXPECT_THAT(message(good, {.drive_frequency = "2 kg"}), HasSubstr("--drive-frequency"));
  EXPECT_THAT(message(good, {.drive_frequency = "-2 Hz"}), HasSubstr("positive"));
}

TEST(FitForced, AShortRecordIsAStatus) {
  const FittedRecording result = fitted(rig(20), forced_options());
  EXPECT_EQ(result.fit.status, FitStatus::too_short);
  EXPECT_THAT(in_words(result.fit.message), HasSubstr("too few"));
  EXPECT_TRUE(result.parameters.empty());
}

// Beats of 7.2 and 7.58 rad/s, by the closed form of an undriven start.
std::string beats(double amplitude) {
  const double w0 = 7.2, g = 0.04, drive = 7.58;
  const double r = w0 * w0 - drive * drive, s = 2 * g * drive, size = amplitude / (r * r + s * s);
  const double c = r * size, d = s * size;  // steady: c cos + d sin
  const double w = std::sqrt(w0 * w0 - g * g);
  std::mt19937_64 engine(3);
  std::normal_distribution<double> normal(0, 2e-4);
  std::ostringstream file;
  file << "Time (s),Position (m)\n";
  for (int i = 0; i < 8000; ++i) {
    const double t = 0.01 * i, x = 0.03 - c, v = -d * drive;
    file << t << ','
         << 0.2 + c * std::cos(drive * t) + d * std::sin(drive * t) +
                std::exp(-g * t) * (x * std::cos(w * t) + (v + g * x) / w * std::sin(w * t)) + normal(engine)
         << '\n';
  }
  return file.str();
}

TEST(FitDriven, SaysTheDrive) {
  FitOptions options;
  options.drive_frequency = "1.206 Hz";
  options.mass = {Quantity{0.25, 0}};
  const FittedRecording result = fitted(beats(0.3), options);
  ASSERT_EQ(result.fit.status, FitStatus::converged) << in_words(result.fit.message);
  const auto near = [&](const char* name, double truth) {
    ASSERT_NE(result.find(name), nullptr) << name;
    EXPECT_NEAR(result.find(name)->value, truth, 4 * result.find(name)->standard_error) << name;
  };
  near("drive_frequency", 7.58);
  near("drive_amplitude", 0.3);
  near("drive_force", 0.075);
  near("drive_phase", 0);
  near("angular_frequency", 7.2);
  near("stiffness", 0.25 * 7.2 * 7.2);
  EXPECT_TRUE(result.between_samples.empty());
  EXPECT_THAT(command_of("simulate", result.simulate),
              testing::StartsWith("cromer simulate --mass 0.25 --stiffness 12.9"));
  EXPECT_THAT(command_of("simulate", result.simulate), HasSubstr(" --drive-frequency 7.5"));
}

TEST(FitDriven, AGyroscopesRecordIsOneOfAngularVelocities) {
  // The derivative of the beats by central differences: exact apart from a factor near 1.
  std::istringstream angles(beats(0.3));
  std::string line;
  std::getline(angles, line);
  std::vector<double> t, x;
  while (std::getline(angles, line)) {
    t.push_back(std::stod(line));
    x.push_back(std::stod(line.substr(line.find(',') + 1)));
  }
  std::ostringstream rates;
  rates.precision(12);
  rates << "Time (s),Gyro z (rad/s)\n";
  for (std::size_t i = 1; i + 1 < t.size(); ++i)
    rates << t[i] << ',' << (x[i + 1] - x[i - 1]) / (t[i + 1] - t[i - 1]) + 0.01 << '\n';
  const FittedRecording result = fitted(rates.str(), {});
  ASSERT_NE(result.find("drive_frequency"), nullptr);
  EXPECT_NEAR(result.find("drive_frequency")->value, 7.58, 2e-3);
  EXPECT_NEAR(result.find("angular_frequency")->value, 7.2, 1e-2);
  EXPECT_NEAR(result.find("drive_amplitude")->value, 0.3, 0.01);
  EXPECT_NEAR(result.find("equilibrium")->value, 0.01, 2e-3);
  EXPECT_THAT(in_words(result.notices),
              testing::Contains(HasSubstr("holds angular velocity and is fitted as such")));
}

TEST(FitDriven, WritesTheMotionUnderTheDrive) {
  FitOptions options;
  options.drive_frequency = "1.206 Hz";
  const FittedRecording result = fitted(beats(0.3), options);
  const FittedMotion motion = fitted_motion(result);
  ASSERT_EQ(motion.x.size(), result.series.t.size());
  for (std::size_t i = 1; i + 1 < motion.x.size(); ++i) {
    EXPECT_NEAR(motion.x[i] + result.fit.equilibrium().value + motion.residual[i], result.series.y[i], 1e-12);
    const double slope = (motion.x[i + 1] - motion.x[i - 1]) / (motion.t[i + 1] - motion.t[i - 1]);
    EXPECT_NEAR(motion.v[i], slope, 0.02 * 7.58 * 0.3);
  }
}

TEST(FitDriven, SimulatesACurvedSpring) {
  FitOptions options;
  options.drive_frequency = "1.206 Hz";
  options.law = "viscous+cubic+quadratic";
  const FittedRecording result = fitted(beats(0.3), options);
  for (const char* option : {"--cubic ", "--quadratic ", "--drive-amplitude "})
    EXPECT_THAT(command_of("simulate", result.simulate), HasSubstr(option));
}

TEST(FitDriven, IsRecognisedUnlessTheMotionIsFree) {
  const FittedRecording driven = fitted(beats(0.3), {});
  ASSERT_NE(driven.find("drive_frequency"), nullptr);
  EXPECT_NEAR(driven.find("drive_frequency")->value, 7.58, 1e-3);
  EXPECT_THAT(in_words(driven.notices), testing::Contains(HasSubstr("the motion is driven, at 1.2063")));
  EXPECT_EQ(fitted(beats(0), {}).find("drive_frequency"), nullptr);
  EXPECT_EQ(fitted(beats(0.3), {.law = "viscous"}).find("drive_frequency"), nullptr);
}

/// A column of these values every 0.03 s.
Series column_of(const std::string& name, const std::string& quantity, const std::vector<double>& y) {
  Series series;
  series.column = name;
  series.quantity = quantity;
  series.rate = 100 / 3.0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    series.t.push_back(0.03 * static_cast<double>(i));
    series.lines.push_back(static_cast<long>(i) + 2);
  }
  series.y = y;
  return series;
}

/// Leaves out what lies between two times, and says so.
void cut_out(Series& series, double from, double to) {
  const auto first = std::upper_bound(series.t.begin(), series.t.end(), from) - series.t.begin(),
             last = std::lower_bound(series.t.begin(), series.t.end(), to) - series.t.begin();
  series.gaps.push_back({series.t[static_cast<std::size_t>(first) - 1], to - from});
  series.t.erase(series.t.begin() + first, series.t.begin() + last);
  series.y.erase(series.y.begin() + first, series.y.begin() + last);
  series.lines.erase(series.lines.begin() + first, series.lines.begin() + last);
}

/// Force and motion of a rig, as columns.
struct Columns {
  Series force, motion;

  explicit Columns(
      const ForcedTruth& truth = {.w0 = 12, .g = 0.35, .gain = 4, .position = 0.01, .velocity = 0},
      std::size_t n = 600) {
    const auto record = forced_synthetic(truth, multisine(40, 1), n, 0.03, 1e-4, 1);
    force = column_of("Force (N)", "force", record.force);
    motion = column_of("Position (m)", "position", record.y);
  }
  Result<FittedRecording> fit(FitOptions options) const {
    options.law = options.law == "auto" ? "viscous" : options.law;
    return fit_forced(motion, force, "rig.csv", options, {});
  }
  std::string told(const FitOptions& options = {}) const {
    const auto result = fit(options);
    return result ? "fitted" : in_words(result.error());
  }
};

TEST(FitForced, OnlyAGapBesideTheMotionDoesNotMatter) {
  const FitOptions part{.from = 6.0, .to = 12.0};
  Columns rig;
  cut_out(rig.force, 5.7, 5.85);
  cut_out(rig.force, 12.3, 12.6);
  EXPECT_EQ(rig.told(part), "fitted");
  EXPECT_EQ(
      rig.told(),
      "force column \"Force (N)\" has 2 gaps, the first 0.15 s long at 5.7 s: what the force did there is "
      "not known; choose a part without gaps with --from and --to, or fill them in");
  // Up to the motion itself.
  rig = Columns();
  cut_out(rig.force, 5.7, 6);
  cut_out(rig.force, 12, 12.3);
  EXPECT_EQ(rig.told(part), "fitted");
  const std::string one_side =
      " s: what the force did there is not known; choose one side of it with --from and --to, or fill it in";
  rig = Columns();
  cut_out(rig.force, 5.7, 6.03);
  EXPECT_EQ(rig.told(part), "force column \"Force (N)\" has a gap, 0.33 s long at 5.7" + one_side);
  rig = Columns();
  cut_out(rig.force, 11.97, 12.3);
  EXPECT_EQ(rig.told(part), "force column \"Force (N)\" has a gap, 0.33 s long at 11.97" + one_side);
  // Where nothing of the force is left, too.
  rig = Columns();
  cut_out(rig.force, 0.3, 17.7);
  EXPECT_EQ(rig.told(part), "force column \"Force (N)\" has a gap, 17.4 s long at 0.3" + one_side);
}

TEST(FitForced, TheForceMustBeThereAtEachSample) {
  const auto ends = [](const std::string& from, const std::string& to, const std::string& t) {
    return "force column \"Force (N)\" goes from " + from + " to " + to +
           " s, and column \"Position (m)\" has a value at " + t +
           " s; choose the part that both have with --from and --to";
  };
  Columns rig;
  for (double& t : rig.force.t) t += 0.03;
  EXPECT_EQ(rig.told(), ends("0.03", "18", "0"));
  EXPECT_EQ(rig.told({.from = 0.03}), "fitted");
  rig = Columns();
  for (double& t : rig.force.t) t -= 0.03;
  EXPECT_EQ(rig.told(), ends("-0.03", "17.94", "17.97"));
  EXPECT_EQ(rig.told({.to = 17.94}), "fitted");
  for (double& t : rig.force.t) t += 100;
  EXPECT_EQ(rig.told(), ends("99.97", "117.94", "0"));
  rig = Columns();
  for (double& t : rig.motion.t) t += 0.0003;  // a hundredth of a spacing
  EXPECT_EQ(rig.told(), "fitted");
  for (double& t : rig.motion.t) t += 0.0006;
  EXPECT_EQ(
      rig.told(),
      "force column \"Force (N)\" has other times than column \"Position (m)\": 0.0009 s lies between two "
      "of its samples; resample one of them first");
  rig = Columns();
  rig.force = column_of("Force (N)", "force", {1});
  EXPECT_EQ(rig.told(), "force column \"Force (N)\" has fewer than two values");
}

TEST(FitForced, WhatIsSetAsideIsNotFitted) {
  Columns rig;
  const auto clean = rig.fit({});
  ASSERT_TRUE(clean);
  for (const std::size_t i : {0u, 7u, 300u}) {
    rig.motion.y[i] = 5;
    rig.motion.outliers.push_back({rig.motion.t[i], 5, static_cast<long>(i) + 2});
  }
  const auto without = rig.fit({});
  ASSERT_TRUE(without) << in_words(without.error());
  EXPECT_EQ(without->series.t.front(), 0.03);  // the motion begins at the first sample that is fitted
  EXPECT_EQ(without->series.t.size(), 599u);
  EXPECT_NEAR(without->find("angular_frequency")->value, clean->find("angular_frequency")->value, 1e-3);
  EXPECT_NEAR(without->fit.residual.rms, 1e-4, 1e-5);
  for (std::size_t i = 0; i < 600; ++i) rig.motion.outliers.push_back({rig.motion.t[i], rig.motion.y[i], 0});
  std::sort(rig.motion.outliers.begin(), rig.motion.outliers.end(),
            [](const Outlier& a, const Outlier& b) { return a.t < b.t; });
  EXPECT_EQ(rig.told(), "all values of column \"Position (m)\" are set aside");
}

TEST(FitForced, SaysWhatADrivenMotionDoesNotGive) {
  const Columns rig;
  const Quantity disc{0.1, 0};
  const auto notices = [&](const FitOptions& options) {
    const auto result = rig.fit(options);
    return result ? in_words(result->notices) : std::vector{in_words(result.error())};
  };
  const std::string reynolds = "--disc-diameter gives no Reynolds number of a driven motion",
                    number = reynolds + "; and no drag coefficient: that needs --mass and drag in the law";
  const auto hides = testing::HasSubstr("noise of the recorded force may hide");
  EXPECT_THAT(notices({}), testing::ElementsAre(hides));
  EXPECT_THAT(notices({.disc_diameter = disc}), testing::ElementsAre(hides, number));
  EXPECT_THAT(notices({.law = "viscous+drag", .mass = {Quantity{0.25, 0}}, .disc_diameter = disc}),
              testing::Contains(reynolds));
  EXPECT_THAT(notices({.segment = 2.0, .textbook = true}),
              testing::ElementsAre(hides, "--segment is not used: the motion is driven",
                                   "--textbook is not used: the motion is driven"));
  EXPECT_THAT(notices({.law = "viscous+hysteresis"}),
              testing::Contains(testing::HasSubstr("the recorded force is taken as exact")));
  const auto trials = rig.fit({.mass = {Quantity{0.25, 0.001}}, .monte_carlo = 1000});
  ASSERT_TRUE(trials && trials->monte_carlo);
  EXPECT_NEAR(trials->monte_carlo->mean, trials->find("stiffness")->value, 0.05);
  EXPECT_FALSE(rig.fit({.mass = {Quantity{0.25, 0.001}}})->monte_carlo);
}

TEST(FitForced, AnOverdampedLawIsSaidToBe) {
  const auto notices = [](double g) {
    return in_words(
        Columns({.w0 = 3, .g = g, .gain = 4, .position = 0, .velocity = 0}, 1500).fit({})->notices);
  };
  const std::string overdamped = "the law is overdamped: it has no frequency and no period of its own";
  EXPECT_THAT(notices(6), testing::Contains(overdamped));
  EXPECT_THAT(notices(1), testing::Not(testing::Contains(overdamped)));
}

/// beats() as a series.
Series beats_series() {
  const auto recording = read_recording(beats(0.3), "rig.csv", {});
  return *take_series(*recording, "Position", 1, {});
}

TEST(FitDriven, RefusesADriveThatTheSamplesCannotShow) {
  const Series series = beats_series();
  const auto told = [&](const std::string& asked) {
    const auto result = fit_driven(series, "rig.csv", {.law = "viscous", .drive_frequency = asked}, {});
    return result ? "fitted" : in_words(result.error());
  };
  const std::string cannot = " cannot be seen in 100 samples per second, only frequencies up to 50 Hz";
  EXPECT_EQ(told("60 Hz"), "--drive-frequency: 60 Hz" + cannot);
  EXPECT_EQ(told("50.001 Hz"), "--drive-frequency: 50.001 Hz" + cannot);
  EXPECT_EQ(told("1.2 Hz"), "fitted");
}

TEST(FitDriven, BeginsAtTheFirstSampleThatIsFitted) {
  Series series = beats_series();
  const auto set_aside = [&](std::size_t i) {
    series.outliers.push_back({series.t[i], series.y[i], static_cast<long>(i) + 2});
  };
  for (const std::size_t i : {0u, 1u, 500u}) {
    series.y[i] = 3;
    set_aside(i);
  }
  const FitOptions options{.law = "viscous", .drive_frequency = "auto"};
  const auto result = fit_driven(series, "rig.csv", options, {});
  ASSERT_TRUE(result) << in_words(result.error());
  ASSERT_EQ(result->fit.status, FitStatus::converged);
  EXPECT_EQ(result->series.t.front(), 0.02);
  EXPECT_EQ(result->series.t.size(), 7998u);
  EXPECT_EQ(result->driven->motion.size(), 7998u);
  EXPECT_NEAR(result->driven->motion[0], series.y[2], 1e-3);
  EXPECT_NEAR(result->fit.residual.rms, 2e-4, 1e-5);
  series.outliers.clear();
  for (std::size_t i = 0; i < series.t.size(); ++i) set_aside(i);
  EXPECT_EQ(in_words(fit_driven(series, "rig.csv", options, {}).error()),
            "all values of column \"Position (m)\" are set aside");
}

TEST(FitDriven, AMassGivesNoStiffnessOfAnAngle) {
  Series series = beats_series();
  series.column = "Angle (rad)";
  series.quantity = "angle";
  const auto notices = [&](const FitOptions& options) {
    return in_words(fit_driven(series, "rig.csv", options, {})->notices);
  };
  const std::string none = "--mass gives no stiffness here: column \"Angle (rad)\" is no length";
  EXPECT_THAT(notices({.law = "viscous", .mass = {Quantity{0.25, 0}}, .drive_frequency = "auto"}),
              testing::Contains(none));
  EXPECT_THAT(notices({.law = "viscous", .drive_frequency = "auto"}), testing::Not(testing::Contains(none)));
}

/// Two free swings at once, of like size.
Series two_swings() {
  Series series;
  series.column = "x (m)";
  series.quantity = "position";
  series.rate = 25;
  std::mt19937_64 engine(5);
  std::normal_distribution<double> normal(0, 2e-4);
  for (int i = 0; i < 1200; ++i) {
    const double t = 0.04 * i;
    series.t.push_back(t);
    series.y.push_back(0.2 + std::exp(-0.03 * t) * (0.03 * std::cos(7.2 * t) + 0.02 * std::sin(8.9 * t)) +
                       normal(engine));
  }
  return series;
}

TEST(FitDriven, TwoSwingsAreNoDriveThatIsAskedFor) {
  const Series series = two_swings();
  for (const char* asked : {"auto", "7.2 rad/s", "8.9 rad/s"}) {
    const FitOptions options{.law = "viscous", .drive_frequency = asked};
    const auto driven = fit_driven(series, "rig.csv", options, {});
    ASSERT_TRUE(driven);
    const auto result = check_drive(*driven, series, options, {});
    ASSERT_TRUE(result) << in_words(result.error());
    EXPECT_EQ(result->fit.status, FitStatus::no_oscillation) << asked;
    EXPECT_THAT(
        in_words(result->fit.message),
        testing::StartsWith("no single swing: two modes swing here, and both decay, like those of coupled "
                            "pendulums: 1.1459"));
    EXPECT_EQ(result->modes.size(), 2u);
    EXPECT_TRUE(result->parameters.empty());
    EXPECT_FALSE(result->driven);
    EXPECT_EQ(result->options.drive_frequency, asked);
  }
}

// As if the swing had died down.
TEST(FitDriven, ABeatMayEndInItsNode) {
  std::mt19937 engine(3);
  std::normal_distribution<double> noise(0, 2e-4);
  Series series;
  series.column = "x (m)";
  series.quantity = "position";
  for (double left = 50; left > 0; left -= 0.05) {
    series.t.push_back(50 - left);
    series.y.push_back(0.03 * std::cos(6.06 * left) - 0.03 * std::exp(0.03 * left) * std::cos(6 * left) +
                       noise(engine));
  }
  auto free = fit_series(series, "rig.csv", {}, {});
  ASSERT_TRUE(free);
  const FittedRecording found = recognise_drive(*std::move(free), series, {}, {});
  ASSERT_TRUE(found.driven);
  EXPECT_NEAR(found.fit.motion.drive_frequency, 6.06, 1e-3);
}

// Within a few thousandths of resonance both lines are one: the transient alone tells that it is driven.
TEST(FitDriven, ADriveInResonanceThatIsNamedIsThere) {
  const int all = cases(24);
  int settled = 0, within = 0;
  for (int seed = 1; seed <= all; ++seed) {
    std::mt19937_64 engine(static_cast<unsigned>(seed));
    const auto among = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(engine);
    };
    const double w = 6 * among(1, 2.5), g = w * std::pow(10, among(-2.5, -1.7)), size = among(0.01, 0.03);
    Motion motion{.position = size * among(-1, 1)};
    motion.set_angular_frequency(w);
    motion.set_decay_rate(g);
    motion.drive_frequency = w * among(0.995, 1.005);
    const double force = 2 * g * w * size * among(0.5, 1.5), phase = among(-3, 3);
    motion.cosine = force * std::cos(phase);
    motion.sine = -force * std::sin(phase);
    Series series;
    series.column = "x (m)";
    series.quantity = "position";
    const double cycles = among(15, 60);
    for (int i = 0; i < 1500; ++i) series.t.push_back(two_pi / w * cycles * i / 1500);
    series.rate = 1 / series.t[1];
    series.y = observed_motion(motion, Drive::harmonic(), series.t, 0, 0.05 / w);
    std::normal_distribution<double> normal(0, 0.02 * size);
    for (double& y : series.y) y += normal(engine);
    const FitOptions options{
        .drive_frequency = std::to_string(motion.drive_frequency * among(0.997, 1.003) / two_pi) + " Hz"};
    auto driven = fit_driven(series, "rig.csv", options, {});
    ASSERT_TRUE(driven) << seed;
    const auto result = check_drive(*driven, series, options, {});
    ASSERT_TRUE(result) << seed;
    ASSERT_TRUE(result->driven) << seed << ": " << to_text(result->fit.law);
    if (result->fit.status != FitStatus::converged) continue;
    ++settled;
    const Estimate& own = *result->find("angular_frequency");
    within += own.low <= w && w <= own.high;
    EXPECT_NEAR(own.value, w, 4.5 * own.standard_error) << seed;
  }
  EXPECT_GE(settled, all - std::max(1, all / 20));
  EXPECT_GE(within, settled * 0.85);
}

TEST(FitForced, AForceIsPointedAtWhereTheFreeLawDoesNotDescribeTheMotion) {
  const std::string path = data("emps/first_part.csv");
  SKIP_WITHOUT(path);
  const auto result = fit(bytes_of(path), path, {});
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  ASSERT_TRUE(result->front().succeeded());
  ASSERT_GT(result->front().fit.explained, 0.95);
  EXPECT_THAT(in_words(result->front().notices),
              testing::Contains(
                  "if column \"Force\" holds what drives the motion, give fit --force-column \"Force\""));
}

TEST(FitForced, ForetellsTheSilverbox) {
  const std::string path = data("silverbox/silverbox_train.csv");
  SKIP_WITHOUT(path);
  FitOptions options;
  options.read.rate = 610.3515625;
  options.force_column = "V1";
  options.column = "V2";
  options.law = "viscous+cubic+quadratic";
  options.hold_out = 0.25;
  const auto result = fit(bytes_of(path), path, options);
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  EXPECT_EQ(result->front().between_samples, "band-limited");
  ASSERT_TRUE(result->front().held_out.has_value());
  EXPECT_LT(result->front().held_out->rms, 0.33e-3);
  for (const Candidate& candidate : result->front().candidates)
    if (candidate.between_samples == "linear") {
      EXPECT_NEAR(candidate.rms, 0.89e-3, 0.02e-3);
    }
}

TEST(FitDriven, FindsTheGeneratorOfTheBeats) {
  const std::string path =
      data("spring-disc-pasco/molla_dura_discopieno_battimenti_0.1419kg_frequenza_1.207hz.csv");
  SKIP_WITHOUT(path);
  for (const char* drive : cases({"1.207 Hz", "auto"})) {
    FitOptions options;
    options.column = "position";
    options.drive_frequency = drive;
    const auto result = fit(bytes_of(path), path, options);
    ASSERT_TRUE(result.ok()) << in_words(result.error());
    EXPECT_NEAR(result->front().find("drive_frequency")->value / (2 * std::numbers::pi), 1.207, 5e-4);
    EXPECT_LT(result->front().fit.residual.rms, 0.01 / std::sqrt(12.0));  // rounding alone
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
