#include "cromer/study/fit_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "cromer/study/toml_text.h"
#include "cromer/tasks/fit/fitted_quantities.h"

namespace cromer::core {
namespace {

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
file = )" + toml_text(verbatim(fitted.file)) +
                      '\n' + toml_settings(options) + R"(
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
