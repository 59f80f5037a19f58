#include "cromer/report/page.h"

#include <fmt/format.h>

#include <iterator>

#include "cromer/report/html_text.h"
#include "cromer/report/svg_element.h"
#include "cromer/report/table_cells.h"

namespace cromer::core {
namespace {

template <class... Args>
void add(std::string& out, fmt::format_string<Args...> text, Args&&... args) {
  fmt::format_to(std::back_inserter(out), text, std::forward<Args>(args)...);
}

std::string classes(const TableBlock& table, std::size_t column) {
  const bool words = is_text(table, column), answer = static_cast<int>(column) == table.answer_column;
  if (!words && !answer) return "";
  return fmt::format(" class=\"{}{}{}\"", words ? "words" : "", words && answer ? " " : "",
                     answer ? "answer" : "");
}

class Writer {
 public:
  std::string write(const Page& page) {
    head(page);
    add(out_, "<main id=\"content\">\n");
    if (!page.summary.empty())
      add(out_, "<div class=\"summary\">\n{}</div>\n", paragraphs_html(page.summary));
    key_figures(page.key_figures);
    for (std::size_t i = 0; i < page.blocks.size(); ++i) {
      pair(page.blocks, i);
      std::visit([this](const auto& block) { this->block(block); }, page.blocks[i]);
    }
    if (in_pair_) add(out_, "</div>\n");
    add(out_, "</main>\n");
    if (!page.footer.empty()) add(out_, "<footer><div>{}</div></footer>\n", inline_html(page.footer));
    add(out_, "</body>\n</html>\n");
    return well_formed(std::move(out_));
  }

 private:
  void head(const Page& page) {
    add(out_, "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n",
        escaped(page.language));
    // Nothing runs and nothing is fetched, whatever the data contain.
    add(out_,
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
        "'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'\">\n");
    out_ += mark_of_pages;
    add(out_, "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n",
        plain_words(page.title));
    add(out_, "<link rel=\"icon\" href=\"data:,\">\n<style>\n{}</style>\n</head>\n<body>\n", page_style());
    add(out_, "<a class=\"skip\" href=\"#content\">{}</a>\n<header>\n<h1>{}</h1>\n", escaped(page.skip),
        inline_html(page.title));
    if (!page.byline.empty()) add(out_, "<p class=\"byline\">{}</p>\n", inline_html(page.byline));
    add(out_, "</header>\n");
  }

  void key_figures(const std::vector<KeyFigure>& figures) {
    if (figures.empty()) return;
    add(out_, "<dl class=\"key\">\n");
    for (const KeyFigure& figure : figures) {
      add(out_, "<div><dt>{}</dt><dd class=\"value\">{}</dd>", inline_html(figure.name),
          inline_html(figure.value));
      if (!figure.remark.empty()) add(out_, "<dd class=\"remark\">{}</dd>", inline_html(figure.remark));
      add(out_, "</div>\n");
    }
    add(out_, "</dl>\n");
  }

  static bool is_half(const Block& block) {
    const auto* figure = std::get_if<FigureBlock>(&block);
    return figure && figure->width <= 0.5;
  }

  // Opens and closes the frame in which half-width figures that follow each other stand side by side.
  void pair(const std::vector<Block>& blocks, std::size_t i) {
    const bool half = is_half(blocks[i]);
    if (in_pair_ && !half) add(out_, "</div>\n"), in_pair_ = false;
    if (half && !in_pair_) add(out_, "<div class=\"pair\">\n"), in_pair_ = true;
  }

  void block(const Heading& heading) {
    ++headings_;
    add(out_, "<h2 id=\"section-{0}\"><span class=\"number\">{0}</span> {1}</h2>\n", headings_,
        inline_html(heading.text));
  }

  void block(const Paragraph& paragraph) { out_ += paragraphs_html(paragraph.text); }

  void block(const Code& code) {
    if (!code.caption.empty()) add(out_, "<p class=\"caption\">{}</p>\n", inline_html(code.caption));
    std::string_view text = code.text;
    while (!text.empty() && text.back() == '\n') text.remove_suffix(1);
    add(out_, "<pre tabindex=\"0\"><code>{}</code></pre>\n", escaped(text));
  }

  void block(const TableBlock& table) {
    ++tables_;
    add(out_, "<div class=\"table\">\n<p class=\"caption\" id=\"table-{}\"><strong>{}.</strong> {}</p>\n",
        tables_, inline_html(label_of(table, tables_)), inline_html(table.caption));
    add(out_, "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-labelledby=\"table-{}\"><table>\n",
        tables_);
    if (!table.header.empty()) {
      add(out_, "<thead><tr>");
      for (std::size_t c = 0; c < table.header.size(); ++c)
        add(out_, "<th scope=\"col\"{}>{}</th>", classes(table, c), inline_html(table.header[c]));
      add(out_, "</tr></thead>\n");
    }
    add(out_, "<tbody>\n");
    const std::size_t columns = columns_of(table);
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      add(out_, "<tr>");
      for (std::size_t c = 0; c < columns; ++c) {
        const std::size_t rows = rows_taken(table, r, c);
        if (rows == 0) continue;
        const std::string_view name = c == 0 && is_text(table, 0) ? "th scope=\"row\"" : "td";
        const std::string span = rows > 1 ? fmt::format(" rowspan=\"{}\"", rows) : "";
        add(out_, "<{}{}{}>{}</{}>", name, span, classes(table, c), inline_html(cell(table, r, c)),
            name.substr(0, 2));
      }
      add(out_, "</tr>\n");
    }
    add(out_, "</tbody>\n</table></div>\n</div>\n");
  }

  void block(const FigureBlock& figure) {
    add(out_, "<figure{}{}>\n", figure.id.empty() ? "" : fmt::format(" id=\"{}\"", escaped(figure.id)),
        figure.width > 0.5 ? " class=\"wide\"" : "");
    out_ += with_alternative(figure.svg, figure.alt);
    if (!figure.label.empty() || !figure.caption.empty()) {
      add(out_, "<figcaption>");
      if (!figure.label.empty()) add(out_, "<strong>{}.</strong> ", inline_html(figure.label));
      add(out_, "{}</figcaption>\n", inline_html(figure.caption));
    }
    add(out_, "</figure>\n");
  }

  // The SVG without what only a file needs, named by `alt`.
  static std::string with_alternative(const std::string& svg, const std::string& alt) {
    const std::size_t start = svg.find("<svg");
    if (start == std::string::npos) return "";
    std::string element = svg.substr(start);
    if (alt.empty()) return element;
    const bool is_named = attribute(element, "aria-label").has_value();
    set_attribute(element, "aria-label", plain_words(alt));
    if (!is_named) set_attribute(element, "role", "img");
    return element;
  }

  std::string out_;
  int headings_ = 0, tables_ = 0;
  bool in_pair_ = false;
};

}  // namespace

std::string to_html(const Page& page) { return Writer().write(page); }

}  // namespace cromer::core
