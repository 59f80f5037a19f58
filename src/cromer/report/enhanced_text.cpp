#include "cromer/report/enhanced_text.h"

#include <algorithm>
#include <utility>

namespace cromer::core {
namespace {

constexpr double script_size = 0.8, superscript_rise = 0.5, subscript_rise = -0.3;

bool is_script(char c) { return c == '_' || c == '^'; }

std::size_t character_length(std::string_view text) {
  const auto continues = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80; };
  std::size_t length = 1;
  while (length < text.size() && continues(length)) ++length;
  return length;
}

bool same_style(const TextRun& a, const TextRun& b) {
  return a.italic == b.italic && a.bold == b.bold && a.size == b.size && a.rise == b.rise;
}

TextRun script_in(const TextRun& style, char sign) {
  TextRun script = style;
  script.rise += style.size * (sign == '^' ? superscript_rise : subscript_rise);
  script.size *= script_size;
  return script;
}

class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  std::vector<TextRun> read() {
    while (!rest_.empty()) piece();
    return std::move(runs_);
  }

 private:
  void piece() {
    const char c = rest_.front();
    if (is_script(c) && rest_.size() > 1)
      script(c);
    else if (c == '{')
      open(styles_.back());
    else if (c == '}')
      close();
    else
      character(styles_.back());
  }

  void script(char sign) {
    rest_.remove_prefix(1);
    const TextRun style = script_in(styles_.back(), sign);
    if (rest_.front() == '{')
      open(style);
    else
      character(style);
  }

  void open(TextRun style) {
    rest_.remove_prefix(1);
    if (rest_.starts_with('/')) {  // a font's name ends at the blank
      const std::string_view name = rest_.substr(0, rest_.find(' '));
      style.italic = style.italic || name.find(":Italic") != std::string_view::npos;
      style.bold = style.bold || name.find(":Bold") != std::string_view::npos;
      rest_.remove_prefix(std::min(name.size() + 1, rest_.size()));
    }
    styles_.push_back(std::move(style));
  }

  void close() {
    rest_.remove_prefix(1);
    if (styles_.size() > 1) styles_.pop_back();
  }

  void character(const TextRun& style) {
    if (rest_.front() == '\\' && rest_.size() > 1) rest_.remove_prefix(1);
    const std::size_t length = character_length(rest_);
    if (runs_.empty() || !same_style(runs_.back(), style)) runs_.push_back(style);
    runs_.back().text += rest_.substr(0, length);
    rest_.remove_prefix(length);
  }

  std::string_view rest_;
  std::vector<TextRun> styles_{TextRun{}};  // of the open braces; their texts are empty
  std::vector<TextRun> runs_;
};

}  // namespace

std::vector<TextRun> runs_of(std::string_view enhanced) { return Reader(enhanced).read(); }

std::string figure_text(std::string_view plain) {
  std::string out;
  for (const char c : plain) {
    if (std::string_view("\\{}_^").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string without_markup(std::string_view enhanced) {
  std::string out;
  for (const TextRun& run : runs_of(enhanced)) out += run.text;
  for (char& c : out)
    if (c == '\n') c = ' ';
  return out;
}

}  // namespace cromer::core
