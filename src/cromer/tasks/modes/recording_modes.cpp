#include <algorithm>
#include <cmath>
#include <numbers>

#include "cromer/base/add_once.h"
#include "cromer/base/extent.h"
#include "cromer/read/columns.h"
#include "cromer/tasks/modes/law_before_method.h"
#include "cromer/tasks/modes/modes_options.h"

namespace cromer::core {
namespace {

// Channels at the same times.
struct AlignedChannels {
  std::vector<Series> series;  ///< without values: their names and units
  std::vector<double> t;       // [s]
  std::vector<std::vector<double>> values;
};

bool is_still(const std::vector<double>& values) {
  const auto [low, high] = extent_of(values);
  return !(high > low);
}

/// The columns that move, and what there is to say of the others.
Result<AlignedChannels> take_channels(const Recording& recording, const ReadOptions& reading,
                                      std::vector<Notice>& notices) {
  constexpr int run = 1;
  if (const auto all = runs(recording); all.size() > 1)
    return Error{"modes_of_one_run", {{"file", recording.file}, {"runs", all.size()}}};
  std::vector<Series> taken;
  for (const std::size_t j : motion_columns(recording, run)) {
    const Column& column = recording.table.columns[j];
    const std::string title = column_title(column);
    const auto missing = std::count_if(column.values.begin(), column.values.end(),
                                       [](double each) { return std::isnan(each); });
    if (2 * static_cast<std::size_t>(missing) > column.values.size()) {
      notices.push_back(Notice{"channel_left_out_empty", {{"column", title}}});
      continue;
    }
    auto series = take_series(recording, title, run, reading);
    if (!series) return series.error();
    for (const Notice& notice : series->notices) add_once(notices, notice);
    if (is_still(series->y)) {
      notices.push_back(Notice{"channel_left_out_still", {{"column", title}}});
      continue;
    }
    taken.push_back(*std::move(series));
  }
  if (taken.empty()) {
    // Says which columns there are.
    if (auto series = take_series(recording, "", run, reading); !series && notices.empty())
      return series.error();
    return Error{"no_channel_moves", {{"file", recording.file}}};
  }
  // Times that all of them have.
  AlignedChannels channels;
  channels.t = taken.front().t;
  for (const Series& each : taken) {
    std::vector<double> both;
    std::set_intersection(channels.t.begin(), channels.t.end(), each.t.begin(), each.t.end(),
                          std::back_inserter(both));
    channels.t = std::move(both);
  }
  std::size_t longest = 0;
  for (Series& each : taken) {
    longest = std::max(longest, each.t.size());
    std::vector<double> values;
    for (std::size_t i = 0, k = 0; i < each.t.size() && k < channels.t.size(); ++i)
      if (each.t[i] == channels.t[k]) {
        values.push_back(each.y[i]);
        ++k;
      }
    channels.values.push_back(std::move(values));
    each.t.clear();
    each.y.clear();
    channels.series.push_back(std::move(each));
  }
  if (channels.t.size() < longest)
    notices.push_back(Notice{"samples_not_in_all_channels", {{"samples", longest - channels.t.size()}}});
  return channels;
}

/// The even grid of the times: its step, and where stretches without a gap begin.
void find_stretches(ModalRecord& record, const std::vector<double>& t) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < t.size(); ++i) steps.push_back(t[i] - t[i - 1]);
  std::vector<double> sorted = steps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double median = *middle;
  double sum = 0;
  std::size_t count = 0;
  record.starts = {0};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] > 1.75 * median) {
      record.starts.push_back(i + 1);
      continue;
    }
    sum += steps[i];
    ++count;
  }
  record.step = sum / static_cast<double>(count);
  record.times = t;
}

/// How much longer the steps are in the last third than in the first, gaps apart; 0 unless it is seen
/// clearly.
double clock_drift(const ModalRecord& record) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < record.times.size(); ++i)
    if (const double step = record.times[i] - record.times[i - 1]; step < 1.75 * record.step)
      steps.push_back(step);
  const std::size_t third = steps.size() / 3;
  if (third < 20) return 0;
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
  return std::abs(drift) > std::max(least, 5 * std::hypot(first_error, last_error) / first) ? drift : 0;
}

/// Peaks that stand out as modes do, and are none.
std::vector<double> peaks_without_mode(const ModalAnalysis& found) {
  constexpr double stands_out = 20, near = 0.05;
  std::vector<double> result;
  for (const SpectralPeak& peak : found.peaks)
    if (peak.prominence > stands_out &&
        std::none_of(found.modes.begin(), found.modes.end(), [&](const MeasuredMode& mode) {
          return std::abs(mode.frequency.value - peak.frequency) < near * peak.frequency;
        }))
      result.push_back(peak.frequency);
  return result;
}

Notice motion_in_words(const ModalAnalysis& found) {
  if (found.motion == ModalMotion::free_decay)
    return Notice{"modes_of_free_decay", {{"percent", 100 * found.decaying_share}}};
  return Notice{"modes_of_random_forces",
                {{"order", found.highest_order}, {"reach", found.lags * found.lag_step}}};
}

void doubt_modes(const ModalAnalysis& found, const ModesOptions& options, std::vector<Notice>& notices) {
  constexpr double enough = 15;
  if (found.motion == ModalMotion::free_decay) return;
  for (const MeasuredMode& mode : found.modes)
    if (mode.lifetimes < enough)
      notices.push_back(
          Notice{"few_decay_times", {{"times", mode.lifetimes}, {"frequency", mode.frequency.value}}});
  if (options.from_frequency || options.to_frequency || options.modes) return;
  for (const double frequency : peaks_without_mode(found))
    notices.push_back(Notice{"peak_without_mode", {{"frequency", frequency}}});
}

/// The estimate whose standard error follows to first order, at the t of another.
Estimate with_error(double value, double standard_error, const Estimate& like) {
  const double t = like.standard_error > 0 ? (like.high - like.value) / like.standard_error : 0;
  return {value, standard_error, value - t * standard_error, value + t * standard_error};
}

/// Takes the method's share out of a mode, and notes what the method made of it.
void take_out(NaturalMode& mode, const ModesOptions& options, std::vector<Notice>& notices) {
  const MethodSettings settings = method_settings_of(options);
  const double h = *options.step;
  const auto before =
      law_before_method(options.of_method, settings, h, mode.frequency.value, mode.damping_ratio.value);
  const auto effect =
      before ? method_effect(options.of_method, settings, before->law, h, false) : std::nullopt;
  if (!effect) {
    notices.push_back(
        Notice{"no_law_before_method",
               {{"method", options.of_method}, {"step", h}, {"frequency", mode.frequency.value}}});
    return;
  }
  const double f = mode.frequency.standard_error, z = mode.damping_ratio.standard_error;
  const auto& slopes = before->slopes;
  mode.frequency =
      with_error(before->frequency, std::hypot(slopes[0][0] * f, slopes[0][1] * z), mode.frequency);
  mode.damping_ratio =
      with_error(before->damping_ratio, std::hypot(slopes[1][0] * f, slopes[1][1] * z), mode.damping_ratio);
  mode.methods.push_back({options.of_method, h, *effect, effect_notice(*effect, before->law)});
}

}  // namespace

Result<ModesResult> recording_modes(const Recording& recording, const ModesOptions& options) {
  if (!options.method.empty()) return Error{"method_of_networks", {{"file", recording.file}}};
  if (options.step && options.of_method.empty()) return Error{"step_needs_of_method"};
  if (!options.step && !options.of_method.empty()) return Error{"of_method_needs_step"};
  ModesOptions checked = options;
  if (!options.of_method.empty()) checked.method = {options.of_method};
  if (auto good = check_modes_options(checked); !good) return good.error();
  if (options.from_frequency && options.to_frequency && *options.from_frequency >= *options.to_frequency)
    return Error{"frequencies_reversed"};

  ModesResult result{.file = recording.file, .notices = recording.notices};
  const auto channels = take_channels(recording, options.read, result.notices);
  if (!channels) return channels.error();
  constexpr std::size_t fewest = 40;
  if (channels->t.size() < fewest)
    return Error{"too_few_samples_for_modes",
                 {{"file", recording.file}, {"samples", channels->t.size()}, {"fewest", fewest}}};
  ModalRecord record;
  for (const auto& each : channels->values) record.channels.emplace_back(each);
  find_stretches(record, channels->t);
  for (const Series& each : channels->series) result.names.push_back(each.column);
  if (record.channels.size() == 1)
    result.notices.push_back(Notice{"one_channel", {{"column", result.names.front()}}});
  if (const double drift = clock_drift(record); drift != 0)
    result.notices.push_back(Notice{"clock_drifts", {{"percent", 100 * drift}}});

  ModalSettings settings;
  constexpr double full_turn = 2 * std::numbers::pi;
  settings.from = options.from_frequency.value_or(0) / full_turn;
  if (options.to_frequency) settings.to = *options.to_frequency / full_turn;
  settings.modes = options.modes.value_or(0);
  result.recording = ModalSource{.quantity = channels->series.front().quantity,
                                 .unit = unit_of(channels->series.front()),
                                 .samples = channels->t.size(),
                                 .rate = 1 / record.step,
                                 .duration = channels->t.back() - channels->t.front(),
                                 .gaps = record.starts.size() - 1,
                                 .found = find_modes(record, settings)};
  const ModalAnalysis& found = result.recording->found;
  for (const MeasuredMode& mode : found.modes)
    result.modes.push_back({.frequency = mode.frequency,
                            .damping_ratio = mode.damping_ratio,
                            .shape = mode.shape,
                            .shape_error = mode.shape_error});
  if (found.modes.empty()) {
    result.message = found.highest_order > 0 ? Notice{"no_modes_found"} : Notice{"too_short_for_modes"};
  } else {
    result.recording->words = motion_in_words(found);
    doubt_modes(found, options, result.notices);
  }
  if (!options.of_method.empty())
    for (NaturalMode& mode : result.modes) take_out(mode, options, result.notices);
  return result;
}

}  // namespace cromer::core
