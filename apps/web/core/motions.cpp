#include "motions.h"

#include <algorithm>
#include <cstring>

#include "cromer/analysis/energy.h"
#include "cromer/analysis/frequency_response.h"
#include "cromer/documents/described/methods.h"
#include "cromer/documents/json/described.h"
#include "cromer/model/linear_quantities.h"
#include "cromer/run/course.h"
#include "cromer/tasks/simulate/run_effect.h"

namespace cromer::core::page {
namespace {

Json block(std::size_t first, std::size_t count) {
  Json place = Json::array();
  place.push_back(first);
  place.push_back(count);
  Json object;
  object["block"] = std::move(place);
  return object;
}

/// `count` numbers to be written, at the end of the blocks.
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

/// Of the law without drag, friction and cubic stiffness.
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

/// The times of those that ended early are the beginning of the others'.
bool begins_with(const std::vector<double>& all, const std::vector<double>& some) {
  return some.size() <= all.size() && std::equal(some.begin(), some.end(), all.begin());
}

}  // namespace

Json motions_of(const SimulateResult& result) {
  const auto& runs = result.runs;
  const auto longest = std::max_element(runs.begin(), runs.end(), [](const auto& a, const auto& b) {
    return a.trajectory.size() < b.trajectory.size();
  });
  const std::vector<double>& times = longest->trajectory.t;
  std::size_t count = times.size();
  for (const SimulatedRun& run : runs) count += 4 * run.trajectory.size();
  json_blocks().reserve(json_blocks().size() + count);
  const std::size_t first = json_blocks().size();
  kept(times);
  Json document;
  Json& list = document["runs"] = Json::array();
  for (const SimulatedRun& run : runs) {
    const auto& t = run.trajectory.t;
    list.push_back(motion(run, begins_with(times, t) ? block(first, t.size()) : kept(t)));
  }
  document["linear_part"] = linear_part(runs.front().oscillator);
  add_notices(document, result.notices, {});
  return document;
}

}  // namespace cromer::core::page
