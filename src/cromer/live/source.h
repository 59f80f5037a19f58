// Something that samples come from while they are measured, and its name as it is typed:
// serial:DEVICE[:BAUD], tcp:HOST:PORT, phyphox:HOST[:PORT] or -.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/live/line_reader.h"
#include "cromer/live/rows.h"
#include "cromer/result.h"

namespace cromer::core {

enum class SourceKind { serial, tcp, phyphox, standard_input };

struct SourceName {
  SourceKind kind = SourceKind::standard_input;
  std::string place{};  ///< the device's path, or the host (an IPv6 address without its brackets)
  int number = 0;       ///< baud (115200 by default), or the port (phyphox: 8080)
};

/// An Error says what was typed and what can be.
Result<SourceName> parse_source(std::string_view text);

class Source {
 public:
  virtual ~Source() = default;

  /// Connects for the first time. An Error if the source cannot be reached.
  virtual Result<void> open() = 0;

  /// Waits about `seconds` at most and adds what came; false when nothing more will come. A lost connection
  /// is tried again at each call, with a notice when it is lost and when it is back.
  virtual bool receive(double seconds, SampleRows& rows, std::vector<Remark>& notices) = 0;

  /// Adds the samples still held back; nothing is received afterwards.
  virtual void finish(SampleRows&, std::vector<Remark>&) {}

  /// Empty until the first row.
  virtual const Headings& headings() const = 0;

  virtual SampleTimes times() const { return {TimesBy::device}; }

  /// Seconds of the device over those of the computer; 0: unknown.
  virtual double pace() const { return 0; }
};

/// Not connected yet.
std::unique_ptr<Source> make_source(const SourceName& name, const LineSettings& lines);

/// Seconds of a clock that never jumps; all arrivals are in them.
double steady_seconds();

}  // namespace cromer::core
