#include "cromer/door/options.h"

#include <fmt/format.h>

#include <cmath>

namespace cromer::core {
namespace {

struct Kind {
  const char *quantity, *unit;
};

Kind kind_of(Observed observed) {
  switch (observed) {
    case Observed::position:
      return {"position", "m"};
    case Observed::angle:
      return {"angle", "rad"};
    case Observed::velocity:
      return {"velocity", "m/s"};
    case Observed::angular_velocity:
      return {"angular velocity", "rad/s"};
    case Observed::acceleration:
      return {"acceleration", "m/s^2"};
  }
  return {"", ""};
}

Column column_of(const char* name, const Kind& kind, std::span<const double> values) {
  return {
      .name = name, .quantity = kind.quantity, .unit = kind.unit, .values = {values.begin(), values.end()}};
}

Result<void> check_times(std::span<const double> t) {
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (!std::isfinite(t[i])) return Error{fmt::format("t[{}] is {}: times must be finite", i, t[i]), "t"};
    if (i > 0 && !(t[i] > t[i - 1]))
      return Error{fmt::format("t must increase strictly: t[{}] = {} s follows {} s", i, t[i], t[i - 1]),
                   "t"};
  }
  return {};
}

Result<void> check_length(std::span<const double> values, const char* argument, std::size_t samples) {
  if (values.size() == samples) return {};
  return Error{
      fmt::format("{} has {} values and t has {}: they must be as many", argument, values.size(), samples),
      argument};
}

/// NaN is a missing value, infinity a mistake.
Result<void> check_not_infinite(std::span<const double> values, const char* argument) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isinf(values[i]))
      return Error{fmt::format("{}[{}] is {}: a missing value is NaN", argument, i, values[i]), argument};
  return {};
}

}  // namespace

Result<void> check_samples(std::span<const double> values, const std::string& argument, std::size_t least) {
  if (values.size() < least)
    return Error{fmt::format("{} needs at least {} values, not {}", argument, least, values.size()),
                 argument};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      return Error{fmt::format("{}[{}] is {}: all values must be finite", argument, i, values[i]), argument};
  return {};
}

Result<void> check_spacing(double spacing) {
  if (spacing > 0 && std::isfinite(spacing)) return {};
  return Error{fmt::format("spacing {}: it must be positive, in seconds", spacing), "spacing"};
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
  o.mass = options.mass;
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

Result<Recording> recording_of(std::span<const double> t, std::span<const double> y,
                               std::span<const double> force, Observed observed) {
  if (auto good = check_enumerator(observed, 5, "observed"); !good) return good.error();
  if (auto good = check_times(t); !good) return good.error();
  if (auto good = check_length(y, "y", t.size()); !good) return good.error();
  if (!force.empty())
    if (auto good = check_length(force, "force", t.size()); !good) return good.error();
  if (t.empty()) return Error{"t has no values: a record has samples", "t"};
  if (auto good = check_not_infinite(y, "y"); !good) return good.error();
  if (auto good = check_not_infinite(force, "force"); !good) return good.error();
  Recording recording;
  recording.file = "the record";
  recording.named = true;
  auto& columns = recording.table.columns;
  columns = {column_of("t", {"time", "s"}, t), column_of("y", kind_of(observed), y)};
  if (!force.empty()) columns.push_back(column_of("force", {"force", "N"}, force));
  for (std::size_t i = 0; i < t.size(); ++i) recording.lines.push_back(static_cast<long>(i));
  return recording;
}

}  // namespace cromer::core
