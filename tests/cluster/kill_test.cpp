// Programs that are killed at random moments: the file opens, and going on gives the bytes of an undisturbed
// run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>

#include "tests/cluster/started.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace CROMER_FILE {

using test::exists;
using test::on_ranks;
using testing::HasSubstr;

using Arguments = std::vector<std::string>;

/// 1003 rows in 101 chunks of about so many milliseconds each, finished ones noted often.
Arguments program(const std::string& file, int milliseconds, const Arguments& more = {}) {
  Arguments all = {
      CROMER_ROWS_PROGRAM, file, "1003", "10", std::to_string(1000 * milliseconds), "1", "often"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::string undisturbed(const test::Folder& folder) {
  const std::string file = folder / "undisturbed.h5";
  const auto ended = test::run({CROMER_ROWS_PROGRAM, file, "1003", "10", "0", "1"}, folder);
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_FALSE(exists(file + ".journal"));
  return bytes_of(file);
}

bool opens(const std::string& file) {
  const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  return opened >= 0 && H5Fclose(opened) >= 0;
}

/// Chunks that the journal has as finished.
long finished(const std::string& file) {
  const std::string journal = bytes_of(file + ".journal");
  return std::count(journal.begin() + static_cast<long>(journal.find('\n')), journal.end(), 'x');
}

void wait_for_finished_chunks(const std::string& file, test::Started& run) {
  for (int i = 0; i < 2000 && run.running() && !(exists(file + ".journal") && finished(file) > 0); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

void kill_rank(const std::string& file, int rank) {
  const std::string pid = bytes_of(file + ".rank" + std::to_string(rank));
  if (!pid.empty()) kill(std::atoi(pid.c_str()), SIGKILL);
}

class Killed : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::have_mpirun()) GTEST_SKIP() << "mpirun is not installed";
    expected = undisturbed(folder);
    ASSERT_FALSE(expected.empty());
  }

  /// Starts, kills, resumes, round after round, until a run comes to its end; then compares the bytes.
  template <class Start, class Kill>
  void rounds(const Start& start, const Kill& kill_it) {
    std::uniform_int_distribution<int> moment(0, 1500);
    int killed = 0;
    for (int round = 0; round < 40; ++round) {
      test::Started run(start(round), folder);
      std::this_thread::sleep_for(std::chrono::milliseconds(moment(random)));
      if (round < 5 && run.running()) {
        kill_it(run);
        ++killed;
      }
      const auto ended = run.wait();
      EXPECT_TRUE(!exists(file) || opens(file)) << "round " << round;
      if (ended.status == 0) break;
      if (round >= 5) ADD_FAILURE() << ended.err;
    }
    EXPECT_GT(killed, 0);
    EXPECT_FALSE(exists(file + ".journal"));
    EXPECT_TRUE(bytes_of(file) == expected) << "not the bytes of an undisturbed run";
  }

  test::Folder folder{};
  std::string file = folder / "killed.h5", expected{};
  std::mt19937 random{20261122};
};

TEST_F(Killed, alone_goes_on_to_the_same_bytes) {
  rounds([&](int) { return program(file, 20, {"resume"}); }, [](test::Started& run) { run.signal(SIGKILL); });
}

TEST_F(Killed, one_of_three_ranks_goes_on_to_the_same_bytes) {
  std::uniform_int_distribution<int> which(0, 2);
  rounds([&](int) { return on_ranks(3, program(file, 60, {"resume"})); },
         [&](test::Started&) { kill_rank(file, which(random)); });
}

TEST_F(Killed, all_ranks_go_on_to_the_same_bytes) {
  rounds([&](int round) { return on_ranks(round % 2 + 2, program(file, 50, {"resume"})); },
         [&](test::Started& run) {
           run.signal(SIGKILL);
           for (const int rank : {0, 1, 2}) kill_rank(file, rank);
         });
}

TEST_F(Killed, while_something_is_finished_keeps_it) {
  test::Started run(on_ranks(2, program(file, 50)), folder);
  wait_for_finished_chunks(file, run);
  kill_rank(file, 1);
  EXPECT_NE(run.wait().status, 0);
  const long kept = finished(file);
  EXPECT_GT(kept, 0);
  EXPECT_LT(kept, 101);
  EXPECT_EQ(test::run(program(file, 1, {"resume"}), folder).status, 0);
  EXPECT_TRUE(bytes_of(file) == expected);
}

TEST_F(Killed, by_a_termination_signal_keeps_what_there_is) {
  for (const bool ranks : {false, true}) {
    const Arguments plain = program(file, 50);
    test::Started run(ranks ? on_ranks(2, plain) : plain, folder);
    wait_for_finished_chunks(file, run);
    run.signal(SIGTERM);
    EXPECT_NE(run.wait().status, 0);
    ASSERT_TRUE(exists(file));
    EXPECT_TRUE(exists(file + ".journal"));
    EXPECT_EQ(test::run(program(file, 1, {"resume"}), folder).status, 0);
    EXPECT_TRUE(bytes_of(file) == expected);
  }
}

TEST_F(Killed, by_a_full_disk_says_so_and_goes_on_later) {
  {
    test::Started run(program(file, 20), folder);
    wait_for_finished_chunks(file, run);
    run.signal(SIGKILL);
    run.wait();
  }
  const auto full = test::run(program(file, 1, {"resume", "file-limit=12000"}), folder);
  EXPECT_EQ(full.status, 1);
  EXPECT_THAT(full.err, HasSubstr("cannot write " + file));
  EXPECT_THAT(full.err, HasSubstr("make room and go on with --resume"));
  EXPECT_TRUE(opens(file));
  const auto on_two = test::run(on_ranks(2, program(file, 1, {"resume", "file-limit=12000"})), folder);
  EXPECT_NE(on_two.status, 0);
  EXPECT_THAT(on_two.err, HasSubstr("make room and go on with --resume"));
  EXPECT_EQ(test::run(program(file, 1, {"resume"}), folder).status, 0);
  EXPECT_TRUE(bytes_of(file) == expected);
}

TEST_F(Killed, by_a_full_disk_at_the_beginning_leaves_nothing) {
  const auto full = test::run(program(file, 1, {"file-limit=12000"}), folder);
  EXPECT_EQ(full.status, 2);
  EXPECT_THAT(full.err, HasSubstr("cannot write"));
  EXPECT_FALSE(exists(file) || exists(file + ".new") || exists(file + ".journal"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
