#include "commands.h"
#include "cromer/documents/json.h"
#include "cromer/documents/text.h"
#include "cromer/tasks/open_recording.h"
#include "cromer/tasks/recognise/recognise.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::core::cli {
namespace {

int run_recognise(const RecogniseOptions& options, const OutputOptions& output) {
  const auto recording = open_recording(options.recognise, options.read);
  if (!recording) return refuse(recording.error());
  const auto result = recognise(*recording, options, watching(output.quiet));
  clear_progress();
  if (!result) return refuse(result.error());
  return give({.text = [&] { return recognise_text(*result); },
               .json = [&] { return to_json(*result); },
               .notices = result->notices,
               .good = result->ok()},
              output);
}

}  // namespace

int run_methods(const Arguments& arguments) {
  RecogniseOptions options;
  OutputOptions output;
  Syntax syntax{
      .command = "methods",
      .description =
          "The methods of integration: their names as --method takes them, their orders and sources; with a "
          "step, what each of them really simulates; and which of them made the states in a file, of any "
          "simulator.",
      .files = "",
      .options = options_of(options),
      .example =
          "  cromer methods --natural-frequency 6 --damping-ratio 0.025 --step 0.01\n"
          "  cromer methods --recognise run.csv --mass \"200 g\" --stiffness \"16 N/m\" --damping 0.01"};
  add_output_options(syntax.options, output, {.files = false, .plot = false}, "");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (!options.recognise.empty()) return run_recognise(options, output);
  if (auto good = only_with_file(options); !good) return refuse(good.error());
  if (options.methods.markdown) return print_all(methods_in_markdown());
  const auto methods = list_methods(options.methods);
  if (!methods) return refuse(methods.error());
  return give({.text = [&] { return methods_text(options.methods, *methods); },
               .json = [&] { return to_json(*methods); }},
              output);
}

}  // namespace cromer::core::cli
