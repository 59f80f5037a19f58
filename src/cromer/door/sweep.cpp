#include "cromer/sweep.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>

#include "cromer/door/options.h"
#include "cromer/door/watching.h"
#include "cromer/door/words.h"
#include "cromer/model/terms/all.h"
#include "cromer/study/task/sweep.h"

namespace cromer {
namespace {

/// The oscillator's coefficients as the grids of a sweep, one value each.
void set_law(core::SweepOptions& asked, const Oscillator& oscillator) {
  const auto set = [&](std::string_view option, double value, double otherwise) {
    if (value != otherwise) asked.values[option] = core::shortest(value);
  };
  set("mass", oscillator.mass, 1);
  set("static-friction", oscillator.static_friction, 0);
  core::for_each_term([&]<class T>() {
    for (std::size_t i = 0; i < core::coefficients_of<T>; ++i)
      set(
          T::coefficients[i].option, oscillator.*T::template members<double>[i],
          Oscillator {}.*T::template members<double>[i]);
  });
}

std::string list_of(std::span<const double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ",") + core::shortest(value);
  return text;
}

std::vector<double> column_of(const core::SweepResult& result, std::string_view name) {
  const auto& columns = result.plan.rows.columns;
  const std::size_t width = columns.size() - 1;
  std::vector<double> values;
  for (std::size_t j = 0; j < width; ++j)
    if (std::string_view(columns[j]).starts_with(name))
      for (std::size_t row = 0; row < result.rows.size() / width; ++row)
        values.push_back(result.rows[row * width + j]);
  return values;
}

/// A point of more steps than memory can count is bad input, not the end of the program.
Result<core::SweepResult> swept(const core::SweepOptions& asked, const core::Watch& watch) {
  const auto too_many = [] {
    return Error{
        "a period of the drive takes more steps than can be held: take a longer step, or a higher frequency",
        "drive_frequency"};
  };
  try {
    return core::sweep(asked, watch);
  } catch (const std::length_error&) {
    return too_many();
  } catch (const std::bad_alloc&) {
    return too_many();
  }
}

}  // namespace

Result<FrequencyResponse> sweep(const Oscillator& oscillator, std::span<const double> drive_frequency,
                                const SweepOptions& options) {
  constexpr const char* directions[] = {"", "up", "down", "both"};
  if (auto good = core::check_enumerator(options.direction, 4, "direction"); !good) return good.error();
  if (auto good = core::check_samples(drive_frequency, "drive_frequency", 1); !good) return good.error();
  if (!(options.drive_amplitude > 0))
    return Error{"drive_amplitude must be positive, not " + core::shortest(options.drive_amplitude),
                 "drive_amplitude"};
  if (options.threads < 0) return Error{"threads must be 0 (one for each processor) or more", "threads"};
  core::SweepOptions asked;
  set_law(asked, oscillator);
  asked.values["drive-amplitude"] = core::shortest(options.drive_amplitude);
  asked.values["drive-frequency"] = list_of(drive_frequency);
  if (options.step) asked.values["step"] = core::shortest(*options.step);
  asked.simulate.method = {options.method.name()};
  asked.measure = {"amplitude", "phase"};
  asked.direction = directions[static_cast<int>(options.direction)];
  if (options.threads > 0) asked.threads = options.threads;
  asked.memory = core::memory_for_results;
  const core::Watching watching(options.progress);
  auto result = swept(asked, watching.watch());
  if (!result) return core::in_arguments(result.error());
  const auto detail = std::make_shared<const core::SweepResult>(*std::move(result));
  FrequencyResponse response;
  response.frequency = column_of(*detail, "drive_frequency");
  response.amplitude = column_of(*detail, "amplitude");
  response.phase = column_of(*detail, "phase");
  if (response.frequency.empty())
    response.frequency.assign(response.amplitude.size(), drive_frequency.front());
  for (const unsigned char each : detail->statuses)
    response.status.emplace_back(core::status_word(detail->plan, each));
  response.way = detail->plan.way;
  response.interrupted = detail->interrupted;
  response.warnings = core::in_arguments(core::warnings_of(*detail));
  response.detail = detail;
  return response;
}

}  // namespace cromer
