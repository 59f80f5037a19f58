// Times in seconds for the rows of a table, their repair, and their steps: rate, jitter, gaps.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core::dialects {

/// The time column that belongs to column `j`: the nearest before it in its run, else the first of its run,
/// else the first of all.
std::optional<std::size_t> time_column_of(const Table& table, std::size_t j);

/// The same for all columns.
std::vector<std::optional<std::size_t>> time_columns_of(const Table& table);

/// The rows where the times start again near their beginning and rise from there. Missing times are skipped.
std::vector<std::size_t> restarts(const std::vector<double>& t);

/// Which rows stay so that their times rise strictly, and what was left out.
struct RisingTimes {
  std::vector<std::size_t> kept;  ///< indices into the times given
  std::vector<Notice> notices;    ///< counts and first line numbers
};

/// Repeated and backward times are left out, and all rows from where the time starts again. A time that runs
/// backward throughout is an Error. `lines` are the file's line numbers of the times.
Result<RisingTimes> keep_rising(const std::vector<double>& t, const std::vector<long>& lines);

/// The clock behind times that a logger wrote rounded.
struct EvenClock {
  std::vector<double> t;  // [s] the even times
  double spacing;         // [s] between samples
  double error;           ///< its relative standard error
  double rounding;        // [s] of the times as written
};

struct Steps {
  double rate = 0;    // [1/s] one over the median step; a round number where the times agree with it
  double jitter = 0;  ///< standard deviation of the steps over their median; 0 below the rounding of doubles
  std::vector<Gap> gaps;
  std::optional<EvenClock> clock{};  ///< where there is one; the gaps are then in its times
};

/// The steps of strictly rising times; all zero for fewer than two. A rate has 12 significant digits at most,
/// and is that of the even clock where there is one. A gap is a missing sample: a step of more than 1.5 usual
/// ones, after which the times stay late by more than half a step. A single late sample, jitter and rounding
/// are no gaps.
Steps describe_steps(std::span<const double> t);

}  // namespace cromer::core::dialects
