#include "cromer/tasks/compare/end_comparison.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "cromer/base/pi.h"
#include "cromer/identify/motion/damped_phasor.h"

namespace cromer::core {
namespace {

/// Samples [first, last).
struct Window {
  std::size_t first, last;
};

// Amplitude and phase of the sinusoid of frequency w that fits the samples best.
std::complex<double> local_sinusoid(std::span<const double> t, std::span<const double> x, Window window,
                                    double w) {
  const std::size_t n = window.last - window.first;
  const Record part{t.subspan(window.first, n), x.subspan(window.first, n), 0};
  const DampedPhasor::Linear fit = DampedPhasor(part).best_linear(w, 0);
  return {fit.cosine, -fit.sine};  // cosine cos(wt) + sine sin(wt) = |z| cos(wt + arg z)
}

Window late_half(Window window) { return {window.first + (window.last - window.first) / 2, window.last}; }

// The second motion over the first at the window's end: the change of their ratio from the first half to the
// second, carried on by the quarter of the window that lies between the second half's middle and the end.
std::complex<double> ratio_at_end(std::span<const double> t, std::span<const double> first,
                                  std::span<const double> second, Window window, double w) {
  const Window late = late_half(window), early{window.first, late.first};
  const std::complex<double> before =
                                 local_sinusoid(t, second, early, w) / local_sinusoid(t, first, early, w),
                             after = local_sinusoid(t, second, late, w) / local_sinusoid(t, first, late, w);
  const std::complex<double> change = after / before;
  return std::isfinite(std::abs(change)) ? after * std::sqrt(change) : after;
}

// From the first to the last upward crossing of zero; `otherwise` where there are fewer than three.
double frequency_in(std::span<const double> t, std::span<const double> x, Window window, double otherwise) {
  int crossings = 0;
  double from = 0, to = 0;
  for (std::size_t i = window.first + 1; i < window.last; ++i) {
    if (!(x[i - 1] < 0 && x[i] >= 0)) continue;
    to = t[i - 1] + (t[i] - t[i - 1]) * x[i - 1] / (x[i - 1] - x[i]);
    if (++crossings == 1) from = to;
  }
  return crossings < 3 ? otherwise : two_pi * (crossings - 1) / (to - from);
}

}  // namespace

EndComparison compare_ends(std::span<const double> t, std::span<const double> first,
                           std::span<const double> second, std::span<const double> guide, double w) {
  EndComparison end;
  const double length = 10 * two_pi / w;
  const int windows = std::max(1, static_cast<int>((t.back() - t.front()) / length));
  double drift = 0;
  for (int i = windows; i > 0; --i) {
    const double from = std::max(t.front(), t.back() - i * length), to = t.back() - (i - 1) * length;
    const Window window{static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), from) - t.begin()),
                        static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), to) - t.begin())};
    if (window.last < window.first + 8) continue;
    const double here = frequency_in(t, guide, window, w);
    const std::complex<double> a = local_sinusoid(t, first, window, here),
                               b = local_sinusoid(t, second, window, here);
    if (std::abs(a) > 0) {
      const double now = std::arg(b * std::conj(a));
      drift = now + two_pi * std::round((drift - now) / two_pi);
    }
    if (i > 1) continue;
    const std::complex<double> ratio = ratio_at_end(t, first, second, window, here);
    end = {.amplitude_ratio = std::abs(ratio),
           .phase_drift = drift + std::arg(ratio * std::polar(1.0, -drift)),
           .first_amplitude = std::abs(local_sinusoid(t, first, late_half(window), here)),
           .second_amplitude = std::abs(local_sinusoid(t, second, late_half(window), here)),
           .samples = window.last - late_half(window).first};
  }
  return end;
}

}  // namespace cromer::core
