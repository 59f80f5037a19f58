// Every command that the documentation shows, run as it stands there.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "program.h"
#include "tests/support/bytes_of.h"

namespace cromer::core::test {
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

TEST(Docs, EveryCommandOfSweepWorks) { expect_all_work("sweep.md", 6); }

TEST(Docs, EveryCommandOfSpectraWorks) { expect_all_work("spectra.md", 9); }

std::string text_of(const std::string& path) { return bytes_of(std::string(CROMER_SOURCE_DIR) + "/" + path); }

TEST(Docs, TheExampleOfStudiesIsAStudy) {
  const std::string page = text_of("docs/studies.md"), begin = "```toml\n";
  const auto from = page.find(begin) + begin.size();
  const Folder folder;
  std::filesystem::create_directory_symlink(CROMER_SOURCE_DIR "/data", folder.path("data"));
  std::string study = page.substr(from, page.find("```", from) - from);
  folder.write("study.toml", study);
  const Finished end = folder.run({"report", "study.toml", "-o", "out"});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_TRUE(folder.has("out/figure-1.svg"));
  // What the task is to show is no warning, and is said.
  EXPECT_EQ(end.err.find("warning"), std::string::npos) << end.err;
  EXPECT_NE(end.err.find("as this study is meant to show, grows: forward-euler is unstable"),
            std::string::npos)
      << end.err;
  // Else it is one, said once.
  const auto line = study.find("shows = ");
  study.erase(line, study.find('\n', line) - line);
  folder.write("study.toml", study);
  const std::string said = folder.run({"report", "study.toml", "-o", "again"}).err;
  const std::string warning = "warning: grows: forward-euler is unstable";
  ASSERT_NE(said.find(warning), std::string::npos) << said;
  EXPECT_EQ(said.find(warning, said.find(warning) + 1), std::string::npos) << said;
}

TEST(Docs, EveryKeyOfAStudyIsExplained) {
  const std::string source = text_of("src/cromer/study/read_study.cpp"), page = text_of("docs/studies.md");
  const std::regex asked("toml\\.[a-z_]+\\(\"([a-z_]+)\"");
  int keys = 0;
  for (std::sregex_iterator each(source.begin(), source.end(), asked), none; each != none; ++each, ++keys)
    EXPECT_NE(page.find("`" + (*each)[1].str() + "`"), std::string::npos) << (*each)[1];
  EXPECT_GT(keys, 50);
}

}  // namespace
}  // namespace cromer::core::test
