#include "cromer/network.h"

#include <cmath>
#include <memory>
#include <utility>

#include "cromer/door/network_of.h"
#include "cromer/door/options.h"
#include "cromer/door/results.h"
#include "cromer/door/watching.h"
#include "cromer/door/words.h"
#include "cromer/report/file.h"
#include "cromer/tasks/modes_of_file.h"
#include "cromer/tasks/network_fit/network_fit.h"
#include "cromer/tasks/network_run/network_run.h"

namespace cromer {
namespace {

std::vector<core::GivenColumn> columns_of(const Channels& channels, const std::vector<std::string>& names) {
  std::vector<core::GivenColumn> columns;
  for (const std::span<const double> values : channels.columns()) {
    const std::size_t i = columns.size();
    columns.push_back({i < names.size() ? names[i] : "channel " + std::to_string(i + 1),
                       "channels[" + std::to_string(i) + "]", values});
  }
  return columns;
}

NetworkSimulation network_simulation_of(core::NetworkRun run) {
  NetworkSimulation simulation;
  for (const core::NetworkMass& mass : run.network.masses) simulation.names.push_back(mass.name);
  simulation.t = run.states.t;
  simulation.x = run.states.x;
  simulation.v = run.states.v;
  simulation.energy = run.states.energy;
  simulation.status = run.outcome.status;
  simulation.interrupted = run.outcome.interrupted;
  simulation.message = core::message_of(run.message);
  simulation.counts = run.outcome.counts;
  simulation.step = run.step;
  simulation.notices = run.notices;
  simulation.detail = std::make_shared<const core::NetworkRun>(std::move(run));
  return simulation;
}

Result<NetworkFit> network_fit_of(const core::Recording& recording, const core::NetworkFile& network,
                                  const ReadOptions& read, const NetworkFitOptions& options, bool of_arrays) {
  core::FitOptions asked;
  asked.read = read;
  asked.from = options.from;
  asked.to = options.to;
  asked.run = options.run;
  const core::Watching watching(options.progress);
  auto found = core::fit_network(recording, network, core::given_network, asked, watching.watch());
  if (!found) return core::of_network(found.error(), of_arrays);
  core::put_in_arguments(*found, of_arrays);
  const auto fitted = std::make_shared<const core::FittedNetwork>(*std::move(found));
  NetworkFit fit{.status = fitted->fit.status,
                 .message = core::message_of(fitted->message),
                 .t = fitted->channels.t,
                 .interrupted = watching.watch().interrupted(),
                 .notices = fitted->notices,
                 .detail = fitted};
  const core::Network& asked_for = fitted->asked.network;
  for (std::size_t i = 0; i < asked_for.links.size(); ++i)
    fit.links.push_back({name_of(asked_for, asked_for.links[i].from),
                         name_of(asked_for, asked_for.links[i].to), fitted->found_of(i)});
  for (std::size_t i = 0; i < fitted->fit.columns.size(); ++i) {
    const core::FittedColumn& column = fitted->fit.columns[i];
    fit.masses.push_back({asked_for.masses[i].name, column.position, column.velocity, column.offset,
                          column.rms, column.residual});
  }
  return fit;
}

Result<core::ModesOptions> modes_task_options(const ModesOptions& options) {
  core::ModesOptions asked{
      .step = options.step, .beta = options.beta, .gamma = options.gamma, .rho_inf = options.rho_inf};
  for (const Method& method : options.method) asked.method.push_back(method.name());
  asked.run = options.run;
  asked.from = options.from;
  asked.to = options.to;
  asked.modes = options.modes;
  asked.read = options.read;
  asked.from_frequency = options.from_frequency;
  asked.to_frequency = options.to_frequency;
  if (options.of_method) asked.of_method = options.of_method->name();
  if (!options.network) return asked;
  auto known = core::known_network(core::network_of(*options.network));
  if (!known) return core::of_network(known.error());
  asked.network = *std::move(known);
  return asked;
}

Modes modes_of(core::ModesResult found, bool of_arrays) {
  core::put_in_arguments(found, of_arrays);
  const auto result = std::make_shared<const core::ModesResult>(std::move(found));
  Modes modes;
  modes.names = result->names;
  modes.notices = result->notices;
  modes.message = result->message;
  for (const core::NaturalMode& mode : result->modes) {
    Mode& shown = modes.modes.emplace_back(
        Mode{mode.frequency, mode.damping_ratio, mode.shape, mode.shape_error, mode.participation, {}, {}});
    if (const auto& of = mode.of_network)
      shown.of_network = {of->mode, of->frequency, of->damping_ratio, of->mac};
    for (const core::ModeByMethod& by : mode.methods)
      shown.methods.push_back({by.method, by.step, by.frequency(), by.damping_ratio(), by.effect.stable});
  }
  modes.detail = result;
  return modes;
}

}  // namespace

Result<Network> read_network(const std::string& path) {
  const auto network = core::open_network_file(path);
  if (!network) return core::in_arguments(network.error());
  return core::shown(*network);
}

Result<NetworkSimulation> simulate(const Network& network, const NetworkRunOptions& options) {
  const auto known = core::known_network(core::network_of(network));
  if (!known) return core::of_network(known.error());
  core::SimulateOptions asked;
  core::set_integration(asked, options);
  const core::Watching watching(options.progress);
  auto run = core::run_network(*known, core::given_network, asked, watching.watch());
  if (!run) return core::of_network(run.error());
  core::put_in_arguments(*run);
  return network_simulation_of(*std::move(run));
}

Result<Network> NetworkFit::network() const {
  if (!detail) return Error{Notice{"fit_is_empty"}, "fit"};
  if (detail->fit.values.empty())
    return Error{Notice{"fit_without_values", {{"what", detail->message}}}, "fit"};
  return core::shown({.network = detail->fit.network});
}

Result<NetworkFit> fit(std::span<const double> t, const Channels& channels, const Network& network,
                       const NetworkFitOptions& options) {
  const auto asked = core::network_of(network);
  if (!asked) return core::of_network(asked.error());
  std::vector<std::string> names;
  for (const Mass& mass : network.masses) names.push_back(mass.name);
  const auto recording =
      core::recording_of(t, columns_of(channels, names),
                         asked->network.angles ? Observed::angle : Observed::position, "channels");
  if (!recording) return recording.error();
  return network_fit_of(*recording, *asked, {}, options, true);
}

Result<NetworkFit> fit(const Recording& recording, const Network& network, const NetworkFitOptions& options) {
  if (!recording.detail) return Error{Notice{"recording_is_empty"}, "recording"};
  const auto asked = core::network_of(network);
  if (!asked) return core::of_network(asked.error());
  return network_fit_of(*recording.detail, *asked, recording.options, options, false);
}

Result<Modes> modes(const std::string& file, const ModesOptions& options) {
  const auto asked = modes_task_options(options);
  if (!asked) return asked.error();
  auto found = core::modes_of_file(file, *asked);
  if (!found) return core::in_arguments(found.error());
  return modes_of(*std::move(found), false);
}

Result<Modes> modes(const Network& network, const ModesOptions& options) {
  const auto asked = modes_task_options(options);
  if (!asked) return asked.error();
  const auto known = core::known_network(core::network_of(network));
  if (!known) return core::of_network(known.error());
  auto found = core::network_modes(*known, core::given_network, *asked);
  if (!found) return core::of_network(found.error());
  return modes_of(*std::move(found), false);
}

Result<Modes> modes(std::span<const double> t, const Channels& channels, const ModesOptions& options) {
  const auto recording = core::recording_of(t, columns_of(channels, {}), options.observed, "channels");
  if (!recording) return recording.error();
  const auto asked = modes_task_options(options);
  if (!asked) return asked.error();
  auto found = core::recording_modes(*recording, *asked);
  if (!found) return core::in_arguments(found.error(), true);
  return modes_of(*std::move(found), true);
}

}  // namespace cromer
