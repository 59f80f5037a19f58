#include "bench/calibration/forced_rows.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <string_view>

#include "cromer/identify/choose/choose_law.h"
#include "cromer/methods/dormand_prince.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/sensor.h"
#include "cromer/run/solve.h"

namespace cromer::core::bench {
namespace {

constexpr double natural_frequency = 6, decay_rate = 0.1, duration = 40;  // [rad/s, 1/s, s]
constexpr double position = 0.02, velocity = 0.1, gain = 2;               // [m, m/s, m/s^2 per unit of force]
constexpr double drive_frequency = 6.5, drive_amplitude = 0.25;           // [rad/s, m/s^2]

struct Line {
  double amplitude, frequency, phase;  // [rad/s, rad]
};

struct Motion {
  std::vector<double> t, x, force;
  double phase = 0;  ///< of a harmonic drive
};

// The closed form of the linear law under lines.
std::vector<double> displacements(const std::vector<double>& t, const std::vector<Line>& lines) {
  using Complex = std::complex<double>;
  const double w0 = natural_frequency, g = decay_rate, w = std::sqrt(w0 * w0 - g * g);
  std::vector<Complex> steady;
  double x = position, v = velocity;
  for (const Line& line : lines) {
    steady.push_back(std::polar(line.amplitude, line.phase) /
                     Complex(w0 * w0 - line.frequency * line.frequency, 2 * g * line.frequency));
    x -= steady.back().real();
    v += line.frequency * steady.back().imag();
  }
  std::vector<double> result;
  for (const double s : t) {
    double sum = std::exp(-g * s) * (x * std::cos(w * s) + (v + g * x) / w * std::sin(w * s));
    for (std::size_t i = 0; i < lines.size(); ++i)
      sum += (steady[i] * std::polar(1.0, lines[i].frequency * s)).real();
    result.push_back(sum);
  }
  return result;
}

// Twenty lines of random phases between 0 and 12 rad/s.
std::vector<Line> smooth_force(SplitMix64& random) {
  std::vector<Line> lines;
  constexpr int count = 20;
  for (int i = 0; i < count; ++i)
    lines.push_back({std::sqrt(2.0 / count), 12 * (i + 0.5 + 0.5 * random.next_signed_unit()) / count,
                     std::numbers::pi * random.next_signed_unit()});
  return lines;
}

std::vector<double> times(double spacing) {
  std::vector<double> t;
  for (int i = 0; i < static_cast<int>(std::lround(duration / spacing)); ++i) t.push_back(spacing * i);
  return t;
}

Motion recorded_motion(double spacing, SplitMix64& random) {
  Motion motion;
  motion.t = times(spacing);
  std::vector<Line> lines = smooth_force(random);
  for (const double t : motion.t) {
    double sum = 0;
    for (const Line& line : lines) sum += line.amplitude * std::cos(line.frequency * t + line.phase);
    motion.force.push_back(sum);
  }
  for (Line& line : lines) line.amplitude *= gain;
  motion.x = displacements(motion.t, lines);
  return motion;
}

Motion driven_motion(double spacing, double friction, SplitMix64& random) {
  Motion motion;
  motion.t = times(spacing);
  motion.phase = std::numbers::pi * random.next_signed_unit();
  const Line line{drive_amplitude, drive_frequency, motion.phase};
  if (friction == 0) {
    motion.x = displacements(motion.t, {line});
    return motion;
  }
  const Oscillator<double> oscillator{.mass = 1,
                                      .stiffness = natural_frequency * natural_frequency,
                                      .damping = 2 * decay_rate,
                                      .friction = friction};
  const Interval interval{0, spacing * static_cast<double>(motion.t.size())};
  constexpr int steps = 8;
  KeepEvery keep(steps, count_steps(interval, spacing / steps));
  with_terms(oscillator, HarmonicDrive<double>{line.amplitude, line.frequency, line.phase},
             [&](const auto& system) {
               return solve(system, DormandPrince{}, interval, State<double>{position, velocity},
                            {spacing / steps, 1e-11}, keep);
             });
  motion.x = keep.take().x;
  motion.x.resize(motion.t.size());
  return motion;
}

// What is true, by the name that a fit gives it.
double truth_of(std::string_view name, const ForcedRow& row, const Motion& motion, double equilibrium) {
  if (name == "friction") return row.friction;
  if (name == "angular_frequency") return natural_frequency;
  if (name == "decay_rate") return decay_rate;
  if (name == "equilibrium") return equilibrium;
  if (name == "position") return position;
  if (name == "velocity") return velocity;
  if (name == "force_gain") return gain;
  if (name == "drive_frequency") return drive_frequency;
  if (name == "drive_amplitude") return drive_amplitude;
  if (name == "drive_phase") return motion.phase;
  return std::nan("");
}

constexpr const char* names_recorded[] = {"angular_frequency", "decay_rate", "position", "velocity",
                                          "force_gain"};
constexpr const char* names_driven[] = {"angular_frequency", "decay_rate",  "equilibrium",
                                        "position",          "velocity",    "drive_frequency",
                                        "drive_amplitude",   "drive_phase", "friction"};

LawFit fitted(const ForcedRow& row, const Motion& motion, const std::vector<double>& y) {
  const Record record{motion.t, y};
  if (!row.recorded)
    return fit_law(record, {.law = law_of(row.friction > 0 ? "viscous+friction" : "viscous"),
                            .drive = Drive::harmonic(),
                            .drive_frequency = drive_frequency});
  const ForceRecord force{motion.force, 0, row.spacing};
  return choose_law(record, {.drive = Drive::recorded(force)}, {}, {law_of("viscous"), {}}).chosen;
}

struct Verdict {
  bool converged = false;
  struct {
    bool covered = false;
    double error = 0, stated = 0;
  } of[max_parameters];
};

}  // namespace

Tally calibrate(const ForcedRow& row, std::size_t records, const Progress& progress) {
  std::vector<std::string_view> names;
  if (row.recorded)
    names.assign(std::begin(names_recorded), std::end(names_recorded));
  else
    names.assign(std::begin(names_driven), std::end(names_driven));
  std::vector<Verdict> verdicts(records);
  in_parallel(records, progress, [&](std::size_t i) {
    SplitMix64 random(seed_of(row.law, row.condition, i));
    NormalDeviates normal(random.next());
    const Motion motion = row.recorded ? recorded_motion(row.spacing, random)
                                       : driven_motion(row.spacing, row.friction, random);
    // A recorded force's offset cannot be told from the sensor's: its zero is where the spring rests.
    const double equilibrium = row.recorded ? 0 : 0.2;
    double squares = 0;
    for (const double x : motion.x) squares += x * x;
    const double noise = std::sqrt(squares / static_cast<double>(motion.x.size())) / row.motion_to_noise;
    const double memory = row.correlation, innovation = noise * std::sqrt(1 - memory * memory);
    double disturbance = noise * normal.next();
    std::vector<double> y;
    for (const double x : motion.x) {
      y.push_back(equilibrium + x + disturbance);
      disturbance = memory * disturbance + innovation * normal.next();
    }
    const LawFit fit = fitted(row, motion, y);
    verdicts[i].converged = fit.status == FitStatus::converged;
    if (!verdicts[i].converged) return;
    for (std::size_t j = 0; j < names.size(); ++j)
      if (const Estimate* estimate = fit.find(names[j])) {
        double error = estimate->value - truth_of(names[j], row, motion, equilibrium);
        if (names[j] == "drive_phase") error = std::remainder(error, 2 * std::numbers::pi);
        const bool covered =
            estimate->low <= estimate->value - error && estimate->value - error <= estimate->high;
        verdicts[i].of[j] = {covered, error, estimate->standard_error};
      }
  });

  Tally tally;
  tally.law = row.law;
  tally.condition = row.condition;
  tally.records = records;
  double converged = 0;
  for (const Verdict& verdict : verdicts) converged += verdict.converged;
  tally.failures = 1 - converged / static_cast<double>(records);
  for (std::size_t j = 0; j < names.size(); ++j) {
    ParameterTally parameter;
    parameter.name = names[j];
    double errors = 0, stated = 0;
    for (const Verdict& verdict : verdicts) {
      if (!verdict.converged) continue;
      parameter.coverage += verdict.of[j].covered / converged;
      errors += verdict.of[j].error * verdict.of[j].error;
      stated += verdict.of[j].stated * verdict.of[j].stated;
    }
    parameter.scatter = stated > 0 ? std::sqrt(errors / stated) : 0;
    parameter.stated = 1;
    tally.parameters.push_back(parameter);
  }
  return tally;
}

}  // namespace cromer::core::bench
