#include "cromer/report/svg_element.h"

#include <fmt/format.h>

#include <locale>
#include <sstream>

namespace cromer::core {
namespace {

std::string opening(std::string_view name) { return ' ' + std::string(name) + "=\""; }

}  // namespace

std::optional<std::string_view> attribute(std::string_view element, std::string_view name) {
  const std::string begin = opening(name);
  const std::size_t at = element.find(begin);
  if (at == std::string_view::npos || at > element.find('>')) return std::nullopt;
  const std::size_t value = at + begin.size();
  return element.substr(value, element.find('"', value) - value);
}

void set_attribute(std::string& element, std::string_view name, std::string_view value) {
  if (const auto old = attribute(element, name))
    element.replace(static_cast<std::size_t>(old->data() - element.data()), old->size(), value);
  else
    element.insert(std::min(element.find_first_of(" \n/>"), element.size()),
                   opening(name) + std::string(value) + '"');
}

std::optional<SvgElement> SvgElement::in(std::string_view document) {
  const std::size_t start = document.find("<svg");
  if (start == std::string_view::npos) return std::nullopt;
  SvgElement svg;
  svg.element_ = document.substr(start);
  std::istringstream view_box{std::string(attribute(svg.element_, "viewBox").value_or(""))};
  view_box.imbue(std::locale::classic());
  double x = 0, y = 0;
  view_box >> x >> y >> svg.width_ >> svg.height_;
  if (!view_box || svg.width_ <= 0 || svg.height_ <= 0) return std::nullopt;
  return svg;
}

std::string SvgElement::scaled_to(double width, double height) const {
  std::string element = element_;
  set_attribute(element, "width", fmt::format("{:.2f}", width));
  set_attribute(element, "height", fmt::format("{:.2f}", height));
  set_attribute(element, "font-family", "inherit");
  return element;
}

}  // namespace cromer::core
