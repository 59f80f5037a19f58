#include <algorithm>

#include "commands.h"
#include "cromer/documents/csv.h"
#include "cromer/documents/json.h"
#include "cromer/documents/text.h"
#include "cromer/documents/words/words.h"
#include "cromer/figures/figures.h"
#include "cromer/tasks/modes_of_file.h"
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
                    "The modes of a network of masses, or in a recording of several channels: natural "
                    "frequencies, damping ratios and shapes; and what a method really simulates of each.",
                .files = "FILE",
                .options = options_of(options),
                .example =
                    "  cromer modes data/networks/frame.toml\n"
                    "  cromer modes data/networks/frame.toml --method newmark --step 0.02 --plot frame.svg\n"
                    "  cromer modes data/networks/floors_in_wind.csv --network data/networks/frame.toml \\\n"
                    "    --plot modes.svg"};
  std::string network_file;
  const auto after = std::find_if(syntax.options.begin(), syntax.options.end(),
                                  [](const Option& option) { return option.name == "of-method"; });
  syntax.options.insert(after + 1,
                        {"network", &network_file, "", Range::any,
                         "the file of a network whose masses are the channels, in its order: its modes are "
                         "set beside those of the recording",
                         "none", after->group});
  add_output_options(syntax.options, output, {}, "the modes as .csv or .json");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (auto good = check_outputs(output, files); !good) return refuse(good.error());
  const std::string& file = files.front();
  if (!network_file.empty()) {
    auto opened = open_network(network_file);
    if (!opened) return refuse(opened.error());
    options.network = *std::move(opened);
  }
  const auto result = modes_of_file(file, options);
  if (!result) return refuse(result.error());
  return give({.text = [&] { return modes_text(*result); },
               .json = [&] { return to_json(*result); },
               .csv = [&] { return result->ok() ? modes_csv(*result) : std::string(); },
               .figure = [&] { return modes_figure(*result); },
               .failures = result->ok() ? std::vector<std::string>{}
                                        : std::vector{file + ": " + in_words(result->message)},
               .notices = result->notices,
               .good = result->ok()},
              output);
}

}  // namespace cromer::core::cli
