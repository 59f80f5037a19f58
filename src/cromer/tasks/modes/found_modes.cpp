#include <algorithm>
#include <cmath>
#include <utility>

#include "cromer/base/add_once.h"
#include "cromer/base/pi.h"
#include "cromer/identify/diagnose/free_part.h"
#include "cromer/identify/modal/still_beginning.h"
#include "cromer/read/channels.h"
#include "cromer/read/in_file.h"
#include "cromer/read/samples_between.h"
#include "cromer/tasks/modes/modes_options.h"

namespace cromer::core {
namespace {

/// The columns that move, at the times that all of them have, and what there is to say of the others.
Result<Channels> moving_channels(const Recording& recording, const ModesOptions& options,
                                 std::vector<Notice>& notices) {
  auto taken = take_channels(recording, options.run, options.read);
  if (!taken) return taken.error();
  Channels channels = *std::move(taken);
  if (auto good = crop(channels, options.from, options.to); !good) return good.error();
  const auto leave_out = [&](const char* code, const auto& why) {
    std::erase_if(channels.each, [&](const Channel& channel) {
      if (!why(channel)) return false;
      std::erase_if(channels.notices, [&](const Notice& each) {
        return each == Notice{"column_never_changes", {{"column", channel.column}}};
      });
      notices.push_back(Notice{code, {{"column", channel.column}}});
      return true;
    });
  };
  leave_out("channel_left_out_empty",
            [&](const Channel& channel) { return 2 * channel.missing > channels.t.size(); });
  leave_out("channel_left_out_still", never_changes);
  for (const Notice& notice : channels.notices) add_once(notices, notice);
  if (channels.each.empty()) return Error{"no_channel_moves", {{"file", recording.file}}};
  if (auto good = check_no_channel_dies(channels, recording.file); !good) return good.error();

  if (const std::size_t left_out = leave_out_incomplete(channels); left_out > 0)
    notices.push_back(Notice{"samples_not_in_all_channels", {{"samples", left_out}}});
  return channels;
}

/// The frequencies [Hz] of peaks that stand out as a mode's would, but belong to no mode and no line.
std::vector<double> peaks_without_mode(const ModalAnalysis& found) {
  constexpr double stands_out = 20, near = 0.05;
  std::vector<double> result;
  for (const SpectralPeak& peak : found.peaks)
    if (peak.prominence > stands_out &&
        std::none_of(found.modes.begin(), found.modes.end(),
                     [&](const MeasuredMode& mode) {
                       return std::abs(mode.frequency.value - peak.frequency) < near * peak.frequency;
                     }) &&
        std::none_of(found.lines.begin(), found.lines.end(),
                     [&](double line) { return std::abs(line - peak.frequency) < near * peak.frequency; }))
      result.push_back(peak.frequency);
  return result;
}

/// Over this many decay times rounding makes a motion without damping seem to change.
constexpr double rounding_of_lifetimes = 1e-6;

bool growing(const MeasuredMode& mode) {
  return mode.damping_ratio.high < 0 && mode.lifetimes < -rounding_of_lifetimes;
}

bool decaying(const MeasuredMode& mode) {
  return mode.damping_ratio.low > 0 && mode.lifetimes > rounding_of_lifetimes;
}

Notice motion_in_words(const ModalAnalysis& found) {
  const bool dies_away = std::any_of(found.modes.begin(), found.modes.end(), decaying) &&
                         std::none_of(found.modes.begin(), found.modes.end(), growing);
  if (found.motion == ModalMotion::free_decay)
    return Notice{dies_away ? "modes_of_free_decay" : "modes_of_free_motion",
                  {{"percent", 100 * found.decaying_share}}};
  return Notice{"modes_of_random_forces",
                {{"order", found.highest_order}, {"reach", found.lags * found.lag_step}}};
}

void doubt_free_motion(const ModalAnalysis& found, std::size_t channels, bool all,
                       std::vector<Notice>& notices) {
  for (const MeasuredMode& mode : found.modes)
    if (growing(mode))
      notices.push_back(Notice{"mode_grows", {{"frequency", mode.frequency.value}}});
    else if (!decaying(mode))
      notices.push_back(Notice{"mode_does_not_decay", {{"frequency", mode.frequency.value}}});
  const auto most =
      std::max_element(found.modes.begin(), found.modes.end(),
                       [](const auto& a, const auto& b) { return a.times_noise < b.times_noise; });
  if (most != found.modes.end() && most->times_noise > times_noise_told)
    notices.push_back(
        Notice{"modes_leave_a_motion", {{"frequency", most->frequency.value}, {"times", most->times_noise}}});
  if (found.modes.size() > channels && channels > 1)
    notices.push_back(
        Notice{"more_modes_than_channels", {{"channels", channels}, {"modes", found.modes.size()}}});
  if (all && found.modes.size() < channels)
    notices.push_back(
        Notice{"fewer_modes_than_channels", {{"channels", channels}, {"modes", found.modes.size()}}});
}

void doubt_modes(const ModalAnalysis& found, std::size_t channels, bool all, std::vector<Notice>& notices) {
  if (found.motion == ModalMotion::free_decay) return doubt_free_motion(found, channels, all, notices);
  for (const double line : found.lines) notices.push_back(Notice{"steady_line", {{"frequency", line}}});
  constexpr double enough = 15;
  for (const MeasuredMode& mode : found.modes)
    if (mode.lifetimes < enough)
      notices.push_back(
          Notice{"few_decay_times", {{"times", mode.lifetimes}, {"frequency", mode.frequency.value}}});
  if (!all) return;
  for (const double frequency : peaks_without_mode(found))
    notices.push_back(Notice{"peak_without_mode", {{"frequency", frequency}}});
}

/// `highest` [Hz]: half the sampling rate.
Notice why_no_modes(const ModalAnalysis& found, const ModesOptions& options, double highest) {
  if (found.highest_order == 0) return Notice{"too_short_for_modes"};
  if (!options.from_frequency && !options.to_frequency) return Notice{"no_modes_found"};
  const double from = options.from_frequency.value_or(0) / two_pi,
               to = options.to_frequency ? *options.to_frequency / two_pi : highest;
  return Notice{"no_modes_in_band", {{"from", from}, {"to", std::max(from, to)}, {"highest", highest}}};
}

}  // namespace

Result<void> check_no_channel_dies(const Channels& channels, const std::string& file) {
  if (channels.each.size() < 2) return {};
  for (const Channel& channel : channels.each) {
    std::vector<double> t, y;
    for (std::size_t i = 0; i < channel.y.size(); ++i)
      if (std::isfinite(channel.y[i])) t.push_back(channels.t[i]), y.push_back(channel.y[i]);
    if (const auto lost = find_lost_motion({t, y, channel.resolution}))
      return Error{
          in_file(file, Notice{"channel_dies", {{"column", channel.column}, {"time", t[lost->seen]}}})};
  }
  return {};
}

bool seeks_all(const ModesOptions& options) {
  return !options.from_frequency && !options.to_frequency && !options.modes;
}

Result<ModesResult> found_modes(const Recording& recording, const ModesOptions& options) {
  if (auto good = check_from_before_to(options.from, options.to); !good) return good.error();

  ModesResult result{.file = recording.file, .notices = recording.notices};
  const auto channels = moving_channels(recording, options, result.notices);
  if (!channels) return channels.error();
  if (channels->t.size() < fewest_modal_samples)
    return Error{
        "too_few_samples_for_modes",
        {{"file", recording.file}, {"samples", channels->t.size()}, {"fewest", fewest_modal_samples}}};
  ModalRecord record;
  for (const Channel& each : channels->each) record.channels.emplace_back(each.y);
  set_times(record, channels->t);
  for (const Channel& each : channels->each) result.names.push_back(each.column);
  if (record.channels.size() == 1)
    result.notices.push_back(Notice{"one_channel", {{"column", result.names.front()}}});
  if (Notice drifts = drifting_clock(record); !drifts.empty()) result.notices.push_back(std::move(drifts));

  ModalSettings settings;
  settings.from = options.from_frequency.value_or(0) / two_pi;
  if (options.to_frequency) settings.to = *options.to_frequency / two_pi;
  settings.modes = options.modes.value_or(0);
  settings.from_first_sample = options.from.has_value();
  result.recording = ModalSource{.run = channels->run,
                                 .quantity = channels->quantity,
                                 .unit = channels->unit,
                                 .rate = 1 / record.step,
                                 .found = find_modes(record, settings)};
  const ModalAnalysis& found = result.recording->found;
  const std::size_t used = channels->t.size() - found.still - found.resting, end = found.still + used;
  result.recording->gaps = static_cast<std::size_t>(
      std::count_if(record.starts.begin(), record.starts.end(),
                    [&](std::size_t start) { return start > found.still && start < end; }));
  result.recording->samples = used;
  result.recording->duration = channels->t[end - 1] - channels->t[found.still];
  if (found.resting > 0) result.notices.push_back(Notice{"rests_at_the_end", {{"time", channels->t[end]}}});
  if (found.still > 0) result.notices.push_back(still_before_motion(record, found.still, found.released));
  for (const MeasuredMode& mode : found.modes)
    result.modes.push_back({.frequency = mode.frequency,
                            .damping_ratio = mode.damping_ratio,
                            .shape = mode.shape,
                            .shape_error = mode.shape_error});
  if (found.modes.empty()) {
    result.message = why_no_modes(found, options, 0.5 / record.step);
  } else {
    result.recording->words = motion_in_words(found);
    doubt_modes(found, result.names.size(), seeks_all(options), result.notices);
  }
  return result;
}

}  // namespace cromer::core
