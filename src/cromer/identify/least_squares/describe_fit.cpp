#include "cromer/identify/least_squares/describe_fit.h"

#include <algorithm>
#include <cmath>

#include "cromer/identify/choose/criterion.h"

namespace cromer {
namespace {

// An equilibrium lives at zero frequency, all else at the oscillation's own: their variances widen
// differently.
struct Widening {
  double oscillation = 1, equilibrium = 1;

  double of(std::string_view parameter) const {
    return parameter == "equilibrium" ? equilibrium : oscillation;
  }
};

// Infinite where a singular matrix left no number.
double standard_error(double variance) {
  return std::isfinite(variance) ? std::sqrt(std::max(0.0, variance)) : HUGE_VAL;
}

void set_undetermined(FreeDecay& fit) {
  fit.status = FitStatus::iteration_limit;
  fit.message = "the record does not determine this law: its terms cannot be told apart";
}

}  // namespace

double centred_norm(std::span<const double> y) {
  double mean = 0, sum = 0;
  for (double value : y) mean += value;
  mean /= static_cast<double>(y.size());
  for (double value : y) sum += (value - mean) * (value - mean);
  return std::sqrt(sum);
}

void describe_fit(FreeDecay& fit, const Record& record, const MotionParameters& motion,
                  const SquareMatrix& inverse_matrix, const Parameters& rounding_bias,
                  std::span<const double> residuals) {
  const FittedParameters fitted = fitted_parameters(fit.law);
  const auto n = static_cast<double>(record.t.size());
  const double h = (record.t.back() - record.t.front()) / (n - 1);
  const std::vector<double> rho = autocorrelations(residuals, first_lags(residuals.size()));
  fit.residual = describe_residual(residuals, rho);
  const double norm = centred_norm(record.y);
  const double sum_of_squares = fit.residual.rms * fit.residual.rms * n;
  fit.explained = 1 - sum_of_squares / (norm * norm);

  const Correlation resting = correlation(residuals, rho, 0);
  const Widening widening{std::min(n, correlation_factor(residuals, rho, motion.angular_frequency * h)),
                          std::min(n, resting.factor)};
  fit.independent_samples = n / widening.oscillation;
  const double k = fitted.count;
  const auto student_of = [&](double degrees) { return student_95(std::max(1.0, degrees - k)); };
  fit.student = student_of(fit.independent_samples);
  fit.bic = bayesian_criterion(fit.independent_samples, fit.residual.rms, k);
  // Each parameter takes as much from the sum of squares as the residuals' spectrum holds where it lives.
  // Rounding alone leaves q^2/12; residuals below that only repeat the rounding's pattern.
  const double remaining = n - (k - 1) * widening.oscillation - widening.equilibrium;
  const double variance = std::max(sum_of_squares / std::max({1.0, n / (k + 1), remaining}),
                                   record.resolution * record.resolution / 12);

  fit.names.clear();
  fit.covariance.assign(static_cast<std::size_t>(fitted.count * fitted.count), 0);
  for (int i = 0; i < fitted.count; ++i) {
    fit.names.emplace_back(fitted.name[i]);
    for (int j = 0; j < fitted.count; ++j)
      fit.covariance[static_cast<std::size_t>(i * fitted.count + j)] =
          variance * inverse_matrix[i][j] *
              std::sqrt(widening.of(fitted.name[i]) * widening.of(fitted.name[j])) +
          rounding_bias[i] * rounding_bias[j];
  }
  const auto estimate = [&](std::string_view parameter, double value) {
    const double student = parameter == "equilibrium" ? student_of(resting.degrees) : fit.student;
    return make_estimate(value, standard_error(fit.covariance_of(parameter, parameter)), student);
  };
  fit.angular_frequency = estimate("angular_frequency", motion.angular_frequency);
  if (fit.law.viscous) fit.decay_rate = estimate("decay_rate", motion.decay_rate);
  if (fit.law.drag) fit.drag = estimate("drag", motion.drag);
  if (fit.law.friction) fit.friction = estimate("friction", motion.friction);
  if (fit.law.cubic) fit.cubic = estimate("cubic", motion.cubic);
  fit.equilibrium = estimate("equilibrium", motion.equilibrium);
  fit.position = estimate("position", motion.position);
  fit.velocity = estimate("velocity", motion.velocity);
  for (int i = 0; i < fitted.count; ++i)
    if (!std::isfinite(fit.covariance_of(fitted.name[i], fitted.name[i]))) set_undetermined(fit);
}

}  // namespace cromer
