// Every command that the documentation shows, run as it stands there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "program.h"
#include "tests/support/markdown.h"

namespace cromer::core::test {
namespace CROMER_FILE {

/// The commands of a shell block, a line each, with their continuations and without comments.
std::vector<std::string> commands_in(const std::string& block) {
  static const std::regex comment("(^|\\s+)#.*");
  std::istringstream lines(block);
  std::vector<std::string> commands;
  bool goes_on = false;
  for (std::string line; std::getline(lines, line);) {
    line = std::regex_replace(line, comment, "");
    line.erase(0, line.find_first_not_of(' '));
    if (line.empty()) continue;
    if (goes_on)
      commands.back() += line;
    else
      commands.push_back(line);
    goes_on = line.ends_with('\\');
    if (goes_on) commands.back().pop_back();
  }
  return commands;
}

void write_swing(const Folder& folder, const std::string& name, const char* mass) {
  folder.run({"simulate", "--mass", mass, "--stiffness", "17", "--damping", "2e-3", "--position", "4 cm",
              "--method", "exact", "--step", "0.01", "--until", "30", "--sensor-noise", "0.3 mm", "-o",
              name});
}

/// Three masses hung on a spring, one after the other, each held for three seconds.
void write_held(const Folder& folder, const std::string& name) {
  std::string rows = "Time (s),Position (m)\n";
  for (int i = 0; i < 900; ++i) {
    const double mass = std::vector{0.0484, 0.06795, 0.08796}[static_cast<std::size_t>(i) / 300];
    rows += std::to_string(0.01 * i) + ',' +
            std::to_string(0.5 - 9.805 * mass / 17 + 2e-4 * std::sin(i * i)) + '\n';
  }
  folder.write(name, rows);
}

/// A body of 0.5 kg on 40 N/m and 0.3 kg/s under a force of three lines, in closed form.
void write_rig(const Folder& folder, const std::string& name) {
  const double mass = 0.5, stiffness = 40, damping = 0.3, rate = damping / (2 * mass);
  const double lines[][3] = {{1, 3, -1.6}, {1, 7.3, 0}, {1, 11, -0.6}};
  std::string rows = "Time (s),Force (N),Position (mm)\n";
  for (int i = 0; i <= 2000; ++i) {
    const double t = 0.02 * i;
    double force = 0,
           x = 0.02 * std::exp(-rate * t) * std::cos(std::sqrt(stiffness / mass - rate * rate) * t);
    for (const auto& [amplitude, w, phase] : lines) {
      const double elastic = stiffness - mass * w * w, viscous = damping * w;
      force += amplitude * std::cos(w * t + phase);
      x += amplitude / std::hypot(elastic, viscous) * std::cos(w * t + phase - std::atan2(viscous, elastic));
    }
    rows += std::to_string(t) + ',' + std::to_string(force) + ',' +
            std::to_string(1e3 * x + 0.1 * std::sin(i * i)) + '\n';
  }
  folder.write(name, rows);
}

/// Both components of two motions, as PEER writes them, in a folder of their own.
void write_records(const Folder& folder, const std::string& name) {
  std::filesystem::create_directory(folder.path(name));
  for (const std::string motion : {"RSN1", "RSN2"})
    for (const std::string component : {"000", "090"}) {
      std::string text = "PEER NGA STRONG MOTION DATABASE RECORD\n" + motion + ", 1/1/2000, station, " +
                         component +
                         "\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS=  1500, DT=   .0100 SEC\n";
      for (int i = 0; i < 1500; ++i)
        text += std::to_string(0.2 * std::sin(0.3 * i + (motion == "RSN1") + i * i * 1e-5) *
                               std::exp(-0.003 * i) * (component == "000" ? 1 : 0.7)) +
                (i % 5 == 4 ? "\n" : " ");
      folder.write(name + "/" + motion + "_" + component + ".AT2", text);
    }
}

/// What a reader has: the recordings and studies of the repository, recordings of his own by the names that
/// the pages give them, and the study that the page shows.
void furnish(const Folder& folder, const std::string& page) {
  for (const char* name : {"data", "studies"})
    std::filesystem::create_directory_symlink(std::string(CROMER_SOURCE_DIR) + "/" + name, folder.path(name));
  write_swing(folder, "swing.csv", "217.6 g");
  write_swing(folder, "one.csv", "100 g");
  write_swing(folder, "two.csv", "150 g");
  write_swing(folder, "three.csv", "200 g");
  write_held(folder, "held.csv");
  write_rig(folder, "rig.csv");
  write_records(folder, "records");
  for (const CodeBlock& block : code_blocks(page))
    if (block.language == "toml") folder.write("study.toml", block.text);
}

/// Options of a command that waits for a device, or for visitors, are looked up; the command is not run.
void expect_known_options(const Folder& folder, const std::vector<std::string>& words) {
  const std::string options = folder.run({"completions", words.at(0)}).out;
  for (const std::string& word : words) {
    const bool known = !word.starts_with("--") || options.find(word + '\t') != std::string::npos;
    EXPECT_TRUE(known) << words[0] << ": " << word;
  }
}

/// A program that is not this one: setting things up, or the repository's own script.
void expect_known_program(const std::vector<std::string>& words, const std::string& command) {
  static const std::set<std::string> known{"./dev", "cmake", "export", "pip", "pipx", "sudo"};
  EXPECT_TRUE(known.contains(words[0])) << "no test knows how to run this: " << command;
  const auto look_up = [&](const char* file, const std::string& what) {
    EXPECT_NE(page_text(file).find(what), std::string::npos) << command;
  };
  if (words[0] == "./dev") look_up("dev", "\n./dev " + words.at(1) + " ");
  for (std::size_t i = 1; words[0] == "cmake" && i < words.size(); ++i)
    if (words[i - 1] == "--preset" || words[i].starts_with("build/"))
      look_up("CMakePresets.json", '"' + std::filesystem::path(words[i]).filename().string() + '"');
}

void expect_works(const Folder& folder, const std::string& command) {
  std::vector<std::string> words = words_of(command);
  // Of a pipe the end, of a launcher what it launches.
  if (const auto pipe = std::find(words.rbegin(), words.rend(), "|"); pipe != words.rend())
    words.erase(words.begin(), pipe.base());
  if (words[0] == "mpirun" || words[0] == "srun")
    words.erase(words.begin(), std::find(words.begin(), words.end(), "cromer"));
  ASSERT_FALSE(words.empty()) << command;
  if (words[0] != "cromer") return expect_known_program(words, command);
  words.erase(words.begin());
  if (words.at(0) == "record" || words.at(0) == "serve") return expect_known_options(folder, words);
  if (words.at(0) == "completions" || words.at(0) == "help") words.resize(2);
  const Finished end = folder.run(words);
  EXPECT_EQ(end.status, 0) << command << "\n" << end.err;
  EXPECT_FALSE(end.out.empty()) << command;
}

class Page : public testing::TestWithParam<std::string> {};

TEST_P(Page, HasCommandsThatWork) {
  const Folder folder;
  furnish(folder, GetParam());
  for (const CodeBlock& block : code_blocks(GetParam()))
    if (block.language == "sh")
      for (const std::string& command : commands_in(block.text)) expect_works(folder, command);
}

TEST_P(Page, HasScriptsThatAShellReads) {
  const Folder folder;
  for (const CodeBlock& block : code_blocks(GetParam()))
    if (block.language == "bash" || block.language == "sh") {
      folder.write("script", block.text);
      EXPECT_EQ(std::system(("bash -n " + folder.path("script")).c_str()), 0)
          << GetParam() << ":" << block.line;
    }
}

std::vector<std::string> pages_with_commands() {
  std::vector<std::string> pages = documentation();
  pages.erase(std::remove_if(pages.begin(), pages.end(),
                             [](const std::string& page) {
                               const auto blocks = code_blocks(page);
                               return std::none_of(blocks.begin(), blocks.end(), [](const CodeBlock& block) {
                                 return block.language == "sh" || block.language == "bash";
                               });
                             }),
              pages.end());
  return pages;
}

INSTANTIATE_TEST_SUITE_P(Docs, Page, testing::ValuesIn(pages_with_commands()), [](const auto& info) {
  std::string name;
  for (const char c : info.param)
    if (std::isalnum(static_cast<unsigned char>(c))) name += c;
  return name;
});

TEST(Docs, NameOnlyOptionsThatExist) {
  const Folder folder;
  std::string options = "--help\t--version\t--man\t--markdown\t";
  std::istringstream commands(folder.run({"completions", "commands"}).out);
  for (std::string line; std::getline(commands, line);)
    options += folder.run({"completions", line.substr(0, line.find('\t'))}).out;
  static const std::regex code("`((cromer |--)[^`\n]*)`"), option("(^| )(--[a-z][a-z0-9-]*)");
  int count = 0;
  for (const std::string& page : documentation()) {
    const std::string text = page_text(page);
    for (std::sregex_iterator each(text.begin(), text.end(), code), end; each != end; ++each) {
      const std::string words = (*each)[1];
      for (std::sregex_iterator one(words.begin(), words.end(), option); one != end; ++one, ++count)
        EXPECT_NE(options.find((*one)[2].str() + '\t'), std::string::npos) << page << ": " << words;
    }
  }
  EXPECT_GT(count, 100);
}

TEST(Docs, TheExampleOfStudiesIsAStudy) {
  const std::string page = page_text("docs/studies.md"), begin = "```toml\n";
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

TEST(Docs, TheStudyBehindThePictureOfTheReadmeIsOne) {
  const Folder folder;
  const Finished end = folder.run({"report", CROMER_SOURCE_DIR "/docs/images/swing.toml", "-o", "out"});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_TRUE(folder.has("out/swing.svg"));
}

TEST(Docs, EveryKeyOfAStudyIsExplained) {
  const std::string source = page_text("src/cromer/study/read_study.cpp"),
                    page = page_text("docs/studies.md");
  const std::regex asked("toml(?:\\.[a-z_]+\\(|, )\"([a-z_]+)\"");
  int keys = 0;
  for (std::sregex_iterator each(source.begin(), source.end(), asked), none; each != none; ++each, ++keys)
    EXPECT_NE(page.find("`" + (*each)[1].str() + "`"), std::string::npos) << (*each)[1];
  EXPECT_GT(keys, 50);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
