#include "cromer/identify/rest_minima.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cromer/base/pi.h"
#include "cromer/identify/least_squares/uncertainty.h"
#include "cromer/identify/motion/motion_model.h"

namespace cromer::core {
namespace {

constexpr double ruled_out = 25;  // variances above the lowest sum of squares
constexpr int farthest = 12;      // half swings more or fewer

// A start across the next end of the band and as far again, towards more (side 1) or less friction, in the
// direction that the swing before the rest resists least.
std::optional<Parameters> beyond_the_band(const Record& record, const FittedParameters& fitted,
                                          const Parameters& at, const Rest& rest, int side, double h) {
  const Motion motion = fitted.unpack(at);
  const NormalEquations swing = motion_equations(fitted, at, {}, record.first(rest.first), h);
  const SquareMatrix spread = inverse(swing.matrix, fitted.count);
  Parameters way{};
  double length = 0;
  for (int i = 0; i < fitted.count; ++i) {
    for (int j = 0; j < fitted.count; ++j) way[i] += spread[i][j] * rest.derivative[j];
    length += way[i] * rest.derivative[i];
  }
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  const double to_more = way[fitted.place_of("friction")] > 0 ? side : -side;
  const double band = motion.per_mass.friction / std::pow(motion.angular_frequency(), 2);
  const double to_end = band - to_more * rest.position;
  const double move = to_more * (to_end + std::max(to_end, 0.3 * band)) / length;
  Parameters start = at;
  const Parameters lower = fitted.lower_bounds();
  for (int i = 0; i < fitted.count; ++i) start[i] = std::max(at[i] + move * way[i], lower[i]);
  return start;
}

}  // namespace

std::vector<LeastSquaresSummary> rest_minima(const Record& record, const FittedParameters& fitted,
                                             const LeastSquaresSummary& found,
                                             const LeastSquaresOptions& options, double h,
                                             const Watch& watch) {
  std::vector<LeastSquaresSummary> minima{found};
  const double period = two_pi / fitted.unpack(found.parameters).angular_frequency();
  const Rest middle = rest_of(fitted, found.parameters, record, h);
  const auto rests = [&](const Rest& rest) {
    return rest.first < record.t.size() && record.t.back() - record.t[rest.first] > period &&
           rest.first > static_cast<std::size_t>(2 * fitted.count);
  };
  if (!rests(middle)) return minima;

  const auto model = interruptible(
      [&](const Parameters& parameters) { return motion_equations(fitted, parameters, {}, record, h); },
      watch, steps_through(record.t, h));
  LeastSquaresOptions settings = options;
  settings.error_tolerance = 0.1;
  settings.iteration_limit = 10;
  double lowest = found.equations.sum_of_squares;
  for (const int side : {-1, 1}) {
    Parameters at = found.parameters;
    Rest rest = middle;
    int without_minimum = 0;
    for (int i = 0; i < farthest && without_minimum < 2 && !watch.interrupted(); ++i) {
      const std::optional<Parameters> start = beyond_the_band(record, fitted, at, rest, side, h);
      if (!start) break;
      const Rest expected = rest_of(fitted, *start, record, h);
      if (!rests(expected) || expected.half_swings == rest.half_swings) break;
      LeastSquaresSummary next = minimise(model, *start, settings);
      const Rest reached = rest_of(fitted, next.parameters, record, h);
      const bool stays = reached.half_swings == expected.half_swings && rests(reached);
      at = stays ? next.parameters : *start;
      rest = stays ? reached : expected;
      // One that slides back over the end of the band has its minimum there, which is known.
      without_minimum = stays ? 0 : without_minimum + 1;
      if (!stays) continue;
      const double sum = next.equations.sum_of_squares;
      const double variance =
          lowest / std::max(1.0, static_cast<double>(record.t.size()) - static_cast<double>(fitted.count));
      if (!(sum < lowest + ruled_out * variance)) break;
      lowest = std::min(lowest, sum);
      minima.push_back(std::move(next));
    }
  }
  std::stable_sort(minima.begin(), minima.end(), [](const auto& a, const auto& b) {
    return a.equations.sum_of_squares < b.equations.sum_of_squares;
  });
  return minima;
}

LeastSquaresSummary end_of_band_minimum(const Record& record, const FittedParameters& fitted,
                                        const LeastSquaresSummary& found, const LeastSquaresOptions& options,
                                        double h, const Watch& watch) {
  const int f = fitted.place_of("friction"), w = fitted.place_of("angular_frequency");
  const auto band_at = [&](const Parameters& p) { return p[f] / (p[w] * p[w]); };
  const Rest middle = rest_of(fitted, found.parameters, record, h);
  const auto resting = static_cast<double>(record.t.size() - std::min(record.t.size(), middle.first));
  if (resting == 0 || std::abs(middle.position) < 0.9 * band_at(found.parameters)) return found;

  // One more reading, so exact that the position of rest stays on the end.
  const double side = middle.position > 0 ? 1 : -1, weight = 1e4 * resting;
  const auto model = interruptible(
      [&](const Parameters& parameters) {
        NormalEquations equations = motion_equations(fitted, parameters, {}, record, h);
        const Rest rest = rest_of(fitted, parameters, record, h);
        const double band = band_at(parameters), off = side * band - rest.position;
        Parameters row = rest.derivative;
        row[f] -= side / (parameters[w] * parameters[w]);
        row[w] += side * 2 * band / parameters[w];
        for (int i = 0; i < fitted.count; ++i) {
          equations.right[i] += weight * row[i] * off;
          for (int j = 0; j < fitted.count; ++j) equations.matrix[i][j] += weight * row[i] * row[j];
        }
        equations.sum_of_squares += weight * off * off;
        return equations;
      },
      watch, steps_through(record.t, h));
  LeastSquaresOptions settings = options;
  settings.error_tolerance = 1e-2;
  LeastSquaresSummary at = minimise(model, found.parameters, settings);
  at.equations = motion_equations(fitted, at.parameters, {}, record, h);
  const double variance = found.equations.sum_of_squares / static_cast<double>(record.t.size());
  const bool as_low = at.equations.sum_of_squares < found.equations.sum_of_squares + 0.1 * variance;
  return as_low && at.reason == LeastSquaresReason::converged ? at : found;
}

namespace {

// One of several minima in one parameter: a component of the mixture of their distributions.
struct Component {
  double weight, centre, deviation;
};

// The value below which the share p of the mixture lies.
double mixture_quantile(const std::vector<Component>& mixture, double p, double degrees) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Component& component : mixture) {
    const double reach = student_quantile(0.9999, degrees) * component.deviation;
    low = std::min(low, component.centre - reach);
    high = std::max(high, component.centre + reach);
  }
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    double below = 0;
    for (const Component& component : mixture)
      below += component.weight * student_cdf((middle - component.centre) / component.deviation, degrees);
    (below < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

void spread_over(LawFit& fit, const FittedParameters& fitted,
                 const std::vector<LeastSquaresSummary>& minima) {
  if (minima.size() < 2) return;
  const int n = fitted.count;
  const auto entry = [&](int i, int j) -> double& {
    return fit.covariance[static_cast<std::size_t>(i * n + j)];
  };
  // The factors that make variances of the inverse normal matrix.
  const SquareMatrix own = inverse(minima.front().equations.matrix, n);
  Parameters scale{};
  double widest = 0;
  for (int i = 0; i < n; ++i) widest = std::max(widest, scale[i] = entry(i, i) / own[i][i]);
  if (!std::isfinite(widest) || !(widest > 0)) return;

  const auto log_determinant = [n](const LeastSquaresSummary& minimum) {
    return ScaledCholesky(minimum.equations.matrix, n, 0, all_free).log_determinant();
  };
  std::vector<double> weights;
  double total = 0;
  for (const LeastSquaresSummary& minimum : minima) {
    const double above = minimum.equations.sum_of_squares - minima.front().equations.sum_of_squares;
    const double narrower = log_determinant(minimum) - log_determinant(minima.front());
    weights.push_back(std::exp(-0.5 * (above / widest + narrower)));
    total += weights.back();
  }
  for (double& weight : weights) weight /= total;

  std::vector<double> covariance(fit.covariance.size());
  std::vector<std::vector<Component>> mixtures(static_cast<std::size_t>(n));
  for (std::size_t k = 0; k < minima.size(); ++k) {
    const SquareMatrix spread = inverse(minima[k].equations.matrix, n);
    if (!std::isfinite(spread[0][0])) return;
    for (int i = 0; i < n; ++i) {
      const double off = minima[k].parameters[i] - minima.front().parameters[i];
      mixtures[static_cast<std::size_t>(i)].push_back(
          {weights[k], minima[k].parameters[i], std::sqrt(scale[i] * spread[i][i])});
      for (int j = 0; j < n; ++j)
        covariance[static_cast<std::size_t>(i * n + j)] +=
            weights[k] * (std::sqrt(scale[i] * scale[j]) * spread[i][j] +
                          off * (minima[k].parameters[j] - minima.front().parameters[j]));
    }
  }
  fit.covariance = std::move(covariance);
  const double degrees = std::max(1.0, fit.independent_samples - n);
  for (int i = 0; i < n; ++i) {
    Estimate& estimate = *fit.find(fitted.of[i].name);
    const auto& mixture = mixtures[static_cast<std::size_t>(i)];
    estimate.standard_error = std::sqrt(entry(i, i));
    estimate.low = std::min(mixture_quantile(mixture, 0.025, degrees), estimate.value);
    estimate.high = std::max(mixture_quantile(mixture, 0.975, degrees), estimate.value);
    if (fitted.of[i].is_never_negative()) estimate.low = std::max(estimate.low, 0.0);
  }

  const double second = *std::max_element(weights.begin() + 1, weights.end());
  if (second > 0.05)
    fit.notices.push_back(Notice{"half_swings_before_rest_unsure", {{"percent", 100 * second}}});
}

}  // namespace cromer::core
