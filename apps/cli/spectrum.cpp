#include "commands.h"
#include "cromer/documents/csv.h"
#include "cromer/documents/hdf5.h"
#include "cromer/documents/json.h"
#include "cromer/documents/text.h"
#include "cromer/figures/figures.h"
#include "cromer/os/process.h"
#include "cromer/report/file.h"
#include "cromer/tasks/open_recording.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::core::cli {
namespace {

/// What this command writes beside the common files.
struct SpectrumOutput {
  OutputOptions common{};
  std::string fourier{};
  bool tripartite = false;
};

Result<void> check_output(const SpectrumOutput& output, bool shock, const std::vector<std::string>& inputs) {
  if (auto good = check_outputs(output.common, inputs); !good) return good;
  if (output.tripartite && output.common.plot.empty()) return Error{"tripartite_without_plot"};
  if (output.tripartite && shock) return Error{"tripartite_of_shock"};
  if (output.fourier.empty()) return {};
  if (!output.fourier.ends_with(".csv")) return Error{"fourier_is_csv", {{"file", output.fourier}}};
  if (output.fourier == output.common.output)
    return Error{"two_outputs_one_file",
                 {{"first", "-o"}, {"second", "--fourier"}, {"file", output.fourier}}};
  OutputOptions same;
  same.output = output.fourier;
  return check_outputs(same, inputs, "--fourier");
}

}  // namespace

int run_spectrum(const Arguments& arguments) {
  SpectrumOptions options;
  SpectrumOutput output;
  output.common.hdf5 = true;
  Syntax syntax{
      .command = "spectrum",
      .description =
          "Response spectrum of a recorded acceleration: the largest displacement, pseudo-velocity and "
          "pseudo-acceleration that oscillators of many periods reach. Two files are the horizontal "
          "components of one motion: geometric mean, RotD50 and RotD100 come with them.",
      .files = "FILE...",
      .options = options_of(options),
      .example =
          "  cromer spectrum quake.AT2 --damping-ratio 2%,5% --periods 0.01:10:200:log --in-g -o "
          "spectrum.csv\n"
          "  cromer spectrum h1.AT2 h2.AT2 --peaks peer --plot spectrum.svg\n"
          "  cromer spectrum drop.uff --shock --frequencies \"5:5000:200:log Hz\" --in-g --plot srs.svg"};
  add_output_options(syntax.options, output.common, {.provenance = true},
                     "the spectrum as .csv, .json or .h5");
  syntax.options.push_back({"fourier", &output.fourier, "", Range::any,
                            "the recording's Fourier amplitudes as .csv", "none", "Output"});
  syntax.options.push_back({"tripartite", &output.tripartite, "", Range::any,
                            "draw pseudo-velocity over lines of displacement and acceleration",
                            "pseudo-acceleration", "Output"});
  std::vector<std::string> names;
  if (const auto status = parse(syntax, arguments, names)) return *status;
  if (auto good = check_output(output, options.shock, names); !good) return refuse(good.error());
  std::vector<Recording> recordings;
  for (const auto& name : names) {
    auto recording = open_recording(name, options.read);
    if (!recording) return refuse(recording.error());
    recordings.push_back(*std::move(recording));
  }
  options.memory = os::memory() / 2;  // what is computed is written out once more as text

  const auto result = response_spectrum(recordings, options, watching(output.common.quiet));
  clear_progress();
  if (!result) return refuse(result.error());
  if (result->interrupted) {
    if (output.common.json) print(to_json(*result, false));
    complain("interrupted; nothing is written");
    tell(result->notices, output.common);
    return no_success;
  }
  const std::string head = provenance(output.common, "spectrum", arguments);
  return give(
      {.text = [&] { return spectrum_text(*result); },
       .json = [&] { return to_json(*result, false); },
       .csv = [&] { return spectrum_csv(*result, head); },
       .whole_json = [&] { return to_json(*result, true); },
       .tables = [&] { return spectrum_tables(*result, command_line("spectrum", arguments)); },
       .figure = [&] { return output.tripartite ? tripartite_figure(*result) : spectrum_figure(*result); },
       .other_files = [&]() -> Result<void> {
         if (output.fourier.empty()) return {};
         return write_file(output.fourier, fourier_csv(*result, head));
       },
       .notices = result->notices},
      output.common);
}

}  // namespace cromer::core::cli
