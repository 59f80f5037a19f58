
#include "cromer/base/ascii.h"
#include "cromer/report/enhanced_text.h"
#include "cromer/report/figure.h"
#include "cromer/report/layout.h"
#include "cromer/report/librsvg.h"
#include "cromer/report/svg.h"

namespace cromer::core {
namespace {

constexpr std::string_view readers_fonts = "'Segoe UI', -apple-system, Roboto, 'Noto Sans', Lato, sans-serif";
constexpr double smaller_dejavu = 1;  // [px] off the font size: DejaVu Sans is wider than Lato

std::string alternative_text(const Figure& figure) {
  return without_markup(figure.title.empty() ? figure.id : figure.title);
}

// The reader's font is not known here: texts are measured in the widest.
std::string for_readers(const Figure& figure) {
  return to_svg(lay_out(figure, Typeface::dejavu_sans), alternative_text(figure), readers_fonts);
}

Result<std::string> for_this_machine(const Figure& figure, FigureFormat format) {
  const Typeface typeface = installed_typeface();
  const Layout layout = lay_out(figure, typeface, typeface == Typeface::lato ? 0 : smaller_dejavu);
  const std::string svg = to_svg(layout, alternative_text(figure), font_family(typeface));
  const auto converted = format == FigureFormat::png ? png_of : pdf_of;
  return converted(svg, layout.width, layout.height);
}

}  // namespace

Result<FigureFormat> figure_format(const std::string& path) {
  const std::string name = lower(path);
  const auto ends_with = [&](std::string_view ending) {
    return name.size() > ending.size() && name.ends_with(ending);
  };
  if (ends_with(".svg")) return FigureFormat::svg;
  if (ends_with(".png")) return FigureFormat::png;
  if (ends_with(".pdf")) return FigureFormat::pdf;
  return Error{"names_no_figure", {{"path", path}}};
}

Result<std::string> draw(const Figure& figure, FigureFormat format) {
  if (format == FigureFormat::svg) return for_readers(figure);
  return for_this_machine(figure, format);
}

}  // namespace cromer::core
