// Whole conversations with the program, word for word: tests/cli/transcripts/*.txt. Each has commands
// ("$ cromer ...", "$ packed cromer ..." of JSON documents, and "$ show FILE", "$ words FILE" or "$ picture
// FILE" of what they wrote), what they print (what goes to standard error after "! "), and their exit status
// where it is not 0. Long numbers may differ
// in the last digit from compiler to compiler. Run with CROMER_WRITE_TRANSCRIPTS=1, the test writes what is
// printed now into the files: read the difference before you commit it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"
#include "tests/support/bytes_of.h"

namespace cromer::core::test {
namespace CROMER_FILE {

const std::filesystem::path folder_of_transcripts = std::string(CROMER_SOURCE_DIR) + "/tests/cli/transcripts";

/// What a reader sees of a figure or a page: its texts, a line each, but for date, version and compiler.
std::string words_in(const std::string& markup) {
  static const std::regex hidden("<(style|script)[^>]*>[^]*?</(style|script)>"), tag("<[^>]*>");
  std::istringstream lines(std::regex_replace(std::regex_replace(markup, hidden, ""), tag, "\n"));
  std::string words;
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" \r") != std::string::npos && line.find(" · ") == std::string::npos)
      words += "  " + line + '\n';
  return words;
}

/// The numbers of path data or points, as pairs: how many, and what they span, in whole px.
std::string span_of(const std::string& numbers) {
  std::string plain = std::regex_replace(numbers, std::regex("h0"), "");  // a dot: a line of no length
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return c >= 'A' || c == ','; }, ' ');
  std::istringstream read(plain);
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  int count = 0;
  for (double value = 0; read >> value; ++count) {
    low[count % 2] = std::min(low[count % 2], value);
    high[count % 2] = std::max(high[count % 2], value);
  }
  std::ostringstream text;
  text << count / 2 << " points";
  for (const int axis : {0, 1})
    text << (axis == 0 ? ", " : " x ") << std::lround(low[axis]) << " to " << std::lround(high[axis]);
  return text.str();
}

/// What is drawn in a figure, a line each: with its looks, where it stands, and of a curve what it spans.
std::string picture_in(const std::string& svg) {
  static const std::regex shape("<(path|polygon|rect|circle|image|text) ([^>]*?)/?>([^\n]*)"),
      attribute("([a-z-]+)=\"([^\"]*)\""), tag("<[^>]*>");
  std::string picture;
  for (std::sregex_iterator each(svg.begin(), svg.end(), shape), end; each != end; ++each) {
    const std::string attributes = (*each)[2];
    picture += "  " + (*each)[1].str();
    for (std::sregex_iterator a(attributes.begin(), attributes.end(), attribute); a != end; ++a) {
      const std::string name = (*a)[1], value = (*a)[2];
      const bool many = name == "d" || name == "points", place = name == "x" || name == "y";
      if (name == "href" || name == "style") continue;
      picture += ' ' + (many    ? span_of(value)
                        : place ? std::to_string(std::lround(std::stod(value)))
                                : value);
    }
    if ((*each)[1] == "text") picture += ": " + std::regex_replace((*each)[3].str(), tag, "");
    picture += '\n';
  }
  return picture;
}

/// The JSON document with its innermost lists and objects in one line each, without zeros and without what
/// the machine decides.
std::string packed(const std::string& document) {
  static const std::regex list("\\[[^\\[\\]{}]*\\]"), object("\\{[^{}]*\\}"), blank("\\s+"),
      left_out("\"simd\":\"[^\"]*\",|\"\\w+\": 0\\.0,\\s*");
  std::string text = std::regex_replace(document, left_out, "");
  for (const std::regex& inner : {list, object}) {
    std::string in_lines;
    std::size_t from = 0;
    for (std::sregex_iterator each(text.begin(), text.end(), inner), end; each != end; ++each) {
      const auto at = static_cast<std::size_t>(each->position());
      in_lines += text.substr(from, at - from) + std::regex_replace(each->str(), blank, " ");
      from = at + static_cast<std::size_t>(each->length());
    }
    text = in_lines + text.substr(from);
  }
  return text;
}

std::string printed_by(const Folder& folder, const std::string& line) {
  std::vector<std::string> words = words_of(line);
  if (words.at(0) == "packed") return packed(printed_by(folder, line.substr(words.at(0).size() + 1)));
  if (words.at(0) == "show") return folder.read(words.at(1));
  if (words.at(0) == "words") return words_in(folder.read(words.at(1)));
  if (words.at(0) == "picture") return picture_in(folder.read(words.at(1)));
  EXPECT_EQ(words.at(0), "cromer") << line;
  words.erase(words.begin());
  const Finished end = folder.run(words);
  std::string text = end.out;
  if (!text.empty() && text.back() != '\n') text += '\n';
  std::istringstream errors(end.err);
  for (std::string each; std::getline(errors, each);) text += "! " + each + '\n';
  if (end.status != 0) text += "[" + std::to_string(end.status) + "]\n";
  return text;
}

/// The transcript with what the program prints now.
std::string spoken_again(const std::string& transcript) {
  const Folder folder;
  for (const char* name :
       {"/data/recording1.csv", "/data/recording2.csv", "/data/ground/shaking.csv", "/data/ground/drop.csv",
        "/data/networks/pendulums.toml", "/data/networks/frame.toml", "/data/networks/floors_in_wind.csv"})
    folder.write(std::filesystem::path(name).filename(), bytes_of(CROMER_SOURCE_DIR + std::string(name)));
  for (const auto& file : std::filesystem::directory_iterator(folder_of_transcripts / "files"))
    folder.write(file.path().filename(), bytes_of(file.path()));
  std::istringstream lines(transcript);
  std::string now;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("$ ")) now += line + '\n' + printed_by(folder, line.substr(2));
  return now;
}

/// Seven digits and more to a millionth, or what rounding leaves of nothing; fewer, down to five, to one in
/// the last.
bool same_number(const std::string& one, const std::string& other) {
  if (one == other) return true;
  const auto digits = [](const std::string& number) {
    return std::count_if(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  const auto shorter = std::min(digits(one), digits(other));
  const double a = std::stod(one), b = std::stod(other), size = std::max(std::abs(a), std::abs(b));
  if (shorter >= 7) return std::abs(a - b) <= 1e-6 * size + 1e-13 || size < 1e-12;
  const auto decimals = [](const std::string& number) {
    const std::size_t point = number.find('.');
    return point == std::string::npos ? 0 : static_cast<int>(number.find_last_of("0123456789") - point);
  };
  return shorter >= 5 && one.find('e') == std::string::npos && decimals(one) == decimals(other) &&
         std::abs(a - b) <= 1.01 * std::pow(10, -decimals(one));
}

bool same_line(const std::string& one, const std::string& other) {
  static const std::regex number("-?[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?");
  if (std::regex_replace(one, number, "#") != std::regex_replace(other, number, "#")) return false;
  const std::sregex_iterator end;
  std::sregex_iterator a(one.begin(), one.end(), number), b(other.begin(), other.end(), number);
  for (; a != end && b != end; ++a, ++b)
    if (!same_number(a->str(), b->str())) return false;
  return a == end && b == end;
}

class Transcript : public testing::TestWithParam<std::string> {};

TEST_P(Transcript, IsSpokenAgainWordForWord) {
  const std::filesystem::path path = folder_of_transcripts / (GetParam() + ".txt");
  const std::string then = bytes_of(path), now = spoken_again(then);
  if (std::getenv("CROMER_WRITE_TRANSCRIPTS")) {
    std::ofstream(path) << now;
    return;
  }
  std::istringstream lines_then(then), lines_now(now);
  std::string command, one, other;
  for (int line = 1;; ++line) {
    const bool more = static_cast<bool>(std::getline(lines_then, one)),
               more_now = static_cast<bool>(std::getline(lines_now, other));
    if (!more && !more_now) break;
    if (one.starts_with("$ ")) command = one;
    ASSERT_TRUE(more && more_now && same_line(one, other))
        << path.string() << ":" << line << "\n"
        << command << "\nthen " << one << "\nnow  " << other;
  }
}

std::vector<std::string> names_of_transcripts() {
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(folder_of_transcripts))
    if (file.path().extension() == ".txt") names.push_back(file.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(Of, Transcript, testing::ValuesIn(names_of_transcripts()),
                         [](const auto& each) { return each.param; });

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
