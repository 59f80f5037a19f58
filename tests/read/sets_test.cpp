// Tables that stand beside or below each other become runs.
#include "cromer/documents/words/words.h"
#include "cromer/read/set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/base/concat.h"
#include "cromer/read/columns.h"
#include "cromer/read/lines.h"
#include "cromer/read/sets_below.h"

namespace cromer::core::dialects {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Set set_of(const std::string& label, const std::vector<Column>& columns, std::vector<long> lines) {
  return {label, columns, std::move(lines)};
}

Column column(const char* name, std::vector<double> values, const char* unit = "") {
  return {name, std::string(name) == "t" ? "time" : "", unit, 1, std::move(values)};
}

std::vector<std::string> laid(std::vector<Set> sets) {
  Recording recording;
  const auto good = lay_side_by_side(std::move(sets), recording);
  if (!good) return {in_words(good.error())};
  std::vector<std::string> all;
  for (const Column& each : recording.table.columns) {
    const auto known = std::count_if(each.values.begin(), each.values.end(), [](double v) { return v == v; });
    all.push_back(concat({std::to_string(each.run), column_title(each), std::to_string(known)}));
  }
  return all;
}

TEST(Sets, ARunKeepsATimeThatItHas) {
  const Column t = column("t", {0, 1}), longer = column("t", {0, 1, 2}), other = column("t", {0, 2});
  const Column x = column("x", {5, 6}), y = column("y", {7, 8}), z = column("y", {7, 8, 9});
  EXPECT_THAT(laid({set_of("a", {t, x}, {1, 2}), set_of("a", {t, y}, {3, 4})}),
              ElementsAre("1t2", "1x2", "1y2"));
  EXPECT_THAT(laid({set_of("a", {t, x}, {1, 2}), set_of("a", {other, y}, {3, 4})}),
              ElementsAre("1t2", "1x2", "1t2", "1y2"));
  EXPECT_THAT(laid({set_of("a", {t, x}, {1, 2}), set_of("a", {longer, z}, {3, 4, 5})}),
              ElementsAre("1t2", "1x2", "1t3", "1y3"));
  EXPECT_THAT(laid({set_of("a", {longer, z}, {3, 4, 5}), set_of("a", {t, x}, {1, 2})}),
              ElementsAre("1t3", "1y3", "1t2", "1x2"));
  EXPECT_THAT(laid({set_of("a", {t, x}, {1, 2}), set_of("a", {column("t", {0, 1}, "ms"), y}, {3, 4})}),
              ElementsAre("1t2", "1x2", "1t (ms)2", "1y2"));
}

TEST(Sets, ARunBeginsWithoutALabelOrWhereAColumnIsThere) {
  const Column t = column("t", {0, 1}), x = column("x", {5, 6}), y = column("y", {7, 8});
  EXPECT_THAT(laid({set_of("", {t, x}, {1, 2}), set_of("", {t, y}, {3, 4})}),
              ElementsAre("1t2", "1x2", "2t2", "2y2"));
  EXPECT_THAT(laid({set_of("a", {t, x}, {1, 2}), set_of("a", {t, x}, {3, 4}), set_of("a", {t, y}, {5, 6})}),
              ElementsAre("1t2", "1x2", "2t2", "2x2", "2y2"));
  EXPECT_THAT(laid({set_of("a", {x}, {1, 2}), set_of("a", {column("x", {1, 2}, "mm")}, {3, 4})}),
              ElementsAre("1x2", "1x (mm)2"));
  EXPECT_THAT(laid({set_of("a", {x}, {1, 2}), set_of("b", {y}, {3, 4}), set_of("a", {y}, {5, 6})}),
              ElementsAre("1x2", "2y2", "1y2"));
}

TEST(Sets, LinesAreOfTheSet) {
  Recording recording;
  const Column x = column("x", {5, 6}), longer = column("x", {7, 8, 9});
  ASSERT_TRUE(lay_side_by_side({set_of("", {x}, {1, 2}), set_of("", {longer}, {3, 5, 7})}, recording).ok());
  EXPECT_EQ(line_of(recording, 1, 2), 7);
  EXPECT_EQ(line_of(recording, 0, 1), 2);
  EXPECT_EQ(line_of(recording, 0, 2), 0);
  EXPECT_THAT(recording.lines, IsEmpty());
  Recording alone;
  ASSERT_TRUE(lay_side_by_side({set_of("", {x}, {1, 2})}, alone).ok());
  EXPECT_THAT(alone.lines, ElementsAre(1, 2));
  EXPECT_THAT(alone.lines_of_set, IsEmpty());
}

TEST(Sets, LabelsAreSaidWhereTheyAreNotTheNumber) {
  const auto said = [](const std::vector<std::string>& labels) {
    std::vector<Notice> notices;
    say_labels(labels, notices);
    return in_words(notices);
  };
  EXPECT_THAT(said({"Run #1", "Run #2"}), IsEmpty());
  EXPECT_THAT(said({"Run #1", "Run #12"}), ElementsAre("run 2 is called \"Run #12\" in the file"));
  EXPECT_THAT(said({"Run #4"}), ElementsAre("run 1 is called \"Run #4\" in the file"));
  EXPECT_THAT(said({"Latest"}), IsEmpty());
  EXPECT_THAT(said({"Latest", ""}), ElementsAre("run 1 is called \"Latest\" in the file"));
  EXPECT_THAT(said({"1", "2"}), IsEmpty());
}

TEST(Sets, TooManyOrTooUnequalOnesAreRefused) {
  const auto many = [](std::size_t count) { return laid(std::vector<Set>(count, set_of("", {}, {}))); };
  EXPECT_THAT(many(10000), IsEmpty());
  EXPECT_THAT(many(10001), ElementsAre("the file holds 10001 tables: 10000 at most are read"));
  const auto wide = [](std::size_t count) {
    return laid({set_of("", std::vector<Column>(count, column("x", {})), {})}).size();
  };
  EXPECT_EQ(wide(100000), 100000u);
  EXPECT_THAT(laid({set_of("", std::vector<Column>(60000, column("x", {})), {}),
                    set_of("", std::vector<Column>(40001, column("x", {})), {})}),
              ElementsAre("the tables of the file have 100001 columns: 100000 at most are read"));
  // 99 columns of one row beside one that is long: 100 n cells out of n + 99.
  const auto unequal = [](std::size_t rows) {
    return laid({set_of("a", {column("x", std::vector<double>(rows))}, std::vector<long>(rows)),
                 set_of("b", std::vector<Column>(99, column("y", {1})), {1})});
  };
  EXPECT_EQ(unequal(1209).size(), 100u);
  EXPECT_THAT(unequal(1210), ElementsAre("the 2 tables of the file are too unequal in length to be laid side "
                                         "by side"));
}

std::vector<std::size_t> tables(const std::string& text) { return find_tables(split_lines(text)); }

TEST(SetsBelow, BeginAtTheFirstHeaderOnceMoreOrAtATime) {
  EXPECT_THAT(tables("a,b\n1,2\na,b\n3,4\n"), ElementsAre(0, 2));
  EXPECT_THAT(tables("a,b\n1,2\na,c\n3,4\n"), ElementsAre(0));
  EXPECT_THAT(tables("a,b\n1,2\n\ntitle\nTime,c\n3,4\n"), ElementsAre(0, 3));
  EXPECT_THAT(tables("a,b\n1,2\nTime;c\n3,4\nt (s)\tc\n5,6\n"), ElementsAre(0, 2, 4));
  EXPECT_THAT(tables("a,b\n1,2\nTime\n3,4\n"), ElementsAre(0));
  EXPECT_THAT(tables("a,b\n1,2\na,b\n"), ElementsAre(0));
  EXPECT_THAT(tables("1,2\nx\n3,4\n"), ElementsAre(0));
  EXPECT_THAT(tables("a,b\n1,2\n---\na,b\n3,4\n"), ElementsAre(0, 2));
  EXPECT_THAT(tables("a,b\n-1,2\n\"+.3\",4\n# a\na,b\n \t\u22125,6\n"), ElementsAre(0, 4));
  EXPECT_THAT(tables("a,b\n1,2\na,b\nTime,d\nx,y\n3,4\n"), ElementsAre(0));
  EXPECT_THAT(tables("a\nb,c\n1,2\nb,c\n1,2\n"), ElementsAre(0, 3));
}

TEST(SetsBelow, TwoHundredAreRead) {
  std::string text;
  for (int k = 0; k < 200; ++k) text += "a,b\n1,2\n";
  EXPECT_EQ(tables(text).size(), 200u);
  EXPECT_THAT(tables(text + "a,b\n1,2\n"), ElementsAre(0));
}

TEST(SetsBelow, TitlesNameTheRun) {
  const auto read = [](const std::string& text) {
    const auto recording = read_recording(text, "lab.txt", {});
    EXPECT_TRUE(recording.ok()) << in_words(recording.error());
    return *recording;
  };
  const std::string rows = "0\t1\n1\t2\n2\t4\n";
  const auto twice = [&](const char* first, const char* second) {
    return concat({first, "\nTime (s)\tU (V)\n", rows, second, "\nTime (s)\tF (N)\n", rows});
  };
  EXPECT_THAT(runs(read(twice("U, Run #3", "F, Run #3"))), ElementsAre(1));
  EXPECT_THAT(runs(read(twice("U, Run #3 a", "F, Run #3 b"))), ElementsAre(1));
  EXPECT_THAT(runs(read(twice("U, Run #3", "F, Run #31"))), ElementsAre(1, 2));
  EXPECT_THAT(runs(read(twice("U", "F"))), ElementsAre(1, 2));
  EXPECT_THAT(
      in_words(read(twice("U, Run #3", "F, Run #31")).notices),
      ElementsAre("run 1 is called \"Run #3\" in the file", "run 2 is called \"Run #31\" in the file"));
  EXPECT_TRUE(read(twice("U", "F")).named);
  EXPECT_EQ(read(twice("U", "F")).dialect.separator, "tab");
  EXPECT_EQ(line_of(read(twice("U", "F")), 3, 2), 10);
  const auto refused = read_recording(twice("U", "F") + "x\ty\n", "lab.txt", {});
  EXPECT_EQ(in_words(refused.error()),
            "lab.txt:11: column \"Time (s)\": \"x\" is not a number; --skip-bad-rows drops such rows");
}

}  // namespace
}  // namespace cromer::core::dialects
