// The <svg> element of a figure's file, made ready to stand in another document.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cromer::core {

/// An attribute of the start tag that `element` begins with.
std::optional<std::string_view> attribute(std::string_view element, std::string_view name);

/// `value` is escaped already.
void set_attribute(std::string& element, std::string_view name, std::string_view value);

/// A figure of a known size.
class SvgElement {
 public:
  /// None where the document has no <svg> with a viewBox.
  static std::optional<SvgElement> in(std::string_view document);

  double width() const { return width_; }
  double height() const { return height_; }

  /// So large, in the font of what is around it.
  std::string scaled_to(double width, double height) const;

 private:
  std::string element_;
  double width_ = 0, height_ = 0;
};

}  // namespace cromer::core
