#include "cromer/base/at_once.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace cromer::core {
namespace {

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

}  // namespace
}  // namespace cromer::core
