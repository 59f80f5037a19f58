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
#include "cromer/documents/json.h"
#include "cromer/documents/json/described.h"
#include "cromer/documents/json/json.h"
#include "described.h"
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
  document["curves"] = described::value_json(*curves, {});
  return found(to_text(document), true);
}

Answer inspect_task(const Request& asked, std::string_view file) {
  Request request = asked;
  const std::string column = take(request, "column");
  ReadOptions options;
  if (auto good = assign(request, options_of(options)); !good) return bad_input(good.error());
  const auto seen = inspect(file, request.file_name, options, column);
  if (!seen) return bad_input(seen.error());
  return found(to_text(json_of(InspectedOnPage{*seen}, {})), true);
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
    list.push_back(json_of(FitOnPage{fitted}, {}));
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
    list.push_back(json_of(ComparedOnPage{each}, {}));
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
      if (option.name == name) document[name] = described::value_json(number_of(option), {});
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
