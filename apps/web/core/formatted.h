// Formats text as the library fmt does, with much less code.
#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>

namespace cromer::core::page {

class Argument {
 public:
  Argument(std::string_view text) : text_(text) {}
  Argument(const std::string& text) : text_(text) {}
  Argument(const char* text) : text_(text) {}
  Argument(const char& letter) : text_(&letter, 1) {}
  Argument(bool) = delete;
  template <std::integral Whole>
  Argument(Whole value) : kind_(Kind::whole), whole_(static_cast<long long>(value)) {}
  Argument(double value) : kind_(Kind::number), number_(value) {}

  /// `how`: the text between the colon and the closing brace.
  void append_to(std::string& text, std::string_view how, int digits) const;
  int whole() const { return static_cast<int>(whole_); }

 private:
  enum class Kind { text, whole, number };

  Kind kind_ = Kind::text;
  std::string_view text_;
  long long whole_ = 0;
  double number_ = 0;
};

/// Knows {}, {0} and, for numbers, {:.6g}, {:.2f}, {:.0e} and {:.{}g}, which takes its digits from an
/// argument.
std::string formatted(std::string_view text, std::initializer_list<Argument> arguments);

}  // namespace cromer::core::page
