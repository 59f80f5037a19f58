#include "cromer/live/timekeeper.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "cromer/base/quantile.h"

namespace cromer::core {
namespace {

constexpr double clear_difference = 0.5;  // [s] which no computer's scheduling makes
constexpr double longest = 1e15;          // [s] thirty million years: a number beyond is no time
constexpr double shortest_gap = 0.1;      // [s]

}  // namespace

double Timekeeper::usual_step() const {
  const std::size_t known = std::min(window, samples_ - 1);
  if (known == 0) return rate_ > 0 ? 1 / rate_ : 0;
  auto steps = steps_;
  return upper_median(std::span(steps).first(known));
}

// A file that is piped in arrives at once: then the computer's clock says nothing about its times.
bool Timekeeper::keeps_pace() const {
  const std::size_t known = std::min(window, samples_ - 1);
  if (known < 8) return false;
  const double device = std::accumulate(steps_.begin(), steps_.begin() + known, 0.0);
  const double arrival = std::accumulate(arrival_steps_.begin(), arrival_steps_.begin() + known, 0.0);
  return arrival > 0.5 * device && device > 0.5 * arrival;
}

double Timekeeper::rising(double t) const {
  if (samples_ == 0 || t > last_t_) return t;
  return std::max(to_microseconds(last_t_ + least_step), std::nextafter(last_t_, HUGE_VAL));
}

void Timekeeper::remember(double arrival, double t) {
  if (samples_ == 0) {
    first_arrival_ = device_arrival_ = arrival;
  } else {
    steps_[(samples_ - 1) % window] = t - last_t_;
    arrival_steps_[(samples_ - 1) % window] = arrival - last_arrival_;
  }
  last_arrival_ = arrival, last_t_ = t;
  ++samples_;
}

void Timekeeper::remember(double device, double arrival, double t) {
  if (samples_ == 0) first_device_ = device;
  remember(arrival, t);
  device_arrival_ = arrival, last_device_ = device;
}

// Samples that arrive in a burst are a usual step apart, however long they were held up: a silence is clearly
// longer than any of them was. The next true time is compared with the last true one.
Stamp Timekeeper::instead_of(double device, double arrival) {
  const double passed = arrival - last_arrival_, usual = samples_ > 0 ? usual_step() : 0;
  const bool silence = passed > shortest_gap && passed > 5 * usual && passed > 2 * held_up_;
  const double step = samples_ == 0 ? 0 : std::max(usual == 0 || silence ? passed : usual, least_step);
  const Stamp stamp{rising(to_microseconds(last_t_ + step)),
                    Remark{RemarkKind::clock,
                           Notice{"device_gave_no_time", {{"given", device}, {"taken", last_t_ + step}}}}};
  remember(arrival, stamp.t);
  return stamp;
}

Stamp Timekeeper::of_device(double device, double arrival) {
  if (!(std::abs(device) < longest)) return instead_of(device, arrival);
  Stamp stamp{device + offset_};
  if (samples_ > 0) {
    const double step = device - last_device_, passed = arrival - device_arrival_, usual = usual_step();
    const double since_last = stamp.t - last_t_;  // which may be one that stands for a garbled time
    const bool back = !(step > 0);
    const bool forward = !back && step > passed + clear_difference && step > 5 * usual && keeps_pace();
    if (back || forward) {
      stamp.t =
          to_microseconds(std::max(last_t_ + std::max(usual, least_step), last_device_ + offset_ + passed));
      offset_ = stamp.t - device;
      stamp.notice =
          Remark{RemarkKind::clock,
                 step == 0 ? Notice{"device_time_twice", {{"time", device}}}
                           : Notice{back ? "device_clock_jumped_back" : "device_clock_jumped_forward",
                                    {{"jump", std::abs(step)}, {"time", last_t_}}}};
    } else {
      held_up_ = std::max(held_up_, passed - step);
      if (since_last > 5 * usual && since_last > shortest_gap && samples_ > 2)
        stamp.notice =
            Remark{RemarkKind::gap, Notice{"nothing_came", {{"duration", since_last}, {"time", last_t_}}}};
    }
    stamp.t = rising(stamp.t);
  }
  remember(device, arrival, stamp.t);
  return stamp;
}

Stamp Timekeeper::of_count(double arrival) {
  if (samples_ == 0) {
    remember(arrival, 0);
    counted_ = 1;
    return {0};
  }
  const double since_first = arrival - first_arrival_;
  const double counted = counted_from_ + static_cast<double>(counted_) / rate_;
  Stamp stamp{counted};
  if (std::abs(since_first - counted) > clear_difference && since_first > last_t_) {
    stamp.t = counted_from_ = to_microseconds(since_first);
    counted_ = 0;
    stamp.notice =
        Remark{RemarkKind::gap, Notice{since_first > counted ? "later_than_counted" : "earlier_than_counted",
                                       {{"difference", std::abs(since_first - counted)}, {"time", last_t_}}}};
  }
  ++counted_;
  stamp.t = rising(stamp.t);
  remember(arrival, stamp.t);
  return stamp;
}

double Timekeeper::pace() const {
  const double passed = device_arrival_ - first_arrival_;
  return passed < 2 ? 0 : (last_device_ - first_device_) / passed;
}

}  // namespace cromer::core
