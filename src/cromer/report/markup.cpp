#include "cromer/report/markup.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>
#include <utility>

#include "cromer/base/ascii.h"
#include "cromer/base/quantity.h"

namespace cromer::core {
namespace {

constexpr std::string_view no_break = "\u00A0";

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }
bool is_letter(char c) { return lower(c) >= 'a' && lower(c) <= 'z'; }
bool is_alnum(char c) { return is_digit(c) || is_letter(c); }

// The place where the run that `mark` opened before text[from] closes; npos if it does not.
std::size_t closing(std::string_view text, std::size_t from, std::string_view mark) {
  if (from >= text.size() || is_blank(text[from])) return std::string_view::npos;
  for (std::size_t i = from; i + mark.size() <= text.size(); ++i) {
    if (text[i] == '`') {  // stars in code do not count
      const std::size_t end = text.find('`', i + 1);
      if (end != std::string_view::npos) i = end;
      continue;
    }
    if (text.substr(i, mark.size()) != mark) continue;
    if (mark == "*" && i + 1 < text.size() && text[i + 1] == '*') {
      ++i;  // a bold mark inside italics
      continue;
    }
    if (i == from || is_blank(text[i - 1])) continue;
    return i;
  }
  return std::string_view::npos;
}

std::size_t closing_brace(std::string_view text, std::size_t from) {
  int depth = 1;
  for (std::size_t i = from; i < text.size(); ++i) {
    if (text[i] == '{') ++depth;
    if (text[i] == '}' && --depth == 0) return i;
  }
  return std::string_view::npos;
}

// A unit or ± after a number stays on the number's line, and a formula on one.
bool keeps_together(std::string_view text, std::size_t blank) {
  if (blank == 0 || blank + 1 >= text.size()) return false;
  const std::string_view before = text.substr(0, blank), after = text.substr(blank + 1);
  for (const std::string_view sign : {"±", "×", "=", "/"})
    if (after.starts_with(sign) || before.ends_with(sign)) return true;
  if (after.starts_with('%')) return true;
  if (!is_digit(text[blank - 1]) && text[blank - 1] != ')') return false;
  std::size_t end = 0;
  while (end < after.size() && !is_blank(after[end])) ++end;
  while (end > 0 && std::string_view(".,;:)").find(after[end - 1]) != std::string_view::npos) --end;
  const std::string_view word = after.substr(0, end);
  for (const std::string_view unit :
       {"m",    "cm",   "mm",   "µm",   "s",    "ms",  "µs",   "min", "kg",    "g",   "mg",  "N",
        "mN",   "N/m",  "J",    "mJ",   "µJ",   "Hz",  "kHz",  "rad", "rad/s", "1/s", "1/m", "m/s",
        "cm/s", "mm/s", "m/s²", "kg/s", "kg/m", "g/s", "N/m³", "°C",  "°",     "V",   "K"}) {
    if (word == unit) return true;
  }
  return false;
}

class MarkupReader {
 public:
  explicit MarkupReader(std::string_view text) : text_(text) {}

  std::vector<Piece> read() {
    while (i_ < text_.size())
      if (!code() && !option() && !number() && !marked() && !scripts()) character();
    return std::move(pieces_);
  }

 private:
  bool code() {
    if (text_[i_] != '`') return false;
    const std::size_t end = text_.find('`', i_ + 1);
    if (end == std::string_view::npos) return false;
    pieces_.push_back({Piece::Kind::code, std::string(text_.substr(i_ + 1, end - i_ - 1)), {}});
    i_ = end + 1;
    return true;
  }

  // Its hyphens are no place to break a line.
  bool option() {
    if (!begins_word() || text_.substr(i_, 2) != "--") return false;
    std::size_t end = i_ + 2;
    while (end < text_.size() && (is_alnum(text_[end]) || text_[end] == '-')) ++end;
    if (end == i_ + 2 || !is_letter(text_[i_ + 2])) return false;
    pieces_.push_back({Piece::Kind::code, std::string(text_.substr(i_, end - i_)), {}});
    i_ = end;
    return true;
  }

  // A minus sign, and a power of ten: -3.5e-05 as −3.5 × 10⁻⁵.
  bool number() {
    const bool negative = text_[i_] == '-';
    const std::size_t first = i_ + (negative ? 1 : 0);
    if (!begins_word() || !is_digit_at(first)) return false;
    std::size_t end = first;
    while (is_digit_at(end) || (end < text_.size() && text_[end] == '.' && is_digit_at(end + 1))) ++end;
    std::string number(text_.substr(first, end - first));
    if (end + 2 < text_.size() && text_[end] == 'e' && (text_[end + 1] == '-' || text_[end + 1] == '+')) {
      int exponent = 0;
      const char* from = text_.data() + end + (text_[end + 1] == '+' ? 2 : 1);
      const auto [next, fault] = std::from_chars(from, text_.data() + text_.size(), exponent);
      if (fault != std::errc()) return false;
      end = static_cast<std::size_t>(next - text_.data());
      number += power_of_ten(exponent);
    } else if (!negative) {
      return false;
    }
    if (end < text_.size() && is_alnum(text_[end])) return false;
    words((negative ? "−" : "") + number);
    i_ = end;
    return true;
  }

  bool is_digit_at(std::size_t i) const { return i < text_.size() && is_digit(text_[i]); }
  bool begins_word() const { return i_ == 0 || is_blank(text_[i_ - 1]) || text_[i_ - 1] == '('; }

  bool marked() {
    if (text_[i_] != '*') return false;
    const bool bold = text_.substr(i_, 2) == "**";
    const std::string_view mark = bold ? "**" : "*";
    const std::size_t from = i_ + mark.size(), end = closing(text_, from, mark);
    if (end == std::string_view::npos) return false;
    pieces_.push_back(
        {bold ? Piece::Kind::bold : Piece::Kind::italic, "", pieces_of(text_.substr(from, end - from))});
    i_ = end + mark.size();
    return true;
  }

  bool scripts() {
    const char sign = text_[i_];
    if (sign != '_' && sign != '^') return false;
    std::optional<Piece> first = script(sign);
    if (!first) return false;
    std::optional<Piece> second = script(sign == '_' ? '^' : '_');
    if (!second) {
      pieces_.push_back(std::move(*first));
      return true;
    }
    if (sign == '_') std::swap(first, second);
    pieces_.push_back({Piece::Kind::both, "", {std::move(*first), std::move(*second)}});
    return true;
  }

  std::optional<Piece> script(char sign) {
    if (i_ + 1 >= text_.size() || text_[i_] != sign || text_[i_ + 1] != '{') return std::nullopt;
    const std::size_t end = closing_brace(text_, i_ + 2);
    if (end == std::string_view::npos) return std::nullopt;
    Piece piece{sign == '_' ? Piece::Kind::below : Piece::Kind::above, "",
                pieces_of(text_.substr(i_ + 2, end - i_ - 2))};
    i_ = end + 1;
    return piece;
  }

  void words(std::string_view more) {
    if (pieces_.empty() || pieces_.back().kind != Piece::Kind::words)
      pieces_.push_back({Piece::Kind::words, "", {}});
    pieces_.back().text += more;
  }

  void character() {
    words(text_[i_] == ' ' && keeps_together(text_, i_) ? no_break : text_.substr(i_, 1));
    ++i_;
  }

  std::string_view text_;
  std::size_t i_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace

std::vector<Piece> pieces_of(std::string_view text) { return MarkupReader(text).read(); }

std::vector<std::string> paragraphs_of(std::string_view text) {
  std::vector<std::string> out;
  std::string paragraph;
  const auto end_paragraph = [&] {
    if (!paragraph.empty()) out.push_back(paragraph);
    paragraph.clear();
  };
  for (std::size_t i = 0; i <= text.size();) {
    const std::size_t end = std::min(text.find('\n', i), text.size());
    std::string_view line = text.substr(i, end - i);
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    if (line.empty())
      end_paragraph();
    else
      (paragraph += paragraph.empty() ? "" : " ") += line;
    i = end + 1;
  }
  end_paragraph();
  return out;
}

std::string words_of(const std::vector<Piece>& pieces) {
  std::string words;
  for (const Piece& piece : pieces) words += piece.text + words_of(piece.parts);
  return words;
}

}  // namespace cromer::core
