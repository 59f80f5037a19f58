#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "cromer/documents/text.h"
#include "cromer/documents/text/words.h"
#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace {

std::string known_or_dash(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : "-"; }

/// With its standard error where it is not known exactly.
std::string number(const Estimate& estimate) {
  return estimate.standard_error > 0 ? in_words(estimate, "") : known_or_dash(estimate.value);
}

std::string interval(const Estimate& estimate) {
  return estimate.standard_error > 0 ? interval_text(estimate.low, estimate.high) : "";
}

std::string number_with_interval(const Estimate& estimate, const std::string& unit) {
  const std::string ends = interval(estimate);
  if (ends.empty()) return known_or_dash(estimate.value) + (unit.empty() ? "" : " " + unit);
  return in_words(estimate, unit) + ", 95 % " + ends;
}

/// "-0.62", or with its phase where it is not in or against that of the largest: "0.62 at 34°".
std::string component_text(const std::complex<double>& z) {
  constexpr double seen = 0.5;  // degrees
  const double phase = std::arg(z) * 180 / std::numbers::pi;
  if (std::abs(phase) < seen || std::abs(z) < 5e-4) return fmt::format("{:.3f}", std::abs(z));
  if (180 - std::abs(phase) < seen) return fmt::format("{:.3f}", -std::abs(z));
  return fmt::format("{:.3f} at {:.0f}°", std::abs(z), phase);
}

std::string shapes_text(const ModesResult& result) {
  constexpr std::size_t most = 8;
  if (result.names.size() > most || result.modes.size() > most) return "";
  std::vector<std::vector<std::string>> rows{{"shape"}};
  for (std::size_t j = 0; j < result.modes.size(); ++j) rows[0].push_back(fmt::format("mode {}", j + 1));
  for (std::size_t i = 0; i < result.names.size(); ++i) {
    rows.push_back({result.names[i]});
    for (const NaturalMode& mode : result.modes) rows.back().push_back(component_text(mode.shape[i]));
  }
  return "\n" + text_table(rows, 1, rows[0].size());
}

/// How two modes beat.
std::string beat_text(const ModesResult& result) {
  const std::optional<Beat> beat = beat_of(result);
  if (!beat) return "";
  return fmt::format(
      "\nthe two beat every {}; coupling, the difference of their squared frequencies over the sum: {}\n",
      number_with_interval(beat->period, "s"), number_with_interval(beat->coupling, ""));
}

std::string percent_off_if_known(const std::optional<double>& value, double asked) {
  return value && asked != 0 && std::isfinite(asked) ? percent_off(*value / asked - 1) : "";
}

/// The network's modes against what was recorded.
std::string beside_network_text(const ModesResult& result) {
  if (!result.recording || !result.network) return "";
  std::vector<std::vector<std::string>> rows{
      {"mode", "of the network", "frequency (Hz)", "off by", "damping ratio", "off by", "MAC"}};
  for (std::size_t j = 0; j < result.modes.size(); ++j) {
    const NaturalMode& mode = result.modes[j];
    rows.push_back({fmt::format("{}", j + 1)});
    if (const auto& of = mode.of_network)
      for (const std::string& cell :
           {fmt::format("mode {}", of->mode), known_or_dash(of->frequency),
            percent_off_if_known(of->frequency, mode.frequency.value), known_or_dash(of->damping_ratio),
            percent_off_if_known(of->damping_ratio, mode.damping_ratio.value),
            fmt::format("{:.4f}", of->mac)})
        rows.back().push_back(cell);
    else
      rows.back().insert(rows.back().end(), {"-", "", "", "", "", ""});
  }
  return "\n" + text_table(rows, 1, rows[0].size());
}

std::string methods_text(const ModesResult& result) {
  if (result.modes.empty() || result.modes.front().methods.empty()) return "";
  std::vector<std::vector<std::string>> rows{
      {"mode", "method", "step (s)", "frequency (Hz)", "off by", "damping ratio", "off by", "stable"}};
  std::string words;
  const auto known = [](const std::optional<double>& value) { return value ? known_or_dash(*value) : "-"; };
  for (std::size_t j = 0; j < result.modes.size(); ++j)
    for (const ModeByMethod& by : result.modes[j].methods) {
      const NaturalMode& mode = result.modes[j];
      rows.push_back({fmt::format("{}", j + 1), by.method, fmt::format("{:.6g}", by.step),
                      known(by.frequency()), percent_off_if_known(by.frequency(), mode.frequency.value),
                      known(by.damping_ratio()),
                      percent_off_if_known(by.damping_ratio(), mode.damping_ratio.value),
                      by.effect.stable ? "yes" : "no"});
      words += fmt::format("mode {}: {} {}\n", j + 1, by.method, in_words(by.words));
    }
  return "\n" + text_table(rows, 2, 7) + "\nWith this step\n" + words;
}

}  // namespace

std::string modes_text(const ModesResult& result) {
  if (!result.ok()) return "";
  bool estimated = false, shares = false;
  for (const NaturalMode& mode : result.modes) {
    estimated = estimated || mode.frequency.standard_error > 0;
    shares = shares || mode.participation;
  }
  std::vector<std::vector<std::string>> rows{{"mode"}};
  const auto add_column = [&](const char* title, const auto& cell) {
    rows[0].emplace_back(title);
    for (std::size_t j = 0; j < result.modes.size(); ++j) rows[j + 1].push_back(cell(result.modes[j]));
  };
  for (std::size_t j = 0; j < result.modes.size(); ++j) rows.push_back({fmt::format("{}", j + 1)});
  const auto add_estimates = [&](const char* title, Estimate NaturalMode::*value) {
    add_column(title, [&](const NaturalMode& mode) { return number(mode.*value); });
    if (estimated) add_column("95 %", [&](const NaturalMode& mode) { return interval(mode.*value); });
  };
  add_estimates("frequency (Hz)", &NaturalMode::frequency);
  add_estimates("damping ratio", &NaturalMode::damping_ratio);
  if (shares)
    add_column("participation", [](const NaturalMode& mode) {
      return mode.participation ? percent(*mode.participation) : "-";
    });
  const std::string motion = result.recording ? "\n" + in_words(result.recording->words) + "\n" : "";
  return text_table(rows, 1, rows[0].size()) + beat_text(result) + shapes_text(result) +
         beside_network_text(result) + methods_text(result) + motion;
}

}  // namespace cromer::core
