// The style sheet: its colours, its sizes, both themes complete.
#include "cromer/report/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "cromer/report/palette.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::HasSubstr;
using Colours = std::map<std::string, std::string>;

std::vector<std::smatch> matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  return {std::sregex_iterator(text.begin(), text.end(), expression), std::sregex_iterator()};
}

/// Of light and dark, in this order.
std::vector<Colours> themes(const std::string& css) {
  std::vector<Colours> all;
  for (const auto& root : matches(css, ":root\\{(--[^}]*)\\}")) {
    Colours colours;
    const std::string body = root[1];
    for (const auto& each : matches(body, "--([a-z0-9-]+):(#[0-9A-F]{6});")) colours[each[1]] = each[2];
    all.push_back(colours);
  }
  return all;
}

TEST(PageStyle, HasItsColoursInBothThemes) {
  const std::string css = page_style();
  const std::vector<Colours> both = themes(css);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0], (Colours{{"ground", "#FFFFFF"},
                              {"ink", "#171C24"},
                              {"text-2", "#4A5361"},
                              {"text-3", "#626C7A"},
                              {"sunk", "#EEF0F3"},
                              {"line", "#DFE3E8"},
                              {"focus", "#2457D6"}}));
  EXPECT_EQ(both[1], (Colours{{"ground", "#171C23"},
                              {"ink", "#EDF0F4"},
                              {"text-2", "#B7C0CC"},
                              {"text-3", "#949FAE"},
                              {"sunk", "#10151B"},
                              {"line", "#2A323D"},
                              {"focus", "#8FB4FF"}}));
  EXPECT_LT(css.find(":root{--"), css.find("prefers-color-scheme:dark"));
}

TEST(PageStyle, EveryColourIsAVariableThatBothThemesDefine) {
  const std::string css = page_style();
  const std::vector<Colours> both = themes(css);
  std::set<std::string> used;
  for (const auto& each : matches(css, "var\\(--([a-z0-9-]+)\\)")) used.insert(each[1]);
  EXPECT_GE(used.size(), 7u);
  for (const Colours& theme : both)
    for (const std::string& name : used) EXPECT_EQ(theme.count(name), 1u) << name;
  const std::string layout =
      css.substr(css.find("*{box-sizing"), css.find("prefers-color") - css.find("*{box"));
  EXPECT_EQ(layout.find('#'), std::string::npos);
  EXPECT_EQ(layout.find("rgb"), std::string::npos);
}

TEST(PageStyle, EveryColourOfAFigureHasItsPartnerInTheDark) {
  const std::string css = page_style();
  const auto expect = [&](std::string_view light, std::string_view dark) {
    for (const std::string property : {"stroke", "fill"}) {
      const std::string rule = "svg [" + property + "=\"" + std::string(light) + "\"]{" + property + ":";
      const std::size_t at = css.find(rule);
      ASSERT_NE(at, std::string::npos) << rule;
      EXPECT_EQ(css.substr(at + rule.size(), 8), std::string(dark) + "}") << rule;
      EXPECT_EQ(css.find(rule, at + 1), std::string::npos) << rule;
      EXPECT_GT(at, css.find("prefers-color-scheme:dark"));
    }
  };
  for (const RoleStyle& role : palette())
    if (role.line != light_surface.text_3) expect(role.line, role.line_dark);
  expect("#FFFFFF", "#171C23");
  expect("#4A5361", "#B7C0CC");
  expect("#626C7A", "#949FAE");
  expect("#7B8594", "#76828F");
  expect(light_surface.grid, dark_surface.grid);
  expect(light_surface.zero_line, dark_surface.zero_line);
}

TEST(PageStyle, HasItsTypography) {
  const std::string css = page_style();
  for (const char* rule :
       {"h1{font-size:34px;line-height:41px;", ".summary p{font-size:17.5px;line-height:28px}",
        "font:16px/25px \"Segoe UI\",-apple-system,Roboto,\"Noto Sans\",Lato,system-ui,sans-serif;",
        "h2{font-size:20px;line-height:27px;", "{font-size:14px;line-height:21px;",
        "ui-monospace,Menlo,Consolas,\"DejaVu Sans Mono\",monospace",
        "font-variant-numeric:tabular-nums lining-nums", "outline:2px solid var(--focus);outline-offset:2px",
        "max-width:908px;margin:0 auto;padding:0 24px", "max-width:640px"})
    EXPECT_THAT(css, HasSubstr(rule));
  for (const auto& weight : matches(css, "font-weight:([0-9]+)"))
    EXPECT_TRUE(weight[1] == "400" || weight[1] == "600" || weight[1] == "700") << weight[0];
}

TEST(PageStyle, WidthsAreWholeAndColumnsEqual) {
  const std::string css = page_style();
  for (const auto& width : matches(css, "width:([0-9]+)%"))
    EXPECT_TRUE(width[1] == "100" || width[1] == "200") << width[0];
  for (const auto& columns : matches(css, "grid-template-columns:([^;}]*)"))
    EXPECT_TRUE(columns[1] == "1fr" || columns[1] == "1fr 1fr") << columns[0];
  EXPECT_THAT(css, HasSubstr(".key>div{flex:1 1 "));
  EXPECT_THAT(css, HasSubstr("grid-column:1/-1"));
}

TEST(PageStyle, TheHintsOfAScrolledTableMirrorEachOther) {
  const std::string css = page_style();
  const auto layers =
      matches(css, "linear-gradient\\((90|270)deg,([^ ]*(?: 40%)?,transparent)\\) ([0-9% ]+)/([^,}]*)");
  ASSERT_EQ(layers.size(), 4u);
  for (std::size_t i = 0; i < 4; i += 2) {
    EXPECT_EQ(layers[i][1], "90");
    EXPECT_EQ(layers[i + 1][1], "270");
    EXPECT_EQ(layers[i][2], layers[i + 1][2]);
    EXPECT_EQ(layers[i][3], "0 0");
    EXPECT_EQ(layers[i + 1][3], "100% 0");
    EXPECT_EQ(layers[i][4], layers[i + 1][4]);
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
