// What inner functions answer to many small inputs, line by line, as it is written down (written_down.h) in
// the folder answers beside the test. Whether it is right is asked elsewhere.
#pragma once

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <random>
#include <sstream>

#include "cromer/notice.h"
#include "tests/support/written_down.h"

namespace cromer::core {

/// Words that are the same, or numbers that are to within one in a million.
inline bool same_answer(const std::string& one, const std::string& other) {
  std::istringstream then(one), now(other);
  for (std::string a, b;;) {
    const bool more = static_cast<bool>(then >> a);
    if (static_cast<bool>(now >> b) != more) return false;
    if (!more) return true;
    if (a == b) continue;
    double x = 0, y = 0;
    const auto is_number = [](const std::string& word, double& value) {
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
      return error == std::errc() && end == word.data() + word.size();
    };
    if (!is_number(a, x) || !is_number(b, y)) return false;
    if (!(std::abs(x - y) <= 1e-6 * std::max(std::abs(x), std::abs(y)) + 1e-12)) return false;
  }
}

class Answers {
 public:
  /// "identify/stops": of tests/identify/answers/stops.txt.
  explicit Answers(const std::filesystem::path& of)
      : file_(std::filesystem::path(CROMER_SOURCE_DIR) / "tests" / of.parent_path() / "answers" /
              (of.filename().string() + ".txt")) {}

  /// A word, a number, or a notice's code with the numbers in it.
  Answers& operator<<(const std::string& word) { return add(word); }
  Answers& operator<<(const char* word) { return add(word); }
  Answers& operator<<(double value) { return add(fmt::format("{:.9g}", value)); }
  Answers& operator<<(int count) { return add(std::to_string(count)); }
  Answers& operator<<(std::size_t count) { return add(std::to_string(count)); }
  Answers& operator<<(bool is) { return add(is ? "yes" : "no"); }
  Answers& operator<<(const Notice& notice) {
    if (notice.empty()) return add("-");
    add(notice.code);
    for (const NoticeValue& each : notice.values) {
      if (const auto* number = std::get_if<double>(&each.value)) *this << *number;
      if (const auto* count = std::get_if<long long>(&each.value)) add(std::to_string(*count));
      if (const auto* inner = std::get_if<std::vector<Notice>>(&each.value)) *this << *inner;
    }
    return *this;
  }
  template <class Each>
  Answers& operator<<(const std::vector<Each>& all) {
    *this << all.size();
    for (const Each& each : all) *this << each;
    return *this;
  }
  void end_line() { text_ += "\n", is_begun_ = false; }

  void expect_as_before() const { test::expect_as_written_down(text_, file_, same_answer); }

 private:
  Answers& add(const std::string& word) {
    if (is_begun_) text_ += ' ';
    text_ += word;
    is_begun_ = true;
    return *this;
  }

  std::filesystem::path file_;
  std::string text_;
  bool is_begun_ = false;
};

/// Numbers from a seed.
class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) / 9007199254740992.0;
  }
  bool is(double probability) { return between(0, 1) < probability; }
  double normal() { return normal_(engine_); }

 private:
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
};

}  // namespace cromer::core
