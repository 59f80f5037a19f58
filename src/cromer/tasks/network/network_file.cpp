#include "cromer/tasks/network/network_file.h"

#include <algorithm>
#include <map>

#include "cromer/base/ascii.h"
#include "cromer/base/nearest.h"
#include "cromer/report/file.h"
#include "cromer/tasks/network/network_table.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {
namespace {

/// One number of a file: its key, where it goes, and its unit. Of an angle a torque per angle may be written
/// with its radians or without.
struct Number {
  std::string key;
  double* target;
  std::string unit{}, with_radians{};
  Range range = Range::any;
};

/// What is wrong with the value, without the name of the option.
Notice reason_of(const Error& error) {
  for (const NoticeValue& value : error.notice.values)
    if (const auto* parts = std::get_if<std::vector<Notice>>(&value.value); parts && value.name == "what")
      return parts->front();
  return error.notice;
}

bool is_open(TomlReader& toml, const std::string& key) {
  if (!toml.has(key)) return false;
  const std::vector<std::string> texts = toml.values(key);
  return texts.size() == 1 && texts.front() == "?";
}

/// Whether a fit may look for the coefficient: what a term without corners in its force is proportional to.
template <class T>
bool may_be_open(std::size_t coefficient) {
  return coefficient == 0 && smooth_terms.has<T>();
}

std::vector<std::string> keys_that_may_be_open() {
  std::vector<std::string> keys;
  for_each_term([&]<class T>() {
    for (std::size_t i = 0; i < coefficients_of<T>; ++i)
      if (may_be_open<T>(i)) keys.push_back(with_underscores(T::coefficients[i].option));
  });
  return keys;
}

/// True if the key is there.
bool take_value(TomlReader& toml, const Number& number) {
  if (!toml.has(number.key)) return false;
  const std::vector<std::string> texts = toml.values(number.key);
  if (texts.size() != 1) {
    toml.fail(number.key, Notice{"key_takes_one_value", {{"key", number.key}}});
    return true;
  }
  if (texts.front() == "?") {
    toml.fail(number.key,
              Notice{"value_cannot_be_open", {{"key", number.key}, {"keys", keys_that_may_be_open()}}});
    return true;
  }
  const Option option{number.key, number.target, number.unit, number.range, "", "", ""};
  Result<void> good = assign(option, texts.front());
  if (!good && !number.with_radians.empty()) {
    Option other = option;
    other.unit = number.with_radians;
    if (assign(other, texts.front())) good = check(option);
  }
  if (!good)
    toml.fail(number.key, Notice{"value_of_key", {{"key", number.key}, {"what", reason_of(good.error())}}});
  return true;
}

struct ReadMass {
  NetworkMass mass{};
  bool angle = false;
  Place place{};
};

ReadMass read_mass(TomlReader& toml) {
  ReadMass read{.place = toml.place()};
  NetworkMass& mass = read.mass;
  if (!toml.has("name"))
    toml.fail(Notice{"mass_without_name"});
  else if (mass.name = toml.text("name"); mass.name.empty() || mass.name == "ground")
    toml.fail("name", Notice{"mass_name_is_no_name", {{"name", mass.name}}});
  for (const char* key : {"mass", "inertia"})
    if (is_open(toml, key)) toml.fail(key, Notice{"mass_is_open", {{"key", key}}});
  const bool weighs = take_value(toml, {"mass", &mass.mass, "kg", "", Range::positive});
  read.angle = take_value(toml, {"inertia", &mass.mass, "kg m^2", "", Range::positive});
  take_value(toml, {"position", &mass.start.x, read.angle ? "rad" : "m"});
  take_value(toml, {"velocity", &mass.start.v, read.angle ? "rad/s" : "m/s"});
  take_value(toml,
             {"drive_amplitude", &mass.drive.amplitude, read.angle ? "N m" : "N", "", Range::not_negative});
  const bool has_frequency =
      take_value(toml, {"drive_frequency", &mass.drive.frequency, "rad/s", "", Range::not_negative});
  take_value(toml, {"drive_phase", &mass.drive.phase, "rad"});
  if (mass.drive.amplitude > 0 && !has_frequency && toml.knows_all())
    toml.fail("drive_amplitude", Notice{"amplitude_without_frequency"});
  if (weighs == read.angle && (weighs || toml.knows_all()))
    toml.fail(Notice{weighs ? "mass_and_inertia" : "mass_or_inertia", {{"name", mass.name}}});
  return read;
}

/// The unit of a coefficient where u is an angle, without and with its radians.
std::string unit_of_torque(const CoefficientInfo& info, bool radians) {
  const int power = radians ? info.length : 0;
  if (info.fitted == FittedAs::not_a_force) return unit_of_powers({{"rad", power}}, Powers::caret);
  return unit_of_powers({{"N", 1}, {"m", 1}, {"s", info.time}, {"rad", power}}, Powers::caret);
}

struct ReadLink {
  NetworkLink link{};
  std::string from{}, to{};
  Place place{};
  std::vector<OpenValue> open{};  ///< their link is not set yet
};

ReadLink read_link(TomlReader& toml, bool angles) {
  ReadLink read{.from = toml.text("from", "ground"), .to = toml.text("to", "ground"), .place = toml.place()};
  bool any = false;
  Oscillator<double>& law = read.link.law;
  for_each_term([&]<class T>() {
    for (std::size_t i = 0; i < coefficients_of<T>; ++i) {
      const CoefficientInfo& info = T::coefficients[i];
      const std::string key = with_underscores(info.option);
      const auto member = T::template members<double>[i];
      double& value = law.*member;
      if (may_be_open<T>(i) && is_open(toml, key)) {
        read.open.push_back({{.member = member, .never_negative = info.sign != Sign::any},
                             key,
                             angles ? unit_of_torque(info, false) : unit_of(info),
                             toml.place_of_key(key)});
        any = true;
        continue;
      }
      // The other coefficients of an inner state shape its force alone.
      const bool there =
          take_value(toml, {key, &value, angles ? unit_of_torque(info, false) : unit_of(info),
                            angles && info.length != 0 ? unit_of_torque(info, true) : "",
                            info.sign == Sign::not_negative ? Range::not_negative : Range::any});
      any = any || (there && i == 0);
    }
  });
  if (!may_be_negative(Viscous::coefficients[0], law_of(law)) && law.damping < 0)
    toml.fail("damping", Notice{"value_of_key",
                                {{"key", "damping"},
                                 {"what", Notice{"must_keep_to",
                                                 {{"rule", constraint(Range::not_negative)},
                                                  {"value", law.damping},
                                                  {"unit", unit_of(Viscous::coefficients[0])}}}}}});
  const std::string force = angles ? "N m" : "N";
  if (take_value(toml, {"static_friction", &law.static_friction, force, "", Range::not_negative}) &&
      law.static_friction < law.friction)
    toml.fail(
        "static_friction",
        Notice{"static_friction_below_friction",
               {{"static_friction", law.static_friction}, {"friction", law.friction}, {"unit", force}}});
  take_value(toml, {"hysteresis_exponent", &law.hysteresis_exponent, "", "", Range::at_least_one});
  if (!any && toml.knows_all()) toml.fail(Notice{"link_without_term"});
  return read;
}

/// The places of the masses by their names, with checks of what holds for all of them.
Result<std::map<std::string, std::size_t>> mass_places(const std::vector<ReadMass>& masses) {
  std::map<std::string, std::size_t> places;
  for (const ReadMass& read : masses) {
    if (!places.emplace(read.mass.name, places.size()).second)
      return read.place.error(Notice{"mass_name_taken", {{"name", read.mass.name}}});
    if (read.angle != masses.front().angle) return read.place.error(Notice{"masses_and_inertias"});
  }
  return places;
}

Result<std::size_t> place_named(const std::string& name, const std::map<std::string, std::size_t>& places,
                                const Place& link) {
  if (name == "ground") return ground;
  if (const auto found = places.find(name); found != places.end()) return found->second;
  std::vector<std::string_view> names{"ground"};
  for (const auto& [known, place] : places) names.push_back(known);
  constexpr std::size_t guess = 3;  // letters, at least
  const std::string near = name.size() < guess ? "" : nearest(name, names);
  constexpr std::size_t few = 8;
  Notice cure;
  if (!near.empty())
    cure = Notice{"perhaps_quoted", {{"near", near}}};
  else if (places.size() <= few)
    cure = Notice{"there_are_masses", {{"names", std::vector<std::string>(names.begin() + 1, names.end())}}};
  return link.error(Notice{"no_such_mass", {{"name", name}, {"near", cure}}});
}

/// The tables of one key, each by `read`. Those that stand in no file have no line: messages number them.
template <class Spec, class Read>
Result<std::vector<Spec>> read_each(const std::vector<const toml::table*>& tables, const std::string& file,
                                    std::string_view key, Read read) {
  std::vector<Spec> specs;
  for (const toml::table* table : tables) {
    const bool in_file = table->source().begin.line > 0;
    const std::string numbered = file + "." + std::string(key) + "[" + std::to_string(specs.size()) + "]";
    auto spec = read_table(*table, in_file ? file : numbered, read);
    if (!spec) return spec.error();
    specs.push_back(*std::move(spec));
  }
  return specs;
}

}  // namespace

bool is_network_file(std::string_view path) { return path.ends_with(".toml"); }

Result<NetworkFile> read_network_file(std::string_view bytes, const std::string& file) {
  const toml::parse_result parsed = toml::parse(bytes, file);
  if (!parsed)
    return is_network_file(file) ? not_toml(parsed, file) : Error{"not_a_network", {{"file", file}}};
  return read_network_table(parsed.table(), file);
}

Result<NetworkFile> read_network_table(const toml::table& table, const std::string& file) {
  struct Tables {
    std::vector<const toml::table*> masses, links;
  };
  const auto tables = read_table(table, file, [](TomlReader& toml) {
    return Tables{toml.tables("mass"), toml.tables("link")};
  });
  if (!tables) return tables.error();
  if (tables->masses.empty()) return Error{"network_without_masses", {{"file", file}}};
  auto masses = read_each<ReadMass>(tables->masses, file, "mass", read_mass);
  if (!masses) return masses.error();
  const auto places = mass_places(*masses);
  if (!places) return places.error();

  NetworkFile whole{.network = {.angles = masses->front().angle}};
  Network& network = whole.network;
  auto links = read_each<ReadLink>(tables->links, file, "link",
                                   [&](TomlReader& toml) { return read_link(toml, network.angles); });
  if (!links) return links.error();
  for (ReadMass& read : *masses) network.masses.push_back(std::move(read.mass));
  std::vector<bool> held(network.masses.size());
  for (ReadLink& read : *links) {
    const auto from = place_named(read.from, *places, read.place),
               to = place_named(read.to, *places, read.place);
    if (!from) return from.error();
    if (!to) return to.error();
    if (*from == *to) return read.place.error(Notice{"link_to_itself", {{"name", read.from}}});
    read.link.from = *from;
    read.link.to = *to;
    for (const std::size_t end : {*from, *to})
      if (end != ground) held[end] = true;
    for (OpenValue& open : read.open) {
      open.value.link = network.links.size();
      whole.open.push_back(std::move(open));
    }
    network.links.push_back(read.link);
  }
  const auto loose = std::find(held.begin(), held.end(), false);
  if (loose != held.end()) {
    const ReadMass& read = (*masses)[static_cast<std::size_t>(loose - held.begin())];
    return read.place.error(
        Notice{"mass_without_link",
               {{"name", network.masses[static_cast<std::size_t>(loose - held.begin())].name}}});
  }
  return whole;
}

Result<NetworkFile> open_network_file(const std::string& path) {
  const auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  return read_network_file(*bytes, path);
}

Result<Network> known_network(Result<NetworkFile> read) {
  if (!read) return read.error();
  if (read->open.empty()) return std::move(read->network);
  const OpenValue& first = read->open.front();
  return first.place.error(Notice{"value_is_open", {{"key", first.key}}});
}

Result<Network> read_network(std::string_view bytes, const std::string& file) {
  return known_network(read_network_file(bytes, file));
}

Result<Network> open_network(const std::string& path) { return known_network(open_network_file(path)); }

Result<void> check_a_column_for_each_mass(const std::vector<std::string>& columns, const Network& network,
                                          const std::string& file) {
  if (columns.size() != network.masses.size())
    return Error{
        "columns_for_masses",
        {{"file", file}, {"columns", columns.size()}, {"names", columns}, {"masses", network.masses.size()}}};
  // "left (rad)", or "left x (rad)" as a run writes it.
  const auto is_named = [](std::string_view column, std::string_view mass) {
    const std::string_view name = column.substr(0, column.rfind(" ("));
    return name == mass || (name.starts_with(mass) && (name.substr(mass.size()) == " x"));
  };
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = 0; j < columns.size(); ++j)
      if (is_named(columns[i], network.masses[j].name) && !is_named(columns[i], network.masses[i].name))
        return Error{"columns_in_another_order",
                     {{"file", file},
                      {"column", columns[i]},
                      {"mass", network.masses[j].name},
                      {"place", network.masses[i].name}}};
  return {};
}

}  // namespace cromer::core
