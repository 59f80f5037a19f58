#include "cromer/live/arrival_clock.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cromer::core {
namespace {

constexpr double between_estimates = 0.1;  // [s]
constexpr double small_delay = 5e-4;       // [s] not worth a thought
constexpr double clearly_early = 1e-3;     // [s]
constexpr double no_delay = 1;             // [s] nothing is held up that long, and those behind it as well
constexpr double sure_delay = 0.05;        // [s] by which a line that is young may be disproved
constexpr double shown_for = 0.1;          // [s] that the line has to be gone
constexpr double patience = 2;             // [s] with arrivals that are all late
constexpr double clear_gap = 0.5;          // [s]
constexpr double settled = 1;              // [s] that a rate must hold, or be gone, to be told
constexpr double settled_memory = 2;       // [s] for a rate that is not the first
constexpr std::size_t few = 3;             ///< samples that show where the line has gone
constexpr std::size_t enough = 8;          ///< samples that show that it has bent

}  // namespace

// A line that was found is kept until samples are earlier than it says; delays do not disprove it.
void ArrivalClock::estimate(double now) {
  estimated_at_ = now;
  const double least = line_ && held() > 0 ? least_delay(released_, arrivals_.size()) : 0;
  const bool early = least < -std::max(clearly_early, rough_);
  if (early && !is_young()) return begin_anew(now);
  // While all samples come late they say nothing about the rate. `follow` sees whether they stay late.
  if (least <= sure_delay) all_late_since_ = now;
  if (now - all_late_since_ < patience && now > all_late_since_ && !is_young()) return;
  if (const auto steady = steady_rate(arrivals_, least_)) {
    line_ = steady;
    done_.rate = 1 / line_->period;
    late_ = lateness(arrivals_, *line_);
    rough_ = roughness(arrivals_);
  } else if (early) {
    line_.reset();
    least_ = settled_memory;
  }
}

bool ArrivalClock::is_young() const { return arrivals_.back() - arrivals_.front() < settled_memory; }

/// The smallest delay of the samples `from` to `end`.
double ArrivalClock::least_delay(std::size_t from, std::size_t end) const {
  double least = arrivals_[from] - line_->at(static_cast<double>(from));
  for (std::size_t i = from + 1; i < end; ++i)
    least = std::min(least, arrivals_[i] - line_->at(static_cast<double>(i)));
  return least;
}

// Begins a new line with the next sample to be stamped.
void ArrivalClock::begin_anew(double now) {
  arrivals_.erase(arrivals_.begin(), arrivals_.begin() + static_cast<std::ptrdiff_t>(released_));
  released_ = 0;
  line_.reset();
  least_ = settled_memory;
  estimate(now);
}

// Moves the samples sent before to where they would have been without the pause, and the line with them.
void ArrivalClock::move_line(std::size_t from, double by) {
  for (std::size_t i = 0; i < from; ++i) arrivals_[i] += by;
  line_->begin += by;
}

void ArrivalClock::follow(double now, std::vector<Remark>& notices) {
  const double delay = arrivals_[released_] - line_->at(static_cast<double>(released_));
  if (delay <= small_delay) return;
  const std::size_t size = arrivals_.size();
  if (const double lasting = least_delay(released_, size); lasting >= no_delay) {
    // Samples that come less and less late are catching up.
    const std::size_t middle = released_ + (size - released_) / 2;
    const bool catches_up = middle > released_ && least_delay(released_, middle) > lasting + line_->period;
    if (!catches_up) move_line(released_, lasting);
    return;
  }
  const double period = line_->period;
  const auto needed = std::max(few, static_cast<std::size_t>(shown_for / period));
  if (size < needed) return;
  const std::size_t from = std::min(released_, size - needed), count = size - from;
  const std::size_t parts = count < enough ? 3 : 4;
  std::array<double, 4> late{};
  for (std::size_t i = 0; i < parts; ++i)
    late[i] = least_delay(from + count * i / parts, from + count * (i + 1) / parts);
  const auto [least, most] = std::minmax_element(late.begin(), late.begin() + parts);
  // Delays may simply have become worse.
  const double rough = roughness(std::span<const double>(arrivals_).subspan(from));
  const double bound = std::max(small_delay, 3 * std::min(late_, rough_)) + (rough > 2 * rough_ ? rough : 0);
  const bool young = is_young() || ends_;
  if (*least <= (young ? std::max(bound, sure_delay) : bound)) return;
  // Samples that were held up come less and less late; at another rate they come later and later; after a
  // pause they are equally late.
  if (*most - *least > std::max(small_delay, 2 * std::min(late_, rough_))) {
    if (!young && count >= enough && std::is_sorted(late.begin(), late.begin() + parts)) begin_anew(now);
    return;
  }
  const double missing = std::round(*least / period);
  const bool whole = std::abs(*least - missing * period) < std::min(bound, 0.25 * period);
  const double by = whole ? missing * period : *least;
  move_line(from, by);
  if (by < clear_gap && by > 0.75 * period)
    notices.push_back(
        {RemarkKind::gap,
         whole ? Notice{"samples_missing", {{"samples", static_cast<long long>(missing)}, {"time", last_t_}}}
               : Notice{"device_paused", {{"duration", by}, {"time", last_t_}}}});
}

/// The time of the next sample.
double ArrivalClock::stamp() {
  const double arrival = arrivals_[released_];
  const double sent = line_ ? line_->at(static_cast<double>(released_)) : arrival;
  if (!origin_) origin_ = sent;
  if (line_) done_.longest_delay = std::max(done_.longest_delay, arrival - sent);
  ++(line_ ? done_.by_rate : done_.by_arrival);
  const double t = to_microseconds(sent - *origin_);
  const bool first = done_.by_rate + done_.by_arrival == 1;
  return first || t > last_t_ ? t : to_microseconds(last_t_ + least_step);
}

/// Adds a notice if a rate was found, lost or changed for good.
void ArrivalClock::tell_changes(double t, std::vector<Remark>& notices) {
  const double period = line_ ? line_->period : 0;
  if (t < settled) told_period_ = period;
  if (std::abs(period - told_period_) <= 0.01 * std::max(period, told_period_)) {
    changed_at_.reset();
    return;
  }
  if (!changed_at_) changed_at_ = t;
  if (t - *changed_at_ < settled) return;
  notices.push_back(
      {RemarkKind::clock, period == 0
                              ? Notice{"no_steady_rate_from", {{"time", *changed_at_}}}
                              : Notice{"steady_rate_from", {{"rate", 1 / period}, {"time", *changed_at_}}}});
  told_period_ = period;
  changed_at_.reset();
}

// Drops the arrivals that are older than the memory.
void ArrivalClock::forget() {
  const double since = arrivals_.back() - longest_memory;
  const auto old = static_cast<std::size_t>(std::lower_bound(arrivals_.begin(), arrivals_.end(), since) -
                                            arrivals_.begin());
  std::size_t drop = std::min(old, arrivals_.size() - std::min(arrivals_.size(), least_samples));
  drop = std::max(drop, arrivals_.size() - std::min(arrivals_.size(), most_samples));
  drop = std::min(drop, released_);
  if (drop < arrivals_.size() / 4) return;
  if (line_) line_->begin = line_->at(static_cast<double>(drop));
  arrivals_.erase(arrivals_.begin(), arrivals_.begin() + static_cast<std::ptrdiff_t>(drop));
  released_ -= drop;
}

SampleTimes ArrivalClock::sample_times() const {
  SampleTimes times = done_;
  if (times.by_rate + times.by_arrival > 0)
    times.by = times.by_rate >= times.by_arrival ? TimesBy::rate : TimesBy::arrival;
  return times;
}

void ArrivalClock::release(double now, std::vector<double>& times, std::vector<Remark>& notices) {
  if (held() == 0) return;
  if (!origin_ && arrivals_.front() <= now - hold && arrivals_.front() > now - first_hold) {
    estimate(now);
    if (!line_) return;
  }
  release_until(now - hold, now, times, notices);
}

void ArrivalClock::release_all(std::vector<double>& times, std::vector<Remark>& notices) {
  ends_ = true;  // what would come next is not known
  if (held() > 0) release_until(arrivals_.back(), arrivals_.back(), times, notices);
}

void ArrivalClock::release_until(double latest, double now, std::vector<double>& times,
                                 std::vector<Remark>& notices) {
  if (held() == 0 || arrivals_[released_] > latest) return;
  if (now - estimated_at_ >= between_estimates) estimate(now);
  for (; held() > 0 && arrivals_[released_] <= latest; ++released_) {
    if (line_) follow(now, notices);
    const double t = stamp();
    if (t - last_t_ > clear_gap && t - last_t_ > 5 * usual_step_ && done_.by_rate + done_.by_arrival > 3)
      notices.push_back(
          {RemarkKind::gap, Notice{"nothing_came", {{"duration", t - last_t_}, {"time", last_t_}}}});
    // A running mean of the last steps.
    usual_step_ += (t - last_t_ - usual_step_) /
                   static_cast<double>(std::min<std::size_t>(done_.by_rate + done_.by_arrival, 16));
    last_t_ = t;
    times.push_back(t);
    tell_changes(t, notices);
  }
  forget();
}

}  // namespace cromer::core
