// cromer sweep into HDF5 files, as users run it: threads, ranks, kills, and going on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include "tests/cluster/datasets.h"
#include "tests/cluster/started.h"
#include "tests/support/bytes_of.h"
#include "tests/support/cases.h"

namespace cromer::core {
namespace CROMER_FILE {

using test::datasets;
using test::exists;
using test::on_ranks;
using test::same_bits;
using testing::HasSubstr;
using Arguments = std::vector<std::string>;

Arguments sweep(const std::string& text, const Arguments& more = {}) {
  Arguments all = {CROMER_PROGRAM, "sweep"};
  std::istringstream words(text);
  for (std::string word; words >> word;) all.push_back(word);
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

const char* const settled =
    "--cubic 0.05 --damping 0.1 --drive-amplitude 0.1:0.3:7 --drive-frequency 0.5:2:101 --method rk4 --step "
    "0.05";
const char* const closed = "--damping-ratio 0.02,0.05,0.1 --drive-amplitude 1 --drive-frequency 0.1:3:20001";
const char* const to_the_end =
    "--cubic 0.05 --damping 0.1 --drive-amplitude 0.3 --drive-frequency 1.3 --method rk4 --step 0.05 --until "
    "50 "
    "--position -4:4:40 --velocity -4:4:33 --measure final";
const char* const hysteresis =
    "--cubic 0.05 --damping 0.1 --drive-amplitude 0.1:0.3:40 --drive-frequency 0.5:2:20 --method rk4 --step "
    "0.05 "
    "--direction up";
const char* const both =
    "--cubic 0.3 --damping 0.1 --drive-amplitude 0.3 --drive-frequency 0.8:2:40 --method rk4 --step 0.05 "
    "--direction both";
/// A few seconds of one thread.
const std::string slow =
    "--cubic 0.05 --damping 0.1 --drive-amplitude 0.3 --drive-frequency 1.3 --method gauss-legendre4 --step "
    "0.05 "
    "--until " +
    std::to_string(cases(1000)) + " --position -4:4:100 --velocity -4:4:25 --measure final --threads 1";

class SweepFile : public testing::Test {
 protected:
  test::Ended run(const Arguments& arguments) { return test::run(arguments, folder); }
  void need_mpirun() const {
    if (!test::have_mpirun()) GTEST_SKIP() << "mpirun is not installed";
  }
  test::Folder folder{};
  std::string file = folder / "sweep.h5";
};

TEST_F(SweepFile, is_the_same_bits_on_any_number_of_threads) {
  for (const char* options : {settled, closed, to_the_end, hysteresis, both}) {
    const std::string one = folder / "one.h5", many = folder / "many.h5";
    ASSERT_EQ(run(sweep(options, {"-o", one, "--threads", "1"})).status, 0);
    for (const char* threads : cases({"2", "3", "7"})) {
      ASSERT_EQ(run(sweep(options, {"-o", many, "--threads", threads})).status, 0);
      EXPECT_TRUE(same_bits(datasets(one), datasets(many))) << threads << " threads, " << options;
    }
  }
}

TEST_F(SweepFile, is_the_same_bits_on_any_number_of_ranks) {
  need_mpirun();
  const std::string one = folder / "one.h5", many = folder / "many.h5";
  for (const char* options : {settled, closed}) {
    ASSERT_EQ(run(sweep(options, {"-o", one})).status, 0);
    for (const int ranks : {1, 2, 3}) {
      const auto ended = run(on_ranks(ranks, sweep(options, {"-o", many, "--threads", "1"})));
      ASSERT_EQ(ended.status, 0) << ended.err;
      EXPECT_TRUE(same_bits(datasets(one), datasets(many))) << ranks << " ranks, " << options;
      EXPECT_EQ(ended.out.find(" points by "), ended.out.rfind(" points by "))
          << "only the first rank prints";
    }
  }
}

TEST_F(SweepFile, holds_what_the_csv_does) {
  const std::string csv = folder / "sweep.csv";
  ASSERT_EQ(run(sweep(settled, {"-o", csv})).status, 0);
  ASSERT_EQ(run(sweep(settled, {"-o", file})).status, 0);
  const auto all = datasets(file);
  const auto& amplitude = all.at("amplitude");
  ASSERT_EQ(amplitude.size(), 707u);
  EXPECT_EQ(all.at("drive_frequency").size(), 101u);
  std::ifstream lines(csv);
  std::size_t row = 0;
  for (std::string line; std::getline(lines, line);) {
    double drive = 0, frequency = 0, value = 0;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf", &drive, &frequency, &value) != 3) continue;
    EXPECT_EQ(drive, all.at("drive_amplitude")[row / 101]);
    EXPECT_EQ(frequency, all.at("drive_frequency")[row % 101]);
    EXPECT_EQ(value, amplitude[row++]);
  }
  EXPECT_EQ(row, 707u);
}

TEST_F(SweepFile, holds_the_direction_and_what_became_of_each_point) {
  ASSERT_EQ(run(sweep(both, {"-o", file})).status, 0);
  const auto all = datasets(file);
  EXPECT_EQ(all.at("direction"), (std::vector<double>{1, -1}));
  EXPECT_EQ(all.at("amplitude").size(), 80u);
  EXPECT_EQ(all.at("status"), std::vector<double>(80, 0));
  // Forward Euler's limit is h = c/k; nothing settles without damping by verlet.
  const std::string other = folder / "other.h5";
  const char* const steps =
      "--damping 0.2 --drive-amplitude 1 --drive-frequency 0.5 --method forward-euler --step ";
  const auto ended = run(sweep(steps + std::string("0.02,0.3"), {"-o", other}));
  EXPECT_EQ(ended.status, 1);
  EXPECT_EQ(datasets(other).at("status"), (std::vector<double>{0, 4}));
  const std::string third = folder / "third.h5";
  run(sweep("--damping 0,0.1 --drive-amplitude 1 --drive-frequency 0.5 --method verlet", {"-o", third}));
  EXPECT_EQ(datasets(third).at("status"), (std::vector<double>{1, 0}));
  run(sweep("--damping 0,0.1 --drive-amplitude 1 --drive-frequency 0.5 --method rk4", {"-o", file}));
  EXPECT_EQ(datasets(file).at("status"), (std::vector<double>{5, 0}));
  // With what is there already the same is said.
  const auto again = run(sweep(steps + std::string("0.02,0.3"), {"-o", other, "--resume"}));
  EXPECT_EQ(again.status, 1);
  EXPECT_EQ(again.err, ended.err);
}

TEST_F(SweepFile, csv_comes_from_ranks_too) {
  need_mpirun();
  const auto rows = [&](const std::string& path) {
    const std::string text = bytes_of(path);
    return text.substr(text.find('\n') + 1);  // after the command line
  };
  const std::string one = folder / "one.csv", three = folder / "three.csv";
  ASSERT_EQ(run(sweep(settled, {"-o", one})).status, 0);
  ASSERT_EQ(run(on_ranks(3, sweep(settled, {"-o", three}))).status, 0);
  EXPECT_EQ(rows(one), rows(three));
}

/// Rank processes: mpirun's children.
std::vector<pid_t> children_of(pid_t parent) {
  std::ifstream list("/proc/" + std::to_string(parent) + "/task/" + std::to_string(parent) + "/children");
  std::vector<pid_t> children;
  for (pid_t child; list >> child;) children.push_back(child);
  return children;
}

TEST_F(SweepFile, killed_at_random_goes_on_to_the_same_bits) {
  need_mpirun();
  const std::string undisturbed = folder / "undisturbed.h5";
  ASSERT_EQ(run(sweep(slow, {"-o", undisturbed})).status, 0);
  std::mt19937 random(7);
  std::uniform_int_distribution<int> moment(100, 1600);
  const auto command = on_ranks(2, sweep(slow, {"-o", file, "--resume"}));
  int killed = 0;
  for (int round = 0; round < 4; ++round) {
    test::Started started(command, folder);
    std::this_thread::sleep_for(std::chrono::milliseconds(moment(random)));
    auto victims = children_of(started.process());
    if (round % 2 == 0 && !victims.empty()) {  // one of them
      kill(victims[random() % victims.size()], SIGKILL);
      killed += started.running();
    } else if (!victims.empty()) {  // all, and mpirun
      started.signal(SIGKILL);
      for (const pid_t victim : victims) kill(victim, SIGKILL);
      ++killed;
    }
    // On a busy machine mpirun may wait for ever for a rank that was killed as it began.
    for (int i = 0; i < 3000 && started.running(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (started.running()) {
      victims = children_of(started.process());
      started.signal(SIGKILL);
      for (const pid_t victim : victims) kill(victim, SIGKILL);
    }
    started.wait();
    EXPECT_TRUE(!exists(file) || !datasets(file).empty()) << "it opens";
  }
  EXPECT_GT(killed, 0);
  const auto last = run(command);
  EXPECT_EQ(last.status, 0) << last.err;
  EXPECT_FALSE(exists(file + ".journal"));
  EXPECT_TRUE(same_bits(datasets(undisturbed), datasets(file)));
}

TEST_F(SweepFile, stopped_by_ctrl_c_goes_on) {
  test::Started started(sweep(slow, {"-o", file}), folder);
  for (int i = 0; i < 1000 && !exists(file); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  started.signal(SIGINT);
  const auto stopped = started.wait();
  EXPECT_EQ(stopped.status, 1);
  EXPECT_THAT(stopped.err, HasSubstr("points; --resume goes on"));
  ASSERT_TRUE(exists(file + ".journal"));
  const auto begun = datasets(file).at("x");
  EXPECT_TRUE(std::isnan(begun.back()));

  const auto without = run(sweep(slow, {"-o", file}));
  EXPECT_EQ(without.status, 2);
  EXPECT_THAT(without.err, HasSubstr("is unfinished; go on with --resume"));

  const auto other = run(sweep(slow, {"-o", file, "--resume", "--mass", "2"}));
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.err, HasSubstr("belongs to another sweep: mass"));

  const auto resumed = run(sweep(slow, {"-o", file, "--resume"}));
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_FALSE(std::isnan(datasets(file).at("x").back()));
  EXPECT_THAT(resumed.out, HasSubstr("2500 points"));

  const auto again = run(sweep(slow, {"-o", file, "--resume"}));
  EXPECT_EQ(again.status, 0);
  EXPECT_EQ(again.out, resumed.out) << "nothing to do, the same said";
}

TEST_F(SweepFile, that_cannot_be_is_refused_before_it_begins) {
  const struct {
    Arguments arguments;
    const char* message;
  } cases[] = {
      {{"-o", file, "--position", "0:1:1000000000", "--velocity", "0:1:1000000"}, "PB, but only"},
      {{"-o", folder / "a.csv", "--resume"}, "--resume: only an HDF5 file can be continued"},
      {{"-o", folder / "nowhere/a.h5", "--position", "1,2"}, "there is no folder"},
      {{"-o", folder / "a.txt", "--position", "1,2"}, "none of .csv, .json and .h5"},
  };
  for (const auto& wrong : cases) {
    const auto ended = run(sweep("--until 10", wrong.arguments));
    EXPECT_EQ(ended.status, 2) << wrong.message;
    EXPECT_THAT(ended.err, HasSubstr(wrong.message));
    EXPECT_FALSE(exists(file));
  }
  const auto plotted = run(sweep("--until 10 --position 0:1:100000 --velocity 0:1:100000 --measure final",
                                 {"-o", file, "--plot", folder / "a.svg"}));
  EXPECT_EQ(plotted.status, 2);
  EXPECT_THAT(plotted.err, HasSubstr("or leave --json and --plot out"));
  std::ofstream(file) << "no HDF5";
  const auto ended = run(sweep(closed, {"-o", file, "--resume"}));
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, HasSubstr("cannot be opened as an HDF5 file"));
  EXPECT_EQ(bytes_of(file), "no HDF5");
}

TEST_F(SweepFile, wrong_options_are_told_once_by_all_ranks) {
  need_mpirun();
  for (const char* wrong : {"--drive-frequency 1:2", "--drive-frequency 1,2 --measure speed"}) {
    const auto ended = run(on_ranks(3, sweep(wrong, {"-o", file})));
    EXPECT_EQ(ended.status, 2);
    const auto first = ended.err.find("cromer: ");
    EXPECT_NE(first, std::string::npos);
    EXPECT_EQ(first, ended.err.rfind("cromer: ")) << ended.err;
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
