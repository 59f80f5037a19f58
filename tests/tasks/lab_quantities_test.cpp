// What a lab asks of a fitted law: decay against amplitude, budget of the spring constant, Keulegan-Carpenter
// number, textbook estimates, the motion sample by sample.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

#include "cromer/analysis/air.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/fit/fitted_motion.h"
#include "cromer/tasks/fit/lab_quantities.h"
#include "tests/tasks/disc_recording.h"

namespace cromer::core {
namespace CROMER_FILE {

FitOptions disc_options() {
  FitOptions options;
  options.mass = {Quantity{0.2176, 0.0003}};
  options.disc_diameter = Quantity{0.12, 0};
  return options;
}

FittedRecording fitted(const FitOptions& options, const Series& series) {
  const Result<FittedRecording> result = fit_series(series, "disc.csv", options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : in_words(result.error()));
  return result.ok() ? *result : FittedRecording{};
}

const Series& disc() {
  static const Series series = disc_recording();
  return series;
}

TEST(DecayByAmplitude, FollowsTheLawThatMadeTheRecord) {
  const Oscillator<double>& o = disc_oscillator;
  const AmplitudeDecay truth{.angular_frequency = std::sqrt(o.stiffness / o.mass),
                             .per_mass = divided_by_mass(o)};
  double chi_squared = 0;
  int points = 0;
  for (const unsigned seed : {2u, 3u, 4u}) {
    const FittedRecording result = fitted({}, disc_recording(seed));
    ASSERT_GE(result.decay_by_amplitude.size(), 10u);
    for (const AmplitudeRate& each : result.decay_by_amplitude) {
      const double off = (each.rate.value - truth.rate(each.amplitude)) / each.rate.standard_error;
      chi_squared += off * off;
      ++points;
      EXPECT_LT(each.rate.standard_error, 0.2 * each.rate.value);
      EXPECT_NEAR(each.law_rate, truth.rate(each.amplitude), 0.02 * each.law_rate);
    }
    EXPECT_GT(result.decay_by_amplitude.front().amplitude, 2 * result.decay_by_amplitude.back().amplitude);
  }
  // Chi squared of about sixty points: within four standard deviations of its mean.
  EXPECT_NEAR(chi_squared, points, 4 * std::sqrt(2.0 * points));
}

TEST(DecayByAmplitude, OneRateForAllShowsAgainstIt) {
  FitOptions options;
  options.law = "viscous";
  const FittedRecording result = fitted(options, disc());
  const AmplitudeRate& first = result.decay_by_amplitude.front();
  EXPECT_GT(first.rate.value - first.law_rate, 5 * first.rate.standard_error);
}

TEST(KeuleganCarpenter, IsTheWayOfTheDiscInItsDiameters) {
  const FittedRecording result = fitted(disc_options(), disc());
  ASSERT_TRUE(result.keulegan_carpenter);
  EXPECT_NEAR(result.keulegan_carpenter->value, 2 * std::numbers::pi * 0.036 / 0.12, 0.002);
  FitOptions uncertain = disc_options();
  uncertain.disc_diameter = Quantity{0.12, 0.0012};
  const Estimate number = *fitted(uncertain, disc()).keulegan_carpenter;
  EXPECT_NEAR(number.standard_error / number.value, 0.01, 2e-4);
}

TEST(DragCoefficient, CarriesTheTemperaturesUncertainty) {
  FitOptions options = disc_options();
  options.mass = {Quantity{0.2176, 0}};
  const Estimate without = *fitted(options, disc()).find("drag_coefficient");
  options.temperature = Quantity{293.15, 10};
  const FittedRecording with = fitted(options, disc());
  const Estimate coefficient = *with.find("drag_coefficient");
  EXPECT_DOUBLE_EQ(coefficient.value, without.value);
  const double share = 10 / 293.15 * coefficient.value;
  EXPECT_NEAR(coefficient.standard_error, std::hypot(without.standard_error, share), 1e-9);
  // Averaged over a cycle: C_d = 3 pi m q/(2 rho S w), q the slope of the decay rate.
  const AmplitudeDecay decay = amplitude_decay(with.fit);
  const double q = (decay.rate(0.02) - decay.rate(0.01)) / 0.01, w = decay.angular_frequency;
  const double area = std::numbers::pi / 4 * 0.12 * 0.12;
  const double averaged = 3 * std::numbers::pi * 0.2176 * q / (2 * air_density(293.15) * area * w);
  EXPECT_NEAR(coefficient.value, averaged, 1e-9 * averaged);
  // nu goes as about T^1.7.
  EXPECT_NEAR(with.reynolds_max->standard_error / with.reynolds_max->value, 1.76 * 10 / 293.15, 2e-3);
}

TEST(StiffnessBudget, SumsUpToTheStiffnesssError) {
  FitOptions options = disc_options();
  options.mass = {Quantity{0.2176, 1e-6}};
  options.spring_mass = Quantity{0.01, 6e-6};
  const FittedRecording result = fitted(options, disc());
  ASSERT_EQ(result.stiffness_budget.size(), 3u);
  double variance = 0, share = 0;
  for (const Contribution& each : result.stiffness_budget) {
    variance += each.contribution * each.contribution;
    share += each.share;
  }
  EXPECT_NEAR(std::sqrt(variance), result.find("stiffness")->standard_error, 1e-9);
  EXPECT_NEAR(share, 1, 1e-12);
  EXPECT_EQ(result.stiffness_budget[1].quantity, "spring_mass");
  EXPECT_NEAR(result.stiffness_budget[1].contribution / result.stiffness_budget[0].contribution, 2, 1e-9);
}

TEST(MonteCarlo, AgreesWithThePropagatedIntervalAndRepeats) {
  FitOptions options = disc_options();
  options.spring_mass = Quantity{0.01, 0.001};
  options.monte_carlo = 200'000;
  const FittedRecording result = fitted(options, disc());
  ASSERT_TRUE(result.monte_carlo);
  const Estimate k = *result.find("stiffness");
  const MonteCarlo& trials = *result.monte_carlo;
  EXPECT_NEAR(trials.mean, k.value, 5 * k.standard_error / std::sqrt(200'000));
  EXPECT_NEAR(trials.standard_deviation / k.standard_error, 1, 0.01);
  EXPECT_NEAR((trials.high - trials.low) / (k.high - k.low), 1, 0.01);
  EXPECT_EQ(trials.mean, fitted(options, disc()).monte_carlo->mean);
  options.seed = 2;
  EXPECT_NE(trials.mean, fitted(options, disc()).monte_carlo->mean);
}

TEST(MonteCarlo, FewDegreesOfFreedomWidenTheInterval) {
  const Estimate frequency = make_estimate(9, 0.01, student_95(4));
  const Body body{Quantity{0.2, 0}, {}, {}, {}};
  const MonteCarlo trials = *stiffness_monte_carlo(frequency, 4, body, 400'000, 1);
  const double error = 2 * 0.2 * 9 * 0.01;
  EXPECT_NEAR((trials.high - trials.low) / (2 * student_95(4) * error), 1, 0.01);
  EXPECT_NEAR(trials.standard_deviation / (error * std::sqrt(2.0)), 1, 0.05);  // t: sqrt(nu/(nu - 2))
  const std::atomic<bool> stop{true};
  EXPECT_FALSE(stiffness_monte_carlo(frequency, 4, body, 400'000, 1, Watch{&stop, {}}));
}

TEST(Textbook, StandsBesideTheFitOnRequest) {
  EXPECT_FALSE(fitted({}, disc()).textbook);
  FitOptions options;
  options.textbook = true;
  const FittedRecording result = fitted(options, disc());
  ASSERT_TRUE(result.textbook && result.textbook->decrement && result.textbook->bandwidth);
  // From 0.0142 1/s at the start to 0.0062 at the end, and 0.0087 in the middle, of a period of 0.71 s.
  EXPECT_NEAR(result.textbook->decrement->value, 0.0087 * 0.71, 0.05 * 0.0062);
  EXPECT_GT(result.textbook->bandwidth->width / 2, 0.0098);  // broadened by the record's length
}

TEST(FittedMotion, IsTheTrueMotionAndTheSamplesAgree) {
  FitOptions options = disc_options();
  const FittedRecording result = fitted(options, disc());
  const FittedMotion motion = fitted_motion(result);
  ASSERT_EQ(motion.t.size(), disc().t.size());
  EXPECT_FALSE(motion.per_mass);
  const double A = 0.036, w = std::sqrt(disc_oscillator.stiffness / disc_oscillator.mass);
  EXPECT_NEAR(motion.energy.front(), 0.5 * 17.04 * A * A, 2e-3 * 0.5 * 17.04 * A * A);
  double sum = 0, square = 0;
  int n = 0;
  for (std::size_t i = 0; i < motion.t.size(); ++i) {
    EXPECT_NEAR(motion.x[i] + result.fit.equilibrium().value + motion.residual[i], disc().y[i], 1e-12);
    if (std::isnan(motion.local_velocity[i])) continue;
    const double off = motion.local_velocity[i] - motion.v[i];
    sum += off * motion.v[i];
    square += motion.v[i] * motion.v[i];
    EXPECT_NEAR(off, 0, 6 * 3e-4 * w * std::sqrt(2.0 / 71));  // the noise that the window lets through
    ++n;
  }
  EXPECT_GT(n, 11'000);
  // A central difference over as many samples would shrink the velocity by half.
  EXPECT_NEAR(sum / square, 0, 2e-4);
}

/// A fit that says 3 rad/s and 0.02 1/s of 0.4 m, with an uncertain frequency.
LawFit swinging() {
  LawFit fit;
  fit.law = law_of("viscous");
  fit.student = 2;
  fit.names = {"angular_frequency", "decay_rate", "position", "velocity"};
  fit.estimates = {make_estimate(3, 0.003, 2), make_estimate(0.02, 0, 2), make_estimate(0.4, 0, 2),
                   make_estimate(0, 0, 2)};
  fit.covariance.assign(16, 0);
  fit.motion.law = fit.law;
  fit.motion.per_mass.stiffness = 9.000123456789;
  fit.motion.per_mass.damping = 0.04;
  fit.motion.position = 0.4;
  return fit;
}

Series even(double rate, double until, double from = 0) {
  Series series;
  series.column = "x (m)";
  series.quantity = "position";
  series.rate = rate;
  series.t = {from, from + until};
  series.y = {0, 0};
  return series;
}

std::string value_of_option(const std::vector<TypedOption>& settings, std::string_view option) {
  for (const TypedOption& each : settings)
    if (each.first == option) return each.second;
  return "none";
}

TEST(SimulateSettings, HaveTheDigitsThatAreKnownAndAStepThatDividesASample) {
  const LawFit fit = swinging();
  const auto settings = simulate_settings(fit, even(10, 7.3), 2);
  EXPECT_EQ(value_of_option(settings, "mass"), "2");
  // With 0.2 %: to about a thousandth of that. What has no error has all its digits.
  EXPECT_EQ(value_of_option(settings, "stiffness"), "18.0002");
  EXPECT_EQ(value_of_option(settings, "damping"), "0.08");
  EXPECT_EQ(value_of_option(settings, "position"), "0.4");
  EXPECT_EQ(value_of_option(settings, "velocity"), "0");
  EXPECT_EQ(value_of_option(settings, "method"), "rk4");
  EXPECT_EQ(value_of_option(settings, "until"), "7.3");
  EXPECT_EQ(value_of_option(settings, "step"), "0.01");  // 2.09 s take at least 200 of them
  EXPECT_EQ(value_of_option(simulate_settings(fit, even(500, 7.3), 2), "step"), "0.002");
  // Of uneven samples the steps fill the record.
  EXPECT_NEAR(std::stod(value_of_option(simulate_settings(fit, even(0, 7.3), 2), "step")), 7.3 / 698, 1e-15);
  EXPECT_EQ(value_of_option(settings, "drive-amplitude"), "none");
}

TEST(SimulateSettings, AreNoneOfWhatCannotBeRunAgain) {
  const auto none = [](auto change) {
    LawFit fit = swinging();
    change(fit);
    return simulate_settings(fit, even(10, 7), 2).empty();
  };
  EXPECT_FALSE(none([](LawFit&) {}));
  EXPECT_TRUE(none([](LawFit& fit) { fit.drive.kind = DriveKind::recorded; }));
  EXPECT_TRUE(none([](LawFit& fit) { fit.law = Law{}; }));
  EXPECT_TRUE(none([](LawFit& fit) { fit.law = fit.law.with(law_with<Hysteresis, Friction>); }));
  EXPECT_FALSE(none([](LawFit& fit) { fit.law = fit.law.with(law_with<Hysteresis>); }));
  EXPECT_TRUE(none([](LawFit& fit) { fit.motion.position = HUGE_VAL; }));
  EXPECT_TRUE(none([](LawFit& fit) { fit.motion.velocity = std::nan(""); }));
  EXPECT_TRUE(none([](LawFit& fit) { fit.motion.per_mass.stiffness = HUGE_VAL; }));
  EXPECT_TRUE(simulate_settings(swinging(), even(10, 7), HUGE_VAL).empty());
}

TEST(OverSettings, NameTheRecordingAndHowItIsRead) {
  FittedRecording fitted;
  fitted.file = "lab.csv";
  fitted.series = even(10, 7.3, 0.1 + 0.2);
  fitted.simulate = {{"mass", "1"}};
  fitted.fit.names = {"equilibrium"};
  fitted.fit.estimates = {make_estimate(0.123456789, 0.001, 2)};
  using Settings = std::vector<TypedOption>;
  EXPECT_EQ(
      over_settings(fitted),
      (Settings{
          {"over", "lab.csv"}, {"over-column", "x (m)"}, {"over-from", "0.3"}, {"over-offset", "0.123457"}}));
  fitted.series.run = 2;
  fitted.fit.estimates = {make_estimate(0, 0.001, 2)};
  ReadOptions& read = fitted.options.read;
  read.rate = 10;
  read.time_column = "t";
  read.delimiter = ";";
  read.decimal = ",";
  read.skip_bad_rows = true;
  EXPECT_EQ(over_settings(fitted), (Settings{{"over", "lab.csv"},
                                             {"over-column", "x (m)"},
                                             {"over-run", "2"},
                                             {"over-from", "0.3"},
                                             {"rate", "10"},
                                             {"time-column", "t"},
                                             {"delimiter", ";"},
                                             {"decimal", ","},
                                             {"skip-bad-rows", ""}}));
  const auto none = [&](auto change) {
    FittedRecording other = fitted;
    change(other);
    return over_settings(other).empty();
  };
  EXPECT_TRUE(none([](auto& other) { other.simulate.clear(); }));
  EXPECT_TRUE(none([](auto& other) { other.of_arrays = true; }));
  EXPECT_TRUE(none([](auto& other) { other.file = ""; }));
  EXPECT_TRUE(none([](auto& other) { other.file = "-"; }));
  EXPECT_TRUE(none([](auto& other) { other.series.quantity = "velocity"; }));
  EXPECT_FALSE(none([](auto& other) { other.series.quantity = "angle"; }));
}

TEST(Headline, IsOfWhatIsFiniteAndOfAFitThatCanBeUsed) {
  FittedRecording fitted;
  fitted.series = even(10, 7);
  fitted.fit = swinging();
  fitted.derived = {{"frequency", make_estimate(0.5, 0.1, 2), "Hz"}};
  fitted.parameters = {{"stiffness", make_estimate(HUGE_VAL, 0.1, 2), "N/m"}};
  const auto names = [&] {
    std::vector<std::string> found;
    for (const Parameter& each : headline_of(fitted)) found.push_back(each.name);
    return found;
  };
  EXPECT_THAT(names(), testing::ElementsAre("frequency", "decay_rate_start", "decay_rate_end"));
  fitted.parameters[0].estimate.value = 18;
  fitted.reynolds_max = make_estimate(100, 1, 2);
  EXPECT_THAT(names(), testing::ElementsAre("frequency", "stiffness", "decay_rate_start", "decay_rate_end",
                                            "reynolds_max"));
  fitted.series.t = {3};
  EXPECT_THAT(names(), testing::ElementsAre("frequency", "stiffness", "reynolds_max"));
  fitted.series.t = {3, 4};
  fitted.fit.status = FitStatus::too_noisy;
  EXPECT_THAT(names(), testing::ElementsAre("frequency", "stiffness", "reynolds_max"));
}

TEST(InterruptedFit, SaysThatResultsBesideTheLawAreMissing) {
  const Series series = disc_recording(4, 20);
  const auto interrupted_at = [&](int n, int& looks) {
    std::atomic<bool> interrupt{false};
    looks = 0;
    Watch watch{.interrupt = &interrupt};
    watch.pulse = [&] { interrupt = ++looks >= n; };
    FitOptions options = disc_options();
    options.law = "viscous+drag";
    return *fit_series(series, "disc.csv", options, watch);
  };
  int looks = 0;
  EXPECT_EQ(interrupted_at(std::numeric_limits<int>::max(), looks).fit.status, FitStatus::converged);
  const FittedRecording late = interrupted_at(looks, looks);
  EXPECT_EQ(late.fit.status, FitStatus::iteration_limit);
  EXPECT_EQ(in_words(late.fit.message),
            "interrupted: the law is fitted, but some results that follow from it are missing");
  EXPECT_NE(late.find("angular_frequency"), nullptr);
  EXPECT_TRUE(late.reynolds_max);
}

TEST(OtherStiffness, IsThatOfALawWhichFitsNearlyAsWell) {
  FittedRecording fitted;
  fitted.fit.residual.rms = 1e-3;
  fitted.fit.names = {"angular_frequency"};
  fitted.fit.estimates = {{6, 0.01, 5.98, 6.02}};
  fitted.parameters = {{"stiffness", {7.2, 0.02, 7.16, 7.24}, "N/m"}};
  const Law odd = law_of("viscous+odd-quadratic");
  fitted.candidates = {{law_of("viscous"), 1.11e-3, 0, true, 5.5},
                       {law_of("friction"), 1.05e-3, 0, false, 5.5},
                       {law_of("drag"), 1.05e-3, 0, true, 6.01},
                       {odd, 1.09e-3, 0, true, 5.9},
                       {law_of("viscous+cubic"), 1.09e-3, 0, true, 5.95}};
  const auto other = other_stiffness(fitted);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->law, odd);
  EXPECT_NEAR(other->stiffness, 7.2 * std::pow(5.9 / 6, 2), 1e-12);
  EXPECT_EQ(other->rms, 1.09e-3);
  fitted.candidates.resize(3);
  EXPECT_FALSE(other_stiffness(fitted));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
