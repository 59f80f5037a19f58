#include "cromer/tasks/simulate/simulate.h"
#include "commands.h"
#include "cromer/documents/csv.h"
#include "cromer/documents/hdf5.h"
#include "cromer/documents/json.h"
#include "cromer/documents/text.h"
#include "cromer/documents/words/words.h"
#include "cromer/figures/figures.h"
#include "cromer/os/process.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::core::cli {

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
  add_output_options(syntax.options, output, {.provenance = true, .panels = true},
                     "the kept states as .csv, .json or .h5");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (auto good = check_outputs(output); !good) return refuse(good.error());
  if (auto good = load_drive(options, ""); !good) return refuse(good.error());
  options.memory = os::memory() / 2;  // what is kept is written out once more as text

  const auto result = simulate(options, watching(output.quiet));
  clear_progress();
  if (!result) return refuse(result.error());
  Answer answer{.text = [&] { return simulate_text(*result); },
                .json = [&] { return to_json(*result, false); },
                .csv = [&] { return simulate_csv(*result, provenance(output, "simulate", arguments)); },
                .whole_json = [&] { return to_json(*result, true); },
                .tables = [&] { return simulate_tables(*result, command_line("simulate", arguments)); },
                .figure = [&] { return simulate_figure(*result, *parse_panels(output.panels)); },
                .notices = result->notices,
                .good = result->ok()};
  for (const auto& run : result->runs)
    if (!run.message.empty()) answer.failures.push_back(run.label + ": " + in_words(run.message));
  return give(answer, output);
}

}  // namespace cromer::core::cli
