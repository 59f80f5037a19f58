#include "answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "cromer/base/grid.h"
#include "cromer/base/number.h"
#include "cromer/documents/json/documents.h"
#include "cromer/documents/json/effect.h"
#include "cromer/documents/json/json.h"
#include "cromer/documents/json/notices.h"
#include "cromer/documents/json/recording.h"
#include "cromer/tasks/fit/fitted_motion.h"
#include "cromer/tasks/fit/motion_units.h"
#include "cromer/tasks/fit/used_samples.h"
#include "motions.h"
#include "request.h"
#include "resonance_curves.h"

namespace cromer::core::page {
namespace {

Answer bad_input(const Error& error) {
  return {Status::bad_input, to_text(Json{{"message", said(error.notice, {})}}), {}};
}

Answer found(const std::string& document, bool ok) {
  return {ok ? Status::done : Status::no_success, document, std::exchange(json_blocks(), {})};
}

/// Options of simulate that the page can run.
Result<SimulateOptions> simulate_options(const Request& request) {
  SimulateOptions options;
  if (auto good = assign(request, options_of(options)); !good) return good.error();
  if (!options.drive.empty() && options.drive != "harmonic" && options.drive != "unbalance" &&
      options.drive != "base")
    return Error{"page_drives_by_sine", {{"drive", options.drive}}};
  if (!options.drive_file.empty() || !options.base_motion.empty()) return Error{"page_has_no_recorded_drive"};
  if (!options.event.empty()) return Error{"program_only", {{"option", "event"}}};
  options.memory = 512e6;  // of the 2 GB that a module may have
  if (options.compensated) return Error{"program_only", {{"option", "compensated"}}};
  return options;
}

Answer simulate_task(const Request& request, std::string_view) {
  const auto options = simulate_options(request);
  if (!options) return bad_input(options.error());
  const auto result = simulate(*options);
  return result ? found(to_json(*result, true), result->ok()) : bad_input(result.error());
}

/// What the page draws of a simulation, without what only a document tells.
Answer motion_task(const Request& request, std::string_view) {
  auto options = simulate_options(request);
  if (!options) return bad_input(options.error());
  options->motion_only = true;
  const auto result = simulate(*options);
  return result ? found(to_text(motions_of(*result)), result->ok()) : bad_input(result.error());
}

Answer methods_task(const Request& request, std::string_view) {
  MethodsOptions options;
  if (auto good = assign(request, options_of(options)); !good) return bad_input(good.error());
  const auto rows = list_methods(options);
  return rows ? found(to_json(*rows), true) : bad_input(rows.error());
}

Answer resonance_task(const Request& asked, std::string_view) {
  Request request = asked;
  const auto grid = parse_grid(take(request, "frequencies", "0.1:10:200"), "rad/s");
  if (!grid) return bad_input(grid.error());
  const auto options = simulate_options(request);
  if (!options) return bad_input(options.error());
  const auto curves = resonance_curves(*options, *grid);
  if (!curves) return bad_input(curves.error());
  Json document;
  Json& list = document["curves"] = Json::array();
  for (const MethodResonance& curve : *curves)
    list.push_back({{"method", curve.method},
                    {"settled", curve.settled},
                    {"too_many_steps", curve.too_many_steps},
                    {"frequency", curve.frequency},
                    {"amplitude", curve.amplitude},
                    {"phase", curve.phase}});
  return found(to_text(document), true);
}

Answer inspect_task(const Request& asked, std::string_view file) {
  Request request = asked;
  const std::string column = take(request, "column");
  ReadOptions options;
  if (auto good = assign(request, options_of(options)); !good) return bad_input(good.error());
  const auto seen = inspect(file, request.file_name, options, column);
  if (!seen) return bad_input(seen.error());
  Json document = inspection_object(*seen, false, {});
  Json& list = document["series"] = Json::array();
  for (const Series& series : seen->series)
    list.push_back({{"run", series.run},
                    {"column", series.column},
                    {"observed", or_null(series.quantity)},
                    {"unit", unit_of(series)},
                    {"rate", or_null(series.rate)},
                    {"t", series.t},
                    {"x", series.y}});
  return found(to_text(document), true);
}

/// The motion beside the law, sample by sample; its own velocity and energy where it is a displacement.
Json curves_of(const FittedRecording& fitted) {
  if (!fitted.succeeded() || fitted.series.t.empty()) return nullptr;
  const FittedMotion motion = fitted_motion(fitted);
  std::vector<double> outlier_times;
  for (const Outlier& outlier : fitted.series.outliers) outlier_times.push_back(outlier.t);
  std::vector<double> displacement = motion.measured;
  for (double& x : displacement) x -= fitted.fit.equilibrium().value;
  return {{"t", motion.t},
          {"measured", motion.measured},
          {"residual", motion.residual},
          {"x", motion.x},
          {"v", motion.v},
          {"energy", motion.energy},
          {"measured_velocity", motion.local_velocity},
          {"measured_energy", energies_of(fitted, displacement, motion.local_velocity)},
          {"set_aside", outlier_times}};
}

Json units_of(const FittedRecording& fitted) {
  const MotionUnits units = motion_units(fitted);
  return {{"measured", units.measured},
          {"displacement", units.displacement},
          {"velocity", units.velocity},
          {"energy", units.energy}};
}

/// [unit of the displacement] what the law leaves; of a column of its derivatives, the swing that has as
/// much.
double displacement_rms(const FittedRecording& fitted) {
  const int derivative = std::max(0, derivative_order(fitted.series.quantity));
  return fitted.fit.residual.rms / std::pow(fitted.fit.angular_frequency().value, derivative);
}

Answer fit_task(const Request& request, std::string_view file) {
  FitOptions options;
  if (auto good = assign(request, options_of(options)); !good) return bad_input(good.error());
  const auto fits = fit(file, request.file_name, options);
  if (!fits) return bad_input(fits.error());
  bool ok = true;
  Json document;
  Json& list = document["fits"] = Json::array();
  for (const FittedRecording& fitted : *fits) {
    ok = ok && fitted.succeeded();
    list.push_back(fit_object(fitted, {}));
    list.back()["units"] = units_of(fitted);
    list.back()["displacement_rms"] = displacement_rms(fitted);
    list.back()["curves"] = curves_of(fitted);
  }
  return found(to_text(document), ok);
}

Answer compare_task(const Request& request, std::string_view file) {
  CompareOptions options;
  if (auto good = assign(request, options_of(options)); !good) return bad_input(good.error());
  const auto compared = compare(file, request.file_name, options);
  if (!compared) return bad_input(compared.error());
  bool ok = true;
  Json document;
  Json& list = document["comparisons"] = Json::array();
  for (const CompareResult& each : *compared) {
    ok = ok && each.complete;
    list.push_back(comparison_object(each, {}));
    Json& states = list.back()["states"] = Json::array();
    for (const ComparedCurve& curve : each.curves)
      states.push_back({{"t", curve.trajectory.t},
                        {"x", curve.trajectory.x},
                        {"v", curve.trajectory.v},
                        {"energy", energies_of(each.recording, curve.trajectory.x, curve.trajectory.v)}});
  }
  return found(to_text(document), ok);
}

/// What a logger would write of a simulated motion: a recording whose truth is known.
Answer synthetic_task(const Request& request, std::string_view) {
  auto options = simulate_options(request);
  if (!options) return bad_input(options.error());
  options->sensor.used = true;
  options->motion_only = true;
  const auto result = simulate(*options);
  if (!result) return bad_input(result.error());
  const SimulatedRun& run = result->runs.front();
  std::string text = "Time (s),Position (m)\n";
  for (std::size_t i = 0; i < run.sensor.size(); ++i)
    text += shortest(to_15_digits(run.trajectory.t[i])) + ',' + shortest(run.sensor[i]) + '\n';
  return found(to_text(Json{{"text", text}}), result->ok());
}

/// The number that an option of simulate was given; none of a text.
std::optional<double> number_of(const Option& option) {
  return std::visit(
      [](const auto* target) -> std::optional<double> {
        using Value = std::remove_cvref_t<decltype(*target)>;
        if constexpr (std::is_same_v<Value, double>) return *target;
        if constexpr (std::is_same_v<Value, std::optional<double>>) return *target;
        if constexpr (std::is_same_v<Value, std::vector<double>>) return target->back();
        return std::nullopt;
      },
      option.target);
}

/// What a quantity as typed means for an option of simulate, in SI units.
Answer quantity_task(const Request& request, std::string_view) {
  SimulateOptions options;
  const std::vector<Option> table = options_of(options);
  if (auto good = assign(request, table); !good) return bad_input(good.error());
  Json document = Json::object();
  for (const auto& [name, text] : request.settings)
    for (const Option& option : table)
      if (option.name == name) document[name] = json_or_null(number_of(option));
  return found(to_text(document), true);
}

struct Task {
  std::string_view name;
  Answer (*run)(const Request& request, std::string_view file);
};

constexpr Task tasks[] = {
    {"simulate", simulate_task},   {"motion", motion_task},       {"effective", methods_task},
    {"resonance", resonance_task}, {"inspect", inspect_task},     {"fit", fit_task},
    {"compare", compare_task},     {"synthetic", synthetic_task}, {"quantity", quantity_task}};

}  // namespace

Answer answer(std::string_view text, std::string_view file) {
  const auto request = read_request(text);
  if (!request) return bad_input(request.error());
  json_blocks().clear();
  for (const Task& task : tasks)
    if (task.name == request->task) return task.run(*request, file);
  return bad_input(Error{"page_task", {{"task", request->task}}});
}

}  // namespace cromer::core::page
