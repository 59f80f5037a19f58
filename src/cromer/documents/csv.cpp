#include "cromer/documents/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "cromer/documents/described/simulate.h"
#include "cromer/documents/described/spectrum.h"
#include "cromer/documents/text.h"
#include "cromer/documents/words/words.h"
#include "cromer/model/sensor.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/recording.h"
#include "cromer/report/csv.h"
#include "cromer/tasks/fit/fitted_motion.h"

namespace cromer::core {

namespace {

/// "PSA (g)"; the name alone where there is no unit.
std::string heading(std::string_view name, std::string_view unit) {
  return unit.empty() ? std::string(name) : fmt::format("{} ({})", name, unit);
}

/// Adds a column for each list of numbers in the description of `result`. `what` follows its name:
/// "PSV RotD50 (m/s)". `unit_of` replaces units that depend on the result.
template <class Result, class UnitOf>
void add_columns(NamedColumns& columns, const Result& result, const std::string& what, UnitOf unit_of) {
  for_each_entry(Described<Result>::entries, [&](const auto& entry) {
    using Value = described::ValueOf<std::remove_cvref_t<decltype(entry)>, Result>;
    if constexpr (std::is_same_v<typename described::OptionalTraits<Value>::Inner, std::vector<double>>)
      if (std::optional<std::vector<double>> numbers = entry.of(result))
        columns.add(heading(std::string(entry.name) + what, unit_of(entry.unit))) = std::move(*numbers);
  });
}

std::vector<CsvColumn> csv_columns(const NamedColumns& columns) {
  std::vector<CsvColumn> all;
  for (std::size_t i = 0; i < columns.headers.size(); ++i)
    all.push_back({columns.headers[i], std::span<const double>(columns.values[i])});
  return all;
}

}  // namespace

Result<std::string> recording_csv(const Recording& recording, const ReadOptions& options) {
  const auto table = clean_table(recording, options);
  if (!table) return table.error();
  std::vector<CsvColumn> cells;
  for (std::size_t i = 0; i < table->columns.size(); ++i)
    cells.push_back({column_heading(*table, i), std::span<const double>(table->columns[i].values)});
  std::string out;
  append_csv(out, cells, {}, true);
  return out;
}

NamedColumns state_columns(const SimulatedRun& run) {
  NamedColumns columns;
  add_columns(columns, KeptStates{run}, "", [](std::string_view unit) { return unit; });
  return columns;
}

namespace {

std::vector<std::string> comments(const SimulateResult& result, const std::string& command) {
  if (command.empty()) return {};
  std::vector<std::string> lines{command};
  if (result.options.sensor.used)
    lines.emplace_back("synthetic: a simulated motion sensor, not a measurement");
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    const SimulatedRun& run = result.runs[i];
    if (result.runs.size() > 1) lines.push_back(fmt::format("run {}: {}", i + 1, run.label));
    if (!run.message.empty()) lines.push_back(fmt::format("run {}: {}", i + 1, in_words(run.message)));
  }
  return lines;
}

std::string states_csv(const SimulateResult& result, const std::vector<std::string>& head) {
  std::string out;
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    const NamedColumns states = state_columns(result.runs[i]);
    std::vector<CsvColumn> columns = csv_columns(states);
    columns.insert(columns.begin(), {"run", fmt::format("{}", i + 1)});
    append_csv(out, columns, i == 0 ? head : std::vector<std::string>{}, i == 0);
  }
  return out;
}

std::string sensor_csv(const SimulateResult& result, const std::vector<std::string>& head) {
  std::size_t rows = 0;
  for (const auto& run : result.runs) rows = std::max(rows, run.sensor.size());
  // Shorter runs end with empty cells.
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::vector<double>> cells;
  for (const auto& run : result.runs) {
    auto& times = cells.emplace_back(run.trajectory.t);
    std::transform(times.begin(), times.end(), times.begin(), to_15_digits);
    times.resize(rows, missing);
    cells.emplace_back(run.sensor).resize(rows, missing);
  }
  std::vector<CsvColumn> columns;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string run = result.runs.size() > 1 ? fmt::format(" Run #{}", i / 2 + 1) : "";
    columns.push_back({(i % 2 ? "Position (m)" : "Time (s)") + run, std::span<const double>(cells[i])});
  }
  std::string out;
  append_csv(out, columns, head, true);
  return out;
}

}  // namespace

std::string simulate_csv(const SimulateResult& result, const std::string& command) {
  const auto head = comments(result, command);
  return result.options.sensor.used ? sensor_csv(result, head) : states_csv(result, head);
}

namespace {

/// A quantity as a column. The same quantity in another unit (the equilibrium of an angle) is another column.
struct NamedQuantity {
  std::string name, unit;

  friend bool operator==(const NamedQuantity&, const NamedQuantity&) = default;
  std::string heading(std::string_view what) const {
    return name + std::string(what) + (unit.empty() || unit == "1" ? "" : " (" + unit + ")");
  }
};

/// All quantities of one recording, in the order of the JSON document.
std::vector<Parameter> numbers_of(const FittedRecording& fitted) {
  std::vector<Parameter> all = fitted.parameters;
  all.insert(all.end(), fitted.derived.begin(), fitted.derived.end());
  for (std::size_t i = 0; i < fitted.segments.size(); ++i)
    all.push_back({fmt::format("decay_rate_segment_{}", i + 1), fitted.segments[i].rate, "1/s"});
  if (fitted.decay_rate_mean) all.push_back({"decay_rate_mean", *fitted.decay_rate_mean, "1/s"});
  if (fitted.reynolds_max) all.push_back({"reynolds_max", *fitted.reynolds_max, "1"});
  if (fitted.keulegan_carpenter) all.push_back({"keulegan_carpenter_max", *fitted.keulegan_carpenter, "1"});
  return all;
}

/// Adds the quantities of a fit that are new. Each stands behind the one that precedes it in its own fit.
void add_quantities(std::vector<NamedQuantity>& head, const FittedRecording& fitted) {
  std::size_t place = 0;
  for (const auto& number : numbers_of(fitted)) {
    const NamedQuantity quantity{number.name, number.unit};
    const auto known = std::find(head.begin(), head.end(), quantity);
    if (known != head.end()) {
      place = static_cast<std::size_t>(known - head.begin()) + 1;
      continue;
    }
    head.insert(head.begin() + static_cast<std::ptrdiff_t>(place), quantity);
    ++place;
  }
}

double or_empty(double value) {
  return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
}

void append_row(std::string& out, const FittedRecording& fitted, const std::vector<NamedQuantity>& head) {
  const std::vector<Parameter> numbers = numbers_of(fitted);
  std::vector<double> cells;
  for (const auto& quantity : head) {
    const auto found = std::find_if(numbers.begin(), numbers.end(), [&](const Parameter& number) {
      return number.name == quantity.name && number.unit == quantity.unit;
    });
    const Estimate estimate =
        found == numbers.end() ? Estimate{HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL} : found->estimate;
    cells.push_back(or_empty(estimate.value));
    cells.push_back(or_empty(estimate.standard_error));
    cells.push_back(or_empty(estimate.low));
    cells.push_back(or_empty(estimate.high));
  }
  cells.push_back(or_empty(fitted.parameters.empty() ? HUGE_VAL : fitted.fit.residual.rms));
  const auto cell = [&](std::size_t i) { return std::span<const double>(&cells[i], 1); };

  std::vector<CsvColumn> columns{{"file", fitted.file},
                                 {"run", fmt::format("{}", fitted.series.run)},
                                 {"column", fitted.series.column},
                                 {"law", fitted.parameters.empty() ? "" : to_text(fitted.fit.law)},
                                 {"status", std::string(fitted.status())}};
  for (std::size_t i = 0; i < head.size(); ++i) {
    columns.push_back({head[i].heading(""), cell(4 * i)});
    columns.push_back({head[i].heading(" standard error"), cell(4 * i + 1)});
    columns.push_back({head[i].heading(" 95 % low"), cell(4 * i + 2)});
    columns.push_back({head[i].heading(" 95 % high"), cell(4 * i + 3)});
  }
  columns.push_back({"residual rms (SI unit of the column)", cell(cells.size() - 1)});
  columns.push_back({"message", in_words(fitted.fit.message)});
  append_csv(out, columns, {}, out.empty());
}

}  // namespace

std::string fit_csv(std::span<const FittedRecording> fits) {
  std::vector<NamedQuantity> head;
  for (const auto& fitted : fits) add_quantities(head, fitted);
  std::string out;
  for (const auto& fitted : fits) append_row(out, fitted, head);
  return out;
}

namespace {

/// 1 for samples that were set aside, else 0.
std::vector<double> set_aside(const FittedRecording& fitted, const std::vector<double>& t) {
  std::vector<double> aside(t.size(), 0.0);
  const auto& outliers = fitted.series.outliers;
  for (std::size_t i = 0, k = 0; i < t.size(); ++i) {
    while (k < outliers.size() && outliers[k].t < t[i]) ++k;
    if (k < outliers.size() && outliers[k].t == t[i]) aside[i] = 1;
  }
  return aside;
}

}  // namespace

std::string motion_csv(std::span<const FittedRecording> fits) {
  std::string out;
  for (const auto& fitted : fits) {
    if (fitted.parameters.empty()) continue;
    const FittedMotion motion = fitted_motion(fitted);
    const auto [measured, x, v, energy] = motion_units(fitted);
    std::vector<CsvColumn> columns{{"file", fitted.file},
                                   {"run", fmt::format("{}", fitted.series.run)},
                                   {"t (s)", std::span<const double>(motion.t)},
                                   {heading("measured", measured), std::span<const double>(motion.measured)},
                                   {heading("x", x), std::span<const double>(motion.x)},
                                   {heading("v", v), std::span<const double>(motion.v)},
                                   {heading("energy", energy), std::span<const double>(motion.energy)},
                                   {heading("residual", measured), std::span<const double>(motion.residual)}};
    if (!motion.local_velocity.empty())
      columns.push_back({heading("v from the samples", v), std::span<const double>(motion.local_velocity)});
    const std::vector<double> aside = set_aside(fitted, motion.t);
    columns.push_back({"set aside", std::span<const double>(aside)});
    append_csv(out, columns, {}, out.empty());
  }
  return out;
}

std::string compare_csv(std::span<const CompareResult> comparisons) {
  std::string out;
  for (const auto& comparison : comparisons) {
    const Series& series = comparison.recording.series;
    std::vector<double> measured = series.y;
    for (double& y : measured) y -= comparison.recording.fit.equilibrium().value;
    const std::string unit = unit_of(series);
    for (const auto& curve : comparison.curves) {
      const CsvColumn columns[] = {
          {"run", fmt::format("{}", series.run)},
          {"curve", in_words(curve.label)},
          {"t (s)", std::span<const double>(series.t)},
          {heading("measured displacement", unit), std::span<const double>(measured)},
          {heading("simulated displacement", unit), std::span<const double>(curve.trajectory.x)}};
      append_csv(out, columns, {}, out.empty());
    }
  }
  return out;
}

NamedColumns spectrum_columns(const SpectrumResult& result, const ResponseSpectrum& spectrum) {
  const auto unit_of = [&](std::string_view unit) {
    return unit == unit_as_written         ? written_unit(result)
           : unit == shock_unit_as_written ? shock_unit(result)
                                           : unit;
  };
  const SpectrumOf described{result, spectrum};
  NamedColumns columns;
  add_columns(columns, described, "", unit_of);
  if (!spectrum.shock.empty()) {
    auto& frequency = columns.insert(1, "frequency (Hz)");
    for (const double period : result.periods) frequency.push_back(1 / period);
  }
  if (!described.two()) return columns;
  const auto add = [&](const std::vector<double>& displacement, const std::string& what) {
    add_columns(columns, described.values(displacement), what, unit_of);
  };
  for (std::size_t c = 0; c < spectrum.displacement.size(); ++c)
    add(spectrum.displacement[c], fmt::format(" {}", c + 1));
  add(spectrum.geometric_mean, " geometric mean");
  add(spectrum.rotd50, " RotD50");
  add(spectrum.rotd100, " RotD100");
  return columns;
}

namespace {

/// The rows of one motion, behind a column with its name if it is one of several.
void append_rows(std::string& out, const SpectrumResult& result, const std::optional<std::string>& motion,
                 const std::string& command, bool with_header) {
  for (const auto& spectrum : result.spectra) {
    NamedColumns columns = spectrum_columns(result, spectrum);
    columns.insert(1, result.hysteretic() ? "loss_factor" : "damping_ratio")
        .assign(result.periods.size(), spectrum.damping_ratio);
    if (result.inelastic()) columns.insert(2, "ductility").assign(result.periods.size(), spectrum.ductility);
    std::vector<CsvColumn> cells = csv_columns(columns);
    if (motion) cells.insert(cells.begin(), {"file", *motion});
    const bool first = with_header && &spectrum == &result.spectra.front();
    const std::vector<std::string> comments{command};
    append_csv(out, cells, first ? comments : std::vector<std::string>{}, first);
  }
}

}  // namespace

std::string spectrum_csv(const SpectrumResult& result, const std::string& command) {
  std::string out;
  append_rows(out, result, std::nullopt, command, true);
  return out;
}

void append_spectra(std::string& out, const MotionSpectra& motion, const std::string& command, bool first) {
  append_rows(out, *motion.result, fmt::format("{}", fmt::join(motion.files, " + ")), command, first);
}

std::string ground_csv(const SpectrumResult& result, const std::string& command) {
  NamedColumns columns;
  auto& t = columns.add("t (s)");
  for (std::size_t i = 0; i < result.components[0].samples; ++i)
    t.push_back(result.components[0].begins + result.components[0].spacing * static_cast<double>(i));
  for (std::size_t c = 0; c < result.components.size(); ++c) {
    const Component& component = result.components[c];
    const std::string which = result.components.size() > 1 ? fmt::format(" {}", c + 1) : "";
    columns.add(heading("acceleration" + which, written_unit(result))) = component.acceleration;
    for (double& a : columns.values.back()) a /= written_acceleration(result);
    columns.add(heading("velocity" + which, "m/s")) = component.path.velocity;
    columns.add(heading("displacement" + which, "m")) = component.path.displacement;
  }
  std::string out;
  append_csv(out, csv_columns(columns), std::vector{command}, true);
  return out;
}

std::string fourier_csv(const SpectrumResult& result, const std::string& command) {
  NamedColumns cells;
  auto& frequency = cells.add("frequency (Hz)");
  const FourierAmplitude& first = result.components[0].fourier;
  for (std::size_t i = 0; i < first.amplitude.size(); ++i)
    frequency.push_back(first.step * static_cast<double>(i));
  for (std::size_t c = 0; c < result.components.size(); ++c)
    cells.add(
        fmt::format("amplitude{} (m/s)", result.components.size() > 1 ? fmt::format(" {}", c + 1) : "")) =
        result.components[c].fourier.amplitude;
  std::string out;
  append_csv(out, csv_columns(cells), std::vector{command}, true);
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

namespace {

/// "ground-left", with a number where several links join the same two.
std::vector<std::string> link_names(const Network& network) {
  std::vector<std::string> names;
  std::map<std::string, int> taken;
  for (const NetworkLink& link : network.links) {
    std::string name = name_of(network, link.from) + "-" + name_of(network, link.to);
    const int number = ++taken[name];
    names.push_back(number == 1 ? name : fmt::format("{} {}", name, number));
  }
  return names;
}

}  // namespace

std::string network_csv(std::span<const NetworkRun> runs, const std::string& command) {
  std::string out;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const NetworkRun& run = runs[r];
    const bool angles = run.network.angles;
    std::vector<CsvColumn> columns;
    if (runs.size() > 1) columns.push_back({"run", fmt::format("{}", r + 1)});
    columns.push_back({"t (s)", run.states.t});
    for (std::size_t i = 0; i < run.network.masses.size(); ++i) {
      const std::string& name = run.network.masses[i].name;
      columns.push_back({name + (angles ? " x (rad)" : " x (m)"), run.states.x[i]});
      columns.push_back({name + (angles ? " v (rad/s)" : " v (m/s)"), run.states.v[i]});
    }
    columns.push_back({"energy (J)", run.states.energy});
    const std::vector<std::string> names = link_names(run.network);
    std::vector<std::vector<double>> stored;
    for (std::size_t l = 0; l < names.size(); ++l) stored.push_back(stored_by(run, l));
    for (std::size_t l = 0; l < names.size(); ++l) columns.push_back({names[l] + " energy (J)", stored[l]});
    std::vector<std::string> head;
    if (r == 0 && !command.empty()) {
      head.push_back(command);
      for (std::size_t each = 0; runs.size() > 1 && each < runs.size(); ++each)
        head.push_back(fmt::format("run {}: {}", each + 1, runs[each].method));
    }
    append_csv(out, columns, head, r == 0);
  }
  return out;
}

std::string network_fit_csv(const FittedNetwork& fitted) {
  std::string out;
  const auto cell = [](const double& value) { return std::span<const double>(&value, 1); };
  const Network& network = fitted.asked.network;
  for (std::size_t l = 0; l < network.links.size(); ++l)
    for (const auto& [name, estimate, unit] : fitted.found_of(l)) {
      const CsvColumn columns[] = {{"from", name_of(network, network.links[l].from)},
                                   {"to", name_of(network, network.links[l].to)},
                                   {"parameter", name},
                                   {"value", cell(estimate.value)},
                                   {"standard error", cell(estimate.standard_error)},
                                   {"95 % low", cell(estimate.low)},
                                   {"95 % high", cell(estimate.high)},
                                   {"unit", unit}};
      append_csv(out, columns, {}, out.empty());
    }
  return out;
}

std::string modes_csv(const ModesResult& result) {
  NamedColumns table;
  const auto add = [&](std::string header, const auto& value) {
    std::vector<double>& column = table.add(std::move(header));
    for (const NaturalMode& mode : result.modes) column.push_back(value(mode));
  };
  std::vector<double>& number = table.add("mode");
  for (std::size_t j = 1; j <= result.modes.size(); ++j) number.push_back(static_cast<double>(j));
  const auto add_estimate = [&](const std::string& name, const std::string& unit,
                                Estimate NaturalMode::*member) {
    add(name + unit, [&](const NaturalMode& mode) { return (mode.*member).value; });
    add(name + " standard error" + unit,
        [&](const NaturalMode& mode) { return (mode.*member).standard_error; });
    add(name + " 95 % low" + unit, [&](const NaturalMode& mode) { return (mode.*member).low; });
    add(name + " 95 % high" + unit, [&](const NaturalMode& mode) { return (mode.*member).high; });
  };
  add_estimate("frequency", " (Hz)", &NaturalMode::frequency);
  add_estimate("damping ratio", "", &NaturalMode::damping_ratio);
  add("participation", [](const NaturalMode& mode) {
    return mode.participation.value_or(std::numeric_limits<double>::quiet_NaN());
  });
  for (std::size_t i = 0; i < result.names.size(); ++i) {
    add(result.names[i] + " re", [&](const NaturalMode& mode) { return mode.shape[i].real(); });
    add(result.names[i] + " im", [&](const NaturalMode& mode) { return mode.shape[i].imag(); });
  }
  if (result.recording)
    for (std::size_t i = 0; i < result.names.size(); ++i) {
      add(result.names[i] + " re standard error",
          [&](const NaturalMode& mode) { return mode.shape_error[i].real(); });
      add(result.names[i] + " im standard error",
          [&](const NaturalMode& mode) { return mode.shape_error[i].imag(); });
    }
  if (result.recording && result.network) {
    const auto add_of_network = [&](std::string header, auto ModeOfNetwork::*member) {
      add(std::move(header), [&](const NaturalMode& mode) {
        return mode.of_network ? static_cast<double>((*mode.of_network).*member)
                               : std::numeric_limits<double>::quiet_NaN();
      });
    };
    add_of_network("mode of the network", &ModeOfNetwork::mode);
    add_of_network("frequency of the network (Hz)", &ModeOfNetwork::frequency);
    add_of_network("damping ratio of the network", &ModeOfNetwork::damping_ratio);
    add_of_network("MAC", &ModeOfNetwork::mac);
  }
  if (!result.modes.empty() && !result.modes.front().methods.empty())
    for (std::size_t k = 0; k < result.modes.front().methods.size(); ++k) {
      const std::string& method = result.modes.front().methods[k].method;
      const auto number_of = [](const std::optional<double>& value) {
        return value.value_or(std::numeric_limits<double>::quiet_NaN());
      };
      add("frequency by " + method + " (Hz)",
          [&](const NaturalMode& mode) { return number_of(mode.methods[k].frequency()); });
      add("damping ratio by " + method,
          [&](const NaturalMode& mode) { return number_of(mode.methods[k].damping_ratio()); });
    }
  std::string out;
  append_csv(out, csv_columns(table), {}, true);
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
  if (!command.empty()) comments = {command, "by " + sweep_method_text(result.plan), status_counts(result)};
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
