// A task's simulation for tests that look at what it gives, or at why it refuses.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

inline SimulateResult simulated(const SimulateOptions& options) {
  auto result = simulate(options);
  EXPECT_TRUE(result.ok()) << (result ? "" : in_words(result.error()));
  return result ? *std::move(result) : SimulateResult{};
}

/// The first of its runs.
inline SimulatedRun run(const SimulateOptions& options) {
  SimulateResult result = simulated(options);
  return result.runs.empty() ? SimulatedRun{} : std::move(result.runs.front());
}

/// Why it refuses; "" where it does not.
inline std::string refusal(const SimulateOptions& options) {
  const auto result = simulate(options);
  return result ? "" : in_words(result.error());
}

}  // namespace cromer::core
