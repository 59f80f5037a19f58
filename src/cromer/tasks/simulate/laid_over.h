// A recording laid under simulated runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cromer/read/recording.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

struct OverOptions {
  std::string file{};
  std::string column{};          ///< a position, else an angle
  std::optional<int> run{};      ///< >= 1; the first
  std::optional<double> from{};  // [s] of the recording, where the runs begin; its first sample
  double offset = 0;             // [m] or [rad], what it reads at x = 0
};

/// What the program takes beside the options of simulate.
std::vector<Option> options_of(OverOptions& options);

/// Whether these are positions or angles, or may be: the file says nothing else.
bool lies_under_runs(const Series& series);

/// The samples on the runs' own time and displacement.
struct LaidOver {
  std::string name;       ///< of the column
  std::string unit;       ///< of x
  std::vector<double> t;  // [s] from the runs' start on
  std::vector<double> x;  // [m] or [rad]
};

/// The samples from `options.from` on, until the longest run ends. An Error if the column is no position or
/// angle, or none of its samples lies there.
Result<LaidOver> lay_over(const Recording& recording, const OverOptions& options, const SimulateResult& runs,
                          const ReadOptions& read);

/// How far a run is from the samples within it: its rms, between kept states by the line through them. Empty
/// if none is.
Notice distance_notice(const LaidOver& samples, const SimulatedRun& run);

}  // namespace cromer::core
