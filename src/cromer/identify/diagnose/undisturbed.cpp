#include "cromer/identify/diagnose/undisturbed.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cromer/base/pi.h"

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

}  // namespace

std::optional<double> swings_freely_from(const Record& record, const Watch& watch) {
  constexpr int parts = 20, latest = 8;
  constexpr double nearly_all = 0.95;  // of the motion's squares
  constexpr double fewest = 5;         // periods
  constexpr double alike = 1.3;        // times the least rms residual
  const std::size_t n = record.t.size();
  if (n < 64) return std::nullopt;
  struct Part {
    double from, rms;
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
    found.push_back({rest.t.front(), swing.residual.rms});
    least = std::min(least, swing.residual.rms);
  }
  for (const Part& part : found)
    if (part.rms < alike * least) return part.from;
  return std::nullopt;
}

}  // namespace cromer::core
