#include "cromer/study/task/end_comparison.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "cromer/identify/damped_phasor.h"

namespace cromer {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

// Amplitude and phase of the sinusoid of frequency w that fits samples [first, last) best.
std::complex<double> local_sinusoid(std::span<const double> t, std::span<const double> x, std::size_t first,
                                    std::size_t last, double w) {
  const Record part{t.subspan(first, last - first), x.subspan(first, last - first), 0};
  const DampedPhasor::Linear fit = DampedPhasor(part).best_linear(w, 0);
  return {fit.cosine, -fit.sine};  // cosine cos(wt) + sine sin(wt) = |z| cos(wt + arg z)
}

// The complex amplitude at the end of samples [first, last): the rates of change of size and phase from the
// first half to the second, carried on by the quarter of the window that lies between the second half's
// middle and the end.
std::complex<double> at_end(std::span<const double> t, std::span<const double> x, std::size_t first,
                            std::size_t last, double w) {
  const std::size_t middle = first + (last - first) / 2;
  const std::complex<double> early = local_sinusoid(t, x, first, middle, w),
                             late = local_sinusoid(t, x, middle, last, w);
  if (!(std::abs(early) > 0)) return late;
  const std::complex<double> change = late / early;
  return late * std::polar(std::sqrt(std::abs(change)), std::arg(change) / 2);
}

}  // namespace

EndComparison compare_ends(std::span<const double> t, std::span<const double> measured,
                           std::span<const double> simulated, double w) {
  EndComparison end;
  const double window = 10 * two_pi / w;
  const double duration = t.back() - t.front();
  const int windows = std::max(1, static_cast<int>(duration / window));
  double drift = 0;
  for (int i = windows; i > 0; --i) {
    const double from = std::max(t.front(), t.back() - i * window), to = t.back() - (i - 1) * window;
    const auto first = static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), from) - t.begin());
    const auto last = static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), to) - t.begin());
    if (last < first + 8) continue;
    const std::complex<double> m = local_sinusoid(t, measured, first, last, w),
                               s = local_sinusoid(t, simulated, first, last, w);
    if (!(std::abs(m) > 0)) continue;
    const double now = std::arg(s * std::conj(m));
    drift = now + two_pi * std::round((drift - now) / two_pi);
    if (i > 1) continue;
    const std::complex<double> ratio =
        at_end(t, simulated, first, last, w) / at_end(t, measured, first, last, w);
    end = {std::abs(ratio), drift + std::arg(ratio * std::polar(1.0, -drift))};
  }
  return end;
}

}  // namespace cromer
