#include "cromer/study/task/sweep.h"

#include <fmt/format.h>
#include <unistd.h>

#include "command_line.h"
#include "commands.h"
#include "cromer/report/csv.h"
#include "cromer/report/file.h"
#include "cromer/study/json/documents.h"
#include "exit_status.h"
#include "message.h"
#include "output.h"
#include "sweep_figure.h"
#include "sweep_text.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::cli {
namespace {

/// A quarter of the machine's memory: the rows are written out once more as text.
double memory_for_rows() {
  return 0.25 * static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

std::string sweep_csv(const SweepResult& result, const Arguments& arguments) {
  const std::size_t width = result.plan.rows.columns.size() - 1;
  const std::size_t rows = result.rows.size() / width;
  std::vector<std::vector<double>> cells(width, std::vector<double>(rows));
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t column = 0; column < width; ++column) cells[column][i] = result.rows[i * width + column];
  std::vector<CsvColumn> columns;
  for (std::size_t column = 0; column < width; ++column)
    columns.push_back({result.plan.rows.columns[column], std::span<const double>(cells[column])});
  std::string out;
  append_csv(out, columns, std::vector<std::string>{command_line("sweep", arguments)}, true);
  return out;
}

Result<void> write_files(const SweepResult& result, const OutputOptions& output, const Arguments& arguments) {
  if (!output.output.empty()) {
    const bool csv = *file_format(output.output) == FileFormat::csv;
    const std::string text = csv ? sweep_csv(result, arguments) : to_json(result);
    if (auto good = write_file(output.output, text); !good) return good;
  }
  if (output.plot.empty()) return {};
  const auto figure = sweep_figure(result);
  return figure ? write_plot(output.plot, *figure) : figure.error();
}

}  // namespace

int run_sweep(const Arguments& arguments) {
  SweepOptions options;
  OutputOptions output;
  Syntax syntax{
      .command = "sweep",
      .description =
          "The same run over grids of its options: low:high:points, low:high:points:log, or a list with "
          "commas. Grids multiply.",
      .files = "",
      .options = options_of(options),
      .example =
          "  cromer sweep --damping-ratio 0.02,0.05,0.1 --drive-amplitude 1 --drive-frequency 0.1:3:1000 \\\n"
          "    -o resonance.csv --plot resonance.svg\n"
          "  cromer sweep --cubic 0.05 --damping 0.1 --drive-amplitude 0.3 --drive-frequency 0.5:2:400 \\\n"
          "    --direction up --plot jump.svg"};
  add_output_options(syntax.options, output, {}, "the rows as .csv or .json");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (auto good = check_outputs(output); !good) return refuse(good.error().message);
  options.memory = memory_for_rows();

  const auto result = sweep(options, watching(output.quiet));
  clear_progress();
  if (!result) return refuse(result.error().message);
  warn(result->plan.warnings, output.quiet);
  if (const std::string trouble = sweep_trouble(*result); !trouble.empty()) complain(trouble);
  if (result->interrupted)
    complain(fmt::format("interrupted after {} of {} points", result->done, result->plan.rows.rows));
  if (auto good = write_files(*result, output, arguments); !good) return refuse(good.error().message);
  if (output.output != "-" && !print(output.json ? to_json(*result) : sweep_text(*result)))
    return refuse("standard output cannot be written");
  return result->counts.ok() && !result->interrupted ? done : no_success;
}

}  // namespace cromer::cli
