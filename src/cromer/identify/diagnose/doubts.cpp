#include "cromer/identify/diagnose/doubts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cromer/base/pi.h"
#include "cromer/identify/diagnose/amplitude_windows.h"
#include "cromer/identify/diagnose/departures.h"
#include "cromer/identify/diagnose/mean_decay.h"
#include "cromer/identify/diagnose/sample_noise.h"
#include "cromer/identify/diagnose/second_mode.h"

namespace cromer::core {
namespace {

double middle(const AmplitudeWindow& window) { return 0.5 * (window.from + window.to); }

std::vector<AmplitudeWindow> amplitudes(const Record& record, double period) {
  return amplitude_windows(record, 4 * period, 16);
}

// The largest rise of the amplitude from an earlier window to a later.
Notice rise(const Record& record, double period, double noise) {
  const std::vector<AmplitudeWindow> windows = amplitudes(record, period);
  if (windows.size() < 3) return {};
  AmplitudeWindow lowest = windows.front(), from = lowest, to = lowest;
  double largest = lowest.amplitude;
  for (const AmplitudeWindow& window : windows) {
    if (window.amplitude - lowest.amplitude > to.amplitude - from.amplitude) from = lowest, to = window;
    if (window.amplitude < lowest.amplitude) lowest = window;
    largest = std::max(largest, window.amplitude);
  }
  // An amplitude over a window of 16 samples or more is known to half the noise, and to a rounding step.
  if (to.amplitude - from.amplitude < std::max({0.1 * largest, 3 * noise, 2 * record.resolution})) return {};
  const double times = to.amplitude / from.amplitude;
  return Notice{
      "amplitude_rises",
      {{"how", to.amplitude < 2 * from.amplitude ? Notice{"by_percent", {{"percent", 100 * (times - 1)}}}
                                                 : Notice{"so_many_fold", {{"times", times}}}},
       {"from", middle(from)},
       {"to", middle(to)}}};
}

// Whether the largest amplitude is less than `range` times the smallest; false where no amplitude is found.
bool stays_within(double range, const Record& record, double period) {
  double lowest = HUGE_VAL, largest = 0;
  for (const AmplitudeWindow& window : amplitudes(record, period)) {
    lowest = std::min(lowest, window.amplitude);
    largest = std::max(largest, window.amplitude);
  }
  return largest > 0 && largest < range * lowest;
}

// What a drive would look like: an amplitude that hardly falls. Drives are steady to a few percent, and few
// swings in air have a quality factor in the thousands.
Notice steadiness(const Record& record, const LawFit& fit, double period) {
  constexpr double fewest = 20;  // periods
  const double duration = record.t.back() - record.t.front(), periods = duration / period;
  if (periods < fewest) return {};
  if (is_fed(fit)) {
    if (!stays_within(1.1, record, period)) return {};
    return Notice{"swing_keeps_itself", {{"periods", periods}}};
  }
  // The terms may be traded for each other: what falls is known of their sum.
  const std::optional<MeanDecay> decay = mean_decay(fit, record);
  if (!decay) return {};
  const Estimate& rate = decay->rate;
  // A law that does not fit may see no decay where there is one.
  if (!(rate.low > 0))
    return stays_within(1.5, record, period) ? Notice{"swing_does_not_die_down", {{"periods", periods}}}
                                             : Notice{};
  const double fall = 1 - std::exp(-rate.value * duration);
  const double quality = fit.swing_frequency().value / (2 * rate.value);
  if (fall > 0.1 || (fall > 0.02 && quality < 5000)) return {};
  return Notice{"amplitude_hardly_falls",
                {{"percent", 100 * fall}, {"periods", periods}, {"quality_factor", quality}}};
}

// A motion of a step or two, whose decay the noise does not blur into view.
Notice coarseness(const Record& record, const LawFit& fit, std::string_view unit) {
  if (!(record.resolution > 0) || fit.residual.rms > 0.36 * record.resolution) return {};
  const auto [low, high] = std::minmax_element(record.y.begin(), record.y.end());
  const double levels = std::round((*high - *low) / record.resolution) + 1;
  if (levels > 4) return {};
  return Notice{"coarse_levels", {{"levels", levels}, {"resolution", record.resolution}, {"unit", unit}}};
}

// Where a period has many samples, what a wrong law leaves is smooth, and larger than the noise.
bool exceeds_noise(const Record& record, const Residual& left, double noise, double angular_frequency) {
  const double duration = record.t.back() - record.t.front();
  const double samples_per_period =
      two_pi / angular_frequency * static_cast<double>(record.t.size() - 1) / duration;
  return samples_per_period >= 12 && left.autocorrelation > 0.5 &&
         left.rms > std::max(2 * noise, record.resolution) && !is_arithmetic(left.rms, record.y);
}

// What a wrong law leaves dies down with the motion, unlike noise: so many times from the first quarter to
// the last, of correlated noise more.
bool shrinks(std::span<const double> residuals, double times) {
  const auto squares = [](std::span<const double> part) {
    return std::inner_product(part.begin(), part.end(), part.begin(), 0.0);
  };
  const std::size_t quarter = residuals.size() / 4;
  return squares(residuals.first(quarter)) > times * squares(residuals.last(quarter));
}

Notice not_described(const LawFit& fit, double noise, bool only_law) {
  return Notice{only_law ? "law_does_not_describe" : "no_law_describes",
                {{"law", to_text(fit.law)},
                 {"times", std::max(2.0, fit.residual.rms / std::max(noise, 1e-3 * fit.residual.rms))}}};
}

}  // namespace

std::vector<Notice> doubts(const Record& record, const LawFit& fit, bool only_law, std::string_view unit) {
  std::vector<Notice> found;
  const auto say = [&](const Notice& notice) {
    if (!notice.empty()) found.push_back(notice);
  };
  const double period = two_pi / fit.swing_frequency().value;
  const std::vector<double> residuals = residuals_of(fit, record);
  const double noise = noise_of(residuals);
  const Notice rises = is_fed(fit) ? Notice{} : rise(record, period, noise);
  say(rises);
  if (rises.empty()) say(steadiness(record, fit, period));
  say(few_samples(record, fit.swing_frequency().value));
  say(coarseness(record, fit, unit));
  const bool described = residuals.size() != record.t.size() ||
                         !exceeds_noise(record, fit.residual, noise, fit.swing_frequency().value);
  const Notice stop = rises.empty() ? sudden_stop(record, period, unit, described) : Notice{};
  say(stop);
  if (described) return found;
  const bool line = leaves_a_line(record, fit, residuals, fit.swing_frequency().value);
  const Notice zero = stop.empty() ? wandering_zero(record, residuals, unit) : Notice{};
  say(zero);
  constexpr double most = 0.95;  // of the motion's squares: what is left then is no detail
  const bool named = !stop.empty() || !zero.empty();
  if (line || (!named && fit.explained < most)) say(not_described(fit, noise, only_law));
  return found;
}

std::vector<Notice> driven_doubts(const Record& record, const LawFit& fit, std::span<const double> residuals,
                                  double drive, bool only_law, std::string_view unit) {
  if (residuals.size() != record.t.size() || record.t.size() < 32) return {};
  const double noise = noise_of(residuals);
  const Record left{record.t, residuals, record.resolution, record.derivative};
  std::vector<Notice> found = second_drives(left, drive, unit);
  const double fastest = std::max(fit.swing_frequency().value, drive);
  if (!found.empty() && exceeds_noise(record, fit.residual, noise, fastest))
    found.push_back(not_described(fit, noise, only_law));
  return found;
}

bool something_is_left(const Record& record, const LawFit& fit) {
  const std::vector<double> residuals = residuals_of(fit, record);
  if (residuals.size() < 64 || is_arithmetic(fit.residual.rms, record.y)) return false;
  if (fit.residual.rms <= record.resolution) return false;
  if (fit.drive.kind == DriveKind::recorded || !fit.find("angular_frequency")) return !fit.residual.white;
  if (fit.residual.autocorrelation > 0.2 && shrinks(residuals, fit.residual.autocorrelation < 0.5 ? 2 : 4))
    return true;
  // White noise stands out twelve times in one record of eight, which costs a few fits. Correlated noise,
  // whose power is not the same on both sides, does so often, and would be taken for terms.
  const double times = fit.residual.autocorrelation < 0.5 ? 12 : 30;
  for (const double w : {fit.swing_frequency().value, fit.motion.drive_frequency})
    for (int multiple = 1; w > 0 && multiple <= 3; ++multiple)
      if (leaves_a_line(record, fit, residuals, multiple * w, times)) return true;
  return false;
}

Notice widening(const LawFit& fit, std::size_t samples) {
  if (fit.residual.white || !(fit.independent_samples > 0)) return {};
  // What neighbours show, unless that is no more than chance makes.
  const Residual& left = fit.residual;
  const double chance = 2 / std::sqrt(static_cast<double>(samples));
  const bool neighbours = left.strongest_lag == 1 || std::abs(left.autocorrelation) > chance;
  const Notice correlated = neighbours
                                ? Notice{"residuals_correlated", {{"correlation", left.autocorrelation}}}
                                : Notice{"residuals_correlated_apart",
                                         {{"correlation", left.strongest}, {"samples", left.strongest_lag}}};
  if (fit.independent_samples > 0.95 * static_cast<double>(samples))
    return Notice{"uncertainties_hardly_widened", {{"correlated", correlated}}};
  return Notice{"uncertainties_widened",
                {{"correlated", correlated}, {"independent_samples", fit.independent_samples}}};
}

}  // namespace cromer::core
