#include "answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "cromer/analysis/energy.h"
#include "cromer/analysis/forces.h"
#include "cromer/analysis/frequency_response.h"
#include "cromer/base/grid.h"
#include "cromer/base/number.h"
#include "cromer/documents/described/methods.h"
#include "cromer/documents/described/modes.h"
#include "cromer/documents/json.h"
#include "cromer/documents/json/described.h"
#include "cromer/model/linear_quantities.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/simulate/run_effect.h"
#include "described.h"
#include "resonance_curves.h"

namespace cromer::core::page {
namespace {

/// A request of the page.
struct Request {
  std::string task;
  std::vector<TypedOption> settings{};  ///< in the order given
  std::string file_name = "recording";
};

/// Removes a setting that is the page's own, and returns its value; `otherwise` if it was not given.
std::string take(Request& request, std::string_view name, std::string_view otherwise = "") {
  auto& settings = request.settings;
  const auto at =
      std::find_if(settings.begin(), settings.end(), [&](const auto& s) { return s.first == name; });
  if (at == settings.end()) return std::string(otherwise);
  std::string value = std::move(at->second);
  settings.erase(at);
  return value;
}

/// Reads a request. An Error names a line that is not "option=value".
Result<Request> read_request(std::string_view text) {
  Request request;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string_view line = text.substr(from, end - from);
    from = end + 1;
    if (line.empty()) continue;
    const std::size_t equals = line.find('=');
    if (request.task.empty())
      request.task = line;
    else if (equals == std::string_view::npos)
      return Error{"page_setting", {{"line", line}}};
    else
      request.settings.emplace_back(line.substr(0, equals), line.substr(equals + 1));
  }
  if (const std::string name = take(request, "file-name"); !name.empty()) request.file_name = name;
  return request;
}

/// Assigns every setting to its option. An Error names an unknown option, or what is wrong with a value, in
/// the words of the command line.
Result<void> assign(const Request& request, const std::vector<Option>& options) {
  return core::assign(request.settings, options, request.task);
}

/// "argument" is the option at fault.
Answer bad_input(const Error& error) {
  return {Status::bad_input, to_text(refusal_object(error.notice, first_option(error.notice), {})), {}};
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

Json block(std::size_t first, std::size_t count) {
  Json place = Json::array();
  place.push_back(first);
  place.push_back(count);
  Json object;
  object["block"] = std::move(place);
  return object;
}

/// Room for `count` numbers at the end of the blocks.
double* room_for(std::size_t count) {
  auto& blocks = json_blocks();
  blocks.resize(blocks.size() + count);
  return blocks.data() + blocks.size() - count;
}

Json kept(const std::vector<double>& column) {
  if (!column.empty()) std::memcpy(room_for(column.size()), column.data(), column.size() * sizeof(double));
  return block(json_blocks().size() - column.size(), column.size());
}

Json energies(const SimulatedRun& run) {
  const auto& [t, x, v] = run.trajectory;
  double* to = room_for(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) to[i] = energy(run.oscillator, State<double>{x[i], v[i]});
  return block(json_blocks().size() - t.size(), t.size());
}

Json states(const SimulatedRun& run, Json times) {
  Json columns;
  columns["t"] = std::move(times);
  columns["x"] = kept(run.trajectory.x);
  columns["v"] = kept(run.trajectory.v);
  columns["energy"] = energies(run);
  return columns;
}

/// A column for each force that a run has: {"spring": [...], "viscous": [...], "drive": [...]}.
Json forces(const SimulatedRun& run) {
  const auto& [t, x, v] = run.trajectory;
  const Law law = law_of(run.oscillator);
  const HarmonicForce<double> drive{run.drive.amplitude, run.drive.frequency, run.drive.phase};
  const bool driven = drive.amplitude != 0;
  const std::size_t count = t.size(), first = json_blocks().size();
  std::size_t columns = 0;
  Json object;
  const auto column = [&](std::string_view name) { object[name] = block(first + count * columns++, count); };
  column("spring");
  for_each_resistance([&]<class T>() {
    if (law.has<T>()) column(T::info.name);
  });
  if (driven) column("drive");
  double* to = room_for(count * columns);
  for (std::size_t i = 0; i < count; ++i) {
    const Forces now = forces_on(run.oscillator, law, driven ? drive(t[i]) : 0, {x[i], v[i]});
    double* at = to + i;
    *at = now.spring;
    for_each_resistance([&]<class T>() {
      if (law.has<T>()) *(at += count) = now.resistance.of<T>();
    });
    if (driven) at[count] = now.drive;
  }
  return object;
}

Json motion(const SimulatedRun& run, Json times) {
  const Outcome& outcome = run.outcome;
  Json object;
  object["method"] = run.method;
  object["step"] = run.step;
  object["until"] = run.until;
  object["drive_frequency"] = run.drive.frequency;
  object["status"] = name(outcome.status);
  object["energy_at_end"] = energy(run.oscillator, outcome.y);
  described::add_entries(object, effect_entries(&SimulatedRun::effect), run, {});
  object["states"] = states(run, std::move(times));
  return object;
}

/// The quantities of the law without its terms that are not linear.
Json linear_part(const Oscillator<double>& law) {
  return {{"natural_frequency", natural_frequency(law)},
          {"damped_frequency", damped_frequency(law)},
          {"decay_rate", decay_rate(law)},
          {"critical_damping", critical_damping(law)},
          {"damping_ratio", damping_ratio(law)},
          {"quality_factor", quality_factor(law)},
          {"resonance_frequency", resonance_frequency(law)},
          {"energy_factor_per_cycle", energy_factor_per_cycle(law)}};
}

/// Whether `all` begins with `some`, as the times of a run do that ended early.
bool begins_with(const std::vector<double>& all, const std::vector<double>& some) {
  return some.size() <= all.size() && std::equal(some.begin(), some.end(), all.begin());
}

/// {"runs": [...], "linear_part": {...}, "warnings": [...]}: the part of the document of `simulate` that
/// every move of a slider needs, and the quantities of the linear law. The columns go straight into
/// json_blocks(); runs with the same times share them. The run of the method `forces` has those that act too.
Json motions_of(const SimulateResult& result, std::string_view forces_of) {
  const auto& runs = result.runs;
  const auto longest = std::max_element(runs.begin(), runs.end(), [](const auto& a, const auto& b) {
    return a.trajectory.size() < b.trajectory.size();
  });
  const std::vector<double>& times = longest->trajectory.t;
  // Of each run times, x, v and energy; of one the spring's force, four that resist and the drive's as well.
  std::size_t count = times.size();
  for (const SimulatedRun& run : runs) count += (run.method == forces_of ? 10 : 4) * run.trajectory.size();
  json_blocks().reserve(json_blocks().size() + count);
  const std::size_t first = json_blocks().size();
  kept(times);
  Json document;
  Json& list = document["runs"] = Json::array();
  for (const SimulatedRun& run : runs) {
    const auto& t = run.trajectory.t;
    list.push_back(motion(run, begins_with(times, t) ? block(first, t.size()) : kept(t)));
    // what hysteresis does is not known from the states
    if (run.method == forces_of && run.oscillator.hysteresis_stiffness == 0)
      list.back()["forces"] = forces(run);
  }
  document["linear_part"] = linear_part(runs.front().oscillator);
  add_notices(document, result.notices, {});
  return document;
}

/// The states of a simulation, which the page draws, without the rest of its document.
Answer motion_task(const Request& asked, std::string_view) {
  Request request = asked;
  const std::string forces_of = take(request, "forces");
  auto options = simulate_options(request);
  if (!options) return bad_input(options.error());
  options->motion_only = true;
  const auto result = simulate(*options);
  return result ? found(to_text(motions_of(*result, forces_of)), result->ok()) : bad_input(result.error());
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
  auto recording = read_recording(file, request.file_name, options);
  if (!recording) return bad_input(recording.error());
  const auto seen = inspect(*std::move(recording), options, column);
  if (!seen) return bad_input(seen.error());
  return found(to_text(json_of(InspectedOnPage{*seen}, {})), true);
}

Answer fit_task(const Request& request, std::string_view file) {
  FitOptions options;
  if (auto good = assign(request, options_of(options)); !good) return bad_input(good.error());
  if (!options.force_column.empty()) return bad_input(Error{"program_only", {{"option", "force-column"}}});
  const auto recording = read_recording(file, request.file_name, options.read);
  if (!recording) return bad_input(recording.error());
  const auto fits = fit(*recording, options);
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
  const auto recording = read_recording(file, request.file_name, options.fit.read);
  if (!recording) return bad_input(recording.error());
  const auto compared = compare(*recording, options);
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

/// What several columns of one kind do together.
Answer modes_task(const Request& request, std::string_view file) {
  ModesOptions options;
  if (auto good = assign(request, options_of(options)); !good) return bad_input(good.error());
  if (options.step || !options.method.empty() || !options.of_method.empty())
    return bad_input(Error{"program_only", {{"option", options.step ? "step" : "method"}}});
  const auto recording = read_recording(file, request.file_name, options.read);
  if (!recording) return bad_input(recording.error());
  const auto modes = found_modes(*recording, options);
  return modes ? found(to_text(json_of(*modes, {})), modes->ok()) : bad_input(modes.error());
}

/// A simulated motion as a logger would write it: a recording whose law is known.
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

/// The value of an option; empty if it is no number.
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

/// Values for options of simulate, as typed, in SI units.
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

constexpr Task tasks[] = {{"simulate", simulate_task},   {"motion", motion_task},
                          {"effective", methods_task},   {"resonance", resonance_task},
                          {"inspect", inspect_task},     {"fit", fit_task},
                          {"compare", compare_task},     {"modes", modes_task},
                          {"synthetic", synthetic_task}, {"quantity", quantity_task}};

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
