#include "cromer/tasks/simulate/simulate.h"

#include <algorithm>
#include <optional>

#include "commands.h"
#include "cromer/documents/csv.h"
#include "cromer/documents/hdf5.h"
#include "cromer/documents/json.h"
#include "cromer/documents/text.h"
#include "cromer/documents/words/words.h"
#include "cromer/figures/figures.h"
#include "cromer/os/process.h"
#include "cromer/tasks/network/network_file.h"
#include "cromer/tasks/network_run/network_run.h"
#include "cromer/tasks/open_recording.h"
#include "cromer/tasks/simulate/laid_over.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::core::cli {

namespace {

/// The first option given beside the file; "" if there is none.
std::string_view first_given(const OverOptions& over) {
  if (!over.column.empty()) return "over-column";
  if (over.run) return "over-run";
  if (over.from) return "over-from";
  return over.offset != 0 ? "over-offset" : "";
}

/// The run of a network, whose file says what moves: only the options of the integration go with it.
int run_network_file(const std::string& file, SimulateOptions options, OutputOptions output,
                     const std::vector<TypedOption>& given, const Arguments& arguments) {
  const std::vector<Option> of_task = options_of(options);
  for (const auto& [name, text] : given)
    if (std::any_of(of_task.begin(), of_task.end(),
                    [&, &typed = name](const Option& o) { return o.name == typed; }) &&
        !is_option_of_networks(name))
      return refuse(Error{"option_not_of_networks", {{"option", name}}});
  if (!output.panels.empty()) return refuse(Error{"option_not_of_networks", {{"option", "panels"}}});
  if (output.output.ends_with(".h5")) return refuse(Error{"network_without_hdf5", {{"file", output.output}}});
  if (auto good = check_outputs(output, {file}); !good) return refuse(good.error());
  const auto network = open_network(file);
  if (!network) return refuse(network.error());
  options.memory = os::memory() / 2;
  const auto runs = run_network_by_each(*network, file, options, watching(output.quiet));
  clear_progress();
  if (!runs) return refuse(runs.error());
  Answer answer{.text = [&] { return network_text(*runs); },
                .json = [&] { return to_json(*runs, false); },
                .csv = [&] { return network_csv(*runs, provenance(output, "simulate", arguments)); },
                .whole_json = [&] { return to_json(*runs, true); },
                .figure = [&] { return network_figure(*runs); }};
  for (const NetworkRun& run : *runs) {
    answer.notices.insert(answer.notices.end(), run.notices.begin(), run.notices.end());
    answer.good = answer.good && run.ok();
    if (!run.message.empty()) answer.failures.push_back(run.method + ": " + in_words(run.message));
  }
  return give(answer, output);
}

}  // namespace

int run_simulate(const Arguments& arguments) {
  SimulateOptions options;
  OutputOptions output;
  output.hdf5 = true;
  Syntax syntax{
      .command = "simulate",
      .description = "One run of the oscillator for each method and each drive frequency.",
      .files = "",
      .options = options_of(options),
      .example =
          "  cromer simulate --stiffness 9 --damping 0.2 --drive-amplitude 1 --drive-frequency 3 \\\n"
          "    --method exact --method euler-cromer --step 0.01 --until 50 -o run.csv --plot run.svg"};
  OverOptions over;
  const std::vector<Option> of_over = options_of(over);
  syntax.options.insert(syntax.options.end(), of_over.begin(), of_over.end());
  std::string network;
  syntax.options.push_back(
      {"network", &network, "", Range::any,
       "file (.toml) of masses and links that run in place of one oscillator; the options "
       "of the integration go with it",
       "none", "A network of masses"});
  add_output_options(syntax.options, output, {.provenance = true, .panels = true},
                     "the kept states as .csv, .json or .h5");
  std::vector<std::string> files;
  std::vector<TypedOption> typed;
  if (const auto status = parse(syntax, arguments, files, &typed)) return *status;
  if (!network.empty()) {
    if (!over.file.empty()) return refuse(Error{"network_not_alone"});
    return run_network_file(network, options, output, typed, arguments);
  }
  if (auto good = check_outputs(output, over.file.empty() ? files : std::vector{over.file}); !good)
    return refuse(good.error());
  std::optional<Recording> under;
  const ReadOptions reading = options.read;
  if (over.file.empty()) {
    if (const std::string_view given = first_given(over); !given.empty())
      return refuse(Error{"over_options_without_over", {{"option", given}}});
  } else {
    auto recording = open_recording(over.file, reading);
    if (!recording) return refuse(recording.error());
    under = *std::move(recording);
    // These options are the recording's where no drive is read.
    if (options.drive_file.empty() && options.base_motion.empty()) options.read = {};
  }
  if (auto good = load_drive(options, ""); !good) return refuse(good.error());
  options.memory = os::memory() / 2;  // what is kept is written out once more as text

  auto result = simulate(options, watching(output.quiet));
  clear_progress();
  if (!result) return refuse(result.error());
  std::optional<LaidOver> laid;
  if (under) {
    auto samples = lay_over(*under, over, *result, reading);
    if (!samples) return refuse(samples.error());
    laid = *std::move(samples);
    for (const SimulatedRun& run : result->runs)
      if (Notice off = distance_notice(*laid, run); !off.empty()) result->notices.push_back(std::move(off));
  }
  Answer answer{
      .text = [&] { return simulate_text(*result); },
      .json = [&] { return to_json(*result, false); },
      .csv = [&] { return simulate_csv(*result, provenance(output, "simulate", arguments)); },
      .whole_json = [&] { return to_json(*result, true); },
      .tables = [&] { return simulate_tables(*result, command_line("simulate", arguments)); },
      .figure =
          [&] { return simulate_figure(*result, *parse_panels(output.panels), laid ? &*laid : nullptr); },
      .notices = result->notices,
      .good = result->ok()};
  for (const auto& run : result->runs)
    if (!run.message.empty()) answer.failures.push_back(run.label + ": " + in_words(run.message));
  return give(answer, output);
}

}  // namespace cromer::core::cli
