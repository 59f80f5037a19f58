// Interrupted as soon as it can be, a command names what is missing and writes nothing that is not done.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "program.h"

namespace cromer::core::test {
namespace {

using ::testing::IsEmpty;

/// Files that a command waits for until it has been interrupted, however fast or slow the machine is.
class LateFiles {
 public:
  LateFiles(const Folder& folder, int count, std::string bytes) : folder_(folder), bytes_(std::move(bytes)) {
    signal(SIGPIPE, SIG_IGN);
    for (int i = 1; i <= count; ++i) {
      names.push_back("r" + std::to_string(i) + ".csv");
      EXPECT_EQ(mkfifo(folder.path(names.back()).c_str(), 0600), 0);
    }
  }

  Finished interrupted(const std::vector<std::string>& arguments) const {
    const pid_t process = folder_.start(arguments);
    EXPECT_TRUE(wait_for_handler(process, SIGINT));
    kill(process, SIGINT);
    std::vector<std::thread> writers;
    for (const std::string& name : names)
      writers.emplace_back([&, path = folder_.path(name)] { std::ofstream(path) << bytes_; });
    const Finished end = folder_.wait(process);
    // Of a file that nobody opened the writer still waits for a reader.
    for (const std::string& name : names) close(open(folder_.path(name).c_str(), O_RDONLY | O_NONBLOCK));
    for (std::thread& writer : writers) writer.join();
    return end;
  }

  std::vector<std::string> names;

 private:
  const Folder& folder_;
  std::string bytes_;
};

std::vector<std::string> with_files(std::vector<std::string> arguments,
                                    const std::vector<std::string>& files) {
  arguments.insert(arguments.begin() + 1, files.begin(), files.end());
  return arguments;
}

std::string shaking() {
  std::string bytes = "t (s),a (m/s^2)\n";
  for (int i = 0; i < 5000; ++i) bytes += std::to_string(i) + "e-2," + std::to_string(i * i % 17 - 8) + "\n";
  return bytes;
}

TEST(Interrupted, WhatIsMissingIsNamedUpToFive) {
  const Folder folder;
  const LateFiles late(folder, 6, shaking());
  const std::vector<std::string>& files = late.names;
  const std::vector<std::string> three(files.begin(), files.begin() + 3),
      five(files.begin(), files.end() - 1);
  const std::vector<std::string> command{"spectrum", "--periods", "0.1:10:5000:log", "-o", "spectra.csv"};
  const auto said = [&](const std::vector<std::string>& of) {
    const Finished end = late.interrupted(with_files(command, of));
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
  const LateFiles late(folder, 2, recording(30000, 0.002));
  const Finished end =
      late.interrupted(with_files({"fit", "--mass-line", "--masses", "1 kg, 2 kg"}, late.names));
  EXPECT_EQ(end.status, 1);
  EXPECT_THAT(end.err,
              ::testing::MatchesRegex(
                  "cromer: interrupted; what follows are the results of "
                  "(2 of 2 files|1 of 2 files; missing: r2.csv)\n"
                  "cromer: r1.csv: run 1: iteration_limit: interrupted before the fit was done\n"
                  "(cromer: r2.csv: run 1: iteration_limit: interrupted before the fit was done\n)?"));
}

TEST(Interrupted, ASpectrumIsNotWritten) {
  const Folder folder;
  const LateFiles late(folder, 1, shaking());
  const std::vector<std::string> command{"spectrum",        "r1.csv", "--periods",
                                         "0.1:10:5000:log", "-o",     "spectrum.csv"};
  const Finished end = late.interrupted(command);
  EXPECT_EQ(end.status, 1);
  EXPECT_THAT(end.out, IsEmpty());
  EXPECT_TRUE(end.err.starts_with("cromer: interrupted; nothing is written\n")) << end.err;
  auto in_json = command;
  in_json.push_back("--json");
  const Finished told = late.interrupted(in_json);
  EXPECT_EQ(told.status, 1);
  EXPECT_EQ(told.json()["message"], "interrupted") << told.out;
  EXPECT_TRUE(told.json()["spectra"].empty());
  EXPECT_EQ(folder.names(), late.names);
}

TEST(Interrupted, AReportIsNotMade) {
  const Folder folder;
  const LateFiles late(folder, 1, recording(30000, 0.002));
  const Finished end = late.interrupted({"report", "r1.csv", "-o", "out"});
  EXPECT_EQ(end.status, 1);
  EXPECT_EQ(end.err, "cromer: interrupted before the report was made\n");
  EXPECT_EQ(folder.names(), late.names);
}

}  // namespace
}  // namespace cromer::core::test
