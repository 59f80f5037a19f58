#include "cromer/door/results.h"

#include <new>
#include <stdexcept>
#include <utility>
#include <variant>

#include "cromer/base/quantity.h"
#include "cromer/door/network_of.h"
#include "cromer/door/options.h"
#include "cromer/door/words.h"
#include "cromer/identify/law_fit.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {

void put_in_arguments(FittedRecording& fitted, bool of_arrays) {
  fitted.of_arrays = of_arrays;
  fitted.fit.message = in_arguments(std::move(fitted.fit.message), of_arrays);
  fitted.notices = in_arguments(std::move(fitted.notices), of_arrays);
}

void put_in_arguments(CompareResult& compared, bool of_arrays) {
  put_in_arguments(compared.recording, of_arrays);
  compared.notices = in_arguments(std::move(compared.notices), of_arrays);
}

void put_in_arguments(SimulateResult& simulated, bool of_arrays) {
  simulated.notices = in_arguments(std::move(simulated.notices), of_arrays);
  for (SimulatedRun& run : simulated.runs) run.message = in_arguments(std::move(run.message), of_arrays);
}

void put_in_arguments(NetworkRun& run) {
  run.notices = in_arguments(std::move(run.notices));
  run.message = in_arguments(std::move(run.message));
}

void put_in_arguments(FittedNetwork& fitted, bool of_arrays) {
  fitted.notices = in_arguments(std::move(fitted.notices), of_arrays);
  fitted.message = in_arguments(std::move(fitted.message), of_arrays);
}

void put_in_arguments(ModesResult& modes, bool of_arrays) {
  modes.notices = in_arguments(std::move(modes.notices), of_arrays);
  modes.message = in_arguments(std::move(modes.message), of_arrays);
}

Error of_network(const Error& error, bool of_arrays) {
  Error said = in_arguments(error, of_arrays);
  if (!said.argument.empty()) return said;
  for (const NoticeValue& each : said.notice.values)
    if (const auto* file = std::get_if<std::string>(&each.value); file && each.name == "file")
      said.argument = of_arrays && *file == given_record ? "channels" : given_network;
  return said;
}

Error no_values(const FittedRecording& fitted) {
  return {Notice{"fit_without_values", {{"what", fitted.fit.message}}}, "fit"};
}

Result<Trajectory> motion_at(const FittedRecording& fitted, std::span<const double> t) {
  if (!fitted.fit.is_usable()) return no_values(fitted);
  if (is_recorded(fitted.fit.drive.kind)) return Error{Notice{"motion_known_at_samples"}, "t"};
  if (auto good = check_times(t); !good) return good.error();
  if (t.empty()) return Trajectory{};
  const double first = fitted.series.t.front();
  if (t.front() < first)
    return Error{Notice{"times_before_the_first", {{"begin", t.front()}, {"first", first}}}, "t"};
  if ((t.back() - first) / fitted.fit.step > most_steps_of_a_run)
    return Error{Notice{"times_too_late", {{"end", t.back()}}}, "t"};
  // The law's motion is known from the first sample on.
  std::vector<double> from_first(t.begin(), t.end());
  const bool begins_later = t.front() > first;
  if (begins_later) from_first.insert(from_first.begin(), first);
  Trajectory motion = motion_of(fitted.fit, from_first);
  if (begins_later)
    for (auto* values : {&motion.t, &motion.x, &motion.v}) values->erase(values->begin());
  return motion;
}

cromer::MethodEffect effect_of(const MethodEffect& effect) {
  std::optional<double> decay_rate = effect.effective.decay_rate;
  if (decay_rate) *decay_rate += 0.0;  // no -0
  return {.decay_rate = decay_rate,
          .angular_frequency = effect.effective.angular_frequency,
          .spectral_radius = effect.effective.spectral_radius,
          .stable = effect.stable,
          .stability_limit = effect.stability_limit};
}

Result<SweepResult> run_sweep(const SweepOptions& options, const Watch& watch) {
  const auto too_many = [] { return Error{Notice{"period_of_too_many_steps"}, "drive_frequency"}; };
  try {
    return sweep(options, watch);
  } catch (const std::length_error&) {
    return too_many();
  } catch (const std::bad_alloc&) {
    return too_many();
  }
}

std::vector<double> column_of(const SweepResult& result, std::size_t column) {
  const std::size_t width = result.plan.rows.columns.size() - 1;  // the last one is the status
  std::vector<double> values;
  for (std::size_t at = column; at < result.rows.size(); at += width) values.push_back(result.rows[at]);
  return values;
}

std::string list_of(std::span<const double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ",") + shortest(value);
  return text;
}

}  // namespace cromer::core
