#include "cromer/tasks/methods/methods.h"
#include "commands.h"
#include "cromer/documents/json.h"
#include "cromer/documents/text.h"
#include "message.h"
#include "output.h"
#include "syntax.h"

namespace cromer::core::cli {

int run_methods(const Arguments& arguments) {
  MethodsOptions options;
  OutputOptions output;
  Syntax syntax{
      .command = "methods",
      .description =
          "The methods of integration: their names as --method takes them, their orders and sources; with a "
          "step, what each of them really simulates.",
      .files = "",
      .options = options_of(options),
      .example = "  cromer methods --natural-frequency 6 --damping-ratio 0.025 --step 0.01"};
  add_output_options(syntax.options, output, {.files = false, .plot = false}, "");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (options.markdown) return print_all(methods_in_markdown());
  const auto methods = list_methods(options);
  if (!methods) return refuse(methods.error());
  return give(
      {.text = [&] { return methods_text(options, *methods); }, .json = [&] { return to_json(*methods); }},
      output);
}

}  // namespace cromer::core::cli
