#include "cromer/identify/diagnose/doubts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cromer/base/even_steps.h"
#include "cromer/base/extent.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantile.h"
#include "cromer/base/quantity.h"
#include "cromer/identify/diagnose/mean_decay.h"
#include "cromer/identify/diagnose/second_mode.h"
#include "cromer/identify/fit_settings.h"
#include "cromer/identify/motion/damped_phasor.h"
#include "cromer/identify/record.h"

namespace cromer::core {
namespace {

// Share of the variance of r that one step takes away, at its best place.
struct Step {
  double share = 0, size = 0;
  std::size_t at = 0;
};

Step best_step(std::span<const double> r, double variance) {
  const auto n = static_cast<double>(r.size());
  double total = 0, before = 0;
  for (const double value : r) total += value;
  Step best;
  for (std::size_t i = 1; i < r.size(); ++i) {
    before += r[i - 1];
    const auto left = static_cast<double>(i), right = n - left;
    const double size = (total - before) / right - before / left;
    const double share = left * right / (n * n) * size * size / variance;
    if (share > best.share) best = {share, size, i};
  }
  return best;
}

struct Wandering {
  double line = 0, slope = 0;  ///< of a straight line: its share of the variance, and its slope [unit/s]
  Step step;
};

Wandering wandering_of(const Record& record, std::span<const double> r) {
  const auto n = static_cast<double>(r.size());
  double mean = 0, time = 0;
  for (std::size_t i = 0; i < r.size(); ++i) mean += r[i] / n, time += record.t[i] / n;
  double variance = 0, times = 0, product = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const double dt = record.t[i] - time, dr = r[i] - mean;
    variance += dr * dr / n;
    times += dt * dt / n;
    product += dt * dr / n;
  }
  if (!(variance > 0)) return {};
  return {product * product / (times * variance), product / times, best_step(r, variance)};
}

}  // namespace

double wandering_share(const Record& record, std::span<const double> r) {
  if (r.size() < 2) return 0;
  const Wandering wandering = wandering_of(record, r);
  return std::max(wandering.line, wandering.step.share);
}

Notice wandering_zero(const Record& record, std::span<const double> r, std::string_view unit) {
  constexpr double enough = 0.3;  // of the variance
  if (r.size() < 32) return {};
  const Wandering wandering = wandering_of(record, r);
  if (std::max(wandering.line, wandering.step.share) < enough) return {};
  const double duration = record.t.back() - record.t.front();
  if (wandering.line >= wandering.step.share)
    return Notice{"zero_drifts", {{"drift", wandering.slope * duration}, {"unit", unit}}};
  return Notice{"zero_jumps",
                {{"jump", wandering.step.size}, {"unit", unit}, {"time", record.t[wandering.step.at]}}};
}

namespace {

// The last sample before the swing is stopped: from `begin` to `end` each one is compared with the swing a
// period before, times `ratio`, as those of the period before are.
std::size_t last_free(const Record& record, double begin, double end, double period, double ratio) {
  constexpr double least = 0.02;  // of the amplitude
  constexpr double times = 1.5;
  const auto place = [&](double t) {
    return static_cast<std::size_t>(std::lower_bound(record.t.begin(), record.t.end(), t) - record.t.begin());
  };
  const std::size_t before = place(begin - period), first = place(begin);
  const auto whole = record.y.subspan(before, first - before);
  const double centre = std::accumulate(whole.begin(), whole.end(), 0.0) / static_cast<double>(whole.size());
  const auto off = [&](std::size_t i) {
    const double t = record.t[i] - period;
    const std::size_t k = std::clamp<std::size_t>(place(t), 1, i);
    const double part = (t - record.t[k - 1]) / (record.t[k] - record.t[k - 1]);
    const double swing = record.y[k - 1] + part * (record.y[k] - record.y[k - 1]);
    return std::abs(record.y[i] - centre - ratio * (swing - centre));
  };
  double most = least * sinusoid_amplitude(whole);
  for (std::size_t i = before; i < first; ++i) most = std::max(most, times * off(i));
  std::size_t i = first;
  while (record.t[i] < end && off(i) < most) ++i;
  return i - 1;
}

}  // namespace

std::optional<SwingStop> find_stop(const Record& record, double period, bool described) {
  // Friction stops a motion too, but the amplitude then halves within the last swings. Where a law describes
  // the record, only a stop after a slower fall is reported.
  constexpr double no_friction = 0.7;
  const double least_before = described ? no_friction : 0.6;
  std::vector<AmplitudeWindow> windows = amplitude_windows(record, period, 6);
  if (windows.size() < 8) return std::nullopt;
  // And one window that ends with the record.
  if (const double end = record.t.back(); end > windows.back().to + 0.25 * period) {
    const auto first = std::lower_bound(record.t.begin(), record.t.end(), end - period) - record.t.begin();
    windows.push_back(
        {end - period, end, sinusoid_amplitude(record.y.subspan(static_cast<std::size_t>(first)))});
  }
  double largest = 0;
  for (const AmplitudeWindow& window : windows) largest = std::max(largest, window.amplitude);
  // From the end: the largest amplitude of all that follows, against the one before the window between, or
  // before the two or three in which it is braked. The further back, the less friction has taken there.
  for (const std::size_t back : {2, 3, 4}) {
    const double slow = back == 4 ? 0.8 : no_friction, least = back == 2 ? least_before : slow;
    double later = 0;
    for (std::size_t i = windows.size() - 1; i >= back + 2; --i) {
      later = std::max(later, windows[i].amplitude);
      const double unseen = windows[i].from - windows[i - back].to;
      if (unseen > (static_cast<double>(back) - 0.5) * period) continue;  // a pause: nobody saw it stop
      const double before = windows[i - back].amplitude, earlier = windows[i - back - 2].amplitude;
      // Below half a rounding step nothing is seen of a swing that goes on.
      const bool in_full_swing =
                     before > 0.2 * largest && before > 5 * record.resolution && before > least * earlier,
                 nearly_done =
                     before > 0.03 * largest && before > 10 * record.resolution && before > slow * earlier;
      if (!(in_full_swing || nearly_done) || !(later < 0.1 * before)) continue;
      // It does not come back on the way.
      const auto rises = [&](const AmplitudeWindow& one, const AmplitudeWindow& next) {
        return next.amplitude > one.amplitude + 0.05 * before;
      };
      const auto begin = windows.begin() + static_cast<std::ptrdiff_t>(i - back),
                 end = windows.begin() + static_cast<std::ptrdiff_t>(i + 1);
      if (std::adjacent_find(begin, end, rises) != end) continue;
      const double ratio = std::min(1.0, windows[i - back - 1].amplitude / earlier);
      const std::size_t last = last_free(record, windows[i - back].from, windows[i].from, period, ratio);
      const auto first =
          std::upper_bound(record.t.begin(), record.t.end(), record.t[last] - period) - record.t.begin();
      const auto whole =
          record.y.subspan(static_cast<std::size_t>(first), last + 1 - static_cast<std::size_t>(first));
      return SwingStop{record.t[last], windows[i].from, sinusoid_amplitude(whole)};
    }
  }
  return std::nullopt;
}

Notice SwingStop::notice(const char* code, std::string_view unit) const {
  return {code, {{"from", from}, {"to", to}, {"amplitude", amplitude}, {"unit", unit}}};
}

Notice sudden_stop(const Record& record, double period, std::string_view unit, bool described) {
  const auto stop = find_stop(record, period, described);
  return stop ? stop->notice("swing_stops", unit) : Notice{};
}

Notice few_samples(const Record& record, double w) {
  const EvenSteps steps = even_steps(record.t);
  if (steps.farthest > 0.01 * steps.mean) return {};
  const double rate = 1 / steps.mean, frequency = w / two_pi;
  if (rate / frequency >= 4) return {};
  return Notice{"few_samples_in_a_period",
                {{"samples", rate / frequency},
                 {"rate", rate},
                 {"slower", std::abs(rate - frequency)},
                 {"faster", rate + frequency},
                 {"frequency", frequency}}};
}

Notice turning_over(const Record& record) {
  if (record.derivative != 0 || record.t.size() < 2) return {};
  const auto [low, high] = extent_of(record.y);
  if (high - low <= two_pi) return {};
  // It swings about the last multiple of a turn once it has stayed within half a turn of it.
  const double rest = two_pi * std::round(record.y.back() / two_pi);
  std::size_t last = record.t.size();
  while (std::abs(record.y[last - 1] - rest) < pi) --last;
  const double turns = (high - low) / two_pi;
  // A few samples are no part to fit.
  if (10 * (record.t.size() - last) < record.t.size()) return Notice{"turns_over", {{"turns", turns}}};
  return Notice{"turns_over_at_first", {{"turns", turns}, {"time", record.t[last]}}};
}

bool leaves_a_line(std::span<const double> t, std::span<const double> residuals, double decay_rate, double w,
                   double times, Background noise) {
  const std::size_t n = std::min<std::size_t>(residuals.size(), 20'000);
  if (n < 32) return true;
  const DampedPhasor phasor({t.first(n), residuals.first(n), 0, 0});
  const double resolution = two_pi / (t[n - 1] - t.front());
  const auto power = [&](double at) {
    const DampedPhasor::Linear line = phasor.best_linear(at, 0);
    return line.cosine * line.cosine + line.sine * line.sine;
  };
  const double reach = std::max(3 * resolution, 3 * decay_rate);
  double top = 0;
  for (int k = -12; k <= 12; ++k)
    if (const double at = w + reach * k / 12; at > 0) top = std::max(top, power(at));
  std::vector<double> beside;
  for (int k = 1; k <= 24; ++k)
    for (const double sign : {-1.0, 1.0}) {
      const double at = w + sign * (2 * reach + k * std::max(resolution, (0.5 * w - 2 * reach) / 24));
      if (!(at > 2 * resolution)) continue;
      // Noise that wanders falls with the square of the frequency.
      beside.push_back(power(at) * (noise == Background::may_wander ? (at / w) * (at / w) : 1));
    }
  return top > times * upper_median(beside);
}

bool exceeds_noise(std::span<const double> y, double resolution, double rms, double autocorrelation,
                   double noise) {
  return autocorrelation > 0.5 && rms > std::max(2 * noise, resolution) && !is_arithmetic(rms, y);
}

double times_noise(double rms, double noise) { return std::max(2.0, rms / std::max(noise, 1e-3 * rms)); }

namespace {

double middle(const AmplitudeWindow& window) { return 0.5 * (window.from + window.to); }

std::vector<AmplitudeWindow> amplitudes(const Record& record, double period) {
  return amplitude_windows(record, 4 * period, 16);
}

// How far apart the amplitudes of an even swing may lie by chance, as a share of them, where samples are
// taken at times of their own: six standard deviations of the mean square of a sinusoid at so many phases.
double chance_of_times(const Record& record, double window) {
  const double mean = even_steps(record.t).mean;
  std::size_t odd = 0;
  for (std::size_t i = 1; i < record.t.size(); ++i)
    odd += std::abs(record.t[i] - record.t[i - 1] - mean) > 0.5 * mean;
  return 10 * odd < record.t.size() ? 0 : 6 / std::sqrt(8 * window / mean);
}

// The largest rise of the amplitude from an earlier window to a later, and the largest amplitude.
struct Rise {
  AmplitudeWindow from{}, to{};
  double largest = 0;

  double height() const { return to.amplitude - from.amplitude; }
};

Rise largest_rise(const Record& record, double period) {
  const std::vector<AmplitudeWindow> windows = amplitudes(record, period);
  if (windows.size() < 3) return {};
  AmplitudeWindow lowest = windows.front();
  Rise rise{lowest, lowest, lowest.amplitude};
  for (const AmplitudeWindow& window : windows) {
    if (window.amplitude - lowest.amplitude > rise.height()) rise.from = lowest, rise.to = window;
    if (window.amplitude < lowest.amplitude) lowest = window;
    rise.largest = std::max(rise.largest, window.amplitude);
  }
  return rise;
}

Notice rise(const Record& record, double period, double noise) {
  const Rise found = largest_rise(record, period);
  const auto& [from, to, largest] = found;
  // An amplitude over a window of 16 samples or more is known to half the noise, and to a rounding step.
  const double least = std::max(0.1, chance_of_times(record, 4 * period)) * largest;
  if (!(found.height() > 0) || found.height() < std::max({least, 3 * noise, 2 * record.resolution}))
    return {};
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

// What grows by negative damping, and is bounded by no term.
Notice growth(const Record& record, const LawFit& fit, double period) {
  if (!may_grow(fit.law) || stays_within(1.1, record, period)) return {};
  const Estimate g = fit.decay_rate();
  return Notice{"swing_grows_by_itself", {{"rate", format_quantity({-g.value, g.standard_error}, "1/s")}}};
}

// What a drive would look like: an amplitude that hardly falls. Drives are steady to a few percent, and few
// swings in air have a quality factor in the thousands.
Notice steadiness(const Record& record, const LawFit& fit, double period) {
  constexpr double fewest = 20;  // periods
  const double duration = record.t.back() - record.t.front(), periods = duration / period;
  if (periods < fewest) return {};
  if (is_fed(fit) && !may_grow(fit.law)) {
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
  if (!(record.resolution > 0) || !is_rounding(fit.residual.rms, record.resolution)) return {};
  const auto [low, high] = extent_of(record.y);
  const double levels = std::round((high - low) / record.resolution) + 1;
  if (levels > 4) return {};
  return Notice{"coarse_levels", {{"levels", levels}, {"resolution", record.resolution}, {"unit", unit}}};
}

// Where a period has many samples, what a wrong law leaves is smooth, and larger than the noise.
bool shows_a_wrong_law(const Record& record, const Residual& left, double noise, double angular_frequency) {
  const double duration = record.t.back() - record.t.front();
  const double samples_per_period =
      two_pi / angular_frequency * static_cast<double>(record.t.size() - 1) / duration;
  return samples_per_period >= 12 &&
         exceeds_noise(record.y, record.resolution, left.rms, left.autocorrelation, noise);
}

Notice not_described(const LawFit& fit, double noise, bool only_law) {
  const std::string law = to_text(fit.law);
  const double times = times_noise(fit.residual.rms, noise);
  return Notice{only_law ? "law_does_not_describe" : "no_law_describes",
                {{"law", law},
                 {"times", times},
                 {"what", Notice{only_law ? "law_leaves_much" : "every_law_leaves_much",
                                 {{"law", law}, {"times", times}}}}}};
}

}  // namespace

bool is_of_no_law(const Notice& notice) {
  return notice.code == "no_law_describes" || notice.code == "law_does_not_describe";
}

bool may_rise(const Record& record, double period) {
  constexpr double least = 0.02;  // of the largest amplitude
  const Rise rise = largest_rise(record, period);
  return rise.height() > least * rise.largest;
}

std::vector<Notice> doubts(const Record& record, const LawFit& fit, bool only_law, std::string_view unit) {
  std::vector<Notice> found;
  const auto say = [&](const Notice& notice) {
    if (!notice.empty()) found.push_back(notice);
  };
  const double period = two_pi / fit.swing_frequency().value;
  const std::vector<double> residuals = residuals_of(fit, record);
  const double noise = noise_of(residuals);
  const bool described = residuals.size() != record.t.size() ||
                         !shows_a_wrong_law(record, fit.residual, noise, fit.swing_frequency().value);
  std::vector<double> t, y;
  Record kept = record;
  if (!fit.outliers.empty()) {
    for (std::size_t i = 0; i < record.t.size(); ++i) {
      if (std::binary_search(fit.outliers.begin(), fit.outliers.end(), i)) continue;
      t.push_back(record.t[i]);
      y.push_back(record.y[i]);
    }
    kept.t = t;
    kept.y = y;
  }
  const Notice rises = is_fed(fit) && described ? growth(kept, fit, period) : rise(kept, period, noise);
  say(rises);
  const Notice coarse = coarseness(kept, fit, unit);
  if (rises.empty() && coarse.empty()) say(steadiness(kept, fit, period));
  say(few_samples(record, fit.swing_frequency().value));
  say(coarse);
  const Notice stop = rises.empty() ? sudden_stop(kept, period, unit, described) : Notice{};
  say(stop);
  if (described) return found;
  if (!stop.empty()) {
    // Whether a law describes the swing is seen only without the stop.
    say(Notice{"law_over_a_stop", {{"law", to_text(fit.law)}, {"rms", fit.residual.rms}, {"unit", unit}}});
    return found;
  }
  const bool line = leaves_a_line(record.t, residuals, fit.decay_rate().value, fit.swing_frequency().value,
                                  line_of_a_wrong_law, Background::may_wander);
  const Notice zero = wandering_zero(record, residuals, unit);
  say(zero);
  // Of the motion's squares: what is left then is no detail, or, where it is many times the noise from sample
  // to sample, hardly slow noise.
  constexpr double most = 0.95, most_beside_little_noise = 0.999, many = 6;
  const bool is_much =
      fit.explained < most || (fit.explained < most_beside_little_noise && fit.residual.rms > many * noise);
  if (line || (zero.empty() && is_much)) say(not_described(fit, noise, only_law));
  return found;
}

std::vector<Notice> driven_doubts(const Record& record, const LawFit& fit, std::span<const double> residuals,
                                  double drive, bool only_law, std::string_view unit) {
  if (residuals.size() != record.t.size()) return {};
  const double noise = noise_of(residuals);
  const Record left{record.t, residuals, record.resolution, record.derivative};
  // The body answers noise of a recorded force about its own frequency, and that is no line.
  constexpr double wide = 2;  // half-widths of the resonance
  const double own = fit.swing_frequency().value, reach = wide * std::abs(fit.decay_rate().value);
  const bool is_answered = fit.force_noise && fit.force_noise->shows;
  std::vector<Notice> found =
      second_drives(left, drive, unit, is_answered ? FrequencyBand{own - reach, own + reach} : no_band);
  const double fastest = std::max(fit.swing_frequency().value, drive);
  // What shakes the mount leaves a few times the noise too.
  constexpr double far_more = 10;
  if ((!found.empty() || fit.residual.rms > far_more * noise) &&
      shows_a_wrong_law(record, fit.residual, noise, fastest))
    found.push_back(not_described(fit, noise, only_law));
  return found;
}

bool something_is_left(const Record& record, const LawFit& fit) {
  const std::vector<double> residuals = residuals_of(fit, record);
  if (residuals.size() < 64 || is_arithmetic(fit.residual.rms, record.y)) return false;
  if (fit.residual.rms <= record.resolution) return false;
  if (is_recorded(fit.drive.kind) || !fit.find("angular_frequency")) return !fit.residual.white;
  if (fit.residual.autocorrelation > 0.2 && dies_down(residuals, fit.residual.autocorrelation < 0.5 ? 2 : 4))
    return true;
  // White noise stands out twelve times in one record of eight, which costs a few fits. Correlated noise,
  // whose power is not the same on both sides, does so often, and would be taken for terms.
  const double times = fit.residual.autocorrelation < 0.5 ? 12 : line_of_a_wrong_law;
  for (const double w : {fit.swing_frequency().value, fit.motion.drive_frequency})
    for (int multiple = 1; w > 0 && multiple <= 3; ++multiple)
      if (leaves_a_line(record.t, residuals, fit.decay_rate().value, multiple * w, times)) return true;
  return false;
}

Notice widening(const LawFit& fit, std::size_t samples) {
  if (fit.residual.white || !(fit.independent_samples > 0)) return {};
  // What neighbours show, unless that is no more than chance makes.
  const Residual& left = fit.residual;
  const bool neighbours =
      left.strongest_lag == 1 || std::abs(left.autocorrelation) > 2 * left.autocorrelation_error;
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
