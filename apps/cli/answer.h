// What a command has found, in every form that may be asked for, and where each form goes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cromer/cluster/tables_file.h"
#include "cromer/report/figure.h"
#include "cromer/result.h"
#include "output.h"

namespace cromer::core::cli {

/// A form is made when it is asked for; one that a command does not offer is empty.
struct Answer {
  std::function<std::string()> text{}, json{};       ///< for standard output
  std::function<Result<std::string>()> csv{};        ///< for -o FILE.csv
  std::function<std::string()> whole_json{};         ///< for -o FILE.json; as `json` if empty
  std::function<std::vector<Hdf5Table>()> tables{};  ///< for -o FILE.h5
  std::function<Result<Figure>()> figure{};          ///< for --plot
  std::function<Result<void>()> other_files{};       ///< what else the command writes
  std::vector<std::string> failures{};               ///< what did not succeed, a line each
  std::vector<Notice> notices{};
  bool good = true;  ///< the computation succeeded
};

/// Writes the files, prints the answer, draws the figure (whose failure does not take the rest with it), then
/// says what failed and what else there is to know. The exit status.
int give(const Answer& answer, const OutputOptions& output);

}  // namespace cromer::core::cli
