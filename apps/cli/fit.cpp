#include "cromer/study/task/fit.h"

#include <fmt/format.h>

#include <algorithm>

#include "commands.h"
#include "cromer/report/file.h"
#include "cromer/report/read_file.h"
#include "cromer/study/json/documents.h"
#include "exit_status.h"
#include "fit_csv.h"
#include "fit_figure.h"
#include "fit_files.h"
#include "fit_table.h"
#include "fit_text.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::cli {
namespace {

/// One file that cannot be read ends the command; of many it is a row.
Result<std::vector<FittedRecording>> fit_all(const RecordingFiles& found, const FitOptions& options,
                                             const Watch& watch) {
  if (found.many) return fit_files(found.files, options, watch);
  const auto bytes = read_file(found.files.front());
  if (!bytes) return bytes.error();
  return fit(*bytes, found.files.front(), options, watch);
}

std::size_t files_of(const std::vector<FittedRecording>& fits) {
  std::size_t files = 0;
  for (std::size_t i = 0; i < fits.size(); ++i) files += i == 0 || fits[i].file != fits[i - 1].file;
  return files;
}

Result<void> write_files(const std::vector<FittedRecording>& fits, const OutputOptions& output, bool many) {
  if (!output.output.empty()) {
    const bool csv = *file_format(output.output) == FileFormat::csv;
    if (auto good = write_file(output.output, csv ? fit_csv(fits) : to_json(fits, many)); !good) return good;
  }
  return output.plot.empty() ? Result<void>{} : write_plot(output.plot, fit_figure(fits));
}

/// Warnings and failures on standard error; whether all fits succeeded.
bool say_what_is_wrong(const std::vector<FittedRecording>& fits, bool many, bool quiet) {
  bool good = true;
  for (const auto& fitted : fits) {
    for (const auto& warning : fitted.warnings)
      warn({many ? fmt::format("{}: {}", fitted.file, warning) : warning}, quiet);
    if (fitted.succeeded()) continue;
    complain(fmt::format("{}: run {}: {}: {}", fitted.file, fitted.series.run, fitted.status(),
                         fitted.fit.message));
    good = false;
  }
  return good;
}

}  // namespace

int run_fit(const Arguments& arguments) {
  FitOptions options;
  OutputOptions output;
  Syntax syntax{.command = "fit",
                .description =
                    "The law of motion of a free oscillation, with uncertainties, from its recording. No "
                    "start values are needed.",
                .files = "FILE|FOLDER...",
                .options = options_of(options),
                .example =
                    "  cromer fit lab.csv --mass \"217.6 ± 0.3 g\" --disc-diameter \"12 cm\" --segment \"30 "
                    "s\" --plot fit.svg"};
  add_output_options(syntax.options, output, {},
                     "a table with a row for each recording as .csv, or the document as .json");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (auto good = check_fit_options(options); !good) return refuse(good.error().message);
  const auto found = recording_files(files);
  if (!found) return refuse(found.error().message);
  if (auto good = check_outputs(output, found->files); !good) return refuse(good.error().message);
  warn(found->notes, output.quiet);

  const Watch watch = watching(output.quiet);
  const auto fits = fit_all(*found, options, watch);
  clear_progress();
  if (!fits) return refuse(fits.error().message);
  const bool interrupted = watch.interrupted();
  if (interrupted)
    complain(fmt::format("interrupted; what follows is what {} of {} files have given", files_of(*fits),
                         found->files.size()));
  const bool good = say_what_is_wrong(*fits, found->many, output.quiet) && !interrupted;
  if (auto written = write_files(*fits, output, found->many); !written)
    return refuse(written.error().message);
  const auto text = [&] {
    return output.json ? to_json(*fits, found->many) : found->many ? fit_table(*fits) : fit_text(*fits);
  };
  if (output.output != "-" && !print(text())) return refuse("standard output cannot be written");
  return good ? done : no_success;
}

}  // namespace cromer::cli
