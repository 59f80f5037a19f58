#include "cromer/study/study_writer.h"

#include <fmt/format.h>

#include <algorithm>

#include "cromer/base/ascii.h"
#include "cromer/base/quantity.h"

namespace cromer::core {

std::string toml_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      (out += '\\') += c;
    else if (c == '\n')
      out += "\\n";
    else if (code < 0x20 || code == 0x7f)
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(code));
    else
      out += c;
  }
  return out + '"';
}

std::string verbatim(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool markup = !out.empty() && (out.back() == '_' || out.back() == '^');
    out += std::string(c == '{' && !markup ? 2 : 1, c);
  }
  return out;
}

std::string toml_settings(const std::vector<TypedOption>& options) {
  std::string lines;
  std::vector<std::string_view> written;
  for (const auto& [name, value] : options) {
    if (std::find(written.begin(), written.end(), name) != written.end()) continue;
    written.push_back(name);
    std::string values;
    int count = 0;
    for (const auto& [other, each] : options)
      if (other == name) values += (count++ ? ", " : "") + toml_text(verbatim(each));
    lines += with_underscores(name) + " = " + (count > 1 ? "[" + values + "]" : values) + '\n';
  }
  return lines;
}

void StudyWriter::table(std::string_view name) { out_ += fmt::format("\n[[{}]]\n", name); }

void StudyWriter::text(std::string_view key, std::string_view value) {
  if (!value.empty()) out_ += fmt::format("{} = {}\n", key, toml_text(value));
}

void StudyWriter::bare(std::string_view key, std::string_view value) {
  out_ += fmt::format("{} = {}\n", key, value);
}

void StudyWriter::heading(std::string_view text) {
  table("block");
  this->text("heading", text);
}

void StudyWriter::paragraph(std::string_view text) {
  table("block");
  this->text("text", text);
}

void StudyWriter::key_figure(std::string_view name, std::string_view value, std::string_view remark) {
  table("key_figure");
  text("name", name);
  text("value", value);
  text("remark", remark);
}

void StudyWriter::figure(const FigureLines& figure) {
  table("figure");
  text("id", figure.id);
  text("title", figure.title);
  text("caption", figure.caption);
  text("size", figure.size);
  if (figure.size != "wide") bare("width", "0.5");
  text("x", figure.x);
  text("y", figure.y);
  text("x_name", figure.x_name);
  text("y_name", figure.y_name);
  text("x_unit", figure.x_unit);
  text("y_unit", figure.y_unit);
  if (figure.x_from_zero) bare("x_low", "0");
  if (figure.y_from_zero) bare("y_low", "0");
  if (figure.x_logarithmic) bare("x_logarithmic", "true");
  for (const CurveLines& curve : figure.curves) this->curve(curve);
  table("block");
  text("figure", figure.id);
}

void StudyWriter::curve(const CurveLines& curve) {
  table("figure.curve");
  text("of", curve.of);
  text("minus", curve.minus);
  text("x", curve.x);
  text("y", curve.y);
  text("role", curve.role);
  text("name", curve.name);
  if (curve.to) bare("to", shortest(*curve.to));
  if (curve.dots) text("mark", "dots");
  if (curve.dashed) bare("dashed", "true");
}

}  // namespace cromer::core
