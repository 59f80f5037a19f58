#include "cromer/identify/diagnose/undisturbed.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cromer/base/pi.h"

namespace cromer::core {
namespace {

// Whether the residuals from one time to another, a period or so, are no larger than all.
bool is_as_the_rest(const LawFit& swing, const Record& record, double from, double to) {
  constexpr double larger = 2;  // times the rms residual
  const std::vector<double> left = residuals_of(swing, record);
  double squares = 0, samples = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (record.t[i] < from || record.t[i] >= to) continue;
    squares += left[i] * left[i];
    ++samples;
  }
  const double rms = larger * swing.residual.rms;
  return squares < rms * rms * samples;
}

// A part of the record that one viscous law describes.
struct Part {
  std::size_t first = 0, end = 0;  // one past the last sample
  double rms = 0;                  // of its residuals

  std::size_t samples() const { return end - first; }
};

std::optional<Part> described_part(const Record& record, std::size_t first, std::size_t end,
                                   const Watch& watch) {
  constexpr double nearly_all = 0.95;  // of the motion's squares
  constexpr double fewest = 4;         // periods
  const Record part = record.part(first, end - first);
  const LawFit swing = fit_law(part, {}, watch);
  if (!swing.is_usable() || swing.explained < nearly_all || !(swing.decay_rate().low > 0))
    return std::nullopt;
  const double period = two_pi / swing.swing_frequency().value;
  const double from = part.t.front(), to = part.t.back();
  if (to - from < fewest * period || !is_as_the_rest(swing, part, from, from + period) ||
      !is_as_the_rest(swing, part, to - period, HUGE_VAL))
    return std::nullopt;
  return Part{first, end, swing.residual.rms};
}

}  // namespace

std::optional<FreeSwing> find_free_swing(const Record& record, const Watch& watch) {
  constexpr int parts = 20, latest = 8, most_out = 4;  // of the record; at its beginning and its end
  constexpr double alike = 1.3;                        // times the least rms residual
  const std::size_t n = record.t.size();
  if (n < 64) return std::nullopt;
  const auto place = [&](int part) {
    const double at = record.t.front() + (record.t.back() - record.t.front()) * part / parts;
    return static_cast<std::size_t>(std::lower_bound(record.t.begin(), record.t.end(), at) -
                                    record.t.begin());
  };
  std::vector<Part> found;
  double least = HUGE_VAL;
  for (int out = 0; out <= most_out; ++out)
    for (int part = 1; part <= latest && !watch.interrupted(); ++part)
      if (const auto described =
              described_part(record, place(part), out == 0 ? n : place(parts - out), watch)) {
        found.push_back(*described);
        least = std::min(least, described->rms);
      }
  std::erase_if(found, [&](const Part& part) { return part.rms > alike * least; });
  const auto longest = std::max_element(
      found.begin(), found.end(), [](const Part& a, const Part& b) { return a.samples() < b.samples(); });
  if (longest == found.end()) return std::nullopt;
  return FreeSwing{record.t[longest->first],
                   longest->end < n ? std::optional(record.t[longest->end - 1]) : std::nullopt};
}

}  // namespace cromer::core
