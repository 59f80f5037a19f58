// Devices to record from: a pseudo-terminal as a serial line, and a phone that speaks phyphox's protocol.
#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace cromer::core::test {

/// A free decay, as all devices here measure it.
double swing(double t);
constexpr double swing_frequency = 1.5;    // [Hz]
constexpr double swing_decay_rate = 0.05;  // [1/s]

/// The two ends of a pseudo-terminal: the program opens `path`, the test writes into the other end.
class SerialLine {
 public:
  SerialLine();
  ~SerialLine() { unplug(); }
  const std::string& path() const { return path_; }
  void write(std::string_view bytes) const;
  /// Closes both ends; the path is gone.
  void unplug();
  /// Makes a new line at the same path, by way of a symbolic link.
  void plug_in_again();

 private:
  void open();
  int device_ = -1, other_ = -1;
  std::string path_;  ///< a symbolic link to the device
};

/// Answers /config, /get and /control as phyphox does, on a port of its own. Samples come by the clock.
class Phone {
 public:
  Phone(double rate, bool measuring);
  ~Phone();
  int port() const { return port_; }
  bool started_by_us() const { return started_; }
  /// As a person would on the phone: clears the data; the times begin at 0.
  void clear();
  /// Cannot be reached for a while.
  void go_away(double seconds);
  /// As many samples as had been measured; their values are swing(t).
  std::size_t samples() const;

 private:
  void open();
  void serve();
  void serve_one(int connection);
  std::string answer(const std::string& target);
  std::size_t measured() const;

  double rate_;
  int listener_ = -1, port_ = 0;
  std::atomic<bool> stop_{false}, started_{false};
  std::atomic<double> away_until_{0};
  mutable std::mutex mutex_;
  double begun_ = -1;  // [s] < 0 while it is not measuring
  std::thread thread_;
};

/// Takes connections and never says a word.
class SilentPort {
 public:
  SilentPort();
  ~SilentPort();
  int port() const { return port_; }

 private:
  int listener_ = -1, port_ = 0;
};

/// Seconds of a clock that never jumps.
double now();
void sleep_until(double time);

/// Writes swing(t) at `rate` for `seconds` in its own time, each line made by `line(n, t)`; late ones follow
/// at once.
template <class Line>
void write_by_the_clock(const SerialLine& serial, double rate, double seconds, const Line& line) {
  const double begin = now();
  for (int n = 0; n < static_cast<int>(rate * seconds); ++n) {
    sleep_until(begin + n / rate);
    serial.write(line(n, n / rate));
  }
}

}  // namespace cromer::core::test
