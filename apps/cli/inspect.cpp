#include "cromer/tasks/inspect/inspect.h"
#include "commands.h"
#include "cromer/documents/csv.h"
#include "cromer/documents/json.h"
#include "cromer/documents/text.h"
#include "cromer/tasks/open_recording.h"
#include "message.h"
#include "output.h"
#include "syntax.h"

namespace cromer::core::cli {

int run_inspect(const Arguments& arguments) {
  ReadOptions options;
  OutputOptions output;
  Syntax syntax{
      .command = "inspect",
      .description =
          "What is in a recording: its dialect, columns, rate, gaps and outliers. -o converts any dialect.",
      .files = "FILE",
      .options = options_of(options),
      .example = "  cromer inspect lab.csv -o clean.csv"};
  add_output_options(syntax.options, output, {.plot = false}, "the columns as .csv or .json");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (auto good = check_outputs(output, files); !good) return refuse(good.error());
  auto recording = open_recording(files.front(), options);
  if (!recording) return refuse(recording.error());
  const auto inspection = inspect(*std::move(recording), options);
  if (!inspection) return refuse(inspection.error());
  return give({.text = [&] { return inspect_text(*inspection); },
               .json = [&] { return to_json(*inspection, false); },
               .csv = [&] { return recording_csv(inspection->recording, options); },
               .whole_json = [&] { return to_json(*inspection, true); },
               .notices = inspection->notices},
              output);
}

}  // namespace cromer::core::cli
