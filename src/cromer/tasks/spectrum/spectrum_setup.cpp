#include "cromer/tasks/spectrum/spectrum_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "cromer/base/grid.h"
#include "cromer/base/nearest.h"
#include "cromer/base/quantity.h"
#include "cromer/tasks/simulate/drive_record.h"

namespace cromer::core {
namespace {

constexpr double most_damping = 20;
constexpr double least_loss = 1e-3, most_loss = 2;
constexpr double most_acceleration = 1e100;  // [m/s^2] its square is summed up
constexpr double shortest_period = 1e-3;     // of a spacing: below, the mass follows the ground
constexpr double longest_period = 1e6;       // of the recording's duration: above, the ground moves past it

template <std::size_t n>
Result<std::size_t> choice(std::string_view option, const std::string& typed,
                           const std::array<std::string_view, n>& words) {
  if (typed.empty()) return std::size_t{0};
  const auto found = std::find(words.begin(), words.end(), typed);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  const std::string near = nearest(typed, {words.begin(), words.end()});
  std::string list;
  for (std::size_t i = 0; i < n; ++i)
    list += (i == 0 ? "" : i + 1 == n ? " or " : ", ") + std::string(words[i]);
  return Error{fmt::format("{}: \"{}\" is not known; it takes {}{}", option, typed, list,
                           near.empty() ? "" : fmt::format(" (did you mean {}?)", near))};
}

void add_once(std::vector<std::string>& warnings, const std::string& warning) {
  if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) warnings.push_back(warning);
}

Result<double> factor_of(const SpectrumOptions& options, const DriveRecord& record, const std::string& file,
                         std::vector<std::string>& warnings) {
  if (options.unit.empty()) {
    if (!record.unit_known)
      add_once(warnings,
               fmt::format("{}: column \"{}\" has no unit and is taken as m/s^2; --unit says another", file,
                           record.column));
    return 1.0;
  }
  if (record.unit_known)
    return Error{
        fmt::format("--unit: {}: column \"{}\" has its unit already; leave --unit out", file, record.column)};
  const auto target = parse_unit("m/s^2");
  const auto unit = parse_unit(options.unit, &target->dimension);
  if (!unit || unit->dimension != target->dimension)
    return Error{fmt::format("--unit: \"{}\" is no unit of acceleration; for instance g, m/s^2 or cm/s^2",
                             options.unit)};
  return unit->factor;
}

Result<Component> read_component(const SpectrumFile& file, const std::string& column,
                                 const SpectrumOptions& options, std::vector<std::string>& warnings) {
  const auto record = read_drive_record(file.bytes, file.name,
                                        {.quantity = "acceleration",
                                         .column = column,
                                         .run = options.run.value_or(0),
                                         .column_option = "--column",
                                         .use = "spectrum"},
                                        options.read);
  if (!record) return record.error();
  const auto factor = factor_of(options, *record, file.name, warnings);
  if (!factor) return factor.error();
  for (const std::string& warning : record->warnings)
    if (warning.find("has no unit") == std::string::npos)  // what it is taken as is said already
      add_once(warnings, warning);
  Component component;
  component.file = file.name;
  component.column = record->column;
  component.motion = record->motion;
  component.spacing = record->spacing;
  component.acceleration = record->values;
  for (std::size_t i = 0; i < component.acceleration.size(); ++i) {
    double& a = component.acceleration[i];
    a *= *factor;
    if (!(std::abs(a) <= most_acceleration))
      return Error{fmt::format(
          "{}: column \"{}\" has {:.4g} m/s^2 at sample {}: nothing shakes like that; mend the recording",
          file.name, component.column, a, i + 1)};
  }
  return component;
}

std::string name_of(const Component& component) {
  return component.column.empty() ? component.file
                                  : fmt::format("{} \"{}\"", component.file, component.column);
}

/// Two components are one motion: sampled alike, cut to the shorter.
Result<void> match(std::vector<Component>& components, std::vector<std::string>& warnings) {
  Component &first = components[0], &second = components[1];
  if (std::abs(first.spacing - second.spacing) > 1e-6 * first.spacing)
    return Error{fmt::format(
        "{} has a sample each {:.6g} s and {} one each {:.6g} s; the components of one motion must be "
        "sampled alike: resample one of them",
        first.file, first.spacing, second.file, second.spacing)};
  if (!first.motion.empty() && !second.motion.empty() && first.motion != second.motion)
    warnings.push_back(
        fmt::format("{} is of \"{}\" and {} of \"{}\": components of two motions, whose RotD50 means nothing",
                    first.file, first.motion, second.file, second.motion));
  if (first.acceleration == second.acceleration)
    warnings.push_back(
        fmt::format("{} and {} hold the same samples: one component given twice, so RotD50 is its own "
                    "spectrum and RotD100 "
                    "sqrt(2) times that",
                    name_of(first), name_of(second)));
  if (first.acceleration.size() == second.acceleration.size()) return {};
  Component& longer = first.acceleration.size() > second.acceleration.size() ? first : second;
  const Component& shorter = &longer == &first ? second : first;
  const std::size_t more = longer.acceleration.size() - shorter.acceleration.size();
  longer.acceleration.resize(shorter.acceleration.size());
  warnings.push_back(
      fmt::format("{} is longer than {}: its last {} samples are left out", longer.file, shorter.file, more));
  return {};
}

std::string default_periods(SpectrumOptions& options, const Component& component) {
  if (!options.shock) return options.periods = "0.01:10:200:log";
  // From a tenth of a cycle within the shock to ten samples a cycle.
  options.frequencies =
      fmt::format("{:.3g}:{:.3g}:200:log Hz", 0.1 / component.duration(), 0.1 / component.spacing);
  return "";
}

}  // namespace

Result<Peaks> peaks_of(const SpectrumOptions& options) {
  constexpr std::array all{Peaks::continuous, Peaks::samples, Peaks::peer};
  const auto which = choice<3>("--peaks", options.peaks, {name(all[0]), name(all[1]), name(all[2])});
  if (!which) return which.error();
  return all[*which];
}

Result<BetweenSamples> between_of(const SpectrumOptions& options) {
  constexpr std::array all{BetweenSamples::linear, BetweenSamples::hold, BetweenSamples::band_limited};
  const auto which =
      choice<3>("--between-samples", options.between_samples, {name(all[0]), name(all[1]), name(all[2])});
  if (!which) return which.error();
  return all[*which];
}

Result<std::vector<double>> damping_ratios_of(const SpectrumOptions& options) {
  const bool hysteretic = !options.loss_factor.empty();
  if (hysteretic && !options.damping_ratio.empty())
    return Error{
        "--damping-ratio and --loss-factor both say how the springs are damped; leave one of them out"};
  const std::string option = hysteretic ? "--loss-factor" : "--damping-ratio";
  const double least = hysteretic ? least_loss : 0, most = hysteretic ? most_loss : most_damping;
  std::vector<double> ratios;
  for (const auto& text : hysteretic ? options.loss_factor : options.damping_ratio) {
    const auto grid = parse_grid(text, "");
    if (!grid) return Error{option + ": " + grid.error().message};
    const auto values = values_of(*grid, 1e3, options.memory > 0 ? options.memory : 1e12);
    if (!values) return Error{option + ": " + values.error().message};
    for (const double ratio : *values)
      if (!(ratio >= least && ratio <= most))
        return Error{
            fmt::format("{}: it must lie between {} and {}, not {}", option, least, most, shortest(ratio))};
    ratios.insert(ratios.end(), values->begin(), values->end());
  }
  if (ratios.empty()) ratios = {0.05};
  return ratios;
}

Result<std::vector<Component>> read_components(std::span<const SpectrumFile> files,
                                               const SpectrumOptions& options,
                                               std::vector<std::string>& warnings) {
  const std::vector<std::string> columns =
      options.column.empty() ? std::vector<std::string>{""} : options.column;
  if (files.size() * columns.size() > 2)
    return Error{
        fmt::format("spectrum takes one recording, or the two components of one motion; {} are given",
                    files.size() * columns.size())};
  std::vector<Component> components;
  for (const auto& file : files)
    for (const auto& column : columns) {
      auto component = read_component(file, column, options, warnings);
      if (!component) return component.error();
      components.push_back(*std::move(component));
    }
  if (components.size() == 2)
    if (auto good = match(components, warnings); !good) return good.error();
  return components;
}

Result<std::vector<double>> periods_of(SpectrumOptions& options, const Component& component,
                                       std::size_t damping_ratios) {
  if (!options.periods.empty() && !options.frequencies.empty())
    return Error{"--periods and --frequencies both say which oscillators there are; leave one of them out"};
  const bool listed = !options.these_periods.empty();
  if (!listed && options.periods.empty() && options.frequencies.empty()) default_periods(options, component);
  const bool by_period = listed || !options.periods.empty();
  const std::string option = by_period ? "--periods" : "--frequencies";
  const auto grid = listed      ? Result<Grid>(Grid(options.these_periods))
                    : by_period ? parse_grid(options.periods, "s")
                                : parse_grid(options.frequencies, "rad/s");
  if (!grid) return Error{option + ": " + grid.error().message};
  // Results, and what is written of them.
  const double bytes = 64 + 600 * static_cast<double>(damping_ratios);
  auto values = values_of(*grid, bytes, options.memory);
  if (!values) return Error{option + ": " + values.error().message};
  for (double& value : *values) {
    const std::string typed = fmt::format("{} {}", shortest(value), by_period ? "s" : "rad/s");
    if (!(value > 0)) return Error{fmt::format("{}: it must be positive, not {}", option, typed)};
    if (!by_period) value = 2 * std::numbers::pi / value;
    if (value < shortest_period * component.spacing)
      return Error{fmt::format(
          "{}: {} is a period below a thousandth of the sampling step ({:.6g} s): such an oscillator moves "
          "with the ground, its PSA is the ground's own peak; ask for longer ones",
          option, typed, component.spacing)};
    if (value > longest_period * component.duration())
      return Error{fmt::format(
          "{}: {} is a period of more than a million times the recording ({:.6g} s); ask for shorter ones",
          option, typed, component.duration())};
  }
  return values;
}

std::vector<std::string> period_warnings(const SpectrumOptions& options, std::span<const double> periods,
                                         const Component& component, Peaks peaks) {
  std::vector<std::string> warnings;
  const std::string option = options.by_frequency() ? "--frequencies" : "--periods";
  const double spacing = component.spacing;
  const auto fast = std::count_if(periods.begin(), periods.end(), [&](double t) { return t < 2 * spacing; });
  if (fast > 0)
    warnings.push_back(fmt::format(
        "{}: {} below {:.6g} s, twice the sampling step of {:.6g} s: the recording holds nothing that fast, "
        "and "
        "what is shown there comes from how its samples were joined",
        option, fast == 1 ? "one period is" : fmt::format("{} periods are", fast), 2 * spacing, spacing));
  const double longest = *std::max_element(periods.begin(), periods.end());
  if (peaks != Peaks::continuous && longest > component.duration())
    warnings.push_back(fmt::format(
        "--peaks {}: the recording ({:.6g} s) is shorter than the longest period ({:.6g} s), whose peak may "
        "come after its end; continuous counts that too",
        options.peaks, component.duration(), longest));
  return warnings;
}

}  // namespace cromer::core
