// A report's texts on paper: measured, broken into lines, written as SVG.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/report/enhanced_text.h"
#include "cromer/report/layout.h"
#include "cromer/report/markup.h"

namespace cromer::core {

/// Sizes in px.
struct TextStyle {
  double size = 14, line_height = 20;
  std::string_view colour;  ///< "#RRGGBB"
  Typeface typeface = Typeface::lato;
  bool bold = false;
};

/// A stretch of a line in one style; `shift` moves it to the right, in font sizes.
struct PaperRun {
  TextRun text;
  bool code = false;
  double shift = 0;
};

struct PaperLine {
  std::vector<PaperRun> runs;
  double width = 0;  ///< [px]
};

/// The words of a text, ready to be set in lines.
class PaperText {
 public:
  PaperText(const std::vector<Piece>& pieces, const TextStyle& style);

  /// A line of code as it was typed.
  static PaperText verbatim(const std::string& text, const TextStyle& style);

  double width() const;         ///< in one line [px]
  double longest_word() const;  ///< [px]

  /// Lines of at most `room` [px]; a word that is longer is broken. Empty text has no lines.
  std::vector<PaperLine> lines(double room) const;

 private:
  struct Word {
    std::vector<PaperRun> runs;
    PaperRun blank;  ///< before it
    double width = 0;
  };
  void take(const std::vector<Piece>& pieces, const PaperRun& style);
  void take_words(const std::string& text, const PaperRun& style);
  void take_both(const std::vector<Piece>& parts, const PaperRun& style);
  void add(const std::string& text, const PaperRun& style);
  double measured(const PaperRun& run) const;
  std::vector<Word> broken(const Word& word, double room) const;

  TextStyle style_;
  std::vector<Word> words_;
  PaperRun blank_;
  double shift_ = 0;  // of what comes next
  bool ended_ = true, keeps_together_ = false;
};

/// The line in a box that begins at 0, 0 and is `width` wide.
std::string text_element(const PaperLine& line, const TextStyle& style, Align align, double width);

}  // namespace cromer::core
