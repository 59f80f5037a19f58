#include "cromer/tasks/inspect/inspect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "cromer/documents/words/words.h"
#include "cromer/read/recording.h"
#include "tests/support/bytes_of.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::Contains;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Inspect, DescribesTheMainColumn) {
  const auto found = inspect("Time (s),Position (m)\n0,1\n0.1,2\n0.2,1\n0.5,2\n0.6,1\n", "lab.csv", {});
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->samples, 5u);
  EXPECT_NEAR(found->rate, 10, 1e-12);
  EXPECT_DOUBLE_EQ(found->duration, 0.6);
  EXPECT_EQ(found->time_column, "Time (s)");
  ASSERT_EQ(found->gaps.size(), 1u);
  EXPECT_DOUBLE_EQ(found->gaps[0].t, 0.2);
  EXPECT_NEAR(found->gaps[0].length, 0.3, 1e-15);
  ASSERT_EQ(found->series.size(), 1u);
  EXPECT_EQ(found->series[0].column, "Position (m)");
}

TEST(Inspect, ListsWhatSticksOutOfTheOtherColumnsToo) {
  std::string text = "Time (s),Position (m),Velocity (m/s)\n";
  for (int i = 0; i < 200; ++i)
    text += std::to_string(0.01 * i) + "," + std::to_string(std::cos(0.1 * i)) + "," +
            (i == 120 ? "1e30" : std::to_string(std::sin(0.1 * i))) + "\n";
  const auto found = inspect(text, "lab.csv", {});
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->column, "Position (m)");
  EXPECT_THAT(in_words(found->notices),
              Contains("column \"Velocity (m/s)\": 1 outlier, the first in line 122: 1e+30"));
}

TEST(Inspect, DescribesAllRuns) {
  ReadOptions options;
  options.rate = 100;
  const auto found = inspect("x (mm) Run #1;x (mm) Run #2\n1,5;9,5\n2,5;8,5\n3,5;\n", "lab.csv", options);
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->series.size(), 2u);
  EXPECT_EQ(found->samples, 3u);
  EXPECT_DOUBLE_EQ(found->duration, 0.02);
}

TEST(Inspect, CountsTheValuesOfEachColumn) {
  ReadOptions options;
  options.rate = 100;
  const auto found = inspect("x (mm) Run #1;x (mm) Run #2\n1,5;9,5\n2,5;8,5\n3,5;\n", "lab.csv", options);
  ASSERT_TRUE(found.ok());
  ASSERT_EQ(found->columns.size(), 2u);
  EXPECT_EQ(found->columns[0].samples, 3u);
  EXPECT_EQ(found->columns[1].samples, 2u);
  EXPECT_EQ(found->rate, 100);
  EXPECT_EQ(found->jitter, 0);
}

TEST(Inspect, PairsEachColumnWithItsTime) {
  const auto found = inspect("Time A,Pos A,Time B,Pos B\n0,1.5,0.5,7\n1,2,1.5,8\n2,4,2.5,9\n", "lab.csv", {});
  ASSERT_TRUE(found.ok());
  ASSERT_EQ(found->columns.size(), 4u);
  EXPECT_EQ(found->columns[0].time_column, "");
  EXPECT_EQ(found->columns[1].time_column, "Time A");
  EXPECT_EQ(found->columns[3].time_column, "Time B");
}

TEST(Inspect, DescribesColumnsOfUnknownKind) {
  const auto found = inspect("Tempo,Forzante,Pendolo\n0,1.5,5\n1,2,6\n2,1,8\n", "lab.csv", {});
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->rate, 1);
  EXPECT_EQ(found->series.at(0).column, "Forzante");
}

TEST(Inspect, NeedNotChooseAmongAlike) {
  const auto found = inspect("t\tx\ty\n0\t1\t2\n1\t2\t3\n2\t3\t5\n", "lab.txt", {});
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->recording.table.columns.size(), 3u);
  EXPECT_EQ(found->rate, 1);
  EXPECT_EQ(found->series.at(0).column, "x");
}

TEST(Inspect, DescribesTheColumnAskedFor) {
  const std::string_view file = "t (ms)\tx (cm)\ty (cm)\n0\t1\t2\n100\t2\t3\n200\t3\t5\n";
  EXPECT_EQ(inspect(file, "lab.txt", {})->column, "x (cm)");
  const auto found = inspect(file, "lab.txt", {}, "y (cm)");
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->column, "y (cm)");
  ASSERT_EQ(found->series.size(), 1u);
  EXPECT_THAT(found->series[0].t, ElementsAre(0, DoubleEq(0.1), DoubleEq(0.2)));
  EXPECT_THAT(found->series[0].y, ElementsAre(DoubleEq(0.02), DoubleEq(0.03), DoubleEq(0.05)));
  const auto none = inspect(file, "lab.txt", {}, "z");
  ASSERT_TRUE(none.ok());
  EXPECT_TRUE(none->series.empty());
  EXPECT_THAT(in_words(none->notices), Contains(HasSubstr("\"z\"")));
}

TEST(Inspect, NamesItsColumnWithoutTimesToo) {
  EXPECT_EQ(inspect("Force (N);Position (mm)\n1,5;9,5\n2,5;8,5\n3,5;7\n", "lab.csv", {})->column,
            "Position (mm)");
}

TEST(Inspect, WithoutTimesSaysWhatIsMissing) {
  const auto found = inspect("Position (mm) Run #1\n1.5\n2.5\n3.5\n", "lab.csv", {});
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->rate, 0);
  EXPECT_EQ(found->duration, 0);
  EXPECT_EQ(found->samples, 3u);
  EXPECT_THAT(in_words(found->notices), ElementsAre(HasSubstr("--rate")));
}

TEST(Inspect, BackwardTimeIsAWarningHere) {
  const auto found = inspect("t,x\n3,1\n2,2\n1,3\n0,4\n", "lab.csv", {});
  ASSERT_TRUE(found.ok());
  EXPECT_THAT(in_words(found->notices), Contains(HasSubstr("the time runs backward")));
}

TEST(Inspect, BadFilesAreErrors) {
  EXPECT_EQ(in_words(inspect("", "lab.csv", {}).error()), "lab.csv: the file is empty");
}

// The seeds of the fuzzer, and whatever it once found, through the same calls; see tests/fuzz.
TEST(Inspect, TheFuzzersCorpusEndsInAnswers) {
  const auto corpus = std::filesystem::path(CROMER_SOURCE_DIR) / "tests" / "fuzz" / "corpus";
  std::size_t files = 0, read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus)) {
    if (!entry.is_regular_file()) continue;
    const std::string bytes = bytes_of(entry.path());
    ASSERT_FALSE(bytes.empty());
    ReadOptions options;
    const auto choice = static_cast<unsigned char>(bytes[0]);
    options.skip_bad_rows = (choice & 1u) != 0;
    if (choice & 2u) options.rate = 100;
    if (choice & 4u) options.decimal = ",";
    if (choice & 8u) options.delimiter = ",";
    if (choice & 16u) options.time_column = "t";
    const auto found = inspect(std::string_view(bytes).substr(1), "seed", options);
    ++files;
    if (!found) {
      EXPECT_THAT(in_words(found.error()), testing::StartsWith("seed:"));
      continue;
    }
    ++read;
    const auto clean = clean_table(found->recording, options);
    if (clean) {
      for (const Column& column : clean->columns) EXPECT_EQ(column.values.size(), clean->rows());
    }
  }
  EXPECT_GE(files, 20u);
  EXPECT_GE(read, 15u);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
