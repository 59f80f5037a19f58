#include "fit_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/base/quantity.h"
#include "text_table.h"

namespace cromer::cli {
namespace {

/// "  decay rate" for decay_rate.
std::string in_words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return fmt::format("  {}", name);
}

std::string quantity(const Estimate& estimate, std::string_view unit) {
  return format_quantity({estimate.value, estimate.standard_error}, unit == "1" ? "" : unit);
}

std::string heading(const FittedRecording& fitted) {
  const Series& series = fitted.series;
  std::string text =
      fmt::format("{}, {}, run {}: {}", fitted.file, series.column, series.run, name(fitted.fit.status));
  if (fitted.fit.status != FitStatus::converged) return text + ", " + fitted.fit.message + "\n";
  return text + fmt::format(", {} of {} samples, {:.6g} to {:.6g} s, law {}\n", series.t.size(),
                            fitted.samples, series.t.front(), series.t.back(), to_text(fitted.fit.law));
}

// Of the column.
std::string si_unit(const FittedRecording& fitted) {
  for (const auto& parameter : fitted.parameters)
    if (parameter.name == "equilibrium") return parameter.unit;
  return "";
}

// The law that comes next, and by how much.
std::string runner_up(const FittedRecording& fitted) {
  const Candidate* second = nullptr;
  const Candidate* chosen = nullptr;
  for (const auto& candidate : fitted.candidates)
    if (candidate.law == fitted.fit.law)
      chosen = &candidate;
    else if (!second || candidate.bic < second->bic)
      second = &candidate;
  if (!chosen || !second) return "";
  const std::string unit = si_unit(fitted);
  return fmt::format("  chosen of {} laws; next is {}: residual {:.4g}{}, BIC {} than that of {}\n",
                     fitted.candidates.size(), to_text(second->law), second->rms,
                     unit.empty() ? "" : " " + unit,
                     second->bic >= chosen->bic
                         ? fmt::format("{:.3g} higher", second->bic - chosen->bic)
                         : fmt::format("{:.3g} lower, {},", chosen->bic - second->bic,
                                       chosen->bic - second->bic < 2 ? "too little to tell"
                                                                     : "but with terms that are not sure"),
                     to_text(chosen->law));
}

std::string one_fit(const FittedRecording& fitted) {
  std::string out = heading(fitted);
  std::vector<std::vector<std::string>> rows;
  for (const auto* list : {&fitted.parameters, &fitted.derived})
    for (const auto& entry : *list)
      if (std::isfinite(entry.estimate.value))
        rows.push_back({in_words(entry.name), quantity(entry.estimate, entry.unit)});
  for (const auto& segment : fitted.segments)
    rows.push_back({fmt::format("  decay rate {:.6g} to {:.6g} s", segment.from, segment.to),
                    quantity(segment.rate, "1/s")});
  if (fitted.decay_rate_mean)
    rows.push_back({"  decay rate, mean", quantity(*fitted.decay_rate_mean, "1/s")});
  if (fitted.reynolds_max)
    rows.push_back({fmt::format("  largest Reynolds number, at {:.6g} s", fitted.reynolds_max_t),
                    quantity(*fitted.reynolds_max, "")});
  if (!fitted.parameters.empty())
    rows.push_back({"  residual (rms)", format_quantity({fitted.fit.residual.rms, 0}, si_unit(fitted))});
  out += text_table(rows, 0, 0);
  out += runner_up(fitted);
  if (!fitted.simulate.empty()) out += "  simulate it: " + fitted.simulate + "\n";
  return out;
}

}  // namespace

std::string fit_text(const std::vector<FittedRecording>& fits) {
  std::string out;
  for (const auto& fitted : fits) {
    if (!out.empty()) out += '\n';
    out += one_fit(fitted);
  }
  return out;
}

}  // namespace cromer::cli
