// A recording in progress as JSON documents, each on one line.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cromer/live/recorder.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// {"source" (null where nothing can be recorded), "for" (seconds of this recording, or of the next one where
/// none is given; null: until stopped), "recording", "running", "samples", "from", "to", "duration", "rate",
/// "times", "last", "garbage", "columns", "message"}; times: null or {"by"} and for samples without a time
/// {"rate" (found; null where none was), "longest_delay", "by_rate", "by_arrival"}
std::string live_status_json(const std::string& source, std::optional<double> duration,
                             const std::string& recording, const RecorderStatus& status,
                             const Headings& headings);

/// {"first", "t": [...], "values": [[...], ...]}, one list of values for each column.
std::string live_samples_json(std::size_t first, const Rows& rows);

/// {"column", "status", "samples", "from", "to", "law", "parameters", "derived"}
std::string live_fit_json(const FittedRecording& fitted);

/// {"notices": [{"kind", "text"}, ...]}
std::string live_notices_json(std::span<const Remark> notices);

/// The end of a recording: its status with the notices.
std::string recording_json(const std::string& recording, const RecorderStatus& status,
                           const Headings& headings, std::span<const Remark> notices);

/// {"message"}
std::string message_json(const std::string& message);

}  // namespace cromer::core
