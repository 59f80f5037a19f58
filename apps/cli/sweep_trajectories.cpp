#include "sweep_trajectories.h"

#include <fmt/format.h>

#include <span>
#include <vector>

#include "cromer/base/quantity.h"
#include "cromer/cluster/disk.h"
#include "cromer/documents/words/words.h"
#include "cromer/report/csv.h"
#include "cromer/report/file.h"
#include "cromer/tasks/sweep/sweep_trajectories.h"
#include "output.h"

namespace cromer::core::cli {
namespace {

/// One block of states of one point, as rows.
void append_block(std::string& out, const SweepPlan& plan, const std::vector<double>& values,
                  const Trajectory& states, std::span<const std::string> comments, bool first) {
  std::vector<std::vector<double>> swept;
  for (const double value : values) swept.emplace_back(states.size(), value);
  std::vector<CsvColumn> columns;
  for (std::size_t i = 0; i < values.size(); ++i)
    columns.push_back({plan.swept[i].column, std::span<const double>(swept[i])});
  columns.push_back({"t (s)", std::span<const double>(states.t)});
  columns.push_back({"x (m)", std::span<const double>(states.x)});
  columns.push_back({"v (m/s)", std::span<const double>(states.v)});
  append_csv(out, columns, comments, first);
}

}  // namespace

Result<std::string> announce_trajectories(const SweepPlan& plan, const TrajectoryOptions& options) {
  const auto format = file_format(options.path);
  if (!format || *format != FileFormat::csv || options.path == "-")
    return Error{"trajectories_are_csv", {{"file", options.path}}};
  if (auto good = check_writable(options.path); !good) return good.error();
  const auto states = count_trajectory_states(plan, options.every);
  if (!states) return states.error();
  // Numbers have 18 characters or so where they are not round.
  const double bytes = *states * 18.0 * static_cast<double>(plan.swept.size() + 3);
  if (auto good = fits_on_disk(options.path, bytes); !good)
    return Error{"trajectories_do_not_fit", {{"what", good.error().notice}}};
  return fmt::format("trajectories: {} points, about {:.3g} states, at most some {} in {}", plan.rows.rows,
                     *states, bytes_in_words(bytes), options.path);
}

Result<std::string> write_trajectories(const SweepPlan& plan, const TrajectoryOptions& options,
                                       const std::string& command, const Watch& watch) {
  std::string said;
  const auto written = write_file(options.path, [&](const PieceSink& write) -> Result<void> {
    const std::vector<std::string> comments{command};
    bool first = true;
    const auto sink = [&](const std::vector<double>& values, const Trajectory& states) {
      std::string rows;
      append_block(rows, plan, values, states, first ? comments : std::vector<std::string>{}, first);
      first = false;
      return write(rows);
    };
    const auto run = run_trajectories(plan, options.every, sink, watch);
    if (!run) return run.error();
    if (run->failed > 0)
      said = fmt::format("trajectories: {} of {} points did not reach their end; what came before is there",
                         run->failed, plan.rows.rows);
    if (run->interrupted)
      said = fmt::format("trajectories: interrupted after {} of {} points", run->points + run->failed,
                         plan.rows.rows);
    return {};
  });
  if (!written) return written.error();
  return said;
}

}  // namespace cromer::core::cli
