#include "cromer/door/network_of.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "cromer/base/ascii.h"
#include "cromer/model/law.h"
#include "cromer/tasks/network/network_table.h"

namespace cromer::core {
namespace {

toml::table table_of(const Mass& mass) {
  toml::table table;
  table.insert("name", mass.name);
  if (mass.mass) table.insert("mass", *mass.mass);
  if (mass.inertia) table.insert("inertia", *mass.inertia);
  table.insert("position", mass.position);
  table.insert("velocity", mass.velocity);
  table.insert("drive_amplitude", mass.drive.amplitude);
  table.insert("drive_frequency", mass.drive.frequency);
  table.insert("drive_phase", mass.drive.phase);
  return table;
}

/// An Error names a term that stands twice.
Result<toml::table> table_of(const Link& link) {
  toml::table table;
  table.insert("from", link.from);
  table.insert("to", link.to);
  for (const LinkTerm& term : link.terms) {
    const bool fresh =
        term.value ? table.insert(term.name, *term.value).second : table.insert(term.name, "?").second;
    if (!fresh) return Error{Notice{"term_given_twice", {{"term", term.name}}}, given_network};
  }
  return table;
}

/// What the request has at `key`. Structures within structures below `depth` are left out.
void put(toml::table& table, const std::string& key, const nlohmann::json& value, int depth);
void put(toml::array& array, const nlohmann::json& value, int depth);

/// The value as `take` gets it: a text, a number, a table or a list.
template <class Take>
void with_node(const nlohmann::json& value, int depth, const Take& take) {
  if (value.is_string()) return take(value.get<std::string>());
  if (value.is_boolean()) return take(value.get<bool>());
  if (value.is_number_integer()) return take(value.get<std::int64_t>());
  if (value.is_number()) return take(value.get<double>());
  if (value.is_object()) {
    toml::table inner;
    for (const auto& item : value.items())
      if (depth > 0) put(inner, item.key(), item.value(), depth - 1);
    return take(std::move(inner));
  }
  if (value.is_array()) {
    toml::array inner;
    for (const nlohmann::json& each : value)
      if (depth > 0) put(inner, each, depth - 1);
    take(std::move(inner));
  }
}

void put(toml::table& table, const std::string& key, const nlohmann::json& value, int depth) {
  with_node(value, depth, [&](auto&& node) { table.insert(key, std::forward<decltype(node)>(node)); });
}

void put(toml::array& array, const nlohmann::json& value, int depth) {
  with_node(value, depth, [&](auto&& node) { array.push_back(std::forward<decltype(node)>(node)); });
}

/// The terms of a link's law that it has, and those that are open.
std::vector<LinkTerm> terms_of(const NetworkFile& network, std::size_t link) {
  const Oscillator<double>& law = network.network.links[link].law;
  std::vector<LinkTerm> terms;
  for (const OpenValue& open : network.open)
    if (open.value.link == link) terms.push_back({open.key, sought});
  const auto add = [&](std::string_view option, double value, double where_absent) {
    if (value != where_absent) terms.push_back({with_underscores(option), value});
  };
  for_each_term([&]<class T>() {
    for (std::size_t i = 0; i < coefficients_of<T>; ++i)
      add(T::coefficients[i].option, law.*(T::template members<double>[i]), 0);
  });
  add("static_friction", law.static_friction, 0);
  add("hysteresis_exponent", law.hysteresis_exponent, 1);
  if (terms.empty()) terms.push_back({"stiffness", 0.0});
  return terms;
}

}  // namespace

Result<NetworkFile> network_of(const cromer::Network& network) {
  toml::array masses, links;
  for (const Mass& mass : network.masses) masses.push_back(table_of(mass));
  for (const Link& link : network.links) {
    auto table = table_of(link);
    if (!table) return table.error();
    links.push_back(*std::move(table));
  }
  toml::table whole;
  whole.insert("mass", std::move(masses));
  whole.insert("link", std::move(links));
  return read_network_table(whole, given_network);
}

Result<NetworkFile> network_of(const nlohmann::json& request) {
  if (request.is_string()) return open_network_file(request.get<std::string>());
  if (!request.is_object()) return Error{Notice{"network_is_object"}, given_network};
  constexpr int depth = 4;  // of a list within a mass
  toml::table whole;
  for (const auto& item : request.items()) put(whole, item.key(), item.value(), depth);
  return read_network_table(whole, given_network);
}

cromer::Network shown(const NetworkFile& file) {
  const Network& network = file.network;
  std::vector<Mass> masses;
  for (const NetworkMass& each : network.masses) {
    Mass& mass =
        masses.emplace_back(Mass{.name = each.name,
                                 .position = each.start.x,
                                 .velocity = each.start.v,
                                 .drive = {each.drive.amplitude, each.drive.frequency, each.drive.phase}});
    (network.angles ? mass.inertia : mass.mass) = each.mass;
  }
  std::vector<Link> links;
  for (std::size_t i = 0; i < network.links.size(); ++i)
    links.push_back({.from = name_of(network, network.links[i].from),
                     .to = name_of(network, network.links[i].to),
                     .terms = terms_of(file, i)});
  return {std::move(masses), std::move(links)};
}

}  // namespace cromer::core
