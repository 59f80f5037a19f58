#include "cromer/report/text_width.h"

#include <algorithm>
#include <array>

namespace cromer {
namespace {

// Advance widths of DejaVu Sans for ' ' to '~', in thousandths of the font size.
constexpr std::array<short, 95> advance{
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
constexpr double other_advance = 0.72;  // Greek and signs, on the safe side
constexpr double small_script = 0.8;    // gnuplot's size of sub- and superscripts
constexpr double bold_dejavu = 1.13, regular_lato = 0.91, bold_lato = 0.92;  // against DejaVu Sans, regular

// One character or piece of markup at text[i]: calls draw(bytes, script depth) for what is seen, returns the
// next index.
template <class Draw>
void scan(std::string_view text, Draw draw) {
  int depth = 0;
  std::vector<bool> script;  // for each open brace: whether it opened a sub- or superscript
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '\\' && i + 1 < text.size()) {
      draw(text.substr(i + 1, 1), depth);
      i += 2;
    } else if ((c == '_' || c == '^') && i + 1 < text.size()) {
      if (text[i + 1] == '{') {
        script.push_back(true);
        ++depth;
        i += 2;
      } else {
        draw(text.substr(i + 1, 1), depth + 1);
        i += 2;
      }
    } else if (c == '{') {
      script.push_back(false);
      ++i;
      if (i < text.size() &&
          text[i] == '/') {  // {/:Bold …}, {/Symbol …}, {/*1.2 …}: the name ends at the blank
        const std::size_t blank = text.find(' ', i);
        i = blank == std::string_view::npos ? text.size() : blank + 1;
      }
    } else if (c == '}') {
      if (!script.empty()) {
        depth -= script.back();
        script.pop_back();
      }
      ++i;
    } else {
      std::size_t length = 1;
      while (i + length < text.size() && (static_cast<unsigned char>(text[i + length]) & 0xC0) == 0x80)
        ++length;
      draw(text.substr(i, length), depth);
      i += length;
    }
  }
}

double relative_width(bool bold, Typeface typeface) {
  if (typeface == Typeface::lato) return bold ? bold_lato : regular_lato;
  return bold ? bold_dejavu : 1;
}

}  // namespace

double text_width(std::string_view text, double size, bool bold, Typeface typeface) {
  double width = 0;
  scan(text, [&](std::string_view bytes, int depth) {
    const unsigned char c = static_cast<unsigned char>(bytes.front());
    const double own = c >= ' ' && c <= '~' ? advance[c - ' '] / 1000.0
                       : bytes == "\u00A0"  ? 0.318
                                            : other_advance;
    width += depth > 0 ? own * small_script : own;
  });
  return width * size * relative_width(bold, typeface);
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
    if (text[i] == '{') ++braces;
    if (text[i] == '}') braces = std::max(0, braces - 1);
    if (text[i] == '\n') take_word(i, true);
    if (text[i] == ' ' && braces == 0) take_word(i, false);
  }
  take_word(text.size(), true);
  return lines;
}

std::string figure_text(std::string_view plain) {
  std::string out;
  for (const char c : plain) {
    if (std::string_view("\\{}_^@&~").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string without_markup(std::string_view text) {
  std::string out;
  scan(text, [&](std::string_view bytes, int) { out += bytes == "\n" ? " " : bytes; });
  return out;
}

}  // namespace cromer
