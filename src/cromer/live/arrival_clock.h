// Times for samples that come without one.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cromer/live/rate_line.h"
#include "cromer/live/rows.h"

namespace cromer::core {

/// Samples are held back for 0.4 s, the first ones for up to 0.8 s until a rate is found. Then they are
/// stamped by the rate at which they were sent, if one is found (steady_rate), else by their arrival. The
/// samples that follow tell whether one was held up on its way or is late for good (a pause, or missing
/// samples); in the second case the line goes on behind it. Arrivals are seconds of a clock that never jumps.
/// Times begin at 0, rise strictly and are rounded to the microsecond.
class ArrivalClock {
 public:
  static constexpr double hold = 0.4, first_hold = 0.8;  // [s]

  /// One more sample has come; `arrival` never falls.
  void take(double arrival) { arrivals_.push_back(arrival); }

  /// Adds the times of the samples that have waited long enough, or of all, in the order of their arrival.
  void release(double now, std::vector<double>& times, std::vector<Remark>& notices);
  void release_all(std::vector<double>& times, std::vector<Remark>& notices);

  std::size_t held() const { return arrivals_.size() - released_; }

  /// What was done so far.
  SampleTimes sample_times() const;

 private:
  void release_until(double latest, double now, std::vector<double>& times, std::vector<Remark>& notices);
  void estimate(double now);
  void follow(double now, std::vector<Remark>& notices);
  double least_delay(std::size_t from, std::size_t end) const;
  bool is_young() const;
  void begin_anew(double now);
  void move_line(std::size_t from, double by);
  double stamp();
  void tell_changes(double t, std::vector<Remark>& notices);
  void forget();

  std::vector<double> arrivals_;  // [s] those of the memory, then those held back
  std::size_t released_ = 0;      ///< how many of arrivals_ are
  std::optional<RateLine> line_;
  double late_ = 0, rough_ = 0;         // [s] lateness and roughness beside it
  double least_ = hold * 0.9;           // [s] of arrivals that a rate is found in
  double all_late_since_ = 0;           // [s] the last time that not all was late
  double estimated_at_ = 0;             // [s]
  std::optional<double> origin_{};      // [s] arrival clock's time of the file's 0
  double last_t_ = 0, usual_step_ = 0;  // [s]
  double told_period_ = 0;              // [s] as was told last; 0: stamped by arrival
  std::optional<double> changed_at_{};  // [s] file's time, since when it is another
  bool ends_ = false;
  SampleTimes done_;
};

}  // namespace cromer::core
