#include "watching.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <string>

#include "cromer/os/process.h"

namespace cromer::core::cli {
namespace {

std::atomic<bool> stop_asked{false};
bool progress_shown = false;

using Clock = std::chrono::steady_clock;

/// What the share done until now lets expect; "" where it is too early to say.
std::string time_left(double fraction, Clock::duration since_begin) {
  const double seconds = std::chrono::duration<double>(since_begin).count();
  if (seconds < 2 || !(fraction > 0)) return "";
  const double left = seconds * (1 - fraction) / fraction;
  if (left < 100) return fmt::format(", {:.0f} s left", left);
  if (left < 100 * 60) return fmt::format(", {:.0f} min left", left / 60);
  return fmt::format(", {:.1f} h left", left / 3600);
}

Watch interruptible() {
  os::on_interrupt([] { stop_asked.store(true, std::memory_order_relaxed); });
  return {&stop_asked, {}};
}

}  // namespace

Watch watching(bool quiet) {
  Watch watch = interruptible();
  if (quiet || !os::is_terminal(os::standard_error)) return watch;
  const auto begin = Clock::now();
  // Parts of the work may begin anew, the number does not.
  watch.progress = [begin, next = begin + std::chrono::milliseconds(500),
                    furthest = 0.0](double fraction) mutable {
    const auto now = Clock::now();
    if (!(fraction > furthest) || now < next) return;
    furthest = fraction;
    next = now + std::chrono::milliseconds(100);
    std::fprintf(stderr, "\r%3.0f %%%-20s", 100 * fraction, time_left(fraction, now - begin).c_str());
    progress_shown = true;
  };
  return watch;
}

Watch watching_ranks(bool quiet) {
  Watch watch = interruptible();
  if (quiet) return watch;
  const auto begin = Clock::now();
  watch.progress = [begin, next = begin + std::chrono::seconds(5)](double fraction) mutable {
    const auto now = Clock::now();
    if (now < next) return;
    next = now + std::chrono::seconds(30);
    std::fprintf(stderr, "cromer: %.0f %%%s\n", 100 * fraction, time_left(fraction, now - begin).c_str());
  };
  return watch;
}

void clear_progress() {
  if (progress_shown) std::fprintf(stderr, "\r%26s\r", "");
  progress_shown = false;
}

}  // namespace cromer::core::cli
