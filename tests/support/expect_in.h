// Files in the tree that tests write: from the descriptions of results and the tables of options.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/bytes_of.h"

namespace cromer::core {

/// Expects that the file in the tree is `now`, or writes it.
inline void expect_in(const std::string& file, const std::string& now) {
  const std::filesystem::path path = std::filesystem::path(CROMER_SOURCE_DIR) / file;
  if (std::getenv("CROMER_WRITE_DESCRIPTIONS")) {
    std::ofstream(path) << now;
    return;
  }
  const std::string then = bytes_of(path);
  EXPECT_EQ(then, now) << file << " is not what the descriptions say: run test_documents with "
                       << "CROMER_WRITE_DESCRIPTIONS=1";
}

}  // namespace cromer::core
