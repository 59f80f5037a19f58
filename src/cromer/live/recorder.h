// A recording in progress: one thread takes what the source sends, another writes it to the disk, others may
// look at it.
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cromer/live/recording_file.h"
#include "cromer/live/source.h"

namespace cromer::core {

struct RecorderSettings {
  std::string path;                     ///< of the file
  std::optional<double> duration;       ///< [s] > 0, from the first sample on; until stopped where not given
  std::vector<std::string> comments{};  ///< for the head of the file
  std::string column{};  ///< the column asked for by name; if there is none, a notice lists those there are
  std::string (*words)(const Notice&) = nullptr;  ///< makes the sentences at the end of the file
};

/// The state at one moment. Rows that did not fit into the file are not counted.
struct RecorderStatus {
  bool running = false;
  std::size_t samples = 0;
  double begin = 0, end = 0;  // [s] times of the first and the last sample
  double rate = 0;            ///< [1/s] over all samples; 0 for less than two
  std::vector<double> last{};
  std::size_t garbage = 0;  ///< lines that were no samples
  std::size_t notices = 0;
  SampleTimes times{};
  Notice failure{};  ///< why it ended too early: a full disk
};

class Recorder {
 public:
  Recorder(std::unique_ptr<Source> source, RecorderSettings settings)
      : source_(std::move(source)), settings_(std::move(settings)) {}
  ~Recorder() { stop(); }

  /// Connects, makes the file and starts the two threads. After an Error nothing is left.
  Result<void> start();

  /// Ends the recording; on return the file is complete and on the disk. May be called more than once and
  /// from any thread.
  void stop();

  RecorderStatus status() const;
  Headings headings() const;
  /// The rows from `first` on, at most `most` of them; the notices likewise.
  SampleRows rows_since(std::size_t first, std::size_t most = static_cast<std::size_t>(-1)) const;
  /// Index of the first row of the last `seconds`.
  std::size_t first_within(double seconds) const;
  std::vector<Remark> notices_since(std::size_t first) const;

 private:
  void record();
  void keep_on_disk();
  Result<void> write_rows(std::size_t& written, bool& headed);
  bool publish(SampleRows& rows, std::vector<Remark>& notices);
  void fail(const Error& error);
  Result<void> write_end();
  std::size_t held() const;

  std::unique_ptr<Source> source_;
  RecorderSettings settings_;
  RecordingFile file_;
  std::mutex stopping_;  ///< over the two threads from their start on
  std::thread thread_, disk_;
  std::atomic<bool> stop_{false}, running_{false};
  mutable std::mutex mutex_;  ///< over what follows; only the recording thread changes headings and rows
  std::condition_variable more_;
  bool over_ = false;  ///< nothing more will come
  Headings headings_;
  SampleRows rows_;
  std::optional<std::size_t> kept_;  ///< of the rows, by a file that can take no more
  std::vector<Remark> notices_;
  std::size_t garbage_ = 0;
  SampleTimes times_;
  Notice failure_;
};

}  // namespace cromer::core
