#include "cromer/documents/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "cromer/analysis/energy.h"
#include "cromer/analysis/frequency_response.h"
#include "cromer/documents/text/words.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/simulate/run_effect.h"
#include "cromer/tasks/simulate/run_energy.h"

namespace cromer::core {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string run_table(const SimulateResult& result) {
  Rows rows{{"run", "t (s)", "x (m)", "v (m/s)", "energy (J)", "steps", "evaluations", "Newton", "status",
             "label"}};
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    const SimulatedRun& run = result.runs[i];
    const Outcome& end = run.outcome;
    rows.push_back({fmt::format("{}", i + 1), fmt::format("{:.6g}", end.t), fmt::format("{:.6g}", end.y.x),
                    fmt::format("{:.6g}", end.y.v), fmt::format("{:.6g}", energy(run.oscillator, end.y)),
                    fmt::format("{}", end.counts.accepted), fmt::format("{}", end.counts.evaluations),
                    fmt::format("{}", end.counts.newton_iterations), std::string(name(end.status)),
                    run.label});
  }
  return text_table(rows, 0, 8);
}

/// The events that were found; empty if none were asked for.
std::string event_table(const SimulateResult& result) {
  if (result.options.event.empty()) return "";
  Rows rows{{"run", "t (s)", "x (m)", "v (m/s)", "event"}};
  for (std::size_t i = 0; i < result.runs.size(); ++i)
    for (const FoundEvent& found : result.runs[i].events.found)
      rows.push_back({fmt::format("{}", i + 1), fmt::format("{:.9g}", found.t),
                      fmt::format("{:.6g}", found.y.x), fmt::format("{:.6g}", found.y.v),
                      result.options.event[found.event]});
  return rows.size() == 1 ? "\nno events\n" : "\n" + text_table(rows, 0, 4);
}

/// The steps that --accuracy chose, and their measured errors.
std::string accuracy_table(const SimulateResult& result) {
  Rows rows{{"run", "step (s)", "frequency off", "decay off", "amplitude off", "label"}};
  const auto or_none = [](std::optional<double> error) { return error ? percent(*error) : ""; };
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    const auto& found = result.runs[i].accuracy;
    if (!found) continue;
    rows.push_back({fmt::format("{}", i + 1), fmt::format("{:.6g}", found->step),
                    or_none(found->frequency_error), or_none(found->decay_error),
                    percent(found->amplitude_error), result.runs[i].label});
  }
  if (rows.size() == 1) return "";
  return fmt::format("\nlongest steps that keep to {}, as measured\n{}", percent(*result.options.accuracy),
                     text_table(rows, 0, 5));
}

/// An amplitude and a lag, exact and as simulated.
struct Compared {
  double exact = 0, exact_lag = 0;
  std::optional<std::pair<double, double>> simulated{};
};

void add_row(Rows& rows, std::size_t number, const SimulatedRun& run, const Compared& two) {
  std::vector<std::string> row{fmt::format("{}", number),
                               fmt::format("{:.4g}", run.transmission->frequency_ratio),
                               "unbounded",
                               "",
                               "",
                               "",
                               "",
                               run.label};
  const bool bounded = std::isfinite(two.exact);
  if (bounded) {
    row[2] = fmt::format("{:.6g}", two.exact);
    row[3] = fmt::format("{:.4g}", two.exact_lag);
  }
  if (two.simulated) {
    row[4] = fmt::format("{:.6g}", two.simulated->first);
    row[5] = fmt::format("{:.4g}", two.simulated->second);
    if (bounded) row[6] = percent_off(two.simulated->first / two.exact - 1);
  }
  rows.push_back(std::move(row));
}

/// The steady motion and the transmissibility of driven linear laws; empty if there are none.
std::string steady_tables(const SimulateResult& result) {
  Rows steady{{"run", "w/w0", "exact (m)", "lag (rad)", "simulated (m)", "lag (rad)", "off by", "label"}};
  Rows through{{"run", "w/w0", "exact", "lag (rad)", "simulated", "lag (rad)", "off by", "label"}};
  std::string_view title;
  bool of_motion = false;
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    const SimulatedRun& run = result.runs[i];
    if (!run.transmission) continue;
    const RunTransmission& found = *run.transmission;
    title = found.of_motion ? "transmissibility: displacement of the mass over that of the base"
                            : "transmissibility: force on the ground over force on the mass";
    of_motion = found.of_motion;
    const SteadyState exact = frequency_response(run.oscillator, run.drive.amplitude, run.drive.frequency);
    Compared motion{exact.amplitude, exact.phase_lag};
    if (run.effect && run.effect->effective.steady_state)
      motion.simulated = {run.effect->effective.steady_state->amplitude,
                          run.effect->effective.steady_state->phase_lag};
    add_row(steady, i + 1, run, motion);
    Compared passed{found.exact.amplitude, found.exact.phase_lag};
    if (found.simulated) passed.simulated = {found.simulated->amplitude, found.simulated->phase_lag};
    add_row(through, i + 1, run, passed);
  }
  if (title.empty()) return "";
  return fmt::format("\nsteady motion{}: amplitude and lag behind the drive\n{}\n{}\n{}",
                     of_motion ? ", from the base" : "", text_table(steady, 0, 7), title,
                     text_table(through, 0, 7));
}

/// What each method makes of the law, and what it conserves. A method whose runs all say the same says it
/// once.
std::string effects(const SimulateResult& result) {
  std::vector<std::pair<const SimulatedRun*, std::string>> said;
  for (const auto& run : result.runs)
    if (const Notice words = effect_notice(run); !words.empty()) said.emplace_back(&run, in_words(words));
  std::vector<std::string> lines;
  for (const auto& [run, words] : said) {
    const bool always = std::all_of(said.begin(), said.end(), [&, r = run, &w = words](const auto& other) {
      return other.first->method != r->method || other.second == w;
    });
    auto line = (always ? run->method : run->label) + " " + words + "\n";
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(std::move(line));
  }
  std::string text;
  for (const auto& line : lines) text += line;
  for (const auto& run : result.runs)
    if (const Notice words = modified_energy_notice(run); !words.empty()) text += in_words(words) + "\n";
  return text.empty() ? text : "\n" + text;
}

}  // namespace

std::string simulate_text(const SimulateResult& result) {
  return run_table(result) + event_table(result) + accuracy_table(result) + steady_tables(result) +
         effects(result);
}

}  // namespace cromer::core
