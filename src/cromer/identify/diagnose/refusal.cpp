#include "cromer/identify/diagnose/refusal.h"

#include <algorithm>
#include <cmath>

#include "cromer/base/even_steps.h"
#include "cromer/base/extent.h"
#include "cromer/base/pi.h"

namespace cromer::core {
namespace {

// Plateaus at one end of the values: how many there are and how long the longest lasts.
struct Plateaus {
  int count = 0;
  std::size_t longest = 0;  // samples
};

Plateaus plateaus_at(std::span<const double> y, double level, double width) {
  Plateaus plateaus;
  std::size_t run = 0;
  for (std::size_t i = 0; i <= y.size(); ++i) {
    if (i < y.size() && std::abs(y[i] - level) <= width) {
      ++run;
      continue;
    }
    if (run >= 3) ++plateaus.count;
    plateaus.longest = std::max(plateaus.longest, run);
    run = 0;
  }
  return plateaus;
}

// How many levels, one resolution apart, the values span; 0 where they are not rounded.
double levels_of(const Record& record) {
  if (!(record.resolution > 0)) return 0;
  const auto [low, high] = extent_of(record.y);
  return std::round((high - low) / record.resolution) + 1;
}

// So few levels show no tops.
constexpr double few_levels = 3;

// A sinusoid of this amplitude stays within one resolution of its top for this long; flat tops stay longer,
// and at the same value again and again.
bool is_clipped(const Record& record, double amplitude, double w) {
  if (!(amplitude > 0) || (record.resolution > 0 && levels_of(record) <= few_levels)) return false;
  const double h = (record.t.back() - record.t.front()) / static_cast<double>(record.t.size() - 1);
  const double depth = std::clamp(1 - record.resolution / amplitude, -1.0, 1.0);
  const double dwell = 2 * std::acos(depth) / w;
  const auto [low, high] = extent_of(record.y);
  const double width = 0.01 * record.resolution;
  // Half as long again, for tops that are not quite a sinusoid's, and a sample or two at either end.
  for (double level : {low, high}) {
    const Plateaus plateaus = plateaus_at(record.y, level, width);
    if (plateaus.count >= 2 && static_cast<double>(plateaus.longest) * h > 1.5 * dwell + 3 * h) return true;
  }
  return false;
}

// Whether the last third's range is under 5 % of the whole: a turning point at the end has more.
bool comes_to_rest(const Record& record) {
  const auto range = [](std::span<const double> y) {
    const auto [low, high] = extent_of(y);
    return high - low;
  };
  return range(record.y.last(std::max<std::size_t>(1, record.y.size() / 3))) < 0.05 * range(record.y);
}

// Whether the frequency w of the damped swing, sqrt(w0² - g²), is surely not 0. The variance is that of w²/2,
// whose standard error is w times that of w.
bool swings_through(const LawFit& fit, double w) {
  constexpr double surely = 4;  // standard errors of w: one in 30,000 by chance
  const double g = fit.decay_rate().value, w0 = fit.angular_frequency().value;
  const double variance = w0 * w0 * fit.covariance_of("angular_frequency", "angular_frequency") +
                          g * g * fit.covariance_of("decay_rate", "decay_rate") -
                          2 * w0 * g * fit.covariance_of("angular_frequency", "decay_rate");
  // On the border to creeping nothing tells the two apart, and no uncertainty is known.
  constexpr double border = 1e-6;
  return variance > 0 && w * w > std::max(border * w0 * w0, surely * std::sqrt(variance));
}

// Whether more samples see the swing than the law has parameters: any law passes through a few that stick out
// at the beginning of a record in which nothing moves.
bool more_than_spikes(const Record& record, double g, int parameters) {
  const double end = record.t.front() + 3 / std::max(g, 1e-300);
  const auto seen = std::upper_bound(record.t.begin(), record.t.end(), end) - record.t.begin();
  return seen > parameters;
}

}  // namespace

LawFit refused(const Refusal& refusal, const LawFitOptions& options) {
  LawFit fit;
  fit.law = options.law;
  fit.drive = options.drive;
  fit.status = refusal.status;
  fit.message = refusal.message;
  return fit;
}

void refuse(LawFit& fit, const Refusal& refusal) {
  fit.status = refusal.status;
  fit.message = refusal.message;
  fit.notices.clear();
}

std::optional<Refusal> refuse_record(const Record& record, const LawFitOptions& options) {
  const bool driven = options.drive.kind != DriveKind::none;
  if (!options.law.shares(springs) && !is_recorded(options.drive.kind))
    return Refusal{FitStatus::no_oscillation, Notice{"no_spring"}};
  // Three more than there are parameters: what is left must show how well the law fits.
  const int parameters = fitted_parameters(options.law, options.drive.kind).count;
  const auto fewest = static_cast<std::size_t>(driven ? std::max(32, 3 * parameters) : parameters + 3);
  if (record.t.size() < fewest)
    return Refusal{FitStatus::too_short,
                   Notice{"too_few_samples",
                          {{"samples", record.t.size()}, {"law", to_text(options.law)}, {"fewest", fewest}}}};
  const auto [low, high] = extent_of(record.y);
  if (!(high > low)) return Refusal{FitStatus::no_oscillation, Notice{"nothing_moves"}};
  return std::nullopt;
}

namespace {

/// The slowest swing that has the same values at even times as one of angular frequency w.
double slowest_alias(std::span<const double> t, double w) {
  const EvenSteps steps = even_steps(t);
  if (steps.farthest > 0.01 * steps.mean) return w;
  return std::abs(std::remainder(w, two_pi / steps.mean));
}

}  // namespace

std::optional<Refusal> refuse_fit(const Record& record, const LawFit& fit) {
  const double duration = record.t.back() - record.t.front();
  const double g = fit.decay_rate().value, w0 = fit.angular_frequency().value;
  const double w = std::sqrt(std::max(0.0, w0 * w0 - g * g));
  const double amplitude =
      std::pow(w0, record.derivative) *
      std::hypot(fit.position().value, (fit.velocity().value + g * fit.position().value) / w);
  const double seen = slowest_alias(record.t, w), periods = seen * duration / two_pi;

  // Signal power over the noise's at the line's own frequency, times samples: the amplitude is known to one
  // over its root (60: to 13 %, 300: to 6 %, 500: to 4.5 %). White noise reaches 60 at a given frequency with
  // a probability of e^-30; the higher bounds are margins for noise that is not white. What a wrong law
  // leaves lies at that frequency too, and must not count against a long oscillation; wandering noise, in
  // turn, looks like a period or three.
  const double against_noise = fit.explained / std::max(1e-300, 1 - fit.explained) * fit.independent_samples;
  const double visible_periods = w * std::min(duration, 2 / std::max(g, 1e-300)) / two_pi;
  const bool stands_out = more_than_spikes(record, g, fit.fitted) &&
                          (visible_periods >= 4 ? fit.explained > 0.5 || against_noise > 300
                                                : against_noise > (fit.explained > 0.9 ? 60 : 500));
  const bool smooth = fit.explained > 0.9;
  // A motion that dies down within a period shows no more of them, however long it is recorded.
  const bool rests = comes_to_rest(record) || g * duration > 3;
  const bool whole = rests && g > 0.5 * w && fit.status == FitStatus::converged && swings_through(fit, w);
  if (smooth && !whole && (g > 0.95 * w0 || (periods < 1.5 && g > 0.7 * w))) {
    if (rests) return Refusal{FitStatus::overdamped, Notice{"overdamped"}};
    return Refusal{FitStatus::too_short, Notice{"ends_before_an_oscillation"}};
  }
  if (smooth && !whole && periods < 1.5)
    return Refusal{FitStatus::too_short,
                   Notice{"too_few_periods", {{"periods", periods}, {"period", two_pi / seen}}}};
  if (!stands_out) {
    if (const double levels = levels_of(record); levels > 0 && levels <= few_levels)
      return Refusal{FitStatus::too_noisy,
                     Notice{"too_few_levels", {{"levels", levels}, {"resolution", record.resolution}}}};
    const auto n = static_cast<double>(record.t.size());
    if (against_noise > 60 && fit.independent_samples > 0.5 * n)
      return Refusal{FitStatus::too_noisy, Notice{"too_noisy", {{"percent", 100 * fit.explained}}}};
    constexpr double much = 0.3;  // more than what wanders by chance has of a sinusoid
    return Refusal{FitStatus::no_oscillation,
                   Notice{fit.explained > much ? "no_single_decay" : "noise_could_do_as_much",
                          {{"percent", 100 * std::max(0.0, fit.explained)}}}};
  }
  if (is_clipped(record, amplitude, w)) return Refusal{FitStatus::clipped, Notice{"tops_cut_off"}};
  return refuse_frequency(fit);
}

Notice explains_too_little(const LawFit& fit) {
  return Notice{is_recorded(fit.drive.kind) ? "force_explains_too_little" : "oscillations_explain_too_little",
                {{"percent", 100 * std::max(0.0, fit.explained)}}};
}

std::optional<Refusal> refuse_harmonic(const LawFit& fit) {
  const Estimate *w = fit.find("angular_frequency"), *drive = fit.find("drive_frequency"),
                 *g = fit.find("decay_rate");
  if (!w || !drive || !g || g->low > 0) return std::nullopt;
  const double multiple = std::round(w->value / drive->value);
  const double error = 4 * std::hypot(w->standard_error, multiple * drive->standard_error) + 1e-4 * w->value;
  if (multiple < 2 || std::abs(w->value - multiple * drive->value) > error) return std::nullopt;
  // A harmonic is smaller than the line that it belongs to.
  if (const Estimate* push = fit.find("drive_amplitude")) {
    const double line = push->value / (w->value * w->value - drive->value * drive->value),
                 swing = std::hypot(fit.motion.position, fit.motion.velocity / w->value) - line;
    if (swing > line) return std::nullopt;
  }
  return Refusal{FitStatus::no_oscillation,
                 Notice{"only_a_harmonic", {{"frequency", drive->value / two_pi}, {"order", multiple}}}};
}

std::optional<Refusal> refuse_frequency(const LawFit& fit) {
  if (!fit.find("angular_frequency")) return std::nullopt;
  const Estimate w = fit.swing_frequency();
  if (w.standard_error <= 0.05 * w.value) return std::nullopt;
  if (w.standard_error < w.value)
    return Refusal{FitStatus::too_noisy,
                   Notice{"frequency_hardly_known", {{"percent", 100 * w.standard_error / w.value}}}};
  return Refusal{FitStatus::too_noisy, Notice{"frequency_unknown", {{"law", to_text(fit.law)}}}};
}

}  // namespace cromer::core
