#include "cromer/study/task/decay_by_amplitude.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "cromer/identify/damped_phasor.h"
#include "cromer/identify/levenberg_marquardt.h"

namespace cromer {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double wanted_certainty = 0.05;  // of each rate
constexpr std::size_t most_stretches = 60;

/// Where stretches begin and end, as samples.
struct Span {
  std::size_t first, last;  // one past the end
};

/// The amplitude after `duration`: the averaged law in small steps.
double carried_on(const AmplitudeDecay& decay, double amplitude, double duration) {
  constexpr int steps = 32;
  for (int i = 0; i < steps && amplitude > 0; ++i)
    amplitude *= std::exp(-std::min(5.0, decay.rate(amplitude) * duration / steps));
  return amplitude;
}

class Spans {
 public:
  Spans(const Record& record, const FreeDecay& fit)
      : t_(record.t), decay_(amplitude_decay(fit)), amplitude_(first_amplitude(fit)) {
    const double n = static_cast<double>(t_.size());
    duration_ = t_.back() - t_.front();
    spacing_ = duration_ / (n - 1);
    const double widening = std::max(1.0, n / std::max(1.0, fit.independent_samples));
    noise_ = fit.residual.rms * std::sqrt(widening);
    const double least = duration_ / static_cast<double>(most_stretches);
    shortest_ = std::max({2 * two_pi / decay_.angular_frequency, 12 * spacing_, least});
    longest_ = std::max(duration_ / 6, shortest_);
  }

  std::vector<Span> all() {
    std::vector<Span> result;
    double t = t_.front();
    std::size_t first = 0;
    while (t_.back() - t > 0.75 * shortest_) {
      double length = length_at(amplitude_);
      if (t_.back() - t < 1.5 * length) length = t_.back() - t;  // the rest is no stretch of its own
      const bool ends = t + length > t_.back() - 0.5 * spacing_;
      const std::size_t last =
          ends ? t_.size()
               : static_cast<std::size_t>(std::lower_bound(t_.begin(), t_.end(), t + length) - t_.begin());
      if (last >= first + 12) result.push_back({first, last});
      if (ends) break;
      amplitude_ = carried_on(decay_, amplitude_, length);
      first = last;
      t += length;
    }
    return result;
  }

 private:
  /// sd(b) = sqrt(24 h / T^3) sigma/A of a short stretch.
  double length_at(double amplitude) const {
    const double error = wanted_certainty * decay_.rate(amplitude) * amplitude / noise_;
    const double length = std::cbrt(24 * spacing_ / (error * error));
    return std::isfinite(length) ? std::clamp(length, shortest_, longest_) : longest_;
  }

  std::span<const double> t_;
  AmplitudeDecay decay_;
  double amplitude_, duration_ = 0, spacing_ = 0, noise_ = 0, shortest_ = 0, longest_ = 0;
};

/// One decaying sinusoid through the samples; its frequency is near `w`, which becomes its own.
std::optional<AmplitudeRate> fit_stretch(const Record& part, double& w, double g) {
  const DampedPhasor model(part);
  const DampedPhasor::Linear linear = model.best_linear(w, g);
  Parameters start{};
  start[DampedPhasor::angular_frequency] = w;
  start[DampedPhasor::decay_rate] = g;
  start[DampedPhasor::equilibrium] = linear.equilibrium;
  start[DampedPhasor::cosine] = linear.cosine;
  start[DampedPhasor::sine] = linear.sine;
  LeastSquaresOptions settings;
  double square = 0;
  for (const double y : part.y) square += (y - linear.equilibrium) * (y - linear.equilibrium);
  settings.scale = std::sqrt(square);
  settings.residuals = static_cast<int>(part.t.size());
  settings.lower[DampedPhasor::angular_frequency] = 0.5 * w;
  settings.error_tolerance = 1e-3;
  const LeastSquaresSummary summary = minimise(model, start, settings);
  if (summary.reason != LeastSquaresReason::converged) return std::nullopt;
  constexpr int n = DampedPhasor::parameter_count;
  const double degrees = static_cast<double>(part.t.size()) - n;
  // What the stretch itself leaves: a law that does not fit the whole record widens nothing here.
  std::vector<double> residuals;
  model.residuals(summary.parameters, residuals);
  const double spacing = (part.t.back() - part.t.front()) / static_cast<double>(part.t.size() - 1);
  const double widening = correlation_factor(residuals, w * spacing);
  const double rounding = part.resolution * part.resolution / 12;
  const double variance = std::max(summary.equations.sum_of_squares / degrees, rounding) * widening;
  const SquareMatrix covariance = inverse(summary.equations.matrix, n);
  const Parameters& p = summary.parameters;
  const double rate = p[DampedPhasor::decay_rate];
  const double error = std::sqrt(variance * covariance[DampedPhasor::decay_rate][DampedPhasor::decay_rate]);
  const double from = part.t.front(), to = part.t.back();
  const double middle = std::exp(-rate * 0.5 * (to - from));
  const double amplitude = std::hypot(p[DampedPhasor::cosine], p[DampedPhasor::sine]) * middle;
  if (!std::isfinite(error) || !std::isfinite(amplitude) || !(amplitude > 0)) return std::nullopt;
  w = p[DampedPhasor::angular_frequency];
  const double t = student_95(std::max(1.0, degrees / widening));
  return AmplitudeRate{from, to, amplitude, make_estimate(rate, error, t), 0};
}

}  // namespace

AmplitudeDecay amplitude_decay(const FreeDecay& fit) {
  const MotionParameters p = fit.motion();
  return {.angular_frequency = p.angular_frequency, .decay_rate = p.decay_rate, .drag = p.drag};
}

double first_amplitude(const FreeDecay& fit) {
  const MotionParameters p = fit.motion();
  // Half the stiffness's energy is what counts where there is a cubic term: the turning point has all of it.
  const double w2 = p.angular_frequency * p.angular_frequency;
  const double energy = 0.5 * p.velocity * p.velocity + 0.5 * w2 * p.position * p.position +
                        0.25 * p.cubic * std::pow(p.position, 4);
  double square = 2 * energy / w2;
  if (p.cubic != 0) {
    const double root = w2 * w2 + 4 * p.cubic * energy;
    if (root > 0) square = 4 * energy / (w2 + std::sqrt(root));
  }
  return std::sqrt(square);
}

std::vector<AmplitudeRate> decay_by_amplitude(const Record& record, const FreeDecay& fit,
                                              const Watch& watch) {
  std::vector<AmplitudeRate> result;
  const AmplitudeDecay decay = amplitude_decay(fit);
  const double amplitude = first_amplitude(fit);
  if (record.t.size() < 24 || !(amplitude > 0) || !std::isfinite(amplitude)) return result;
  // A cubic spring's frequency at the first amplitude; from then on each stretch starts from the one before.
  const MotionParameters p = fit.motion();
  double w =
      std::sqrt(std::max(0.25 * p.angular_frequency * p.angular_frequency,
                         p.angular_frequency * p.angular_frequency + 0.75 * p.cubic * amplitude * amplitude));
  double at = amplitude;
  for (const Span& stretch : Spans(record, fit).all()) {
    if (watch.interrupted()) break;
    const std::size_t n = stretch.last - stretch.first;
    const Record part{record.t.subspan(stretch.first, n), record.y.subspan(stretch.first, n),
                      record.resolution};
    auto found = fit_stretch(part, w, decay.rate(at));
    at = carried_on(decay, at, part.t.back() - part.t.front());
    if (!found) continue;
    found->law_rate = decay.rate(found->amplitude);
    if (found->rate.standard_error > std::max(std::abs(found->rate.value), found->law_rate)) continue;
    result.push_back(*found);
  }
  return result;
}

}  // namespace cromer
