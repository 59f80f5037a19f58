// From options to the drive of a run: what each drive needs, may take, and refuses.
#include "cromer/tasks/simulate/drive_setup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cromer/documents/words/words.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::IsEmpty;

std::string refused(const SimulateOptions& options) {
  const auto checked = check_drive(options);
  return checked ? "" : in_words(checked.error());
}

/// Gives the option of that name its value of 1.
void give(SimulateOptions& o, std::string_view name) {
  if (name == "drive-amplitude") o.drive_amplitude = 1;
  if (name == "drive-frequency") o.drive_frequency = {1};
  if (name == "drive-phase") o.drive_phase = 1;
  if (name == "drive-start") o.drive_start = 1;
  if (name == "drive-duration") o.drive_duration = 1;
  if (name == "drive-to") o.drive_to = 1;
  if (name == "unbalance-mass") o.unbalance_mass = 1;
  if (name == "eccentricity") o.eccentricity = 1;
  if (name == "base-displacement") o.base_displacement = 1;
  if (name == "drive-column") o.drive_column = "1";
  if (name == "between-samples") o.between_samples = "linear";
}

constexpr std::string_view all_options[] = {
    "drive-amplitude", "drive-frequency", "drive-phase",       "drive-start",  "drive-duration", "drive-to",
    "unbalance-mass",  "eccentricity",    "base-displacement", "drive-column", "between-samples"};

struct Takes {
  std::string drive;
  std::vector<std::string_view> needs, takes;
};

const Takes all_drives[] = {
    {"step", {"drive-amplitude"}, {"drive-start"}},
    {"rectangular", {"drive-amplitude", "drive-duration"}, {"drive-start"}},
    {"half-sine", {"drive-amplitude", "drive-duration"}, {"drive-start"}},
    {"triangular", {"drive-amplitude", "drive-duration"}, {"drive-start"}},
    {"chirp",
     {"drive-amplitude", "drive-frequency", "drive-to"},
     {"drive-phase", "drive-start", "drive-duration"}},
    {"logarithmic-chirp",
     {"drive-amplitude", "drive-frequency", "drive-to"},
     {"drive-phase", "drive-start", "drive-duration"}},
    {"unbalance", {"drive-frequency", "unbalance-mass", "eccentricity"}, {"drive-phase"}},
    {"base", {"drive-frequency", "base-displacement"}, {"drive-phase"}},
    {"harmonic", {}, {"drive-amplitude", "drive-frequency", "drive-phase"}},
};

TEST(DriveSetup, EachDriveNeedsTakesAndRefusesItsOwn) {
  const auto is_in = [](const std::vector<std::string_view>& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  for (const Takes& one : all_drives) {
    SimulateOptions with_needs;
    with_needs.drive = one.drive;
    for (const std::string_view needed : one.needs) give(with_needs, needed);
    EXPECT_EQ(refused(with_needs), "") << one.drive;
    for (const std::string_view missing : one.needs) {
      SimulateOptions options;
      options.drive = one.drive;
      for (const std::string_view needed : one.needs)
        if (needed != missing) give(options, needed);
      EXPECT_EQ(refused(options), "--drive " + one.drive + " needs --" + std::string(missing));
    }
    SimulateOptions with_all = with_needs;
    for (const std::string_view taken : one.takes) give(with_all, taken);
    EXPECT_EQ(refused(with_all), "") << one.drive;
    for (const std::string_view other : all_options) {
      if (is_in(one.needs, other) || is_in(one.takes, other)) continue;
      SimulateOptions options = with_needs;
      give(options, other);
      EXPECT_EQ(refused(options), "--" + std::string(other) + " has no effect with --drive " + one.drive +
                                      "; leave one of them out");
    }
  }
}

TEST(DriveSetup, HasANameOnceItDrives) {
  EXPECT_EQ(drive_name({}), "none");
  EXPECT_EQ(drive_name({.drive = "harmonic"}), "none");
  EXPECT_EQ(drive_name({.drive_amplitude = 1}), "harmonic");
  EXPECT_EQ(drive_name({.drive = "step"}), "step");
  EXPECT_EQ(drive_name({.drive_file = "f"}), "drive-file");
  EXPECT_EQ(drive_name({.base_motion = "f"}), "base-motion");
  EXPECT_EQ(
      refused({.drive = "stepp"}),
      "--drive: there is no drive \"stepp\"; did you mean step? (harmonic, step, rectangular, half-sine, "
      "triangular, chirp, logarithmic-chirp, unbalance, base)");
  EXPECT_EQ(refused({.drive_amplitude = 2}),
            "--drive-amplitude: 2 N needs a --drive-frequency (0 is a constant force)");
  EXPECT_EQ(refused({.drive_amplitude = 2, .drive_frequency = {0}}), "");
}

TEST(DriveSetup, OptionsOfReadingNeedAFile) {
  const std::string said =
      "--rate, --time-column, --delimiter, --decimal and --skip-bad-rows are for reading a --drive-file or a "
      "--base-motion, and none is given";
  ReadOptions each[5];
  each[0].rate = 1;
  each[1].time_column = "t";
  each[2].delimiter = ",";
  each[3].decimal = ".";
  each[4].skip_bad_rows = true;
  for (const ReadOptions& reading : each) {
    SimulateOptions options;
    options.read = reading;
    EXPECT_EQ(refused(options), said);
    options.drive_file = "f.csv";
    options.drive_record = DriveRecord{{1, 2}, 0.5, {}};
    EXPECT_EQ(refused(options), "");
  }
  SimulateOptions unread{.drive_file = "f.csv"};
  EXPECT_EQ(refused(unread), "--drive-file: the file's samples were not read");
  unread = {.base_motion = "f.csv"};
  EXPECT_EQ(refused(unread), "--base-motion: the file's samples were not read");
}

TEST(DriveSetup, ALogarithmicChirpHasNoZero) {
  SimulateOptions chirp{
      .drive = "logarithmic-chirp", .drive_amplitude = 1, .drive_frequency = {1}, .drive_to = 2};
  EXPECT_EQ(refused(chirp), "");
  const std::string said =
      "--drive logarithmic-chirp: --drive-frequency and --drive-to must be positive; a sweep from or to 0 is "
      "--drive "
      "chirp";
  chirp.drive_frequency = {1, 0};
  EXPECT_EQ(refused(chirp), said);
  chirp.drive_frequency = {1};
  chirp.drive_to = 0;
  EXPECT_EQ(refused(chirp), said);
  chirp.drive = "chirp";
  EXPECT_EQ(refused(chirp), "");
}

TEST(DriveSetup, AForceIsThatOfItsKind) {
  EXPECT_EQ(harmonic_drive({.drive_amplitude = 3, .drive_phase = 0.5}, 2, 5)->amplitude, 3);
  EXPECT_EQ(harmonic_drive({.drive_amplitude = 3, .drive_phase = 0.5}, 2, 5)->frequency, 2);
  EXPECT_EQ(harmonic_drive({.drive_amplitude = 3, .drive_phase = 0.5}, 2, 5)->phase, 0.5);
  EXPECT_EQ(
      harmonic_drive({.drive = "unbalance", .unbalance_mass = 0.5, .eccentricity = 0.25}, 4, 5)->amplitude,
      2);
  EXPECT_EQ(harmonic_drive({.drive = "base", .base_displacement = 0.25}, 4, 5)->amplitude, 20);
  EXPECT_FALSE(harmonic_drive({.drive = "step", .drive_amplitude = 1}, 4, 5));
  SimulatedRun run;
  SimulateOptions heavy{.drive = "unbalance", .unbalance_mass = 1, .eccentricity = 1};
  EXPECT_TRUE(set_drive(heavy, 1, run));
  heavy.unbalance_mass = 1.5;
  EXPECT_EQ(in_words(set_drive(heavy, 1, run).error()),
            "--unbalance-mass: it is part of --mass (1 kg), and cannot be 1.5 kg");
  EXPECT_EQ(in_words(set_drive({.drive = "base", .base_displacement = 1}, 1e200, run).error()),
            "--drive base: the force at 1e+200 rad/s is beyond the largest number");
}

TEST(DriveSetup, PulsesAndChirpsHaveTheirTimes) {
  SimulatedRun run;
  EXPECT_EQ(drive_period(run), 0);
  EXPECT_EQ(drive_begin(run), 0);
  EXPECT_EQ(drive_end(run), 0);
  run.drive = {.amplitude = 1, .frequency = 2, .phase = 0};
  EXPECT_DOUBLE_EQ(drive_period(run), M_PI);
  run.drive.frequency = 0;
  EXPECT_EQ(drive_period(run), 0);
  run.drive = {.amplitude = 0, .frequency = 2, .phase = 0};
  EXPECT_EQ(drive_period(run), 0);
  ASSERT_TRUE(set_drive({.drive = "half-sine", .drive_amplitude = 1, .drive_start = 0.5, .drive_duration = 2},
                        0, run));
  EXPECT_EQ(std::get<PulseDrive<double>>(*run.general).shape, PulseShape::half_sine);
  EXPECT_EQ(drive_period(run), 2);
  EXPECT_EQ(drive_begin(run), 0.5);
  EXPECT_EQ(drive_end(run), 2.5);
  SimulateOptions chirp{
      .drive = "chirp", .drive_amplitude = 1, .drive_to = 4, .drive_start = 0.5, .drive_duration = 2};
  ASSERT_TRUE(set_drive(chirp, 8, run));
  EXPECT_FALSE(std::get<ChirpDrive<double>>(*run.general).logarithmic);
  EXPECT_EQ(run.drive.frequency, 8);
  EXPECT_DOUBLE_EQ(drive_period(run), M_PI / 4);
  EXPECT_EQ(drive_begin(run), 0.5);
  EXPECT_EQ(drive_end(run), 2.5);
  chirp.drive = "logarithmic-chirp";
  ASSERT_TRUE(set_drive(chirp, 2, run));
  EXPECT_TRUE(std::get<ChirpDrive<double>>(*run.general).logarithmic);
  EXPECT_DOUBLE_EQ(drive_period(run), M_PI / 2);
  chirp.drive = "chirp";
  chirp.drive_to = 0;
  ASSERT_TRUE(set_drive(chirp, 0, run));
  EXPECT_EQ(drive_period(run), 0);
  for (const auto& [name, shape] : {std::pair{"step", PulseShape::step},
                                    {"rectangular", PulseShape::rectangular},
                                    {"triangular", PulseShape::triangular}}) {
    ASSERT_TRUE(set_drive({.drive = name, .drive_amplitude = 1}, 0, run));
    EXPECT_EQ(std::get<PulseDrive<double>>(*run.general).shape, shape) << name;
  }
}

TEST(DriveSetup, AChirpEndsWithItsRun) {
  SimulateOptions chirp{.drive = "chirp", .drive_amplitude = 1, .drive_to = 4, .drive_start = 3};
  SimulatedRun run;
  ASSERT_TRUE(set_drive(chirp, 2, run));
  run.method = "rk4";
  run.until = 3;
  EXPECT_EQ(in_words(end_drive(chirp, run).error()),
            "--drive-start: the chirp begins at 3 s, and the run ends at 3 s; give --until");
  run.until = 5;
  ASSERT_TRUE(end_drive(chirp, run));
  EXPECT_EQ(drive_end(run), 5);
  chirp.drive_duration = 1;
  ASSERT_TRUE(set_drive(chirp, 2, run));
  ASSERT_TRUE(end_drive(chirp, run));
  EXPECT_EQ(drive_end(run), 4);
  run.method = "exact";
  EXPECT_EQ(in_words(end_drive(chirp, run).error()),
            "--method exact: there is no closed form for --drive chirp; choose another method, for instance "
            "dormand-prince or rk4 with a short step");
}

TEST(DriveSetup, ExactTakesNoDriveWithFriction) {
  SimulateOptions step{.law = {.friction = 1}, .drive = "step", .drive_amplitude = 1};
  SimulatedRun run;
  run.oscillator.friction = 1;
  ASSERT_TRUE(set_drive(step, 0, run));
  run.method = "rk4";
  EXPECT_TRUE(end_drive(step, run));
  run.method = "exact";
  EXPECT_EQ(
      in_words(end_drive(step, run).error()),
      "--method exact: with friction there is no closed form under a drive (step); leave one out or choose "
      "another method");
  run.oscillator.friction = 0;
  EXPECT_TRUE(end_drive(step, run));
}

TEST(DriveSetup, ARecordingPushesTheMassAgainstItsGround) {
  SimulateOptions options{.mass = 4, .base_motion = "ground.csv"};
  options.drive_record = DriveRecord{{1, -2, 3}, 0.5, {}};
  SimulatedRun run;
  ASSERT_TRUE(set_drive(options, 0, run));
  EXPECT_THAT(*std::get<SampledDrive>(*run.general).force, ElementsAre(-4, 8, -12));
  run.until = 1 + 1e-12;
  EXPECT_TRUE(end_drive(options, run));
  run.until = 1.25;
  EXPECT_EQ(in_words(end_drive(options, run).error()),
            "--base-motion: the recording ends at 1 s, before the run does (1.25 s); shorten --until");
  options.base_motion = "";
  options.drive_file = "force.csv";
  ASSERT_TRUE(set_drive(options, 0, run));
  EXPECT_THAT(*std::get<SampledDrive>(*run.general).force, ElementsAre(1, -2, 3));
  EXPECT_EQ(std::get<SampledDrive>(*run.general).spacing, 0.5);
  EXPECT_EQ(drive_end(run), 1);
  EXPECT_EQ(drive_period(run), 0);
  EXPECT_EQ(drive_begin(run), 0);
  options.between_samples = "hold";
  ASSERT_TRUE(set_drive(options, 0, run));
  EXPECT_EQ(std::get<SampledDrive>(*run.general).between, BetweenSamples::hold);
  options.between_samples = "band-limited";
  ASSERT_TRUE(set_drive(options, 0, run));
  EXPECT_EQ(std::get<SampledDrive>(*run.general).spacing, 0.5 / 16);
  EXPECT_EQ(std::get<SampledDrive>(*run.general).force->size(), 33u);
}

Result<DriveRecord> record_of(const std::string& bytes, const DriveRequest& request) {
  return drive_record(bytes, "f.csv", request, {});
}

std::string record_refusal(const std::string& bytes, const DriveRequest& request = {.quantity = "force"}) {
  const auto record = record_of(bytes, request);
  return record ? "" : in_words(record.error());
}

TEST(DriveFile, EvenTimesMayBeOffByAFiftieth) {
  const auto shifted = [](const char* middle) {
    return record_refusal(std::string("Time (s),Force (N)\n0,1\n1,2\n") + middle + ",3\n3,2\n4,1\n");
  };
  EXPECT_EQ(shifted("2.019"), "");
  EXPECT_EQ(shifted("1.981"), "");
  EXPECT_EQ(shifted("2.021"),
            "f.csv: line 4: the times are not evenly spaced (2.021 s where 2 s is expected, one sample every "
            "1 s); a "
            "drive needs even samples: resample it first");
  EXPECT_NE(shifted("1.979"), "");
}

TEST(DriveFile, SaysWhichColumnItCouldBe) {
  EXPECT_EQ(record_refusal("Time (s),Force x (N),Force y (N),Position (m)\n0,1,4,1\n1,2,5,1\n2,3,6,1\n"),
            "f.csv: which column is the force? \"Force x\", \"Force y\"; say it with --drive-column");
  EXPECT_EQ(
      record_refusal("Time (s),Position (m)\n0,1\n1,2\n2,3\n"),
      "f.csv: column \"Position (m)\" holds position, not a force (N); choose another with --drive-column");
  EXPECT_EQ(
      record_refusal("Time (s),Position (m)\n0,1\n1,2\n2,3\n",
                     {.quantity = "acceleration", .column_option = "column", .use = "spectrum"}),
      "f.csv: column \"Position (m)\" holds position, not an acceleration (m/s^2 or g); choose another with "
      "--column");
  EXPECT_EQ(record_refusal("Time (s),Force (N)\n0,1\n"),
            "f.csv: column \"Force (N)\" has one sample, and a drive needs at least two samples");
  EXPECT_EQ(record_refusal("Time (s),Force (N)\n0,1\n1,2\n2,3\n", {.quantity = "force", .run = 2}),
            "f.csv: there is no run 2: the file has 1 run");
  EXPECT_EQ(record_refusal("Time (s),Force (N)\n0,1\n1,2\n2,3\n", {.quantity = "force", .run = 1}), "");
}

TEST(DriveFile, SaysThatItBeginsLate) {
  const std::string late = "Time (s),Force (N)\n5,1\n6,2\n7,3\n";
  EXPECT_THAT(in_words(record_of(late, {.quantity = "force"})->notices),
              ElementsAre("f.csv: its first sample, at 5 s, acts at the run's start, t = 0"));
  EXPECT_THAT(in_words(record_of(late, {.quantity = "force", .use = "spectrum"})->notices), IsEmpty());
  EXPECT_TRUE(record_of(late, {.quantity = "force"})->unit_known);
  EXPECT_EQ(record_of(late, {.quantity = "force"})->column, "Force (N)");
  EXPECT_FALSE(record_of("Time (s),Force\n0,1\n1,2\n", {.quantity = "force"})->unit_known);
  const auto share = record_of("Time (s),Force (%)\n0,1\n1,2\n", {.quantity = "force"});
  EXPECT_FALSE(share->unit_known);
  EXPECT_THAT(share->values, testing::ElementsAre(1, 2));
  EXPECT_THAT(
      in_words(share->notices),
      testing::Contains(testing::HasSubstr("\"%\" of column \"Force (%)\" is no unit of force: its values")));
  EXPECT_THAT(in_words(record_of("Time (s),Force (N)\n0.019,1\n1.019,2\n", {.quantity = "force"})->notices),
              IsEmpty());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
