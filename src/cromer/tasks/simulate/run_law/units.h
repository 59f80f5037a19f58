// The units that run_law is compiled in, and what each of them does with a system.
#pragma once

#include "cromer/methods/all.h"
#include "cromer/run/solve.h"
#include "cromer/tasks/simulate/run_law.h"

namespace cromer::core {

Outcome run_free(const LawRun& run, KeepEvery& keep, const Watch& watch);
Outcome run_harmonic(const LawRun& run, KeepEvery& keep, const Watch& watch);
Outcome run_friction(const LawRun& run, KeepEvery& keep, const Watch& watch);
Outcome run_compensated(const LawRun& run, KeepEvery& keep, const Watch& watch);
Outcome run_hysteresis(const LawRun& run, KeepEvery& keep, const Watch& watch);
Outcome run_driven(const LawRun& run, const PulseDrive<double>& drive, KeepEvery& keep, const Watch& watch);
Outcome run_driven(const LawRun& run, const ChirpDrive<double>& drive, KeepEvery& keep, const Watch& watch);
Outcome run_driven(const LawRun& run, const SampledDrive& drive, KeepEvery& keep, const Watch& watch);

/// Looks the method up and runs it on a system: for with_terms to call.
inline auto by_method(const LawRun& run, KeepEvery& keep, const Watch& watch) {
  return [&](const auto& system) {
    return visit_method(run.method, run.settings, [&](const auto& method) {
      return solve(system, method, run.interval, run.start, run.control, keep, watch, {}, run.events);
    });
  };
}

}  // namespace cromer::core
