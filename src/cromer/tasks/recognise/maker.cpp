#include "cromer/tasks/recognise/maker.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/methods/all.h"
#include "cromer/model/law.h"
#include "cromer/model/linear_quantities.h"
#include "cromer/run/keep.h"
#include "cromer/tasks/methods/step_map_of.h"
#include "cromer/tasks/simulate/run_law.h"

namespace cromer::core {
namespace {

constexpr std::size_t most_unknowns = 5;

/// The origin with its i-th unknown moved by `amount`, in units of the motion and of the law.
Origin moved(Origin origin, std::size_t i, double amount, const Yardstick& yardstick,
             const Freedom& freedom) {
  if (i == 0) origin.start.x += amount * yardstick.x;
  if (i == 1) origin.start.v += amount * yardstick.v;
  if (i < 2) return origin;
  if (i == 2 && freedom.spacing_error > 0) {
    origin.spacing *= 1 + amount;
    return origin;
  }
  if (i == (freedom.spacing_error > 0 ? 3 : 2))
    origin.law.stiffness *= 1 + amount;
  else
    origin.law.damping += amount * std::sqrt(origin.law.stiffness * origin.law.mass);
  return origin;
}

std::size_t unknowns_of(const Freedom& freedom) {
  return 2 + (freedom.spacing_error > 0 ? 1 : 0) + (freedom.law ? 2 : 0);
}

/// What is left of the rows, each over the rms of the motion; empty where the method does not get through.
std::vector<double> residuals(const Maker& maker, const Trajectory& rows, const Yardstick& yardstick,
                              const Origin& origin) {
  const Trajectory made = states_made_by(maker, origin, rows.size());
  if (made.size() < rows.size()) return {};
  std::vector<double> left;
  for (std::size_t i = rows_left_out(maker, rows.size()); i < rows.size(); ++i) {
    left.push_back((made.x[i] - rows.x[i]) / yardstick.x);
    left.push_back((made.v[i] - rows.v[i]) / yardstick.v);
  }
  return left;
}

double sum_of_squares(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

/// What a spacing off that of the times weighs.
double off_times(const Freedom& freedom, const Origin& origin, double spacing) {
  if (!(freedom.spacing_error > 0)) return 0;
  return freedom.rounding * (origin.spacing / spacing - 1) / freedom.spacing_error;
}

Trajectory states_by_steps(const Maker& maker, const Origin& origin, std::size_t rows) {
  const long long k = maker.steps_per_row;
  const auto last = static_cast<double>(rows - 1);
  const double step = origin.spacing / static_cast<double>(k);
  const double until = last * origin.spacing + (maker.velocity_ahead ? step : 0);
  const Interval interval{0, until};
  KeepEvery keep(maker.velocity_ahead ? 1 : k, count_steps(interval, step));
  // A law that runs away would take an adaptive method for ever.
  constexpr int most_looks = 2000;  // at a run, each some hundred steps after the last
  std::atomic<bool> enough = false;
  int looks = 0;
  const Watch watch{.interrupt = &enough,
                    .pulse = [&] { enough = !maker.shows_steps() && ++looks > most_looks; }};
  run_law({.oscillator = origin.law,
           .method = maker.method,
           .settings = maker.settings,
           .interval = interval,
           .start = origin.start,
           .control = {step, maker.settings.newton.tolerance}},
          keep, watch);
  Trajectory states = keep.take();
  if (!maker.velocity_ahead) return states;
  Trajectory shifted;
  for (std::size_t i = 0; i + 1 < states.size(); i += static_cast<std::size_t>(k)) {
    shifted.t.push_back(states.t[i]);
    shifted.x.push_back(states.x[i]);
    shifted.v.push_back(states.v[i + 1]);
  }
  return shifted;
}

using Numbers = std::array<Precise, 3>;
using Matrix = std::array<Numbers, 3>;  ///< by columns

Numbers times(const Matrix& matrix, const Numbers& z) {
  Numbers image{};
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 3; ++i) image[i] += matrix[j][i] * z[j];
  return image;
}

Matrix power(Matrix base, long long exponent) {
  Matrix result{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (; exponent > 0; exponent /= 2) {
    Matrix square;
    for (std::size_t j = 0; j < 3; ++j) {
      if (exponent % 2 != 0) result[j] = times(base, result[j]);
      square[j] = times(base, base[j]);
    }
    base = square;
  }
  return result;
}

Trajectory states_by_map(const Maker& maker, const Origin& origin, std::size_t rows) {
  const double step = origin.spacing / static_cast<double>(maker.steps_per_row);
  const LinearLaw<double> law = linear_law(origin.law);
  const StepMap map = step_map_of(maker.method, maker.settings, law, step);
  const Matrix to_next_row = power(map.column, maker.steps_per_row);
  const auto& [x, v] = origin.start;
  Numbers z{x, step * v, step * step * -(law.stiffness * x + 2 * law.decay_rate * v)};
  Trajectory states;
  for (std::size_t i = 0; i < rows && map.converged; ++i) {
    const double velocity = static_cast<double>(maker.velocity_ahead ? times(map.column, z)[1] : z[1]) / step;
    if (!std::isfinite(static_cast<double>(z[0])) || !std::isfinite(velocity)) break;
    states.t.push_back(static_cast<double>(i) * origin.spacing);
    states.x.push_back(static_cast<double>(z[0]));
    states.v.push_back(velocity);
    z = times(to_next_row, z);
  }
  return states;
}

}  // namespace

bool carries_acceleration(const Maker& maker) {
  return visit_method(maker.method, maker.settings, []<class M>(const M&) {
    return CarriesAcceleration<M, typename M::template Memory<double>>;
  });
}

std::size_t rows_left_out(const Maker& maker, std::size_t rows) {
  constexpr long long steps_to_forget = 60;
  if (!maker.begun_before) return 0;
  const auto needed = static_cast<std::size_t>(steps_to_forget / maker.steps_per_row + 1);
  return std::min(needed, rows / 3);
}

bool Maker::shows_steps() const { return find_method(method)->takes_fixed_steps(); }

Trajectory states_made_by(const Maker& maker, const Origin& origin, std::size_t rows) {
  // Of a linear law the steps from row to row are one matrix, however many they are.
  return maker.shows_steps() && is_linear(law_of(origin.law)) ? states_by_map(maker, origin, rows)
                                                              : states_by_steps(maker, origin, rows);
}

double Yardstick::distance(const Trajectory& one, const Trajectory& other) const {
  const std::size_t size = std::min(one.size(), other.size());
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const double dx = (one.x[i] - other.x[i]) / x, dv = (one.v[i] - other.v[i]) / v;
    sum += dx * dx + dv * dv;
  }
  const double found = std::sqrt(sum / (2 * static_cast<double>(size)));
  return one.size() == other.size() && std::isfinite(found) ? found : std::numeric_limits<double>::infinity();
}

MakerFit fit_maker(const Maker& maker, const Trajectory& rows, const Yardstick& yardstick,
                   const Freedom& freedom, const Origin& guess, int iterations) {
  const std::size_t count = unknowns_of(freedom);
  MakerFit best{guess};
  std::vector<double> left = residuals(maker, rows, yardstick, guess);
  if (left.empty()) return best;
  const auto cost_of = [&](const std::vector<double>& values, const Origin& origin) {
    const double off = off_times(freedom, origin, guess.spacing);
    return sum_of_squares(values) + off * off;
  };
  double cost = cost_of(left, guess);
  for (int i = 0; i < iterations && std::isfinite(cost); ++i) {
    constexpr double small = 1e-6;
    std::array<std::vector<double>, most_unknowns> slopes;
    for (std::size_t j = 0; j < count; ++j) {
      slopes[j] = residuals(maker, rows, yardstick, moved(best.origin, j, small, yardstick, freedom));
      if (slopes[j].size() != left.size()) return best;
      for (std::size_t n = 0; n < left.size(); ++n) slopes[j][n] = (slopes[j][n] - left[n]) / small;
    }
    // Normal equations; unknowns that there are not keep a 1 on their diagonal.
    std::array<std::array<double, most_unknowns>, most_unknowns> matrix{};
    std::array<double, most_unknowns> step{};
    for (std::size_t j = 0; j < most_unknowns; ++j) {
      if (j >= count) {
        matrix[j][j] = 1;
        continue;
      }
      for (std::size_t l = 0; l < count; ++l)
        for (std::size_t n = 0; n < left.size(); ++n) matrix[j][l] += slopes[j][n] * slopes[l][n];
      for (std::size_t n = 0; n < left.size(); ++n) step[j] -= slopes[j][n] * left[n];
    }
    if (freedom.spacing_error > 0) {
      const double weight = freedom.rounding / freedom.spacing_error;
      matrix[2][2] += weight * weight;
      step[2] -= weight * off_times(freedom, best.origin, guess.spacing);
    }
    solve_linear(matrix, step);
    bool better = false;
    for (double share = 1; share > 0.1 && !better; share /= 2) {
      Origin next = best.origin;
      for (std::size_t j = 0; j < count; ++j) next = moved(next, j, share * step[j], yardstick, freedom);
      // Rounding moves the times by no more.
      if (std::abs(next.spacing / guess.spacing - 1) > 2 * freedom.spacing_error ||
          (freedom.law && !(next.law.stiffness > 0)))
        continue;
      std::vector<double> next_left = residuals(maker, rows, yardstick, next);
      if (next_left.empty()) continue;
      const double next_cost = cost_of(next_left, next);
      if (!(next_cost < cost)) continue;
      best.origin = next;
      left = std::move(next_left);
      better = true;
      const bool settled = next_cost > 0.9 * cost;
      cost = next_cost;
      if (settled) i = iterations;
    }
    if (!better) break;
  }
  best.distance = std::sqrt(sum_of_squares(left) / static_cast<double>(left.size()));
  return best;
}

}  // namespace cromer::core
