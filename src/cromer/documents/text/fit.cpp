#include "cromer/documents/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "cromer/base/pi.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/text/words.h"
#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/criterion.h"
#include "cromer/read/column_kind.h"
#include "cromer/tasks/fit/decay_rates.h"
#include "cromer/tasks/fit/lab_quantities.h"

namespace cromer::core {
namespace {

Estimate in_hertz(const Estimate& angular) {
  constexpr double turn = two_pi;
  return {angular.value / turn, angular.standard_error / turn, angular.low / turn, angular.high / turn};
}

/// What drives the motion, and how a recorded force was read.
std::string drive_in_words(const FittedRecording& fitted) {
  if (!fitted.driven) return "";
  if (fitted.between_samples.empty())
    return fmt::format("  the motion is driven, at {}\n",
                       in_words(in_hertz(fitted.fit["drive_frequency"]), "Hz"));
  return fmt::format("  driven by \"{}\", taken as {} between its samples\n", fitted.options.force_column,
                     fitted.between_samples);
}

std::string first_line(const FittedRecording& fitted) {
  const Series& series = fitted.series;
  const std::string title = recording_title(fitted) + ": ";
  if (fitted.fit.status != FitStatus::converged) return title + in_words(fitted.fit.message) + "\n";
  return title +
         fmt::format("converged, {} of {} samples, {:.10g} to {:.10g} s, law {}\n", fitted.used(),
                     fitted.samples, series.t.front(), series.t.back(), to_text(fitted.fit.law)) +
         drive_in_words(fitted);
}

/// Why a law of lower BIC was not chosen. Among laws without strong evidence between them, the one with the
/// fewest parameters is.
std::string_view why_not(const Candidate& lower, double by) {
  return by < strong_evidence ? "too little to prefer more or rarer terms"
         : lower.converged    ? "but with terms that are not sure"
                              : "but its fit has not converged";
}

/// The second best law, and by how much it is worse.
std::string runner_up(const FittedRecording& fitted) {
  const Candidate* second = nullptr;
  const Candidate* chosen = nullptr;
  for (const auto& candidate : fitted.candidates)
    if (candidate.law == fitted.fit.law)
      chosen = &candidate;
    else if (!second || candidate.bic < second->bic)
      second = &candidate;
  if (!chosen || !second) return "";
  const std::string unit = fitted_unit(fitted);
  return fmt::format("  chosen of {} laws; next is {}: residual {:.4g}{}, BIC {} than that of {}\n",
                     fitted.candidates.size(), to_text(second->law), second->rms,
                     unit.empty() ? "" : " " + unit,
                     second->bic >= chosen->bic ? fmt::format("{:.3g} higher", second->bic - chosen->bic)
                                                : fmt::format("{:.3g} lower, {},", chosen->bic - second->bic,
                                                              why_not(*second, chosen->bic - second->bic)),
                     to_text(chosen->law));
}

/// A line for each contribution to the uncertainty of the spring constant.
std::string budget(const std::vector<Contribution>& contributions) {
  std::string out;
  for (const auto& each : contributions)
    out +=
        each.standard_uncertainty > 0
            ? fmt::format("  spring constant, from {}: \u00b1\u00a0{:.2g}\u00a0N/m, {} of its variance\n",
                          readable_name(each.quantity), each.contribution, percent(each.share))
            : fmt::format("  spring constant: your {} has no \u00b1, so its part is not in the uncertainty\n",
                          readable_name(each.quantity));
  return out;
}

std::string checked(const FittedRecording& fitted) {
  const MonteCarlo& trials = *fitted.monte_carlo;
  const Estimate& propagated = *fitted.find("stiffness");
  const Quantity drawn{trials.mean, trials.standard_deviation};
  return fmt::format("  spring constant by {} trials: {}, 95 % {}; propagated {}\n", trials.trials,
                     format_quantity(drawn, "N/m"), interval_text(trials.low, trials.high),
                     interval_text(propagated.low, propagated.high));
}

/// The damping by textbook methods, with what is wrong about each.
std::string textbook(const FittedRecording& fitted) {
  std::string out;
  if (const auto& peaks = fitted.textbook->decrement)
    out += fmt::format("  textbook: logarithmic decrement {} from {} peaks ({})\n",
                       format_quantity({peaks->value, peaks->standard_error}, ""), peaks->peaks,
                       in_words(TextbookDamping::decrement_bias()));
  else
    out += "  textbook: fewer than three peaks stand out of the noise\n";
  if (const auto& line = fitted.textbook->bandwidth)
    out += fmt::format(
        "  textbook: half-power bandwidth {} rad/s, so a decay rate of {} 1/s (too wide: a record of this "
        "length shows no line narrower than {} rad/s)\n",
        rounded(line->width, 4), rounded(line->width / 2, 4), rounded(line->narrowest, 4));
  else
    out += "  textbook: the spectrum's line does not fall to half its power on both sides\n";
  return out;
}

/// Lines that are printed only if asked for.
std::string more(const FittedRecording& fitted) {
  std::string out = budget(fitted.stiffness_budget);
  if (fitted.monte_carlo && fitted.find("stiffness")) out += checked(fitted);
  if (fitted.textbook) out += textbook(fitted);
  if (fitted.plan) out += "  to record: " + in_words(fitted.plan->text) + "\n";
  return out;
}

/// The decay rate at both ends of the record, or what is known of it.
std::string decay_in_words(const Parameter& start, const Parameter* end, const Law& law) {
  const std::string first = in_words(start.estimate, start.unit);
  if (!end) return first + (law.has<Friction>() ? " at the start; it comes to rest" : " at the start");
  if (is_one_rate(start.estimate, end->estimate)) return first;
  return fmt::format("{} at the start \u2192 {} at the end", first, in_words(end->estimate, end->unit));
}

/// What is looked for first.
std::vector<std::vector<std::string>> headline(const FittedRecording& fitted) {
  std::vector<std::vector<std::string>> rows;
  if (const Parameter* frequency = named(fitted.headline, "frequency"))
    rows.push_back({"  frequency", in_words(frequency->estimate, frequency->unit)});
  if (const Parameter* stiffness = named(fitted.headline, "stiffness")) {
    const Estimate& k = stiffness->estimate;
    rows.push_back({"  spring constant",
                    fmt::format("{}, 95 % {}", in_words(k, stiffness->unit), interval_text(k.low, k.high))});
  }
  if (const Parameter* start = named(fitted.headline, "decay_rate_start"))
    rows.push_back(
        {"  decay rate", decay_in_words(*start, named(fitted.headline, "decay_rate_end"), fitted.fit.law)});
  if (const Parameter* reynolds = named(fitted.headline, "reynolds_max"))
    rows.push_back({"  largest Reynolds number",
                    fmt::format("{}, at {:.6g} s", in_words(reynolds->estimate, ""), fitted.reynolds_max_t)});
  return rows;
}

std::string name_in_law(const Law& law, std::string_view parameter) {
  const std::string part = viscous_part_in_words(law, parameter);
  return part.empty() ? readable_name(parameter) : part;
}

std::string one_fit(const FittedRecording& fitted) {
  std::string out = first_line(fitted);
  const std::string first = text_table(headline(fitted), 0, 0);
  if (!first.empty()) out += first + "  the law, and what follows from it:\n";
  std::vector<std::vector<std::string>> rows;
  const Law& law = fitted.fit.law;
  for (const auto* list : {&fitted.parameters, &fitted.derived})
    for (const auto& entry : *list)
      if (std::isfinite(entry.estimate.value) && !named(fitted.headline, entry.name))
        rows.push_back({"  " + name_in_law(law, entry.name), in_words(entry.estimate, entry.unit),
                        std::string(term_of(law, entry.name))});
  for (const auto& segment : fitted.segments)
    rows.push_back({fmt::format("  decay rate {:.10g} to {:.10g} s", segment.from, segment.to),
                    in_words(segment.rate, "1/s")});
  if (fitted.decay_rate_mean)
    rows.push_back({"  decay rate, mean", in_words(*fitted.decay_rate_mean, "1/s")});
  if (fitted.keulegan_carpenter)
    rows.push_back({"  largest Keulegan-Carpenter number", in_words(*fitted.keulegan_carpenter, "")});
  if (!fitted.parameters.empty())
    rows.push_back({"  residual (rms)", format_quantity({fitted.fit.residual.rms, 0}, fitted_unit(fitted))});
  if (fitted.held_out)
    rows.push_back(
        {fmt::format("  residual held out, {:.10g} to {:.10g} s", fitted.held_out->from, fitted.held_out->to),
         format_quantity({fitted.held_out->rms, 0}, fitted_unit(fitted))});
  out += text_table(rows, 0, 0);
  // Under a recorded force, law and interpolation are chosen together: all candidates are listed.
  const bool forced = !fitted.candidates.empty() && !fitted.candidates.front().between_samples.empty();
  if (!forced) out += runner_up(fitted);
  const std::string unit = fitted_unit(fitted);
  if (forced && fitted.candidates.size() > 1)
    for (const auto& candidate : fitted.candidates)
      out += fmt::format("  candidate {}, {}: residual {:.4g}{}, BIC {}\n", to_text(candidate.law),
                         candidate.between_samples, candidate.rms, unit.empty() ? "" : " " + unit,
                         rounded(candidate.bic, 6));
  out += more(fitted);
  if (!fitted.simulate.empty())
    out += "  simulate it: " + command_of("simulate", simulate_and_lay_over(fitted)) + "\n";
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

std::string failure_text(const FittedRecording& fitted) {
  return fmt::format("{}: run {}: {}", fitted.file, fitted.series.run, in_words(fitted.fit.message));
}

namespace {

constexpr std::string_view shown_quantities[] = {"frequency", "stiffness", "decay_rate_start",
                                                 "decay_rate_end", "drag_coefficient"};

const Parameter* find(const FittedRecording& fitted, std::string_view name) {
  for (const auto* list : {&fitted.headline, &fitted.parameters, &fitted.derived})
    if (const Parameter* number = named(*list, name); number && std::isfinite(number->estimate.value))
      return number;
  return nullptr;
}

/// The quantities that any of the recordings has.
std::vector<std::string_view> columns_of(const std::vector<FittedRecording>& fits) {
  std::vector<std::string_view> names;
  for (const std::string_view name : shown_quantities)
    if (std::any_of(fits.begin(), fits.end(), [&](const auto& fitted) { return find(fitted, name); }))
      names.push_back(name);
  return names;
}

std::vector<std::string> row_of(const FittedRecording& fitted, const std::string& name,
                                const std::vector<std::string_view>& columns) {
  std::vector<std::string> row{name, fmt::format("{}", fitted.series.run),
                               fitted.succeeded() ? to_text(fitted.fit.law) : std::string(fitted.status())};
  const bool any = !fitted.parameters.empty();
  for (const auto column : columns) {
    const Parameter* number = find(fitted, column);
    row.push_back(!number ? ""
                          : format_concise({number->estimate.value, number->estimate.standard_error},
                                           number->unit == "1" ? "" : number->unit));
  }
  const std::string unit = unit_of(fitted.series);
  row.push_back(any ? fmt::format("{:.3g}{}{}", fitted.fit.residual.rms, unit.empty() ? "" : " ", unit) : "");
  row.push_back(in_words(fitted.fit.message));
  return row;
}

}  // namespace

std::string fit_table(const std::vector<FittedRecording>& fits) {
  if (fits.empty()) return "";
  std::vector<std::string> files;
  for (const auto& fitted : fits) files.push_back(fitted.file);
  const std::vector<std::string> names = short_names(files);
  const std::vector<std::string_view> columns = columns_of(fits);
  std::vector<std::vector<std::string>> rows{{"file", "run", "law"}};
  for (const auto column : columns) rows[0].push_back(readable_name(column));
  rows[0].emplace_back("residual (rms)");
  std::size_t failed = 0;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    rows.push_back(row_of(fits[i], names[i], columns));
    failed += !fits[i].succeeded();
  }
  std::string out = text_table(rows, 1, 2);
  out += fmt::format("{} of {} fits succeeded\n", fits.size() - failed, fits.size());
  return out;
}

}  // namespace cromer::core
