// The C interface: a request in JSON and arrays in, a document and arrays out.
#include <algorithm>
#include <cmath>
#include <exception>
#include <list>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cromer/base/ascii.h"
#include "cromer/base/nearest.h"
#include "cromer/c.h"
#include "cromer/documents/json.h"
#include "cromer/documents/json/described.h"
#include "cromer/documents/json/json.h"
#include "cromer/door/found.h"
#include "cromer/door/network_of.h"
#include "cromer/door/options.h"
#include "cromer/door/results.h"
#include "cromer/door/watching.h"
#include "cromer/door/words.h"
#include "cromer/read/columns.h"
#include "cromer/tasks/fit/fitted_motion.h"
#include "cromer/tasks/modes_of_file.h"
#include "cromer/tasks/network_fit/network_fit.h"
#include "cromer/tasks/network_run/network_run.h"
#include "cromer/tasks/open_recording.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/recognise/recognise.h"
#include "cromer/tasks/simulate/run_energy.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/version.h"

/// What a call gives back; C sees it only by pointer.
struct cromer_result {
  int status = CROMER_DONE;
  std::string document{};
  cromer::core::Found found{};
  cromer::Language language = cromer::Language::english;  ///< of what is said of it later
  std::list<std::string> names{};                         ///< of the arrays
  std::list<std::vector<double>> columns{};               ///< values that `found` does not hold as such
  std::vector<cromer_array> arrays{};

  /// An array whose values `found` holds.
  void show(std::string name, const std::vector<double>& values) {
    names.push_back(std::move(name));
    arrays.push_back({names.back().c_str(), values.data(), values.size()});
  }
  void add(std::string name, std::vector<double> values) {
    columns.push_back(std::move(values));
    show(std::move(name), columns.back());
  }
  void show(const std::string& prefix, const cromer::Trajectory& motion) {
    show(prefix + "t", motion.t);
    show(prefix + "x", motion.x);
    show(prefix + "v", motion.v);
  }
};

namespace cromer::core {
namespace {

using Request = nlohmann::json;

/// A setting that is no option of a task, taken out of the request; "" where it is not there.
Result<std::string> take_text(Request& request, const char* name) {
  const auto at = request.find(name);
  if (at == request.end()) return std::string();
  if (!at->is_string() && !at->is_null()) return Error{Notice{"must_be_text", {{"argument", name}}}, name};
  const std::string text = at->is_null() ? std::string() : at->get<std::string>();
  request.erase(at);
  return text;
}

/// Takes the language of the document's sentences out of the request.
Result<Language> take_language(Request& request) {
  const auto word = take_text(request, "language");
  if (!word) return word.error();
  if (word->empty() || *word == "en") return Language::english;
  if (*word == "de") return Language::german;
  const std::vector<std::string> known{"en", "de"};
  return Error{Notice{"word_not_known", {{"argument", "language"}, {"word", *word}, {"known", known}}},
               "language"};
}

struct AskedNetwork {
  Result<NetworkFile> network;
  std::string name{};  ///< its file
};

/// A call's request, taken apart as the verb asks for it.
class Call {
 public:
  Call(std::string_view verb, Request request, std::span<const cromer_array> arrays, const Progress& progress,
       const Voice& voice)
      : verb_(verb), request_(std::move(request)), arrays_(arrays), watching_(progress), voice_(voice) {}

  std::string_view verb() const { return verb_; }
  const Voice& voice() const { return voice_; }
  const Watch& watch() const { return watching_.watch(); }

  /// Settings that are no options of the task, taken out of the request; "" where one is not there.
  Result<std::string> take_text(const char* name) { return core::take_text(request_, name); }
  /// Likewise, in seconds; NaN where it is not there.
  Result<double> take_seconds(const char* name) {
    const auto at = request_.find(name);
    if (at == request_.end()) return std::nan("");
    const Request value = *at;
    request_.erase(at);
    if (value.is_null()) return std::nan("");
    if (value.is_number()) return value.get<double>();
    if (!value.is_string()) return Error{Notice{"must_be_number", {{"argument", name}}}, name};
    const auto quantity = parse_quantity(value.get<std::string>(), "s");
    if (!quantity) return Error{quantity.error().notice, name};
    return quantity->value;
  }

  /// The network that the request names or has, taken out of it; empty where there is none.
  std::optional<AskedNetwork> take_network() {
    const auto at = request_.find("network");
    if (at == request_.end()) return std::nullopt;
    const Request value = *at;
    request_.erase(at);
    if (value.is_null()) return std::nullopt;
    return AskedNetwork{network_of(value), value.is_string() ? value.get<std::string>() : given_network};
  }

  /// All arrays but the times as columns of a recording, marked as used.
  std::vector<GivenColumn> take_columns() {
    std::vector<GivenColumn> columns;
    for (const cromer_array& each : arrays_)
      if (std::string_view(each.name) != "t")
        columns.push_back({each.name, each.name, take_array(each.name)});
    return columns;
  }

  /// An array by name, marked as used; empty where it is not given.
  std::span<const double> take_array(std::string_view name) {
    for (const cromer_array& each : arrays_)
      if (name == each.name) {
        used_.push_back(&each);
        return {each.values, each.length};
      }
    return {};
  }
  bool has_array(std::string_view name) const {
    return std::any_of(arrays_.begin(), arrays_.end(),
                       [&](const cromer_array& each) { return name == each.name; });
  }

  /// Whether the request has that argument.
  bool asks(const std::string& argument) const { return request_.contains(argument); }

  /// Refuses arguments that are not options of that kind; `code` is what is said of the first.
  Result<void> refuse_unless(bool (*is_option)(std::string_view), const char* code) const {
    for (const auto& item : request_.items())
      if (const std::string option = with_hyphens(item.key()); !item.value().is_null() && !is_option(option))
        return Error{Notice{code, {{"option", option}}}, item.key()};
    return {};
  }

  /// What is left of the request, into the options.
  Result<void> assign_rest(const std::vector<Option>& options) const {
    std::vector<TypedOption> settings;
    for (const auto& item : request_.items()) {
      const Request& value = item.value();
      const auto found = find(item.key(), options);
      if (!found) return found.error();
      const Option& option = **found;
      const std::string name(option.name);
      const bool nested =
          value.is_array() &&
          std::any_of(value.begin(), value.end(), [](const Request& each) { return each.is_structured(); });
      if (value.is_object() || nested)
        return Error{Notice{"must_be_value", {{"argument", item.key()}}}, item.key()};
      if (value.is_null()) continue;
      if (!value.is_array()) {
        settings.emplace_back(name, text_of(value));
      } else if (option.has_uncertainty() && value.size() == 2) {
        settings.emplace_back(name, text_of(value[0]) + " ± " + text_of(value[1]));
      } else if (option.is_list()) {
        for (const auto& each : value) settings.emplace_back(name, text_of(each));
      } else if (option.is_text()) {
        std::string list;
        for (const auto& each : value) list += (list.empty() ? "" : ",") + text_of(each);
        settings.emplace_back(name, std::move(list));
      } else {
        return Error{Notice{"takes_one_value", {{"argument", item.key()}, {"count", value.size()}}},
                     item.key()};
      }
    }
    return assign(settings, options, verb_);
  }

  /// Refuses options about a file (how to read it, which column) where arrays are given.
  Result<void> refuse_of_files() const {
    ReadOptions read;
    std::vector<std::string> names{"column", "force-column", "run", "unit"};
    for (const Option& option : options_of(read)) names.emplace_back(option.name);
    for (const std::string& option : names)
      if (const std::string name = argument_of(option); request_.contains(name))
        return Error{Notice{"said_of_a_file", {{"argument", name}}}, name};
    return {};
  }

  /// Refuses arrays that the verb has no use for.
  Result<void> check_arrays() const {
    for (const cromer_array& each : arrays_)
      if (std::find(used_.begin(), used_.end(), &each) == used_.end())
        return Error{Notice{"not_an_array_here", {{"array", each.name}, {"verb", verb_}}}, each.name};
    return {};
  }

  /// Every array that is left, for sweeps.
  std::vector<const cromer_array*> take_all() {
    std::vector<const cromer_array*> all;
    for (const cromer_array& each : arrays_) all.push_back(&each);
    used_ = all;
    return all;
  }

 private:
  /// The option that an argument is; the Error suggests the nearest.
  Result<const Option*> find(const std::string& argument, const std::vector<Option>& options) const {
    std::vector<std::string> names;
    for (const Option& each : options) {
      names.push_back(argument_of(each.name));
      if (names.back() == argument) return &each;
    }
    const std::string near = nearest(argument, std::vector<std::string_view>(names.begin(), names.end()));
    return Error{Notice{near.empty() ? "unknown_argument" : "unknown_argument_but",
                        {{"argument", argument}, {"verb", verb_}, {"near", near}}},
                 argument};
  }

  static std::string text_of(const Request& value) {
    if (value.is_string()) return value;
    if (value.is_number_float()) return shortest(value.get<double>());
    return value.dump();
  }

  std::string_view verb_;
  Request request_;
  std::span<const cromer_array> arrays_;
  std::vector<const cromer_array*> used_;
  Watching watching_;
  const Voice& voice_;
};

/// The recording that fit and compare are about: arrays, or a file.
struct Motion {
  Recording recording;
  bool of_arrays = false;
};

Result<Motion> motion_of(Call& call, const ReadOptions& read, const std::string& file,
                         const std::string& observed) {
  if (call.has_array("t") || call.has_array("y")) {
    if (!file.empty()) return Error{Notice{"file_and_arrays"}, "file"};
    for (const char* needed : {"t", "y"})
      if (!call.has_array(needed)) return Error{Notice{"array_is_missing", {{"array", needed}}}, needed};
    const auto kind = observed_of(observed);
    if (!kind) return kind.error();
    auto recording =
        recording_of(call.take_array("t"), call.take_array("y"), call.take_array("force"), *kind);
    if (!recording) return recording.error();
    return Motion{*std::move(recording), true};
  }
  if (!observed.empty()) return Error{Notice{"observed_of_file"}, "observed"};
  if (file.empty()) return Error{Notice{"no_record", {{"verb", call.verb()}}}, "t"};
  auto recording = open_recording(file, read);
  if (!recording) return recording.error();
  return Motion{*std::move(recording), false};
}

/// Reads what fit and compare share; `options` are filled by `table`.
Result<Motion> take_motion(Call& call, FitOptions& options, const std::vector<Option>& table) {
  const auto file = call.take_text("file");
  if (!file) return file.error();
  const auto observed = call.take_text("observed");
  if (!observed) return observed.error();
  if (call.has_array("t"))
    if (auto good = call.refuse_of_files(); !good) return good.error();
  if (auto good = call.assign_rest(table); !good) return good.error();
  auto motion = motion_of(call, options.read, *file, *observed);
  if (!motion) return motion;
  if (motion->of_arrays) {
    options.column = "y";
    if (!call.take_array("force").empty()) options.force_column = "force";
  }
  return motion;
}

Error said(const Error& error, const Motion& motion) { return in_arguments(error, motion.of_arrays); }

/// A recording of several columns: arrays of one kind, or a file.
Result<Motion> take_channels_of(Call& call, const ReadOptions& read, const std::string& file,
                                Observed observed) {
  if (call.has_array("t")) {
    if (!file.empty()) return Error{Notice{"file_and_arrays"}, "file"};
    auto recording = recording_of(call.take_array("t"), call.take_columns(), observed, "arrays");
    if (!recording) return recording.error();
    return Motion{*std::move(recording), true};
  }
  if (file.empty()) return Error{Notice{"no_record", {{"verb", call.verb()}}}, "t"};
  auto recording = open_recording(file, read);
  if (!recording) return recording.error();
  return Motion{*std::move(recording), false};
}

Result<void> fit_network_verb(Call& call, const AskedNetwork& asked, cromer_result& result) {
  const Result<NetworkFile>& network = asked.network;
  if (!network) return of_network(network.error());
  FitOptions options;
  const auto file = call.take_text("file");
  if (!file) return file.error();
  if (call.has_array("t"))
    if (auto good = call.refuse_of_files(); !good) return good;
  const std::vector<Option> table = options_of(options);
  if (auto good = call.assign_rest(table); !good) return good;
  if (auto good = call.refuse_unless(is_fit_option_of_networks, "fit_option_not_of_networks"); !good)
    return good;
  const auto motion = take_channels_of(call, options.read, *file,
                                       network->network.angles ? Observed::angle : Observed::position);
  if (!motion) return motion.error();
  auto found = fit_network(motion->recording, *network, asked.name, options, call.watch());
  if (!found) return of_network(found.error(), motion->of_arrays);
  put_in_arguments(*found, motion->of_arrays);
  const FittedNetwork& fitted = result.found.emplace<FittedNetwork>(*std::move(found));
  if (!fitted.succeeded()) result.status = CROMER_NO_SUCCESS;
  result.show("1.t", fitted.channels.t);
  for (std::size_t i = 0; i < fitted.fit.columns.size(); ++i) {
    const std::string of_mass = "1." + fitted.asked.network.masses[i].name + ".";
    result.show(of_mass + "measured", fitted.channels.each[i].y);
    result.show(of_mass + "residual", fitted.fit.columns[i].residual);
  }
  result.document = to_json(fitted, call.voice());
  return {};
}

Result<void> fit_verb(Call& call, cromer_result& result) {
  if (const auto network = call.take_network()) return fit_network_verb(call, *network, result);
  FitOptions options;
  const auto motion = take_motion(call, options, options_of(options));
  if (!motion) return motion.error();
  auto fits = core::fit(motion->recording, options, call.watch());
  if (!fits) return said(fits.error(), *motion);
  for (FittedRecording& each : *fits) {
    put_in_arguments(each, motion->of_arrays);
    if (!each.succeeded()) result.status = CROMER_NO_SUCCESS;
    if (!each.fit.is_usable()) continue;
    FittedMotion known = law_motion(each);
    const std::string run = std::to_string(each.series.run) + ".";
    result.add(run + "t", std::move(known.t));
    result.add(run + "measured", std::move(known.measured));
    result.add(run + "residual", std::move(known.residual));
    result.add(run + "x", std::move(known.x));
    result.add(run + "v", std::move(known.v));
  }
  result.document = to_json(*fits, false, call.voice());
  result.found = *std::move(fits);
  return {};
}

Result<void> compare_verb(Call& call, cromer_result& result) {
  CompareOptions options;
  const auto motion = take_motion(call, options.fit, options_of(options));
  if (!motion) return motion.error();
  auto compared = compare(motion->recording, options, call.watch());
  if (!compared) return said(compared.error(), *motion);
  for (CompareResult& each : *compared) put_in_arguments(each, motion->of_arrays);
  for (const CompareResult& each : result.found.emplace<std::vector<CompareResult>>(*std::move(compared))) {
    if (!each.complete || !each.recording.succeeded()) result.status = CROMER_NO_SUCCESS;
    for (std::size_t i = 0; i < each.curves.size(); ++i)
      result.show(std::to_string(each.recording.series.run) + "." + std::to_string(i + 1) + ".",
                  each.curves[i].trajectory);
  }
  result.document = to_json(std::get<std::vector<CompareResult>>(result.found), call.voice());
  return {};
}

Result<void> take_record(Call& call, SimulateOptions& options, double spacing) {
  const bool force = call.has_array("force"), ground = call.has_array("acceleration");
  if (!force && !ground) {
    if (!std::isnan(spacing)) return Error{Notice{"spacing_of_nothing"}, "spacing"};
    return load_drive(options, "");
  }
  const std::string name = force ? "force" : "acceleration";
  if (force && ground) return Error{Notice{"force_and_acceleration"}, "force"};
  if (std::isnan(spacing)) return Error{Notice{"spacing_is_missing", {{"array", name}}}, "spacing"};
  return core::set_record(options, force ? RecordOf::force : RecordOf::ground, call.take_array(name),
                          spacing);
}

Result<void> simulate_network_verb(Call& call, const AskedNetwork& asked, cromer_result& result) {
  const auto network = known_network(asked.network);
  if (!network) return of_network(network.error());
  SimulateOptions options;
  if (auto good = call.assign_rest(options_of(options)); !good) return good;
  if (auto good = call.refuse_unless(is_option_of_networks, "option_not_of_networks"); !good) return good;
  if (auto good = call.check_arrays(); !good) return good;
  options.memory = memory_for_states;
  auto found = run_network_by_each(*network, asked.name, options, call.watch());
  if (!found) return of_network(found.error());
  for (NetworkRun& run : *found) put_in_arguments(run);
  const auto& runs = result.found.emplace<std::vector<NetworkRun>>(*std::move(found));
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const NetworkRun& run = runs[k];
    if (!run.ok()) result.status = CROMER_NO_SUCCESS;
    const std::string of_run = std::to_string(k + 1) + ".";
    result.show(of_run + "t", run.states.t);
    for (std::size_t i = 0; i < run.network.masses.size(); ++i) {
      const std::string of_mass = of_run + run.network.masses[i].name + ".";
      result.show(of_mass + "x", run.states.x[i]);
      result.show(of_mass + "v", run.states.v[i]);
    }
    result.show(of_run + "energy", run.states.energy);
  }
  result.document = to_json(runs, false, call.voice());
  return {};
}

Result<void> simulate_verb(Call& call, cromer_result& result) {
  if (const auto network = call.take_network()) return simulate_network_verb(call, *network, result);
  SimulateOptions options;
  const auto spacing = call.take_seconds("spacing");
  if (!spacing) return spacing.error();
  if (auto good = call.assign_rest(options_of(options)); !good) return good;
  if (auto good = take_record(call, options, *spacing); !good) return good;
  if (auto good = call.check_arrays(); !good) return good;
  options.memory = memory_for_states;
  const bool of_arrays = call.has_array("force") || call.has_array("acceleration");
  auto found = simulate(options, call.watch());
  if (!found) return in_arguments(found.error(), of_arrays);
  put_in_arguments(*found, of_arrays);
  const auto& simulated = result.found.emplace<SimulateResult>(*std::move(found));
  if (!simulated.ok()) result.status = CROMER_NO_SUCCESS;
  for (std::size_t i = 0; i < simulated.runs.size(); ++i) {
    const SimulatedRun& run = simulated.runs[i];
    const std::string of_run = std::to_string(i + 1) + ".";
    result.show(of_run, run.trajectory);
    result.add(of_run + "energy", energies(run));
    if (!run.sensor.empty()) result.show(of_run + "sensor", run.sensor);
  }
  result.document = to_json(simulated, false, call.voice());
  return {};
}

Result<void> methods_verb(Call& call, cromer_result& result) {
  RecogniseOptions options;
  if (auto good = call.assign_rest(options_of(options)); !good) return good;
  if (!options.recognise.empty()) {
    const auto recording = open_recording(options.recognise, options.read);
    if (!recording) return recording.error();
    auto found = recognise(*recording, options, call.watch());
    if (!found) return found.error();
    if (!found->ok()) result.status = CROMER_NO_SUCCESS;
    result.document = to_json(*found, call.voice());
    result.found = *std::move(found);
    return {};
  }
  if (auto good = only_with_file(options); !good) return good;
  auto rows = list_methods(options.methods);
  if (!rows) return rows.error();
  result.document = to_json(std::span<const MethodRow>(*rows), call.voice());
  result.found = ListedMethods{options.methods, *std::move(rows)};
  return {};
}

/// What modes are sought of: a network, a file of either kind, or arrays; of the last two beside a network.
Result<ModesResult> modes_of_call(Call& call, const std::optional<AskedNetwork>& asked) {
  ModesOptions options;
  const auto file = call.take_text("file");
  if (!file) return file.error();
  const auto word = call.take_text("observed");
  if (!word) return word.error();
  const bool of_arrays = call.has_array("t");
  if (of_arrays)
    if (auto good = call.refuse_of_files(); !good) return good.error();
  if (!of_arrays && !word->empty()) return Error{Notice{"observed_of_file"}, "observed"};
  if (auto good = call.assign_rest(options_of(options)); !good) return good.error();
  if (asked) {
    auto known = known_network(asked->network);
    if (!known) return of_network(known.error());
    if (!of_arrays && file->empty()) {
      auto found = network_modes(*known, asked->name, options);
      if (!found) return of_network(found.error());
      return found;
    }
    options.network = *std::move(known);
  }
  if (!of_arrays) {
    if (file->empty()) return Error{Notice{"no_file"}, "file"};
    return modes_of_file(*file, options);
  }
  const auto observed = observed_of(*word);
  if (!observed) return observed.error();
  const auto motion = take_channels_of(call, options.read, *file, *observed);
  if (!motion) return motion.error();
  auto found = recording_modes(motion->recording, options);
  if (!found) return in_arguments(found.error(), true);
  put_in_arguments(*found, true);
  return found;
}

Result<void> modes_verb(Call& call, cromer_result& result) {
  auto found = modes_of_call(call, call.take_network());
  if (!found) return found.error();
  put_in_arguments(*found, false);
  if (!found->ok()) result.status = CROMER_NO_SUCCESS;
  result.document = to_json(*found, call.voice());
  result.found = *std::move(found);
  return {};
}

Result<SpectrumResult> response_spectrum_of(Call& call, const SpectrumOptions& options,
                                            const std::string& file, double spacing) {
  if (!call.has_array("acceleration")) {
    if (file.empty()) return Error{Notice{"no_acceleration"}, "acceleration"};
    if (!std::isnan(spacing)) return Error{Notice{"spacing_of_a_file"}, "spacing"};
    const auto one = open_recording(file, options.read);
    if (!one) return one.error();
    return response_spectrum(std::span(&*one, 1), options, call.watch());
  }
  if (std::isnan(spacing)) return Error{Notice{"spacing_is_missing", {{"array", "acceleration"}}}, "spacing"};
  auto components = components_of(call.take_array("acceleration"), call.take_array("second"), spacing);
  if (!components) return components.error();
  return response_spectrum(*std::move(components), options, call.watch());
}

Result<void> spectrum_verb(Call& call, cromer_result& result) {
  SpectrumOptions options;
  const auto file = call.take_text("file");
  if (!file) return file.error();
  const auto spacing = call.take_seconds("spacing");
  if (!spacing) return spacing.error();
  if (call.has_array("acceleration")) {
    if (!file->empty()) return Error{Notice{"file_and_arrays"}, "file"};
    if (auto good = call.refuse_of_files(); !good) return good;
  }
  if (auto good = call.assign_rest(options_of(options)); !good) return good;
  const auto periods = call.take_array("periods");
  for (const char* argument : {"periods", "frequencies"})
    if (!periods.empty() && call.asks(argument))
      return Error{Notice{"array_and_argument", {{"array", "periods"}, {"argument", argument}}}, argument};
  if (auto good = check_samples(periods, "periods", 0); !good) return good;
  options.these_periods.assign(periods.begin(), periods.end());
  options.memory = memory_for_results;
  auto found = response_spectrum_of(call, options, *file, *spacing);
  if (!found) return in_arguments(found.error(), file->empty());
  if (auto good = call.check_arrays(); !good) return good;
  if (found->interrupted) result.status = CROMER_NO_SUCCESS;
  found->notices = in_arguments(std::move(found->notices), file->empty());
  const auto& kept = result.found.emplace<SpectrumResult>(*std::move(found));
  result.show("period", kept.periods);
  result.show("ground_velocity", kept.components[0].path.velocity);
  result.show("ground_displacement", kept.components[0].path.displacement);
  for (std::size_t i = 0; i < kept.spectra.size(); ++i) {
    const ResponseSpectrum& spectrum = kept.spectra[i];
    const std::string ratio = kept.spectra.size() > 1 ? std::to_string(i + 1) + "." : "";
    if (!spectrum.displacement.empty()) {
      const std::vector<double>& peaks = spectrum.displacement.front();
      const auto each = [&](double (*of)(double displacement, double period)) {
        std::vector<double> values(peaks.size());
        std::transform(peaks.begin(), peaks.end(), kept.periods.begin(), values.begin(), of);
        return values;
      };
      result.show(ratio + "displacement", peaks);
      result.add(ratio + "pseudo_velocity", each(pseudo_velocity));
      result.add(ratio + "pseudo_acceleration", each(pseudo_acceleration));
    }
    if (!spectrum.rotd50.empty()) result.show(ratio + "rotd50", spectrum.rotd50);
    if (!spectrum.rotd100.empty()) result.show(ratio + "rotd100", spectrum.rotd100);
  }
  result.document = to_json(kept, false, call.voice(), false);  // the arrays have the curves
  return {};
}

Result<void> sweep_verb(Call& call, cromer_result& result) {
  SweepOptions options;
  if (auto good = call.assign_rest(options_of(options)); !good) return good;
  const std::vector<Option> table = options_of(options);
  std::vector<TypedOption> grids;
  for (const cromer_array* array : call.take_all()) {
    const std::string option = with_hyphens(array->name);
    if (std::none_of(table.begin(), table.end(), [&](const Option& each) { return each.name == option; }))
      return Error{Notice{"not_an_array_of", {{"array", array->name}, {"verb", call.verb()}}}, array->name};
    if (call.asks(array->name))
      return Error{Notice{"array_and_argument", {{"array", array->name}, {"argument", array->name}}},
                   array->name};
    grids.emplace_back(option, list_of({array->values, array->length}));
  }
  if (auto good = assign(grids, table, call.verb()); !good) return good;
  options.memory = memory_for_results;
  auto swept = run_sweep(options, call.watch());
  if (!swept) return swept.error();
  if (!swept->counts.ok() || swept->interrupted) result.status = CROMER_NO_SUCCESS;
  const auto& columns = swept->plan.rows.columns;
  for (std::size_t j = 0; j + 1 < columns.size(); ++j)
    result.add(std::string(columns[j]), column_of(*swept, j));
  result.document = to_json(*swept, false, call.voice());
  result.found = *std::move(swept);
  return {};
}

Result<void> read_verb(Call& call, cromer_result& result) {
  ReadOptions options;
  const auto file = call.take_text("file");
  if (!file) return file.error();
  if (file->empty()) return Error{Notice{"no_file"}, "file"};
  const auto column = call.take_text("column");
  if (!column) return column.error();
  if (auto good = call.assign_rest(options_of(options)); !good) return good;
  auto recording = open_recording(*file, options);
  if (!recording) return recording.error();
  auto seen = inspect(*std::move(recording), options, *column);
  if (!seen) return seen.error();
  const auto& read = result.found.emplace<ReadFile>(ReadFile{options, *std::move(seen)});
  for (const core::Column& each : read.inspection.recording.table.columns)
    result.show(column_title(each), each.values);
  result.document = to_json(read.inspection, false, call.voice());
  return {};
}

struct Verb {
  std::string_view name;
  Result<void> (*run)(Call& call, cromer_result& result);
};

constexpr Verb verbs[] = {{"read", read_verb},         {"fit", fit_verb},         {"simulate", simulate_verb},
                          {"compare", compare_verb},   {"methods", methods_verb}, {"modes", modes_verb},
                          {"spectrum", spectrum_verb}, {"sweep", sweep_verb}};

/// The request, or where it ceases to be JSON.
Result<Request> request_of(std::string_view text) {
  if (text.empty()) return Request::object();
  try {
    return Request::parse(text);
  } catch (const Request::parse_error& error) {
    return Error{Notice{"request_is_no_json", {{"byte", error.byte}}}, "request"};
  } catch (const Request::out_of_range&) {
    return Error{Notice{"request_number_too_large"}, "request"};
  }
}

/// `voice`: in which language the request wants its answer.
Result<void> run(std::string_view verb, std::string_view text, std::span<const cromer_array> arrays,
                 const Progress& progress, Voice& voice, cromer_result& result) {
  Result<Request> parsed = request_of(text);
  Request request = parsed ? *std::move(parsed) : Request();
  const auto language = request.is_object() ? take_language(request) : Language::english;
  if (language) voice.language = *language;
  const auto found =
      std::find_if(std::begin(verbs), std::end(verbs), [&](const Verb& each) { return each.name == verb; });
  if (found == std::end(verbs)) {
    std::vector<std::string> known;
    for (const Verb& each : verbs) known.emplace_back(each.name);
    return Error{Notice{"no_verb", {{"verb", verb}, {"verbs", known}}}, "verb"};
  }
  if (!parsed) return parsed.error();
  if (!request.is_object()) return Error{Notice{"request_is_no_object"}, "request"};
  if (!language) return language.error();
  std::set<std::string_view> names;
  for (const cromer_array& each : arrays) {
    if (!each.name || !*each.name || (!each.values && each.length > 0))
      return Error{Notice{"array_without_name_or_values"}, "arrays"};
    if (!names.insert(each.name).second)
      return Error{Notice{"array_given_twice", {{"array", each.name}}}, each.name};
  }
  Call call(verb, std::move(request), arrays, progress, voice);
  if (auto good = found->run(call, result); !good) return good;
  return call.check_arrays();
}

}  // namespace
}  // namespace cromer::core

namespace {

/// Runs `work`, which fills a result of its own or says why it cannot. nullptr where memory has run out.
template <class Work>
cromer_result* answer(cromer::core::Voice& voice, const Work& work) {
  using namespace cromer;
  std::unique_ptr<cromer_result> result(new (std::nothrow) cromer_result);
  if (!result) return nullptr;
  const auto refuse = [&](const Error& error) {
    *result = {};
    result->status = CROMER_BAD_INPUT;
    result->document = core::to_text(core::refusal_object(error.notice, error.argument, voice));
  };
  try {
    if (const Result<void> good = work(*result); !good) refuse(core::in_arguments(good.error()));
  } catch (const std::bad_alloc&) {
    return nullptr;
  } catch (const std::exception& error) {
    refuse(Error{"call_failed", {{"what", error.what()}}});
  }
  return result.release();
}

cromer::core::Voice voice_of_result(const cromer_result* result) {
  return {result ? result->language : cromer::Language::english, cromer::core::Audience::caller};
}

const cromer::core::Found& found_of(const cromer_result* result) {
  static const cromer::core::Found nothing;
  return result ? result->found : nothing;
}

}  // namespace

cromer_result* cromer_call(const char* verb, const char* request, const cromer_array* arrays, size_t count,
                           cromer_progress progress, void* user) {
  using namespace cromer;
  core::Voice voice{.audience = core::Audience::caller};
  return answer(voice, [&](cromer_result& result) {
    const Progress told =
        progress ? Progress([=](double done) { return progress(done, user) != 0; }) : Progress{};
    auto good = core::run(verb ? verb : "", request ? request : "", std::span(arrays, arrays ? count : 0),
                          told, voice, result);
    result.language = voice.language;
    return good;
  });
}

cromer_result* cromer_written_as(const cromer_result* result, const char* form) {
  using namespace cromer;
  core::Voice voice = voice_of_result(result);
  return answer(voice, [&](cromer_result& written) -> Result<void> {
    auto text = core::written_as(found_of(result), form ? form : "");
    if (!text) return text.error();
    written.document = *std::move(text);
    return {};
  });
}

cromer_result* cromer_motion_at(const cromer_result* fit, int run, const double* t, size_t length) {
  using namespace cromer;
  core::Voice voice = voice_of_result(fit);
  return answer(voice, [&](cromer_result& made) -> Result<void> {
    auto motion = core::motion_of_run(found_of(fit), run, std::span(t, t ? length : 0));
    if (!motion) return motion.error();
    made.document = "{}\n";
    for (auto& [name, values] : {std::pair("t", &motion->t), {"x", &motion->x}, {"v", &motion->v}})
      made.add(name, std::move(*values));
    return {};
  });
}

const char* cromer_document(const cromer_result* result) { return result ? result->document.c_str() : ""; }
int cromer_status(const cromer_result* result) { return result ? result->status : CROMER_BAD_INPUT; }

const cromer_array* cromer_arrays(const cromer_result* result, size_t* count) {
  if (count) *count = result ? result->arrays.size() : 0;
  return result ? result->arrays.data() : nullptr;
}

void cromer_free(cromer_result* result) { delete result; }

const char* cromer_version() { return CROMER_VERSION; }
