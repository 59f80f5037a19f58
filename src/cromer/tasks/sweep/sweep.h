// Task: the same run over grids of its options.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/function_ref.h"
#include "cromer/base/interrupt.h"
#include "cromer/ensemble/chunks.h"
#include "cromer/result.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// What `cromer sweep` takes.
struct SweepOptions {
  SimulateOptions simulate{};                        ///< what takes no grid: the method, the kind of drive
  std::map<std::string_view, std::string> values{};  ///< numeric options of simulate by name, as typed
  std::vector<std::string> measure{};                ///< names, also several with commas
  std::optional<double> settle{};                    ///< cycles to drop, >= 0; empty: until settled
  std::string direction{};                           ///< up, down or both; empty: each point by itself
  std::optional<int> threads{};                      ///< > 0; empty: one for each processor
  bool check = false;                                ///< also step a few points that have a closed form
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

/// A sweep that is ready to run: its rows, made chunk by chunk.
struct SweepPlan {
  std::vector<SweptOption> swept;     ///< outermost first
  std::vector<std::string> measured;  ///< columns of the measures
  Notice way;                         ///< how points are found: in closed form, stepped until settled, ...
  Notice steps;                       ///< how long steps and runs are; may be empty
  std::string method;
  std::string simd;  ///< instruction set of the kernel: baseline, avx2, avx512
  ChunkedRows rows;  ///< the swept values, the measures, and last the status (PointStatus)
  std::vector<Notice> notices;
  std::shared_ptr<const SweepWork> work;  ///< what the rows depend on (sweep_rows.h)
};

/// Checks the options (an Error names option, value and constraint) and plans the sweep.
Result<SweepPlan> plan_sweep(const SweepOptions& options);

/// How many points ended in each status, and which rows the notices are about.
struct SweepCounts {
  static constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();

  std::uint64_t done = 0, not_settled = 0, not_finite = 0, no_convergence = 0, unstable = 0, own_damping = 0;
  std::uint64_t first_own_damping = none;  ///< row
  std::uint64_t phase_outside = 0;         ///< lags outside 0 to pi
  std::uint64_t phase_worst = none;        ///< row of the lag farthest outside
  double phase_excess = 0;                 // [rad] how far that is, > 0
  bool ok() const { return not_finite == 0 && no_convergence == 0 && unstable == 0; }
  std::uint64_t with_numbers() const { return done + own_damping; }
};

/// The closed form compared with stepping at a few points.
struct SweepCheck {
  std::size_t points = 0;
  double difference = 0;             ///< largest relative difference of the amplitude
  std::size_t left_out = 0;          ///< points without a settled motion in closed form, or when stepped
  std::uint64_t first_left_out = 0;  ///< the row of the first of them
  Notice why{};                      ///< why that one is left out
};

struct SweepResult {
  SweepPlan plan;
  std::vector<double> rows;  ///< as ChunkedRows has them, without the status
  SweepCounts counts;
  std::optional<SweepCheck> check{};
  bool interrupted = false;               ///< rows that were not reached are NaN
  std::uint64_t done = 0;                 ///< rows made
  std::vector<unsigned char> statuses{};  ///< of each row: PointStatus, or not_reached
  static constexpr unsigned char not_reached = 255;
};

/// Makes all rows in memory.
Result<SweepResult> sweep(const SweepOptions& options, const Watch& watch = {});

/// The same of a plan, whose chunks `make` makes.
Result<SweepResult> sweep(SweepPlan plan, const SweepOptions& options, const ChunkMaker& make,
                          const Watch& watch);

/// Compares the closed form with stepping at points all over the sweep. Empty if there is no closed form, or
/// if interrupted.
std::optional<SweepCheck> check_closed_form(const SweepPlan& plan, const Watch& watch);

/// Counts a row as it was made: its status, in the last column, and a lag outside 0 to pi.
void count_row(const SweepPlan& plan, std::uint64_t row, const double* made, SweepCounts& counts);

/// The word for a row's status: settled, measured (after --settle), reached_end, settled_by_own_damping,
/// not_settled, unstable, not_finite, no_convergence or not_reached.
std::string_view status_word(const SweepPlan& plan, unsigned char status);

/// "60 points: 58 settled, 2 not_settled".
std::string status_counts(const SweepResult& result);

/// The plan's notices, and those that follow from the rows.
std::vector<Notice> notices_of(const SweepResult& result);

/// How many points failed: one notice for each way in which they did.
std::vector<Notice> failure_notices(const SweepResult& result);

/// Why a sweep does not take this option of simulate, or this grid for one of its own; empty if there is
/// nothing particular to say.
Notice sweep_refusal(std::string_view option, std::string_view text);

/// About how many states run_trajectories hands on: of each point the first and every n-th, n = `every` > 0.
/// Of more than 10000 points some stand for all. An adaptive method counts as if it took the default step. An
/// Error if the sweep looks for settled motion, which has no end.
Result<double> count_trajectory_states(const SweepPlan& plan, long long every);

/// Takes the next states of the point with these values of the swept options, in order; at most 4096 at once.
using TrajectorySink = FunctionRef<Result<void>(const std::vector<double>& values, const Trajectory& states)>;

struct SweptTrajectories {
  std::uint64_t points = 0;  ///< that reached their end
  std::uint64_t failed = 0;  ///< that ran away, or found no solution; their states up to there are handed on
  bool interrupted = false;
};

/// Hands on every n-th state (n = `every`) of each point of a sweep that runs to an end, point by point in
/// the order of the rows: a sweep of any length takes the memory of one block of states. An Error of the sink
/// ends it.
Result<SweptTrajectories> run_trajectories(const SweepPlan& plan, long long every, const TrajectorySink& sink,
                                           const Watch& watch);

}  // namespace cromer::core
