#include "cromer/tasks/compare/compare.h"
#include "cromer/documents/words/words.h"

#include <fmt/format.h>

#include <cmath>

#include "commands.h"
#include "cromer/documents/csv/compare.h"
#include "cromer/documents/json/documents.h"
#include "cromer/documents/text/fit.h"
#include "cromer/documents/text/text_table.h"
#include "cromer/figures/compare.h"
#include "cromer/read/column_kind.h"
#include "cromer/report/file.h"
#include "exit_status.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::core::cli {
namespace {

std::string with_unit(std::string name, const CompareResult& comparison) {
  const std::string_view unit = si_unit_of(comparison.recording.series.quantity);
  return unit.empty() ? name : fmt::format("{} ({})", name, unit);
}

/// Nothing of what was not reached; a fixed number of decimals where that is short.
std::string number(double value, int decimals) {
  if (!std::isfinite(value)) return "";
  const double size = std::abs(value);
  return size < 1e4 && (size >= 0.01 || size == 0) ? fmt::format("{:.{}f}", value, decimals)
                                                   : fmt::format("{:.{}g}", value, decimals);
}

/// What is known about the apparatus, and what else was asked, says nothing of the curves: it is answered by
/// the fit.
bool asks_for_the_fit(const FitOptions& options) {
  return options.mass || options.disc_diameter || !options.goal.empty() || options.textbook;
}

std::string table(const std::vector<CompareResult>& comparisons) {
  std::string out;
  for (const auto& comparison : comparisons) {
    const FittedRecording& recording = comparison.recording;
    if (asks_for_the_fit(recording.options)) out += fit_text({recording}) + "\n";
    out += fmt::format("{}, {}, run {}\n", recording.file, recording.series.column, recording.series.run);
    std::vector<std::vector<std::string>> rows{{with_unit("rms", comparison), "R squared",
                                                "amplitude ratio at the end", "phase drift (rad)", "method",
                                                "simulated"}};
    for (const auto& curve : comparison.curves)
      rows.push_back(
          {std::isfinite(curve.rms) ? fmt::format("{:.4g}", curve.rms) : "", number(curve.r_squared, 6),
           number(curve.amplitude_ratio_end, 4), number(curve.phase_drift, 4), curve.method,
           curve.measured_at_rest ? curve.label + ", at the end the measured motion rests" : curve.label});
    if (!comparison.curves.empty()) out += text_table(rows, 0, 4);
    if (const Notice sentence = explanation(comparison); !sentence.empty()) out += in_words(sentence) + "\n";
  }
  return out;
}

/// All but the figure, whose failure shall not take the rest with it.
Result<void> write_files(const std::vector<CompareResult>& comparisons, const OutputOptions& output) {
  if (!output.output.empty()) {
    const bool csv = *file_format(output.output) == FileFormat::csv;
    if (auto good = write_file(output.output, csv ? compare_csv(comparisons) : to_json(comparisons)); !good)
      return good;
  }
  return {};
}

}  // namespace

int run_compare(const Arguments& arguments) {
  CompareOptions options;
  OutputOptions output;
  Syntax syntax{
      .command = "compare",
      .description =
          "A recording beside simulations of it: one constant decay rate, and the law that fit chose.",
      .files = "FILE",
      .options = options_of(options),
      .example =
          "  cromer compare lab.csv --mass \"217.6 g\" --method rk4 --segment \"30 s\" --plot compare.svg"};
  add_output_options(syntax.options, output, {},
                     "measured and simulated motion as .csv, or the document as .json");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (auto good = check_outputs(output, files); !good) return refuse(good.error());
  auto bytes = read_file(files.front());
  if (!bytes) return refuse(bytes.error());
  auto comparisons = compare(*bytes, files.front(), options, watching(output.quiet));
  clear_progress();
  if (!comparisons) return refuse(comparisons.error());
  if (auto good = write_files(*comparisons, output); !good) return refuse(good.error());
  if (output.output != "-" && !print(output.json ? to_json(*comparisons) : table(*comparisons)))
    return refuse("standard output cannot be written");
  if (!output.plot.empty())
    if (auto drawn = write_plot(output.plot, compare_figure(*comparisons)); !drawn)
      return refuse(drawn.error());
  bool ok = true;
  for (const auto& comparison : *comparisons) {
    tell(comparison.notices, output);
    ok = ok && comparison.complete;
    const LawFit& fit = comparison.recording.fit;
    if (fit.status == FitStatus::converged) continue;
    complain(fmt::format("{}: run {}: {}: {}", files.front(), comparison.recording.series.run,
                         name(fit.status), in_words(fit.message)));
    ok = false;
  }
  return ok ? done : no_success;
}

}  // namespace cromer::core::cli
