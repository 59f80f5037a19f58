// Interrupted as soon as it can be, a command names what is missing and writes nothing that is not done.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "program.h"

namespace cromer::core::test {
namespace {

using ::testing::IsEmpty;

Finished interrupted(const Folder& folder, const std::vector<std::string>& arguments) {
  const pid_t process = folder.start(arguments);
  EXPECT_TRUE(wait_for_handler(process, SIGINT));
  kill(process, SIGINT);
  return folder.wait(process);
}

std::vector<std::string> with_files(std::vector<std::string> arguments,
                                    const std::vector<std::string>& files) {
  arguments.insert(arguments.begin() + 1, files.begin(), files.end());
  return arguments;
}

/// Shaking of which the spectrum of 5000 periods is not done when the signal comes.
std::vector<std::string> put_shaking(const Folder& folder, int count) {
  std::string bytes = "t (s),a (m/s^2)\n";
  for (int i = 0; i < 5000; ++i) bytes += std::to_string(i) + "e-2," + std::to_string(i * i % 17 - 8) + "\n";
  std::vector<std::string> names;
  for (int i = 1; i <= count; ++i) folder.write(names.emplace_back("r" + std::to_string(i) + ".csv"), bytes);
  return names;
}

std::vector<std::string> put_swings(const Folder& folder, int count) {
  const std::string bytes = recording(30000, 0.002);
  std::vector<std::string> names;
  for (int i = 1; i <= count; ++i) folder.write(names.emplace_back("r" + std::to_string(i) + ".csv"), bytes);
  return names;
}

TEST(Interrupted, WhatIsMissingIsNamedUpToFive) {
  const Folder folder;
  const auto files = put_shaking(folder, 6);
  const std::vector<std::string> three(files.begin(), files.begin() + 3),
      five(files.begin(), files.end() - 1);
  const std::vector<std::string> command{"spectrum", "--periods", "0.01:10:5000:log", "-o", "spectra.csv"};
  const auto said = [&](const std::vector<std::string>& of) {
    const Finished end = interrupted(folder, with_files(command, of));
    EXPECT_EQ(end.status, 1);
    return end.err;
  };
  const std::string nothing = "cromer: spectra.csv is not written: there is nothing to write into it\n";
  EXPECT_EQ(said(three),
            "cromer: interrupted; what follows are the spectra of 0 of 3 motions; missing: r1.csv, r2.csv, "
            "r3.csv\n" +
                nothing);
  EXPECT_EQ(said(five),
            "cromer: interrupted; what follows are the spectra of 0 of 5 motions; missing: r1.csv, r2.csv, "
            "r3.csv, r4.csv, r5.csv\n" +
                nothing);
  EXPECT_EQ(said(files),
            "cromer: interrupted; what follows are the spectra of 0 of 6 motions; missing: r1.csv, r2.csv, "
            "r3.csv, r4.csv, r5.csv and 1 more\n" +
                nothing);
  EXPECT_EQ(folder.names(), files);
}

// Each thread has begun one.
TEST(Interrupted, FitsMakeNoLine) {
  const Folder folder;
  const auto files = put_swings(folder, 2);
  const Finished end =
      interrupted(folder, with_files({"fit", "--mass-line", "--masses", "1 kg, 2 kg"}, files));
  EXPECT_EQ(end.status, 1);
  EXPECT_THAT(end.err,
              ::testing::MatchesRegex(
                  "cromer: interrupted; what follows are the results of "
                  "(2 of 2 files|1 of 2 files; missing: r2.csv)\n"
                  "cromer: r1.csv: run 1: iteration_limit: interrupted before the fit was done\n"
                  "(cromer: r2.csv: run 1: iteration_limit: interrupted before the fit was done\n)?"));
}

TEST(Interrupted, AComparisonIsNotGood) {
  const Folder folder;
  const auto files = put_swings(folder, 1);
  EXPECT_EQ(interrupted(folder, {"compare", "r1.csv"}).status, 1);
}

TEST(Interrupted, ASpectrumIsNotWritten) {
  const Folder folder;
  const auto files = put_shaking(folder, 1);
  const std::vector<std::string> command{"spectrum",         "r1.csv", "--periods",
                                         "0.01:10:5000:log", "-o",     "spectrum.csv"};
  const Finished end = interrupted(folder, command);
  EXPECT_EQ(end.status, 1);
  EXPECT_THAT(end.out, IsEmpty());
  EXPECT_TRUE(end.err.starts_with("cromer: interrupted; nothing is written\n")) << end.err;
  auto in_json = command;
  in_json.push_back("--json");
  const Finished told = interrupted(folder, in_json);
  EXPECT_EQ(told.status, 1);
  EXPECT_EQ(told.json()["message"], "interrupted") << told.out;
  EXPECT_TRUE(told.json()["spectra"].empty());
  EXPECT_EQ(folder.names(), files);
}

TEST(Interrupted, AReportIsNotMade) {
  const Folder folder;
  const auto files = put_swings(folder, 1);
  const Finished end = interrupted(folder, {"report", "r1.csv", "-o", "out"});
  EXPECT_EQ(end.status, 1);
  EXPECT_EQ(end.err, "cromer: interrupted before the report was made\n");
  EXPECT_EQ(folder.names(), files);
}

}  // namespace
}  // namespace cromer::core::test
