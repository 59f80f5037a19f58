#include "cromer/identify/answer_to_force.h"

#include <array>
#include <cmath>
#include <string_view>

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

AnswerToForce answer_of(const LinearLaw<double>& law, double gain, double step, int derivative) {
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

}  // namespace

std::optional<AnswerToForce> answer_to_force(const LawFit& fit, const Record& record,
                                             const SampleGrid& grid) {
  for (std::size_t i = 1; i < record.t.size(); ++i) {
    const double told = grid.step * static_cast<double>(grid.at(i) - grid.at(i - 1));
    if (std::abs(record.t[i] - record.t[i - 1] - told) > grid.step) return std::nullopt;
  }
  const std::optional<LinearLaw<double>> law = nearest_linear_law(fit, record);
  if (!law) return std::nullopt;
  return answer_of(*law, fit.motion.force_gain, grid.step, record.derivative);
}

Parameters force_noise_bias(const LawFit& fit, const FittedParameters& fitted, const Record& record,
                            const SampleGrid& grid, const SquareMatrix& inverse_matrix) {
  const std::optional<LinearLaw<double>> law = nearest_linear_law(fit, record);
  Parameters bias{}, gradient{};
  if (!law) return bias;
  const double gain = fit.motion.force_gain, w = fit.motion.angular_frequency();
  const std::size_t places = grid.at(record.t.size() - 1) + 1;
  const auto norm = [&](const LinearLaw<double>& of, double by) {
    return answer_norm(answer_of(of, by, grid.step, record.derivative), places);
  };
  const auto add = [&](std::string_view name, double step, const auto& at) {
    const int place = fitted.place_of(name);
    if (place >= 0 && step > 0) gradient[place] = (at(step) - at(-step)) / (2 * step);
  };
  constexpr double little = 1e-4;
  add("angular_frequency", little * w, [&](double d) {
    LinearLaw<double> other = *law;
    other.stiffness += 2 * w * d + d * d;
    return norm(other, gain);
  });
  add("decay_rate", little * law->decay_rate, [&](double d) {
    LinearLaw<double> other = *law;
    other.decay_rate += d;
    return norm(other, gain);
  });
  add("force_gain", little * std::abs(gain), [&](double d) { return norm(*law, gain + d); });
  for (int a = 0; a < fitted.count; ++a)
    for (int b = 0; b < fitted.count; ++b) bias[a] -= inverse_matrix[a][b] * gradient[b] / 2;
  return bias;
}

}  // namespace cromer::core
