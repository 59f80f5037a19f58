#include "cromer/identify/law_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "cromer/base/state.h"
#include "cromer/identify/diagnose/outliers.h"
#include "cromer/identify/diagnose/refusal.h"
#include "cromer/identify/fit_motion.h"
#include "cromer/identify/fit_settings.h"
#include "cromer/identify/fit_viscous.h"
#include "cromer/identify/motion/damped_phasor.h"

namespace cromer::core {

const Estimate* LawFit::find(std::string_view wanted) const {
  const auto at = std::find(names.begin(), names.end(), wanted) - names.begin();
  return at < static_cast<std::ptrdiff_t>(names.size()) ? &estimates[static_cast<std::size_t>(at)] : nullptr;
}

Estimate* LawFit::find(std::string_view wanted) {
  return const_cast<Estimate*>(std::as_const(*this).find(wanted));
}

Estimate LawFit::operator[](std::string_view wanted) const {
  const Estimate* found = find(wanted);
  return found ? *found : Estimate{};
}

double LawFit::covariance_of(std::string_view a, std::string_view b) const {
  const auto i = std::find(names.begin(), names.end(), a), j = std::find(names.begin(), names.end(), b);
  if (i == names.end() || j == names.end()) return 0;
  const auto row = static_cast<std::size_t>(i - names.begin()),
             column = static_cast<std::size_t>(j - names.begin());
  return covariance[row * names.size() + column];
}

Estimate LawFit::swing_frequency() const {
  constexpr std::string_view spring = "angular_frequency", hysteretic = Hysteresis::coefficients[0].parameter;
  const Estimate w = (*this)[spring];
  const Estimate* stiffness = find(hysteretic);
  if (!stiffness || !(w.value * w.value + stiffness->value > 0)) return w;
  const double together = std::sqrt(w.value * w.value + stiffness->value);
  const double variance = 4 * w.value * w.value * covariance_of(spring, spring) +
                          covariance_of(hysteretic, hysteretic) +
                          4 * w.value * covariance_of(spring, hysteretic);
  return make_estimate(together, std::sqrt(std::max(0.0, variance)) / (2 * together), student);
}

namespace {

LawFit fit_every_sample(const Record& record, const LawFitOptions& options, const Watch& watch) {
  if (const auto refusal = refuse_record(record, options)) return refused(*refusal, options);
  if (watch.interrupted()) return interrupted_fit(options, watch);
  if (options.drive.kind == DriveKind::none && options.law == law_of("viscous"))
    return fit_viscous(record, options, watch);
  if (options.start) return fit_motion(record, options, *options.start, watch);
  const Beginning beginning = begin_fit(record, options, watch);
  if (watch.interrupted()) return interrupted_fit(options, watch);
  if (!beginning.usable()) {
    LawFit fit = beginning.linear;
    fit.law = options.law;
    return fit;
  }
  if (options.drive.kind == DriveKind::harmonic && beginning.linear.law == options.law)
    return beginning.linear;
  return fit_motion(record, options, beginning.known(options.law, record), watch);
}

// The closed form of a derivative of the displacement, where the law has one: the viscous law, which is
// fitted to swings alone. Even of the wildest fit to noise it costs no steps.
std::optional<Parameters> phasor_of(const LawFit& fit, int derivative) {
  if (fit.law != law_of("viscous") || fit.drive.kind != DriveKind::none) return std::nullopt;
  const double w0 = fit.motion.angular_frequency(), g = fit.motion.decay_rate();
  const double w = std::sqrt(std::max(0.0, w0 * w0 - g * g));
  State<double> y{fit.motion.position, fit.motion.velocity};
  for (int i = 0; i < derivative; ++i) y = {y.v, -w0 * w0 * y.x - 2 * g * y.v};
  Parameters phasor{};
  phasor[DampedPhasor::angular_frequency] = w;
  phasor[DampedPhasor::decay_rate] = g;
  phasor[DampedPhasor::equilibrium] = fit.motion.equilibrium;
  phasor[DampedPhasor::cosine] = y.x;
  phasor[DampedPhasor::sine] = (y.v + g * y.x) / w;
  return phasor;
}

}  // namespace

LawFit fit_law(const Record& record, const LawFitOptions& options, const Watch& given) {
  const Watch watch = within_steps(given, record, options.drive.kind);
  const auto fit_all = [&](const Record& samples) { return fit_every_sample(samples, options, watch); };
  if (options.every_sample) return fit_all(record);
  auto settled = settle_outliers(record, fit_all(record), {}, fit_all, residuals_of);
  settled.result.outliers = std::move(settled.aside);
  return std::move(settled.result);
}

std::vector<double> residuals_of(const LawFit& fit, const Record& record) {
  std::vector<double> residuals;
  if (!fit.has_values()) return residuals;
  if (const auto phasor = phasor_of(fit, record.derivative))
    DampedPhasor(record).residuals(*phasor, residuals);
  else
    residuals = motion_residuals(fit.motion, fit.drive, record, fit.step);
  if (residuals.size() != record.t.size()) residuals.clear();
  return residuals;
}

Trajectory motion_of(const LawFit& fit, std::span<const double> t) {
  const auto position = phasor_of(fit, 0), velocity = phasor_of(fit, 1);
  if (!position || t.empty()) return motion_states(fit.motion, fit.drive, t, fit.step);
  const DampedPhasor phasor({t, {}, 0});
  Trajectory motion{{t.begin(), t.end()}, phasor.swing(*position), phasor.swing(*velocity)};
  // One that grows runs away.
  std::size_t finite = t.size();
  while (finite > 0 && !(std::isfinite(motion.x[finite - 1]) && std::isfinite(motion.v[finite - 1])))
    --finite;
  for (auto* values : {&motion.t, &motion.x, &motion.v}) values->resize(finite);
  return motion;
}

}  // namespace cromer::core
