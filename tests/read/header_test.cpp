// The lines above the rows: which of them names the columns, and what one name says.
#include "cromer/read/header.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/base/concat.h"
#include "cromer/read/cells.h"

namespace cromer::core::dialects {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::IsEmpty;

/// "name|unit|run|prefix".
std::string parsed(std::string_view cell) {
  const Heading heading = parse_heading(cell);
  return concat({heading.name, "|", heading.unit, "|", heading.run, "|", heading.prefix});
}

TEST(Heading, RunsStandBehindOrInFront) {
  EXPECT_EQ(parsed("x (m) Run #12"), "x|m|Run #12|");
  EXPECT_EQ(parsed("x, Run 1"), "x||Run 1|");
  EXPECT_EQ(parsed("Run #1"), "||Run #1|");
  EXPECT_EQ(parsed("x Run #1 (m)"), "x|m|Run #1|");
  EXPECT_EQ(parsed("x Run"), "x Run|||");
  EXPECT_EQ(parsed("x Run #1b"), "x Run #1b|||");
  EXPECT_EQ(parsed("x Runner 5"), "x Runner 5|||");
  EXPECT_EQ(parsed("x5Run 1"), "x5Run 1|||");
  EXPECT_EQ(parsed("5"), "5|||");
  EXPECT_EQ(parsed("Run 1: x (m)"), "x|m|Run 1|Run 1");
  EXPECT_EQ(parsed("Latest:x"), "x||Latest|Latest");
  EXPECT_EQ(parsed("x:"), "x:|||");
  EXPECT_EQ(parsed("Latest: x Run #2"), "x||Run #2|Latest");
  const std::string longest(60, 'a');
  EXPECT_EQ(parsed(longest + ":x"), concat({"x||", longest, "|", longest}));
  EXPECT_EQ(parsed(longest + "b:x"), concat({longest, "b:x|||"}));
}

TEST(Heading, UnitsStandInBrackets) {
  EXPECT_EQ(parsed("x [mm]"), "x|mm||");
  EXPECT_EQ(parsed("x ( mm )"), "x|mm||");
  EXPECT_EQ(parsed("(mm)"), "(mm)|||");
  EXPECT_EQ(parsed("x (m]"), "x (m]|||");
  EXPECT_EQ(parsed("x m)"), "x m)|||");
  EXPECT_EQ(parsed("f(x) (m)"), "f(x)|m||");
  EXPECT_EQ(parsed("v/(m/s)"), "v|m/s||");
  EXPECT_EQ(parsed("/"), "/|||");
  EXPECT_EQ(parsed("Position (cm) smoothed"), "Position smoothed|cm||");
  EXPECT_EQ(parsed("Position [cm] smoothed"), "Position smoothed|cm||");
  EXPECT_EQ(parsed("(cm) smoothed"), "(cm) smoothed|||");
  EXPECT_EQ(parsed("Position (s) smoothed"), "Position (s) smoothed|||");
  EXPECT_EQ(parsed("Position () smoothed"), "Position () smoothed|||");
}

TEST(Heading, UnitsStandBehindTheName) {
  EXPECT_EQ(parsed("time_s"), "time|s||");
  EXPECT_EQ(parsed("pos_x_mm"), "pos_x|mm||");
  EXPECT_EQ(parsed("time_"), "time_|||");
  EXPECT_EQ(parsed("_s"), "_s|||");
  EXPECT_EQ(parsed("pos_s"), "pos_s|||");
  EXPECT_EQ(parsed("time_1"), "time_1|||");
  EXPECT_EQ(parsed("foo_m"), "foo_m|||");
  EXPECT_EQ(parsed("Time/ms"), "Time|ms||");
  EXPECT_EQ(parsed("Time/[ms]"), "Time|ms||");
  EXPECT_EQ(parsed("Time/ticks"), "Time|ticks||");
  EXPECT_EQ(parsed("Time/m"), "Time|m||");
  EXPECT_EQ(parsed("Time/("), "Time|(||");
  EXPECT_EQ(parsed("Position/furlong"), "Position|furlong||");
  EXPECT_EQ(parsed("Position/s"), "Position/s|||");
  EXPECT_EQ(parsed("/ms"), "/ms|||");
  EXPECT_EQ(parsed("foo/mm"), "foo/mm|||");
  EXPECT_EQ(parsed("Time in ms"), "Time|ms||");
  EXPECT_EQ(parsed("Time in air"), "Time in air|||");
  EXPECT_EQ(parsed("Position, mm"), "Position|mm||");
  EXPECT_EQ(parsed("Position, s"), "Position, s|||");
  EXPECT_EQ(parsed("Time, local"), "Time, local|||");
  EXPECT_EQ(parsed("Position, left"), "Position, left|||");
  EXPECT_EQ(parsed("pos cm"), "pos|cm||");
  EXPECT_EQ(parsed("pos\tcm"), "pos|cm||");
  EXPECT_EQ(parsed("pos s"), "pos s|||");
  EXPECT_EQ(parsed("foo cm"), "foo cm|||");
  EXPECT_EQ(parsed("millis"), "millis|ms||");
}

TEST(Heading, AnApostropheBeforeAFormulaIsTakenOff) {
  for (const char* sign : {"=", "+", "-", "@"})
    EXPECT_EQ(parsed(concat({"'", sign, "a"})), concat({sign, "a|||"}));
  EXPECT_EQ(parsed("'-"), "-|||");
  EXPECT_EQ(parsed("'a"), "'a|||");
  EXPECT_EQ(parsed("'"), "'|||");
  EXPECT_EQ(parsed("a-b"), "a-b|||");
  EXPECT_EQ(parsed("a \"\"b\"\" c"), "a \"b\" c|||");
  EXPECT_EQ(parsed("a\""), "a\"|||");
}

Header header_of(const std::string& text, std::size_t columns, char separator = ',') {
  const auto lines = split_lines(text);
  return find_header(lines, lines.size() - 1, Layout{separator, '.', columns});
}

/// "name|unit" of each column.
std::vector<std::string> names(const Header& header) {
  std::vector<std::string> all;
  for (const Heading& heading : header.headings) all.push_back(concat({heading.name, "|", heading.unit}));
  return all;
}

TEST(Header, TheLineAboveTheRowsNamesTheColumns) {
  const Header header = header_of("My lab\nby me\n\n# note\nt,x\n", 2);
  EXPECT_THAT(names(header), ElementsAre("t|", "x|"));
  EXPECT_THAT(header.titles, ElementsAre("My lab", "by me"));
  EXPECT_EQ(header.separator, ',');
  EXPECT_FALSE(header.quoted);
  EXPECT_THAT(names(header_of("", 2)), IsEmpty());
  EXPECT_TRUE(header_of("\"t\",\"x\"\n", 2).quoted);
  EXPECT_TRUE(header_of("lab\n\"t\",x\n", 2).quoted);
  EXPECT_TRUE(header_of("lab\nt,\"x\"\n", 2).quoted);
}

TEST(Header, LinesOfNumbersAreTitles) {
  const Header header = header_of("t,x\n2024\n4,0.5\n", 2);
  EXPECT_THAT(names(header), ElementsAre("t|", "x|"));
  EXPECT_THAT(header.titles, ElementsAre("4,0.5", "2024"));
  EXPECT_THAT(names(header_of("4,0.5\n", 2)), IsEmpty());
  EXPECT_THAT(header_of("4,0.5\n", 2).titles, ElementsAre("4,0.5"));
  // Of one column, with blanks between them.
  EXPECT_THAT(names(header_of("x (m)\n4 0.5\n", 1, 0)), ElementsAre("x|m"));
  EXPECT_THAT(names(header_of("my x\n", 1, 0)), ElementsAre("my x|"));
}

TEST(Header, ACommentNamesColumnsThatItMatches) {
  EXPECT_THAT(names(header_of("# made by hand\n# t,x\n", 2)), ElementsAre("t|", "x|"));
  EXPECT_THAT(names(header_of("% t,x\n", 2)), ElementsAre("t|", "x|"));
  EXPECT_THAT(names(header_of("# t,x\n# made by hand\n", 2)), IsEmpty());
  EXPECT_THAT(names(header_of("# t,x,y\n", 2)), IsEmpty());
  EXPECT_THAT(names(header_of("# t\n", 1, 0)), IsEmpty());
  EXPECT_THAT(names(header_of("a,b\n# t,x\n", 2)), ElementsAre("a|", "b|"));
}

TEST(Header, ALineOfUnitsStandsBelowTheNames) {
  EXPECT_THAT(names(header_of("t,x\ns,mm\n", 2)), ElementsAre("t|s", "x|mm"));
  EXPECT_THAT(names(header_of("t,x\n[s],( mm )\n", 2)), ElementsAre("t|s", "x|mm"));
  EXPECT_THAT(names(header_of("t,x\n,mm\n", 2)), ElementsAre("t|", "x|mm"));
  EXPECT_THAT(names(header_of("t (ms),x\ns,mm\n", 2)), ElementsAre("t|ms", "x|mm"));
  EXPECT_THAT(names(header_of("t,x\ns,y\n", 2)), ElementsAre("s|", "y|"));
  EXPECT_THAT(names(header_of("t,x\n[s,(mm)\n", 2)), ElementsAre("[s|", "(mm)|"));
  EXPECT_THAT(names(header_of("s,m\n", 2)), ElementsAre("s|", "m|"));
  EXPECT_THAT(names(header_of("t\ns,mm\n", 2)), ElementsAre("s|", "mm|"));
  EXPECT_THAT(header_of("t\ns,mm\n", 2).titles, ElementsAre("t"));
  EXPECT_THAT(header_of("lab\nt,x\ns,mm\n", 2).titles, ElementsAre("lab"));
}

TEST(Header, NamesMayHaveASeparatorOfTheirOwn) {
  EXPECT_EQ(header_of("t\tx\n", 2).separator, '\t');
  EXPECT_EQ(header_of("t;x\n", 2).separator, ';');
  EXPECT_EQ(header_of("t,x\n", 2, ';').separator, ',');
  EXPECT_EQ(header_of("t x\n", 2).separator, ' ');
  EXPECT_EQ(header_of("x\n", 1, 0).separator, 0);
  EXPECT_THAT(names(header_of("t,x,\n", 2)), ElementsAre("t|", "x|"));
  EXPECT_THAT(names(header_of("t,x,\n", 3)), ElementsAre("t|", "x|"));
  // A delimiter that ends each row makes a column more; a lone word is a name of two.
  EXPECT_THAT(names(header_of("t,x\n", 3)), ElementsAre("t|", "x|"));
  EXPECT_THAT(names(header_of("Time\n", 2)), ElementsAre("Time|"));
  EXPECT_THAT(names(header_of("Time\n", 3)), IsEmpty());
  EXPECT_THAT(names(header_of("a,b,c,d\n", 3)), ElementsAre("a|", "b|", "c|"));
}

TEST(Header, BetweenBlanksABracketBelongsToItsName) {
  EXPECT_THAT(names(header_of("Time (s)  Position [mm]\n", 2, ' ')), ElementsAre("Time|s", "Position|mm"));
  EXPECT_THAT(names(header_of("Time ( s ) x\n", 2, ' ')), ElementsAre("Time|s", "x|"));
  EXPECT_THAT(names(header_of("(s) x\n", 2, ' ')), ElementsAre("(s)|", "x|"));
  EXPECT_THAT(names(header_of("Time(s) x(m) y\n", 3, ' ')), ElementsAre("Time|s", "x|m", "y|"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::dialects
