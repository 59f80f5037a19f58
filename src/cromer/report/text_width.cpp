#include "cromer/report/text_width.h"

#include <algorithm>
#include <array>

#include "cromer/report/enhanced_text.h"

namespace cromer::core {
namespace {

// Advance widths of DejaVu Sans for ' ' to '~', in thousandths of the font size.
constexpr std::array<short, 95> advance{
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
constexpr double other_advance = 0.72;  // Greek and signs, on the safe side
constexpr std::string_view no_break_space = "\u00A0";
constexpr double bold_dejavu = 1.13, regular_lato = 0.91, bold_lato = 0.92;  // against DejaVu Sans, regular

/// Of plain text, in font sizes.
double advances(std::string_view text) {
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
  if (typeface == Typeface::lato) return bold ? bold_lato : regular_lato;
  return bold ? bold_dejavu : 1;
}

}  // namespace

double text_width(std::string_view text, double size, bool bold, Typeface typeface) {
  double width = 0;
  for (const TextRun& run : runs_of(text))
    width += advances(run.text) * run.size * relative_width(bold || run.bold, typeface);
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
