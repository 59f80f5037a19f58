// What many small networks do that were made by chance: their modes, and how they move by different methods.
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/model/law.h"
#include "cromer/tasks/modes/modes.h"
#include "cromer/tasks/network/network_file.h"
#include "cromer/tasks/network_run/network_run.h"
#include "tests/support/answers.h"

namespace cromer::core {
namespace CROMER_FILE {

Network some_network(Chance& chance, bool rubs) {
  Network network;
  network.angles = chance.is(0.2);
  const auto n = static_cast<std::size_t>(chance.between(1, 4.5));
  for (std::size_t i = 0; i < n; ++i) {
    NetworkMass mass{.name = "m" + std::to_string(i + 1), .mass = chance.between(0.3, 2)};
    mass.start.x = chance.between(-1, 1);
    mass.start.v = chance.is(0.5) ? 0 : chance.between(-1, 1);
    if (chance.is(0.3)) {
      mass.drive.amplitude = chance.between(0, 4);
      mass.drive.frequency = chance.between(0.2, 6);
      mass.drive.phase = chance.between(-3, 3);
    }
    network.masses.push_back(mass);
  }
  const auto link = [&](std::size_t from, std::size_t to) {
    NetworkLink made{from, to, {.stiffness = chance.between(1, 20)}};
    if (chance.is(0.7)) made.law.damping = chance.between(0, 0.5);
    if (rubs && chance.is(0.5)) made.law.friction = chance.between(0, 0.8);
    if (rubs && made.law.friction > 0 && chance.is(0.4))
      made.law.static_friction = made.law.friction * chance.between(1, 1.5);
    if (chance.is(0.2)) made.law.cubic = chance.between(0, 10);
    if (chance.is(0.1)) made.law.drag = chance.between(0, 0.5);
    if (!rubs && chance.is(0.15)) {
      made.law.hysteresis_stiffness = chance.between(1, 5);
      made.law.hysteresis_beta = 2;
      made.law.hysteresis_gamma = -0.5;
    }
    network.links.push_back(made);
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (i == 0 || chance.is(0.4)) link(ground, i);
    if (i > 0) link(i, i - 1);
    if (i > 1 && chance.is(0.3)) link(0, i);
  }
  return network;
}

void say(Answers& said, const NetworkRun& run) {
  said << run.method << run.step << run.until << static_cast<int>(run.outcome.status) << run.outcome.t
       << static_cast<int>(run.outcome.step) << run.states.t.size() << run.message << run.notices;
  for (const State<double>& last : run.last) said << last.x << last.v;
  if (!run.states.energy.empty()) said << run.states.energy.front() << run.states.energy.back();
  for (const InnerForce& inner : run.states.inner) said << inner.link << inner.force.back();
  if (run.energy) {
    said << run.energy->start << run.energy->end << run.energy->drive << run.energy->taken;
    for (const LinkEnergy& each : run.energy->of_links) said << each.end << each.taken;
  }
  if (const std::vector<double> stored = stored_by(run, 0); !stored.empty()) said << stored.back();
}

TEST(NetworkAnswers, OfRuns) {
  Answers said("tasks/network_runs");
  const char* methods[] = {"euler-cromer", "verlet", "newmark", "rk4", "dormand-prince"};
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Chance chance(seed);
    const Network network = some_network(chance, seed % 2 == 0);
    SimulateOptions options;
    options.method = {methods[seed % 5]};
    if (chance.is(0.8)) options.step = chance.between(0.01, 0.3);
    options.until = chance.between(1, 3);
    options.every = 1 + static_cast<long long>(seed % 3);
    const auto run = run_network(network, "n.toml", options);
    said << static_cast<int>(seed);
    if (run)
      say(said, *run);
    else
      said << run.error().notice;
    said.end_line();
  }
  said.expect_as_before();
}

TEST(NetworkAnswers, OfModes) {
  Answers said("tasks/network_modes");
  const char* methods[] = {"euler-cromer", "verlet", "newmark", "rk4", "generalized-alpha", "exact"};
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Chance chance(seed);
    const Network network = some_network(chance, seed % 4 == 0);
    ModesOptions options;
    options.method = {methods[seed % 6]};
    options.step = chance.between(0.02, 0.6);
    const auto found = network_modes(network, "n.toml", options);
    said << static_cast<int>(seed);
    if (!found) {
      said << found.error().notice;
      said.end_line();
      continue;
    }
    said << found->message << found->notices;
    for (const NaturalMode& mode : found->modes) {
      said << mode.frequency.value << mode.damping_ratio.value << mode.participation.value_or(-1);
      for (const ModeByMethod& by : mode.methods)
        said << by.step << by.frequency().value_or(0) << by.damping_ratio().value_or(0) << by.words
             << by.effect.stable;
    }
    said.end_line();
  }
  said.expect_as_before();
}

/// Which units each number may have, of lengths and of angles.
TEST(NetworkAnswers, OfUnits) {
  Answers said("tasks/network_units");
  const char* units[] = {"",
                         "N",
                         "N m",
                         "N/m",
                         "N m/rad",
                         "N/m^2",
                         "N m/rad^2",
                         "N/m^3",
                         "N/m^5",
                         "kg/s",
                         "N m s",
                         "N m s/rad",
                         "kg/m",
                         "N m s^2",
                         "N s/m^3",
                         "kg",
                         "kg m^2",
                         "N m/rad^3",
                         "N m/rad^5",
                         "N m s^2/rad^2",
                         "N m s/rad^3",
                         "m",
                         "rad",
                         "rad/s",
                         "m/s",
                         "Hz",
                         "mm",
                         "deg"};
  const auto try_each = [&](const std::string& key, bool angles, bool of_mass) {
    int refused = 0;
    Notice last;
    said << key << (angles ? "angles" : "lengths");
    for (const char* unit : units) {
      std::string file = "[[mass]]\nname = \"a\"\n";
      if (key != "mass" && key != "inertia") file += angles ? "inertia = 1\n" : "mass = 1\n";
      const std::string line =
          key + " = \"2 " + unit + "\"\n" + (key == "drive_amplitude" ? "drive_frequency = 0\n" : "");
      file += (of_mass ? line : "") + "[[link]]\nto = \"a\"\nquintic = 1\n" +
              (of_mass || key == "quintic" ? "" : line);
      if (key == "quintic") file.replace(file.find("quintic = 1\n"), 12, line);
      const auto network = read_network(file, "n.toml");
      if (!network) {
        ++refused;
        last = network.error().notice;
        continue;
      }
      const NetworkMass& mass = network->masses[0];
      double sum = mass.mass + mass.start.x + mass.start.v + mass.drive.amplitude + mass.drive.frequency +
                   mass.drive.phase;
      const Oscillator<double>& law = network->links[0].law;
      for_each_term([&]<class T>() {
        for (std::size_t i = 0; i < coefficients_of<T>; ++i) sum += law.*T::template members<double>[i];
      });
      said << "[" + std::string(unit) + "]" << sum + law.static_friction + law.hysteresis_exponent;
    }
    said << "refused" << refused << last;
    said.end_line();
  };
  for (const bool angles : {false, true}) {
    for (const char* key :
         {"mass", "inertia", "position", "velocity", "drive_amplitude", "drive_frequency", "drive_phase"})
      try_each(key, angles, true);
    for (const char* key : {"stiffness", "damping", "drag", "friction", "cubic", "quadratic", "odd_quadratic",
                            "quintic", "van_der_pol", "pendulum", "hysteresis_stiffness", "hysteresis_beta",
                            "hysteresis_gamma", "static_friction", "hysteresis_exponent"})
      try_each(key, angles, false);
  }
  said.expect_as_before();
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
