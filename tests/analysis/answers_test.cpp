// What is measured of many small motions, networks and ground motions that were made by chance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cromer/analysis/air.h"
#include "cromer/analysis/baseline.h"
#include "cromer/analysis/butterworth.h"
#include "cromer/analysis/complex_modes.h"
#include "cromer/analysis/envelope.h"
#include "cromer/analysis/ground_motion.h"
#include "cromer/analysis/hysteretic_peaks.h"
#include "cromer/analysis/interval_peak.h"
#include "cromer/analysis/line.h"
#include "cromer/analysis/measured_oscillator.h"
#include "cromer/analysis/spectrum.h"
#include "cromer/analysis/steady_state.h"
#include "cromer/analysis/swing.h"
#include "cromer/analysis/textbook_damping.h"
#include "cromer/analysis/yielding.h"
#include "cromer/base/pi.h"
#include "tests/support/answers.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr int some = 40;

/// A decaying swing, seen with some noise.
Trajectory some_swing(Chance& chance, double noise = 0) {
  const auto n = static_cast<std::size_t>(chance.between(3, 160));
  const double w = two_pi * chance.between(0.5, 2), falls = chance.between(-0.02, 0.3),
               phase = chance.between(0, 7), h = chance.between(0.01, 0.12),
               begin = chance.is(0.5) ? 0 : chance.between(-3, 40), uneven = chance.is(0.5) ? 0 : 0.3;
  Trajectory motion;
  for (std::size_t i = 0; i < n; ++i) {
    const double s = h * (static_cast<double>(i) + uneven * chance.between(0, 1)),
                 size = std::exp(-falls * s);
    motion.t.push_back(begin + s);
    motion.x.push_back(size * std::cos(w * s + phase) + noise * chance.normal());
    motion.v.push_back(-size * (falls * std::cos(w * s + phase) + w * std::sin(w * s + phase)));
  }
  return motion;
}

/// A ground that shakes for a second or two.
std::vector<double> some_ground(Chance& chance, double size = 3) {
  std::vector<double> a(static_cast<std::size_t>(chance.between(2, 60)));
  for (double& each : a) each = chance.is(0.1) ? 0 : size * chance.normal();
  return a;
}

void say(Answers& said, const std::vector<double>& values) {
  double sum = 0, weighted = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += values[i];
    weighted += static_cast<double>(i) * values[i];
  }
  said << values.size() << sum << weighted;
}

TEST(Answers, OfSpeedsAndTurns) {
  Answers said("analysis/turns");
  for (unsigned seed = 1; seed <= 3 * some; ++seed) {
    Chance chance(seed);
    const Trajectory motion = some_swing(chance, chance.is(0.5) ? 0 : 0.05);
    said << static_cast<int>(seed);
    std::vector<double> begins, speeds, places, turns, heights;
    for (const SpeedWindow& each : speed_windows(motion.t, motion.v, chance.between(0.1, 1))) {
      begins.push_back(each.t);
      speeds.push_back(each.speed);
      places.push_back(each.at);
    }
    for (const TurningPoint& each : turning_points(motion)) {
      turns.push_back(each.t);
      heights.push_back(each.x);
    }
    for (const auto& values : {begins, speeds, places, turns, heights}) say(said, values);
    std::vector<double> noise;
    for (std::size_t i = 0; i < motion.t.size(); ++i) noise.push_back(chance.normal());
    for (const Envelope& each : {envelope(motion.t, noise), envelope(motion.t, motion.x)})
      for (const auto& values : {each.top_t, each.top, each.bottom_t, each.bottom}) say(said, values);
    const Envelope found = envelope(motion.t, motion.x);
    if (!found.top.empty()) said << interpolate(found.top_t, found.top, motion.t[motion.t.size() / 2]);
    if (const auto measured = measure_oscillator(motion))
      said << measured->angular_frequency << measured->decay_rate << measured->first_amplitude
           << measured->last_amplitude << measured->half_cycles;
    if (const auto recurrence = measure_recurrence(motion.x, 0.05, 6))
      said << recurrence->angular_frequency << recurrence->decay_rate;
    const Oscillator<double> oscillator{.mass = 2, .stiffness = 70};
    if (motion.t.size() > 1) said << energy_growth(oscillator, motion).rate;
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Answers, OfSpectra) {
  Answers said("analysis/spectra");
  for (unsigned seed = 1; seed <= some; ++seed) {
    Chance chance(seed);
    const Trajectory motion = some_swing(chance, 0.1);
    if (motion.t.size() < 4) continue;
    const double h = (motion.t.back() - motion.t.front()) / static_cast<double>(motion.t.size() - 1);
    said << static_cast<int>(seed);
    for (const Spectrum& spectrum :
         {amplitude_spectrum(motion.x, h), least_squares_spectrum(motion.t, motion.x, h)}) {
      said << spectrum.step;
      say(said, spectrum.amplitude);
      for (const SpectralLine& line : strongest_lines(spectrum, chance.between(0, 1), 3))
        said << line.angular_frequency << line.amplitude;
    }
    const double w = chance.between(3, 13);
    if (const auto found = peak_decrement(motion.t, motion.x, two_pi / w, chance.between(0, 0.1)))
      said << found->value << found->standard_error << found->peaks;
    if (const auto found = half_power_bandwidth(motion.t, motion.x, w))
      said << found->width << found->angular_frequency << found->narrowest;
    const HarmonicDrive<double> drive{1, w, chance.between(0, 3)};
    if (const auto steady = measure_steady_state(motion, drive, 2 + 2 * static_cast<int>(seed % 3)))
      said << steady->amplitude << steady->phase_lag << steady->mean << steady->residual << steady->change
           << steady->growth << steady->cycles << steady->settled();
    else
      said << steady.error().notice;
    const int degree = static_cast<int>(chance.between(0, 3));
    say(said, least_squares_polynomial(motion.x, degree));
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Answers, OfFilters) {
  Answers said("analysis/filters");
  for (unsigned seed = 1; seed <= some; ++seed) {
    Chance chance(seed);
    const double h = chance.between(0.005, 0.05);
    PassBand band;
    if (seed % 3 != 0) band.low = chance.between(0.05, 4);
    if (seed % 3 != 1) band.high = chance.between(4.5, 9);
    const auto sections = butterworth(1 + static_cast<int>(seed % 6), band, h);
    said << static_cast<int>(seed) << memory_of(sections, h);
    for (const FilterSection& each : sections) said << each.b0 << each.b1 << each.b2 << each.a1 << each.a2;
    std::vector<double> samples = some_ground(chance), both = samples;
    filter(sections, samples);
    filter_both_ways(sections, both);
    say(said, samples);
    say(said, both);
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Answers, OfGroundMotions) {
  Answers said("analysis/grounds");
  for (unsigned seed = 1; seed <= 2 * some; ++seed) {
    Chance chance(seed);
    const std::vector<double> a = some_ground(chance, chance.is(0.5) ? 3 : 0.3);
    const double h = chance.between(0.01, 0.1);
    said << static_cast<int>(seed);
    for (const BetweenSamples between : {BetweenSamples::linear, BetweenSamples::hold}) {
      const Intensity found = intensity(a, h, between);
      said << found.arias << found.decades << found.from << found.duration << found.duration_75;
      const GroundPath path = ground_path(a, h, between);
      said << path.peak_velocity << path.peak_displacement;
      say(said, path.velocity);
      say(said, path.displacement);
      said << cumulative_absolute_velocity(a, h, between) << bracketed_duration(a, h, between)
           << bracketed_duration(a, h, between, 4);
    }
    const FourierAmplitude fourier = fourier_amplitude(a, h);
    said << fourier.step;
    say(said, fourier.amplitude);
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Answers, OfYieldAndHysteresis) {
  Answers said("analysis/peaks");
  for (unsigned seed = 1; seed <= some; ++seed) {
    Chance chance(seed);
    const std::vector<double> a = some_ground(chance);
    const double h = chance.between(0.01, 0.1);
    said << static_cast<int>(seed);
    const YieldingOscillator yielding{a, h, two_pi / chance.between(0.1, 2), chance.between(0, 0.3)};
    const double elastic = yielding.peak(1e9);
    said << elastic << yielding.peak(0.5 * elastic) << yielding.peak(0.1 * elastic);
    if (seed % 4 == 0) said << yielding.yield_displacement(chance.between(1.2, 6), elastic);
    const std::vector<double> periods{chance.between(0.05, 0.3), chance.between(0.3, 1.5),
                                      h * chance.between(50, 80)};
    const double loss = chance.between(0.02, 0.6);
    said << hysteretic_samples(a.size(), h, periods[2], loss);
    for (const double peak : hysteretic_peaks(a, h, periods, loss)) said << peak;
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Answers, OfExtremes) {
  Answers said("analysis/extremes");
  for (unsigned seed = 1; seed <= 3 * some; ++seed) {
    Chance chance(seed);
    const LinearLaw<double> law{.decay_rate = chance.is(0.7) ? chance.between(0, 1) : chance.between(1, 4),
                                .stiffness = chance.between(1, 9)};
    const ResponseQuantity<double> quantity{chance.between(-1, 1),
                                            chance.is(0.5) ? 0 : chance.between(-1, 1)};
    const State<double> y{chance.between(-1, 1), chance.between(-2, 2)};
    Extremes range{y.x, y.x};
    include_free(law, quantity, y, range);
    said << static_cast<int>(seed) << range.low << range.high;
    const double h = chance.between(0.1, 1) * pi / std::sqrt(law.stiffness);
    const double f = chance.between(-3, 3), slope = chance.between(-3, 3);
    const IntervalMotion motion(law, y, f, slope);
    Extremes inside{1e9, -1e9};
    include_inside(law, quantity, motion, propagate_ramp(law, f, slope, h, y), h, inside);
    said << inside.low << inside.high << overshoot_bound(law, quantity, motion, h);
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Answers, OfLines) {
  Answers said("analysis/lines");
  for (unsigned seed = 1; seed <= 2 * some; ++seed) {
    Chance chance(seed);
    std::vector<UncertainPoint> points(static_cast<std::size_t>(chance.between(2, 9)));
    const bool has_x = chance.is(0.7), has_y = chance.is(0.7);
    const double scatter = chance.between(0, 0.5);
    for (UncertainPoint& each : points) {
      each.x = chance.between(0, 4);
      each.y = 1 + 2 * each.x + scatter * chance.normal();
      if (has_x && !chance.is(0.1)) each.x_error = chance.between(0, 0.2);
      if (has_y && !chance.is(0.1)) each.y_error = chance.between(0, 0.4);
    }
    said << static_cast<int>(seed);
    if (const auto line = fit_line_with_errors(points))
      said << line->slope << line->intercept << line->slope_error << line->intercept_error << line->covariance
           << line->chi_squared << line->degrees << line->extra_scatter;
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Answers, OfNetworks) {
  Answers said("analysis/networks");
  for (unsigned seed = 1; seed <= 2 * some; ++seed) {
    Chance chance(seed);
    const auto n = static_cast<std::size_t>(chance.between(1, 4.5));
    LinearNetwork network{n, {}, std::vector<double>(n * n), std::vector<double>(n * n)};
    for (std::size_t i = 0; i < n; ++i) network.mass.push_back(chance.between(0.5, 2));
    const auto join = [&](std::vector<double>& of, std::size_t i, std::size_t j, double value) {
      of[i * n + i] += value;
      if (i == j) return;
      of[j * n + j] += value;
      of[i * n + j] -= value;
      of[j * n + i] -= value;
    };
    const bool is_free = chance.is(0.2), is_heavy = chance.is(0.3);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i; j < n; ++j) {
        if (i == j ? is_free : chance.is(0.2)) continue;
        join(network.stiffness, i, j, chance.between(0, 40));
        if (chance.is(0.5)) join(network.damping, i, j, chance.between(0, is_heavy ? 30 : 1));
      }
    const auto modes = complex_modes(network);
    said << static_cast<int>(seed);
    for (const ComplexMode& mode : modes) {
      said << mode.first.real() << mode.first.imag() << mode.second.real() << mode.second.imag()
           << participation(network, mode) << modal_assurance(mode.shape, modes.front().shape);
    }
    if (is_free) {  // a double 0 splits by the root of the rounding
      said.end_line();
      continue;
    }
    const double h = chance.between(0.01, 0.5);
    // An Euler step: v first.
    const auto step = [&](const std::vector<double>& z) {
      std::vector<double> next(2 * n);
      for (std::size_t i = 0; i < n; ++i) {
        double force = 0;
        for (std::size_t j = 0; j < n; ++j)
          force -= network.stiffness[i * n + j] * z[j] + network.damping[i * n + j] * z[n + j] / h;
        next[n + i] = z[n + i] + h * h * force / network.mass[i];
        next[i] = z[i] + next[n + i];
      }
      return next;
    };
    const EffectiveNetwork effective = effective_network(modes, 2, h, step);
    said << effective.spectral_radius;
    for (const EffectiveOscillator& each : effective.modes)
      said << each.decay_rate.value_or(0) << each.angular_frequency.value_or(0) << each.spectral_radius;
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Answers, OfLimitCycles) {
  Answers said("analysis/limit_cycles");
  for (unsigned seed = 1; seed <= some / 2; ++seed) {
    Chance chance(seed);
    Oscillator<double> per_mass{.mass = 1, .stiffness = 30, .damping = -2 * chance.between(-0.01, 0.4)};
    per_mass.van_der_pol = chance.between(0.1, 2);
    if (chance.is(0.3)) per_mass.friction = chance.between(0, 0.3);
    if (chance.is(0.3)) per_mass.cubic = chance.between(-10, 30);
    if (chance.is(0.3)) per_mass.quadratic = chance.between(-10, 10);
    said << static_cast<int>(seed)
         << limit_cycle_amplitude(per_mass, chance.between(0.5, 2), 1.1).value_or(0);
    said.end_line();
  }
  said.expect_as_before();
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
