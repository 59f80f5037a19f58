// Chunks on ranks: the same bytes however many, and errors that say whose they are.
#include "cromer/cluster/ranks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "tests/cluster/started.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace CROMER_FILE {

using test::on_ranks;
using testing::HasSubstr;

std::vector<std::string> program(const std::string& file, const std::string& threads,
                                 const std::string& more = "") {
  return {CROMER_ROWS_PROGRAM, file, "1003", "10", "500", threads, more};
}

class OnRanks : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::have_mpirun()) GTEST_SKIP() << "mpirun is not installed";
  }
  test::Folder folder{};
};

TEST_F(OnRanks, files_are_the_same_bytes) {
  const std::string alone = folder / "alone.h5";
  ASSERT_EQ(test::run(program(alone, "3"), folder).status, 0);
  for (const int ranks : {1, 2, 3})
    for (const char* threads : {"1", "2"}) {
      const std::string file = folder / ("ranks" + std::to_string(ranks) + threads + ".h5");
      const auto ended = test::run(on_ranks(ranks, program(file, threads)), folder);
      EXPECT_EQ(ended.status, 0) << ended.err;
      EXPECT_THAT(ended.out, HasSubstr("done"));
      EXPECT_EQ(ended.out.find("done"), ended.out.rfind("done")) << "only the first rank prints";
      EXPECT_TRUE(bytes_of(file) == bytes_of(alone)) << ranks << " ranks";
    }
}

TEST_F(OnRanks, the_failure_of_one_ends_all_and_is_told) {
  const auto ended = test::run(on_ranks(3, program(folder / "a.h5", "1", "name=throws")), folder);
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.err, testing::ContainsRegex("rank [12] on .*: not enough memory"));
}

TEST_F(OnRanks, one_that_cannot_help_says_why) {
  const auto ended = test::run(on_ranks(2, program(folder / "a.h5", "1", "name=cannot")), folder);
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.err, testing::ContainsRegex("rank 1 on .*: this node has no AVX-512"));
}

TEST_F(OnRanks, ranks_with_other_work_are_refused) {
  const auto ended = test::run(on_ranks(2, program(folder / "a.h5", "1", "name=by-rank")), folder);
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.err, HasSubstr("name is \"by-rank0\" there and \"by-rank1\" here"));
}

TEST_F(OnRanks, a_file_that_cannot_be_opened_lets_all_ranks_go) {
  const auto ended = test::run(on_ranks(3, program(folder / "nowhere/a.h5", "1")), folder);
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, HasSubstr("nowhere/a.h5"));
}

TEST(RankPlace, is_read_from_the_environment) {
  const auto place_with = [](const char* size, const char* ranks, const char* rank, const char* place) {
    setenv(size, ranks, 1);
    setenv(rank, place, 1);
    const RankPlace found = rank_place();
    unsetenv(size);
    unsetenv(rank);
    return std::pair{found.rank, found.ranks};
  };
  EXPECT_EQ(rank_place().ranks, 1);
  EXPECT_EQ(place_with("OMPI_COMM_WORLD_SIZE", "3", "OMPI_COMM_WORLD_RANK", "2"), std::pair(2, 3));
  EXPECT_EQ(place_with("PMI_SIZE", "4", "PMI_RANK", "0"), std::pair(0, 4));
  EXPECT_EQ(place_with("SLURM_STEP_NUM_TASKS", "8", "SLURM_PROCID", "7"), std::pair(7, 8));
  // A job's script sees the tasks of the job, but is no rank.
  EXPECT_EQ(place_with("SLURM_NTASKS", "8", "SLURM_PROCID", "0"), std::pair(0, 1));
  EXPECT_EQ(place_with("OMPI_COMM_WORLD_SIZE", "1", "OMPI_COMM_WORLD_RANK", "0"), std::pair(0, 1));
  EXPECT_EQ(place_with("OMPI_COMM_WORLD_SIZE", "many", "OMPI_COMM_WORLD_RANK", "0"), std::pair(0, 1));
}

TEST(RankThreads, are_the_share_of_the_machine) {
  EXPECT_EQ(threads_of_rank(5), 5);
  const int alone = threads_of_rank(0);
  EXPECT_EQ(alone, threads_of(0));
  setenv("OMPI_COMM_WORLD_LOCAL_SIZE", "2", 1);
  EXPECT_LE(threads_of_rank(0), std::max(1, static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN)) / 2));
  EXPECT_EQ(threads_of_rank(5), 5);
  setenv("OMPI_COMM_WORLD_LOCAL_SIZE", "100000", 1);
  EXPECT_EQ(threads_of_rank(0), 1);
  unsetenv("OMPI_COMM_WORLD_LOCAL_SIZE");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
