#include "cromer/tasks/fit/decay_segments.h"

#include <algorithm>
#include <cmath>

namespace cromer::core {

DecaySegments fit_segments(const Record& record, double period, std::optional<double> length,
                           std::optional<int> count, const Watch& watch) {
  DecaySegments result;
  if ((!length && !count) || record.t.size() < 2) return result;
  const double t0 = record.t.front();
  const double duration = record.t.back() - t0;
  const double step = duration / static_cast<double>(record.t.size() - 1);
  const double each = length ? *length : duration / *count;
  const double shortest_segment = std::max(1.5 * period, 8 * step);
  if (each < shortest_segment) {
    result.notices.push_back(
        length ? Notice{"segment_too_short", {{"length", each}, {"shortest", shortest_segment}}}
               : Notice{"segments_too_short",
                        {{"count", *count}, {"length", each}, {"shortest", shortest_segment}}});
    return result;
  }
  // The last sample stands for one step more: 3000 samples at 100 a second are one segment of 30 s.
  const auto whole = static_cast<long long>((duration + step) / each + 1e-9);
  const long long wanted = count ? std::min<long long>(*count, whole) : whole;
  if (count && wanted < *count)
    result.notices.push_back(Notice{
        "fewer_segments", {{"duration", duration}, {"whole", wanted}, {"count", *count}, {"length", each}}});
  constexpr double to_speak_of = 0.02;  // of the record
  const double rest = duration - static_cast<double>(wanted) * each;
  if (length && wanted > 0 && wanted == whole && rest > to_speak_of * duration)
    result.notices.push_back(Notice{"rest_in_no_segment", {{"rest", rest}, {"length", each}}});
  if (!count && whole == 0)
    result.notices.push_back(Notice{"shorter_than_a_segment", {{"duration", duration}, {"length", each}}});

  const auto index_at = [&](double t) {
    return static_cast<std::size_t>(std::lower_bound(record.t.begin(), record.t.end(), t - 1e-6 * step) -
                                    record.t.begin());
  };
  double sum = 0, variance = 0, student = 0;
  long long left_out = 0;
  double failed_from = 0, failed_to = 0;  // [s] of the first
  Notice why;
  for (long long i = 0; i < wanted; ++i) {
    const double from = t0 + static_cast<double>(i) * each, to = t0 + static_cast<double>(i + 1) * each;
    const std::size_t first = index_at(from),
                      last = i + 1 == wanted && !length ? record.t.size() : index_at(to);
    const Record part{record.t.subspan(first, last - first), record.y.subspan(first, last - first),
                      record.resolution};
    const LawFit fit = fit_law(part, {.may_grow = true}, watch);
    if (watch.interrupted()) {
      result.notices.push_back(Notice{"segments_interrupted", {{"done", i}, {"count", wanted}}});
      break;
    }
    if (fit.status != FitStatus::converged) {
      if (left_out++ == 0) {
        failed_from = from;
        failed_to = to;
        why = fit.message;
      }
      continue;
    }
    result.segments.push_back({from, to, fit.decay_rate()});
    sum += fit.decay_rate().value;
    variance += fit.decay_rate().standard_error * fit.decay_rate().standard_error;
    student = std::max(student, fit.student);
  }
  if (left_out > 0)
    result.notices.push_back(Notice{
        left_out == 1 ? "segment_left_out" : "segments_left_out",
        {{"left_out", left_out}, {"count", wanted}, {"from", failed_from}, {"to", failed_to}, {"why", why}}});
  if (!result.segments.empty()) {
    const auto n = static_cast<double>(result.segments.size());
    result.mean = make_estimate(sum / n, std::sqrt(variance) / n, student);
  }
  return result;
}

}  // namespace cromer::core
