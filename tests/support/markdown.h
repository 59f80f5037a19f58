// The documentation as its tests read it: pages, and the code blocks of a page.
#pragma once

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/bytes_of.h"

namespace cromer::core::test {

/// README.md and all pages of docs, as paths from the root of the repository.
inline std::vector<std::string> documentation() {
  std::vector<std::string> pages{"README.md", "CONTRIBUTING.md", "data/README.md"};
  const std::filesystem::path root = CROMER_SOURCE_DIR;
  for (const auto& each : std::filesystem::recursive_directory_iterator(root / "docs"))
    if (each.path().extension() == ".md") pages.push_back(each.path().lexically_relative(root).string());
  std::sort(pages.begin(), pages.end());
  return pages;
}

inline std::string page_text(const std::string& page) {
  return bytes_of(std::string(CROMER_SOURCE_DIR) + "/" + page);
}

/// A page without its code.
inline std::string prose(const std::string& page) {
  std::istringstream lines(page_text(page));
  std::string text;
  bool fenced = false;
  for (std::string line; std::getline(lines, line);) {
    const bool fence =
        line.find("```") != std::string::npos && line.find_first_not_of(' ') == line.find("```");
    fenced ^= fence;
    if (fenced || fence) continue;
    bool code = false;
    for (const char c : line) {
      code ^= c == '`';
      if (!code && c != '`') text += c;
    }
    text += '\n';
  }
  return text;
}

/// A fenced piece of code: what stands after the opening fence, and its lines.
struct CodeBlock {
  std::string language;
  std::string text;
  int line = 0;
};

/// The blocks of a page; they may be set in, as in a list or a tab.
inline std::vector<CodeBlock> code_blocks(const std::string& page) {
  std::istringstream lines(page_text(page));
  std::vector<CodeBlock> blocks;
  bool inside = false;
  std::size_t indent = 0;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
    if (line.compare(begin, 3, "```") == 0) {
      inside = !inside;
      indent = begin;
      if (inside) blocks.push_back({line.substr(begin + 3), "", number});
    } else if (inside) {
      blocks.back().text += line.substr(std::min(begin, indent)) + '\n';
    }
  }
  return blocks;
}

}  // namespace cromer::core::test
