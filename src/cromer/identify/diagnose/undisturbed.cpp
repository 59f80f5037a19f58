#include "cromer/identify/diagnose/undisturbed.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cromer/base/for_page.h"
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

// A part of the record that one law describes.
struct Part {
  std::size_t first = 0, end = 0;  // one past the last sample
  int from = 0, out = 0;           // what is left out before and after it, in eightieths of the record
  double rms = 0;                  // of its residuals
  double period = 0;               // [s]

  std::size_t samples() const { return end - first; }
};

constexpr double alike = 1.15;  // times the least rms residual
constexpr double fewest = 4;    // periods

// Whether a law of what comes before the last period is no worse in that: a touch there changes a fit of the
// whole, and so hides in it.
bool leads_to_its_end(const Record& part, double period, const LawFitOptions& law, const Watch& watch) {
  const double cut = part.t.back() - period;
  if (cut - part.t.front() < (fewest - 1) * period) return true;
  const auto samples =
      static_cast<std::size_t>(std::lower_bound(part.t.begin(), part.t.end(), cut) - part.t.begin());
  const LawFit before = fit_law(part.first(samples), law, watch);
  return !before.is_usable() || is_as_the_rest(before, part, cut, HUGE_VAL);
}

std::optional<Part> described_part(const Record& record, std::size_t first, std::size_t end, int from_part,
                                   int parts_out, const Watch& watch) {
  constexpr double nearly_all = 0.95;  // of the motion's squares
  const Record part = record.part(first, end - first);
  const LawFit swing = fit_law(part, {}, watch);
  if (!swing.is_usable() || swing.explained < nearly_all || !(swing.decay_rate().low > 0))
    return std::nullopt;
  const double period = two_pi / swing.swing_frequency().value;
  const double from = part.t.front(), to = part.t.back();
  if (to - from < fewest * period || !is_as_the_rest(swing, part, from, from + period) ||
      !is_as_the_rest(swing, part, to - period, HUGE_VAL))
    return std::nullopt;
  return Part{first, end, from_part, parts_out, swing.residual.rms, period};
}

// A viscous law holds only while rate and frequency hardly change. Extends the longest part that it describes
// as far on either side as drag and a cubic spring leave hardly more; place(part) is the first sample of a
// part of the record, one of `parts`.
template <class Place>
[[maybe_unused]] Part extended(Part best, const Record& record, int parts, const Place& place,
                               const Watch& watch) {
  LawFitOptions options;
  options.law = law_of("viscous+drag+cubic");
  const auto end_of = [&](int out) { return out == 0 ? record.t.size() : place(parts - out); };
  const auto part_of = [&](int from, int out) {
    const std::size_t first = place(from);
    return record.part(first, end_of(out) - first);
  };
  const LawFit known = fit_law(part_of(best.from, best.out), options, watch);
  // What leaves more than noise would follow a hand's first touch, too.
  constexpr double smooth = 0.5;  // of residuals, from sample to sample
  if (!known.is_usable() || known.residual.autocorrelation > smooth) return best;
  // By chance, two standard deviations.
  const double hardly_more = 1 + std::sqrt(2 / static_cast<double>(best.samples()));
  const auto follows = [&](int from, int out) {
    const Record part = part_of(from, out);
    const LawFit swing = fit_law(part, options, watch);
    return swing.is_usable() && !watch.interrupted() &&
           swing.residual.rms <= hardly_more * known.residual.rms &&
           is_as_the_rest(swing, part, part.t.front(), part.t.front() + best.period) &&
           is_as_the_rest(swing, part, part.t.back() - best.period, HUGE_VAL) &&
           leads_to_its_end(part, best.period, options, watch);
  };
  // The least of a number down to `least` for which it still follows: taken to do so above once it does.
  const auto lowest = [&](int sure, int least, const auto& still_follows) {
    int failed = least - 1;
    for (int next = least; sure - failed > 1; next = failed + (sure - failed) / 2)
      (still_follows(next) ? sure : failed) = next;
    return sure;
  };
  best.from = lowest(best.from, 1, [&](int from) { return follows(from, best.out); });
  best.out = lowest(best.out, 0, [&](int out) { return follows(best.from, out); });
  best.first = place(best.from);
  best.end = end_of(best.out);
  return best;
}

}  // namespace

std::optional<FreeSwing> find_free_swing(const Record& record, const Watch& watch) {
  constexpr int finer = 4, parts = 20 * finer, latest = 8 * finer, most_out = 8 * finer;
  const std::size_t n = record.t.size();
  if (n < 64) return std::nullopt;
  const auto place = [&](int part) {
    const double at = record.t.front() + (record.t.back() - record.t.front()) * part / parts;
    return static_cast<std::size_t>(std::lower_bound(record.t.begin(), record.t.end(), at) -
                                    record.t.begin());
  };
  std::vector<Part> found;
  const auto look_at = [&](int from, int out) {
    if (from < 1 || from > latest || out < 0 || out > most_out || watch.interrupted()) return;
    if (const auto described =
            described_part(record, place(from), out == 0 ? n : place(parts - out), from, out, watch))
      found.push_back(*described);
  };
  const auto longest = [&]() -> std::optional<Part> {
    double least = HUGE_VAL;
    for (const Part& part : found) least = std::min(least, part.rms);
    std::optional<Part> best;
    for (const Part& part : found)
      if (part.rms <= alike * least && (!best || part.samples() > best->samples())) best = part;
    return best;
  };
  for (int out = 0; out <= most_out; out += finer)
    for (int from = finer; from <= latest; from += finer) look_at(from, out);
  const std::optional<Part> rough = longest();
  if (!rough) return std::nullopt;
  for (int out = 1 - finer; out < finer; ++out)
    for (int from = 1 - finer; from < finer; ++from)
      if (from != 0 || out != 0) look_at(rough->from + from, rough->out + out);
  Part best = *longest();
  // The longest that a touch in its last period does not end, if there is one.
  for (int out = best.out; out <= most_out && !watch.interrupted(); ++out) {
    const std::size_t end = out == 0 ? n : place(parts - out);
    const auto part = out == best.out ? std::optional(best)
                                      : described_part(record, best.first, end, best.from, out, watch);
    if (!part || !leads_to_its_end(record.part(part->first, part->samples()), part->period, {}, watch))
      continue;
    best = *part;
    break;
  }
  // The page, which must be small, takes what a viscous law describes.
  if constexpr (!for_page) best = extended(best, record, parts, place, watch);
  return FreeSwing{record.t[best.first], best.end < n ? std::optional(record.t[best.end - 1]) : std::nullopt,
                   best.period};
}

}  // namespace cromer::core
