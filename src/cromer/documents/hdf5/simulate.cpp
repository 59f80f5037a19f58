#include "cromer/documents/hdf5/simulate.h"
#include "cromer/documents/words/words.h"

#include <fmt/format.h>

#include "cromer/analysis/energy.h"
#include "cromer/documents/json/documents.h"
#include "cromer/version.h"

namespace cromer::core {

std::vector<Hdf5Table> simulate_tables(const SimulateResult& result, const std::string& command) {
  std::vector<Hdf5Table> tables(1);
  tables[0].texts = {
      {"description", to_json(result, false)}, {"program", "cromer " CROMER_VERSION}, {"command", command}};
  if (result.options.sensor.used)
    tables[0].texts.emplace_back("synthetic", "a simulated motion sensor, not a measurement");
  for (const SimulatedRun& run : result.runs) {
    Hdf5Table& table = tables.emplace_back();
    table.name = fmt::format("run_{}", tables.size() - 1);
    table.texts = {{"method", run.method}, {"label", run.label}};
    if (!run.message.empty()) table.texts.emplace_back("message", in_words(run.message));
    std::vector<double> energies;
    for (std::size_t n = 0; n < run.trajectory.size(); ++n)
      energies.push_back(energy(run.oscillator, State<double>{run.trajectory.x[n], run.trajectory.v[n]}));
    const auto add = [&](const char* name, std::vector<double> values) {
      table.columns.push_back(
          {.name = name, .values = std::move(values), .shape = {}, .axes = name[0] == 't' ? "" : "t"});
    };
    add("t (s)", run.trajectory.t);
    add("x (m)", run.trajectory.x);
    add("v (m/s)", run.trajectory.v);
    add("energy (J)", std::move(energies));
    add("sensor (m)", run.sensor);
  }
  return tables;
}

}  // namespace cromer::core
