#include "watching.h"

#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace cromer::cli {
namespace {

std::atomic<bool> stop_asked{false};
bool progress_shown = false;

extern "C" void ask_to_stop(int) { stop_asked.store(true, std::memory_order_relaxed); }

void on_signal(int signal) {
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);  // the second one ends the program
  sigaction(signal, &action, nullptr);
}

}  // namespace

Watch watching(bool quiet) {
  on_signal(SIGINT);
  on_signal(SIGTERM);
  Watch watch{&stop_asked, {}};
  if (quiet || !isatty(STDERR_FILENO)) return watch;
  using Clock = std::chrono::steady_clock;
  // Parts of the work may begin anew, the number does not.
  watch.progress = [next = Clock::now() + std::chrono::milliseconds(500),
                    furthest = 0.0](double fraction) mutable {
    if (!(fraction > furthest) || Clock::now() < next) return;
    furthest = fraction;
    next = Clock::now() + std::chrono::milliseconds(100);
    std::fprintf(stderr, "\r%3.0f %%", 100 * fraction);
    progress_shown = true;
  };
  return watch;
}

void clear_progress() {
  if (progress_shown) std::fputs("\r      \r", stderr);
  progress_shown = false;
}

}  // namespace cromer::cli
