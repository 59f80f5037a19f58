// Measured recordings by others, read where their folder exists.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/bytes_of.h"

namespace cromer::core {

inline std::string data(const std::string& name) {
  return std::string(CROMER_SOURCE_DIR) + "/../shared/data/" + name;
}

#define SKIP_WITHOUT(path) \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here"

}  // namespace cromer::core
