// Columns of words beside those of numbers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/read/reading.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// Six rows `begin` t, x `end` under a line of names.
std::string rows(const std::string& names, const std::vector<std::string>& begin,
                 const std::vector<std::string>& end, const char separator = ',') {
  std::string text = names + "\n";
  for (std::size_t i = 0; i < 6; ++i)
    text += begin[i % begin.size()] + concat({"0.0", std::to_string(i)}) + separator +
            concat({"0.", std::to_string(i * i), "5"}) + end[i % end.size()] + "\n";
  return text;
}

void expect_read(const std::string& text, const std::string& said) {
  const Recording found = read(text);
  EXPECT_THAT(titles(found), ElementsAre("1 t", "1 x")) << text;
  ASSERT_EQ(found.table.columns.size(), 2u) << text;
  EXPECT_THAT(values(found, 0), ElementsAre(0, 0.01, 0.02, 0.03, 0.04, 0.05));
  EXPECT_THAT(values(found, 1), ElementsAre(0.05, 0.15, 0.45, 0.95, 0.165, 0.255));
  EXPECT_EQ(line_of(found, 1, 5), 7);
  EXPECT_THAT(in_words(found.notices), Contains(said)) << text;
}

TEST(TextColumns, AreLeftOutAndNamed) {
  expect_read(rows("t,x,label", {""}, {",up", ",down"}), "column \"label\" holds text and is left out");
  expect_read(rows("label,t,x", {"up,", "down,"}, {""}), "column \"label\" holds text and is left out");
  expect_read(rows("a,t,x,b", {"up,", "down,"}, {",fine"}),
              "columns \"a\", \"b\" hold text and are left out");
  expect_read(rows("t;x;label", {""}, {";up", ";down"}, ';'), "column \"label\" holds text and is left out");
  expect_read(rows("t\tx\tlabel", {""}, {"\tgoing up", "\tgoing down"}, '\t'),
              "column \"label\" holds text and is left out");
}

TEST(TextColumns, MayHoldSeparatorsInQuotes) {
  expect_read(rows("label,t,x", {"\"up, or so\",", "\"down, 1 m\","}, {""}),
              "column \"label\" holds text and is left out");
  expect_read(rows("t,x,\"remark, by hand\"", {""}, {",\"say \"\"up\"\", twice\"", ",down"}),
              "column \"remark, by hand\" holds text and is left out");
}

// An event is noted in a few rows only, perhaps far from the file's begin.
TEST(TextColumns, MayBeEmptyInMostRows) {
  expect_read(rows("t,x,event", {""}, {",", ",", ",", ",pushed", ",", ","}),
              "column \"event\" holds text and is left out");
  expect_read(rows("event,t,x", {",", ",", ",", ",", ",", "let go,"}, {""}),
              "column \"event\" holds text and is left out");
  ReadOptions skip;
  skip.skip_bad_rows = true;
  const Recording found = read(rows("t,x,event", {""}, {",", ",pushed"}), "lab.csv", skip);
  EXPECT_EQ(values(found, 0).size(), 6u);
}

TEST(TextColumns, KeepTheRunsOfTheOthers) {
  const Recording found = read(
      "Run 1: label,Run 1: t,Run 1: x,Run 2: label,Run 2: t,Run 2: x\n"
      "up,0,1,up,0,2\ndown,1,2,up,1,3\nup,2,1,up,2,2\n");
  EXPECT_THAT(titles(found), ElementsAre("1 t", "1 x", "2 t", "2 x"));
}

TEST(TextColumns, AloneWithASampledColumnNeedTheRate) {
  const std::string text = "label,x\nup,0.5\ndown,1.5\nup,2.5\n";
  EXPECT_THAT(refusal(text), HasSubstr("no rows of numbers"));
  ReadOptions options;
  options.rate = 100;
  EXPECT_THAT(titles(read(text, "lab.csv", options)), ElementsAre("1 x"));
}

// Numbers that are not written as such are no text.
TEST(TextColumns, WhatMayBeANumberIsStillRefused) {
  EXPECT_THAT(refusal(rows("t,x,y", {""}, {",1.5D-03"})), HasSubstr("Fortran"));
  EXPECT_THAT(refusal(rows("t,x,y", {""}, {",12 mm"})), HasSubstr("no rows of numbers"));
  EXPECT_THAT(refusal(rows("t,x,y", {""}, {",up", ",up", ",7"})), HasSubstr("\"up\" is not a number"));
  EXPECT_THAT(refusal("t,x\n0,abc\n1,def\n2,ghi\n3,jkl\n"), HasSubstr("no rows of numbers"));
  EXPECT_THAT(refusal("In 1990, 3 men\nwent, 4 women\nand 12, dogs 7\n"), HasSubstr("no rows of numbers"));
}

TEST(TextColumns, DatesCountOnlyBesideATime) {
  const std::vector<std::string> date{"2024-05-01 10:00:00,"}, clock{"10:00:01.5,"};
  expect_read(rows("Date,t,x", date, {""}), "column \"Date\" holds text and is left out");
  expect_read(rows("clock,t,x", clock, {""}), "column \"clock\" holds text and is left out");
  EXPECT_THAT(refusal(rows("Date,u,x", clock, {""})), HasSubstr("clock time: write the seconds"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
