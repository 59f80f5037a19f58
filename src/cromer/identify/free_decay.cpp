#include "cromer/identify/free_decay.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cromer/identify/motion/damped_phasor.h"
#include "cromer/identify/fit_motion.h"
#include "cromer/identify/least_squares/fit_settings.h"
#include "cromer/identify/least_squares/fit_viscous.h"
#include "cromer/identify/diagnose/outliers.h"
#include "cromer/identify/diagnose/refusal.h"

namespace cromer {

std::string_view name(FitStatus status) {
  switch (status) {
    case FitStatus::converged:
      return "converged";
    case FitStatus::iteration_limit:
      return "iteration_limit";
    case FitStatus::no_oscillation:
      return "no_oscillation";
    case FitStatus::too_short:
      return "too_short";
    case FitStatus::too_noisy:
      return "too_noisy";
    case FitStatus::clipped:
      return "clipped";
    case FitStatus::overdamped:
      return "overdamped";
  }
  return "";
}

MotionParameters FreeDecay::motion() const {
  return {.angular_frequency = angular_frequency.value,
          .decay_rate = decay_rate.value,
          .drag = drag ? drag->value : 0,
          .friction = friction ? friction->value : 0,
          .cubic = cubic ? cubic->value : 0,
          .equilibrium = equilibrium.value,
          .position = position.value,
          .velocity = velocity.value,
          .pendulum = law.pendulum};
}

double FreeDecay::covariance_of(std::string_view a, std::string_view b) const {
  const auto i = std::find(names.begin(), names.end(), a), j = std::find(names.begin(), names.end(), b);
  if (i == names.end() || j == names.end()) return 0;
  const auto row = static_cast<std::size_t>(i - names.begin()),
             column = static_cast<std::size_t>(j - names.begin());
  return covariance[row * names.size() + column];
}

namespace {

FreeDecay fit_every_sample(const Record& record, const FreeDecayOptions& options, const Watch& watch) {
  if (const auto refusal = refuse_record(record, options.law)) {
    FreeDecay fit;
    fit.law = options.law;
    fit.status = refusal->status;
    fit.message = refusal->message;
    return fit;
  }
  if (watch.interrupted()) return interrupted_fit(options.law);
  if (options.law == Law{}) return fit_viscous(record, options, watch);
  if (options.start) return fit_motion(record, options, *options.start, watch);
  const Beginning beginning = begin_fit(record, options, watch);
  if (!beginning.usable() || watch.interrupted()) {
    FreeDecay fit = beginning.viscous;
    fit.law = options.law;
    return fit;
  }
  return fit_motion(record, options, beginning.known(options.law, record.t.front()), watch);
}

}  // namespace

FreeDecay fit_free_decay(const Record& record, const FreeDecayOptions& options, const Watch& watch) {
  const auto fit_all = [&](const Record& samples) { return fit_every_sample(samples, options, watch); };
  if (options.every_sample) return fit_all(record);
  auto [fit, aside] = fit_without_outliers(record, fit_all, residuals_of);
  fit.outliers = std::move(aside);
  return std::move(fit);
}

std::vector<double> residuals_of(const FreeDecay& fit, const Record& record) {
  const MotionParameters p = fit.motion();
  std::vector<double> residuals;
  if (!(p.angular_frequency > 0)) return residuals;
  if (!(fit.law == Law{}) || record.derivative != 0) {
    residuals = motion_residuals(p, record, fit.step);
    if (residuals.size() != record.t.size()) residuals.clear();
    return residuals;
  }
  const double w =
      std::sqrt(std::max(0.0, p.angular_frequency * p.angular_frequency - p.decay_rate * p.decay_rate));
  Parameters phasor{};
  phasor[DampedPhasor::angular_frequency] = w;
  phasor[DampedPhasor::decay_rate] = p.decay_rate;
  phasor[DampedPhasor::equilibrium] = p.equilibrium;
  phasor[DampedPhasor::cosine] = p.position;
  phasor[DampedPhasor::sine] = (p.velocity + p.decay_rate * p.position) / w;
  DampedPhasor(record).residuals(phasor, residuals);
  return residuals;
}

Trajectory motion_of(const FreeDecay& fit, std::span<const double> t) {
  return free_motion(fit.motion(), t, fit.step);
}

}  // namespace cromer
