#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "cromer/documents/described/modes.h"
#include "cromer/documents/described/network_fit.h"
#include "cromer/documents/described/network_run.h"
#include "cromer/study/collect.h"
#include "cromer/study/facts.h"

namespace cromer::core {
namespace {

/// "floor 1" as a part of a result's name: "floor_1".
std::string as_part_of_name(std::string_view name) {
  std::string part(name);
  for (char& c : part)
    if (static_cast<unsigned char>(c) < 0x80 && !std::isalnum(static_cast<unsigned char>(c)) && c != '-')
      c = '_';
  return part;
}

/// The largest value of a column, and where it stands.
void collect_peak(const std::string& name, const std::vector<double>& t, const std::vector<double>& values,
                  std::string_view unit, Results& results) {
  const auto size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto largest = std::max_element(values.begin(), values.end(), size);
  results.set(name + "peak", std::abs(*largest), unit);
  results.set(name + "peak_t", t[static_cast<std::size_t>(largest - values.begin())], "s");
}

void collect_mass(const std::string& name, const NetworkRun& run, std::size_t i, Results& results) {
  const NetworkStates& kept = run.states;
  const bool angles = run.network.angles;
  // Kinetic energy, and what its links to the ground store.
  std::vector<double> energy(kept.t.size());
  for (std::size_t n = 0; n < kept.t.size(); ++n)
    energy[n] = run.network.masses[i].mass * kept.v[i][n] * kept.v[i][n] / 2;
  for (std::size_t l = 0; l < run.network.links.size(); ++l) {
    const NetworkLink& link = run.network.links[l];
    if (!(link.from == ground && link.to == i) && !(link.from == i && link.to == ground)) continue;
    const std::vector<double> stored = stored_by(run, l);
    for (std::size_t n = 0; n < kept.t.size(); ++n) energy[n] += stored[n];
  }
  collect_peak(name + ".", kept.t, kept.x[i], angles ? "rad" : "m", results);
  collect_peak(name + ".energy_", kept.t, energy, "J", results);
  results.set(name + ".x_end", run.last[i].x, angles ? "rad" : "m");
  results.set(name + ".v_end", run.last[i].v, angles ? "rad/s" : "m/s");
  results.set_column(name + ".t", kept.t, "s", "time *t*");
  results.set_column(name + ".x", kept.x[i], angles ? "rad" : "m", angles ? "angle *x*" : "position *x*");
  results.set_column(name + ".v", kept.v[i], angles ? "rad/s" : "m/s",
                     angles ? "angular velocity *v*" : "velocity *v*");
  results.set_column(name + ".energy", std::move(energy), "J", "energy *E*");
}

/// Facts with the units of lengths or of angles.
Facts network_facts(bool angles, Results& results) {
  return Facts(results, [angles](std::string_view unit) -> std::string_view {
    if (unit == "m or rad") return angles ? "rad" : "m";
    if (unit == "m/s or rad/s") return angles ? "rad/s" : "m/s";
    return unit;
  });
}

}  // namespace

void collect(const std::string& id, const std::vector<NetworkRun>& runs, Results& results) {
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const NetworkRun& run = runs[r];
    const std::string name = id + "." + std::to_string(r + 1);
    network_facts(run.network.angles, results).set(name, NetworkDocument{run, false});
    results.set(name + ".label", run.method);
    for (std::size_t i = 0; i < run.network.masses.size(); ++i)
      collect_mass(name + "." + as_part_of_name(run.network.masses[i].name), run, i, results);
    for (std::size_t l = 0; l < run.network.links.size(); ++l) {
      const std::string link = name + ".links." + std::to_string(l + 1);
      std::vector<double> stored = stored_by(run, l);
      collect_peak(link + ".energy_", run.states.t, stored, "J", results);
      results.set_column(link + ".t", run.states.t, "s", "time *t*");
      results.set_column(link + ".energy", std::move(stored), "J", "energy *E*");
    }
    results.set_column(name + ".t", run.states.t, "s", "time *t*");
    results.set_column(name + ".energy", run.states.energy, "J", "energy *E*");
  }
}

void collect(const std::string& id, const FittedNetwork& fitted, Results& results) {
  const Network& network = fitted.asked.network;
  const std::string_view unit = network.angles ? "rad" : "m";
  const Facts facts = network_facts(network.angles, results);
  facts.set(id, fitted);
  results.set_column(id + ".t", fitted.channels.t, "s", "time *t*");
  for (std::size_t i = 0; i < network.masses.size(); ++i) {
    const std::string mass = id + "." + as_part_of_name(network.masses[i].name);
    const std::vector<double>& measured = fitted.channels.each[i].y;
    results.set_column(mass + ".measured", measured, unit, network.angles ? "angle *x*" : "position *x*");
    if (i >= fitted.fit.columns.size()) continue;
    const FittedColumn& column = fitted.fit.columns[i];
    facts.set(mass + ".position", column.position, unit);
    facts.set(mass + ".velocity", column.velocity, network.angles ? "rad/s" : "m/s");
    facts.set(mass + ".equilibrium", column.offset, unit);
    results.set(mass + ".rms", column.rms, unit);
    results.set(mass + ".r_squared", column.explained);
    const std::vector<double>& residual = column.residual;
    std::vector<double> curve(residual.size());
    for (std::size_t n = 0; n < curve.size(); ++n) curve[n] = measured[n] - residual[n];
    results.set_column(mass + ".fitted", std::move(curve), unit,
                       network.angles ? "angle *x*" : "position *x*");
    results.set_column(mass + ".residual", residual, unit, "residual");
  }
}

void collect(const std::string& id, const ModesResult& found, Results& results) {
  const Facts facts(results, [](std::string_view unit) { return unit; });
  std::vector<double> number, frequency, damping_ratio;
  for (std::size_t j = 0; j < found.modes.size(); ++j) {
    const NaturalMode& mode = found.modes[j];
    const std::string name = id + "." + std::to_string(j + 1);
    facts.set(name + ".frequency", mode.frequency, "Hz");
    results.set(name + ".period", 1 / mode.frequency.value, "s");
    facts.set(name + ".damping_ratio", mode.damping_ratio, "");
    if (mode.participation) results.set(name + ".participation", *mode.participation);
    for (std::size_t i = 0; i < found.names.size(); ++i) {
      const std::string mass = name + "." + as_part_of_name(found.names[i]);
      // With a sign where it swings in or against the phase of the largest.
      results.set(mass, std::abs(mode.shape[i]) * (mode.shape[i].real() < 0 ? -1 : 1));
      results.set(mass + ".phase", std::arg(mode.shape[i]), "rad");
    }
    if (mode.of_network) {
      facts.set(name + ".of_network", *mode.of_network);
      results.set(name + ".of_network.frequency_error",
                  mode.of_network->frequency / mode.frequency.value - 1);
    }
    for (std::size_t m = 0; m < mode.methods.size(); ++m) {
      const ModeByMethod& by = mode.methods[m];
      const std::string method = name + ".methods." + std::to_string(m + 1);
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      results.set(method + ".label", by.method);
      results.set(method + ".frequency", by.frequency().value_or(none), "Hz");
      results.set(method + ".frequency_error", by.frequency().value_or(none) / mode.frequency.value - 1);
      results.set(method + ".damping_ratio", by.damping_ratio().value_or(none));
    }
    number.push_back(static_cast<double>(j + 1));
    frequency.push_back(mode.frequency.value);
    damping_ratio.push_back(mode.damping_ratio.value);
  }
  results.set(id + ".modes", static_cast<double>(found.modes.size()));
  if (const auto beat = beat_of(found)) {
    facts.set(id + ".beat_frequency", beat->frequency, "Hz");
    facts.set(id + ".beat_period", beat->period, "s");
    facts.set(id + ".coupling", beat->coupling, "");
  }
  results.set_column(id + ".mode", std::move(number), "", "mode");
  results.set_column(id + ".frequency", std::move(frequency), "Hz", "frequency *f*");
  results.set_column(id + ".damping_ratio", std::move(damping_ratio), "", "damping ratio");
}

}  // namespace cromer::core
