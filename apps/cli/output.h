// What a command writes and where: options common to all commands, checks before the work, files after it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/report/figure.h"
#include "cromer/result.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core::cli {

struct OutputOptions {
  bool json = false;
  bool quiet = false;
  bool verbose = false;
  std::string output;  ///< "" none
  std::string plot;    ///< "" none
  bool hdf5 = false;   ///< whether .h5 is offered; not an option
};

/// Which of them a command offers.
struct OutputKinds {
  bool files = true;
  bool plot = true;
};

/// Appends --json, -o, --plot, --quiet and --verbose, with `what` as the help of -o.
void add_output_options(std::vector<Option>& options, OutputOptions& output, OutputKinds kinds,
                        std::string_view what);

enum class FileFormat { csv, json, hdf5 };

/// By the ending of the name; "-" is CSV on standard output. Unknown endings are Errors, and .h5 where it is
/// not offered.
Result<FileFormat> file_format(const std::string& path, bool hdf5 = false);

/// That all outputs have a known format, can be written, and are none of the inputs; asked before long work.
/// `option` is what `output` is called.
Result<void> check_outputs(const OutputOptions& options, const std::vector<std::string>& inputs = {},
                           const char* option = "-o");

/// Draws the figure and writes it.
Result<void> write_plot(const std::string& path, const Figure& figure);

/// What there is to say beside the answer, unless --quiet.
void tell(const std::vector<Notice>& notices, const OutputOptions& output);

/// On standard output, what could drive a terminal spelled out; false if it could not take all of it.
bool print(std::string_view text);

}  // namespace cromer::core::cli
