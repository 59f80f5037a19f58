// Recorded drives from the command line and from a study.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::HasSubstr;

/// One second of ground acceleration, 100 samples a second.
std::string ground() {
  std::string bytes = "Time (s),acc (g)\n";
  for (int i = 0; i <= 100; ++i)
    bytes += std::to_string(i * 0.01) + "," + std::to_string(0.1 * std::sin(0.2 * i)) + "\n";
  return bytes;
}

TEST(DriveFile, DrivesAndIsNamed) {
  const Folder folder;
  folder.write("ground.csv", ground());
  const Finished end = folder.run({"simulate", "--stiffness", "400", "--base-motion", "ground.csv",
                                   "--method", "exact", "--step", "0.01", "--json"});
  EXPECT_EQ(end.status, 0) << end.err;
  const auto only = end.json()["runs"][0];
  EXPECT_EQ(only["parameters"]["drive"], "base-motion");
  EXPECT_EQ(only["parameters"]["drive_file"], "ground.csv");
  EXPECT_EQ(only["parameters"]["between_samples"], "linear");
  EXPECT_NEAR(only["final"]["t"].get<double>(), 1, 1e-9);
  EXPECT_NE(only["final"]["x"].get<double>(), 0);
}

TEST(DriveFile, ShorterThanTheRunIsRefused) {
  const Folder folder;
  folder.write("ground.csv", ground());
  const Finished end = folder.run({"simulate", "--base-motion", "ground.csv", "--until", "2"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("--base-motion: the recording ends at 1 s"));
}

TEST(DriveFile, MissingIsRefused) {
  const Folder folder;
  const Finished end = folder.run({"simulate", "--drive-file", "none.csv"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("--drive-file: "));
  EXPECT_THAT(end.err, HasSubstr("none.csv"));
}

TEST(DriveFile, OfAnotherQuantityIsRefused) {
  const Folder folder;
  folder.write("ground.csv", ground());
  const Finished end = folder.run({"simulate", "--drive-file", "ground.csv"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("not a force"));
}

TEST(DriveFile, OfAStudyLiesBesideIt) {
  const Folder folder;
  std::filesystem::create_directory(folder.path("lab"));
  folder.write("lab/ground.csv", ground());
  folder.write("lab/s.toml",
               "[[task]]\nsimulate = \"shaken\"\nbase_motion = \"ground.csv\"\nmethod = \"rk4\"\n"
               "[[block]]\ntext = \"{shaken.1.steps} steps\"\n");
  const Finished end = folder.run({"report", "lab/s.toml", "-o", "out"});
  EXPECT_EQ(end.status, 0) << end.err;
}

TEST(Drive, IsNamedInTheParameters) {
  const Folder folder;
  const auto drive = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "simulate");
    arguments.emplace_back("--json");
    return folder.run(arguments).json()["runs"][0]["parameters"]["drive"];
  };
  EXPECT_EQ(drive({}), "none");
  EXPECT_EQ(drive({"--drive-amplitude", "1", "--drive-frequency", "2"}), "harmonic");
  EXPECT_EQ(drive({"--drive", "step", "--drive-amplitude", "1"}), "step");
  EXPECT_EQ(drive({"--drive", "base", "--base-displacement", "2 mm", "--drive-frequency", "1 Hz"}), "base");
}

// How long a drive lasts is one of its parameters; a step does not end.
TEST(Drive, LastsAsLongAsAsked) {
  const Folder folder;
  const auto duration = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"simulate", "--drive-amplitude", "1", "--json", "--drive"});
    return folder.run(arguments).json()["runs"][0]["parameters"].value("drive_duration", -1.0);
  };
  EXPECT_EQ(duration({"half-sine", "--drive-duration", "0.3"}), 0.3);
  EXPECT_EQ(duration({"chirp", "--drive-duration", "5", "--drive-frequency", "1", "--drive-to", "20"}), 5);
  EXPECT_EQ(duration({"step"}), -1);
}

TEST(Drive, SaysWhatGetsThrough) {
  const Folder folder;
  const std::vector<std::string> arguments{
      "simulate",      "--natural-frequency", "6",    "--damping-ratio",   "0.05", "--drive",
      "base",          "--base-displacement", "2 mm", "--drive-frequency", "12",   "--method",
      "implicit-euler"};
  const Finished text = folder.run(arguments);
  EXPECT_THAT(text.out, HasSubstr("transmissibility: displacement of the mass over that of the base"));
  auto with_json = arguments;
  with_json.emplace_back("--json");
  const auto found = folder.run(with_json).json()["runs"][0]["transmissibility"];
  EXPECT_EQ(found["of"], "displacement");
  EXPECT_NEAR(found["frequency_ratio"].get<double>(), 2, 1e-15);
  const double exact = std::hypot(1, 0.2) / std::hypot(3, 0.2);
  EXPECT_NEAR(found["ratio"].get<double>(), exact, 1e-14);
  EXPECT_NEAR(found["transmitted"].get<double>(), 0.002 * exact, 1e-16);
  EXPECT_NEAR(found["simulated"]["ratio"].get<double>() / exact - 1,
              found["simulated"]["error"].get<double>(), 1e-12);
  EXPECT_NE(found["simulated"]["error"].get<double>(), 0);
  const auto free = folder.run({"simulate", "--json"}).json()["runs"][0];
  EXPECT_FALSE(free.contains("transmissibility"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
