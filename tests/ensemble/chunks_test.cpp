// Chunks on threads: the same bits however many, each once, bounded memory, and an end when one is asked for.
#include "cromer/ensemble/chunks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <mutex>
#include <numeric>
#include <set>
#include <thread>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

/// 103 rows of two columns in chunks of 10; rounding differs from row to row, and chunks take unlike times.
ChunkedRows sample_work() {
  ChunkedRows work;
  work.columns = {"a", "b"};
  work.rows = 103;
  work.rows_per_chunk = 10;
  work.make = [work](std::uint64_t chunk, double* rows, const Watch&) {
    std::this_thread::sleep_for(std::chrono::microseconds(chunk % 3 * 500));
    for (std::uint64_t r = 0; r < work.rows_of(chunk); ++r) {
      const auto row = static_cast<double>(chunk * 10 + r);
      rows[2 * r] = std::sin(row);
      rows[2 * r + 1] = std::exp(std::cos(row));
    }
    return true;
  };
  return work;
}

std::vector<std::uint64_t> all_chunks(const ChunkedRows& work) {
  std::vector<std::uint64_t> chunks(work.chunks());
  std::iota(chunks.begin(), chunks.end(), 0);
  return chunks;
}

std::vector<double> rows_made_by(int threads) {
  const ChunkedRows work = sample_work();
  std::vector<double> rows(work.rows * 2, std::nan(""));
  std::multiset<std::uint64_t> seen;
  const auto end =
      make_chunks(work, all_chunks(work), threads,
                  [&](std::uint64_t chunk, const double* made) -> Result<void> {
                    seen.insert(chunk);
                    std::memcpy(&rows[chunk * 20], made, work.rows_of(chunk) * 2 * sizeof(double));
                    return {};
                  },
                  {});
  EXPECT_TRUE(end && *end == ChunksEnd::done);
  const auto each = all_chunks(work);
  EXPECT_EQ(seen, std::multiset<std::uint64_t>(each.begin(), each.end()));
  return rows;
}

TEST(Chunks, are_the_same_bits_on_any_number_of_threads) {
  const auto one = rows_made_by(1);
  for (const int threads : {2, 3, 7, 0}) {
    const auto many = rows_made_by(threads);
    EXPECT_EQ(std::memcmp(one.data(), many.data(), one.size() * sizeof(double)), 0) << threads << " threads";
  }
  EXPECT_EQ(one[2 * 102], std::sin(102.0));
}

TEST(Chunks, are_made_on_as_many_threads_as_asked) {
  ChunkedRows work = sample_work();
  std::mutex mutex;
  std::set<std::thread::id> makers;
  std::size_t threads = 1;
  work.make = [&](std::uint64_t, double*, const Watch&) {
    // Waits for the others, so that each thread gets its chunk also on a busy machine.
    for (int i = 0; i < 1000; ++i) {
      {
        const std::lock_guard lock(mutex);
        makers.insert(std::this_thread::get_id());
        if (makers.size() >= threads) return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
  };
  for (threads = 1; threads <= 3; threads += 2) {
    makers.clear();
    const auto end = make_chunks(work, all_chunks(work), static_cast<int>(threads),
                                 [](std::uint64_t, const double*) { return Result<void>(); }, {});
    EXPECT_TRUE(end);
    EXPECT_EQ(makers.size(), threads);
  }
}

TEST(Chunks, in_memory_are_two_a_thread_however_slow_the_sink) {
  ChunkedRows work = sample_work();
  std::atomic<int> begun{0};
  int taken = 0, most = 0;
  work.make = [&](std::uint64_t, double*, const Watch&) { return ++begun, true; };
  const auto end = make_chunks(work, all_chunks(work), 2,
                               [&](std::uint64_t, const double*) -> Result<void> {
                                 // Another is begun at once where memory is left, on a busy machine later.
                                 for (int wait = 0; wait < 1000 && most < 2 && begun - taken < 2; ++wait)
                                   std::this_thread::sleep_for(std::chrono::milliseconds(5));
                                 std::this_thread::sleep_for(std::chrono::milliseconds(5));
                                 most = std::max(most, begun - taken++);
                                 return {};
                               },
                               {});
  EXPECT_TRUE(end);
  EXPECT_GT(most, 1);
  EXPECT_LE(most, 4);
}

TEST(Chunks, end_with_the_error_of_the_sink) {
  const ChunkedRows work = sample_work();
  int taken = 0;
  const auto end = make_chunks(work, all_chunks(work), 3,
                               [&](std::uint64_t, const double*) -> Result<void> {
                                 if (++taken == 4) return Error{"the disk is full"};
                                 return {};
                               },
                               {});
  ASSERT_FALSE(end);
  EXPECT_EQ(in_words(end.error()), "the disk is full");
  EXPECT_EQ(taken, 4) << "nothing is handed on after an error";
}

TEST(Chunks, stop_when_interrupted_and_hand_on_nothing_half_made) {
  ChunkedRows work = sample_work();
  std::atomic<bool> stop{false};
  work.make = [&](std::uint64_t chunk, double*, const Watch& watch) {
    if (chunk == 5) stop = true;
    return !watch.interrupted();
  };
  for (const int threads : {1, 3}) {
    stop = false;
    std::set<std::uint64_t> seen;
    const auto end = make_chunks(
        work, all_chunks(work), threads,
        [&](std::uint64_t chunk, const double*) { return seen.insert(chunk), Result<void>(); }, {&stop});
    ASSERT_TRUE(end);
    EXPECT_EQ(*end, ChunksEnd::interrupted);
    EXPECT_EQ(seen.count(5), 0u);
    EXPECT_LT(seen.size(), work.chunks());
  }
}

TEST(Chunks, tell_their_progress_to_the_end) {
  const ChunkedRows work = sample_work();
  std::vector<double> told;
  Watch watch;
  watch.progress = [&](double fraction) { told.push_back(fraction); };
  EXPECT_TRUE(make_chunks(
      work, {2, 7, 10, 3}, 2, [](std::uint64_t, const double*) { return Result<void>(); }, watch));
  EXPECT_EQ(told, (std::vector<double>{0.25, 0.5, 0.75, 1}));
}

TEST(Chunks, pass_on_what_making_them_throws) {
  ChunkedRows work = sample_work();
  work.make = [](std::uint64_t, double*, const Watch&) -> bool { throw std::bad_alloc(); };
  EXPECT_THROW((void)make_chunks(work, all_chunks(work), 2,
                                 [](std::uint64_t, const double*) { return Result<void>(); }, {}),
               std::bad_alloc);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
