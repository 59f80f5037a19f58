#include "cromer/tasks/compare/compare.h"
#include "commands.h"
#include "cromer/documents/csv.h"
#include "cromer/documents/json.h"
#include "cromer/documents/text.h"
#include "cromer/figures/figures.h"
#include "cromer/tasks/fit/said_of_runs.h"
#include "cromer/tasks/open_recording.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::core::cli {

int run_compare(const Arguments& arguments) {
  CompareOptions options;
  OutputOptions output;
  Syntax syntax{
      .command = "compare",
      .description =
          "A recording beside one constant decay rate, the law that fit chose, and that law simulated by "
          "each "
          "method.",
      .files = "FILE",
      .options = options_of(options),
      .example =
          "  cromer compare lab.csv --mass \"217.6 g\" --method forward-euler --method euler-cromer \\\n"
          "    --segment \"30 s\" --plot compare.svg --panels position,energy,phase"};
  add_output_options(syntax.options, output, {.panels = true},
                     "measured and simulated motion as .csv, or the document as .json");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (auto good = check_outputs(output, files); !good) return refuse(good.error());
  const auto recording = open_recording(files.front(), options.fit.read);
  if (!recording) return refuse(recording.error());
  const auto comparisons = compare(*recording, options, watching(output.quiet));
  clear_progress();
  if (!comparisons) return refuse(comparisons.error());
  Answer answer{.text = [&] { return compare_text(*comparisons); },
                .json = [&] { return to_json(*comparisons); },
                .csv = [&] { return compare_csv(*comparisons); },
                .figure = [&] { return compare_figure(*comparisons, *parse_panels(output.panels)); },
                .notices = said_of_runs(*comparisons)};
  for (const auto& comparison : *comparisons) {
    answer.good = answer.good && comparison.complete && comparison.recording.succeeded();
    if (!comparison.recording.succeeded()) answer.failures.push_back(failure_text(comparison.recording));
  }
  return give(answer, output);
}

}  // namespace cromer::core::cli
