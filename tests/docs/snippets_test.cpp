// The C++ and C that the documentation shows compiles. A page's snippets of one language stand in one room,
// in their order, as a reader takes them; what the reader has besides is in snippets/.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>

#include "tests/support/markdown.h"

namespace cromer::core::test {
namespace {

struct Compiled {
  std::string file;  ///< of snippets/, which has the line `// here`
  std::string options;
};

const std::map<std::string, Compiled>& languages() {
  static const std::map<std::string, Compiled> all{
      {"cpp", {"reader.cpp", "-std=c++20"}},
      {"c", {"reader.c", "-x c -std=c11"}},
      {"arduino", {"arduino.cpp", "-std=c++20"}},
  };
  return all;
}

/// The snippets with their includes first, in the reader's own file.
std::string whole(const std::string& file, const std::string& snippets) {
  std::istringstream lines(snippets);
  std::string includes, code;
  for (std::string line; std::getline(lines, line);)
    (line.starts_with("#include") ? includes : code) += line + '\n';
  std::string text = page_text("tests/docs/snippets/" + file);
  const std::string place = "// here\n";
  const std::size_t at = text.find(place);
  EXPECT_NE(at, std::string::npos) << file;
  return includes + text.replace(at, place.size(), code);
}

TEST(Snippets, Compile) {
  std::map<std::string, std::map<std::string, std::string>> rooms;  // by page, by language
  for (const std::string& page : documentation())
    for (const CodeBlock& block : code_blocks(page))
      if (languages().contains(block.language)) rooms[page][block.language] += block.text;
  int count = 0;
  for (const auto& [page, by_language] : rooms)
    for (const auto& [language, snippets] : by_language) {
      const Compiled& how = languages().at(language);
      const std::string path = testing::TempDir() + "snippet-" + std::to_string(count++) + "-" + how.file;
      std::ofstream(path) << whole(how.file, snippets);
      const std::string command = std::string(CROMER_COMPILER) + " -fsyntax-only " + how.options + " -I" +
                                  CROMER_SOURCE_DIR + "/include -I" + CROMER_GENERATED + " " + path;
      EXPECT_EQ(std::system(command.c_str()), 0) << page << ", " << language;
    }
  EXPECT_GE(count, 3);
}

}  // namespace
}  // namespace cromer::core::test
