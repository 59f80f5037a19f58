// A recording in progress as JSON, each document on one line.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "cromer/live/recorder.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// {"source", "for", "recording", "running", "samples", "from", "to", "duration", "rate", "times", "last",
/// "garbage", "columns"}, with "message" and "message_german" if it failed.
/// "source": null if there is nothing to record from. "for": [s] length of this recording, or of the next
/// one; null: until stopped. "times": null before the first sample, else {"by"}; if samples came without a
/// time, also "rate" (null if none was found), "longest_delay", "by_rate" and "by_arrival".
std::string live_status_json(const std::string& source, std::optional<double> duration,
                             const std::string& recording, const RecorderStatus& status,
                             const Headings& headings);

/// {"first", "t": [...], "values": [[...], ...]} with one list of values for each column.
std::string live_samples_json(std::size_t first, const SampleRows& rows);

/// {"column", "status", "samples", "from", "to", "law", "parameters", "derived"}; without success "message"
/// and "message_german" in place of the last three.
std::string live_fit_json(const FittedRecording& fitted);

/// {"notices": [{"kind", "text", "german"}, ...]}
std::string live_notices_json(std::span<const Remark> notices);

/// The status of a finished recording with its notices; indented, not on one line.
std::string recording_json(const std::string& recording, const RecorderStatus& status,
                           const Headings& headings, std::span<const Remark> notices);

/// {"message"}
std::string message_json(const std::string& message);

}  // namespace cromer::core
