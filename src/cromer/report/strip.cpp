#include "cromer/report/strip.h"

#include <fmt/format.h>

#include <algorithm>

namespace cromer::core {

Printed print_line(const PaperLine& line, const TextStyle& style, Align align, double x, double y,
                   double width) {
  const double left = align == Align::left ? 0 : (width - line.width) / (align == Align::right ? 1 : 2);
  const Box box{x + left, y, line.width, style.line_height};
  return {Printed::Kind::text, box, text_element(line, style, align, line.width)};
}

Printed print_rule(double x, double y, double width, std::string_view colour, double thickness) {
  return {Printed::Kind::ground,
          {x, y, width, thickness},
          fmt::format("<rect width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>", width, thickness, colour)};
}

std::vector<Strip> text_strips(const std::vector<TextColumn>& columns, const TextStyle& style, double space) {
  std::vector<Strip> strips;
  for (const TextColumn& column : columns) {
    const std::vector<PaperLine> lines = column.text.lines(column.width);
    if (strips.size() < lines.size()) strips.resize(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
      strips[i].printed.push_back(print_line(lines[i], style, Align::left, column.x, 0, column.width));
  }
  for (std::size_t i = 0; i < strips.size(); ++i) {
    strips[i].height = style.line_height;
    strips[i].space = i == 0 ? space : 0;
    strips[i].keeps_next = i + 1 < strips.size() && (i == 0 || i + 2 == strips.size());
  }
  return strips;
}

std::vector<Piece> captioned(const std::string& label, const std::string& caption) {
  std::vector<Piece> pieces = pieces_of(caption);
  if (label.empty()) return pieces;
  pieces.insert(pieces.begin(),
                {{Piece::Kind::bold, "", pieces_of(label + ".")}, {Piece::Kind::words, " ", {}}});
  return pieces;
}

}  // namespace cromer::core
