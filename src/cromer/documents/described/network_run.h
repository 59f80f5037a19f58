// What the document of a run of a network consists of.
#pragma once

#include "cromer/documents/described/describe.h"
#include "cromer/documents/described/simulate.h"
#include "cromer/tasks/network_run/network_run.h"

namespace cromer::core {

/// With or without the kept states.
struct NetworkDocument {
  const NetworkRun& run;
  bool with_states = false;
};

/// A mass of the run.
struct MassOfRun {
  NetworkDocument of;
  std::size_t place;

  std::optional<std::vector<double>> kept(const std::vector<std::vector<double>>& states) const {
    return of.with_states ? std::optional(states[place]) : std::nullopt;
  }
};

template <>
struct Described<MassOfRun> {
  using M = MassOfRun;
  static constexpr std::string_view name = "MassOfRun";
  static constexpr auto entries = members(
      field(
          "name", [](const M& m) { return m.of.run.network.masses[m.place].name; }, "", "its name"),
      field(
          "x", [](const M& m) { return m.of.run.last[m.place].x; }, "m or rad", "position at the end"),
      field(
          "v", [](const M& m) { return m.of.run.last[m.place].v; }, "m/s or rad/s", "velocity at the end"),
      field(
          "positions", [](const M& m) { return m.kept(m.of.run.states.x); }, "m or rad",
          "at the kept times; only in files")
          .left_out(),
      field(
          "velocities", [](const M& m) { return m.kept(m.of.run.states.v); }, "m/s or rad/s",
          "at the kept times; only in files")
          .left_out());
};

/// A link of the run.
struct LinkOfRun {
  NetworkDocument of;
  std::size_t place;

  std::string end(std::size_t NetworkLink::*which) const {
    return name_of(of.run.network, of.run.network.links[place].*which);
  }
  std::optional<double> of_energy(double LinkEnergy::*number) const {
    return of.run.energy ? std::optional(of.run.energy->of_links[place].*number) : std::nullopt;
  }
};

template <>
struct Described<LinkOfRun> {
  using L = LinkOfRun;
  static constexpr std::string_view name = "LinkOfRun";
  static constexpr auto entries =
      members(field(
                  "from", [](const L& l) { return l.end(&NetworkLink::from); }, "", "a mass, or ground"),
              field(
                  "to", [](const L& l) { return l.end(&NetworkLink::to); }, "", "a mass, or ground"),
              field(
                  "energy", [](const L& l) { return l.of_energy(&LinkEnergy::end); }, "J",
                  "stored at the end, hysteresis apart; null if the kept states are not dense enough"),
              field(
                  "taken", [](const L& l) { return l.of_energy(&LinkEnergy::taken); }, "J",
                  "energy that its resistances and its friction took, and the work against hysteresis; null "
                  "likewise"));
};

template <>
struct Described<NetworkDocument> {
  using D = NetworkDocument;
  static constexpr std::string_view name = "NetworkRun";
  static constexpr auto entries = members(
      field(
          "file", [](const D& d) { return d.run.file; }, "", "the network's file"),
      field(
          "method", [](const D& d) { return d.run.method; }, "", "name, as typed"),
      field(
          "step", [](const D& d) { return d.run.step; }, "s", "time step, or spacing of the states")
          .known(),
      field(
          "until", [](const D& d) { return d.run.until; }, "s", "end asked for")
          .known(),
      field(
          "status", [](const D& d) { return cromer::name(d.run.outcome.status); }, "", "how it ended"),
      field(
          "t_end", [](const D& d) { return d.run.outcome.t; }, "s", "time of the last state")
          .known(),
      group(
          "counts", "the work of the run",
          members(field(
                      "accepted", [](const D& d) { return d.run.outcome.counts.accepted; }, "", "steps"),
                  field(
                      "rejected", [](const D& d) { return d.run.outcome.counts.rejected; }, "",
                      "steps that were repeated"),
                  field(
                      "evaluations", [](const D& d) { return d.run.outcome.counts.evaluations; }, "",
                      "evaluations of all accelerations"),
                  field(
                      "newton_iterations", [](const D& d) { return d.run.outcome.counts.newton_iterations; },
                      "", "Newton iterations"))),
      field(
          "masses",
          [](const D& d) {
            std::vector<MassOfRun> masses;
            for (std::size_t i = 0; i < d.run.network.masses.size(); ++i) masses.push_back({d, i});
            return masses;
          },
          "", "in the order of the file"),
      field(
          "links",
          [](const D& d) {
            std::vector<LinkOfRun> links;
            for (std::size_t i = 0; i < d.run.network.links.size(); ++i) links.push_back({d, i});
            return links;
          },
          "", "in the order of the file"),
      group_if(
          "energy", "where the energy came from and went; null if the kept states are not dense enough",
          [](const D& d) { return d.run.energy.has_value(); },
          members(field(
                      "start", [](const D& d) { return d.run.energy->start; }, "J", "stored at the start"),
                  field(
                      "end", [](const D& d) { return d.run.energy->end; }, "J", "stored at the end"),
                  field(
                      "drive", [](const D& d) { return d.run.energy->drive; }, "J", "work of the drives"),
                  field(
                      "taken", [](const D& d) { return d.run.energy->taken; }, "J", "taken by all links"),
                  field(
                      "method", [](const D& d) { return d.run.energy->method(); }, "J",
                      "made (+) or lost (-) by the method itself"))),
      field(
          "times", [](const D& d) { return d.with_states ? std::optional(d.run.states.t) : std::nullopt; },
          "s", "of the kept states; only in files")
          .left_out(),
      field(
          "energies",
          [](const D& d) { return d.with_states ? std::optional(d.run.states.energy) : std::nullopt; }, "J",
          "of all masses and links at these times; only in files")
          .left_out(),
      notices([](const D& d) { return d.run.notices; }));
};

}  // namespace cromer::core
