#include "output.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <utility>

#include "commands.h"
#include "cromer/base/utf8.h"
#include "cromer/cluster/tables_file.h"
#include "cromer/figures/panels.h"
#include "cromer/report/file.h"
#include "message.h"
#include "syntax.h"

namespace cromer::core::cli {

void add_output_options(std::vector<Option>& options, OutputOptions& output, OutputKinds kinds,
                        std::string_view what) {
  constexpr std::string_view group = "Output";
  options.push_back({"json", &output.json, "", Range::any, "one JSON document on standard output",
                     "a text for people", group});
  if (kinds.files) options.push_back({"output", &output.output, "", Range::any, what, "none", group});
  if (kinds.plot)
    options.push_back(
        {"plot", &output.plot, "", Range::any, "draw a figure: .svg, .png or .pdf", "none", group});
  if (kinds.panels)
    options.push_back({"panels", &output.panels, "", Range::any, panels_help, "position", group});
  if (kinds.provenance)
    options.push_back({"provenance", &output.provenance, "", Range::any,
                       "what made a CSV file stands at its head, in lines that begin with #",
                       "the first line has the names of the columns", group});
  options.push_back({"quiet", &output.quiet, "", Range::any, "no warnings, no progress",
                     "warnings on standard error, after the answer", group});
  options.push_back({"verbose", &output.verbose, "", Range::any, "all warnings and notes, on a terminal too",
                     "on a terminal the three worst", group});
}

std::string provenance(const OutputOptions& output, std::string_view command, const Arguments& arguments) {
  return output.provenance ? command_line(command, arguments) : "";
}

Result<FileFormat> file_format(const std::string& path, bool hdf5) {
  if (path == "-") return FileFormat::csv;
  const auto slash = path.find_last_of('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  const auto dot = name.find_last_of('.');
  const std::string ending = dot == std::string::npos ? "" : name.substr(dot);
  if (ending == ".csv") return FileFormat::csv;
  if (ending == ".json") return FileFormat::json;
  if (ending == ".h5" && hdf5) return FileFormat::hdf5;
  if (ending == ".h5") return Error{"no_hdf5_here", {{"file", path}}};
  return Error{hdf5 ? "unknown_ending_hdf5" : "unknown_ending", {{"file", path}, {"ending", ending}}};
}

Result<void> check_outputs(const OutputOptions& options, const std::vector<std::string>& inputs,
                           const char* option) {
  for (const auto& input : inputs)
    for (const auto& [name, path] :
         {std::pair{option, &options.output}, std::pair{"--plot", &options.plot}}) {
      std::error_code none;
      if (!path->empty() && std::filesystem::equivalent(input, *path, none))
        return Error{"output_is_the_input", {{"option", name}, {"file", *path}}};
    }
  if (!options.output.empty()) {
    const auto format = file_format(options.output, options.hdf5);
    if (!format) return format.error();
    if (options.output == "-" && options.json) return Error{"two_on_standard_output"};
    if (options.output != "-")
      if (auto good = check_writable(options.output); !good) return good;
    if (*format == FileFormat::hdf5)
      if (auto good = can_write_tables(options.output); !good) return good;
  }
  if (auto panels = parse_panels(options.panels); !panels) return panels.error();
  if (!options.panels.empty() && options.plot.empty()) return Error{"panels_without_plot"};
  if (!options.plot.empty()) {
    if (auto format = figure_format(options.plot); !format)
      return Error{"option_is_wrong", {{"option", "plot"}, {"what", format.error().notice}}};
    if (auto good = check_writable(options.plot); !good) return good;
  }
  return {};
}

namespace {

/// Draws the figure and writes it to a path that check_outputs has seen.
Result<void> write_plot(const std::string& path, const Figure& figure) {
  auto picture = draw(figure, *figure_format(path));
  if (!picture) return picture.error();
  return write_file(path, *picture);
}

}  // namespace

Result<void> write_table(const std::string& path, const std::string& csv) {
  // A file that is there is not lost to nothing.
  if (csv.empty()) return Error{"nothing_to_write", {{"file", path}}};
  return write_file(path, csv);
}

namespace {

Result<void> write_output(const Answer& answer, const OutputOptions& output) {
  const std::string& file = output.output;
  if (file.empty()) return {};
  switch (*file_format(file, output.hdf5)) {
    case FileFormat::hdf5:
      // A sweep's rows are in its file already.
      return answer.tables ? write_tables(file, answer.tables()) : Result<void>{};
    case FileFormat::json:
      return write_file(file, answer.whole_json ? answer.whole_json() : answer.json());
    case FileFormat::csv:
      break;
  }
  if (answer.csv_pieces)
    return write_file(file, [&](const PieceSink& write) { return answer.csv_pieces(write); });
  const auto text = answer.csv();
  return text ? write_table(file, *text) : text.error();
}

}  // namespace

void tell(const std::vector<Notice>& notices, const OutputOptions& output) {
  if (!output.quiet) tell(notices, output.verbose);
}

bool print(std::string_view text) {
  const std::string shown = printable(text);
  return std::fwrite(shown.data(), 1, shown.size(), stdout) == shown.size() && std::fflush(stdout) == 0;
}

int output_refused() { return refuse(Error{"standard_output_not_written"}); }

int print_all(std::string_view text) { return print(text) ? done : output_refused(); }

int give(const Answer& answer, const OutputOptions& output) {
  std::vector<Error> unwritten;
  const auto keep = [&](const Result<void>& written) {
    if (!written) unwritten.push_back(written.error());
  };
  keep(write_output(answer, output));
  if (answer.other_files) keep(answer.other_files());
  const bool printed = output.output == "-" || print(output.json ? answer.json() : answer.text());
  if (!output.plot.empty() && answer.figure) {
    const auto figure = answer.figure();
    keep(figure ? write_plot(output.plot, *figure) : figure.error());
  }
  for (const std::string& failure : answer.failures) complain(failure);
  tell(answer.notices, output);
  for (const Error& error : unwritten) complain(error);
  if (!printed) return output_refused();
  if (!answer.good) return no_success;
  return unwritten.empty() ? done : wrong_input;
}

}  // namespace cromer::core::cli
