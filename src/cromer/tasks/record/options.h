// The options of a recording, for record and serve.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cromer/live/recorder.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {

struct RecordOptions {
  std::string from;                ///< a source; "" if none
  double rate = 0;                 ///< [1/s] of lines without a time
  std::optional<double> duration;  // [s]
  std::string time_unit;
  std::string headings;
  std::string column;  ///< for the live fit
  std::string output;
};

std::vector<Option> options_of(RecordOptions& options);

/// Of options that have been checked.
struct RecordSetup {
  SourceName source;
  LineSettings lines;
  std::string column;
};

/// Checks source, unit of time and the name of the file.
Result<RecordSetup> check(const RecordOptions& options);

/// A recorder to `path`, not started yet. With a command line the file's head holds it and the time of the
/// start; `words` makes sentences of the notices at its end.
std::unique_ptr<Recorder> make_recorder(const RecordSetup& setup, std::optional<double> duration,
                                        const std::string& path, const std::string& command,
                                        std::string (*words)(const Notice&));

}  // namespace cromer::core
