// What a command writes and where: options common to all commands, checks before the work, files after it.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/cluster/tables_file.h"
#include "cromer/report/figure.h"
#include "cromer/report/file.h"
#include "cromer/result.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core::cli {

struct OutputOptions {
  bool json = false;
  bool quiet = false;
  bool verbose = false;
  bool provenance = false;
  std::string output;  ///< "" none
  std::string plot;    ///< "" none
  std::string panels;  ///< of the plot, as parse_panels reads them
  bool hdf5 = false;   ///< whether .h5 is offered; not an option
};

/// Which of them a command offers.
struct OutputKinds {
  bool files = true;
  bool plot = true;
  bool provenance = false;  ///< of CSV files that hold one table of numbers
  bool panels = false;      ///< of a plot of motions
};

/// Appends --json, -o, --plot, --panels, --provenance, --quiet and --verbose, with `what` as the help of -o.
void add_output_options(std::vector<Option>& options, OutputOptions& output, OutputKinds kinds,
                        std::string_view what);

enum class FileFormat { csv, json, hdf5 };

/// By the ending of the name; "-" is CSV on standard output. Unknown endings are Errors, and .h5 where it is
/// not offered.
Result<FileFormat> file_format(const std::string& path, bool hdf5 = false);

/// Checks, before long work, that all outputs have a known format, can be written, and are none of the
/// inputs. `option` is what messages call `output`.
Result<void> check_outputs(const OutputOptions& options, const std::vector<std::string>& inputs = {},
                           const char* option = "-o");

/// "cromer COMMAND ...", for the head of a CSV file; "" unless it was asked for.
std::string provenance(const OutputOptions& output, std::string_view command,
                       const std::vector<std::string>& arguments);

/// Says the notices on standard error, unless --quiet.
void tell(const std::vector<Notice>& notices, const OutputOptions& output);

/// On standard output, what could drive a terminal spelled out; false if it could not take all of it.
bool print(std::string_view text);

/// Says that standard output could not take it. The exit status.
int output_refused();

/// print, and what there is to say where it fails. The exit status.
int print_all(std::string_view text);

/// Writes a CSV table. One without anything in it is an Error, and what the file held stays.
Result<void> write_table(const std::string& path, const std::string& csv);

/// What a command has found, in every form that may be asked for. A form is made when it is asked for; one
/// that a command does not offer is empty.
struct Answer {
  std::function<std::string()> text{}, json{};                       ///< for standard output
  std::function<Result<std::string>()> csv{};                        ///< for -o FILE.csv
  std::function<Result<void>(const PieceSink& write)> csv_pieces{};  ///< in its place, where it is long
  std::function<std::string()> whole_json{};                         ///< for -o FILE.json; as `json` if empty
  std::function<std::vector<Hdf5Table>()> tables{};                  ///< for -o FILE.h5
  std::function<Result<Figure>()> figure{};                          ///< for --plot
  std::function<Result<void>()> other_files{};                       ///< what else the command writes
  std::vector<std::string> failures{};                               ///< what did not succeed, a line each
  std::vector<Notice> notices{};
  bool good = true;  ///< the computation succeeded
};

/// Writes the files, prints the answer and draws the figure; then says what failed, what else there is to
/// know, and last what could not be written: none of these takes the others with it. The exit status.
int give(const Answer& answer, const OutputOptions& output);

}  // namespace cromer::core::cli
