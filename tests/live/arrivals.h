// Samples that were sent at known times and arrive late, as a device, its line and a busy computer make them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

#include "cromer/live/arrival_clock.h"

namespace cromer::core::test {

struct Sent {
  std::vector<double> sent, arrival;  // [s]
  std::size_t size() const { return sent.size(); }
  void add(double at, double delay) {
    sent.push_back(at);
    // Nothing overtakes.
    arrival.push_back(std::max(at + delay, arrival.empty() ? at : arrival.back()));
  }
};

/// Delay [s] of what is sent at a time [s].
using Delay = std::function<double(double)>;

inline Delay exponential(double mean) {
  return [mean, engine = std::mt19937_64(1)](double) mutable {
    return std::exponential_distribution<double>(1 / mean)(engine);
  };
}
/// As USB adapters hand over.
inline Delay bundles(double every) {
  return [every](double t) { return std::ceil(t / every) * every - t; };
}
/// Every second or so all is held up for 0.1 to 0.3 s.
inline Delay held_up() {
  return [engine = std::mt19937_64(2), from = 0.0, until = 0.0](double t) mutable {
    std::uniform_real_distribution<double> uniform(0, 1);
    if (t > from) until = t + 0.1 + 0.2 * uniform(engine), from = until + 0.3 + uniform(engine);
    return std::max(0.0, until - t) + 1e-4 * uniform(engine);
  };
}

/// Adds `count` samples, the first a period after the last one.
inline void send(Sent& sent, double rate, int count, const Delay& delay) {
  const double begin = sent.size() == 0 ? 1000.123 : sent.sent.back() + 1 / rate;
  for (int i = 0; i < count; ++i) sent.add(begin + i / rate, delay(begin + i / rate));
}

struct Stamped {
  std::vector<double> times;  // [s]
  std::vector<Remark> notices;
  SampleTimes by;
  double longest_held = 0, longest_held_later = 0;  // [s] of all, and of those after the first second
};

/// What the clock makes of them, asked every 50 ms and whenever something comes.
inline Stamped stamp(const Sent& sent) {
  ArrivalClock clock;
  Stamped stamped;
  const auto release = [&](double now) {
    const std::size_t before = stamped.times.size();
    clock.release(now, stamped.times, stamped.notices);
    if (stamped.times.size() == before) return;
    const double held = now - sent.arrival[before];
    stamped.longest_held = std::max(stamped.longest_held, held);
    if (sent.arrival[before] > sent.arrival[0] + 1)
      stamped.longest_held_later = std::max(stamped.longest_held_later, held);
  };
  double now = sent.arrival.front();
  for (std::size_t i = 0; i < sent.size();) {
    const double next = std::min(now + 0.05, sent.arrival[i]);
    for (; i < sent.size() && sent.arrival[i] <= next; ++i) clock.take(sent.arrival[i]);
    release(now = next);
  }
  clock.release_all(stamped.times, stamped.notices);
  stamped.by = clock.sample_times();
  return stamped;
}

/// [s] Largest departure from the times of sending, but for a constant: the median departure.
inline double worst_error(const std::vector<double>& times, const Sent& sent, std::size_t from = 0) {
  std::vector<double> off;
  for (std::size_t i = from; i < times.size(); ++i) off.push_back(times[i] - sent.sent[i]);
  std::vector<double> sorted = off;
  std::sort(sorted.begin(), sorted.end());
  const double middle = sorted[sorted.size() / 2];
  return std::max(sorted.back() - middle, middle - sorted.front());
}

}  // namespace cromer::core::test
