// Writes a study file: its texts, options, tables and figures.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/tasks/option/option.h"

namespace cromer::core {

/// A text in quotes, as TOML has it.
std::string toml_text(std::string_view text);

/// A text that stands for itself: in a study a brace begins a result, but for that of x_{1} and x^{2}.
std::string verbatim(std::string_view text);

/// A line for each option, once with all its values: mass = "217.6 g".
std::string toml_settings(const std::vector<TypedOption>& options);

/// [[figure.curve]], as write_report.h reads it; what is empty is left out.
struct CurveLines {
  std::string_view of, role;
  std::string name{};
  std::string_view x{}, y{}, minus{};
  std::optional<double> to{};  // [s]
  bool dots = false, dashed = false;
};

/// [[figure]] and the [[block]] that shows it.
struct FigureLines {
  std::string_view id;
  std::string title, caption;
  std::string_view size{}, x{}, y{};  ///< all sizes but "wide" take half the page's width
  std::string x_name{}, y_name{};
  std::string x_unit{}, y_unit{};
  bool x_from_zero = false, y_from_zero = false, x_logarithmic = false;
  std::vector<CurveLines> curves{};
};

/// Puts one table after the other.
class StudyWriter {
 public:
  void table(std::string_view name);                        ///< begins [[name]]
  void text(std::string_view key, std::string_view value);  ///< nothing for an empty one
  void bare(std::string_view key, std::string_view value);  ///< a number, a list, true
  void raw(std::string_view lines) { out_ += lines; }
  void heading(std::string_view text);
  void paragraph(std::string_view text);
  void key_figure(std::string_view name, std::string_view value, std::string_view remark);
  void figure(const FigureLines& figure);
  const std::string& written() const { return out_; }

 private:
  void curve(const CurveLines& curve);

  std::string out_;
};

}  // namespace cromer::core
