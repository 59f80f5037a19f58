#include "cromer/read/samples_between.h"

#include <algorithm>

namespace cromer::core {

Result<SampleRange> samples_between(std::span<const double> t, double rate, const std::optional<double>& from,
                                    const std::optional<double>& to) {
  const double slack = rate > 0 ? 1e-6 / rate : 0;
  const auto first = from ? std::lower_bound(t.begin(), t.end(), *from - slack) : t.begin();
  const auto end = to ? std::upper_bound(t.begin(), t.end(), *to + slack) : t.end();
  if (first < end)
    return SampleRange{static_cast<std::size_t>(first - t.begin()),
                       static_cast<std::size_t>(end - t.begin())};
  const double front = t.front(), back = t.back();
  if (!to) return Error{"nothing_left_from", {{"from", *from}, {"first", front}, {"last", back}}};
  if (!from) return Error{"nothing_left_to", {{"to", *to}, {"first", front}, {"last", back}}};
  return Error{"nothing_left_between", {{"from", *from}, {"to", *to}, {"first", front}, {"last", back}}};
}

Result<void> check_from_before_to(const std::optional<double>& from, const std::optional<double>& to) {
  if (from && to && *from >= *to) return Error{"from_behind_to", {{"from", *from}, {"to", *to}}};
  return {};
}

}  // namespace cromer::core
