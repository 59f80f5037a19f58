#include "cromer/documents/csv/sweep.h"

#include "cromer/documents/text/sweep.h"
#include "cromer/report/csv.h"

namespace cromer::core {

std::string sweep_csv(const SweepResult& result, const std::string& command) {
  const std::size_t width = result.plan.rows.columns.size() - 1;
  const std::size_t rows = result.rows.size() / width;
  std::vector<std::vector<double>> cells(width, std::vector<double>(rows));
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t column = 0; column < width; ++column) cells[column][i] = result.rows[i * width + column];
  std::vector<CsvColumn> columns;
  for (std::size_t column = 0; column < width; ++column)
    columns.push_back({result.plan.rows.columns[column], std::span<const double>(cells[column])});
  std::vector<std::string> comments;
  if (!command.empty()) comments = {command, "by " + how(result.plan), status_counts(result)};
  std::string out;
  append_csv(out, columns, comments, true);
  return out;
}

void append_trajectory(std::string& out, const SweepPlan& plan, const std::vector<double>& values,
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

}  // namespace cromer::core
