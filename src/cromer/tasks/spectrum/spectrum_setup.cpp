#include "cromer/tasks/spectrum/spectrum_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "cromer/base/add_once.h"
#include "cromer/base/grid.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantity.h"
#include "cromer/tasks/option/choice.h"
#include "cromer/tasks/simulate/drive_record.h"

namespace cromer::core {
namespace {

constexpr double most_damping = 20;
constexpr double least_loss = 1e-3, most_loss = 2;
constexpr double least_ductility = 1.001, most_ductility = 100;
constexpr double most_acceleration = 1e100;  // [m/s^2] its square is summed up
constexpr double shortest_period = 1e-3;     // of a spacing: below, the mass follows the ground
constexpr double longest_period = 1e6;       // of the recording's duration: above, the ground moves past it

/// Whether a notice is about a column whose unit is not known.
bool says_no_unit(const Notice& notice) {
  if (notice.code == "unit_assumed" || notice.code == "column_without_unit" ||
      notice.code == "unit_of_something_else")
    return true;
  for (const NoticeValue& each : notice.values)
    if (const auto* parts = std::get_if<std::vector<Notice>>(&each.value))
      if (std::any_of(parts->begin(), parts->end(), says_no_unit)) return true;
  return false;
}

Error wrong_grid(std::string_view option, const Error& error) {
  return Error{"option_is_wrong", {{"option", option}, {"what", error.notice}}};
}

Result<double> factor_of(const SpectrumOptions& options, const DriveRecord& record, const std::string& file,
                         std::vector<Notice>& notices) {
  if (options.unit.empty()) {
    if (!record.unit_known)
      add_once(notices, Notice{"acceleration_unit_assumed", {{"file", file}, {"column", record.column}}});
    return 1.0;
  }
  if (record.unit_known) return Error{"unit_is_there", {{"file", file}, {"column", record.column}}};
  const auto target = parse_unit("m/s^2");
  const auto unit = parse_unit(options.unit, &target->dimension);
  if (!unit || unit->dimension != target->dimension)
    return Error{"no_unit_of_acceleration", {{"typed", options.unit}}};
  return unit->factor;
}

Result<Component> read_component(const Recording& recording, const std::string& column,
                                 const SpectrumOptions& options, std::vector<Notice>& notices) {
  const auto record = drive_record(recording,
                                   {.quantity = "acceleration",
                                    .column = column,
                                    .run = options.run.value_or(0),
                                    .column_option = "column",
                                    .use = "spectrum"},
                                   options.read);
  if (!record) return record.error();
  const auto factor = factor_of(options, *record, recording.file, notices);
  if (!factor) return factor.error();
  for (const Notice& notice : record->notices)
    if (!says_no_unit(notice)) add_once(notices, notice);  // factor_of has said what it is taken as
  Component component;
  component.file = recording.file;
  component.column = record->column;
  component.motion = record->motion;
  component.spacing = record->spacing;
  component.acceleration = record->values;
  for (std::size_t i = 0; i < component.acceleration.size(); ++i) {
    double& a = component.acceleration[i];
    a *= *factor;
    if (!(std::abs(a) <= most_acceleration))
      return Error{
          "nothing_shakes_so",
          {{"file", recording.file}, {"column", component.column}, {"acceleration", a}, {"sample", i + 1}}};
  }
  return component;
}

std::string component_name(const Component& component) {
  return component.column.empty() ? component.file
                                  : fmt::format("{} \"{}\"", component.file, component.column);
}

/// Two components of one motion must be sampled alike; the longer one is cut.
Result<void> match(std::vector<Component>& components, std::vector<Notice>& notices) {
  Component &first = components[0], &second = components[1];
  if (std::abs(first.spacing - second.spacing) > 1e-6 * first.spacing)
    return Error{"not_sampled_alike",
                 {{"first", first.file},
                  {"first_spacing", first.spacing},
                  {"second", second.file},
                  {"second_spacing", second.spacing}}};
  if (!first.motion.empty() && !second.motion.empty() && first.motion != second.motion)
    notices.push_back(Notice{"two_motions",
                             {{"first", first.file},
                              {"first_motion", first.motion},
                              {"second", second.file},
                              {"second_motion", second.motion}}});
  if (first.acceleration == second.acceleration)
    notices.push_back(Notice{"same_component_twice",
                             {{"first", component_name(first)}, {"second", component_name(second)}}});
  if (first.acceleration.size() == second.acceleration.size()) return {};
  Component& longer = first.acceleration.size() > second.acceleration.size() ? first : second;
  const Component& shorter = &longer == &first ? second : first;
  const std::size_t more = longer.acceleration.size() - shorter.acceleration.size();
  longer.acceleration.resize(shorter.acceleration.size());
  notices.push_back(
      Notice{"longer_component", {{"longer", longer.file}, {"shorter", shorter.file}, {"samples", more}}});
  return {};
}

/// A period or frequency as it was asked for: "0.1 s", "20 rad/s".
std::string typed(double value, bool by_frequency) {
  return fmt::format("{} {}", shortest(value), by_frequency ? "rad/s" : "s");
}

std::string fill_in_periods(SpectrumOptions& options, const Component& component) {
  if (!options.shock) return options.periods = "0.01:10:200:log";
  // From a tenth of a cycle within the shock to ten samples a cycle.
  options.frequencies =
      fmt::format("{:.3g}:{:.3g}:200:log Hz", 0.1 / component.duration(), 0.1 / component.spacing);
  return "";
}

}  // namespace

Result<Peaks> peaks_of(const SpectrumOptions& options) {
  constexpr std::array all{Peaks::continuous, Peaks::samples, Peaks::peer};
  const auto which = choice<3>("peaks", options.peaks, {name(all[0]), name(all[1]), name(all[2])});
  if (!which) return which.error();
  return all[*which];
}

Result<BetweenSamples> between_of(const SpectrumOptions& options) {
  constexpr std::array all{BetweenSamples::linear, BetweenSamples::hold, BetweenSamples::band_limited};
  const auto which =
      choice<3>("between-samples", options.between_samples, {name(all[0]), name(all[1]), name(all[2])});
  if (!which) return which.error();
  return all[*which];
}

namespace {

/// The values of grids, all of which must lie in these bounds.
Result<std::vector<double>> values_between(std::string_view option, const std::vector<std::string>& grids,
                                           double least, double most, double memory) {
  std::vector<double> all;
  for (const auto& text : grids) {
    const auto grid = parse_grid(text, "");
    if (!grid) return wrong_grid(option, grid.error());
    const auto values = values_of(*grid, 1e3, memory > 0 ? memory : 1e12);
    if (!values) return wrong_grid(option, values.error());
    for (const double value : *values)
      if (!(value >= least && value <= most))
        return Error{"damping_out_of_range",
                     {{"option", option},
                      {"least", shortest(least)},
                      {"most", shortest(most)},
                      {"value", shortest(value)}}};
    all.insert(all.end(), values->begin(), values->end());
  }
  return all;
}

}  // namespace

Result<std::vector<double>> damping_ratios_of(const SpectrumOptions& options) {
  const bool hysteretic = !options.loss_factor.empty();
  if (hysteretic && !options.damping_ratio.empty()) return Error{"damping_said_twice"};
  auto ratios =
      hysteretic ? values_between("loss-factor", options.loss_factor, least_loss, most_loss, options.memory)
                 : values_between("damping-ratio", options.damping_ratio, 0, most_damping, options.memory);
  if (ratios && ratios->empty()) ratios->push_back(0.05);
  return ratios;
}

Result<std::vector<double>> ductilities_of(const SpectrumOptions& options) {
  auto all = values_between("ductility", options.ductility, least_ductility, most_ductility, options.memory);
  if (all && all->empty()) all->push_back(1);
  return all;
}

Result<void> check_components(const SpectrumOptions& options, std::size_t files) {
  const std::size_t given = files * std::max<std::size_t>(1, options.column.size());
  if (given > 2) return Error{"too_many_components", {{"given", given}}};
  return {};
}

Result<std::optional<Grid>> grid_of(const SpectrumOptions& options) {
  if (!options.periods.empty() && !options.frequencies.empty()) return Error{"oscillators_said_twice"};
  const bool listed = !options.these_periods.empty(), by_frequency = options.by_frequency();
  if (!listed && !by_frequency && options.periods.empty()) return std::optional<Grid>{};
  const std::string_view option = by_frequency ? "frequencies" : "periods";
  const auto grid = listed         ? Result<Grid>(Grid(options.these_periods))
                    : by_frequency ? parse_grid(options.frequencies, "rad/s")
                                   : parse_grid(options.periods, "s");
  if (!grid) return wrong_grid(option, grid.error());
  if (!(grid->lowest() > 0))
    return Error{"oscillator_not_positive",
                 {{"option", option}, {"value", typed(grid->lowest(), by_frequency)}}};
  return std::optional(*grid);
}

Result<std::vector<Component>> read_components(std::span<const Recording> recordings,
                                               const SpectrumOptions& options, std::vector<Notice>& notices) {
  if (auto good = check_components(options, recordings.size()); !good) return good.error();
  const std::vector<std::string> columns =
      options.column.empty() ? std::vector<std::string>{""} : options.column;
  std::vector<Component> components;
  for (const auto& recording : recordings)
    for (const auto& column : columns) {
      auto component = read_component(recording, column, options, notices);
      if (!component) return component.error();
      components.push_back(*std::move(component));
    }
  if (components.size() == 2)
    if (auto good = match(components, notices); !good) return good.error();
  return components;
}

Result<std::vector<double>> periods_of(SpectrumOptions& options, const Component& component,
                                       std::size_t damping_ratios) {
  if (options.these_periods.empty() && options.periods.empty() && options.frequencies.empty())
    fill_in_periods(options, component);
  const auto grid = grid_of(options);
  if (!grid) return grid.error();
  const bool by_frequency = options.by_frequency();
  const std::string_view option = by_frequency ? "frequencies" : "periods";
  // For the results, and for what is written of them.
  const double bytes = 64 + 600 * static_cast<double>(damping_ratios);
  auto values = values_of(**grid, bytes, options.memory);
  if (!values) return wrong_grid(option, values.error());
  for (double& value : *values) {
    const std::string as_typed = typed(value, by_frequency);
    if (by_frequency) value = two_pi / value;
    if (value < shortest_period * component.spacing)
      return Error{"period_too_short",
                   {{"option", option}, {"value", as_typed}, {"spacing", component.spacing}}};
    if (value > longest_period * component.duration())
      return Error{"period_too_long",
                   {{"option", option}, {"value", as_typed}, {"duration", component.duration()}}};
  }
  return values;
}

std::vector<Notice> period_notices(const SpectrumOptions& options, std::span<const double> periods,
                                   const Component& component, Peaks peaks) {
  std::vector<Notice> notices;
  const std::string_view option = options.by_frequency() ? "frequencies" : "periods";
  const double spacing = component.spacing;
  const auto fast = std::count_if(periods.begin(), periods.end(), [&](double t) { return t < 2 * spacing; });
  if (fast > 0)
    notices.push_back(
        Notice{fast == 1 ? "one_period_too_fast" : "periods_too_fast",
               {{"option", option}, {"periods", fast}, {"fastest", 2 * spacing}, {"spacing", spacing}}});
  const double longest = *std::max_element(periods.begin(), periods.end());
  if (peaks != Peaks::continuous && longest > component.duration())
    notices.push_back(
        Notice{"recording_ends_early",
               {{"peaks", options.peaks}, {"duration", component.duration()}, {"longest", longest}}});
  return notices;
}

}  // namespace cromer::core
