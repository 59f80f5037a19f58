// Files that other people's loggers wrote, as they published them (../shared/data; not part of the project).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "cromer/base/concat.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/columns.h"
#include "cromer/read/recording.h"
#include "tests/read/measured_files.h"

namespace cromer::core {
namespace {

using testing::Contains;
using testing::HasSubstr;

const std::filesystem::path folder = std::filesystem::path(CROMER_SOURCE_DIR) / ".." / "shared" / "data";

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The file's name in letters and digits.
std::string test_name(const testing::TestParamInfo<Known>& test) {
  std::string name;
  for (const char c : std::filesystem::path(test.param.file).stem().string())
    name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

std::string dialect_of(const Recording& recording) {
  const Dialect& dialect = recording.dialect;
  return concat({dialect.name, ", ", dialect.encoding, ", ", dialect.separator, ", ", dialect.decimal});
}

std::vector<std::string> columns_of(const Recording& recording) {
  std::vector<std::string> all;
  for (const Column& column : recording.table.columns) {
    const auto there = std::count_if(column.values.begin(), column.values.end(),
                                     [](double value) { return !std::isnan(value); });
    all.push_back(concat({std::to_string(column.run), " ", column_title(column), ": ", column.quantity, " ",
                          std::to_string(there)}));
  }
  return all;
}

/// Jitter moves the median step: three digits of the rate.
std::string series_of(const Series& series) {
  const std::string rate = series.jitter > 1e-6 ? rounded(series.rate, 3) : shortest(series.rate);
  return concat({std::to_string(series.t.size()), " at ", rate, " Hz, ",
                 rounded(series.t.back() - series.t.front(), 6), " s, ", std::to_string(series.gaps.size()),
                 " gaps, ", std::to_string(series.outliers.size()), " outliers"});
}

class MeasuredFile : public testing::TestWithParam<Known> {};

TEST_P(MeasuredFile, IsReadRightly) {
  const Known& known = GetParam();
  if (!std::filesystem::exists(folder / known.file)) GTEST_SKIP() << "no " << (folder / known.file);
  ReadOptions options;
  options.rate = known.rate;
  const auto recording = read_recording(bytes_of(folder / known.file), known.file, options);
  ASSERT_TRUE(recording.ok()) << in_words(recording.error());
  EXPECT_EQ(dialect_of(*recording), known.dialect);
  EXPECT_EQ(columns_of(*recording), known.columns);
  std::vector<std::string> all, notices = in_words(recording->notices);
  for (const int run : runs(*recording)) {
    const auto series = take_series(*recording, known.column, run, options);
    ASSERT_TRUE(series.ok()) << in_words(series.error());
    all.push_back(series_of(*series));
    if (run > 1) continue;
    EXPECT_DOUBLE_EQ(series->y.front(), known.first);
    EXPECT_DOUBLE_EQ(series->y.back(), known.last);
    for (const std::string& said : in_words(series->notices)) notices.push_back(said);
  }
  EXPECT_EQ(all, known.series);
  EXPECT_EQ(notices, known.notices);
}

INSTANTIATE_TEST_SUITE_P(Shared, MeasuredFile, testing::ValuesIn(measured_files()), test_name);

TEST(MeasuredFiles, ATableOfWordsIsRefused) {
  const auto path = folder / "silverbox" / "published_rmse_van_mulders.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const auto recording = read_recording(bytes_of(path), "published.csv", {});
  ASSERT_FALSE(recording.ok());
  EXPECT_THAT(in_words(recording.error()), HasSubstr("no rows of numbers are found"));
}

TEST(MeasuredFiles, TrackerNeedsAChoiceOfColumn) {
  const auto path = folder / "pendulum-tracker" / "8047.txt";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const auto recording = read_recording(bytes_of(path), "8047.txt", {});
  ASSERT_TRUE(recording.ok());
  const auto series = take_series(*recording, "", 1, {});
  ASSERT_FALSE(series.ok());
  EXPECT_THAT(in_words(series.error()), HasSubstr("\"x\", \"y\""));
}

TEST(MeasuredFiles, TheLongRunsHaveNoOutliersButRoundingSteps) {
  const auto path = folder / "spring-disc-pasco" / "molla_durissima_discopieno_14.91945_0.2016_1.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const auto recording = read_recording(bytes_of(path), "lab.csv", {});
  ASSERT_TRUE(recording.ok());
  const auto series = take_series(*recording, "", 1, {});
  ASSERT_TRUE(series.ok());
  EXPECT_TRUE(series->outliers.empty());
  EXPECT_DOUBLE_EQ(series->resolution, 1e-4);
  EXPECT_THAT(in_words(series->notices), Contains(HasSubstr("\"position\" has no unit: m is assumed")));
}

}  // namespace
}  // namespace cromer::core
