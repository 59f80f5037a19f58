#include "cromer/report/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/report/html_text.h"
#include "tests/support/xml.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t i = 0; (i = text.find(word, i)) != std::string::npos; i += word.size()) ++n;
  return n;
}

TEST(PageText, HasItsSmallMarkup) {
  EXPECT_EQ(inline_html("*k* and **bold** and `a*b*`"),
            "<em>k</em> and <strong>bold</strong> and <code>a*b*</code>");
  EXPECT_EQ(inline_html("**bold *k* in it**"), "<strong>bold <em>k</em> in it</strong>");
  EXPECT_EQ(inline_html("x_{0} + x^{2}"), "x<sub>0</sub> + x<sup>2</sup>");
  EXPECT_EQ(
      inline_html("*m* (*ω*_{d}^{2} + *γ*^{2})"),
      "<em>m</em> (<em>ω</em><span class=\"both\"><sup>2</sup><sub>d</sub></span> + <em>γ</em><sup>2</sup>)");
}

TEST(PageText, WhatIsNoMarkupStays) {
  EXPECT_EQ(inline_html("2 * 3 * 4 and a_b and x^2"), "2 * 3 * 4 and a_b and x^2");
  EXPECT_EQ(inline_html("*open"), "*open");
  EXPECT_EQ(inline_html("`open and x_{open"), "`open and x_{open");
  EXPECT_EQ(inline_html(""), "");
}

TEST(PageText, EverythingElseIsEscaped) {
  EXPECT_EQ(inline_html("<script>&\"'"), "&lt;script&gt;&amp;&quot;&#39;");
  EXPECT_EQ(inline_html("`<b>` *<i>*"), "<code>&lt;b&gt;</code> <em>&lt;i&gt;</em>");
  EXPECT_EQ(plain_words("*k* < 3 & `x`"), "k &lt; 3 &amp; x");
}

TEST(PageText, ANumberKeepsItsUnit) {
  EXPECT_EQ(inline_html("17.04 ± 0.02 N/m. Next"), "17.04\u00A0±\u00A00.02\u00A0N/m. Next");
  EXPECT_EQ(inline_html("10 % of 3 springs"), "10\u00A0% of 3 springs");
}

TEST(PageText, BlankLinesPartParagraphs) {
  EXPECT_EQ(paragraphs_html("one\nline\n\n  two\n\n\n"), "<p>one line</p>\n<p>two</p>\n");
  EXPECT_EQ(paragraphs_html(" \n"), "");
}

Page example() {
  Page page;
  page.title = "A *disc* <on> a spring";
  page.byline = "Lab two";
  page.summary = "What came out.";
  page.key_figures = {{"frequency", "1.408 Hz", "period"}};
  TableBlock table;
  table.caption = "Rates.";
  table.header = {"part", "rate", "remark"};
  table.rows = {{"first", "1", "same words"}, {"second", "2", "same words"}, {"third", "3"}};
  table.text_columns = {0, 2};
  table.answer_column = 1;
  const std::string svg =
      "<?xml version=\"1.0\"?>\n<svg viewBox=\"0 0 1 1\" role=\"img\" aria-label=\"old\"><path d=\"M0 "
      "0\"/></svg>";
  page.blocks = {Heading{"How stiff?"},
                 Paragraph{"Text."},
                 table,
                 FigureBlock{"figure-1", svg, "A \"b\"", "Figure 1", "One.", 0.5},
                 FigureBlock{"figure-2", svg, "Two", "Figure 2", "Two.", 0.5},
                 Heading{"Second"},
                 table,
                 Code{"a < b\n", "So:"},
                 FigureBlock{"figure-3", svg, "", "Figure 3", "Three."}};
  page.footer = "cromer";
  return page;
}

TEST(Page, IsOneDocumentThatOpensOffline) {
  const std::string html = to_html(example());
  EXPECT_EQ(html.rfind("<!DOCTYPE html>\n<html lang=\"en\">", 0), 0u);
  EXPECT_THAT(html, HasSubstr("<meta charset=\"utf-8\">"));
  EXPECT_THAT(html, HasSubstr("<meta name=\"generator\" content=\"Cromer\">"));
  EXPECT_THAT(html, HasSubstr("<link rel=\"icon\" href=\"data:,\">"));
  EXPECT_THAT(html, HasSubstr("prefers-color-scheme:dark"));
  EXPECT_THAT(html, HasSubstr("@media print"));
  EXPECT_THAT(html, Not(HasSubstr("src=")));
  EXPECT_THAT(html, Not(HasSubstr("@import")));
  EXPECT_THAT(html, Not(HasSubstr("url(")));
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, Not(HasSubstr("<?xml")));
  EXPECT_THAT(html, HasSubstr("href=\"#content\""));
  EXPECT_THAT(html, HasSubstr("<main id=\"content\">"));
}

TEST(Page, LetsNothingRunOrBeFetched) {
  Page page = example();
  page.title = "a]]>b <script>alert(1)</script> \x1b[31m \xff";
  const std::string html = to_html(page);
  EXPECT_EQ(test::html_fault(html), "");
  EXPECT_THAT(html, HasSubstr("http-equiv=\"Content-Security-Policy\" content=\"default-src 'none';"));
  EXPECT_THAT(html, Not(HasSubstr("script-src")));
  EXPECT_THAT(html, Not(HasSubstr("<script")));
}

TEST(Page, NumbersHeadingsAndTables) {
  const std::string html = to_html(example());
  EXPECT_THAT(html, HasSubstr("<h1>A <em>disc</em> &lt;on&gt; a spring</h1>"));
  EXPECT_THAT(html, HasSubstr("<title>A disc &lt;on&gt; a spring</title>"));
  EXPECT_THAT(html, HasSubstr("<span class=\"number\">2</span> Second"));
  EXPECT_THAT(html, HasSubstr("<strong>Table 1.</strong> Rates."));
  EXPECT_THAT(html, HasSubstr("<strong>Table 2.</strong> Rates."));
  EXPECT_THAT(html, HasSubstr("<strong>Figure 3.</strong> Three."));
  EXPECT_THAT(html, HasSubstr("<pre tabindex=\"0\"><code>a &lt; b</code></pre>"));
}

TEST(Page, TablesKnowWordsAnswersAndSharedCells) {
  const std::string html = to_html(example());
  EXPECT_THAT(html, HasSubstr("<td rowspan=\"2\" class=\"words\">same words</td>"));
  EXPECT_EQ(count(html, "same words"), 2u);  // once in each table
  EXPECT_THAT(html, HasSubstr("<td class=\"answer\">2</td>"));
  EXPECT_THAT(html, HasSubstr("<tr><th scope=\"row\" class=\"words\">third</th><td "
                              "class=\"answer\">3</td><td class=\"words\"></td></tr>"));
}

TEST(Page, HalfFiguresStandSideBySide) {
  const std::string html = to_html(example());
  EXPECT_EQ(count(html, "<div class=\"pair\">"), 1u);
  const std::size_t pair = html.find("<div class=\"pair\">"), end = html.find("</div>", pair);
  EXPECT_EQ(count(html.substr(pair, end - pair), "<figure"), 2u);
  EXPECT_EQ(count(html, "<figure"), count(html, "</figure>"));
  EXPECT_EQ(count(html, "<div"), count(html, "</div>"));
  EXPECT_THAT(html, HasSubstr("aria-label=\"A &quot;b&quot;\""));
  EXPECT_EQ(count(html, "aria-label=\"old\""), 1u);  // where no alternative text was given
}

TEST(Page, AnEmptyPageIsStillAPage) {
  const std::string html = to_html({});
  EXPECT_THAT(html, HasSubstr("<h1></h1>"));
  EXPECT_EQ(html.substr(html.size() - 8), "</html>\n");
}

std::string body(std::vector<Block> blocks) {
  Page page;
  page.blocks = std::move(blocks);
  const std::string html = to_html(page);
  const std::size_t from = html.find("<main id=\"content\">\n") + 20;
  return html.substr(from, html.find("</main>") - from);
}

TEST(Page, WritesOnlyWhatThereIs) {
  Page page;
  page.title = "t";
  const std::string bare = to_html(page);
  for (const char* part : {"<div class=\"summary\">", "<dl", "<p class=\"byline\">", "<footer>", "remark\">"})
    EXPECT_THAT(bare, Not(HasSubstr(part)));
  page.summary = "s", page.byline = "b", page.footer = "f", page.language = "de";
  page.key_figures = {{"n", "1", ""}, {"m", "2", "r"}};
  const std::string full = to_html(page);
  EXPECT_THAT(full, HasSubstr("<div class=\"summary\">\n<p>s</p>\n</div>"));
  EXPECT_THAT(full, HasSubstr("<p class=\"byline\">b</p>"));
  EXPECT_THAT(full, HasSubstr("<footer><div>f</div></footer>"));
  EXPECT_THAT(full, HasSubstr("<html lang=\"de\">"));
  EXPECT_THAT(full, HasSubstr("<div><dt>n</dt><dd class=\"value\">1</dd></div>\n<div><dt>m</dt><dd "
                              "class=\"value\">2</dd><dd class=\"remark\">r</dd></div>"));
  EXPECT_THAT(full, HasSubstr("content=\"width=device-width, initial-scale=1\""));
}

TEST(Page, CellsWithTheSameWordsBelowEachOtherAreOne) {
  TableBlock table;
  table.rows = {{"a", "x", "7"}, {"a", "x", "7"}, {"a", "x", "7"},
                {"a", "y", "7"}, {"a", "", ""},   {"a", "", "", "4"}};
  table.text_columns = {0, 1};
  const std::string html = body({table});
  EXPECT_EQ(count(html, "<th scope=\"row\" class=\"words\">a</th>"), 6u);  // the first column names rows
  EXPECT_EQ(count(html, "<td rowspan=\"3\" class=\"words\">x</td>"), 1u);
  EXPECT_EQ(count(html, ">x<"), 1u);
  EXPECT_EQ(count(html, "<td class=\"words\">y</td>"), 1u);
  EXPECT_EQ(count(html, "<td class=\"words\"></td>"), 2u);
  EXPECT_EQ(count(html, "<td>7</td>"), 4u);  // numbers stay
  EXPECT_EQ(count(html, "<tr>"), 6u);
  EXPECT_EQ(count(html, "<td></td>"), 2u + 5u);  // as many columns as the longest row
  EXPECT_THAT(html, Not(HasSubstr("<thead>")));
  table.text_columns = {1}, table.answer_column = 1, table.label = "Table A", table.header = {"h"};
  const std::string other = body({table});
  EXPECT_THAT(other, HasSubstr("<td>a</td><td rowspan=\"3\" class=\"words answer\">x</td>"));
  EXPECT_THAT(other, HasSubstr("<strong>Table A.</strong>"));
  EXPECT_THAT(other, HasSubstr("<thead><tr><th scope=\"col\">h</th></tr></thead>"));
  EXPECT_THAT(other, HasSubstr("id=\"table-1\""));
  EXPECT_THAT(other, HasSubstr("aria-labelledby=\"table-1\""));
}

TEST(Page, AFigureIsNamedAndPlaced) {
  const std::string bare =
      body({FigureBlock{"", "x<svg a=\"1\"><p aria-label=\"in\"/></svg>", "A & b", "", "", 1}});
  EXPECT_EQ(bare,
            "<figure class=\"wide\">\n<svg role=\"img\" aria-label=\"A &amp; b\" a=\"1\">"
            "<p aria-label=\"in\"/></svg></figure>\n");
  EXPECT_EQ(body({FigureBlock{"f", "none", "a", "", "c", 0.51}}),
            "<figure id=\"f\" class=\"wide\">\n<figcaption>c</figcaption>\n</figure>\n");
  EXPECT_EQ(body({FigureBlock{"f", "<svg>", "", "F", "", 0.5}}),
            "<div class=\"pair\">\n<figure id=\"f\">\n<svg><figcaption><strong>F.</strong> </figcaption>\n"
            "</figure>\n</div>\n");
  EXPECT_EQ(body({FigureBlock{"", "<svg aria-label=\"old\">", "new", "", "", 1}}),
            "<figure class=\"wide\">\n<svg aria-label=\"new\"></figure>\n");
}

TEST(Page, CodeIsAsItWasTyped) {
  EXPECT_EQ(body({Code{"a *b*\n\n", ""}}), "<pre tabindex=\"0\"><code>a *b*</code></pre>\n");
  EXPECT_EQ(body({Code{"\n", "c"}}), "<p class=\"caption\">c</p>\n<pre tabindex=\"0\"><code></code></pre>\n");
  EXPECT_EQ(body({Heading{"h"}}), "<h2 id=\"section-1\"><span class=\"number\">1</span> h</h2>\n");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
