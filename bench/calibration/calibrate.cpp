#include "bench/calibration/calibrate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/calibration/in_parallel.h"
#include "cromer/identify/choose/choose_law.h"

namespace cromer::core::bench {
namespace {

// Starts of every phase, each with its own bound on the scatter.
struct Motion {
  Waveform waveform;
  Parameters bound{};  // standard deviations that no unbiased estimate can go below
};

constexpr int phases = 12;

std::vector<Motion> motions(const Oscillator<double>& oscillator, const Law& law,
                            const Condition& condition) {
  std::vector<Motion> result(phases);
  const FittedParameters fitted = fitted_parameters(law);
  for (int i = 0; i < phases; ++i) {
    Waveform& waveform = result[i].waveform;
    waveform = simulate_waveform(oscillator, 2 * std::numbers::pi * i / phases, condition.cycles);
    // The times of a record of this condition; its noise does not matter here.
    const SimulatedRecord record = simulate_record(waveform, condition, 1);
    const NormalEquations equations =
        motion_equations(fitted, record.truth.packed(fitted), {}, record.record(), waveform.step);
    const SquareMatrix covariance = inverse(equations.matrix, fitted.count);
    for (int j = 0; j < fitted.count; ++j)
      result[i].bound[j] =
          effective_noise(condition,
                          fitted.of[j].name == std::string_view("equilibrium") ? 0 : natural_frequency) *
          std::sqrt(covariance[j][j]);
  }
  return result;
}

// One fit held against the truth.
struct Verdict {
  bool converged = false, on_bound = false;
  struct {
    bool covered = false;
    double error = 0, stated = 0;  // over the bound
  } of[max_parameters];
};

Verdict judge(const LawFit& fit, const Truth& truth, const FittedParameters& fitted,
              const Parameters& bound) {
  Verdict verdict;
  verdict.converged = fit.status == FitStatus::converged;
  if (!verdict.converged) return verdict;
  for (int i = 0; i < fitted.count; ++i) {
    const Estimate* estimate = fit.find(fitted.of[i].name);
    if (!estimate) continue;
    const double value = truth.of(fitted.of[i].name);
    verdict.of[i] = {estimate->low <= value && value <= estimate->high, (estimate->value - value) / bound[i],
                     estimate->standard_error / bound[i]};
    verdict.on_bound |= !fitted.of[i].may_be_negative && estimate->value <= 0;
  }
  return verdict;
}

// The oscillator with its extra terms scaled to about so many standard errors each.
Oscillator<double> weakened(const TrueLaw& truth, const Law& law, const Condition& condition,
                            double strength) {
  Oscillator<double> oscillator = truth.oscillator;
  const FittedParameters fitted = fitted_parameters(law);
  for (int round = 0; round < 3; ++round) {
    const std::vector<Motion> all = motions(oscillator, law, condition);
    for (int i = 0; i < fitted.count; ++i) {
      const std::string_view name = fitted.of[i].name;
      double* coefficient = name == "drag"       ? &oscillator.drag
                            : name == "cubic"    ? &oscillator.cubic
                            : name == "friction" ? &oscillator.friction
                                                 : nullptr;
      if (!coefficient) continue;
      double mean = 0;
      for (const Motion& motion : all) mean += std::abs(*coefficient) / motion.bound[i] / phases;
      *coefficient *= strength / mean;
    }
  }
  return oscillator;
}

bool lacks(const Law& law, const Law& wanted) { return !law.contains(wanted); }

}  // namespace

Tally calibrate(const TrueLaw& truth, const Condition& condition, std::size_t records,
                const Progress& progress) {
  const Law law = *parse_law(truth.law);
  const FittedParameters fitted = fitted_parameters(law);
  const std::vector<Motion> all = motions(truth.oscillator, law, condition);
  std::vector<Verdict> verdicts(records);
  in_parallel(records, progress, [&](std::size_t i) {
    const Motion& motion = all[i % phases];
    const SimulatedRecord record =
        simulate_record(motion.waveform, condition, seed_of(truth.law, condition.name, i));
    LawFitOptions options;
    options.law = law;
    verdicts[i] = judge(fit_law(record.record(), options), record.truth, fitted, motion.bound);
  });

  Tally tally;
  tally.law = truth.law;
  tally.condition = condition.name;
  tally.records = records;
  double converged = 0;
  tally.parameters.resize(static_cast<std::size_t>(fitted.count));
  for (const Verdict& verdict : verdicts) {
    if (!verdict.converged) continue;
    ++converged;
    tally.on_bound += verdict.on_bound;
    for (int i = 0; i < fitted.count; ++i) {
      ParameterTally& parameter = tally.parameters[static_cast<std::size_t>(i)];
      parameter.coverage += verdict.of[i].covered;
      parameter.scatter += verdict.of[i].error * verdict.of[i].error;
      parameter.stated += verdict.of[i].stated * verdict.of[i].stated;
    }
  }
  const double count = std::max(1.0, converged);
  tally.failures = 1 - converged / static_cast<double>(records);
  tally.on_bound /= count;
  for (int i = 0; i < fitted.count; ++i) {
    ParameterTally& parameter = tally.parameters[static_cast<std::size_t>(i)];
    parameter.name = fitted.of[i].name;
    parameter.coverage /= count;
    parameter.scatter = std::sqrt(parameter.scatter / count);
    parameter.stated = std::sqrt(parameter.stated / count);
    for (const Motion& motion : all)
      parameter.strength += std::abs(motion.waveform.truth.of(parameter.name)) / motion.bound[i] / phases;
  }
  return tally;
}

Choices choose(const TrueLaw& truth, const Condition& condition, double strength, std::size_t records,
               const Progress& progress) {
  const Law law = *parse_law(truth.law);
  const std::vector<Motion> all =
      motions(strength > 0 ? weakened(truth, law, condition, strength) : truth.oscillator, law, condition);
  std::vector<Law> chosen(records);
  in_parallel(records, progress, [&](std::size_t i) {
    const SimulatedRecord record =
        simulate_record(all[i % phases].waveform, condition, seed_of(truth.law, "choice", i));
    chosen[i] = choose_law(record.record(), {}).chosen.law;
  });
  Choices choices{truth.law, condition.name, records, HUGE_VAL};
  const FittedParameters fitted = fitted_parameters(law);
  for (int i = 0; i < fitted.count; ++i) {
    const std::string_view name = fitted.of[i].name;
    if (name != "decay_rate" && name != "drag" && name != "friction" && name != "cubic") continue;
    double mean = 0;
    for (const Motion& motion : all)
      mean += std::abs(motion.waveform.truth.of(name)) / motion.bound[i] / phases;
    choices.strength = std::min(choices.strength, mean);
  }
  for (const Law& each : chosen) {
    const double share = 1 / static_cast<double>(records);
    choices.right += each == law ? share : 0;
    choices.needless += lacks(law, each) ? share : 0;
    choices.missed += lacks(each, law) ? share : 0;
  }
  return choices;
}

}  // namespace cromer::core::bench
