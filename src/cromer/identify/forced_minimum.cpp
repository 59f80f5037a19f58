#include "cromer/identify/forced_minimum.h"
#include "cromer/identify/choose/criterion.h"

namespace cromer {
namespace {

// What lives at zero frequency: its variance widens with the residuals' slow part.
bool is_slow(std::string_view name) { return name == "equilibrium" || name == "force_offset"; }

std::string why(LeastSquaresReason reason, int iterations) {
  switch (reason) {
    case LeastSquaresReason::iteration_limit:
      return fmt::format("the fit has not settled after {} iterations", iterations);
    case LeastSquaresReason::not_finite:
      return "this law's motion runs away from the recorded one";
    default:
      return "the record does not determine this law: its terms cannot be told apart";
  }
}

}  // namespace

double rms_of(std::span<const double> z) {
  double sum = 0;
  for (double value : z)
    if (!std::isnan(value)) sum += value * value;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, samples_of(z))));
}

std::size_t samples_of(std::span<const double> z) {
  return static_cast<std::size_t>(
      std::count_if(z.begin(), z.end(), [](double value) { return !std::isnan(value); }));
}

void integrate_start(Parameters& p, const ForcedLayout& at, double pull, bool observed) {
  const double rest = observed ? p[at.bias] / p[at.stiffness] : 0;
  const double v = p[at.position] - rest, acceleration = p[at.velocity];
  p[at.position] = (pull - 2 * p[at.decay] * v - acceleration) / p[at.stiffness];
  p[at.velocity] = v;
  if (observed) p[at.bias] = rest;
}

Trajectory states_from_rest(Trajectory states, const FreeDecay& law) {
  if (states.x.empty()) return states;
  const double rest = states.x.front() - law.position.value;
  for (double& x : states.x) x -= rest;
  return states;
}

void describe_forced(ForcedFit& fit, const ForcedMinimum& minimum, const ForcedQuantities& quantities,
                     std::span<const double> t, std::span<const double> y, double resolution) {
  FreeDecay& law = fit.law;
  law.iterations = minimum.summary.iterations;
  law.step = minimum.step;
  if (minimum.summary.reason != LeastSquaresReason::converged) {
    law.status = FitStatus::iteration_limit;
    law.message = why(minimum.summary.reason, law.iterations);
  }
  std::vector<double> residuals;
  double mean = 0, norm = 0;
  for (std::size_t i = 0; i < std::min(t.size(), fit.motion.size()); ++i) {
    if (std::isnan(y[i])) continue;
    residuals.push_back(y[i] - fit.motion[i]);
    mean += y[i];
  }
  if (residuals.size() < 2 || fit.motion.size() < t.size()) {
    law.status = FitStatus::iteration_limit;
    law.message = why(LeastSquaresReason::not_finite, 0);
    return;
  }
  const auto n = static_cast<double>(residuals.size());
  mean /= n;
  for (std::size_t i = 0; i < t.size(); ++i)
    if (!std::isnan(y[i])) norm += (y[i] - mean) * (y[i] - mean);
  const std::vector<double> rho = autocorrelations(residuals, first_lags(residuals.size()));
  law.residual = describe_residual(residuals, rho);
  const double sum_of_squares = law.residual.rms * law.residual.rms * n;
  law.explained = 1 - sum_of_squares / norm;

  const double spacing = (t.back() - t.front()) / static_cast<double>(t.size() - 1);
  double widening = 1;
  for (std::size_t i = 0; i < quantities.names.size(); ++i)
    if (quantities.names[i] == "angular_frequency" || quantities.names[i] == "drive_frequency")
      widening = std::max(widening, correlation_factor(residuals, rho, quantities.values[i] * spacing));
  const double slow_widening = correlation_factor(residuals, rho, 0);
  law.independent_samples = n / widening;
  const double k = minimum.summary.equations.size;
  law.student = student_95(std::max(1.0, law.independent_samples - k));
  law.bic = bayesian_criterion(law.independent_samples, law.residual.rms, k);
  const double variance = std::max(sum_of_squares / std::max(1.0, n - k), resolution * resolution / 12);

  const int size = minimum.summary.equations.size;
  const SquareMatrix inverse_matrix = inverse(minimum.summary.equations.matrix, size);
  const std::size_t count = quantities.names.size();
  law.names = quantities.names;
  law.covariance.assign(count * count, 0);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j) {
      double sum = 0;
      for (int a = 0; a < size; ++a)
        for (int b = 0; b < size; ++b)
          sum += quantities.derivatives[i][a] * inverse_matrix[a][b] * quantities.derivatives[j][b];
      const auto wide = [&](std::size_t q) {
        return is_slow(law.names[q]) ? std::max(widening, slow_widening) : widening;
      };
      law.covariance[i * count + j] = variance * sum * std::sqrt(wide(i) * wide(j));
    }
  std::vector<double> bias(count, 0.0);
  for (std::size_t i = 0; i < count; ++i)
    for (int a = 0; a < size; ++a) bias[i] += quantities.derivatives[i][a] * minimum.rounding_bias[a];
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j) law.covariance[i * count + j] += bias[i] * bias[j];
  const auto estimate = [&](std::string_view name) -> std::optional<Estimate> {
    const auto at = std::find(law.names.begin(), law.names.end(), name) - law.names.begin();
    if (at == static_cast<std::ptrdiff_t>(count)) return std::nullopt;
    const auto i = static_cast<std::size_t>(at);
    return make_estimate(quantities.values[i], std::sqrt(std::max(0.0, law.covariance[i * count + i])),
                         law.student);
  };
  law.angular_frequency = *estimate("angular_frequency");
  law.decay_rate = *estimate("decay_rate");
  law.drag = estimate("drag");
  // Neither can be negative.
  law.decay_rate.low = std::max(0.0, law.decay_rate.low);
  if (law.drag) law.drag->low = std::max(0.0, law.drag->low);
  law.cubic = estimate("cubic");
  law.equilibrium = *estimate("equilibrium");
  law.position = *estimate("position");
  law.velocity = *estimate("velocity");
  fit.quadratic = estimate("quadratic");
  fit.force_gain = estimate("force_gain");
  fit.force_offset = estimate("force_offset");
  fit.drive_frequency = estimate("drive_frequency");
  fit.drive_amplitude = estimate("drive_amplitude");
  fit.drive_phase = estimate("drive_phase");
  if (law.decay_rate.value <= 0)
    law.warnings.emplace_back("the decay rate is on its bound 0: the record shows no viscous damping");
  if (law.drag && law.drag->value <= 0)
    law.warnings.emplace_back("the drag is on its bound 0: the record shows none");
}

}  // namespace cromer
