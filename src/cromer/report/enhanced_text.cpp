#include "cromer/report/enhanced_text.h"

#include <algorithm>
#include <array>
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

namespace {

// Advance widths for ' ' to '~', in thousandths of the font size.
using Advances = std::array<short, 95>;
constexpr Advances dejavu_advances{
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
constexpr Advances lato_advances{
    256, 269, 370, 580, 580, 802, 712, 204, 267, 267, 425, 580, 227, 372, 236, 452, 580, 580,  580,
    580, 580, 580, 580, 580, 580, 580, 250, 262, 580, 580, 580, 448, 836, 677, 646, 668, 760,  578,
    566, 730, 764, 280, 422, 662, 514, 928, 764, 800, 600, 800, 626, 542, 590, 736, 677, 1036, 649,
    624, 602, 306, 452, 306, 580, 459, 400, 497, 560, 478, 560, 528, 350, 520, 558, 240, 240,  508,
    236, 822, 558, 567, 560, 560, 364, 433, 358, 558, 516, 786, 498, 516, 452, 301, 250, 301,  580};
constexpr double other_advance = 0.72;  // Greek and signs, on the safe side
constexpr std::string_view no_break_space = "\u00A0";
constexpr double bold_dejavu = 1.13, bold_lato = 1.02;  // against regular

/// Of plain text, in font sizes.
double advances(std::string_view text, Typeface typeface) {
  const Advances& advance = typeface == Typeface::lato ? lato_advances : dejavu_advances;
  double sum = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned char c = static_cast<unsigned char>(text[i]);
    if (c >= ' ' && c <= '~')
      sum += advance[c - ' '] / 1000.0;
    else if ((c & 0xC0) != 0x80)  // once for each character
      sum += text.substr(i).starts_with(no_break_space) ? advance[0] / 1000.0 : other_advance;
  }
  return sum;
}

double relative_width(bool bold, Typeface typeface) {
  if (!bold) return 1;
  return typeface == Typeface::lato ? bold_lato : bold_dejavu;
}

}  // namespace

double text_width(std::string_view text, double size, bool bold, Typeface typeface) {
  double width = 0;
  for (const TextRun& run : runs_of(text))
    width += advances(run.text, typeface) * run.size * relative_width(bold || run.bold, typeface);
  return width * size;
}

std::vector<std::string> wrapped(std::string_view text, double size, bool bold, Typeface typeface,
                                 double room) {
  std::vector<std::string> lines;
  std::string line;
  int braces = 0;
  std::size_t start = 0;
  const auto take_word = [&](std::size_t end, bool last_of_line) {
    const std::string word(text.substr(start, end - start));
    const std::string longer = line.empty() ? word : line + ' ' + word;
    if (!line.empty() && text_width(longer, size, bold, typeface) > room) {
      lines.push_back(line);
      line = word;
    } else {
      line = longer;
    }
    if (last_of_line) {
      lines.push_back(line);
      line.clear();
    }
    start = end + 1;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
      continue;
    }
    if (text[i] == '{') ++braces;
    if (text[i] == '}') braces = std::max(0, braces - 1);
    if (text[i] == '\n') take_word(i, true);
    if (text[i] == ' ' && braces == 0) take_word(i, false);
  }
  take_word(text.size(), true);
  return lines;
}

}  // namespace cromer::core
