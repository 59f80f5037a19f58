#include "cromer/tasks/modes/modes.h"

#include "commands.h"
#include "cromer/documents/csv.h"
#include "cromer/documents/json.h"
#include "cromer/documents/text.h"
#include "cromer/tasks/network/network_file.h"
#include "message.h"
#include "output.h"
#include "syntax.h"

namespace cromer::core::cli {

int run_modes(const Arguments& arguments) {
  ModesOptions options;
  OutputOptions output;
  Syntax syntax{.command = "modes",
                .description =
                    "The modes of a network of masses: natural frequencies, damping ratios and "
                    "shapes; and what a method really simulates of each.",
                .files = "FILE",
                .options = options_of(options),
                .example =
                    "  cromer modes data/networks/frame.toml\n"
                    "  cromer modes data/networks/frame.toml --method newmark --step 0.02"};
  add_output_options(syntax.options, output, {.plot = false}, "the modes as .csv or .json");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (auto good = check_outputs(output, files); !good) return refuse(good.error());
  const std::string& file = files.front();
  if (!is_network_file(file)) return refuse(Error{"not_a_network_file", {{"file", file}}});
  const auto network = open_network(file);
  if (!network) return refuse(network.error());
  const auto result = network_modes(*network, file, options);
  if (!result) return refuse(result.error());
  return give({.text = [&] { return modes_text(*result); },
               .json = [&] { return to_json(*result); },
               .csv = [&] { return modes_csv(*result); },
               .notices = result->notices},
              output);
}

}  // namespace cromer::core::cli
