#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

#include "commands.h"
#include "cromer/documents/json/live.h"
#include "cromer/documents/text/words.h"
#include "cromer/documents/words/words.h"
#include "cromer/os/process.h"
#include "cromer/tasks/record/live_fit.h"
#include "cromer/tasks/record/options.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::core::cli {
namespace {

/// "1234 samples, 100.0 a second, last 0.0213; frequency 0.9552(3) Hz"
std::string status_line(const RecorderStatus& status, const FittedRecording* fit) {
  std::string line = fmt::format("{} samples", status.samples);
  if (status.rate > 0) line += fmt::format(", {:.1f} a second", status.rate);
  if (status.times.by == TimesBy::rate) line += fmt::format(" (found {:.7g}/s)", status.times.rate);
  for (std::size_t i = 0; i < std::min<std::size_t>(status.last.size(), 3); ++i)
    line += fmt::format("{}{:.5g}", i == 0 ? ", last " : " ", status.last[i]);
  if (status.notices > 0) line += fmt::format(", {} notices", status.notices);
  const Estimate* frequency = fit && fit->succeeded() ? fit->find("frequency") : nullptr;
  if (frequency) line += "; frequency " + format_concise({frequency->value, frequency->standard_error}, "Hz");
  return line;
}

/// Until the recording ends by itself or by a signal.
void watch_it(const Recorder& recorder, const std::string& column, const Watch& watch, bool quiet) {
  const bool shown = !quiet && os::is_terminal(os::standard_error);
  std::optional<LiveFitter> fitter;
  if (shown) fitter.emplace(recorder, column);
  for (int i = 0; !watch.interrupted() && recorder.status().running; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    if (!shown || i % 5 != 0) continue;
    std::fprintf(stderr, "\r\033[K%s", status_line(recorder.status(), fitter->latest().get()).c_str());
  }
  if (shown) std::fputs("\r\033[K", stderr);
}

std::string summary(const std::string& path, const RecorderStatus& status) {
  const std::string times = in_words(sentence(status.times));
  std::string text = fmt::format("{}: {} samples", path, status.samples);
  if (status.rate > 0)
    text += fmt::format(" in {}, {} a second", format_quantity({status.end - status.begin, 0}, "s"),
                        rounded(status.rate, 6));
  return text + "\n" + (times.empty() ? "" : times + "\n");
}

/// The first remarks, and how many more there are.
std::vector<Notice> what_happened(const Recorder& recorder, const RecorderStatus& end) {
  constexpr std::size_t most = 20;
  const auto remarks = recorder.notices_since(0);
  std::vector<Notice> all;
  for (std::size_t i = 0; i < std::min(remarks.size(), most); ++i) all.push_back(remarks[i].what);
  if (end.garbage > 1) all.push_back(Notice{"lines_no_samples", {{"lines", end.garbage}}});
  if (end.samples > 0 && remarks.size() > most) all.push_back(Notice{"file_lists_more"});
  return all;
}

/// Says what happened, what was recorded and how it ended; the exit status.
int conclude(const Recorder& recorder, const RecordOptions& options, const OutputOptions& output) {
  RecorderStatus end = recorder.status();
  const auto notices = recorder.notices_since(0);
  if (end.samples == 0 && end.failure.empty())
    end.failure = Notice{"no_sample_came", {{"source", options.from}}};
  if (!print(output.json       ? recording_json(options.output, end, recorder.headings(), notices)
             : end.samples > 0 ? summary(options.output, end)
                               : ""))
    return output_refused();
  tell(what_happened(recorder, end), output);
  if (end.failure.empty()) return done;
  complain(in_words(end.failure));
  return no_success;
}

}  // namespace

int run_record(const Arguments& arguments) {
  RecordOptions options;
  OutputOptions output;
  Syntax syntax{.command = "record",
                .description =
                    "Records samples as they come: lines `time value` or `value` of a serial device, a TCP "
                    "connection or standard input, or a phone that runs phyphox with remote access allowed. "
                    "They are on the disk within a second; if the recording is interrupted, what came until "
                    "then is a valid file. Ctrl-C ends it normally.",
                .files = "",
                .options = options_of(options),
                .example =
                    "  cromer record --from serial:/dev/ttyACM0:115200 --for \"60 s\" -o swing.csv\n"
                    "  cromer record --from phyphox:192.168.1.7 --for \"20 s\" -o phone.csv"};
  add_output_options(syntax.options, output, {.files = false, .plot = false, .provenance = true}, "");
  std::vector<std::string> none;
  if (const auto status = parse(syntax, arguments, none)) return *status;
  if (options.from.empty()) return refuse("cromer record needs --from SOURCE; see cromer record --help");
  const auto setup = check(options);
  if (!setup) return refuse(setup.error());

  const Watch watch = watching(true);
  const auto recorder =
      make_recorder(*setup, options.duration, options.output, provenance(output, "record", arguments),
                    [](const Notice& notice) { return in_words(notice); });
  if (auto good = recorder->start(); !good) return refuse(good.error());
  watch_it(*recorder, options.column, watch, output.quiet);
  recorder->stop();
  return conclude(*recorder, options, output);
}

}  // namespace cromer::core::cli
