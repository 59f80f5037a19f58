#include "cromer/identify/diagnose/undisturbed.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cromer/base/pi.h"
#include "cromer/base/quantile.h"

namespace cromer::core {
namespace {

// Whether the first period's residuals are no larger than the others'.
bool begins_as_it_goes_on(const LawFit& swing, const Record& record, double period) {
  constexpr double larger = 2;  // times the rms residual
  const std::vector<double> left = residuals_of(swing, record);
  double squares = 0;
  std::size_t i = 0;
  for (; i < left.size() && record.t[i] < record.t.front() + period; ++i) squares += left[i] * left[i];
  const double rms = larger * swing.residual.rms;
  return squares < rms * rms * static_cast<double>(i);
}

// The rms of the residuals of each half period, the first one's first, and the number of its first sample.
// What is left at the end joins the last.
struct HalfPeriods {
  std::vector<double> rms;
  std::vector<std::size_t> first;
};

HalfPeriods half_periods_of(const LawFit& swing, const Record& record) {
  const std::vector<double> left = residuals_of(swing, record);
  const double half = pi / swing.swing_frequency().value;
  const auto count = static_cast<std::size_t>((record.t.back() - record.t.front()) / half);
  HalfPeriods all;
  for (std::size_t i = 0, k = 0; k < count && i < left.size(); ++k) {
    const double end = k + 1 < count ? record.t.front() + static_cast<double>(k + 1) * half : HUGE_VAL;
    const std::size_t first = i;
    double squares = 0;
    for (; i < left.size() && record.t[i] < end; ++i) squares += left[i] * left[i];
    if (i == first) continue;
    all.rms.push_back(std::sqrt(squares / static_cast<double>(i - first)));
    all.first.push_back(first);
  }
  return all;
}

// How many samples follow one law up to a last half period or two that a hand disturbs; all of them where
// none does.
std::size_t undisturbed_samples(const Record& record, const Watch& watch) {
  constexpr double larger = 2.5;          // times the median half period's
  constexpr std::size_t most_halves = 3;  // that are left out
  constexpr std::size_t fewest = 8;       // that are left
  std::size_t kept = record.t.size();
  for (std::size_t out = 0; out < most_halves && !watch.interrupted(); ++out) {
    const Record part = record.first(kept);
    const LawFit swing = fit_law(part, {}, watch);
    if (!swing.is_usable()) return kept;
    const HalfPeriods halves = half_periods_of(swing, part);
    if (halves.rms.size() <= fewest || halves.rms.back() < larger * median(halves.rms)) return kept;
    kept = halves.first.back();
  }
  return kept;
}

}  // namespace

std::optional<FreeSwing> find_free_swing(const Record& record, const Watch& watch) {
  constexpr int parts = 20, latest = 8;
  constexpr double nearly_all = 0.95;  // of the motion's squares
  constexpr double fewest = 5;         // periods
  constexpr double alike = 1.3;        // times the least rms residual
  const std::size_t n = record.t.size();
  if (n < 64) return std::nullopt;
  struct Part {
    std::size_t first;
    double rms;
  };
  std::vector<Part> found;
  double least = HUGE_VAL;
  const double duration = record.t.back() - record.t.front();
  for (int part = 1; part <= latest && !watch.interrupted(); ++part) {
    const double from = record.t.front() + duration * part / parts;
    const auto first =
        static_cast<std::size_t>(std::lower_bound(record.t.begin(), record.t.end(), from) - record.t.begin());
    const Record rest = record.part(first, n - first);
    const LawFit swing = fit_law(rest, {}, watch);
    if (!swing.is_usable() || swing.explained < nearly_all || !(swing.decay_rate().low > 0)) continue;
    const double period = two_pi / swing.swing_frequency().value;
    if (rest.t.back() - rest.t.front() < fewest * period || !begins_as_it_goes_on(swing, rest, period))
      continue;
    found.push_back({first, swing.residual.rms});
    least = std::min(least, swing.residual.rms);
  }
  for (const Part& part : found) {
    if (part.rms >= alike * least) continue;
    const Record rest = record.part(part.first, n - part.first);
    const std::size_t kept = undisturbed_samples(rest, watch);
    return FreeSwing{rest.t.front(), kept < rest.t.size() ? std::optional(rest.t[kept - 1]) : std::nullopt};
  }
  return std::nullopt;
}

}  // namespace cromer::core
