#include "cromer/identify/start/envelope_track.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cromer/analysis/swing.h"
#include "cromer/base/pi.h"
#include "cromer/base/state.h"
#include "cromer/model/law.h"

namespace cromer::core {
namespace {

constexpr std::size_t most_in_a_window = 96;

// A pendulum's swing whose fundamental has the amplitude a [rad] < 4: Jacobi's elliptic functions as series
// in the nome q (DLMF 22.11.1, 20.2.3, 22.2.2).
//
//   x = sum over odd n of 8 q^(n/2)/(n (1 + q^n)) cos(n phase), signs +-+-...,  rate = 1/theta3(q)^2
class PendulumSwing {
 public:
  explicit PendulumSwing(double a) : a_(std::min(a, 3.8)) {
    s_ = a_ > 1e-6 ? (4 - std::sqrt(16 - a_ * a_)) / a_ : a_ / 8;
    double theta = 1;
    const double q = s_ * s_;
    for (int n = 1; n < terms; ++n) theta += 2 * std::pow(q, n * n);
    rate_ = 1 / (theta * theta);
  }

  /// The ratio of its frequency to that of small swings.
  double rate() const { return rate_; }

  /// Position, and velocity over the small swings' angular frequency.
  State<double> at(double phase) const {
    State<double> y{0, 0};
    for (int k = 0, n = 1; k < terms; ++k, n += 2) {
      const double c = (k % 2 ? -1 : 1) * harmonic(n);
      y.x += c * std::cos(n * phase);
      y.v -= rate_ * n * c * std::sin(n * phase);
    }
    return y;
  }

  /// Amplitude of the linear swing of the same action, which falls as a linear one's under viscous damping.
  double linear() const {
    double sum = 0;
    for (int k = 0, n = 1; k < terms; ++k, n += 2) sum += n * harmonic(n) * n * harmonic(n);
    return std::sqrt(rate_ * sum);
  }

 private:
  static constexpr int terms = 24;
  double a_, s_, rate_;

  double harmonic(int n) const { return 8 * std::pow(s_, n) / (n * (1 + std::pow(s_ * s_, n))); }
};

PendulumSwing swing_of_action(double linear) {
  double low = 0, high = 3.8;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (PendulumSwing(middle).linear() < linear ? low : high) = middle;
  }
  return PendulumSwing(low);
}

struct Window {
  double equilibrium, amplitude, phase, error;  // error of the amplitude
};

// A sinusoid of one frequency over the samples [first, last), its phase at the time tc.
std::optional<Window> window_at(const Record& record, std::size_t first, std::size_t last, double w,
                                double tc) {
  const std::size_t stride = (last - first + most_in_a_window - 1) / most_in_a_window;
  NormalEquations equations{.size = 3};
  double used = 0;
  for (std::size_t i = first; i < last; i += stride, ++used) {
    const double phase = w * (record.t[i] - tc), row[] = {1, std::cos(phase), std::sin(phase)};
    equations.add_row(row, record.y[i]);
  }
  const LinearFit fit = solve(equations);
  if (!fit.ok || used < 6) return std::nullopt;
  const double variance = std::max(fit.rest, 0.0) / (used - 3);
  return Window{fit.x[0], std::hypot(fit.x[1], fit.x[2]), std::atan2(-fit.x[2], fit.x[1]),
                std::sqrt(2 * variance / used)};
}

// The integral over the track of f(A), from its first time: by trapezoids.
template <class F>
std::vector<double> integral(const EnvelopeTrack& track, F f) {
  std::vector<double> sum(track.t.size());
  for (std::size_t k = 1; k < sum.size(); ++k)
    sum[k] = sum[k - 1] +
             0.5 * (track.t[k] - track.t[k - 1]) * (f(track.amplitude[k - 1]) + f(track.amplitude[k]));
  return sum;
}

// A term's coefficient per unit mass, and the integrals along the track of what a unit of it does.
struct TermAlong {
  double Oscillator<double>::*coefficient;
  bool may_be_negative;
  std::vector<double> fall, shift;
};

// Of the terms that change amplitude or frequency: all but the spring and what has an inner state.
std::vector<TermAlong> terms_along(const EnvelopeTrack& track, const Law& law, double w) {
  std::vector<TermAlong> terms;
  for_each_term([&]<class T>() {
    if constexpr (!HasInnerState<T>) {
      if (!law.has<T>() || springs.has<T>()) return;
      terms.push_back({T::template members<double>[0], may_be_negative(T::coefficients[0], law),
                       integral(track, [&](double A) { return cycle_average<T>(A, w).fall; }),
                       integral(track, [&](double A) { return cycle_average<T>(A, w).shift; })});
    }
  });
  return terms;
}

// Least squares of the track's amplitudes: the best of all subsets of the terms in which none is negative
// that cannot be.
struct Decay {
  double amplitude = 0;  // at the first window
  std::vector<double> coefficients;
  double rest = HUGE_VAL;
};

Decay decay_along(const EnvelopeTrack& track, const std::vector<TermAlong>& terms) {
  Decay best{.coefficients = std::vector<double>(terms.size())};
  std::vector<std::size_t> damping;
  for (std::size_t i = 0; i < terms.size(); ++i)
    if (terms[i].fall.back() != 0) damping.push_back(i);
  for (unsigned subset = 0; subset < 1U << damping.size(); ++subset) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < damping.size(); ++i)
      if (subset >> i & 1U) chosen.push_back(damping[i]);
    std::vector<double> row(1 + chosen.size(), 1.0);
    NormalEquations equations{.size = static_cast<int>(row.size())};
    for (std::size_t k = 0; k < track.t.size(); ++k) {
      for (std::size_t i = 0; i < chosen.size(); ++i) row[1 + i] = -terms[chosen[i]].fall[k];
      equations.add_row(row, track.amplitude[k]);
    }
    const LinearFit fit = solve(equations);
    if (!fit.ok || fit.rest >= best.rest) continue;
    bool negative = false;
    std::vector<double> coefficients(terms.size(), 0.0);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      coefficients[chosen[i]] = fit.x[1 + i];
      negative = negative || (fit.x[1 + i] < 0 && !terms[chosen[i]].may_be_negative);
    }
    if (!negative) best = {fit.x[0], coefficients, fit.rest};
  }
  return best;
}

// A law's springs that follow a track's phases.
struct SpringsAlong {
  Oscillator<double> per_mass;
  double phase = 0;          // [rad] at the first window
  std::vector<double> rate;  // [rad/s] in each window
};

// The third harmonic of a swing whose fundamental has the amplitude A: what the bends add to it at the
// turning points. Of the harmonic balance, 9 w² - w0² as 8 w².
double third_harmonic(const Swing<double>& swing, double A, double w) {
  constexpr int points = 12;
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const double theta = (i + 0.5) * pi / points;
    sum += swing.pull(A * std::cos(theta)) * std::cos(3 * theta);
  }
  return 2 * sum / points / (8 * w * w);
}

// By the frequency that springs have at each amplitude, not just to the first order: steps of Gauss and
// Newton from `per_mass`. Empty where they lead nowhere.
std::optional<SpringsAlong> springs_along(const EnvelopeTrack& track, const std::vector<TermAlong>& terms,
                                          const std::vector<std::size_t>& bending,
                                          Oscillator<double> per_mass) {
  constexpr std::size_t most = 5;
  using Real = Dual<double, most>;
  if (1 + bending.size() > most) return std::nullopt;
  std::vector<double Oscillator<double>::*> unknown{&Oscillator<double>::stiffness};
  for (const std::size_t i : bending) unknown.push_back(terms[i].coefficient);
  SpringsAlong found{.per_mass = per_mass, .rate = {}};
  for (int round = 0; round < 6; ++round) {
    const Swing<double> now{per_mass};
    Swing<Real> swing;
    swing.per_mass.stiffness = Real::variable(per_mass.stiffness, 0);
    for_each_term([&]<class T>() {
      for (std::size_t j = 1; j < unknown.size(); ++j)
        if (unknown[j] == T::template members<double>[0])
          swing.per_mass.*T::template members<Real>[0] = Real::variable(per_mass.*unknown[j], j);
    });
    NormalEquations equations{.size = static_cast<int>(1 + unknown.size())};
    found.rate.clear();
    Real phase = 0, before = 0;
    for (std::size_t k = 0; k < track.t.size(); ++k) {
      const double A = track.amplitude[k];
      const Real rate = swing.angular_frequency(Real(A + third_harmonic(now, A, track.frequency)), 24);
      if (!std::isfinite(rate.value)) return std::nullopt;
      if (k > 0) phase += 0.5 * (track.t[k] - track.t[k - 1]) * (rate + before);
      before = rate;
      found.rate.push_back(rate.value);
      std::array<double, 1 + most> row{1};
      for (std::size_t j = 0; j < unknown.size(); ++j) row[1 + j] = phase.derivative[j];
      equations.add_row(row, track.phase[k] - phase.value);
    }
    const LinearFit step = solve(equations);
    if (!step.ok) return std::nullopt;
    double largest = 0;
    for (std::size_t j = 0; j < unknown.size(); ++j) {
      per_mass.*unknown[j] += step.x[1 + j];
      largest = std::max(largest, std::abs(step.x[1 + j]) / std::max(std::abs(per_mass.*unknown[j]), 1e-300));
    }
    if (!(per_mass.stiffness > 0)) return std::nullopt;
    found.per_mass = per_mass;
    found.phase = step.x[0];
    if (largest < 1e-4) break;
  }
  return found;
}

}  // namespace

std::optional<EnvelopeTrack> track_envelope(const Record& record, double angular_frequency,
                                            double decay_rate) {
  EnvelopeTrack track;
  double w = angular_frequency, equilibria = 0;
  const double duration = std::min(record.t.back() - record.t.front(), 2 / std::max(decay_rate, 1e-300));
  const double most_periods = std::clamp(w * duration / two_pi / 12, 1.0, 3.0);
  double periods = 1;  // for as long as noise allows: a large swing's frequency changes fast
  std::size_t first = 0;
  double last_t = 0, last_phase = 0;
  bool dies_away = false;
  for (;;) {
    const double from = record.t[first], to = from + periods * two_pi / w, tc = 0.5 * (from + to);
    const auto last =
        static_cast<std::size_t>(std::lower_bound(record.t.begin(), record.t.end(), to) - record.t.begin());
    if (to > record.t.back()) break;
    const std::optional<Window> window = window_at(record, first, last, w, tc);
    first = last;
    constexpr double clear = 0.03;
    if (!window || window->error > clear * window->amplitude)
      periods = std::min(1.25 * periods, most_periods);
    if (!window) continue;
    const bool begins = track.t.empty();
    const double scale = std::pow(w, record.derivative);
    const double amplitude = window->amplitude / scale;
    dies_away = !begins && (window->amplitude < std::max(4 * window->error, record.resolution) ||
                            amplitude < 0.02 * track.amplitude.front());
    if (dies_away) break;
    double phase = window->phase - 0.5 * pi * record.derivative;
    if (!begins) {
      const double expected = last_phase + w * (tc - last_t);
      const double off = std::remainder(phase - expected, two_pi);
      if (std::abs(off) > 1.5) break;  // lost
      phase = expected + off;
      w += std::clamp(off / (tc - last_t), -0.1 * w, 0.1 * w);
    }
    track.t.push_back(tc);
    track.amplitude.push_back(amplitude);
    track.phase.push_back(phase);
    equilibria += window->equilibrium;
    last_t = tc;
    last_phase = phase;
    track.samples = track.swinging = last;
  }
  if (track.t.size() < 3) return std::nullopt;
  const bool followed = dies_away || record.t.back() - last_t < 2.5 * periods * two_pi / w;
  if (followed) track.samples = record.t.size();
  if (!dies_away) track.swinging = track.samples;
  track.frequency = (track.phase[1] - track.phase[0]) / (track.t[1] - track.t[0]);
  track.equilibrium = equilibria / static_cast<double>(track.t.size());
  return track;
}

Motion motion_along(const EnvelopeTrack& track, const Law& law, double t0) {
  const bool pendulum = law.has<Pendulum>();
  EnvelopeTrack linear = track;
  if (pendulum)
    for (double& A : linear.amplitude) A = PendulumSwing(A).linear();
  const std::vector<TermAlong> terms = terms_along(linear, law, track.frequency);
  const Decay decay = decay_along(linear, terms);
  const std::vector<double> time =
      integral(track, [&](double A) { return pendulum ? PendulumSwing(A).rate() : 1.0; });
  std::vector<std::size_t> shifting;
  for (std::size_t i = 0; i < terms.size(); ++i)
    if (terms[i].shift.back() != 0) shifting.push_back(i);
  std::vector<double> row(2 + shifting.size(), 1.0);
  NormalEquations equations{.size = static_cast<int>(row.size())};
  for (std::size_t k = 0; k < track.t.size(); ++k) {
    row[1] = time[k];
    for (std::size_t i = 0; i < shifting.size(); ++i) row[2 + i] = terms[shifting[i]].shift[k];
    equations.add_row(row, track.phase[k]);
  }
  LinearFit fit = solve(equations);
  if (!fit.ok) fit.x = {track.phase.front(), track.frequency};
  const double w = fit.x[1] > 0 ? fit.x[1] : track.frequency;

  Motion motion;
  motion.law = law;
  motion.equilibrium = track.equilibrium;
  for (std::size_t i = 0; i < terms.size(); ++i)
    motion.per_mass.*terms[i].coefficient = decay.coefficients[i];
  for (std::size_t i = 0; i < shifting.size(); ++i)
    motion.per_mass.*terms[shifting[i]].coefficient = fit.x[2 + i];
  motion.set_angular_frequency(std::hypot(w, motion.decay_rate()));
  constexpr double much = 0.03;  // of the frequency: beyond, the first order is not enough
  std::optional<SpringsAlong> bent;
  if (!shifting.empty() && std::abs(track.frequency - w) > much * w)
    bent = springs_along(track, terms, shifting, motion.per_mass);
  if (bent) {
    motion.per_mass = bent->per_mass;
    // Damping takes from the action, of which the linear swing of amplitude A sqrt(rate/w) has as much.
    for (std::size_t k = 0; k < track.t.size(); ++k)
      linear.amplitude[k] = track.amplitude[k] * std::sqrt(bent->rate[k] / motion.angular_frequency());
    const Decay of_action = decay_along(linear, terms_along(linear, law, motion.angular_frequency()));
    for (std::size_t i = 0; i < terms.size(); ++i)
      if (terms[i].shift.back() == 0) motion.per_mass.*terms[i].coefficient = of_action.coefficients[i];
  }
  // From the first window's middle back to the first sample, at the rates there.
  const double back = track.t.front() - t0, A = decay.amplitude;
  double fall = 0, rate = w;
  for_each_term([&]<class T>() {
    if constexpr (!HasInnerState<T>) {
      if (!law.has<T>() || springs.has<T>()) return;
      const CycleAverage<double> average = cycle_average<T>(A, w);
      fall += motion.per_mass.*T::template members<double>[0] * average.fall;
      rate += motion.per_mass.*T::template members<double>[0] * average.shift;
    }
  });
  const double amplitude = A + fall * back;
  if (pendulum) {
    const PendulumSwing swing = swing_of_action(amplitude);
    const double mean_rate = 0.5 * (swing.rate() + PendulumSwing(track.amplitude.front()).rate());
    const State<double> start = swing.at(fit.x[0] - w * mean_rate * back);
    motion.position = start.x;
    motion.velocity = w * start.v - motion.decay_rate() * start.x;
    return motion;
  }
  if (bent) {
    const Swing<double> swing{bent->per_mass};
    const double third = third_harmonic(swing, amplitude, track.frequency);
    const double exact = swing.angular_frequency(amplitude + third), phase = bent->phase - exact * back;
    motion.position = amplitude * std::cos(phase) + third * std::cos(3 * phase);
    motion.velocity = -exact * (amplitude * std::sin(phase) + 3 * third * std::sin(3 * phase)) -
                      motion.decay_rate() * motion.position;
    return motion;
  }
  const double phase = fit.x[0] - rate * back;
  motion.position = amplitude * std::cos(phase);
  motion.velocity = -amplitude * rate * std::sin(phase) - motion.decay_rate() * motion.position;
  return motion;
}

}  // namespace cromer::core
