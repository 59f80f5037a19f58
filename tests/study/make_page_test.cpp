#include "cromer/study/write_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class MakePage : public testing::Test {
 protected:
  MakePage() {
    results_.set("k", 3, "N/m");
    for (const char* run : {"a.1", "a.2", "a.4"}) results_.set(std::string(run) + ".label", std::string(run));
    study_.file = "lab.toml";
    study_.title = "title {k}";
    study_.byline = "byline {k}";
    study_.summary = "summary {k}";
    study_.key_figures = {{"name {k}", "value {k}", "remark {k}"}, {"n", "v", ""}};
    study_.figures.resize(2);
    study_.figures[0].look.id = "first";
    study_.figures[1].look.id = "second";
  }

  void add(decltype(BlockSpec::content) content) {
    study_.blocks.push_back({std::move(content), {"lab.toml", 9, 1}});
  }
  Page page() {
    const auto made =
        make_page(study_, results_, {{"second", {"<svg/>", "title", "caption", 0.5}}}, "footer");
    EXPECT_TRUE(made) << (made ? "" : in_words(made.error()));
    return made ? *made : Page{};
  }
  std::string refusal() {
    const auto made = make_page(study_, results_, {}, "");
    return made ? "" : in_words(made.error());
  }

  Study study_;
  Results results_;
};

TEST_F(MakePage, FillsWhatStandsAtItsTop) {
  const Page made = page();
  EXPECT_EQ(made.title, "title 3\u00a0N/m");
  EXPECT_EQ(made.byline, "byline 3\u00a0N/m");
  EXPECT_EQ(made.summary, "summary 3\u00a0N/m");
  EXPECT_EQ(made.footer, "footer");
  ASSERT_EQ(made.key_figures.size(), 2u);
  EXPECT_EQ(made.key_figures[0].name, "name 3\u00a0N/m");
  EXPECT_EQ(made.key_figures[0].value, "value 3\u00a0N/m");
  EXPECT_EQ(made.key_figures[0].remark, "remark 3\u00a0N/m");
  EXPECT_THAT(made.blocks, IsEmpty());
}

TEST_F(MakePage, HasTheBlocksInTheirOrder) {
  add(BlockSpec::Heading{"h {k}"});
  add(BlockSpec::Text{"t {k}"});
  add(BlockSpec::Code{"c {k}", "d {k}"});
  add(BlockSpec::FigureName{"second"});
  const Page made = page();
  ASSERT_EQ(made.blocks.size(), 4u);
  EXPECT_EQ(std::get<Heading>(made.blocks[0]).text, "h 3\u00a0N/m");
  EXPECT_EQ(std::get<Paragraph>(made.blocks[1]).text, "t 3\u00a0N/m");
  EXPECT_EQ(std::get<Code>(made.blocks[2]).text, "c 3\u00a0N/m");
  EXPECT_EQ(std::get<Code>(made.blocks[2]).caption, "d 3\u00a0N/m");
  const auto& figure = std::get<FigureBlock>(made.blocks[3]);
  EXPECT_EQ(figure.id + figure.svg + figure.alt + figure.caption, "second<svg/>titlecaption");
  EXPECT_EQ(figure.label, "Figure 2");
  EXPECT_EQ(figure.width, 0.5);
}

TEST_F(MakePage, ATableRepeatsItsRowForEveryRun) {
  TableSpec table;
  table.caption = "c {k}";
  table.header = {"one {k}", "two"};
  table.rows = {{"r {k}", "s"}, {"u", "v"}};
  table.each = {"a"};
  table.row = {"{.label}", "{k, bare}"};
  table.text_columns = {0, 1};
  table.answer_column = 1;
  add(table);
  const Page page_of_table = page();
  const auto& made = std::get<TableBlock>(page_of_table.blocks.at(0));
  EXPECT_EQ(made.caption, "c 3\u00a0N/m");
  EXPECT_THAT(made.header, ElementsAre("one 3\u00a0N/m", "two"));
  // The third run is not there, so the fourth is none.
  EXPECT_THAT(made.rows, ElementsAre(ElementsAre("r 3\u00a0N/m", "s"), ElementsAre("u", "v"),
                                     ElementsAre("a.1", "3"), ElementsAre("a.2", "3")));
  EXPECT_THAT(made.text_columns, ElementsAre(0, 1));
  EXPECT_EQ(made.answer_column, 1);
}

TEST_F(MakePage, SaysWhereATextIsThatCannotBeFilled) {
  add(BlockSpec::Text{"{first} {second}"});
  EXPECT_EQ(refusal(), "lab.toml:9:1: \"first\" is no result of this study");
  TableSpec table;
  table.each = {"b", "c"};
  study_.blocks.clear();
  add(table);
  EXPECT_EQ(refusal(), "lab.toml:9:1: \"b\" has no runs to list");
  study_.key_figures[1].remark = "{missing}";
  EXPECT_EQ(refusal(), "lab.toml:1:1: \"missing\" is no result of this study");
}

}  // namespace
}  // namespace cromer::core
