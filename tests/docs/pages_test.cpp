// Links within the documentation lead somewhere, its code blocks say what they are, its equations are whole.
#include <gtest/gtest.h>

#include <cctype>
#include <regex>
#include <set>
#include <utility>

#include "tests/support/markdown.h"

namespace cromer::core::test {
namespace {

/// As forges make a heading's anchor, and the site does: small letters, no punctuation, hyphens for blanks.
std::string anchor(const std::string& heading) {
  std::string out;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || std::isalnum(byte) || c == '_' || c == '-')
      out += static_cast<char>(std::tolower(byte));
    if (c == ' ') out += '-';
  }
  return out;
}

std::set<std::string> anchors(const std::string& page) {
  std::istringstream lines(page_text(page));
  std::set<std::string> found;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of('#');
    if (begin > 0 && begin < line.size() && line[begin] == ' ') found.insert(anchor(line.substr(begin + 1)));
  }
  return found;
}

TEST(Links, LeadSomewhere) {
  static const std::regex link("\\]\\(([^)\\s]+)\\)");
  int count = 0;
  for (const std::string& page : documentation()) {
    const std::string text = prose(page);
    for (std::sregex_iterator each(text.begin(), text.end(), link), end; each != end; ++each) {
      const std::string target = (*each)[1];
      if (target.starts_with("https://")) continue;
      ++count;
      const std::size_t hash = std::min(target.find('#'), target.size());
      const std::string path = hash == 0
                                   ? page
                                   : (std::filesystem::path(page).parent_path() / target.substr(0, hash))
                                         .lexically_normal()
                                         .string();
      EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(CROMER_SOURCE_DIR) / path))
          << page << ": " << target;
      if (hash < target.size() && path.ends_with(".md")) {
        EXPECT_TRUE(anchors(path).contains(target.substr(hash + 1))) << page << ": " << target;
      }
    }
  }
  EXPECT_GT(count, 50);
}

TEST(Links, AreSeenToBeBroken) {
  EXPECT_EQ(anchor("What gets through: transmissibility"), "what-gets-through-transmissibility");
  EXPECT_TRUE(anchors("docs/identify.md").contains("driven-motions"));
  EXPECT_FALSE(anchors("docs/identify.md").contains("driven-motion"));
}

// What is shown as code is run, compiled, read or drawn by a test, each by its language. What remains is
// `text`.
TEST(CodeBlocks, SayWhatTheyAre) {
  const std::set<std::string> tested{"sh", "bash", "cpp", "c", "arduino", "cmake", "python", "toml", "math"};
  int blocks = 0;
  for (const std::string& page : documentation())
    for (const CodeBlock& block : code_blocks(page)) {
      ++blocks;
      static const std::regex command("(^|\n)(\\./dev|cromer|import|#include) ");
      const bool right = block.language == "text" ? !std::regex_search(block.text, command)
                                                  : tested.contains(block.language);
      EXPECT_TRUE(right) << page << ":" << block.line << ": " << block.language;
    }
  EXPECT_GT(blocks, 50);
}

// Code that is only set in has no language, and no test.
TEST(CodeBlocks, AreFenced) {
  static const std::regex item("\\s*([-*]|[0-9]+\\.) .*");
  for (const std::string& page : documentation()) {
    std::istringstream lines(prose(page));
    bool in_list = false, after_blank = false;
    for (std::string line; std::getline(lines, line);) {
      if (std::regex_match(line, item))
        in_list = true;
      else if (!line.empty() && line[0] != ' ')
        in_list = false;
      EXPECT_FALSE(after_blank && !in_list && line.starts_with("    ")) << page << ": " << line;
      after_blank = line.empty();
    }
  }
}

TEST(Site, HasEveryPageInItsMenu) {
  const std::string menu = page_text("mkdocs.yml");
  for (const std::string& page : documentation())
    if (page.starts_with("docs/")) {
      EXPECT_NE(menu.find(": " + page.substr(5) + '\n'), std::string::npos) << page;
    }
}

int count(const std::string& text, const std::string& what) {
  int found = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size()) ++found;
  return found;
}

// No browser is asked here: what opens must close.
TEST(Equations, AreClosed) {
  static const std::regex in_line("\\$[^$\n]+\\$");
  int equations = 0;
  for (const std::string& page : documentation()) {
    std::vector<std::string> all;
    for (const CodeBlock& block : code_blocks(page))
      if (block.language == "math") all.push_back(block.text);
    const std::string text = prose(page);
    EXPECT_EQ(count(text, "$") % 2, 0) << page;
    for (std::sregex_iterator each(text.begin(), text.end(), in_line), end; each != end; ++each)
      all.push_back(each->str());
    equations += static_cast<int>(all.size());
    for (const std::string& tex : all)
      for (const auto& [opens, closes] : {std::pair{"{", "}"}, {"\\left", "\\right"}, {"\\begin", "\\end"}})
        EXPECT_EQ(count(tex, opens), count(tex, closes)) << page << ": " << tex;
  }
  EXPECT_GT(equations, 100);
}

}  // namespace
}  // namespace cromer::core::test
