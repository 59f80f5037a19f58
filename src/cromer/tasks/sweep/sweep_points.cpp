#include "cromer/tasks/sweep/sweep_rows.h"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <variant>

#include "cromer/tasks/simulate/drive_setup.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

/// The point of options with one value each, without its settings.
Result<SweepPoint> sweep_point_of(const SimulateOptions& options) {
  const auto oscillator = oscillator_of(options);
  if (!oscillator) return oscillator.error();
  const double frequency = options.drive_frequency.empty() ? 0 : options.drive_frequency.front();
  SweepPoint result;
  result.point.oscillator = *oscillator;
  result.point.drive = harmonic_drive(options, frequency, oscillator->mass).value_or(HarmonicDrive<double>{});
  result.point.start = start_of(options);
  const double natural = natural_period(*oscillator), period = drive_period(result.point.drive);
  result.point.step = options.step.value_or(default_step(natural, period));
  result.loss_factor = options.loss_factor;
  result.until = options.until.value_or(default_end(natural, period));
  if (!(result.point.step > 0) || !(result.until > 0)) return no_period(*oscillator, options);
  return result;
}

}  // namespace

bool is_method_setting(std::string_view option) {
  return option == "tolerance" || option == "beta" || option == "gamma" || option == "rho-inf";
}

void set_number(const Option::Target& target, double value) {
  std::visit(
      [&](auto* to) {
        using T = std::remove_pointer_t<decltype(to)>;
        if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>>)
          *to = value;
        else if constexpr (std::is_same_v<T, std::vector<double>>)
          to->assign(1, value);
      },
      target);
}

SweepPoints::SweepPoints(const SimulateOptions& base, const std::vector<SweepAxis>& axes)
    : axes_(axes), options_(base) {
  const std::vector<Option> table = point_options(options_);
  for (const SweepAxis& axis : axes_) {
    const auto option =
        std::find_if(table.begin(), table.end(), [&](const Option& each) { return each.name == axis.name; });
    targets_.push_back(option == table.end() ? std::nullopt : std::optional(option->target));
  }
  settings_ = cromer::core::settings_of(options_, options_.method.front());
  settings_vary_ = std::any_of(axes_.begin(), axes_.end(),
                               [](const SweepAxis& axis) { return is_method_setting(axis.name); });
}

void SweepPoints::values_of(std::uint64_t row, double* values) const {
  for (std::size_t i = axes_.size(); i-- > 0;) {
    const std::uint64_t points = axes_[i].grid.size();
    values[i] = axes_[i].grid[row % points];
    row /= points;
  }
}

Result<SweepPoint> SweepPoints::at(const double* values) {
  set_options(values);
  auto point = sweep_point_of(options_);
  if (point)
    point->settings =
        settings_vary_ ? cromer::core::settings_of(options_, options_.method.front()) : settings_;
  return point;
}

MethodSettings SweepPoints::settings_of(std::uint64_t row) {
  if (!settings_vary_) return settings_;
  std::vector<double> values(axes_.size());
  values_of(row, values.data());
  set_options(values.data());
  return cromer::core::settings_of(options_, options_.method.front());
}

void SweepPoints::set_options(const double* values) {
  for (std::size_t i = 0; i < targets_.size(); ++i)
    if (targets_[i]) set_number(*targets_[i], values[i]);
}

}  // namespace cromer::core
