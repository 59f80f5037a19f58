// What the server records: at most one recording at a time, with its live fit, and the files made so far.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "apps/serve/http_server.h"
#include "cromer/tasks/record/live_fit.h"
#include "cromer/tasks/record/options.h"

namespace cromer::core::serve {

class LiveSession {
 public:
  /// Without a setup nothing can be recorded. `command` heads the files.
  LiveSession(std::optional<RecordSetup> setup, RecordOptions options)
      : setup_(std::move(setup)), options_(std::move(options)) {}

  /// Begins a recording into -o, or into NAME-2.csv, NAME-3.csv, ... if that is taken, and returns its name.
  /// Without a `duration` [s], that of the command line counts. Connecting may take seconds.
  Result<std::string> start(std::optional<double> duration);
  /// Ends the recording that is going on; its file is then complete. One that still waits for its device does
  /// not begin.
  void stop();

  std::string status() const;
  /// The path of a recording this session has made, by its name.
  std::optional<std::string> path_of(const std::string& name) const;
  /// What is new for a listener, as text of an event stream. A listener that comes during a recording gets
  /// its last ten seconds, and all of later recordings.
  std::string events(EventCursor& cursor) const;

 private:
  /// Ended and replaced as a whole; every user of one holds it.
  struct Active {
    std::string name;
    std::unique_ptr<Recorder> recorder;
    std::unique_ptr<LiveFitter> fitter;  ///< goes before the recorder that it reads
    std::size_t number;
    std::optional<double> duration;  // [s]
  };
  std::shared_ptr<Active> active() const;

  std::optional<RecordSetup> setup_;
  RecordOptions options_;
  mutable std::mutex mutex_;  ///< over what follows
  std::shared_ptr<Active> active_;
  std::map<std::string, std::string> paths_;
  std::size_t recordings_ = 0, stops_ = 0;
};

}  // namespace cromer::core::serve
