#include "cromer/identify/modal/modal_record.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "cromer/base/for_page.h"
#include "cromer/base/quantile.h"

namespace cromer::core {

namespace {

// Whether samples any number of steps apart, up to a hundred, are there together often enough: not in bursts
// with gaps between.
bool has_pairs_at_all_lags(const std::vector<std::size_t>& places) {
  constexpr std::size_t lags = 100, tenth = 10;  // of the samples
  std::vector<char> there(places.back() + 1 + lags, 0);
  for (const std::size_t place : places) there[place] = 1;
  for (std::size_t lag = 1; lag <= lags; ++lag) {
    const auto pairs = std::count_if(places.begin(), places.end(),
                                     [&](std::size_t place) { return there[place + lag] != 0; });
    if (tenth * static_cast<std::size_t>(pairs) < places.size()) return false;
  }
  return true;
}

}  // namespace

void set_times(ModalRecord& record, const std::vector<double>& t) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < t.size(); ++i) steps.push_back(t[i] - t[i - 1]);
  std::vector<double> sorted = steps;
  const double gap = 1.75 * upper_median(sorted);
  double sum = 0;
  std::size_t count = 0;
  record.starts = {0};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] > gap) {
      record.starts.push_back(i + 1);
      continue;
    }
    sum += steps[i];
    ++count;
  }
  record.step = sum / static_cast<double>(count);
  record.times = t;
}

std::vector<std::size_t> places_with_short_gaps(const ModalRecord& record) {
  constexpr double longest = for_page ? 0 : 20;  // the page, which must be small, fills in none
  std::vector<std::size_t> places(record.samples());
  std::iota(places.begin(), places.end(), std::size_t{0});
  if constexpr (longest == 0) return places;
  std::size_t missing = 0;
  for (std::size_t stretch = 1; stretch < record.starts.size(); ++stretch) {
    const std::size_t start = record.starts[stretch];
    const double lost = std::round((record.time(start) - record.time(start - 1)) / record.step) - 1;
    if (lost > 0 && lost <= longest) missing += static_cast<std::size_t>(lost);
    for (std::size_t i = start; i < record.end(stretch); ++i) places[i] = i + missing;
  }
  // With less than a third missing there are such pairs, whatever the gaps.
  if (2 * missing > places.size() && !has_pairs_at_all_lags(places))
    std::iota(places.begin(), places.end(), std::size_t{0});
  return places;
}

BridgedRecord::BridgedRecord(const ModalRecord& record) : record_(record) {
  const std::vector<std::size_t> places = places_with_short_gaps(record);
  if (for_page || places.empty() || places.back() + 1 == places.size()) return;
  constexpr std::size_t steps_of_cubic = 4;
  // Whether no longer gap is before this sample.
  const auto follows = [&](std::size_t i) {
    return i > 0 && (places[i] > places[i - 1] + 1 ||
                     !std::binary_search(record.starts.begin(), record.starts.end(), i));
  };
  const auto value_before = [&](std::size_t i, double place, std::span<const double> y) {
    const auto is_near = [&](std::size_t k) {
      return k < places.size() && follows(k) && places[k] - places[k - 1] <= steps_of_cubic;
    };
    const std::size_t first = is_near(i) && is_near(i - 1) ? i - 2 : i - 1,
                      last = is_near(i) && is_near(i + 1) ? i + 1 : i;
    double sum = 0;
    for (std::size_t k = first; k <= last; ++k) {
      double weight = 1;
      for (std::size_t j = first; j <= last; ++j)
        if (j != k)
          weight *= (place - static_cast<double>(places[j])) /
                    (static_cast<double>(places[k]) - static_cast<double>(places[j]));
      sum += weight * y[k];
    }
    return sum;
  };
  values_.resize(record.channels.size());
  record_.times.clear();
  record_.starts = {0};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t steps = i > 0 ? places[i] - places[i - 1] : 1;
    if (i > 0 && !follows(i)) record_.starts.push_back(places[i]);
    for (std::size_t k = 1; k < steps; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(steps);
      record_.times.push_back(std::lerp(record.time(i - 1), record.time(i), share));
      record_.measured.push_back(0);
      for (std::size_t c = 0; c < values_.size(); ++c)
        values_[c].push_back(value_before(i, static_cast<double>(places[i - 1] + k), record.channels[c]));
    }
    record_.times.push_back(record.time(i));
    record_.measured.push_back(1);
    for (std::size_t c = 0; c < values_.size(); ++c) values_[c].push_back(record.channels[c][i]);
  }
  record_.channels.assign(values_.begin(), values_.end());
}

Notice drifting_clock(const ModalRecord& record) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < record.times.size(); ++i)
    if (!std::binary_search(record.starts.begin(), record.starts.end(), i))
      steps.push_back(record.times[i] - record.times[i - 1]);
  const std::size_t third = steps.size() / 3;
  if (third < 20) return {};
  const auto mean_of = [&](std::size_t from) {
    double sum = 0, square = 0;
    for (std::size_t i = from; i < from + third; ++i) sum += steps[i], square += steps[i] * steps[i];
    const double mean = sum / static_cast<double>(third);
    return std::pair{mean, std::sqrt(std::max(0.0, square / static_cast<double>(third) - mean * mean) /
                                     static_cast<double>(third))};
  };
  const auto [first, first_error] = mean_of(0);
  const auto [last, last_error] = mean_of(steps.size() - third);
  const double drift = last / first - 1;
  constexpr double least = 5e-4;
  if (!(std::abs(drift) > std::max(least, 5 * std::hypot(first_error, last_error) / first))) return {};
  return Notice{"clock_drifts", {{"percent", 100 * drift}}};
}

}  // namespace cromer::core
