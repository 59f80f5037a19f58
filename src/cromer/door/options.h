// What callers hand in, checked and made into what the tasks take.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/fit.h"
#include "cromer/result.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"

namespace cromer::core {

inline constexpr double memory_for_results = 16e9;  // [bytes] beyond which a result is refused
/// [bytes] The same of the states of a run alone: energies and copies stand beside them.
inline constexpr double memory_for_states = memory_for_results / 3;

/// Checks that there are at least `least` samples, all finite. The Error names the argument.
Result<void> check_samples(std::span<const double> values, const std::string& argument, std::size_t least);

/// Checks that an enumerator is one of the first `count`: other languages pass numbers.
template <class Enum>
Result<void> check_enumerator(Enum value, int count, const char* argument) {
  if (static_cast<int>(value) >= 0 && static_cast<int>(value) < count) return {};
  return Error{Notice{"no_enumerator", {{"argument", argument}, {"number", static_cast<int>(value)}}},
               argument};
}

/// Checks that times [s] are finite and increase strictly.
Result<void> check_times(std::span<const double> t);

FitOptions fit_options(const cromer::FitOptions& options, const Selection& selection);

/// "position", "angular_velocity", ...: as C writes it; "" is a position.
Result<Observed> observed_of(std::string_view word);

inline constexpr const char* given_record = "the record";  ///< what messages call one that is made of arrays

/// A column of a recording that is made of arrays.
struct GivenColumn {
  std::string name{};
  std::string argument{};  ///< what an Error calls it
  std::span<const double> values{};
};

/// Arrays of one kind as a recording of t and these columns. The Error names the argument: `columns_argument`
/// if there are none.
Result<Recording> recording_of(std::span<const double> t, const std::vector<GivenColumn>& columns,
                               Observed observed, const char* columns_argument);

/// Arrays as a recording of columns t, y and, where there is one, force. The Error names the argument.
Result<Recording> recording_of(std::span<const double> t, std::span<const double> y,
                               std::span<const double> force, Observed observed);

/// How a run of an oscillator or of a network is integrated, and which states are kept.
template <class RunOptions>
void set_integration(SimulateOptions& task, const RunOptions& options) {
  task.method = {options.method.name()};
  task.step = options.step;
  task.until = options.until;
  task.tolerance = options.tolerance;
  task.beta = options.beta;
  task.gamma = options.gamma;
  task.rho_inf = options.rho_inf;
  task.every = options.every;
  task.memory = memory_for_states;
}

/// A recorded force, or the acceleration of the ground, as the drive of a run.
enum class RecordOf { force, ground };
Result<void> set_record(SimulateOptions& options, RecordOf what, std::span<const double> values,
                        double spacing);

/// The ground's acceleration and, unless it is empty, its second component, sampled alike.
Result<std::vector<Component>> components_of(std::span<const double> acceleration,
                                             std::span<const double> second, double spacing);

}  // namespace cromer::core
