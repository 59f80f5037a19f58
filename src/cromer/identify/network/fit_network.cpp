#include "cromer/identify/network/fit_network.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "cromer/analysis/complex_modes.h"
#include "cromer/base/pi.h"
#include "cromer/identify/least_squares/levenberg_marquardt.h"
#include "cromer/identify/least_squares/residual.h"
#include "cromer/identify/least_squares/uncertainty.h"
#include "cromer/methods/rk4.h"
#include "cromer/model/law_force.h"
#include "cromer/model/linear_network.h"
#include "cromer/model/network_system.h"

namespace cromer::core {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Level and scatter of a column, without its missing values.
struct ColumnSpread {
  double mean = 0, deviation = 0;
  std::size_t count = 0;
};

ColumnSpread column_spread(std::span<const double> y) {
  ColumnSpread s;
  for (const double each : y)
    if (!std::isnan(each)) s.mean += each, ++s.count;
  s.mean /= static_cast<double>(s.count);
  for (const double each : y)
    if (!std::isnan(each)) s.deviation += (each - s.mean) * (each - s.mean);
  s.deviation = std::sqrt(s.deviation / static_cast<double>(s.count));
  return s;
}

/// The usual time [s] from one upward crossing of the mean to the next, of the column that crosses it least
/// often; the whole record where none does twice. Within a fifth of its scatter a value is at neither side.
double slowest_period(const NetworkRecord& record, const std::vector<ColumnSpread>& spreads) {
  double longest = 0;
  for (std::size_t i = 0; i < record.y.size(); ++i) {
    const double clear = 0.2 * spreads[i].deviation;
    bool below = false;
    std::vector<double> up;
    for (std::size_t n = 0; n < record.t.size(); ++n) {
      const double off = record.y[i][n] - spreads[i].mean;
      if (below && off > clear) up.push_back(record.t[n]);
      if (std::abs(off) > clear) below = off < 0;
    }
    if (up.size() > 1)
      longest = std::max(longest, (up.back() - up.front()) / static_cast<double>(up.size() - 1));
  }
  return longest > 0 ? longest : record.t.back() - record.t.front();
}

/// The force [N or N m] with which a law pulls back.
double force_of(const Oscillator<double>& law, double u, double rate) {
  const Law present = law_of(law);
  return resisting_force<any_terms>(law, present, u, rate) + restoring_force<any_terms>(law, present, u);
}

/// A column about its mean, values that are missing for no longer than `longest` [s] on the line between
/// their neighbours.
std::vector<double> filled(std::span<const double> t, std::span<const double> y, double mean,
                           double longest) {
  std::vector<double> whole(y.begin(), y.end());
  for (double& each : whole) each -= mean;
  for (std::size_t n = 1; n < whole.size(); ++n) {
    if (!std::isnan(whole[n]) || std::isnan(whole[n - 1])) continue;
    std::size_t next = n;
    while (next < whole.size() && std::isnan(whole[next])) ++next;
    if (next == whole.size() || t[next] - t[n - 1] > longest) continue;
    const double slope = (whole[next] - whole[n - 1]) / (t[next] - t[n - 1]);
    for (std::size_t i = n; i < next; ++i) whole[i] = whole[n - 1] + slope * (t[i] - t[n - 1]);
  }
  return whole;
}

/// The equations of motion, weighed by windows and summed: the first guess of the coefficients.
class EquationsOfMotion {
 public:
  EquationsOfMotion(const Network& network, const std::vector<SoughtValue>& sought,
                    const NetworkRecord& record, const std::vector<ColumnSpread>& spreads, double period)
      : network_(network), sought_(sought), record_(record), period_(period) {
    for (std::size_t i = 0; i < record.y.size(); ++i)
      y_.push_back(filled(record.t, record.y[i], spreads[i].mean, longest_gap * period));
  }

  struct Guess {
    double value = 0;
    double size = 0;  ///< the value whose term alone would be as large as the accelerations
  };

  /// By windows of so many slowest periods. Empty if the record does not determine them.
  std::vector<Guess> solved(double periods) const {
    const std::size_t samples = record_.t.size();
    const double step = (record_.t.back() - record_.t.front()) / static_cast<double>(samples - 1);
    const auto wanted = static_cast<std::size_t>(std::max(12.0, periods * period_ / step));
    const std::size_t length = std::min(samples, wanted), hop = std::max<std::size_t>(1, length / 4);
    NormalEquations sums;
    sums.size = static_cast<int>(sought_.size() + network_.masses.size());
    for (std::size_t first = 0; first + length <= samples; first += hop) add_window(sums, first, length);
    const LinearFit fit = solve(sums, 1e-10);
    if (!fit.ok) return {};
    std::vector<Guess> guesses;
    for (std::size_t j = 0; j < sought_.size(); ++j)
      guesses.push_back({fit.x[j], std::sqrt(sums.sum_of_squares / sums.matrix[j][j])});
    return guesses;
  }

 private:
  static constexpr double longest_gap = 0.15;  // periods

  /// m x'' + pulls = drive, each of it times w and summed over the window; derivatives of x and of u in a
  /// viscous force go over to w.
  void add_window(NormalEquations& sums, std::size_t first, std::size_t length) const {
    const std::span<const double> t = record_.t.subspan(first, length);
    const double half = (t.back() - t.front()) / 2, middle = t.front() + half;
    const std::size_t masses = network_.masses.size();
    std::vector<std::vector<double>> rows(masses, std::vector<double>(sought_.size() + masses));
    std::vector<double> right(masses);
    for (std::size_t n = 1; n + 1 < length; ++n) {
      if (t[n + 1] - t[n - 1] > 2 * longest_gap * period_) return;
      const double s = (t[n] - middle) / half, q = std::max(0.0, 1 - s * s);
      const double share = (t[n + 1] - t[n - 1]) / 2;
      const double w = share * q * q * q * q, slope = share * -8 * s * q * q * q / half;
      const double bend = share * 8 * q * q * (6 * s * s - q) / (half * half);
      for (std::size_t i = 0; i < masses; ++i) {
        const double x = at(i, first + n);
        if (std::isnan(x)) return;
        const HarmonicDrive<double>& drive = network_.masses[i].drive;
        right[i] += w * drive.amplitude * std::cos(drive.frequency * t[n] + drive.phase) -
                    network_.masses[i].mass * x * bend;
        rows[i][sought_.size() + i] += w;
      }
      for (std::size_t l = 0; l < network_.links.size(); ++l) {
        const NetworkLink& link = network_.links[l];
        const double u = across(link, first + n);
        const double rate =
            (across(link, first + n + 1) - across(link, first + n - 1)) / (t[n + 1] - t[n - 1]);
        if (std::isnan(rate)) return;
        Oscillator<double> known = link.law;
        known.damping = 0;
        pull(link, force_of(known, u, rate) * w - link.law.damping * u * slope,
             [&](std::size_t i, double force) { right[i] -= force; });
        for (std::size_t j = 0; j < sought_.size(); ++j) {
          if (sought_[j].link != l) continue;
          Oscillator<double> one{.stiffness = 0.0};
          one.*sought_[j].member = 1;
          const bool viscous = one.damping == 1;
          pull(link, viscous ? -u * slope : force_of(one, u, rate) * w,
               [&](std::size_t i, double force) { rows[i][j] += force; });
        }
      }
    }
    for (std::size_t i = 0; i < masses; ++i) {
      for (double& each : rows[i]) each /= network_.masses[i].mass;
      sums.add_row(rows[i], right[i] / network_.masses[i].mass);
    }
  }

  /// A link's force pulls back the mass that it ends at, and pulls on the one that it begins at.
  template <class Add>
  static void pull(const NetworkLink& link, double force, const Add& add) {
    if (link.to != ground) add(link.to, force);
    if (link.from != ground) add(link.from, -force);
  }
  double at(std::size_t mass, std::size_t n) const { return y_[mass][n]; }
  double across(const NetworkLink& link, std::size_t n) const {
    return stretch(link.from, link.to, [&](std::size_t mass) { return at(mass, n); });
  }

  const Network& network_;
  const std::vector<SoughtValue>& sought_;
  const NetworkRecord& record_;
  double period_;
  std::vector<std::vector<double>> y_;
};

/// Positions of all masses, mass by mass, at the record's times.
using Positions = std::vector<std::vector<double>>;

/// From state to state through the times; ends where a state is not finite.
template <class Move>
Positions positions_through(std::span<const double> t, State<MassVector> y, const Move& move) {
  Positions x(y.x.first.size(), std::vector<double>(t.size(), nan));
  for (std::size_t n = 0; n < t.size(); ++n) {
    if (n > 0) y = move(t[n - 1], t[n], y);
    if (!std::isfinite(value_of(y.x) + value_of(y.v))) break;
    for (std::size_t i = 0; i < x.size(); ++i) x[i][n] = y.x.first[i];
  }
  return x;
}

Positions positions_of(const Network& network, std::span<const double> t, double longest_step) {
  const State<MassVector> start = start_of(network);
  if (linear_terms.contains(law_of(network))) {
    const NetworkByExponential exact(network);
    return positions_through(t, start, [&](double from, double to, const State<MassVector>& y) {
      return exact.propagate(from, to, y);
    });
  }
  const NetworkSystem<> system(network);
  const Rk4 method;
  NoMemory none;
  return positions_through(t, start, [&](double from, double to, State<MassVector> y) {
    const double steps = std::max(1.0, std::ceil((to - from) / longest_step)), h = (to - from) / steps;
    for (double i = 0; i < steps; ++i) y = method.step(system, from + i * h, h, y, none).y;
    return y;
  });
}

/// Trajectories with their derivatives by all parameters: values sought, then of each mass its position,
/// velocity and offset.
class NetworkMotions {
 public:
  NetworkMotions(const Network& network, const std::vector<SoughtValue>& sought, const NetworkRecord& record,
                 const std::vector<ColumnSpread>& spreads, const std::vector<double>& scale, double period)
      : network_(network),
        sought_(sought),
        record_(record),
        spreads_(spreads),
        scale_(scale),
        period_(period) {
    for (const ColumnSpread& spread : spreads_) weight_.push_back(1 / (spread.deviation * spread.deviation));
  }

  std::size_t masses() const { return network_.masses.size(); }
  int size() const { return static_cast<int>(sought_.size() + 3 * masses()); }
  std::size_t state(std::size_t mass) const { return sought_.size() + 3 * mass; }

  Network network_at(const Parameters& p) const {
    Network network = network_;
    for (std::size_t j = 0; j < sought_.size(); ++j)
      network.links[sought_[j].link].law.*sought_[j].member = p[j];
    for (std::size_t i = 0; i < masses(); ++i) network.masses[i].start = {p[state(i)], p[state(i) + 1]};
    return network;
  }

  /// Drives go by the time of the record.
  Positions at(const Parameters& p, std::size_t samples) const {
    return positions_of(network_at(p), record_.t.first(samples), longest_step_);
  }

  NormalEquations equations(const Parameters& p, std::size_t samples, const Watch& watch) const {
    NormalEquations sums;
    sums.size = size();
    const Positions x = at(p, samples);
    std::vector<Positions> slope;
    for (int j = 0; j < size(); ++j) {
      if (is_offset(j)) {
        slope.emplace_back();
        continue;
      }
      const double change = change_of(p, j);
      Parameters more = p, less = p;
      more[j] += change;
      less[j] -= change;
      Positions up = at(more, samples);
      const Positions down = at(less, samples);
      for (std::size_t i = 0; i < masses(); ++i)
        for (std::size_t n = 0; n < samples; ++n) up[i][n] = (up[i][n] - down[i][n]) / (2 * change);
      slope.push_back(std::move(up));
      if (watch.interrupted()) break;
    }
    std::vector<double> row(static_cast<std::size_t>(size()));
    if (slope.size() < row.size()) {
      sums.sum_of_squares = nan;
      return sums;
    }
    for (std::size_t i = 0; i < masses(); ++i) {
      const double root = std::sqrt(weight_[i]);
      for (std::size_t n = 0; n < samples; ++n) {
        if (std::isnan(record_.y[i][n])) continue;
        for (std::size_t j = 0; j < row.size(); ++j)
          row[j] = root * (is_offset(static_cast<int>(j)) ? (j == state(i) + 2 ? 1.0 : 0.0) : slope[j][i][n]);
        sums.add_row(row, root * (record_.y[i][n] - p[state(i) + 2] - x[i][n]));
      }
    }
    return sums;
  }

  /// Weighs each column by what is left of it, or by rounding.
  void weigh(const std::vector<FittedColumn>& columns) {
    constexpr double rounding = 1e-12;
    for (std::size_t i = 0; i < masses(); ++i) {
      const double least = rounding * spreads_[i].deviation, rms = columns[i].rms;
      weight_[i] = std::pow(rms > least ? rms : least, -2);
    }
  }
  /// The Euclidean norm of all columns, weighed.
  double norm() const {
    double squares = 0;
    for (std::size_t i = 0; i < masses(); ++i)
      squares += weight_[i] * std::pow(spreads_[i].deviation, 2) * static_cast<double>(spreads_[i].count);
    return std::sqrt(squares);
  }
  /// Steps short beside the fastest mode, where there is no closed form.
  void step_for(const Parameters& p) {
    const std::vector<ComplexMode> modes = complex_modes(linearised(network_at(p)));
    const double fastest = std::sqrt(std::abs(modes.back().law().stiffness));
    longest_step_ = 0.05 / std::max(fastest, two_pi / period_);
  }

 private:
  bool is_offset(int j) const {
    const auto place = static_cast<std::size_t>(j);
    return place >= sought_.size() && (place - sought_.size()) % 3 == 2;
  }
  double change_of(const Parameters& p, int j) const {
    const auto place = static_cast<std::size_t>(j);
    if (place < sought_.size()) return 1e-5 * std::max(std::abs(p[j]), scale_[place]);
    double largest = 0;
    for (const ColumnSpread& spread : spreads_) largest = std::max(largest, spread.deviation);
    const bool velocity = (place - sought_.size()) % 3 == 1;
    return 1e-4 * largest * (velocity ? two_pi / period_ : 1);
  }

  Network network_;
  const std::vector<SoughtValue>& sought_;
  const NetworkRecord& record_;
  const std::vector<ColumnSpread>& spreads_;
  std::vector<double> weight_, scale_;  ///< of columns; of changes of values, where these are small
  double period_, longest_step_ = HUGE_VAL;
};

/// A parabola through the first samples of a column: where it begins, and how fast.
State<double> beginning_of(std::span<const double> t, std::span<const double> y) {
  NormalEquations sums;
  sums.size = 3;
  for (std::size_t n = 0; n < t.size(); ++n)
    if (const double s = t[n] - t[0]; !std::isnan(y[n])) sums.add_row(std::array{1.0, s, s * s}, y[n]);
  const LinearFit fit = solve(sums);
  return fit.ok ? State<double>{fit.x[0], fit.x[1]} : State<double>{};
}

/// What is left of each column, and how much that is.
void put_residuals(NetworkFit& fit, const NetworkMotions& motions, const Parameters& p,
                   const NetworkRecord& record, const std::vector<ColumnSpread>& spreads) {
  const Positions x = motions.at(p, record.t.size());
  fit.columns.assign(motions.masses(), {});
  for (std::size_t i = 0; i < motions.masses(); ++i) {
    FittedColumn& column = fit.columns[i];
    double squares = 0;
    for (std::size_t n = 0; n < record.t.size(); ++n) {
      column.residual.push_back(record.y[i][n] - p[motions.state(i) + 2] - x[i][n]);
      if (!std::isnan(column.residual[n])) squares += column.residual[n] * column.residual[n];
    }
    column.rms = std::sqrt(squares / static_cast<double>(spreads[i].count));
    column.explained = 1 - std::pow(column.rms / spreads[i].deviation, 2);
  }
}

/// Of samples `lag` apart, without those that are missing.
struct Correlation {
  double value = 0, pairs = 0;
};

Correlation lagged_correlation(std::span<const double> residual, std::size_t lag) {
  double products = 0, squares = 0, pairs = 0;
  for (std::size_t n = lag; n < residual.size(); ++n) {
    const double product = residual[n] * residual[n - lag];
    if (std::isnan(product)) continue;
    products += product;
    squares += residual[n] * residual[n];
    ++pairs;
  }
  return {squares > 0 ? products / squares : 0, pairs};
}

/// Whether neighbours are alike, as those of a motion are and those of noise are not.
bool is_smooth(std::span<const double> residual) { return lagged_correlation(residual, 1).value > 0.5; }

/// Whether no sample says anything of the next two: a motion's would, however few there are in its period.
bool is_white(std::span<const double> residual) {
  constexpr double most = 3;  // standard deviations
  const auto is_none = [&](std::size_t lag) {
    const auto [value, pairs] = lagged_correlation(residual, lag);
    return std::abs(value) * std::sqrt(pairs) < most;
  };
  return is_none(1) && is_none(2);
}

/// By how much correlated residuals widen the variance of what lives at the network's frequencies: most of
/// all columns and modes.
double widening_of(const NetworkFit& fit, const NetworkRecord& record) {
  const std::vector<ComplexMode> modes = complex_modes(linearised(fit.network));
  double widest = 1;
  for (const FittedColumn& column : fit.columns) {
    std::vector<double> t, r;
    for (std::size_t n = 0; n < record.t.size(); ++n)
      if (!std::isnan(column.residual[n])) {
        t.push_back(record.t[n]);
        r.push_back(column.residual[n]);
      }
    const SampleGrid grid = find_grid(t);
    const Autoregression noise = autoregression_of(r, autocorrelations(r, grid, first_lags(r.size())), grid);
    for (const ComplexMode& mode : modes) {
      const double angle = std::sqrt(std::abs(mode.law().stiffness)) * grid.step;
      if (angle < std::numbers::pi) widest = std::max(widest, noise.density(angle));
    }
  }
  return widest;
}

/// What the normal equations do not tell. Some values must be held for the others to be told; which, is open.
struct Untold {
  std::vector<std::size_t> open;                     ///< those that are held, or might be in the place of one
  std::array<bool, max_parameters> told = all_free;  ///< false of those that are held
};

Untold untold_of(const NormalEquations& equations, std::size_t sought) {
  Untold untold;
  auto& told = untold.told;
  const auto are_told = [&] { return ScaledCholesky(equations.matrix, equations.size, 0, told).ok(); };
  if (are_told()) return untold;
  std::fill_n(told.begin(), sought, false);
  for (std::size_t j = 0; j < sought; ++j) told[j] = true, told[j] = are_told();
  for (std::size_t j = 0; j < sought; ++j) {
    bool is_open = !told[j];
    for (std::size_t held = 0; held < sought && !is_open; ++held) {
      if (told[held]) continue;
      std::swap(told[j], told[held]);
      is_open = are_told();
      std::swap(told[j], told[held]);
    }
    if (is_open) untold.open.push_back(j);
  }
  return untold;
}

void put_estimates(NetworkFit& fit, const std::vector<SoughtValue>& sought, const NetworkMotions& motions,
                   const NormalEquations& equations, const Parameters& p, const NetworkRecord& record,
                   std::size_t samples) {
  const auto [open, told] = untold_of(equations, sought.size());
  fit.undetermined = open;
  fit.independent_samples = static_cast<double>(samples) / widening_of(fit, record);
  const double degrees = std::max(1.0, fit.independent_samples - equations.size);
  const double variance = equations.sum_of_squares / degrees, t = student_95(degrees);
  const ScaledCholesky factor(equations.matrix, equations.size, 0, told);
  const auto estimate_of = [&](std::size_t j) {
    const bool known = factor.ok() && std::find(fit.undetermined.begin(), fit.undetermined.end(), j) ==
                                          fit.undetermined.end();
    Parameters unit{};
    unit[j] = 1;
    return make_estimate(p[j], known ? std::sqrt(variance * factor.solve(unit)[j]) : nan, t);
  };
  for (std::size_t j = 0; j < sought.size(); ++j) {
    fit.values.push_back(estimate_of(j));
    if (sought[j].never_negative) fit.values.back().low = std::max(fit.values.back().low, 0.0);
  }
  for (std::size_t i = 0; i < fit.columns.size(); ++i) {
    FittedColumn& column = fit.columns[i];
    column.position = estimate_of(motions.state(i));
    column.velocity = estimate_of(motions.state(i) + 1);
    column.offset = estimate_of(motions.state(i) + 2);
  }
}

/// How many of the record's samples lie within so long [s] of its first.
std::size_t samples_within(const NetworkRecord& record, double duration) {
  const auto end = std::upper_bound(record.t.begin(), record.t.end(), record.t.front() + duration);
  return static_cast<std::size_t>(end - record.t.begin());
}

NetworkRecord first_samples(const NetworkRecord& record, std::size_t samples) {
  NetworkRecord part{record.t.first(samples), {}};
  for (const std::span<const double> y : record.y) part.y.push_back(y.first(samples));
  return part;
}

/// The record until nearly all of its motion has been: of what has died down only noise follows.
NetworkRecord lively_part(const NetworkRecord& record, const std::vector<ColumnSpread>& spreads) {
  constexpr double nearly_all = 0.99;
  std::vector<double> until;
  double sum = 0;
  for (std::size_t n = 0; n < record.t.size(); ++n) {
    for (std::size_t i = 0; i < record.y.size(); ++i)
      if (const double off = (record.y[i][n] - spreads[i].mean) / spreads[i].deviation; !std::isnan(off))
        sum += off * off;
    until.push_back(sum);
  }
  const auto end = std::lower_bound(until.begin(), until.end(), nearly_all * sum);
  const auto samples = static_cast<std::size_t>(end - until.begin()) + 1;
  return first_samples(record, samples);
}

/// How large the values sought are: the guesses, or a hundredth of what their terms could be.
std::vector<double> sizes_of(const std::vector<EquationsOfMotion::Guess>& guesses) {
  constexpr double small = 0.01;
  std::vector<double> sizes;
  for (const auto& [value, size] : guesses) sizes.push_back(std::max(std::abs(value), small * size));
  return sizes;
}

/// Where the iteration begins: at the guesses, and each mass as its first samples show it.
Parameters start_values(const NetworkMotions& motions, const std::vector<SoughtValue>& sought,
                        const std::vector<EquationsOfMotion::Guess>& guesses, const NetworkRecord& record,
                        const std::vector<ColumnSpread>& spreads, double period) {
  Parameters p{};
  for (std::size_t j = 0; j < sought.size(); ++j)
    p[j] = sought[j].never_negative ? std::max(guesses[j].value, 0.0) : guesses[j].value;
  const std::size_t first = std::max<std::size_t>(4, samples_within(record, period / 6));
  for (std::size_t i = 0; i < record.y.size(); ++i) {
    const auto [x, v] = beginning_of(record.t.first(first), record.y[i].first(first));
    p[motions.state(i)] = x - spreads[i].mean;
    p[motions.state(i) + 1] = v;
    p[motions.state(i) + 2] = spreads[i].mean;
  }
  return p;
}

/// Whether a motion is left of a column's beginning: the values are not the right ones, or the law is not.
bool leaves_motion(const NetworkMotions& motions, const Parameters& p, const NetworkRecord& record,
                   std::size_t samples) {
  const Positions x = motions.at(p, samples);
  for (std::size_t i = 0; i < motions.masses(); ++i) {
    std::vector<double> left;
    for (std::size_t n = 0; n < samples; ++n)
      left.push_back(record.y[i][n] - p[motions.state(i) + 2] - x[i][n]);
    if (is_smooth(left)) return true;
  }
  return false;
}

/// A motion that runs away leaves more than any other.
double squares_left(const LeastSquaresSummary& summary) {
  const double sum = summary.equations.sum_of_squares;
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

/// The fit of one record: from guesses over its beginning, over ever more of it, then with columns weighed by
/// their own noise.
class NetworkSearch {
 public:
  NetworkSearch(const Network& network, const std::vector<SoughtValue>& sought, const NetworkRecord& record,
                const Watch& watch)
      : network_(network), sought_(sought), record_(record), watch_(watch) {
    for (const std::span<const double> y : record.y) {
      spreads_.push_back(column_spread(y));
      samples_ += spreads_.back().count;
    }
    options_.tolerance = 1e-12;  // what rounding moves the motions by
    options_.residuals = static_cast<int>(std::min<std::size_t>(samples_, 1u << 30));
    for (std::size_t j = 0; j < sought.size(); ++j)
      if (sought[j].never_negative) options_.lower[j] = 0;
  }

  NetworkFit run() {
    if (!std::all_of(spreads_.begin(), spreads_.end(), moves)) return ended(FitStatus::no_oscillation);
    period_ = slowest_period(record_, spreads_);
    lively_ = lively_part(record_, spreads_);
    const Guesses guesses = is_long_enough() ? guesses_of(lively_, windows[0]) : Guesses{};
    if (guesses.empty()) return ended(FitStatus::too_short);
    motions_.emplace(network_, sought_, record_, spreads_, sizes_of(guesses), period_);

    begin(guesses);
    go_on_to_end();
    weigh_columns();
    fit_.network = motions_->network_at(found_.parameters);
    put_residuals(fit_, *motions_, found_.parameters, record_, spreads_);
    fit_.runs_away = found_.reason == LeastSquaresReason::not_finite;
    if (watch_.interrupted() || found_.reason != LeastSquaresReason::converged) return std::move(fit_);

    put_estimates(fit_, sought_, *motions_, found_.equations, found_.parameters, record_, samples_);
    return ended(!fit_.undetermined.empty() ? FitStatus::undetermined
                 : explains(fit_.columns)   ? FitStatus::converged
                                            : FitStatus::too_noisy);
  }

 private:
  using Guesses = std::vector<EquationsOfMotion::Guess>;
  // Wide windows let little noise through, and narrow ones the fast modes.
  static constexpr double windows[] = {2, 1, 0.5};
  static constexpr double first_periods = 3;

  static bool moves(const ColumnSpread& spread) {
    constexpr double rounding = 1e-12;
    return spread.deviation > rounding * std::abs(spread.mean);
  }
  bool is_long_enough() const {
    const std::size_t parameters = sought_.size() + 3 * network_.masses.size();
    return samples_ >= 3 * parameters && record_.t.back() - record_.t.front() >= 1.5 * period_;
  }
  NetworkFit ended(FitStatus status) {
    fit_.status = status;
    return std::move(fit_);
  }
  Guesses guesses_of(const NetworkRecord& part, double window) const {
    return EquationsOfMotion(network_, sought_, part, spreads_, period_).solved(window);
  }

  // Over the first samples, from where the last fit ended.
  void fit_through(std::size_t end) {
    options_.scale = motions_->norm();
    motions_->step_for(found_.parameters);
    found_ = minimise([&](const Parameters& at) { return motions_->equations(at, end, watch_); },
                      found_.parameters, options_);
    fit_.iterations += found_.iterations;
  }
  void tell(std::size_t end) const {
    if (watch_.progress)
      watch_.progress(0.7 * static_cast<double>(end) / static_cast<double>(record_.t.size()));
  }

  // Far from the start, trajectories of wrong values are out of phase. Where a fast mode dies down early
  // noise makes bad guesses of the rest, and those of a shorter part are better.
  void begin(Guesses guesses) {
    const std::size_t beginning = samples_within(record_, first_periods * period_);
    std::optional<LeastSquaresSummary> best;
    bool is_found = false;
    for (const double window : windows)
      for (std::size_t part = lively_.t.size(); !is_found; part = std::max(part / 2, beginning)) {
        if (best) guesses = guesses_of(first_samples(record_, part), window);
        if (!guesses.empty()) {
          found_.parameters = start_values(*motions_, sought_, guesses, record_, spreads_, period_);
          fit_through(beginning);
          if (!best || squares_left(found_) < squares_left(*best)) best = found_;
          is_found = (found_.reason == LeastSquaresReason::converged &&
                      !leaves_motion(*motions_, found_.parameters, record_, beginning)) ||
                     watch_.interrupted();
        }
        if (part <= beginning) break;
      }
    found_ = *best;
    tell(beginning);
  }

  void go_on_to_end() {
    double duration = first_periods * period_;
    for (std::size_t end = samples_within(record_, duration);
         end < record_.t.size() && !watch_.interrupted();) {
      duration *= 2;
      end = samples_within(record_, duration);
      fit_through(end);
      tell(end);
    }
  }

  // Columns have noise of their own.
  void weigh_columns() {
    for (int round = 0; round < 2 && !watch_.interrupted(); ++round) {
      put_residuals(fit_, *motions_, found_.parameters, record_, spreads_);
      motions_->weigh(fit_.columns);
      fit_through(record_.t.size());
    }
  }

  const Network& network_;
  const std::vector<SoughtValue>& sought_;
  const NetworkRecord& record_;
  const Watch& watch_;
  std::vector<ColumnSpread> spreads_;
  std::size_t samples_ = 0;  ///< of all columns that are there
  double period_ = 0;        ///< of the slowest motion [s]
  NetworkRecord lively_;
  LeastSquaresOptions options_;
  std::optional<NetworkMotions> motions_;
  LeastSquaresSummary found_;
  NetworkFit fit_{.network = network_};
};

}  // namespace

bool explains(const std::vector<FittedColumn>& columns) {
  constexpr double beside_noise = 0.5, beside_motion = 0.9;
  const auto is_told = [](const FittedColumn& column) {
    return column.explained > (is_smooth(column.residual) ? beside_motion : beside_noise);
  };
  return std::any_of(columns.begin(), columns.end(), is_told) &&
         std::all_of(columns.begin(), columns.end(), [&](const FittedColumn& column) {
           return is_told(column) || is_white(column.residual);
         });
}

std::size_t most_sought(std::size_t masses) {
  const std::size_t all = max_parameters;
  return all > 3 * masses ? all - 3 * masses : 0;
}

NetworkFit fit_network(const Network& network, const std::vector<SoughtValue>& sought,
                       const NetworkRecord& record, const Watch& watch) {
  return NetworkSearch(network, sought, record, watch).run();
}

}  // namespace cromer::core
