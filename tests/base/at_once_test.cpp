#include "cromer/base/at_once.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace cromer::core {
namespace CROMER_FILE {

TEST(AtOnce, DoesEachPieceOnceAndTheFirstOnThisThread) {
  for (const std::size_t count : {0U, 1U, 2U, 7U, 100U}) {
    std::vector<std::atomic<int>> done(count);
    std::thread::id first;
    at_once(count, [&](std::size_t i) {
      if (i == 0) first = std::this_thread::get_id();
      ++done[i];
    });
    for (const std::atomic<int>& each : done) EXPECT_EQ(each, 1);
    EXPECT_EQ(first, count > 0 ? std::this_thread::get_id() : std::thread::id());
  }
}

TEST(AtOnce, DoesTwoPiecesSideBySide) {
  std::atomic<int> begun = 0;
  std::atomic<bool> met = false;
  at_once(2, [&](std::size_t) {
    ++begun;
    for (int i = 0; i < 5000 && begun < 2; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    met = begun == 2;
  });
  EXPECT_TRUE(met);
}

TEST(AtOnce, BeginsNoPieceBeforeThoseFarEnoughBeforeItHaveEnded) {
  constexpr std::size_t count = 200;
  for (const std::size_t ahead : {1U, 2U, 4U}) {
    std::vector<std::atomic<bool>> ended(count);
    std::atomic<int> early = 0;
    std::vector<std::size_t> told;  // in order, one at a time
    at_once(
        count,
        [&](std::size_t i) {
          for (std::size_t k = 0; k + ahead <= i; ++k) early += !ended[k];
          if (i % 3 == 0) std::this_thread::sleep_for(std::chrono::microseconds(200));
          ended[i] = true;
        },
        ahead, [&](std::size_t i) { told.push_back(i); });
    ASSERT_EQ(told.size(), count);
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(told[i], i);
    EXPECT_EQ(early, 0) << ahead;
    for (const std::atomic<bool>& each : ended) EXPECT_TRUE(each);
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
