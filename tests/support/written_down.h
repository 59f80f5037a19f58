// Drawings and numbers written down: tests compare what there is now with a file in the tree. Run with
// CROMER_WRITE_TRANSCRIPTS=1, they write what there is now into the file: look at the picture and at the
// difference before you commit it.
#pragma once

#include <fmt/format.h>
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

#include "tests/support/bytes_of.h"

namespace cromer::core::test {

/// The numbers of path data or points: all of a short list; of a long one how many points there are, the
/// first, the last and their mean.
inline std::string in_short(const std::string& numbers) {
  std::string plain = std::regex_replace(numbers, std::regex("h0"), "");  // a dot: a line of no length
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return c >= 'A' || c == ','; }, ' ');
  std::istringstream read(plain);
  std::vector<double> all;
  for (double value = 0; read >> value;) all.push_back(value);
  if (all.size() <= 48) return numbers;
  double mean[2] = {0, 0};
  for (std::size_t i = 0; i < all.size(); ++i) mean[i % 2] += all[i] / static_cast<double>(all.size() / 2);
  std::ostringstream text;
  text << all.size() / 2 << " points, " << all[0] << ' ' << all[1] << " to " << all[all.size() - 2] << ' '
       << all.back() << " about " << std::round(100 * mean[0]) / 100 << ' '
       << std::round(100 * mean[1]) / 100;
  return text.str();
}

/// The SVG with its long lists of numbers in short, and without the bytes of its images.
inline std::string drawing_in(const std::string& svg) {
  static const std::regex list(" (d|points|href)=\"([^\"]*)\"");
  std::string drawing;
  std::sregex_iterator each(svg.begin(), svg.end(), list), end;
  std::size_t from = 0;
  for (; each != end; ++each) {
    const auto at = static_cast<std::size_t>(each->position());
    drawing += svg.substr(from, at - from) + ' ' + (*each)[1].str() + "=\"" +
               ((*each)[1] == "href" ? "" : in_short((*each)[2])) + '"';
    from = at + static_cast<std::size_t>(each->length());
  }
  return drawing + svg.substr(from);
}

/// Whole numbers are the same, others to within 0.02: compilers round their last digit differently.
inline bool same_drawing(const std::string& one, const std::string& other) {
  static const std::regex number("-?[0-9]+(\\.[0-9]+)?");
  if (std::regex_replace(one, number, "#") != std::regex_replace(other, number, "#")) return false;
  std::sregex_iterator a(one.begin(), one.end(), number), b(other.begin(), other.end(), number), end;
  for (; a != end && b != end; ++a, ++b) {
    const bool whole = !(*a)[1].matched && !(*b)[1].matched;
    if (whole ? a->str() != b->str() : std::abs(std::stod(a->str()) - std::stod(b->str())) > 0.0201)
      return false;
  }
  return a == b;
}

/// Four digits before the point: compared to 0.02, that is a few millionths.
inline std::string as_written(double value) {
  if (!std::isfinite(value) || std::abs(value) < 1e-9) return fmt::format("{:.0f}", std::abs(value));
  const std::string digits = fmt::format("{:.7e}", value);
  const std::size_t e = digits.find('e');
  return fmt::format("{:.4f}e{}", 1000 * std::stod(digits.substr(0, e)), std::stoi(digits.substr(e + 1)) - 3);
}

inline std::string as_written(const std::vector<double>& values) {
  std::string text = fmt::format("{}:", values.size());
  if (values.size() <= 12) {
    for (const double each : values) text += ' ' + as_written(each);
    return text;
  }
  double squares = 0;
  for (const double each : values)
    if (std::isfinite(each)) squares += each * each;
  return fmt::format("{} {} to {}, {}", text, as_written(values.front()), as_written(values.back()),
                     as_written(std::sqrt(squares / static_cast<double>(values.size()))));
}

/// `same` says whether two lines are.
template <class Same = decltype(same_drawing)>
void expect_as_written_down(const std::string& drawn, const std::filesystem::path& file,
                            const Same& same = same_drawing) {
  if (std::getenv("CROMER_WRITE_TRANSCRIPTS")) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << drawn;
    return;
  }
  std::istringstream now(drawn), then(bytes_of(file));
  int number = 0, wrong = 0;
  for (std::string a, b;;) {
    const bool more = static_cast<bool>(std::getline(now, a)),
               wanted = static_cast<bool>(std::getline(then, b));
    if (!more && !wanted) return;
    ++number;
    if (more == wanted && (a == b || same(a, b))) continue;
    ADD_FAILURE() << file.filename() << ", line " << number << "\n  was " << (wanted ? b : "nothing")
                  << "\n  is  " << (more ? a : "nothing");
    if (++wrong == 5 || more != wanted) return;
  }
}

}  // namespace cromer::core::test
