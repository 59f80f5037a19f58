#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "cromer/base/quantity.h"
#include "cromer/identify/least_squares/uncertainty.h"
#include "cromer/methods/all.h"
#include "cromer/tasks/methods/law_before_method.h"
#include "cromer/tasks/methods/unused_by_method.h"
#include "cromer/tasks/modes/beside_network.h"
#include "cromer/tasks/modes/modes_options.h"

namespace cromer::core {
namespace {

/// Student's t that an estimate's interval was made with.
double student_of(const Estimate& estimate) {
  return estimate.standard_error > 0 ? (estimate.high - estimate.value) / estimate.standard_error : 0;
}

/// Takes the method's share out of a mode, and notes what the method made of it.
void take_out(NaturalMode& mode, const ModesOptions& options, std::vector<Notice>& notices) {
  const MethodSettings settings = method_settings_of(options);
  const double h = *options.step;
  const auto before =
      law_before_method(options.of_method, settings, h, mode.frequency.value, mode.damping_ratio.value);
  const auto effect =
      before ? method_effect(options.of_method, settings, before->law, h, false) : std::nullopt;
  if (!effect) {
    notices.push_back(
        Notice{"no_law_before_method",
               {{"method", options.of_method}, {"step", h}, {"frequency", mode.frequency.value}}});
    return;
  }
  const double f = mode.frequency.standard_error, z = mode.damping_ratio.standard_error;
  const auto& slopes = before->slopes;
  mode.frequency = make_estimate(before->frequency, std::hypot(slopes[0][0] * f, slopes[0][1] * z),
                                 student_of(mode.frequency));
  mode.damping_ratio = make_estimate(before->damping_ratio, std::hypot(slopes[1][0] * f, slopes[1][1] * z),
                                     student_of(mode.damping_ratio));
  mode.methods.push_back({options.of_method, h, *effect, effect_notice(*effect, before->law)});
}

/// Rows come a whole number of steps apart.
Result<void> check_step_of(const ModesOptions& options, const std::optional<ModalSource>& recording) {
  if (options.of_method.empty() || !recording) return {};
  const double spacing = 1 / recording->rate;
  const double steps = spacing / *options.step;
  constexpr double close = 1e-3;
  if (std::round(steps) >= 1 && std::abs(steps - std::round(steps)) <= close * steps) return {};
  return Error{"step_not_of_record", {{"step", *options.step}, {"spacing", rounded(spacing, 6)}}};
}

/// Where damping couples the modes, a composed explicit method makes something of them together, and so does
/// newmark, except as average acceleration.
bool couples_modes(const ModesOptions& options, const std::vector<NaturalMode>& modes) {
  const MethodInfo* info = options.of_method.empty() ? nullptr : find_method(options.of_method);
  if (!info || modes.size() < 2) return false;
  const MethodSettings settings = method_settings_of(options), average;
  const bool composed = info->symplectic && !info->implicit && !info->is_exact();
  const bool other_newmark =
      info->name == Newmark::info.name && (settings.beta != average.beta || settings.gamma != average.gamma);
  if (!composed && !other_newmark) return false;
  constexpr double seen = 0.02;  // of a shape's largest component, across its phase
  return std::any_of(modes.begin(), modes.end(), [](const NaturalMode& mode) {
    return std::any_of(mode.shape.begin(), mode.shape.end(),
                       [](const std::complex<double>& z) { return std::abs(z.imag()) > seen; });
  });
}

}  // namespace

Result<ModesResult> recording_modes(const Recording& recording, const ModesOptions& options) {
  if (!options.method.empty()) return Error{"method_of_networks", {{"file", recording.file}}};
  if (options.step && options.of_method.empty()) return Error{"step_needs_of_method"};
  if (!options.step && !options.of_method.empty()) return Error{"of_method_needs_step"};
  ModesOptions checked = options;
  if (!options.of_method.empty()) checked.method = {options.of_method};
  if (auto good = check_modes_options(checked, "of-method"); !good) return good.error();
  if (options.from_frequency && options.to_frequency && *options.from_frequency >= *options.to_frequency)
    return Error{"frequencies_reversed"};

  auto found = found_modes(recording, options);
  if (!found) return found;
  ModesResult result = *std::move(found);
  if (auto good = check_step_of(options, result.recording); !good) return good.error();
  if (couples_modes(options, result.modes))
    result.notices.push_back(Notice{"method_couples_modes", {{"method", options.of_method}}});
  if (!options.of_method.empty()) {
    say_unused_by_method(options.of_method, options, result.notices);
    for (NaturalMode& mode : result.modes) {
      const Notice grows{"mode_grows", {{"frequency", mode.frequency.value}}};
      take_out(mode, options, result.notices);
      // It was the method that fed it.
      if (mode.damping_ratio.value > 0) std::erase(result.notices, grows);
    }
  }
  if (options.network)
    if (auto good = set_beside(result, *options.network, seeks_all(options)); !good) return good.error();
  return result;
}

}  // namespace cromer::core
