// What the document of a fit of a network consists of.
#pragma once

#include "cromer/documents/described/describe.h"
#include "cromer/tasks/network_fit/network_fit.h"

namespace cromer::core {

/// A link of the network.
struct LinkOfFit {
  const FittedNetwork& of;
  std::size_t place;

  const NetworkLink& link() const { return of.asked.network.links[place]; }
};

template <>
struct Described<LinkOfFit> {
  using L = LinkOfFit;
  static constexpr std::string_view name = "LinkOfFit";
  static constexpr auto entries = members(
      field(
          "from", [](const L& l) { return name_of(l.of.asked.network, l.link().from); }, "",
          "a mass, or ground"),
      field(
          "to", [](const L& l) { return name_of(l.of.asked.network, l.link().to); }, "", "a mass, or ground"),
      field(
          "parameters", [](const L& l) { return l.of.found_of(l.place); }, "",
          "what the file leaves open, by its names there"));
};

/// A mass of the network and its column.
struct MassOfFit {
  const FittedNetwork& of;
  std::size_t place;

  Parameter parameter(std::string_view name, Estimate FittedColumn::*which, std::string_view per = "") const {
    const std::string unit = of.asked.network.angles ? "rad" : "m";
    return {std::string(name), of.fit.columns[place].*which, unit + std::string(per)};
  }
};

template <>
struct Described<MassOfFit> {
  using M = MassOfFit;
  static constexpr std::string_view name = "MassOfFit";
  static constexpr auto entries = members(
      field(
          "name", [](const M& m) { return m.of.asked.network.masses[m.place].name; }, "", "its name"),
      field(
          "column", [](const M& m) { return m.of.channels.each[m.place].column; }, "", "its column"),
      field(
          "position", [](const M& m) { return m.parameter("position", &FittedColumn::position); }, "",
          "displacement from rest at the first sample"),
      field(
          "velocity", [](const M& m) { return m.parameter("velocity", &FittedColumn::velocity, "/s"); }, "",
          "at the first sample"),
      field(
          "equilibrium", [](const M& m) { return m.parameter("equilibrium", &FittedColumn::offset); }, "",
          "what the column reads at rest"),
      field(
          "rms", [](const M& m) { return m.of.fit.columns[m.place].rms; }, "m or rad", "of the residuals"),
      field(
          "r_squared", [](const M& m) { return m.of.fit.columns[m.place].explained; }, "",
          "share of the column's variance that the network accounts for"));
};

template <>
struct Described<FittedNetwork> {
  using F = FittedNetwork;
  static constexpr std::string_view name = "NetworkFit";
  static constexpr auto entries = members(
      field("file", &F::file, "", "the recording"),
      field("network", &F::network_file, "", "the network's file"),
      field(
          "run", [](const F& f) { return f.channels.run; }, "", "run of the file, from 1"),
      field(
          "samples", [](const F& f) { return f.channels.t.size(); }, "", "times used"),
      field(
          "from", [](const F& f) { return f.channels.t.front(); }, "s", "first time used")
          .known(),
      field(
          "to", [](const F& f) { return f.channels.t.back(); }, "s", "last time used")
          .known(),
      field(
          "status", [](const F& f) { return cromer::name(f.fit.status); }, "", "how the fit ended"),
      field(
          "iterations", [](const F& f) { return f.fit.iterations; }, "", "of the least squares"),
      field(
          "links",
          [](const F& f) {
            std::vector<LinkOfFit> links;
            for (std::size_t i = 0; i < f.asked.network.links.size(); ++i) links.push_back({f, i});
            return links;
          },
          "", "in the order of the network's file"),
      field(
          "masses",
          [](const F& f) {
            std::vector<MassOfFit> masses;
            for (std::size_t i = 0; i < f.fit.columns.size(); ++i) masses.push_back({f, i});
            return masses;
          },
          "", "in the order of the network's file"),
      field(
          "independent_samples", [](const F& f) { return f.fit.independent_samples; }, "",
          "as many independent samples would tell as much as the correlated residuals of all columns"),
      notices(&F::notices));
};

}  // namespace cromer::core
