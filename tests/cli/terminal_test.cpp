// Names from files and from the command line drive no terminal, and what is printed is UTF-8.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/base/utf8.h"
#include "program.h"

namespace cromer::core::test {
namespace {

using ::testing::HasSubstr;

const std::string hostile =
    "x\x1b]0;owned\a\xC2\x9B"
    "31m\xE2\x80\xAE";

void expect_harmless(const std::string& text) {
  EXPECT_TRUE(is_utf8(text)) << text;
  EXPECT_EQ(text, printable(text));
}

void expect_harmless(const Finished& end) {
  expect_harmless(end.out);
  expect_harmless(end.err);
}

TEST(Terminal, IsNotDrivenByTheNameOfAColumn) {
  const Folder folder;
  std::string text = recording(2000);
  text.replace(text.find("Position"), 8, hostile);
  folder.write("lab.csv", text);
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"inspect", "lab.csv"},
                                             {"inspect", "lab.csv", "--json"},
                                             {"inspect", "lab.csv", "-o", "-"},
                                             {"fit", "lab.csv"},
                                             {"fit", "lab.csv", "--json"},
                                             {"fit", "lab.csv", "-o", "-"},
                                             {"fit", "lab.csv", "--column", "absent"},
                                             {"fit", "lab.csv", "--plot", "fit.svg"},
                                             {"compare", "lab.csv"}}) {
    const Finished end = folder.run(command);
    expect_harmless(end);
  }
  const Finished shown = folder.run({"inspect", "lab.csv"});
  EXPECT_THAT(shown.out, HasSubstr("x\\x1b]0;owned\\x07\\x9b31m\\u202e"));
  const auto json = folder.run({"fit", "lab.csv", "--json"}).json();
  EXPECT_THAT(json["recording"]["column"].get<std::string>(), HasSubstr("\xC2\x9B"
                                                                        "31m"))
      << "JSON keeps the name";
}

TEST(Terminal, IsNotDrivenByWhatIsTyped) {
  const Folder folder;
  folder.write(hostile + ".csv", recording(300));
  folder.write("broken \xff.csv", recording(300));
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{hostile},
                                             {"\xff\xfe"},
                                             {"fit", "--" + hostile},
                                             {"fit", hostile},
                                             {"fit", hostile + ".csv", "--law", hostile},
                                             {"fit", "broken \xff.csv"},
                                             {"fit", "broken \xff.csv", "--json"},
                                             {"fit", "broken \xff.csv", "-o", "-"},
                                             {"inspect", "broken \xff.csv"},
                                             {"simulate", "--method", hostile},
                                             {"simulate", "--mass", "\xff"},
                                             {"simulate", "-o", hostile + "/x.csv"},
                                             {"report", "absent \xff.toml", "-o", "out"},
                                             {"serve", "--from", hostile},
                                             {"spectrum", hostile}}) {
    const Finished end = folder.run(command);
    expect_harmless(end);
  }
}

}  // namespace
}  // namespace cromer::core::test
