#include "cromer/tasks/simulate/simulate.h"
#include "cromer/documents/words/words.h"

#include <unistd.h>

#include "command_line.h"
#include "commands.h"
#include "cromer/documents/csv.h"
#include "cromer/documents/hdf5.h"
#include "cromer/documents/json.h"
#include "cromer/documents/text.h"
#include "cromer/figures/figures.h"
#include "cromer/report/file.h"
#include "cromer/tasks/simulate/load_drive.h"
#include "exit_status.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::core::cli {
namespace {

/// Half of the machine's memory: what is kept is written out once more as text.
double memory_for_states() {
  return 0.5 * static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

Result<void> write_files(const SimulateResult& result, const OutputOptions& output,
                         const std::string& command) {
  if (!output.output.empty()) {
    const std::string& file = output.output;
    const FileFormat format = *file_format(file, true);
    const auto good = format == FileFormat::hdf5  ? write_tables(file, simulate_tables(result, command))
                      : format == FileFormat::csv ? write_file(file, simulate_csv(result, command))
                                                  : write_file(file, to_json(result, true));
    if (!good) return good;
  }
  return output.plot.empty() ? Result<void>{} : write_plot(output.plot, simulate_figure(result));
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
  add_output_options(syntax.options, output, {}, "the kept states as .csv, .json or .h5");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (auto good = check_outputs(output); !good) return refuse(good.error());
  if (auto good = load_drive(options, ""); !good) return refuse(good.error());
  options.memory = memory_for_states();

  const auto result = simulate(options, watching(output.quiet));
  clear_progress();
  if (!result) return refuse(result.error());
  if (auto good = write_files(*result, output, command_line("simulate", arguments)); !good)
    return refuse(good.error());
  if (output.output != "-" && !print(output.json ? to_json(*result, false) : simulate_text(*result)))
    return refuse("standard output cannot be written");
  for (const auto& run : result->runs)
    if (!run.message.empty()) complain(run.label + ": " + in_words(run.message));
  tell(result->notices, output);
  return result->ok() ? done : no_success;
}

}  // namespace cromer::core::cli
