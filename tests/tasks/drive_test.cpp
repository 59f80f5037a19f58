// The drives of `simulate`: recorded, pulses, chirps, unbalance and a shaking base.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cromer/analysis/frequency_response.h"
#include "cromer/analysis/steady_state.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/simulate/drive_setup.h"
#include "cromer/tasks/simulate/simulate.h"
#include "tests/support/bytes_of.h"
#include "tests/support/simulated.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::HasSubstr;

/// A recorded force of these samples.
SimulateOptions recorded(std::vector<double> values, double spacing) {
  SimulateOptions options;
  options.drive_file = "force.csv";
  options.drive_record = DriveRecord{std::move(values), spacing, {}};
  return options;
}

double peak(const SimulatedRun& of) {
  double most = 0;
  for (const double x : of.trajectory.x) most = std::max(most, std::abs(x));
  return most;
}

/// Chopra's examples: m = 0.2533, k = 10, c = 0.1592, p = 10 sin(pi t/0.6) for 0.6 s.
SimulateOptions chopra() {
  SimulateOptions options;
  options.mass = 0.2533;
  options.stiffness = 10;
  options.damping = 0.1592;
  options.method = {"exact"};
  options.step = 0.1;
  options.until = 1;
  return options;
}

TEST(Drive, MeetsChoprasInterpolation) {
  // A. K. Chopra, Dynamics of Structures, example 5.1: the half-sine sampled each 0.1 s, straight between.
  const double table[] = {0,      0.0318, 0.2274, 0.6336,  1.1339, 1.4896,
                          1.4480, 0.9037, 0.0579, -0.7577, -1.2432};
  SimulateOptions options = chopra();
  options.drive_file = "force.csv";
  DriveRecord record{{}, 0.1, {}};
  for (int i = 0; i <= 10; ++i) record.values.push_back(i <= 6 ? 10 * std::sin(std::numbers::pi * i / 6) : 0);
  options.drive_record = record;
  const SimulatedRun only = run(options);
  ASSERT_EQ(only.trajectory.size(), 11u);
  for (std::size_t i = 0; i < 11; ++i) EXPECT_NEAR(only.trajectory.x[i], table[i], 2e-4) << i;
}

TEST(Drive, MeetsChoprasTheoreticalHalfSine) {
  const double table[] = {0,      0.0328, 0.2332, 0.6487,  1.1605, 1.5241,
                          1.4814, 0.9245, 0.0593, -0.7751, -1.2718};
  SimulateOptions options = chopra();
  options.drive = "half-sine";
  options.drive_amplitude = 10;
  options.drive_duration = 0.6;
  const SimulatedRun only = run(options);
  for (std::size_t i = 0; i < 11; ++i) EXPECT_NEAR(only.trajectory.x[i], table[i], 2e-4) << i;
}

// The shortest recording: two rows, a straight line between them, and no run beyond the second.
TEST(Drive, TwoRowsAreARamp) {
  const auto two = drive_record("Time (s),Force (N)\n0,0\n0.5,3\n", "two.csv", {.quantity = "force"}, {});
  ASSERT_TRUE(two.ok()) << in_words(two.error());
  EXPECT_EQ(two->values, (std::vector<double>{0, 3}));
  EXPECT_EQ(two->spacing, 0.5);
  EXPECT_TRUE(in_words(two->notices).empty());
  SimulateOptions options = recorded({}, 0);
  options.drive_record = *two;
  options.mass = 2;
  options.stiffness = 50;
  options.damping = 0;
  options.position = 0;
  options.method = {"exact"};
  options.step = 0.25;
  options.until = 0.5;
  const SimulatedRun only = run(options);
  ASSERT_EQ(only.trajectory.size(), 3u);
  const double w = 5, slope = 3 / 0.5 / 2;  // [m/s^3] of the force on a unit mass
  for (std::size_t i = 0; i <= 2; ++i) {
    const double t = 0.25 * static_cast<double>(i);
    EXPECT_NEAR(only.trajectory.x[i], slope / (w * w) * (t - std::sin(w * t) / w), 1e-15) << i;
  }
  options.until = 0.51;
  EXPECT_THAT(in_words(simulate(options).error()), HasSubstr("the recording ends at 0.5 s"));
  const auto one = drive_record("Time (s),Force (N)\n0,1\n", "one.csv", {.quantity = "force"}, {});
  ASSERT_FALSE(one.ok());
  EXPECT_EQ(in_words(one.error()),
            "one.csv: column \"Force (N)\" has one sample, and a drive needs at least two samples");
}

TEST(Drive, MeetsChoprasPeaksOfElCentro) {
  const std::string bytes = bytes_of(CROMER_SOURCE_DIR "/../shared/data/ground-motion/elcentro_chopra.csv");
  if (bytes.empty()) GTEST_SKIP() << "no ../shared/data";
  const auto record = drive_record(bytes, "elcentro_chopra.csv", {.quantity = "acceleration"}, {});
  ASSERT_TRUE(record.ok()) << in_words(record.error());
  EXPECT_EQ(record->values.size(), 1560u);
  EXPECT_NEAR(record->spacing, 0.02, 1e-12);
  EXPECT_NEAR(record->values[1], 0.0063 * 9.80665, 1e-12);
  struct Row {
    double period, ratio, peak;  // [in], g = 386.4 in/s^2
  };
  for (const Row& row : {Row{0.5, 0.02, 2.676}, Row{1, 0.02, 5.971}, Row{2, 0.02, 7.471}, Row{2, 0, 9.919},
                         Row{2, 0.05, 5.375}}) {
    SimulateOptions options;
    options.mass = 3;  // the relative motion does not depend on it
    options.natural_frequency = 2 * std::numbers::pi / row.period;
    options.damping_ratio = row.ratio;
    options.base_motion = "elcentro_chopra.csv";
    options.drive_record = *record;
    options.method = {"exact"};
    options.step = 0.02;
    const double inches = peak(run(options)) / 9.80665 * 386.4;
    EXPECT_NEAR(inches, row.peak, std::max(2e-4 * row.peak, 5e-4)) << row.period << ' ' << row.ratio;
  }
}

TEST(Drive, OtherMethodsApproachTheExactMotion) {
  SimulateOptions options = recorded({0, 2, -1, 0.5, 3, 3, -2}, 0.1);
  options.stiffness = 40;
  options.damping = 0.4;
  options.method = {"exact"};
  options.step = 0.01;
  const SimulatedRun exact = run(options);
  for (const char* between : {"linear", "hold", "band-limited"}) {
    options.between_samples = between;
    options.method = {"exact"};
    const double truth = run(options).outcome.y.x;
    // rk4 meets every corner at a step's end; the jumps of hold cost it all but its first order.
    options.method = {"rk4"};
    options.step = 0.1 / 16;
    options.until = 0.6;
    const double off = std::abs(run(options).outcome.y.x - truth);
    EXPECT_LT(off, std::string(between) == "hold" ? 1e-2 : 1e-5) << between;
  }
}

TEST(Drive, ARecordingSetsStepAndEnd) {
  SimulateOptions options = recorded(std::vector<double>(101, 1.0), 0.02);
  options.stiffness = 4 * std::numbers::pi * std::numbers::pi;  // a period of 1 s, a 200th of it 0.005
  const SimulatedRun only = run(options);
  EXPECT_DOUBLE_EQ(only.step, 0.005);
  EXPECT_DOUBLE_EQ(only.until, 2);
  EXPECT_EQ(only.start, (State<double>{0, 0}));
}

TEST(Drive, AConstantRecordingIsAStep) {
  SimulateOptions options = recorded(std::vector<double>(101, 3.0), 0.1);
  options.stiffness = 9;
  options.damping = 0.3;
  options.method = {"exact"};
  const SimulatedRun sampled = run(options);
  SimulateOptions step;
  step.stiffness = 9;
  step.damping = 0.3;
  step.method = {"exact"};
  step.drive = "step";
  step.drive_amplitude = 3;
  step.step = sampled.step;
  step.until = sampled.until;
  const SimulatedRun once = run(step);
  ASSERT_EQ(once.trajectory.size(), sampled.trajectory.size());
  for (std::size_t i = 0; i < once.trajectory.size(); ++i)
    EXPECT_NEAR(once.trajectory.x[i], sampled.trajectory.x[i], 1e-13);
}

TEST(Drive, AChirpWithoutASweepIsTheHarmonicDrive) {
  SimulateOptions harmonic;
  harmonic.stiffness = 9;
  harmonic.drive_amplitude = 1;
  harmonic.drive_frequency = {2};
  harmonic.drive_phase = 0.3;
  harmonic.method = {"rk4"};
  harmonic.step = 0.01;
  harmonic.until = 20;
  SimulateOptions chirp = harmonic;
  chirp.drive = "chirp";
  chirp.drive_to = 2;
  chirp.drive_duration = 30;
  EXPECT_NEAR(run(chirp).outcome.y.x, run(harmonic).outcome.y.x, 1e-12);
}

TEST(Drive, AShakingBaseSettlesAtItsTransmissibility) {
  SimulateOptions options;
  options.mass = 2;
  options.natural_frequency = 6;
  options.damping_ratio = 0.1;
  options.drive = "base";
  options.base_displacement = 0.05;
  options.drive_frequency = {8};
  options.drive_phase = 0.4;
  options.method = {"exact"};
  options.until = 40;
  options.step = 0.005;
  const SimulatedRun only = run(options);
  const auto relative = measure_steady_state(only.trajectory, only.drive);
  ASSERT_TRUE(relative.ok());
  const SteadyState exact = frequency_response(only.oscillator, 2 * 8 * 8 * 0.05, 8);  // m w^2 Y
  EXPECT_NEAR(relative->amplitude / exact.amplitude, 1, 1e-9);
  EXPECT_NEAR(relative->phase_lag, exact.phase_lag, 1e-9);
  // The mass itself: the base's motion on top.
  Trajectory absolute = only.trajectory;
  for (std::size_t i = 0; i < absolute.size(); ++i) absolute.x[i] += 0.05 * std::cos(8 * absolute.t[i] + 0.4);
  const auto mass = measure_steady_state(absolute, only.drive);
  ASSERT_TRUE(mass.ok());
  EXPECT_NEAR(mass->amplitude / (0.05 * transmissibility(only.oscillator, 8).amplitude), 1, 1e-9);
  EXPECT_NEAR(mass->phase_lag, transmissibility(only.oscillator, 8).phase_lag, 1e-9);
}

TEST(Drive, AnUnbalancePushesWithTheSquareOfItsFrequency) {
  SimulateOptions options;
  options.drive = "unbalance";
  options.unbalance_mass = 0.02;
  options.eccentricity = 0.1;
  options.drive_frequency = {30};
  EXPECT_DOUBLE_EQ(run(options).drive.amplitude, 0.02 * 0.1 * 900);
}

TEST(Drive, OneThatBeginsAfterTheEndIsWarnedOf) {
  SimulateOptions late;
  late.drive = "step";
  late.drive_amplitude = 1;
  late.drive_start = 30;
  late.until = 10;
  const auto result = simulate(late);
  ASSERT_TRUE(result.ok());
  EXPECT_THAT(in_words(result->notices),
              testing::Contains(HasSubstr("the drive begins at 30 s, and the run ends at 10 s")));
}

TEST(Drive, RefusesWhatDoesNotFitTogether) {
  SimulateOptions heavy;
  heavy.drive = "unbalance";
  heavy.unbalance_mass = 2;
  heavy.eccentricity = 0.1;
  heavy.drive_frequency = {30};
  EXPECT_THAT(refusal(heavy), HasSubstr("--unbalance-mass: it is part of --mass (1 kg), and cannot be 2 kg"));
  SimulateOptions step;
  step.drive = "step";
  EXPECT_THAT(refusal(step), HasSubstr("--drive step needs --drive-amplitude"));
  step.drive_amplitude = 1;
  EXPECT_EQ(refusal(step), "");
  step.drive_frequency = {3};
  EXPECT_THAT(refusal(step), HasSubstr("--drive-frequency has no effect with --drive step"));
  SimulateOptions pulse;
  pulse.drive = "triangular";
  pulse.drive_amplitude = 1;
  EXPECT_THAT(refusal(pulse), HasSubstr("needs --drive-duration"));
  SimulateOptions wrong;
  wrong.drive = "triangulr";
  EXPECT_THAT(refusal(wrong), HasSubstr("did you mean triangular?"));
  SimulateOptions harmonic;
  harmonic.drive_duration = 3;
  EXPECT_THAT(refusal(harmonic), HasSubstr("--drive-duration has no effect with --drive harmonic"));
  SimulateOptions chirp;
  chirp.drive = "logarithmic-chirp";
  chirp.drive_amplitude = 1;
  chirp.drive_frequency = {0};
  chirp.drive_to = 5;
  EXPECT_THAT(refusal(chirp), HasSubstr("must be positive"));
  chirp.drive_frequency = {1};
  EXPECT_EQ(refusal(chirp), "");
  chirp.method = {"exact"};
  EXPECT_THAT(refusal(chirp), HasSubstr("no closed form for --drive logarithmic-chirp"));
  SimulateOptions both = recorded({0, 1}, 1);
  both.base_motion = "ground.csv";
  EXPECT_THAT(refusal(both), HasSubstr("both drive"));
  SimulateOptions rate;
  rate.read.rate = 100;
  EXPECT_THAT(refusal(rate), HasSubstr("--rate"));
  SimulateOptions between = recorded({0, 1}, 1);
  between.between_samples = "cubic";
  EXPECT_THAT(refusal(between), HasSubstr("none of linear, hold, band-limited"));
}

TEST(Drive, RefusesARecordingShorterThanTheRun) {
  SimulateOptions options = recorded({0, 1, 2}, 0.5);
  options.until = 1.5;
  EXPECT_THAT(refusal(options), HasSubstr("the recording ends at 1 s, before the run does (1.5 s)"));
  options.between_samples = "hold";  // the last value is held for as long as the others
  EXPECT_EQ(refusal(options), "");
  options.until = 1.6;
  EXPECT_THAT(refusal(options), HasSubstr("ends at 1.5 s"));
}

std::string file_refusal(const std::string& bytes, const std::string& quantity = "force",
                         const ReadOptions& read = {}) {
  const auto record = drive_record(bytes, "drive.csv", {.quantity = quantity}, read);
  return record ? "" : in_words(record.error());
}

/// A file of 40 samples at 100 a second; row 20 replaced where one is given.
std::string file_of(const std::string& header, const std::string& row = "", double jitter = 0) {
  std::string bytes = header + "\n";
  for (int i = 0; i < 40; ++i) {
    const double t = i * 0.01 + (i % 2 ? jitter : 0);
    bytes += i == 20 && !row.empty() ? row + "\n"
                                     : std::to_string(t) + "," + std::to_string(std::sin(0.3 * i)) + "\n";
  }
  return bytes;
}

TEST(Drive, AFileMustBeEvenAndWhole) {
  EXPECT_EQ(file_refusal(file_of("Time (s),Force (N)")), "");
  EXPECT_EQ(file_refusal(file_of("Time (s),Force (N)", "", 0.0001)), "");
  EXPECT_THAT(file_refusal(file_of("Time (s),Force (N)", "", 0.001)), HasSubstr("not evenly spaced"));
  EXPECT_THAT(file_refusal(file_of("Time (s),Force (N)", "0.2,")),
              HasSubstr("a gap of 0.02 s after t = 0.19 s"));
  EXPECT_THAT(file_refusal(file_of("Time (s),Force (N)", "0.2,NaN")), HasSubstr("fill in what is missing"));
  EXPECT_THAT(file_refusal(file_of("Time (s),Force (N)", "0.2,many")), HasSubstr("many"));
  EXPECT_THAT(file_refusal(file_of("Time (s),Position (m)")), HasSubstr("holds position, not a force"));
  EXPECT_THAT(file_refusal(file_of("Time (s),Force (N)"), "acceleration"),
              HasSubstr("holds force, not an acceleration"));
  EXPECT_THAT(file_refusal("Time (s),Force (N)\n0,1\n"), HasSubstr("at least two samples"));
  EXPECT_NE(file_refusal(""), "");
}

TEST(Drive, AFileInItsUnits) {
  const auto record =
      drive_record("Time (ms),Force (kN)\n0,1\n10,2\n20,-1\n", "drive.csv", {.quantity = "force"}, {});
  ASSERT_TRUE(record.ok()) << in_words(record.error());
  EXPECT_THAT(record->values, ::testing::ElementsAre(1000, 2000, -1000));
  EXPECT_DOUBLE_EQ(record->spacing, 0.01);
  ReadOptions rate;
  rate.rate = 50;
  const auto bare = drive_record("Force (N)\n1\n2\n3\n", "drive.csv", {.quantity = "force"}, rate);
  ASSERT_TRUE(bare.ok()) << in_words(bare.error());
  EXPECT_DOUBLE_EQ(bare->spacing, 0.02);
}

TEST(Drive, SeveralColumnsAreAsked) {
  const std::string bytes = "Time (s),Force x (N),Force y (N)\n0,1,4\n1,2,5\n2,3,6\n";
  EXPECT_THAT(file_refusal(bytes), HasSubstr("--drive-column"));
  const auto record = drive_record(bytes, "drive.csv", {.quantity = "force", .column = "Force y"}, {});
  ASSERT_TRUE(record.ok()) << in_words(record.error());
  EXPECT_EQ(record->values.front(), 4);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
