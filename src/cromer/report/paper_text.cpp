#include "cromer/report/paper_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cromer/report/html_text.h"

namespace cromer::core {
namespace {

// In font sizes.
constexpr double code_size = 0.86, code_advance = 0.602;  // of DejaVu Sans Mono
constexpr double small_size = 0.72, small_above = 0.36, small_below = -0.18;
constexpr double stacked_size = 0.66, stacked_above = 0.42, stacked_below = -0.26;
constexpr double paper_baseline = 0.345;  // below the middle of the line

constexpr std::string_view unbreakable = "\u00A0";

bool is_inside_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

PaperRun scripted(PaperRun style, double size, double rise) {
  style.text.rise += rise * style.text.size;
  style.text.size *= size;
  return style;
}

bool has_style_of(const PaperRun& a, const PaperRun& b) {
  return b.shift == 0 && a.code == b.code && a.text.italic == b.text.italic && a.text.bold == b.text.bold &&
         a.text.size == b.text.size && a.text.rise == b.text.rise;
}

void add_run(std::vector<PaperRun>& runs, const PaperRun& run) {
  if (!runs.empty() && has_style_of(runs.back(), run))
    runs.back().text.text += run.text.text;
  else
    runs.push_back(run);
}

}  // namespace

PaperText::PaperText(const std::vector<Piece>& pieces, const TextStyle& style) : style_(style) {
  take(pieces, {});
}

PaperText PaperText::verbatim(const std::string& text, const TextStyle& style) {
  PaperText made({}, style);
  PaperRun code;
  code.code = true;
  if (!text.empty()) made.add(text, code);
  return made;
}

void PaperText::take(const std::vector<Piece>& pieces, const PaperRun& style) {
  using Kind = Piece::Kind;
  for (const Piece& piece : pieces) {
    PaperRun inner = style;
    switch (piece.kind) {
      case Kind::code:
        inner.code = true;
        inner.text.size *= code_size;
        [[fallthrough]];
      case Kind::words:
        take_words(piece.text, inner);
        continue;
      case Kind::both:
        take_both(piece.parts, style);
        continue;
      case Kind::italic:
        inner.text.italic = true;
        break;
      case Kind::bold:
        inner.text.bold = true;
        break;
      case Kind::above:
        inner = scripted(style, small_size, small_above);
        break;
      case Kind::below:
        inner = scripted(style, small_size, small_below);
        break;
    }
    take(piece.parts, inner);
  }
}

/// The narrower is written first, the wider goes back to where that began.
void PaperText::take_both(const std::vector<Piece>& parts, const PaperRun& style) {
  const bool kept = std::exchange(keeps_together_, true);
  const auto width_of = [&](const std::vector<Piece>& pieces, const PaperRun& script) {
    PaperText alone({}, style_);
    alone.take(pieces, script);
    return alone.width();
  };
  const std::vector<Piece>&above = parts.front().parts, &below = parts.back().parts;
  const PaperRun high = scripted(style, stacked_size, stacked_above);
  const PaperRun low = scripted(style, stacked_size, stacked_below);
  const double above_width = width_of(above, high), below_width = width_of(below, low);
  const bool below_first = below_width < above_width;
  take(below_first ? below : above, below_first ? low : high);
  shift_ = -std::min(above_width, below_width) / style_.size;
  take(below_first ? above : below, below_first ? high : low);
  keeps_together_ = kept;
}

void PaperText::take_words(const std::string& text, const PaperRun& style) {
  for (std::size_t i = 0; i < text.size();) {
    const bool is_blank = std::string_view(" \t\r\n").find(text[i]) != std::string_view::npos;
    if (is_blank && keeps_together_) {
      add(std::string(unbreakable), style);
      ++i;
    } else if (is_blank) {
      if (!ended_) blank_ = style;
      ended_ = true;
      ++i;
    } else {
      const std::size_t end = std::min(text.find_first_of(" \t\r\n", i), text.size());
      add(text.substr(i, end - i), style);
      i = end;
    }
  }
}

void PaperText::add(const std::string& text, const PaperRun& style) {
  if (ended_) {
    blank_.text.text = " ";
    words_.push_back({{}, blank_, 0});
  }
  ended_ = false;
  PaperRun run = style;
  run.text.text = text;
  run.shift = std::exchange(shift_, 0.0);
  words_.back().width += measured(run);
  add_run(words_.back().runs, run);
}

double PaperText::measured(const PaperRun& run) const {
  double width = run.shift;
  if (run.code)
    width += code_advance * run.text.size *
             static_cast<double>(std::count_if(run.text.text.begin(), run.text.text.end(),
                                               [](char c) { return !is_inside_character(c); }));
  else
    width +=
        text_width(figure_text(run.text.text), run.text.size, style_.bold || run.text.bold, style_.typeface);
  return width * style_.size;
}

double PaperText::width() const {
  double sum = 0;
  for (std::size_t i = 0; i < words_.size(); ++i)
    sum += words_[i].width + (i > 0 ? measured(words_[i].blank) : 0);
  return sum;
}

double PaperText::longest_word() const {
  double longest = 0;
  for (const Word& word : words_) longest = std::max(longest, word.width);
  return longest;
}

/// Pieces of a word that is wider than the room, broken behind a blank, slash, hyphen or underscore near the
/// end if there is one.
std::vector<PaperText::Word> PaperText::broken(const Word& word, double room) const {
  std::vector<Word> pieces{{{}, word.blank, 0}};
  const auto end_piece = [&] {
    Word& full = pieces.back();
    PaperRun rest = full.runs.back();
    std::string& text = full.runs.back().text.text;
    const std::size_t at = text.find_last_of(" /-_") + 1;  // 0 where there is none
    Word next;
    if (at > text.size() / 2 && at < text.size()) {
      rest.text.text = text.substr(at);
      rest.shift = 0;
      text.resize(at);
      next.width = measured(rest);
      full.width -= next.width;
      next.runs.push_back(std::move(rest));
    }
    pieces.push_back(std::move(next));
  };
  for (const PaperRun& run : word.runs)
    for (std::size_t i = 0; i < run.text.text.size();) {
      std::size_t end = i + 1;
      while (end < run.text.text.size() && is_inside_character(run.text.text[end])) ++end;
      PaperRun letter = run;
      letter.text.text = run.text.text.substr(i, end - i);
      if (i > 0) letter.shift = 0;
      if (!pieces.back().runs.empty() && pieces.back().width + measured(letter) > room) end_piece();
      if (pieces.back().runs.empty()) letter.shift = 0;
      pieces.back().width += measured(letter);
      add_run(pieces.back().runs, letter);
      i = end;
    }
  return pieces;
}

std::vector<PaperLine> PaperText::lines(double room) const {
  std::vector<PaperLine> lines;
  const auto begin = [&](const Word& word) { lines.push_back({word.runs, word.width}); };
  for (const Word& word : words_) {
    const double blank = measured(word.blank);
    if (!lines.empty() && lines.back().width + blank + word.width <= room) {
      add_run(lines.back().runs, word.blank);
      for (const PaperRun& run : word.runs) add_run(lines.back().runs, run);
      lines.back().width += blank + word.width;
    } else if (word.width <= room) {
      begin(word);
    } else {
      for (const Word& piece : broken(word, room)) begin(piece);
    }
  }
  return lines;
}

std::string text_element(const PaperLine& line, const TextStyle& style, Align align, double width) {
  const double x = align == Align::left ? 0 : align == Align::right ? width : width / 2;
  std::string out = fmt::format(
      "<text xml:space=\"preserve\" x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.2f}\" fill=\"{}\"{}{}>", x,
      style.line_height / 2 + paper_baseline * style.size, style.size, style.colour,
      style.bold ? " font-weight=\"bold\"" : "",
      align == Align::left    ? ""
      : align == Align::right ? " text-anchor=\"end\""
                              : " text-anchor=\"middle\"");
  double rise = 0;
  for (const PaperRun& run : line.runs) {
    std::string look;
    if (run.code) look += " font-family=\"'DejaVu Sans Mono', monospace\"";
    if (run.text.italic) look += " font-style=\"italic\"";
    if (run.text.bold) look += " font-weight=\"bold\"";
    if (run.text.size != 1) look += fmt::format(" font-size=\"{:.2f}\"", run.text.size * style.size);
    if (run.text.rise != rise) look += fmt::format(" dy=\"{:.2f}\"", (rise - run.text.rise) * style.size);
    if (run.shift != 0) look += fmt::format(" dx=\"{:.2f}\"", run.shift * style.size);
    rise = run.text.rise;
    const std::string words = escaped(run.text.text);
    out += look.empty() ? words : "<tspan" + look + '>' + words + "</tspan>";
  }
  return out + "</text>";
}

}  // namespace cromer::core
