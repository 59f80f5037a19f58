#include "cromer/study/task/simulate.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

#include "commands.h"
#include "cromer/analysis/energy.h"
#include "cromer/report/file.h"
#include "cromer/study/json/documents.h"
#include "cromer/study/load_drive.h"
#include "cromer/study/task/run_effect.h"
#include "exit_status.h"
#include "message.h"
#include "output.h"
#include "simulate_csv.h"
#include "simulate_figure.h"
#include "syntax.h"
#include "text_table.h"
#include "watching.h"

namespace cromer::cli {
namespace {

std::string table(const SimulateResult& result) {
  std::vector<std::vector<std::string>> rows{{"run", "t (s)", "x (m)", "v (m/s)", "energy (J)", "steps",
                                              "evaluations", "Newton", "status", "label"}};
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

/// The moments of the events asked for; empty without any.
std::string event_table(const SimulateResult& result) {
  if (result.options.event.empty()) return "";
  std::vector<std::vector<std::string>> rows{{"run", "t (s)", "x (m)", "v (m/s)", "event"}};
  for (std::size_t i = 0; i < result.runs.size(); ++i)
    for (const FoundEvent& found : result.runs[i].events.found)
      rows.push_back({fmt::format("{}", i + 1), fmt::format("{:.9g}", found.t),
                      fmt::format("{:.6g}", found.y.x), fmt::format("{:.6g}", found.y.v),
                      result.options.event[found.event]});
  return rows.size() == 1 ? "\nno events\n" : "\n" + text_table(rows, 0, 4);
}

/// "+5.8 %", "0 %" where only rounding is left.
std::string percent_off(std::optional<double> error) {
  if (!error) return "";
  return std::abs(*error) < 1e-12 ? "0 %" : fmt::format("{:+.2g} %", 100 * *error);
}

/// What gets through to the mass or to the ground; empty where nothing shakes a linear law.
std::string transmissions(const SimulateResult& result) {
  std::vector<std::vector<std::string>> rows{
      {"run", "w/w0", "ratio", "lag (rad)", "simulated", "lag (rad)", "off by", "label"}};
  std::string_view title;
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    const auto& found = result.runs[i].transmission;
    if (!found) continue;
    title = transmission_title(*found);
    std::vector<std::string> row{
        fmt::format("{}", i + 1), fmt::format("{:.4g}", found->frequency_ratio), "unbounded", "", "", "", "",
        result.runs[i].label};
    if (found->bounded()) {
      row[2] = fmt::format("{:.6g}", found->exact.amplitude);
      row[3] = fmt::format("{:.4g}", found->exact.phase_lag);
    }
    if (found->simulated) {
      row[4] = fmt::format("{:.6g}", found->simulated->amplitude);
      row[5] = fmt::format("{:.4g}", found->simulated->phase_lag);
      row[6] = percent_off(found->error());
    }
    rows.push_back(std::move(row));
  }
  return rows.size() == 1 ? "" : fmt::format("\n{}\n{}", title, text_table(rows, 0, 7));
}

/// What each method really simulates.
std::string effects(const SimulateResult& result) {
  std::string text;
  for (const auto& run : result.runs)
    if (const auto words = effect_in_words(run); !words.empty()) text += words + "\n";
  return text.empty() ? text : "\n" + text;
}

/// Half of the machine's memory: what is kept is written out once more as text.
double memory_for_states() {
  return 0.5 * static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

Result<void> write_files(const SimulateResult& result, const OutputOptions& output,
                         const Arguments& arguments) {
  if (!output.output.empty()) {
    const bool csv = *file_format(output.output) == FileFormat::csv;
    if (auto good = write_file(output.output, csv ? simulate_csv(result, arguments) : to_json(result, true));
        !good)
      return good;
  }
  return output.plot.empty() ? Result<void>{} : write_plot(output.plot, simulate_figure(result));
}

}  // namespace

int run_simulate(const Arguments& arguments) {
  SimulateOptions options;
  OutputOptions output;
  Syntax syntax{
      .command = "simulate",
      .description = "One run of the oscillator for each method and each drive frequency.",
      .files = "",
      .options = options_of(options),
      .example =
          "  cromer simulate --stiffness 9 --damping 0.2 --drive-amplitude 1 --drive-frequency 3 \\\n"
          "    --method exact --method euler-cromer --step 0.01 --until 50 -o run.csv --plot run.svg"};
  add_output_options(syntax.options, output, {}, "the kept states as .csv or .json");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (auto good = check_outputs(output); !good) return refuse(good.error().message);
  if (auto good = load_drive(options, ""); !good) return refuse(good.error().message);
  options.memory = memory_for_states();

  Watch watch = watching(output.quiet);
  std::size_t said = 0;
  watch.warn = [&](const std::vector<std::string>& warnings) {
    warn(warnings, output.quiet);
    said = warnings.size();
  };
  auto result = simulate(options, watch);
  clear_progress();
  if (!result) return refuse(result.error().message);
  warn({result->warnings.begin() + static_cast<std::ptrdiff_t>(said), result->warnings.end()}, output.quiet);
  for (const auto& run : result->runs)
    if (!run.message.empty()) complain(run.label + ": " + run.message);
  if (auto good = write_files(*result, output, arguments); !good) return refuse(good.error().message);
  if (output.output != "-" &&
      !print(output.json ? to_json(*result, false)
                         : table(*result) + event_table(*result) + transmissions(*result) + effects(*result)))
    return refuse("standard output cannot be written");
  return result->ok() ? done : no_success;
}

}  // namespace cromer::cli
