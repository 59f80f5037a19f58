// Task: the same run over grids of its options.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/base/result.h"
#include "cromer/ensemble/chunks.h"
#include "cromer/study/task/simulate.h"

namespace cromer {

/// What `cromer sweep` takes.
struct SweepOptions {
  SimulateOptions simulate{};                        ///< method, tolerance, drive's kind: what is not a grid
  std::map<std::string_view, std::string> values{};  ///< numeric options of simulate by name, as typed
  std::vector<std::string> measure{};                ///< names, also several with commas
  std::optional<double> settle{};                    ///< cycles dropped, >= 0; empty: found out
  std::string direction{};                           ///< up or down; empty: each point by itself
  std::optional<int> threads{};                      ///< > 0; empty: one for each processor
  bool check = false;                                ///< step a few points of a closed form, too
  double memory = 0;  // [bytes] that the rows may take; 0: no limit. Set by the caller, not an option
};

/// One option that takes several values.
struct SweptOption {
  std::string name;    ///< as typed: "drive-frequency"
  std::string column;  ///< "drive_frequency (rad/s)"
  std::uint64_t points = 0;
  std::string shown;      ///< the column for people, in the unit that its grid was given in
  double shown_unit = 1;  ///< that unit in SI
};

struct SweepWork;

/// A sweep that is ready to go: its rows, to be made in chunks by whoever does.
struct SweepPlan {
  std::vector<SweptOption> swept;     ///< outermost first
  std::vector<std::string> measured;  ///< columns of the measures
  std::string way;                    ///< "closed form", "settled", "to the end": how points are found
  std::string method;
  std::string simd;  ///< the unit of the kernel: baseline, avx2, avx512
  ChunkedRows rows;  ///< the swept values, the measures, and last the status (PointStatus)
  std::vector<std::string> warnings;
  std::shared_ptr<const SweepWork> work;  ///< what the rows depend on (sweep_rows.h)
};

/// Checks the options (an Error names option, value and constraint) and says what there is to do.
Result<SweepPlan> plan_sweep(const SweepOptions& options);

/// How many points ended in which way.
struct SweepCounts {
  std::uint64_t not_settled = 0, not_finite = 0, no_convergence = 0;
  bool ok() const { return not_finite == 0 && no_convergence == 0; }
};

/// Closed form and stepping side by side at a few points.
struct SweepCheck {
  std::size_t points = 0;
  double difference = 0;             ///< largest of the amplitude, relative
  std::size_t left_out = 0;          ///< points without a settled motion in closed form, or when stepped
  std::uint64_t first_left_out = 0;  ///< the row of the first of them
  std::string why{};                 ///< why that one is left out
};

struct SweepResult {
  SweepPlan plan;
  std::vector<double> rows;  ///< as ChunkedRows has them, without the status
  SweepCounts counts;
  std::optional<SweepCheck> check{};
  bool interrupted = false;  ///< rows that were not reached are NaN
  std::uint64_t done = 0;    ///< rows made
};

/// All rows, in memory.
Result<SweepResult> sweep(const SweepOptions& options, const Watch& watch = {});

/// The same of options that are planned already, made by `make`.
Result<SweepResult> sweep(SweepPlan plan, const SweepOptions& options, const ChunkMaker& make,
                          const Watch& watch);

/// Stepping beside the closed form at points all over the sweep; empty where there is no closed form, or no
/// time.
std::optional<SweepCheck> check_closed_form(const SweepPlan& plan, const Watch& watch);

/// Why a sweep does not take this option of simulate, or this text for one of its own that has no grid; empty
/// where there is nothing particular to say.
std::string sweep_refusal(std::string_view option, std::string_view text);

/// The status in the last column of a row is counted.
void count_status(double status, SweepCounts& counts);

}  // namespace cromer
