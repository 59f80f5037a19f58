// What is said of many small recordings that were made by chance about the limits of what is looked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cromer/base/pi.h"
#include "cromer/identify/diagnose/doubts.h"
#include "cromer/identify/diagnose/free_part.h"
#include "cromer/identify/diagnose/mean_decay.h"
#include "cromer/identify/diagnose/outliers.h"
#include "cromer/identify/diagnose/refusal.h"
#include "cromer/identify/diagnose/second_mode.h"
#include "tests/identify/synthetic.h"
#include "tests/support/answers.h"

namespace cromer::core {
namespace CROMER_FILE {

/// Some samples a period of about a second; every third record has uneven times.
std::vector<double> some_times(Chance& chance, double periods, double fewest = 9, double most = 30) {
  const double h = 1 / chance.between(fewest, most);
  const auto n = static_cast<std::size_t>(periods / h);
  const bool is_even = !chance.is(0.3);
  std::vector<double> t;
  for (std::size_t i = 0; i < n; ++i)
    t.push_back(static_cast<double>(i) * h + (is_even ? 0 : chance.between(0, 0.3 * h)));
  return t;
}

void round_to(double step, std::vector<double>& y) {
  if (!(step > 0)) return;
  for (double& each : y) each = step * std::round(each / step);
}

/// A swing of amplitude A(t) about 0.3, seen by a sensor.
template <class Amplitude>
SyntheticRecord swing_of(Chance& chance, const std::vector<double>& t, double noise, double resolution,
                         const Amplitude& amplitude) {
  SyntheticRecord record{t, {}, resolution};
  const double w = two_pi * chance.between(0.9, 1.1), phase = chance.between(0, two_pi);
  for (const double at : t)
    record.y.push_back(0.3 + amplitude(at) * std::cos(w * at + phase) + noise * chance.normal());
  round_to(resolution, record.y);
  return record;
}

void say(Answers& said, const std::optional<FreePart>& part) {
  if (part)
    said << part->reason << part->from;
  else
    said << "-";
}

TEST(Diagnosed, WhereADriveStops) {
  Answers said("identify/after_a_drive");
  for (unsigned seed = 1; seed <= 160; ++seed) {
    Chance chance(seed);
    const double periods = chance.between(20, 60), stops = chance.between(4, periods - 4),
                 grows = chance.is(0.4) ? 0 : chance.between(-0.01, 0.02),
                 falls = chance.between(0.004, 0.12), noise = chance.is(0.5) ? 1e-4 : chance.between(0, 0.03),
                 beat = chance.is(0.7) ? 0 : chance.between(0, 0.15),
                 comes_back = chance.is(0.8) ? 0 : chance.between(0, 0.1);
    const SyntheticRecord record = swing_of(chance, some_times(chance, periods), noise, 0, [&](double t) {
      const double after = std::max(0.0, t - stops);
      return std::exp(grows * std::min(t, stops) - falls * after) * (1 + beat * std::cos(0.4 * t)) +
             (after > 12 ? comes_back : 0);
    });
    said << static_cast<int>(seed);
    say(said, find_free_part(record.record()));
    said << period_at_start(record.record()).value_or(0);
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Diagnosed, WhereAHandLetsGo) {
  Answers said("identify/after_a_hold");
  for (unsigned seed = 1; seed <= 300; ++seed) {
    Chance chance(seed);
    const double periods = chance.between(5, 14), held = chance.between(0.3, 4),
                 falls = chance.between(0, 0.3), noise = chance.is(0.5) ? 1e-3 : chance.between(0, 0.2),
                 at = chance.is(0.5) ? 1 : chance.between(-1, 1),
                 rises = chance.is(0.6) ? 0 : chance.between(0, 3), spike = chance.is(0.7) ? 0 : 4.7;
    std::vector<double> t = some_times(chance, periods, 8, 40);
    SyntheticRecord record{t, {}, 0};
    for (std::size_t i = 0; i < t.size(); ++i) {
      const double after = t[i] - held;
      const double moves = std::exp(-falls * after) * (rises > 0 ? std::min(1.0, after / rises) : 1) *
                           (rises > 0 ? std::sin(two_pi * after) : std::cos(two_pi * after));
      record.y.push_back(3 + (after < 0 ? at : moves) + noise * chance.normal());
    }
    if (spike > 0) record.y[record.y.size() / 2] = spike;
    said << static_cast<int>(seed);
    say(said, find_free_part(record.record()));
    said << period_at_start(record.record()).value_or(0);
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Diagnosed, WhereAnEnvelopeHasAKink) {
  Answers said("identify/kinks");
  for (unsigned seed = 1; seed <= 160; ++seed) {
    Chance chance(seed);
    const auto n = static_cast<std::size_t>(chance.between(14, 40));
    const double at = chance.between(0.2, 0.8), before = chance.between(-0.4, 0.6),
                 after = chance.between(-2, 0.5), bent = chance.between(-0.5, 0.5),
                 beat = chance.is(0.5) ? 0 : chance.between(0, 0.6), turn = chance.between(2, 14),
                 noise = chance.is(0.5) ? 1e-3 : chance.between(0, 0.03);
    std::vector<double> t, amplitude;
    for (std::size_t i = 0; i < n; ++i) {
      t.push_back(3 + static_cast<double>(i) / static_cast<double>(n - 1) + chance.between(0, 0.01));
      const double s = t.back() - 3 - at;
      const double log = s < 0 ? before * s : after * s + bent * s * s;
      amplitude.push_back(std::exp(log + noise * chance.normal()) * (1 + beat * std::cos(turn * s)));
    }
    const auto kink = find_kink(t, amplitude);
    if (!kink) continue;
    said << static_cast<int>(seed) << kink->t << kink->before << kink->after;
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Diagnosed, WhereAMotionIsLost) {
  Answers said("identify/lost_motions");
  for (unsigned seed = 1; seed <= 600; ++seed) {
    Chance chance(seed);
    const double falls = chance.between(0, 0.7), resolution = chance.is(0.4) ? 0 : chance.between(0, 0.15),
                 periods = chance.between(5, 13), ends = chance.between(4, periods - 0.3),
                 value = chance.between(-1, 1), spikes = chance.is(0.5) ? 0 : chance.between(0, 0.5),
                 noise = chance.is(0.5) ? 0 : chance.between(0, 0.05);
    SyntheticRecord record = swing_of(chance, some_times(chance, periods, 7, 24), noise, 0,
                                      [&](double t) { return std::exp(-falls * t); });
    record.resolution = resolution;
    const bool stays_where_it_is = chance.is(0.3);
    double last = value;
    for (std::size_t i = 0; i < record.t.size(); ++i) {
      if (record.t[i] < ends)
        last = stays_where_it_is ? record.y[i] : value;
      else if (!chance.is(spikes))
        record.y[i] = last;
    }
    round_to(resolution, record.y);
    const auto lost = find_lost_motion(record.record());
    if (!lost) continue;
    said << static_cast<int>(seed) << lost->seen << lost->value << lost->share;
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Diagnosed, WhereASwingStops) {
  Answers said("identify/stops");
  for (unsigned seed = 1; seed <= 900; ++seed) {
    Chance chance(seed);
    const double periods = chance.between(9, 20), stops = periods - chance.between(0.3, 5),
                 falls = chance.between(0, 0.35), friction = chance.is(0.5) ? 0 : chance.between(0, 0.15),
                 braked = chance.between(0, 3.5), left = chance.between(0, 0.12),
                 resolution = chance.is(0.5) ? 0 : chance.between(0, 0.3),
                 noise = chance.is(0.5) ? 0 : chance.between(0, 0.02);
    std::vector<double> t = some_times(chance, periods, 7, 20);
    if (chance.is(0.15)) std::erase_if(t, [&](double at) { return at > stops - 1 && at < stops + 1.5; });
    const SyntheticRecord record = swing_of(chance, t, noise, resolution, [&](double at) {
      const double free = std::max(0.0, std::exp(-falls * at) - friction * at / 2);
      const double last = std::max(0.0, std::exp(-falls * stops) - friction * stops / 2);
      if (at < stops) return free;
      return last * std::max(left, braked > 0.5 ? 1 - (at - stops) / braked : 0);
    });
    for (const bool described : {false, true}) {
      const auto stop = find_stop(record.record(), 1, described);
      if (!stop) continue;
      said << static_cast<int>(seed) << described << stop->from << stop->to << stop->amplitude;
      said.end_line();
    }
  }
  said.expect_as_before();
}

TEST(Diagnosed, WhatStandsOut) {
  Answers said("identify/outliers");
  for (unsigned seed = 1; seed <= 250; ++seed) {
    Chance chance(seed);
    SyntheticRecord record{some_times(chance, chance.between(2, 8), 12, 20), {}, 0};
    const double grows = chance.is(0.5) ? 0 : 2, many = chance.between(0, 0.12),
                 slow = chance.is(0.6) ? 0 : chance.between(0, 4),
                 resolution = chance.is(0.5) ? 0 : chance.between(0, 4);
    std::vector<double> residuals;
    for (const double t : record.t) {
      const double motion = 30 * std::exp(-0.4 * t) * std::cos(two_pi * t);
      const double noise = (1 + grows * std::abs(motion) / 30) * chance.normal();
      residuals.push_back(noise + slow * std::sin(0.3 * t) + (chance.is(many) ? chance.between(-8, 8) : 0));
      record.y.push_back(motion + residuals.back());
    }
    record.resolution = resolution;
    const std::vector<std::size_t> found = outliers(record.record(), residuals);
    said << static_cast<int>(seed) << found;
    const KeptSamples kept(record.record(), found, residuals);
    said << kept.t.size() << kept.y.front() << kept.y.back();
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Diagnosed, WhatDropsOut) {
  Answers said("identify/drop_outs");
  for (unsigned seed = 1; seed <= 600; ++seed) {
    Chance chance(seed);
    const double resolution = chance.is(0.5) ? 0 : chance.between(0, 1), at = chance.between(-5, 5);
    const std::size_t longest = chance.is(0.5) ? 5 : 9;
    SyntheticRecord record = swing_of(chance, some_times(chance, chance.between(2, 6), 10, 40), 0, 0,
                                      [](double t) { return std::exp(-0.1 * t); });
    for (int i = 0; i < 1 + static_cast<int>(seed) % 3; ++i) {
      const auto from = static_cast<std::size_t>(
          chance.is(0.2) ? 0 : chance.between(0, static_cast<double>(record.y.size())));
      const auto length = static_cast<std::size_t>(chance.between(2, static_cast<double>(longest)));
      for (std::size_t k = from; k < std::min(record.y.size(), from + length); ++k) record.y[k] = at;
    }
    record.resolution = resolution;
    const std::vector<std::size_t> found = drop_outs(record.record());
    if (found.empty()) continue;
    said << static_cast<int>(seed) << found;
    said.end_line();
  }
  said.expect_as_before();
}

/// A swing with what the seed adds: noise, a coarse sensor, a second mode, harmonics, a drift, a jump.
SyntheticRecord seen(Chance& chance) {
  TrueSwing swing{.angular_frequency = two_pi * chance.between(0.9, 1.1),
                  .decay_rate = chance.between(0, 0.12),
                  .equilibrium = 0.3,
                  .position = 1,
                  .velocity = chance.between(-3, 3)};
  if (chance.is(0.3)) swing.drag = chance.between(0, 0.3);
  if (chance.is(0.2)) swing.cubic = chance.between(-3, 8);
  const std::vector<double> t = some_times(chance, chance.between(6, 40), 3, 30);
  SyntheticRecord record{t, free_motion(swing, t, 0.005).x, 0};
  const double noise = chance.is(0.5) ? chance.between(0, 0.01) : chance.between(0, 0.4),
               second = chance.is(0.6) ? 0 : chance.between(0, 0.1), its = chance.between(0.3, 4),
               third = chance.is(0.7) ? 0 : chance.between(0, 0.05),
               drift = chance.is(0.8) ? 0 : chance.between(-0.05, 0.05),
               jump = chance.is(0.8) ? 0 : chance.between(-0.5, 0.5);
  for (std::size_t i = 0; i < t.size(); ++i) {
    record.y[i] += noise * chance.normal() + second * std::cos(two_pi * its * t[i]) + drift * t[i] +
                   third * std::cos(3 * swing.angular_frequency * t[i]) + (t[i] > 4 ? jump : 0);
  }
  if (chance.is(0.3)) record.resolution = chance.is(0.5) ? chance.between(0, 0.2) : chance.between(0, 1.5);
  round_to(record.resolution, record.y);
  return record;
}

TEST(Diagnosed, WhatSpeaksAgainstAFit) {
  Answers said("identify/doubts");
  for (unsigned seed = 1; seed <= 160; ++seed) {
    Chance chance(seed);
    const SyntheticRecord made = seen(chance);
    Record record = made.record();
    if (chance.is(0.15)) record.derivative = 1;
    LawFitOptions options;
    options.every_sample = true;
    const LawFit fit = fit_law(record, options);
    said << static_cast<int>(seed) << fit.message;
    if (fit.is_usable()) {
      said << doubts(record, fit, seed % 2 == 0) << something_is_left(record, fit)
           << widening(fit, record.t.size())
           << second_modes(residual_lines(record, fit), fit, record.derivative, "m");
      const std::vector<double> residuals = residuals_of(fit, record);
      said << wandering_share(record, residuals) << wandering_zero(record, residuals, "m")
           << leaves_a_line(record.t, residuals, fit.decay_rate().value, fit.swing_frequency().value, 6);
      if (const auto decay = mean_decay(fit, record))
        said << decay->amplitude << decay->rate.value << decay->rate.standard_error;
    }
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Diagnosed, WhatSpeaksAgainstAnOscillation) {
  Answers said("identify/refusals");
  for (unsigned seed = 1; seed <= 200; ++seed) {
    Chance chance(seed);
    const double strong = chance.is(0.5) ? chance.between(0, 0.3) : chance.between(0.3, 1.2);
    const ViscousTruth truth{.w0 = two_pi,
                             .g = two_pi * std::min(strong, 0.999),
                             .equilibrium = 0.3,
                             .position = chance.between(-1, 1),
                             .velocity = chance.between(-6, 6)};
    const double noise = chance.is(0.5) ? chance.between(0, 0.02) : chance.between(0, 1),
                 resolution = chance.is(0.6) ? 0 : chance.between(0, 1),
                 top = chance.is(0.7) ? 10 : chance.between(0.2, 0.9);
    SyntheticRecord made =
        viscous_record(truth, some_times(chance, chance.between(0.7, 6), 9, 40), noise, 0, seed);
    for (double& y : made.y) y = std::min(y, top);
    made.resolution = resolution;
    round_to(resolution, made.y);
    const LawFit fit = fit_law(made.record(), {});
    said << static_cast<int>(seed) << static_cast<int>(fit.status) << fit.message;
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Diagnosed, WhatADriveLeaves) {
  Answers said("identify/second_drives");
  for (unsigned seed = 1; seed <= 150; ++seed) {
    Chance chance(seed);
    SyntheticRecord rest{some_times(chance, chance.between(3, 30), 9, 20), {}, 0};
    const double drive = two_pi * chance.between(0.5, 1), noise = chance.between(0, 0.3),
                 order = chance.is(0.5) ? 2 : 3, twice = order * drive * chance.between(0.98, 1.02),
                 other = two_pi * chance.between(0.1, 4), falls = chance.is(0.5) ? 0 : chance.between(0, 1),
                 near = other + chance.between(-2, 2);
    const double a = chance.between(0, 0.5), b = chance.between(0, 0.5), c = chance.is(0.5) ? 0 : 0.3;
    for (const double t : rest.t)
      rest.y.push_back(noise * chance.normal() + a * std::cos(twice * t) +
                       b * std::exp(-falls * t) * std::sin(other * t) + c * std::cos(near * t));
    rest.resolution = chance.is(0.7) ? 0 : chance.between(0, 0.5);
    said << static_cast<int>(seed) << second_drives(rest.record(), drive, "m")
         << second_drives(rest.record(), 0, "m");
    said.end_line();
  }
  said.expect_as_before();
}

TEST(Diagnosed, WhichMultipleAFrequencyIs) {
  Answers said("identify/harmonics");
  for (unsigned seed = 1; seed <= 250; ++seed) {
    Chance chance(seed);
    const FrequencyBand own{5, chance.between(5, 5.2), chance.between(0, 0.02)};
    const double order = std::floor(chance.between(1, 18)), w = 5 * order * chance.between(0.985, 1.05),
                 error = chance.between(0, 0.2), duration = chance.between(3, 30);
    const int multiple = harmonic_of(w, error, own, duration);
    if (multiple == 0) continue;
    said << static_cast<int>(seed) << multiple;
    said.end_line();
  }
  said.expect_as_before();
}

/// Fits whose numbers were thrown.
TEST(Diagnosed, WhatTheNumbersOfAFitSay) {
  Answers said("identify/fits");
  for (unsigned seed = 1; seed <= 200; ++seed) {
    Chance chance(seed);
    LawFit fit;
    fit.names = {"angular_frequency", "decay_rate", "drive_frequency"};
    if (chance.is(0.6)) fit.names.emplace_back("drive_amplitude");
    const double drive = chance.between(1, 3), order = std::floor(chance.between(1, 4)),
                 w = order * drive * (chance.is(0.5) ? 1 : chance.between(0.99, 1.01)),
                 error = chance.is(0.7) ? chance.between(0, 0.01) : chance.between(0, 2);
    const double g = chance.between(-0.1, 0.2), g_error = chance.between(0, 0.2);
    fit.estimates = {{w, error, w, w}, {g, g_error, g - g_error, g + g_error}, {drive, 0.001, drive, drive}};
    const double push = chance.between(0, 20);
    if (fit.names.size() > 3) fit.estimates.push_back({push, 0.1, push, push});
    const std::size_t n = fit.names.size();
    fit.covariance.assign(n * n, 0);
    fit.motion.set_angular_frequency(w);
    fit.motion.position = chance.between(-2, 2);
    fit.motion.velocity = chance.between(-4, 4);
    fit.explained = chance.between(-0.5, 1);
    fit.independent_samples = chance.between(0, 120);
    fit.residual.white = chance.is(0.2);
    fit.residual.autocorrelation = chance.between(-0.5, 0.9);
    fit.residual.autocorrelation_error = chance.between(0.05, 0.3);
    fit.residual.strongest = chance.between(-0.5, 0.9);
    fit.residual.strongest_lag = static_cast<int>(chance.between(1, 5));
    fit.residual.rms = chance.between(0, 0.4);
    said << static_cast<int>(seed);
    for (const auto& refusal : {refuse_harmonic(fit), refuse_frequency(fit)}) {
      if (refusal)
        said << static_cast<int>(refusal->status) << refusal->message;
      else
        said << "-";
    }
    said << explains_too_little(fit) << widening(fit, 100) << is_fed(fit);
    const double angle = chance.between(2.5, 9), falls = chance.between(0, 0.4);
    const SyntheticRecord record = swing_of(chance, some_times(chance, chance.between(3, 12), 2.5, 9), 0, 0,
                                            [&](double t) { return angle * std::exp(-falls * t); });
    said << few_samples(record.record(), two_pi * chance.between(0.5, 2)) << turning_over(record.record());
    said.end_line();
  }
  said.expect_as_before();
}

/// A swing of this law, its fit, and a line beside it.
TEST(Diagnosed, WhichMultipleOfABentSwingALineIs) {
  Answers said("identify/bent_swings");
  const char* laws[] = {"viscous+pendulum", "viscous+cubic", "viscous+odd-quadratic",
                        "viscous+quintic",  "viscous+drag",  "viscous+quadratic"};
  for (unsigned seed = 1; seed <= 120; ++seed) {
    Chance chance(seed);
    LawFit fit;
    fit.law = law_of(laws[seed % 6]);
    Motion& motion = fit.motion;
    motion = Motion{.position = chance.between(0.2, 2.8), .velocity = chance.between(-2, 2)};
    motion.law = fit.law;
    motion.set_angular_frequency(two_pi);
    motion.set_decay_rate(chance.is(0.3) ? chance.between(0, 1) : 0.02);
    const double bent = chance.between(-1, 6);
    if (fit.law.has<Cubic>()) motion.per_mass.cubic = bent;
    if (fit.law.has<OddQuadratic>()) motion.per_mass.odd_quadratic = bent;
    if (fit.law.has<Quadratic>()) motion.per_mass.quadratic = bent;
    if (fit.law.has<Quintic>()) motion.per_mass.quintic = bent / 4;
    if (fit.law.has<Drag>()) motion.per_mass.drag = std::abs(bent) / 10;
    fit.names = {"angular_frequency", "decay_rate"};
    const double g = motion.decay_rate();
    fit.estimates = {{two_pi, 1e-3, two_pi, two_pi}, {g, 1e-3, g, g}};
    fit.covariance = {1e-6, 0, 0, 1e-6};
    fit.student = 2;
    fit.step = 0.002;
    const std::vector<double> t = even_times(400, 0.04);
    SyntheticRecord record{t, free_motion(motion, t, 0.002).x, 0};
    const double order = std::floor(chance.between(0.4, 5)), at = order * two_pi * chance.between(0.7, 1.4),
                 size = chance.between(0.001, 0.1);
    for (std::size_t i = 0; i < t.size(); ++i)
      record.y[i] += size * std::sin(at * t[i]) + 1e-3 * chance.normal();
    said << static_cast<int>(seed);
    for (const ResidualLine& line : residual_lines(record.record(), fit))
      said << line.angular_frequency << line.frequency_error << line.amplitude << line.decay_rate
           << line.harmonic;
    if (const auto decay = mean_decay(fit, record.record())) said << decay->amplitude << decay->rate.value;
    said.end_line();
  }
  said.expect_as_before();
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
