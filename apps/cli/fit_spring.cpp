#include "fit_spring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/documents/json/documents.h"
#include "cromer/documents/text/interval_text.h"
#include "cromer/documents/text/text_table.h"
#include "cromer/documents/text/words.h"
#include "cromer/documents/words/words.h"
#include "cromer/report/csv.h"
#include "cromer/report/file.h"
#include "cromer/tasks/fit/fit_static.h"
#include "cromer/tasks/fit/masses.h"
#include "exit_status.h"
#include "message.h"

namespace cromer::core::cli {
namespace {

/// Measured points with error bars, masses in grams; where they lie close to a line they are ringed.
void add_points(Panel& panel, const std::vector<UncertainPoint>& points, double y_unit) {
  Curve dots, bars;
  for (const UncertainPoint& point : points) {
    const double x = 1000 * point.x, y = point.y / y_unit, e = point.y_error / y_unit;
    dots.x.push_back(x);
    dots.y.push_back(y);
    bars.x.insert(bars.x.end(), {x, x, x});
    bars.y.insert(bars.y.end(), {y - e, y + e, std::numeric_limits<double>::quiet_NaN()});
    panel.notes.push_back({.text = "", .x = x, .y = y, .circle = true, .leader = false});
  }
  dots.role = bars.role = "measured";
  dots.mark = Mark::dots;
  dots.name = "measured";
  panel.curves.push_back(std::move(bars));
  panel.curves.push_back(std::move(dots));
}

/// The line through the points, and what it leaves of them; `y` and `rest` name the vertical axes.
Figure line_figure(const std::vector<UncertainPoint>& points, const LineWithErrors& line, const Axis& y,
                   double y_unit, const Axis& rest, double rest_unit, const Estimate& stiffness) {
  double high = 0;
  for (const UncertainPoint& point : points) high = std::max(high, 1.05 * point.x);
  Panel through, left;
  Curve straight, zero;
  for (const double m : {0.0, high}) {
    straight.x.push_back(1000 * m);
    straight.y.push_back((line.intercept + line.slope * m) / y_unit);
    zero.x.push_back(1000 * m);
    zero.y.push_back(0);
  }
  straight.role = zero.role = "fitted";
  straight.name = zero.name = "straight line";
  straight.remark = "{/:Italic k} = " + in_words(stiffness, "N/m");
  through.y = y;
  through.curves.push_back(std::move(straight));
  add_points(through, points, y_unit);
  std::vector<UncertainPoint> residuals = points;
  for (UncertainPoint& point : residuals) point.y -= line.intercept + line.slope * point.x;
  left.title = "What the line leaves";
  left.y = rest;
  left.curves.push_back(std::move(zero));
  add_points(left, residuals, rest_unit);
  for (Panel* panel : {&through, &left}) {
    panel->x.name = "mass {/:Italic m} (g)";
    panel->x.low = 0;
    panel->x.high = 1000 * high;
  }
  Figure figure;
  figure.size = FigureSize::single;
  figure.panels = {std::move(through), std::move(left)};
  return figure;
}

Figure static_figure(const StaticStiffness& found) {
  std::vector<UncertainPoint> points;
  for (const Hold& hold : found.holds)
    points.push_back({hold.mass.value, hold.position, hold.mass.uncertainty,
                      std::hypot(hold.standard_error, found.line.extra_scatter)});
  Axis y, rest;
  y.name = "position (mm)";
  rest.name = "residual (mm)";
  Figure figure = line_figure(points, found.line, y, 1e-3, rest, 1e-3, found.stiffness);
  figure.id = "static";
  figure.title = "Position at rest against mass, and what the line leaves";
  figure.panels.front().title = "Position at rest against mass";
  return figure;
}

std::string static_text(const StaticStiffness& found) {
  std::vector<std::vector<std::string>> rows{
      {"file", "run", "from (s)", "to (s)", "samples", "mass", "position"}};
  for (const Hold& hold : found.holds)
    rows.push_back({hold.file, fmt::format("{}", hold.run), fmt::format("{:.6g}", hold.from),
                    fmt::format("{:.6g}", hold.to), fmt::format("{}", hold.samples),
                    format_quantity(hold.mass, "kg"),
                    format_quantity({hold.position, hold.standard_error}, "m")});
  std::string out = text_table(rows, 1, 5);
  out += fmt::format("stiffness  {}, 95 % {} N/m (with g = {})\n", in_words(found.stiffness, "N/m"),
                     interval_text(found.stiffness.low, found.stiffness.high),
                     format_quantity(found.gravity, "m/s²"));
  return out;
}

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

}  // namespace

std::vector<Option> options_of(SpringOptions& o) {
  constexpr std::string_view group = "The spring constant from several masses";
  return {
      {"static", &o.held, "", Range::any,
       "from held extensions: a run, file or plateau for each of --masses, at rest", "the law of a swing",
       group},
      {"mass-line", &o.mass_line, "", Range::any,
       "from the periods: T² against --masses, one for each recording and run; also the spring's own mass",
       "each by itself", group},
      {"masses", &o.masses, "", Range::any, "\"48.4 g, 67.95 g, 87.96 g\", in the order of the recordings",
       "none", group},
      {"gravity", &o.gravity, "m/s^2", Range::positive, "local acceleration of free fall, for --static",
       "9.80665 m/s²", group},
  };
}

Result<void> check(const SpringOptions& options) {
  if (options.held && options.mass_line) return Error{"static_or_mass_line"};
  const char* way = options.held ? "static" : "mass-line";
  if (!options.held && options.gravity) return Error{"gravity_without_static"};
  if (!options.held && !options.mass_line)
    return options.masses.empty() ? Result<void>{} : Error{"masses_without_line"};
  if (options.masses.empty()) return Error{"masses_needed", {{"way", way}}};
  const auto masses = parse_masses(options.masses);
  if (!masses) return masses.error();
  if (masses->size() < 2) return Error{"two_masses_needed", {{"way", way}}};
  return {};
}

int run_static(const std::vector<std::string>& files, const FitOptions& fit, const SpringOptions& options,
               const OutputOptions& output) {
  std::vector<NamedBytes> bytes;
  for (const auto& file : files) {
    auto read = read_file(file);
    if (!read) return refuse(read.error());
    bytes.emplace_back(file, *std::move(read));
  }
  StaticOptions task{fit, options.masses, options.gravity.value_or(Quantity{9.80665, 0})};
  const auto found = fit_static(bytes, task);
  if (!found) return refuse(found.error());
  if (!output.output.empty()) {
    const bool csv = *file_format(output.output) == FileFormat::csv;
    if (auto good = write_file(output.output, csv ? static_csv(*found) : to_json(*found)); !good)
      return refuse(good.error());
  }
  if (output.output != "-" && !print(output.json ? to_json(*found) : static_text(*found)))
    return refuse("standard output cannot be written");
  if (!output.plot.empty())
    if (auto good = write_plot(output.plot, static_figure(*found)); !good) return refuse(good.error());
  tell(found->notices, output);
  return done;
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

std::string mass_line_text(const MassLine& line) {
  return fmt::format(
      "T² against mass, {} recordings: stiffness {}, 95 % {} N/m; moving along {}, so a spring of {}\n",
      line.points.size(), in_words(line.stiffness, "N/m"),
      interval_text(line.stiffness.low, line.stiffness.high), in_words(line.effective_mass, "kg"),
      in_words(line.spring_mass, "kg"));
}

Figure mass_line_figure(const MassLine& line) {
  std::vector<UncertainPoint> points;
  for (const MassLinePoint& point : line.points)
    points.push_back({point.mass.value, point.period_square.value, point.mass.uncertainty,
                      std::hypot(point.period_square.standard_error, line.line.extra_scatter)});
  Axis y, rest;
  y.name = "period squared {/:Italic T}^{2} (s²)";
  y.low = 0;
  rest.name = "residual (10^{−3} s²)";
  Figure figure = line_figure(points, line.line, y, 1, rest, 1e-3, line.stiffness);
  figure.id = "mass-line";
  figure.title = "Period squared against mass, and what the line leaves";
  figure.panels.front().title = "Period squared against mass";
  return figure;
}

}  // namespace cromer::core::cli
