#include "cromer/report/paper.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "cromer/report/html_text.h"
#include "cromer/report/librsvg.h"
#include "cromer/report/palette.h"
#include "cromer/report/paper_table.h"
#include "cromer/report/svg_element.h"
#include "cromer/report/table_cells.h"

namespace cromer::core {
namespace {

// [px]
constexpr double column_width = sheet_width - 2 * side_margin,
                 column_height = sheet_height - 2 * upper_margin;
constexpr double half_gap = 20, key_padding = 14, code_padding = 12;
constexpr double least_figure = column_height / 3;  // left to a figure whose caption is long
constexpr double short_table = column_height / 3;   // such a table stands on one sheet
constexpr std::string_view code_ground = "#EEF0F3", key_line = "#DFE3E8";

struct PaperStyles {
  explicit PaperStyles(Typeface face) {
    const double scale = face == Typeface::lato ? 1 : 0.93;
    const SurfaceColours& light = light_surface;
    const auto style = [&](double size, double line, std::string_view colour, bool bold = false) {
      return TextStyle{scale * size, line, colour, face, bold};
    };
    title = style(26.7, 33, light.ink, true);
    byline = style(13, 19, light.text_2);
    summary = style(15.3, 22, light.ink);
    text = style(14, 20, light.ink);
    heading = style(18, 24, light.ink, true);
    caption = style(13, 18.5, light.ink);
    code = style(11.3, 16.5, light.ink);
    key = style(12, 17, light.text_2);
    key_value = style(17.5, 24, light.ink, true);
    foot = style(11.5, 17, light.text_3);
  }
  TextStyle title, byline, summary, text, heading, caption, code, key, key_value, foot;
};

/// Blocks as strips, from the first to the last.
class Strips {
 public:
  explicit Strips(Typeface typeface) : typeface_(typeface), style_(typeface) {}

  std::vector<Strip> of(const Page& page) {
    add(lines(pieces_of(page.title), style_.title, 0));
    add(lines(pieces_of(page.byline), style_.byline, 8));
    paragraphs(page.summary, style_.summary, 16);
    key_figures(page.key_figures);
    for (std::size_t i = 0; i < page.blocks.size(); ++i) {
      const auto* figure = std::get_if<FigureBlock>(&page.blocks[i]);
      const auto* next = i + 1 < page.blocks.size() ? std::get_if<FigureBlock>(&page.blocks[i + 1]) : nullptr;
      if (figure && next && is_half(*figure) && is_half(*next))
        figures({figure, next}), ++i;
      else if (figure)
        figures({figure});
      else
        std::visit([this](const auto& block) { this->block(block); }, page.blocks[i]);
    }
    return std::move(strips_);
  }

 private:
  static bool is_half(const FigureBlock& figure) { return figure.width <= 0.5; }

  static std::vector<Strip> lines(const std::vector<Piece>& pieces, const TextStyle& style, double space) {
    return text_strips({{PaperText(pieces, style), 0, column_width}}, style, space);
  }

  void add(std::vector<Strip> strips) {
    if (strips.empty()) return;
    strips.front().space = std::max(strips.front().space, std::exchange(space_below_, 0.0));
    strips_.insert(strips_.end(), std::make_move_iterator(strips.begin()),
                   std::make_move_iterator(strips.end()));
  }

  void add_with_next(std::vector<Strip> strips) {
    keep_together(strips);
    if (!strips.empty()) strips.back().keeps_next = true;
    add(std::move(strips));
  }

  void paragraphs(const std::string& text, const TextStyle& style, double space) {
    for (const std::string& paragraph : paragraphs_of(text)) {
      add(lines(pieces_of(paragraph), style, space));
      space = 9;
    }
  }

  void key_figures(const std::vector<KeyFigure>& figures) {
    if (figures.empty()) return;
    const std::size_t rows = (figures.size() + 3) / 4, in_a_row = (figures.size() + rows - 1) / rows;
    const double width = column_width / static_cast<double>(in_a_row);
    for (std::size_t from = 0; from < figures.size(); from += in_a_row) {
      const std::size_t end = std::min(from + in_a_row, figures.size());
      const double room = width - 1.5 * key_padding;
      TextStyle value = style_.key_value;  // smaller where one would be broken
      for (std::size_t i = from; i < end; ++i) {
        const double longest = PaperText(pieces_of(figures[i].value), style_.key_value).width();
        value.size = std::min(value.size, std::max(style_.key.size, style_.key_value.size * room / longest));
      }
      const auto texts = [&](std::string KeyFigure::*part, const TextStyle& style) {
        std::vector<TextColumn> columns;
        for (std::size_t i = from; i < end; ++i) {
          const double left = i == from ? 0 : key_padding;
          columns.push_back({PaperText(pieces_of(figures[i].*part), style),
                             width * static_cast<double>(i - from) + left, room});
        }
        return text_strips(columns, style, 0);
      };
      std::vector<Strip> strips = texts(&KeyFigure::name, style_.key);
      for (auto& part : {texts(&KeyFigure::value, value), texts(&KeyFigure::remark, style_.key)})
        strips.insert(strips.end(), part.begin(), part.end());
      rule_key_figures(strips, width, end - from, from == 0);
      keep_together(strips);
      add(std::move(strips));
    }
  }

  static void rule_key_figures(std::vector<Strip>& strips, double width, std::size_t count, bool is_first) {
    constexpr double padding = 9;
    if (strips.empty()) return;
    for (Printed& printed : strips.front().printed) printed.box.y += padding;
    strips.front().height += padding;
    strips.front().space = is_first ? 16 : 0;
    strips.back().height += padding;
    for (Strip& strip : strips)
      for (std::size_t i = 1; i < count; ++i)
        strip.printed.push_back(
            {Printed::Kind::ground,
             {width * static_cast<double>(i), 0, 1, strip.height},
             fmt::format("<rect width=\"1\" height=\"{:.2f}\" fill=\"{}\"/>", strip.height, key_line)});
    strips.front().printed.push_back(print_rule(0, 0, column_width, is_first ? light_surface.ink : key_line));
    strips.back().printed.push_back(print_rule(0, strips.back().height - 1, column_width, key_line));
  }

  void block(const Heading& heading) {
    std::vector<Piece> pieces = pieces_of(heading.text);
    pieces.insert(pieces.begin(), {Piece::Kind::words, std::to_string(++headings_) + "\u2002", {}});
    add_with_next(lines(pieces, style_.heading, 26));
  }

  void block(const Paragraph& paragraph) { paragraphs(paragraph.text, style_.text, 9); }

  void block(const Code& code) {
    if (!code.caption.empty()) add_with_next(lines(pieces_of(code.caption), style_.caption, 12));
    std::string text = code.text;
    while (!text.empty() && text.back() == '\n') text.pop_back();
    std::vector<Strip> strips;
    for (std::size_t i = 0; i <= text.size();) {
      const std::size_t end = std::min(text.find('\n', i), text.size());
      const PaperText line = PaperText::verbatim(text.substr(i, end - i), style_.code);
      std::vector<Strip> set =
          text_strips({{line, code_padding, column_width - 2 * code_padding}}, style_.code, 0);
      if (set.empty()) set.push_back({0, style_.code.line_height, {}});
      strips.insert(strips.end(), set.begin(), set.end());
      i = end + 1;
    }
    ground_code(strips);
    add(std::move(strips));
  }

  static void ground_code(std::vector<Strip>& strips) {
    for (std::size_t i = 0; i < strips.size(); ++i) {
      Strip& strip = strips[i];
      const double above = i == 0 ? code_padding * 0.7 : 0,
                   below = i + 1 == strips.size() ? code_padding * 0.7 : 0;
      for (Printed& printed : strip.printed) printed.box.y += above;
      strip.height += above + below;
      strip.space = i == 0 ? 8 : 0;
      strip.keeps_next = i + 1 < strips.size() && (i == 0 || i + 2 == strips.size());
      strip.printed.insert(strip.printed.begin(),
                           print_rule(0, 0, column_width, code_ground, strip.height + (below > 0 ? 0 : 0.5)));
    }
  }

  void block(const TableBlock& table) {
    add_with_next(lines(captioned(label_of(table, ++tables_), table.caption), style_.caption, 20));
    std::vector<Strip> strips = table_strips(table, typeface_, column_width);
    if (strips.empty()) return;
    strips.front().space = 6;
    double height = 0;
    for (const Strip& strip : strips) height += strip.height;
    if (height <= short_table) keep_together(strips);
    if (strips.size() > 2) strips[strips.size() - 2].keeps_next = true;
    add(std::move(strips));
    space_below_ = 20;
  }

  /// One of the whole width, or halves side by side.
  void figures(const std::vector<const FigureBlock*>& beside) {
    const double width = is_half(*beside.front()) ? (column_width - half_gap) / 2 : column_width;
    std::vector<TextColumn> captions;
    for (const FigureBlock* figure : beside)
      captions.push_back({PaperText(captioned(figure->label, figure->caption), style_.caption),
                          (width + half_gap) * static_cast<double>(captions.size()), width});
    std::vector<Strip> caption = text_strips(captions, style_.caption, 4);
    double caption_height = 4;
    for (const Strip& line : caption) caption_height += line.height;
    Strip strip;
    strip.space = 20;
    const double highest = std::max(column_height - caption_height, least_figure);
    for (std::size_t i = 0; i < beside.size(); ++i) {
      const std::optional<SvgElement> svg = SvgElement::in(beside[i]->svg);
      if (!svg) continue;
      const double shrink = std::min({width / svg->width(), highest / svg->height()});
      const Box box{captions[i].x, 0, svg->width() * shrink, svg->height() * shrink};
      strip.height = std::max(strip.height, box.height);
      strip.printed.push_back({Printed::Kind::figure, box, svg->scaled_to(box.width, box.height)});
    }
    if (!caption.empty()) strip.keeps_next = true;
    keep_together(caption);
    add({strip});
    add(std::move(caption));
    space_below_ = 20;
  }

  void block(const FigureBlock& figure) { figures({&figure}); }

  Typeface typeface_;
  PaperStyles style_;
  std::vector<Strip> strips_;
  double space_below_ = 0;  // the last block's
  int headings_ = 0, tables_ = 0;
};

/// Strips laid below each other; where the next ones that keep together find no room, a sheet begins.
class Stack {
 public:
  /// `spaces`: the strips' spaces are multiplied by this.
  explicit Stack(double spaces = 1) : spaces_(spaces) {}

  std::vector<Sheet> of(const std::vector<Strip>& strips) {
    for (std::size_t i = 0; i < strips.size();) {
      std::size_t end = i + 1;
      double height = strips[i].height;
      for (; end < strips.size() && strips[end - 1].keeps_next; ++end)
        height += spaces_ * strips[end].space + strips[end].height;
      if (!fits(spaces_ * strips[i].space + height)) begin_sheet();
      for (; i < end; ++i) lay(strips[i]);
    }
    return std::move(sheets_);
  }

 private:
  bool fits(double height) const { return y_ + height <= column_height + 1e-6; }

  void begin_sheet() {
    if (y_ == 0) return;
    sheets_.emplace_back();
    y_ = 0;
  }

  void lay(const Strip& strip) {
    if (!fits(spaces_ * strip.space + strip.height)) begin_sheet();
    if (y_ == 0 && strip.header) put(*strip.header);
    if (y_ > 0) y_ += spaces_ * strip.space;
    put(strip);
  }

  void put(const Strip& strip) {
    for (Printed printed : strip.printed) {
      printed.box.x += side_margin;
      printed.box.y += upper_margin + y_;
      sheets_.back().push_back(std::move(printed));
    }
    y_ += strip.height;
  }

  double spaces_ = 1;
  std::vector<Sheet> sheets_{1};
  double y_ = 0;  // below the upper margin
};

/// The sheets with the spaces as they are, or somewhat smaller where that saves one.
std::vector<Sheet> stacked(const std::vector<Strip>& strips) {
  std::vector<Sheet> sheets = Stack().of(strips);
  for (const double spaces : {0.85, 0.7})
    if (std::vector<Sheet> fewer = Stack(spaces).of(strips); fewer.size() < sheets.size()) return fewer;
  return sheets;
}

}  // namespace

std::vector<Sheet> sheets_of(const Page& page, Typeface typeface) {
  std::vector<Sheet> sheets = stacked(Strips(typeface).of(page));
  const TextStyle foot = PaperStyles(typeface).foot;
  constexpr double foot_line = sheet_height - upper_margin + 18, room_for_number = 60;
  double y = foot_line;
  for (const auto& line : PaperText(pieces_of(page.footer), foot).lines(column_width - room_for_number)) {
    sheets.back().push_back(
        print_line(line, foot, Align::left, side_margin, y, column_width - room_for_number));
    y += foot.line_height;
  }
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const PaperText number({{Piece::Kind::words, fmt::format("{} / {}", i + 1, sheets.size()), {}}}, foot);
    sheets[i].push_back(print_line(number.lines(column_width).front(), foot, Align::right, side_margin,
                                   foot_line, column_width));
  }
  return sheets;
}

std::string to_svg(const Sheet& sheet, Typeface typeface, std::string_view language) {
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xml:lang=\"{}\" viewBox=\"0 0 {:.3f} {:.3f}\" "
      "width=\"{:.3f}\" height=\"{:.3f}\" font-family=\"{}\">\n",
      escaped(language), sheet_width, sheet_height, sheet_width, sheet_height, font_family(typeface));
  for (const Printed& printed : sheet)
    fmt::format_to(std::back_inserter(out), "<g transform=\"translate({:.2f} {:.2f})\">{}</g>\n",
                   printed.box.x, printed.box.y, printed.svg);
  return well_formed(out + "</svg>\n");
}

Result<std::string> to_pdf(const Page& page) {
  const Typeface typeface = installed_typeface();
  std::vector<std::string> svgs;
  for (const Sheet& sheet : sheets_of(page, typeface)) svgs.push_back(to_svg(sheet, typeface, page.language));
  const std::vector<std::string_view> views(svgs.begin(), svgs.end());
  return pdf_of_pages(views, sheet_width, sheet_height, well_formed(words_of(pieces_of(page.title))));
}

}  // namespace cromer::core
