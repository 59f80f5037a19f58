#include "cromer/sweep.h"

#include <memory>
#include <utility>

#include "cromer/base/quantity.h"
#include "cromer/door/options.h"
#include "cromer/door/results.h"
#include "cromer/door/watching.h"
#include "cromer/door/words.h"
#include "cromer/model/terms/all.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer {
namespace {

/// The oscillator's coefficients as the grids of a sweep, one value each.
void set_law(core::SweepOptions& asked, const Oscillator& oscillator) {
  const auto set = [&](std::string_view option, double value, double otherwise) {
    if (value != otherwise) asked.values[option] = core::shortest(value);
  };
  const Oscillator none;  // what an option is that is not given
  set("mass", oscillator.mass, none.mass);
  set("static-friction", oscillator.static_friction, none.static_friction);
  core::for_each_term([&]<class T>() {
    for (std::size_t i = 0; i < core::coefficients_of<T>; ++i)
      set(T::coefficients[i].option, oscillator.*T::template members<double>[i],
          none.*T::template members<double>[i]);
  });
}

/// The column of that name, without its unit; empty where there is none.
std::vector<double> column_named(const core::SweepResult& result, std::string_view name) {
  const auto& columns = result.plan.rows.columns;
  for (std::size_t j = 0; j + 1 < columns.size(); ++j)
    if (std::string_view(columns[j]).starts_with(name)) return core::column_of(result, j);
  return {};
}

}  // namespace

Result<FrequencyResponse> sweep(const Oscillator& oscillator, std::span<const double> drive_frequency,
                                const SweepOptions& options) {
  constexpr const char* directions[] = {"", "up", "down", "both"};
  if (auto good = core::check_enumerator(options.direction, 4, "direction"); !good) return good.error();
  if (auto good = core::check_samples(drive_frequency, "drive_frequency", 1); !good) return good.error();
  for (std::size_t i = 0; i < drive_frequency.size(); ++i)
    if (!(drive_frequency[i] > 0))
      return Error{Notice{"value_not_positive",
                          {{"argument", "drive_frequency"}, {"index", i}, {"value", drive_frequency[i]}}},
                   "drive_frequency"};
  if (!(options.drive_amplitude > 0))
    return Error{Notice{"drive_amplitude_not_positive", {{"amplitude", options.drive_amplitude}}},
                 "drive_amplitude"};
  if (options.threads < 0) return Error{Notice{"too_few_threads"}, "threads"};
  core::SweepOptions asked;
  set_law(asked, oscillator);
  asked.values["drive-amplitude"] = core::shortest(options.drive_amplitude);
  asked.values["drive-frequency"] = core::list_of(drive_frequency);
  if (options.step) asked.values["step"] = core::shortest(*options.step);
  asked.simulate.method = {options.method.name()};
  asked.measure = {"amplitude", "phase"};
  asked.direction = directions[static_cast<int>(options.direction)];
  if (options.threads > 0) asked.threads = options.threads;
  asked.memory = core::memory_for_results;
  const core::Watching watching(options.progress);
  auto result = core::run_sweep(asked, watching.watch());
  if (!result) return core::in_arguments(result.error());
  const auto detail = std::make_shared<const core::SweepResult>(*std::move(result));
  FrequencyResponse response;
  response.frequency = column_named(*detail, "drive_frequency");
  response.amplitude = column_named(*detail, "amplitude");
  response.phase = column_named(*detail, "phase");
  if (response.frequency.empty())
    response.frequency.assign(response.amplitude.size(), drive_frequency.front());
  for (const unsigned char each : detail->statuses)
    response.status.emplace_back(core::status_word(detail->plan, each));
  response.way = text(detail->plan.way);
  response.interrupted = detail->interrupted;
  response.notices = core::notices_of(*detail);
  response.detail = detail;
  return response;
}

}  // namespace cromer
