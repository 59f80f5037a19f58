#include "cromer/tasks/record/options.h"

#include <fmt/format.h>

#include <ctime>

#include "cromer/os/process.h"
#include "cromer/report/file.h"
#include "cromer/version.h"

namespace cromer::core {
namespace {

/// "2026-11-22T04:10:00Z"
std::string now_utc() {
  const std::tm date = os::universal_time(std::time(nullptr));
  return fmt::format("{}-{:02}-{:02}T{:02}:{:02}:{:02}Z", date.tm_year + 1900, date.tm_mon + 1, date.tm_mday,
                     date.tm_hour, date.tm_min, date.tm_sec);
}

}  // namespace

std::vector<Option> options_of(RecordOptions& o) {
  constexpr std::string_view source = "What to record";
  return {
      {"from", &o.from, "", Range::any,
       "serial:DEVICE[:BAUD], tcp:HOST:PORT, phyphox:HOST[:PORT], or - for standard input", "", source},
      {"rate", &o.rate, "Hz", Range::positive, "samples per second, for lines without a time",
       "found from their arrival where it is steady", source},
      {"for", &o.duration, "s", Range::positive, "how long, from the first sample on", "until Ctrl-C",
       source},
      {"time-unit", &o.time_unit, "", Range::any, "unit of the device's times: s, ms or us",
       "what its heading says, else s", source},
      {"heading", &o.headings, "", Range::any,
       "name and unit of the values, \"Position (mm)\"; several with commas", "the device's own, else Value",
       source},
      {"column", &o.column, "", Range::any, "which of several values the live fit takes",
       "the one that swings most clearly", source},
      {"output", &o.output, "", Range::any, "the recording, .csv; an existing one is not overwritten",
       "required", "Output"},
  };
}

Result<RecordSetup> check(const RecordOptions& options) {
  RecordSetup setup;
  auto source = parse_source(options.from);
  if (!source) return source.error();
  setup.source = *std::move(source);
  setup.lines = {options.rate, 0, options.headings};
  setup.column = options.column;
  if (!options.time_unit.empty()) {
    const auto unit = parse_unit(options.time_unit);
    if (!unit || unit->dimension != Dimension{.second = 1} || !(unit->factor > 0))
      return Error{"no_unit_of_time", {{"unit", options.time_unit}}};
    setup.lines.time_unit = unit->factor;
  }
  if (options.output.empty()) return Error{"recording_needs_a_file"};
  if (!options.output.ends_with(".csv")) return Error{"recording_is_csv", {{"path", options.output}}};
  if (auto good = check_writable(options.output); !good) return good.error();
  return setup;
}

std::unique_ptr<Recorder> make_recorder(const RecordSetup& setup, std::optional<double> duration,
                                        const std::string& path, const std::string& command,
                                        std::string (*words)(const Notice&)) {
  RecorderSettings settings{path, duration, {}, setup.column, words};
  if (!command.empty()) settings.comments = {command + " (cromer " CROMER_VERSION ")", "begun " + now_utc()};
  return std::make_unique<Recorder>(make_source(setup.source, setup.lines), std::move(settings));
}

}  // namespace cromer::core
