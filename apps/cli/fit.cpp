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
#include "fit_text.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::cli {
namespace {

Result<std::vector<FittedRecording>> fit_all(const std::vector<std::string>& files, const FitOptions& options,
                                             const Watch& watch) {
  std::vector<FittedRecording> fits;
  for (const auto& file : files) {
    if (watch.interrupted() && !fits.empty()) break;
    auto bytes = read_file(file);
    if (!bytes) return bytes.error();
    auto of_file = fit(*bytes, file, options, watch);
    if (!of_file) return of_file.error();
    std::move(of_file->begin(), of_file->end(), std::back_inserter(fits));
  }
  return fits;
}

std::size_t files_of(const std::vector<FittedRecording>& fits) {
  std::size_t files = 0;
  for (std::size_t i = 0; i < fits.size(); ++i) files += i == 0 || fits[i].file != fits[i - 1].file;
  return files;
}

Result<void> write_files(const std::vector<FittedRecording>& fits, const OutputOptions& output) {
  if (!output.output.empty()) {
    const bool csv = *file_format(output.output) == FileFormat::csv;
    if (auto good = write_file(output.output, csv ? fit_csv(fits) : to_json(fits)); !good) return good;
  }
  return output.plot.empty() ? Result<void>{} : write_plot(output.plot, fit_figure(fits));
}

}  // namespace

int run_fit(const Arguments& arguments) {
  FitOptions options;
  OutputOptions output;
  Syntax syntax{.command = "fit",
                .description =
                    "The law of motion of a free or a driven oscillation, with uncertainties, from its "
                    "recording. No start values are needed.",
                .files = "FILE...",
                .options = options_of(options),
                .example =
                    "  cromer fit lab.csv --mass \"217.6 ± 0.3 g\" --disc-diameter \"12 cm\" --segment \"30 "
                    "s\" --plot fit.svg\n"
                    "  cromer fit rig.csv --force-column Force --hold-out \"25 %\""};
  add_output_options(syntax.options, output, {}, "the table of quantities as .csv, or the document as .json");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (auto good = check_outputs(output, files); !good) return refuse(good.error().message);

  const Watch watch = watching(output.quiet);
  auto fits = fit_all(files, options, watch);
  clear_progress();
  if (!fits) return refuse(fits.error().message);
  bool ok = !watch.interrupted();
  if (!ok)
    complain(fmt::format("interrupted; what follows is what {} of {} files have given", files_of(*fits),
                         files.size()));
  for (const auto& fitted : *fits) {
    warn(fitted.warnings, output.quiet);
    if (fitted.fit.status == FitStatus::converged) continue;
    complain(fmt::format("{}: run {}: {}: {}", fitted.file, fitted.series.run, name(fitted.fit.status),
                         fitted.fit.message));
    ok = false;
  }
  if (auto good = write_files(*fits, output); !good) return refuse(good.error().message);
  if (output.output != "-" && !print(output.json ? to_json(*fits) : fit_text(*fits)))
    return refuse("standard output cannot be written");
  return ok ? done : no_success;
}

}  // namespace cromer::cli
