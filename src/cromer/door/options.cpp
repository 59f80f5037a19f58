#include "cromer/door/options.h"

#include <cmath>
#include <iterator>
#include <numeric>

namespace cromer::core {
namespace {

struct Kind {
  Observed observed;
  std::string_view word, quantity, unit;
};

/// In the order of the enumerators.
constexpr Kind kinds[] = {{Observed::position, "position", "position", "m"},
                          {Observed::angle, "angle", "angle", "rad"},
                          {Observed::velocity, "velocity", "velocity", "m/s"},
                          {Observed::angular_velocity, "angular_velocity", "angular velocity", "rad/s"},
                          {Observed::acceleration, "acceleration", "acceleration", "m/s^2"}};

Column column_of(const std::string& name, std::string_view quantity, std::string_view unit,
                 std::span<const double> values) {
  return {.name = name,
          .quantity = std::string(quantity),
          .unit = std::string(unit),
          .values = {values.begin(), values.end()}};
}

Result<void> check_length(std::span<const double> values, const std::string& argument,
                          std::span<const double> others, const char* other) {
  if (values.size() == others.size()) return {};
  return Error{
      Notice{
          "lengths_differ",
          {{"argument", argument}, {"values", values.size()}, {"other", other}, {"others", others.size()}}},
      argument};
}

Component component_of(std::span<const double> acceleration, double spacing, const char* argument) {
  Component component;
  component.file = argument;
  component.acceleration.assign(acceleration.begin(), acceleration.end());
  component.spacing = spacing;
  return component;
}

/// NaN is a missing value, infinity a mistake.
Result<void> check_not_infinite(std::span<const double> values, const std::string& argument) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isinf(values[i]))
      return Error{Notice{"value_is_infinite", {{"argument", argument}, {"index", i}, {"value", values[i]}}},
                   argument};
  return {};
}

/// Checks that the spacing of samples [s] is positive and finite.
Result<void> check_spacing(double spacing) {
  if (spacing > 0 && std::isfinite(spacing)) return {};
  return Error{Notice{"spacing_not_positive", {{"spacing", spacing}}}, "spacing"};
}

}  // namespace

Result<void> check_times(std::span<const double> t) {
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (!std::isfinite(t[i])) return Error{Notice{"time_not_finite", {{"index", i}, {"value", t[i]}}}, "t"};
    if (i > 0 && !(t[i] > t[i - 1]))
      return Error{Notice{"times_do_not_increase", {{"index", i}, {"time", t[i]}, {"before", t[i - 1]}}},
                   "t"};
  }
  return {};
}

Result<void> check_samples(std::span<const double> values, const std::string& argument, std::size_t least) {
  if (values.size() < least)
    return Error{
        Notice{"too_few_values", {{"argument", argument}, {"least", least}, {"values", values.size()}}},
        argument};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      return Error{Notice{"value_not_finite", {{"argument", argument}, {"index", i}, {"value", values[i]}}},
                   argument};
  return {};
}

FitOptions fit_options(const cromer::FitOptions& options, const Selection& selection) {
  FitOptions o;
  o.column = selection.column;
  o.force_column = selection.force_column;
  o.run = selection.run;
  o.from = options.from;
  o.to = options.to;
  o.law = options.law.terms();
  o.no_spring = options.no_spring;
  o.hysteresis_exponent = options.hysteresis_exponent;
  if (options.mass) o.mass = {*options.mass};
  o.spring_mass = options.spring_mass;
  o.disc_diameter = options.disc_diameter;
  o.temperature = options.temperature;
  o.segment = options.segment;
  if (options.between_samples) o.between_samples = name(*options.between_samples);
  if (options.find_drive) o.drive_frequency = "auto";
  if (options.drive_frequency) o.drive_frequency = shortest(*options.drive_frequency) + " rad/s";
  o.hold_out = options.hold_out;
  return o;
}

Result<Recording> recording_of(std::span<const double> t, const std::vector<GivenColumn>& columns,
                               Observed observed, const char* columns_argument) {
  if (auto good = check_enumerator(observed, std::size(kinds), "observed"); !good) return good.error();
  if (auto good = check_times(t); !good) return good.error();
  if (columns.empty())
    return Error{Notice{"no_columns_given", {{"argument", columns_argument}}}, columns_argument};
  for (const GivenColumn& each : columns)
    if (auto good = check_length(each.values, each.argument, t, "t"); !good) return good.error();
  if (t.empty()) return Error{Notice{"no_times"}, "t"};
  for (const GivenColumn& each : columns)
    if (auto good = check_not_infinite(each.values, each.argument); !good) return good.error();
  Recording recording;
  recording.file = given_record;
  recording.named = true;
  const Kind& kind = kinds[static_cast<int>(observed)];
  recording.table.columns.push_back(column_of("t", "time", "s", t));
  for (const GivenColumn& each : columns)
    recording.table.columns.push_back(column_of(each.name, kind.quantity, kind.unit, each.values));
  recording.lines.resize(t.size());
  std::iota(recording.lines.begin(), recording.lines.end(), 0L);
  return recording;
}

Result<Recording> recording_of(std::span<const double> t, std::span<const double> y,
                               std::span<const double> force, Observed observed) {
  auto recording = recording_of(t, {{"y", "y", y}}, observed, "y");
  if (!recording || force.empty()) return recording;
  if (auto good = check_length(force, "force", t, "t"); !good) return good.error();
  if (auto good = check_not_infinite(force, "force"); !good) return good.error();
  recording->table.columns.push_back(column_of("force", "force", "N", force));
  return recording;
}

Result<Observed> observed_of(std::string_view word) {
  if (word.empty()) return Observed::position;
  std::vector<std::string> known;
  for (const Kind& kind : kinds) {
    if (word == kind.word) return kind.observed;
    known.emplace_back(kind.word);
  }
  return Error{Notice{"word_not_known", {{"argument", "observed"}, {"word", word}, {"known", known}}},
               "observed"};
}

Result<void> set_record(SimulateOptions& options, RecordOf what, std::span<const double> values,
                        double spacing) {
  const bool force = what == RecordOf::force;
  std::string& named = force ? options.drive_file : options.base_motion;
  named = force ? "force" : "acceleration";
  if (auto good = check_spacing(spacing); !good) return good;
  if (auto good = check_samples(values, named, 2); !good) return good;
  options.drive_record.emplace();
  options.drive_record->values.assign(values.begin(), values.end());
  options.drive_record->spacing = spacing;
  return {};
}

Result<std::vector<Component>> components_of(std::span<const double> acceleration,
                                             std::span<const double> second, double spacing) {
  if (auto good = check_spacing(spacing); !good) return good.error();
  if (auto good = check_samples(acceleration, "acceleration", 2); !good) return good.error();
  std::vector<Component> components{component_of(acceleration, spacing, "acceleration")};
  if (second.empty()) return components;
  if (auto good = check_length(second, "second", acceleration, "acceleration"); !good) return good.error();
  if (auto good = check_samples(second, "second", 0); !good) return good.error();
  components.push_back(component_of(second, spacing, "second"));
  return components;
}

}  // namespace cromer::core
