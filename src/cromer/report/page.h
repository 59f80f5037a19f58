// A report as data and as one HTML file that opens offline.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "cromer/result.h"

namespace cromer::core {

/// Texts are Markdown-like in a small way (markup.h): *italic*, **bold**, `code`, x_{0} and x^{2} for sub-
/// and superscript, blank line for a new paragraph. All else is escaped. Headings are numbered by the page.
struct Heading {
  std::string text;
};
struct Paragraph {
  std::string text;
};
struct Code {
  std::string text;
  std::string caption;
};

/// Numbers right-aligned (`text_columns` names those that are words), the answer column bold. In a text
/// column after the first, cells below each other with the same words are one cell. Numbered by the page,
/// "Table 1.", unless `label` says otherwise.
struct TableBlock {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<int> text_columns{0};
  int answer_column = -1;
  std::string label;
};

/// An SVG figure; `width` is the share of the column it may take: 1 or 0.5 (two such that follow each other
/// stand side by side).
struct FigureBlock {
  std::string id;     ///< "figure-01"; also the file's name
  std::string svg;    ///< the bytes of the SVG, from draw()
  std::string alt;    ///< what is seen, for those who cannot; empty: the SVG's own words
  std::string label;  ///< "Figure 1"
  std::string caption;
  double width = 1;
};

using Block = std::variant<Heading, Paragraph, Code, TableBlock, FigureBlock>;

/// The four large figures under the summary: what, value, remark.
struct KeyFigure {
  std::string name, value, remark;
};

struct Page {
  std::string title;
  std::string byline;
  std::string summary;
  std::vector<KeyFigure> key_figures;
  std::vector<Block> blocks;
  std::string footer;  ///< versions
  std::string language = "en";
  std::string skip = "Skip to the content";
};

/// In the head of every page, by which it is known again.
constexpr const char* mark_of_pages = "<meta name=\"generator\" content=\"Cromer\">\n";

/// One HTML document, everything inside it, light and dark, printable.
std::string to_html(const Page& page);

/// The style sheet of a page: light and dark by the reader's choice, paper, narrow screens. The colours of
/// figures follow the palette in the dark.
std::string page_style();

}  // namespace cromer::core
