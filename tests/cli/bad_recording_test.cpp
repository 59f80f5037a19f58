// Wrong recordings: a message with file, line and column, never a crash, never a half-written file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <filesystem>
#include <random>

#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// Each command that reads a recording, asked for every output.
class Commands : public ::testing::TestWithParam<const char*> {
 protected:
  Finished run(const std::string& file) const {
    std::vector<std::string> arguments{GetParam(), file, "--json", "-o", "result.csv"};
    return folder.run(arguments);
  }
  void expect_refused(const Finished& end, const std::string& said) const {
    EXPECT_EQ(end.status, 2) << end.err;
    EXPECT_THAT(end.out, IsEmpty());
    EXPECT_THAT(end.err, StartsWith("cromer: "));
    EXPECT_THAT(end.err, HasSubstr(said));
    EXPECT_FALSE(folder.has("result.csv"));
  }
  Folder folder;
};

TEST_P(Commands, RefuseAMissingFile) { expect_refused(run("absent.csv"), "absent.csv"); }

TEST_P(Commands, RefuseAnEmptyFile) {
  folder.write("empty.csv", "");
  expect_refused(run("empty.csv"), "empty.csv");
}

TEST_P(Commands, RefuseAFolder) {
  std::filesystem::create_directory(folder.path("lab"));
  expect_refused(run("lab"), "lab");
}

TEST_P(Commands, RefuseABinaryFile) {
  std::string bytes;
  for (int i = 0; i < 5000; ++i) bytes += static_cast<char>((i * 7919) >> 3);
  folder.write("noise.csv", bytes);
  expect_refused(run("noise.csv"), "noise.csv");
}

TEST_P(Commands, NameFileLineAndColumnOfAWord) {
  std::string text = recording(300);
  const auto at = text.find("\n0.15,") + 6;
  text.replace(at, 3, "abc");
  folder.write("lab.csv", text);
  const Finished end = run("lab.csv");
  expect_refused(end, "lab.csv:17");
  EXPECT_THAT(end.err, HasSubstr("Position (m)"));
  EXPECT_THAT(end.err, HasSubstr("--skip-bad-rows"));
}

INSTANTIATE_TEST_SUITE_P(All, Commands, ::testing::Values("inspect", "fit", "compare"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(Commands, NeverOverwriteTheRecording) {
  folder.write("lab.csv", recording(600));
  const std::string before = folder.read("lab.csv");
  const Finished end = folder.run({GetParam(), "lab.csv", "-o", "./lab.csv"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("that is the file to be read; it would be lost"));
  EXPECT_EQ(folder.read("lab.csv"), before);
}

TEST(BadRecording, ATimeFarAwayIsNamedAndCanBeLeftOut) {
  Folder folder;
  folder.write("far.csv", recording(600) + "1e19,0.01\n");
  const Finished end = folder.run({"fit", "far.csv"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("line 602: the time jumps"));
  EXPECT_EQ(folder.run({"fit", "far.csv", "--to", "100"}).status, 0);
}

TEST(BadRecording, ALongPauseKeepsTheFrequency) {
  Folder folder;
  std::string csv = "Time (s),Position (m)\n";
  for (int i = 0; i < 3000; ++i) {
    const double t = 0.02 * i + (i >= 1500 ? 600 : 0);
    csv += std::to_string(t) + "," + std::to_string(0.05 * std::exp(-0.001 * t) * std::cos(6 * t)) + "\n";
  }
  folder.write("pause.csv", csv);
  const Finished end = folder.run({"fit", "pause.csv", "--law", "viscous", "--json"});
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_NEAR(end.json().at("parameters").at("angular_frequency").at("value").get<double>(), 6, 1e-5);
}

TEST(BadRecording, SkipBadRowsReadsTheRest) {
  const Folder folder;
  std::string text = recording(1000);
  text.replace(text.find("\n0.15,") + 6, 3, "abc");
  folder.write("lab.csv", text);
  const Finished end = folder.run({"inspect", "lab.csv", "--json", "--skip-bad-rows"});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_EQ(end.json()["samples"], 999);
}

TEST(BadRecording, MissingValuesAreCountedInWarnings) {
  const Folder folder;
  std::string text = recording(1000);
  text.replace(text.find("\n1.00,") + 6, 7, "NaN");
  text.replace(text.find("\n2.00,") + 6, 7, "");
  folder.write("lab.csv", text);
  const Finished end = folder.run({"fit", "lab.csv", "--law", "viscous", "--json"});
  EXPECT_EQ(end.status, 0) << end.err;
  const auto document = end.json();
  EXPECT_EQ(document["recording"]["used"], 998);
  EXPECT_THAT(document["warnings"].dump(), HasSubstr("2"));
}

TEST(BadRecording, BackwardTimeIsRepairedAndSaid) {
  const Folder folder;
  std::string text = recording(1000);
  text.replace(text.find("\n1.00,") + 1, 4, "0.50");
  folder.write("lab.csv", text);
  const Finished end = folder.run({"fit", "lab.csv", "--law", "viscous", "--json"});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_FALSE(end.json()["warnings"].empty());
  EXPECT_NEAR(end.json()["parameters"]["decay_rate"]["value"].get<double>(), 0.05, 1e-4);
}

TEST(BadRecording, NonUniformTimeIsFitted) {
  const Folder folder;
  // Every third sample left out: steps of 10 and 20 ms.
  std::string text, all = recording(1500);
  std::size_t line = 0;
  for (std::size_t from = 0; from < all.size(); ++line) {
    const auto end = all.find('\n', from) + 1;
    if (line == 0 || line % 3 != 0) text += all.substr(from, end - from);
    from = end;
  }
  folder.write("lab.csv", text);
  const Finished end = folder.run({"fit", "lab.csv", "--law", "viscous", "--json"});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_NEAR(end.json()["parameters"]["decay_rate"]["value"].get<double>(), 0.05, 1e-4);
}

TEST(BadRecording, WithoutOscillationExitsOneAndSaysWhy) {
  const Folder folder;
  std::string text = "Time (s),Position (m)\n";
  std::mt19937 noise(1);
  for (int i = 0; i < 2000; ++i)
    text += std::to_string(i / 100.0) + "," + std::to_string(0.2 + 1e-4 * static_cast<double>(noise() % 13)) +
            "\n";
  folder.write("rest.csv", text);
  const Finished end = folder.run({"fit", "rest.csv", "--json"});
  EXPECT_EQ(end.status, 1) << end.err;
  const auto document = end.json();
  EXPECT_NE(document["status"], "converged");
  EXPECT_FALSE(document["message"].get<std::string>().empty());
}

TEST(BadRecording, ASeismometerAtRestExitsOneAndSaysWhy) {
  const std::string file = CROMER_SOURCE_DIR "/../shared/data/seismometer-datastudio/train2.txt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const Folder folder;
  const Finished end = folder.run({"fit", file, "--json"});
  EXPECT_EQ(end.status, 1) << end.err;
  EXPECT_EQ(end.json()["status"], "no_oscillation");
  EXPECT_FALSE(end.json()["message"].get<std::string>().empty());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
