#include "cromer/study/fit_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "cromer/base/ascii.h"
#include "cromer/tasks/fit/fitted_quantities.h"

namespace cromer::core {
namespace {

/// A text as TOML has it.
std::string toml_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      (out += '\\') += c;
    else if (code < 0x20 || code == 0x7f)
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(code));
    else
      out += c;
  }
  return out + '"';
}

/// A value that stands for itself: in a study a brace begins a result.
std::string value_of(std::string_view text) {
  std::string out;
  for (const char c : text) out += std::string(c == '{' ? 2 : 1, c);
  return toml_text(out);
}

/// Each option once, with all its values.
std::string settings(const std::vector<TypedOption>& options) {
  std::string lines;
  std::vector<std::string_view> written;
  for (const auto& [name, value] : options) {
    if (std::find(written.begin(), written.end(), name) != written.end()) continue;
    written.push_back(name);
    std::string values;
    int count = 0;
    for (const auto& [other, each] : options)
      if (other == name) values += (count++ ? ", " : "") + value_of(each);
    lines += with_underscores(name) + " = " + (count > 1 ? "[" + values + "]" : values) + '\n';
  }
  return lines;
}

std::string row_of(const std::string& name) {
  std::string words = name;
  std::replace(words.begin(), words.end(), '_', ' ');
  return fmt::format("  [\"{}\", \"{{recording.{}}}\"],\n", words, name);
}

std::string rows_of(const FittedRecording& fitted) {
  std::string rows;
  for (const std::string& name : coefficient_names(fitted.fit.law, fitted.parameters)) rows += row_of(name);
  for (const Parameter& each : fitted.derived) rows += row_of(each.name);
  return rows;
}

constexpr std::string_view decay_figure = R"(
[[figure]]
id = "decay"
title = "Decay rate against amplitude"
caption = "Rates of short stretches with their standard errors, and what the law says."
x = "amplitude"
y = "rate"

[[figure.curve]]
of = "recording"
x = "bar_amplitude"
y = "bar_rate"
role = "measured"

[[figure.curve]]
of = "recording"
role = "measured"
mark = "dots"
name = "measured"

[[figure.curve]]
of = "recording"
y = "law_rate"
role = "fitted"
name = "law"
)";

}  // namespace

std::string fit_study(const FittedRecording& fitted, const std::vector<TypedOption>& options) {
  if (!fitted.succeeded()) return "";
  const bool decays = !fitted.decay_by_amplitude.empty();
  std::string study = R"(# The recording lies beside this file. To run it: cromer report study.toml -o report
title = "{recording.file}: law and numbers"
summary = "The law {recording.law} leaves a residual of {recording.rms, 3} in {recording.used, bare} samples."

[[task]]
fit = "recording"
file = )" + value_of(fitted.file) +
                      '\n' + settings(options) + R"(
[[figure]]
id = "recording"
title = "What was measured"
caption = "{recording.used, bare} samples from {recording.from, 4} to {recording.to, 4}."
size = "wide"
x = "t"
y = "measured"

[[figure.curve]]
of = "recording"
role = "measured"
mark = "dots"
name = "measured"
)";
  if (decays) study += decay_figure;
  study += R"(
[[block]]
table = "The law {recording.law}: values and standard uncertainties"
header = ["quantity", "value"]
rows = [
)" + rows_of(fitted) +
           "]\n\n[[block]]\nfigure = \"recording\"\n";
  if (decays) study += "\n[[block]]\nfigure = \"decay\"\n";
  return study;
}

}  // namespace cromer::core
