#include "cromer/identify/noise_of_force_in_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "cromer/identify/least_squares/force_noise.h"
#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/model/law_force.h"
#include "cromer/model/propagate.h"

namespace cromer::core {
namespace {

std::optional<LinearLaw<double>> nearest_linear_law(const LawFit& fit, const Record& record) {
  const Oscillator<double>& law = fit.motion.per_mass;
  if (is_linear(fit.law)) return LinearLaw<double>{.decay_rate = law.damping / 2, .stiffness = law.stiffness};
  if (fit.law.has<Hysteresis>()) return std::nullopt;
  const Trajectory motion = motion_of(fit, record.t);
  NormalEquations sums;
  sums.size = 3;
  for (std::size_t i = 0; i < motion.x.size(); ++i) {
    const double x = motion.x[i], v = motion.v[i], slides = (v > 0) - (v < 0);
    const std::array<double, 3> row = {x, v, 1};
    sums.add_row(row, restoring_force(law, x) + resisting_force<any_terms>(law, fit.law, x, v) +
                          law.friction * slides);
  }
  const LinearFit nearest = solve(sums);
  if (!nearest.ok || !(nearest.x[1] > 0)) return std::nullopt;
  return LinearLaw<double>{.decay_rate = nearest.x[1] / 2, .stiffness = nearest.x[0]};
}

// The body as it answers a force, per unit of what was recorded of it.
struct AnsweringBody {
  LinearLaw<double> law;
  double gain = 1, step = 1;  // step of the grid [s]
  int derivative = 0;         // which is seen

  AnswerToForce answer() const {
    const ImpulseResponse<double> free = impulse_response(law, step);
    AnswerToForce answer;
    answer.transition = {{{free.position, free.g}, {-law.stiffness * free.g, free.slope}}};
    // A force that is held for a step.
    answer.entry = {gain * ramp_response(law, free, step).step, gain * free.g};
    if (derivative == 0) answer.sight = {1, 0};
    if (derivative == 1) answer.sight = {0, 1};
    if (derivative == 2) {
      answer.sight = {-law.stiffness, -2 * law.decay_rate};
      answer.directly = gain;
    }
    return answer;
  }
};

// By the fitted law if it is linear, else by the linear law that is nearest to its force, on average over the
// motion's samples (least squares). Empty under hysteresis, where that law does not damp, and where the
// record has a gap that the grid cuts short.
std::optional<AnsweringBody> answering_body(const LawFit& fit, const Record& record, const SampleGrid& grid) {
  for (std::size_t i = 1; i < record.t.size(); ++i) {
    const double told = grid.step * static_cast<double>(grid.at(i) - grid.at(i - 1));
    if (std::abs(record.t[i] - record.t[i - 1] - told) > grid.step) return std::nullopt;
  }
  const std::optional<LinearLaw<double>> law = nearest_linear_law(fit, record);
  if (!law) return std::nullopt;
  return AnsweringBody{*law, fit.motion.force_gain, grid.step, record.derivative};
}

// By how much noise of variance 1 in each sample of a recorded force moves the estimates, on average: the
// answer to the noise is not in the motion, and the least sum of squares is where the law answers it less.
// With S = the answers' mean sum of squares, H⁻¹ grad S / 2, H⁻¹ the inverse of the normal matrix (of bias by
// errors in variables: W. A. Fuller, Measurement Error Models (1987), chapter 1). By frequency, decay rate
// and gain.
Parameters bias_by_noise(const AnsweringBody& body, double angular_frequency, const FittedParameters& fitted,
                         std::size_t places, const SquareMatrix& inverse_matrix) {
  Parameters bias{}, gradient{};
  const auto slope = [&](std::string_view name, double step, const auto& moved) {
    const int place = fitted.place_of(name);
    if (place >= 0 && step > 0)
      gradient[place] =
          (answer_norm(moved(step).answer(), places) - answer_norm(moved(-step).answer(), places)) /
          (2 * step);
  };
  constexpr double little = 1e-4;
  slope("angular_frequency", little * angular_frequency, [&](double d) {
    AnsweringBody other = body;
    other.law.stiffness += 2 * angular_frequency * d + d * d;
    return other;
  });
  slope("decay_rate", little * body.law.decay_rate, [&](double d) {
    AnsweringBody other = body;
    other.law.decay_rate += d;
    return other;
  });
  slope("force_gain", little * std::abs(body.gain), [&](double d) {
    AnsweringBody other = body;
    other.gain += d;
    return other;
  });
  for (int a = 0; a < fitted.count; ++a)
    for (int b = 0; b < fitted.count; ++b) bias[a] -= inverse_matrix[a][b] * gradient[b] / 2;
  return bias;
}

// What the estimates' noise is with that of a recorded force: of each, the larger variance.
EstimateNoise larger_of(const EstimateNoise& alone, const EstimateNoise& forced, int size) {
  EstimateNoise both = forced;
  Parameters widening{};
  for (int i = 0; i < size; ++i) {
    const double ratio = alone.covariance[i][i] / forced.covariance[i][i];
    widening[i] = std::sqrt(std::max(1.0, ratio));
    if (ratio > 1) both.degrees[i] = alone.degrees[i];
  }
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) both.covariance[i][j] *= widening[i] * widening[j];
  return both;
}

// By how much the standard error grows that grows most.
double largest_growth(const EstimateNoise& alone, const EstimateNoise& forced, int size) {
  double largest = 0;
  for (int i = 0; i < size; ++i)
    largest = std::max(largest, std::sqrt(forced.covariance[i][i] / alone.covariance[i][i]));
  return largest;
}

}  // namespace

EstimateNoise with_noise_of_force(LawFit& fit, const Record& record, const DescribedMinimum& minimum,
                                  std::span<const double> jacobian, const SquareMatrix& inverse_matrix,
                                  const SampleGrid& grid, const EstimateNoise& known) {
  const FittedParameters& fitted = minimum.fitted;
  const std::optional<AnsweringBody> body = answering_body(fit, record, grid);
  if (!body) return known;
  // The force's own samples may be closer than the motion's.
  const double closer = std::sqrt(std::max(1.0, grid.step / fit.drive.force.spacing));
  // White noise would show from sample to sample of the force; a sensor that smooths hides part of it.
  constexpr double smoothed = 2;
  const double seen = noise_of(fit.drive.force.samples);
  const std::optional<ForceNoise> found =
      find_force_noise(grid, minimum.residuals, jacobian, fitted.count, inverse_matrix, body->answer(),
                       smoothed * seen / closer);
  if (!found) return known;
  // What a wrong law leaves may look like noise, too, but not like so much.
  constexpr double most = 0.2, most_smoothed = 8;  // of the force; times what is seen from sample to sample
  const double deviation = found->deviation * closer;
  const auto samples = static_cast<double>(fit.drive.force.samples.size());
  const bool is_plausible = deviation < most * centred_norm(fit.drive.force.samples) / std::sqrt(samples) &&
                            deviation < most_smoothed * seen;
  constexpr double told = 1.05;
  fit.force_noise = {.deviation = deviation,
                     .shows = found->shows && is_plausible,
                     .counts = largest_growth(known, found->of_estimates, fitted.count) > told,
                     .bic = (is_plausible ? found->deviance : found->deviance_without) +
                            fitted.count * std::log(static_cast<double>(minimum.residuals.size()))};
  EstimateNoise both = larger_of(known, found->of_estimates, fitted.count);
  const Parameters bias = bias_by_noise(*body, fit.motion.angular_frequency(), fitted,
                                        grid.at(record.t.size() - 1) + 1, inverse_matrix);
  for (int i = 0; i < fitted.count; ++i)
    for (int j = 0; j < fitted.count; ++j)
      both.covariance[i][j] += found->mean_square * bias[i] * found->mean_square * bias[j];
  return both;
}

}  // namespace cromer::core
