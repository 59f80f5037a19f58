// Every command that the documentation shows, run as it stands there.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "program.h"

namespace cromer::test {
namespace {

/// The lines set in by four that begin with "cromer ", with their continuations.
std::vector<std::string> commands_in(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> commands;
  bool goes_on = false;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("    ")) continue;
    line.erase(0, line.find_first_not_of(' '));
    if (goes_on)
      commands.back() += line;
    else if (line.starts_with("cromer "))
      commands.push_back(line);
    else
      continue;
    goes_on = line.ends_with('\\');
    if (goes_on) commands.back().pop_back();
  }
  return commands;
}

/// As a shell would: words between blanks, "quoted" ones whole.
std::vector<std::string> words_of(const std::string& command) {
  std::vector<std::string> words{""};
  bool quoted = false;
  for (const char c : command) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ' ' && !quoted)
      words.emplace_back();
    else
      words.back() += c;
  }
  std::erase(words, "");
  return words;
}

void expect_all_work(const std::string& page, std::size_t at_least) {
  const auto commands = commands_in(std::string(CROMER_SOURCE_DIR) + "/docs/" + page);
  EXPECT_GE(commands.size(), at_least);
  const Folder folder;
  std::filesystem::create_directory_symlink(CROMER_SOURCE_DIR "/data", folder.path("data"));
  for (const auto& command : commands) {
    auto words = words_of(command);
    words.erase(words.begin());
    const Finished end = folder.run(words);
    EXPECT_EQ(end.status, 0) << command << "\n" << end.err;
    EXPECT_FALSE(end.out.empty()) << command;
  }
}

TEST(Docs, EveryCommandOfMethodsWorks) { expect_all_work("methods.md", 8); }

TEST(Docs, EveryCommandOfIdentifyWorks) { expect_all_work("identify.md", 6); }

TEST(Docs, EveryCommandOfSpectraWorks) { expect_all_work("spectra.md", 9); }

}  // namespace
}  // namespace cromer::test
