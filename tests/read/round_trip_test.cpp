// Whatever the dialect: written as one clean table and read again, it gives the same numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "cromer/base/concat.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/columns.h"
#include "cromer/read/recording.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace CROMER_FILE {

const std::filesystem::path seeds = std::filesystem::path(CROMER_SOURCE_DIR) / "tests" / "fuzz" / "corpus";

/// As `cromer inspect -o clean.csv` writes it: names in quotes where they need them, the shortest numbers.
std::string as_csv(const Table& table) {
  std::string text;
  for (std::size_t j = 0; j < table.columns.size(); ++j)
    text += concat({j > 0 ? "," : "", "\"", column_heading(table, j), "\""});
  for (std::size_t i = 0; i < table.rows(); ++i) {
    text += '\n';
    for (std::size_t j = 0; j < table.columns.size(); ++j) {
      const double value = table.columns[j].values[i];
      text += concat({j > 0 ? "," : "", std::isnan(value) ? "" : shortest(value)});
    }
  }
  return text;
}

/// Without the fuzzer's first byte, its choice of options.
std::string seed(const std::string& name) { return bytes_of(seeds / name).substr(1); }

/// Those that are read without options.
std::vector<std::string> readable_seeds() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(seeds)) {
    if (!entry.is_regular_file()) continue;  // found/ holds fragments
    const std::string name = entry.path().filename().string();
    const auto recording = read_recording(seed(name), name, {});
    if (recording && clean_table(*recording, {})) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

class RoundTrip : public testing::TestWithParam<std::string> {};

TEST_P(RoundTrip, GivesTheSameNumbers) {
  const auto recording = read_recording(seed(GetParam()), GetParam(), {});
  ASSERT_TRUE(recording.ok());
  const auto clean = clean_table(*recording, {});
  ASSERT_TRUE(clean.ok());
  const auto again = read_recording(as_csv(*clean), "clean.csv", {});
  ASSERT_TRUE(again.ok()) << in_words(again.error());
  ASSERT_EQ(again->table.columns.size(), clean->columns.size());
  for (std::size_t j = 0; j < clean->columns.size(); ++j) {
    const Column &a = again->table.columns[j], &b = clean->columns[j];
    SCOPED_TRACE(column_heading(*clean, j));
    EXPECT_EQ(column_title(a), column_title(b));
    EXPECT_EQ(a.run, b.run);
    EXPECT_EQ(a.quantity, b.quantity);
    ASSERT_EQ(a.values.size(), b.values.size());
    for (std::size_t i = 0; i < a.values.size(); ++i)
      EXPECT_TRUE(a.values[i] == b.values[i] || (std::isnan(a.values[i]) && std::isnan(b.values[i])))
          << "row " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, RoundTrip, testing::ValuesIn(readable_seeds()), [](const auto& test) {
  std::string name = test.param;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
});

}  // namespace CROMER_FILE
}  // namespace cromer::core
