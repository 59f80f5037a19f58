#include "cromer/identify/describe_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>

#include "cromer/base/dual.h"
#include "cromer/base/extent.h"
#include "cromer/identify/choose/criterion.h"
#include "cromer/identify/diagnose/mean_decay.h"
#include "cromer/identify/diagnose/slip.h"
#include "cromer/identify/least_squares/noise.h"
#include "cromer/identify/noise_of_force_in_fit.h"

namespace cromer::core {
namespace {

// Beyond so many samples correlation is known without their Jacobian.
constexpr std::size_t most_filtered = 1'000'000;

// The inverse of the normal matrix where the record determines it, and which parameters it does not.
struct Inverse {
  SquareMatrix matrix{};
  std::array<bool, max_parameters> unknown{};
  std::vector<Notice> known;  ///< clauses: the combinations that are known instead

  bool determined() const { return std::find(unknown.begin(), unknown.end(), true) == unknown.end(); }
};

Inverse inverse_of(const SquareMatrix& normal, const FittedParameters& fitted) {
  const int n = fitted.count;
  Inverse result;
  if (ScaledCholesky(normal, n, 0, all_free).ok()) {
    result.matrix = inverse(normal, n);
    return result;
  }
  // Of unit diagonal: the parameters' units then do not matter.
  Eigen::MatrixXd scaled = Eigen::MatrixXd::Zero(n, n);
  Parameters scale{};
  for (int i = 0; i < n; ++i) scale[i] = normal[i][i] > 0 ? 1 / std::sqrt(normal[i][i]) : 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) scaled(i, j) = normal[i][j] * scale[i] * scale[j];
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled);
  constexpr double flat = 1e-13, takes_part = 1e-3;
  for (int k = 0; k < n; ++k) {
    const double value = solver.eigenvalues()(k);
    std::vector<int> parts;
    for (int i = 0; i < n; ++i) {
      const double share = solver.eigenvectors()(i, k);
      if (value <= flat && std::abs(share) > takes_part) {
        result.unknown[i] = true;
        parts.push_back(i);
      }
      if (value > flat)
        for (int j = 0; j < n; ++j)
          result.matrix[i][j] += share * solver.eigenvectors()(j, k) / value * scale[i] * scale[j];
    }
    if (parts.empty()) continue;
    Notice names;
    for (const int i : parts) {
      const Notice name = parameter_named(fitted.of[i].name, fitted.held.law);
      names = names.empty() ? name : Notice{"and_also", {{"one", names}, {"other", name}}};
    }
    result.known.push_back(Notice{parts.size() == 1 ? "parameter_not_shown" : "only_combination_known",
                                  {{"parameters", names}}});
  }
  return result;
}

// The parameters that people read, with their derivatives by the fitted ones.
struct ReadParameters {
  std::vector<std::string> names;
  std::vector<double> values;
  std::vector<Parameters> derivatives;
  std::vector<int> place;  ///< among the fitted parameters; -1 where it is made of several or held

  void add(std::string_view name, double value, const Parameters& derivative, int at) {
    names.emplace_back(name);
    values.push_back(value);
    derivatives.push_back(derivative);
    place.push_back(at);
  }
};

ReadParameters read_parameters(const FittedParameters& fitted, const Parameters& p, DriveKind drive,
                               int derivative) {
  ReadParameters list;
  const int cosine = fitted.place_of("drive_cosine");
  const Motion motion = fitted.unpack(p);
  const auto held = [&](std::string_view name, double value) {
    if (fitted.place_of(name) < 0) list.add(name, value, {}, -1);
  };
  for (int i = 0; i < fitted.count; ++i) {
    if (fitted.of[i].name == "equilibrium" ||
        (i > 0 && fitted.of[i].name == "position" && fitted.place_of("equilibrium") < 0)) {
      if (is_recorded(drive) && derivative == 0) held("force_offset", motion.force_offset);
      if (motion.law.shares(springs)) held("equilibrium", motion.equilibrium);
    }
    if (cosine >= 0 && (i == cosine || i == cosine + 1)) continue;
    Parameters unit{};
    unit[i] = 1;
    list.add(fitted.of[i].name, p[i], unit, i);
    if (cosine < 0 || fitted.of[i].name != "drive_frequency") continue;
    // C cos + S sin = A cos(w s + phase)
    using Real = Dual<double, 2>;
    const Real C = Real::variable(p[cosine], 0), S = Real::variable(p[cosine + 1], 1);
    const auto add = [&](std::string_view name, const Real& value) {
      Parameters by{};
      by[cosine] = value.derivative[0];
      by[cosine + 1] = value.derivative[1];
      list.add(name, value.value, by, -1);
    };
    add("drive_amplitude", hypot(C, S));
    add("drive_phase", atan2(-S, C));
  }
  return list;
}

// Whether the record determines the estimates, and is not too long to follow its noise.
bool is_followed(const DescribedMinimum& minimum, const Inverse& inverse, const Noise& noise) {
  return minimum.jacobian && inverse.determined() && noise.samples <= most_filtered;
}

// Whether the noise makes a difference to the estimates as well.
bool is_filtered(const DescribedMinimum& minimum, const Inverse& inverse, const Noise& noise) {
  return is_followed(minimum, inverse, noise) && !noise.is_plain() && noise.correlation.may_be_noise();
}

EstimateNoise known_of(LawFit& fit, const Record& record, const DescribedMinimum& minimum,
                       const Inverse& inverse, const Noise& noise) {
  const FittedParameters& fitted = minimum.fitted;
  const auto n = static_cast<double>(noise.samples);
  const double k = fitted.count;
  EstimateNoise known;
  const bool is_asked = is_recorded(fit.drive.kind) && is_followed(minimum, inverse, noise),
             filtered = is_filtered(minimum, inverse, noise);
  std::vector<double> jacobian;
  if (is_asked || filtered) jacobian = minimum.jacobian();
  if (filtered && !jacobian.empty()) {
    known = estimate_noise(jacobian, fitted.count, noise, record.resolution);
  } else {
    // All parameters are taken at the swing's own frequency, those that live at rest also at zero
    // frequency.
    const double w = fit.motion.angular_frequency();
    const auto widening = [&](double at) {
      return std::clamp(noise.correlation.density(at * noise.grid.step), 1.0, n);
    };
    const double own = widening(std::max(w, fit.motion.drive_frequency)), resting = widening(0);
    const auto of = [&](int i) { return fitted.of[i].lives_at_rest ? std::max(own, resting) : own; };
    const double variance = std::max(noise.sum_of_squares / std::max({1.0, n / (k + 1), n - k * own}),
                                     record.resolution * record.resolution / 12);
    for (int i = 0; i < fitted.count; ++i) {
      known.degrees[i] = std::max(1.0, n / of(i) - k);
      for (int j = 0; j < fitted.count; ++j)
        known.covariance[i][j] = variance * inverse.matrix[i][j] * std::sqrt(of(i) * of(j));
    }
  }
  if constexpr (fits_recorded_forces)
    if (is_asked && !jacobian.empty())
      known = with_noise_of_force(fit, record, minimum, jacobian, inverse.matrix, noise.grid, known);
  for (int i = 0; i < fitted.count; ++i)
    for (int j = 0; j < fitted.count; ++j)
      known.covariance[i][j] += minimum.rounding_bias[i] * minimum.rounding_bias[j];
  return known;
}

// Jᵀ d: what the errors d of the samples weigh in the normal equations.
Parameters weighed(std::span<const double> errors, int k, std::span<const double> jacobian) {
  Parameters along{};
  for (std::size_t i = 0; i < errors.size(); ++i)
    for (int a = 0; a < k; ++a) along[a] += jacobian[i * static_cast<std::size_t>(k) + a] * errors[i];
  return along;
}

// What errors move the estimates by, of which `along` is Jᵀ d.
Parameters moved_by(const Parameters& along, int k, const SquareMatrix& inverse) {
  Parameters moved{};
  for (int a = 0; a < k; ++a)
    for (int b = 0; b < k; ++b) moved[a] += inverse[a][b] * along[b];
  return moved;
}

// The estimates move together, by so much for one standard error.
void add_moved(EstimateNoise& known, const Parameters& moved, int k) {
  for (int a = 0; a < k; ++a)
    for (int b = 0; b < k; ++b) known.covariance[a][b] += moved[a] * moved[b];
}

void add_common_error(EstimateNoise& known, const Parameters& along, int k, const SquareMatrix& inverse) {
  add_moved(known, moved_by(along, k, inverse), k);
}

// What a slip of one second adds to each sample after it: minus the motion's derivative.
std::vector<double> slip_of_a_second(const Record& record, std::span<const double> motion) {
  const std::size_t n = motion.size();
  std::vector<double> added(n);
  const auto first = static_cast<std::size_t>(
      std::lower_bound(record.t.begin(), record.t.end(), record.slips_at) - record.t.begin());
  for (std::size_t i = first; i < n; ++i) {
    const std::size_t before = std::max(first, i - 1), after = std::min(n - 1, i + 1);
    if (after > before) added[i] = (motion[before] - motion[after]) / (record.t[after] - record.t[before]);
  }
  return added;
}

// Adds to the covariance what the estimates would change without the samples [from, to): by Jᵀ J and Jᵀ r of
// the rest. Nothing where the rest does not tell them.
void add_change_without(EstimateNoise& known, std::size_t from, std::size_t to,
                        const DescribedMinimum& minimum, std::span<const double> jacobian) {
  const int k = minimum.fitted.count;
  SquareMatrix rest = minimum.matrix;
  Parameters along{};
  for (std::size_t i = from; i < to; ++i) {
    const std::span<const double> row = jacobian.subspan(i * static_cast<std::size_t>(k));
    for (int a = 0; a < k; ++a) {
      along[a] -= row[a] * minimum.residuals[i];
      for (int b = 0; b < k; ++b) rest[a][b] -= row[a] * row[b];
    }
  }
  if (!ScaledCholesky(rest, k, 0, all_free).ok()) return;
  Parameters moved = moved_by(along, k, inverse(rest, k));
  // Where the motion begins is seen, whatever a hand does later.
  for (int i = 0; i < k; ++i)
    if (is_of_the_start(minimum.fitted.of[i].name)) moved[i] = 0;
  add_moved(known, moved, k);
}

// Errors common to many samples: of the unit of the values, as of a motion that is larger by as much (all),
// of a slip of the times, which is one parameter more (those after it), and of ends that a hand may move.
void add_common_errors(EstimateNoise& known, const Record& record, const DescribedMinimum& minimum,
                       const Inverse& inverse, std::span<const double> motion, double variance) {
  const bool slips = looks_for_slips && record.slips_at < HUGE_VAL;
  const bool handled = record.handled_first > 0 || record.handled_last > 0;
  if ((!(record.scale_error > 0) && !slips && !handled) || !minimum.jacobian || !inverse.determined()) return;
  const int k = minimum.fitted.count;
  const std::vector<double> jacobian = minimum.jacobian();
  if (jacobian.empty()) return;
  const auto place = [&](double time) {
    return static_cast<std::size_t>(std::lower_bound(record.t.begin(), record.t.end(), time) -
                                    record.t.begin());
  };
  if (record.handled_first > 0)
    add_change_without(known, 0, place(record.t.front() + record.handled_first), minimum, jacobian);
  if (record.handled_last > 0)
    add_change_without(known, place(record.t.back() - record.handled_last), record.t.size(), minimum,
                       jacobian);
  if (record.scale_error > 0) {
    Parameters along = weighed(record.y, k, jacobian);
    for (double& each : along) each *= record.scale_error;
    add_common_error(known, along, k, inverse.matrix);
  }
  if (!slips) return;
  const std::vector<double> of_slip = slip_of_a_second(record, motion);
  Parameters along = weighed(of_slip, k, jacobian);
  double left = 0;  // of its square, that no other parameter can take
  for (const double each : of_slip) left += each * each;
  for (int a = 0; a < k; ++a)
    for (int b = 0; b < k; ++b) left -= along[a] * inverse.matrix[a][b] * along[b];
  if (!(left > 0)) return;
  for (double& each : along) each *= std::sqrt(variance / left);
  add_common_error(known, along, k, inverse.matrix);
}

// Of two parameters that are hardly known, the ratio that is: flat to the noise, not to rounding.
Notice known_ratio(const LawFit& fit, const FittedParameters& fitted) {
  constexpr double hardly = 0.3, much_better = 0.01;  // relative standard errors
  for (int i = 0; i < fitted.count; ++i)
    for (int j = 0; j < i; ++j) {
      const Estimate *a = fit.find(fitted.of[i].name), *b = fit.find(fitted.of[j].name);
      if (!a || !b || a->value == 0 || b->value == 0) continue;
      if (is_of_the_start(fitted.of[i].name)) continue;
      const double of_a = a->standard_error / std::abs(a->value),
                   of_b = b->standard_error / std::abs(b->value);
      if (!(of_a > hardly && of_b > hardly)) continue;
      const double covariance =
          fit.covariance_of(fitted.of[i].name, fitted.of[j].name) / (a->value * b->value);
      const double of_ratio = std::sqrt(std::max(0.0, of_a * of_a + of_b * of_b - 2 * covariance));
      if (of_ratio < much_better * std::min(of_a, of_b))
        return Notice{"only_ratio_known",
                      {{"one", parameter_named(fitted.of[i].name, fitted.held.law)},
                       {"other", parameter_named(fitted.of[j].name, fitted.held.law)},
                       {"ratio", a->value / b->value},
                       {"error", of_ratio * std::abs(a->value / b->value)}}};
    }
  return {};
}

void say_bounds(LawFit& fit, const FittedParameters& fitted, const Record& record) {
  Notice cut;
  for (int i = 0; i < fitted.count; ++i) {
    if (fitted.of[i].may_be_negative) continue;
    const Estimate& term = *fit.find(fitted.of[i].name);
    if (term.low > 0) continue;
    const Notice name = parameter_named(fitted.of[i].name, fitted.held.law);
    cut = cut.empty() ? name : Notice{"and_the", {{"one", cut}, {"other", name}}};
  }
  if (cut.empty()) return;
  const std::optional<MeanDecay> sum = mean_decay(fit, record);
  if (fit.drive.kind == DriveKind::none && sum && dampings_are_collinear(fit)) {
    fit.notices.push_back(Notice{"dampings_not_told_apart",
                                 {{"law", to_text(fit.law)}, {"sum", as_clause(*sum)}, {"parameters", cut}}});
    return;
  }
  for (int i = 0; i < fitted.count; ++i) {
    if (fitted.of[i].may_be_negative) continue;
    const Estimate& term = *fit.find(fitted.of[i].name);
    if (!(term.value <= 0 || term.low <= 0)) continue;
    const Notice what = parameter_named(fitted.of[i].name, fitted.held.law);
    const Notice damping = fitted.of[i].name == "decay_rate" ? Notice{"viscous_damping"}
                           : fitted.of[i].name == "friction" ? Notice{"dry_friction"}
                                                             : what;
    fit.notices.push_back(Notice{term.value <= 0 ? "parameter_on_bound" : "interval_cut_at_bound",
                                 {{"parameter", what}, {"damping", damping}}});
  }
}

}  // namespace

void describe_fit(LawFit& fit, const Record& record, const DescribedMinimum& minimum) {
  const FittedParameters& fitted = minimum.fitted;
  const std::span<const double> residuals = minimum.residuals;
  fit.motion = fitted.unpack(minimum.parameters);
  fit.fitted = fitted.count;
  const SampleGrid grid = find_grid(record.t);
  const std::vector<double> rho = autocorrelations(residuals, grid, first_lags(residuals.size()));
  fit.residual = describe_residual(residuals, rho, grid);
  const auto n = static_cast<double>(residuals.size());
  const double norm = centred_norm(record.y);
  fit.explained = 1 - fit.residual.rms * fit.residual.rms * n / (norm * norm);

  std::vector<double> motion(residuals.size());
  for (std::size_t i = 0; i < motion.size(); ++i) motion[i] = record.y[i] - residuals[i];
  const Noise noise = find_noise(grid, residuals, motion, rho);
  const double w = std::max(fit.motion.angular_frequency(), fit.motion.drive_frequency);
  fit.independent_samples = n / std::clamp(noise.correlation.density(w * noise.grid.step), 1.0, n);
  const double k = fitted.count;
  fit.student = student_95(std::max(1.0, fit.independent_samples - k));
  fit.bic = bayesian_criterion(fit.independent_samples, fit.residual.rms, k, 0);

  const Inverse inverse = inverse_of(minimum.matrix, fitted);
  EstimateNoise known = known_of(fit, record, minimum, inverse, noise);
  const double variance = noise.sum_of_squares / std::max(1.0, fit.independent_samples - fitted.count);
  add_common_errors(known, record, minimum, inverse, motion, variance);
  const ReadParameters quantities =
      read_parameters(fitted, minimum.parameters, fit.drive.kind, record.derivative);
  const std::size_t count = quantities.names.size();
  fit.names = quantities.names;
  fit.estimates.clear();
  fit.covariance.assign(count * count, 0);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j)
      for (int a = 0; a < fitted.count; ++a)
        for (int b = 0; b < fitted.count; ++b)
          fit.covariance[i * count + j] +=
              quantities.derivatives[i][a] * known.covariance[a][b] * quantities.derivatives[j][b];
  // A frequency is only as well known as the clock. What else counts in seconds is known less well anyway.
  for (std::size_t i = 0; i < count; ++i)
    if (fit.names[i] == "angular_frequency" || fit.names[i] == "drive_frequency")
      fit.covariance[i * count + i] += std::pow(quantities.values[i] * record.clock_error, 2);
  for (std::size_t i = 0; i < count; ++i) {
    double error = std::sqrt(std::max(0.0, fit.covariance[i * count + i])), degrees = 1e9;
    bool unknown = false;
    for (int a = 0; a < fitted.count; ++a) {
      if (quantities.derivatives[i][a] == 0) continue;
      degrees = std::min(degrees, known.degrees[a]);
      unknown = unknown || inverse.unknown[a];
    }
    if (unknown) error = HUGE_VAL;
    Estimate estimate = make_estimate(quantities.values[i], error, student_95(std::max(1.0, degrees)));
    if (const int at = quantities.place[i]; at >= 0 && std::isfinite(error)) {
      const double shift = minimum.without_bounds[at] - minimum.parameters[at];
      estimate.low = std::min(estimate.low + shift, estimate.value);
      estimate.high = std::max(estimate.high + shift, estimate.value);
      if (fitted.of[at].is_never_negative()) estimate.low = std::max(estimate.low, 0.0);
    }
    if (quantities.names[i] == "drive_amplitude") estimate.low = std::max(estimate.low, 0.0);
    fit.estimates.push_back(estimate);
  }
  if (!inverse.determined()) {
    fit.status = FitStatus::undetermined;
    fit.message = Notice{"law_undetermined", {{"what", inverse.known}}};
  } else if (const Notice ratio = known_ratio(fit, fitted); !ratio.empty()) {
    fit.status = FitStatus::undetermined;
    fit.message = Notice{"law_undetermined", {{"what", ratio}}};
  }
  say_bounds(fit, fitted, record);
  // Of noise that is correlated as well, the intervals are known less well than the sentence says.
  const bool is_white = noise.correlation.coefficients.empty();
  if (!noise.scale.empty() && is_white && is_filtered(minimum, inverse, noise)) {
    const auto [low, high] = extent_of(noise.scale);
    constexpr double told = 1.1;
    if (high > told * low) fit.notices.push_back(Notice{"noise_is_uneven", {{"times", high / low}}});
  }
}

}  // namespace cromer::core
