#include "cromer/documents/csv/spring.h"

#include <fmt/format.h>

#include <span>
#include <vector>

#include "cromer/report/csv.h"

namespace cromer::core {

std::string static_csv(const StaticStiffness& found) {
  std::string out;
  for (const Hold& hold : found.holds) {
    const double n = static_cast<double>(hold.samples);
    const auto cell = [](const double& value) { return std::span<const double>(&value, 1); };
    const CsvColumn columns[] = {{"file", hold.file},
                                 {"run", fmt::format("{}", hold.run)},
                                 {"from (s)", cell(hold.from)},
                                 {"to (s)", cell(hold.to)},
                                 {"samples", cell(n)},
                                 {"mass (kg)", cell(hold.mass.value)},
                                 {"mass standard error (kg)", cell(hold.mass.uncertainty)},
                                 {"position (m)", cell(hold.position)},
                                 {"position standard error (m)", cell(hold.standard_error)},
                                 {"stiffness (N/m)", cell(found.stiffness.value)},
                                 {"stiffness standard error (N/m)", cell(found.stiffness.standard_error)},
                                 {"stiffness 95 % low (N/m)", cell(found.stiffness.low)},
                                 {"stiffness 95 % high (N/m)", cell(found.stiffness.high)},
                                 {"gravity (m/s²)", cell(found.gravity.value)}};
    append_csv(out, columns, {}, out.empty());
  }
  return out;
}

std::string mass_line_csv(const MassLine& line) {
  std::string out;
  const auto cell = [](const double& value) { return std::span<const double>(&value, 1); };
  for (const MassLinePoint& point : line.points) {
    const double rest =
        point.period_square.value - (line.line.intercept + line.line.slope * point.mass.value);
    std::vector<CsvColumn> columns{
        {"file", point.file},
        {"run", fmt::format("{}", point.run)},
        {"mass (kg)", cell(point.mass.value)},
        {"mass standard error (kg)", cell(point.mass.uncertainty)},
        {"period squared (s²)", cell(point.period_square.value)},
        {"period squared standard error (s²)", cell(point.period_square.standard_error)},
        {"residual (s²)", cell(rest)}};
    const auto add = [&](const std::string& name, const Estimate& estimate, const std::string& unit) {
      columns.push_back({name + unit, cell(estimate.value)});
      columns.push_back({name + " standard error" + unit, cell(estimate.standard_error)});
      columns.push_back({name + " 95 % low" + unit, cell(estimate.low)});
      columns.push_back({name + " 95 % high" + unit, cell(estimate.high)});
    };
    add("stiffness", line.stiffness, " (N/m)");
    add("moving along", line.effective_mass, " (kg)");
    add("spring mass", line.spring_mass, " (kg)");
    append_csv(out, columns, {}, out.empty());
  }
  return out;
}

}  // namespace cromer::core
