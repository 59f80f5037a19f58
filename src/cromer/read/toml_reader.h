// Typed values from TOML, with the place of each in the file, for messages.
#pragma once

#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#include <toml++/impl/forward_declarations.h>
// toml++ 3.3 takes it as given that behind "[" stands a key, and that outside quotes no letter between U+00A1
// and U+0499 occurs, such as ±; a compiler may rely on both. A user may write anything.
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT_ASSUME(expr) static_assert(true)
#pragma push_macro("TOML_UNREACHABLE")
#undef TOML_UNREACHABLE
#define TOML_UNREACHABLE return false
#include <toml++/impl/unicode.h>
#pragma pop_macro("TOML_UNREACHABLE")
#include <toml++/toml.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cromer/read/place.h"
#include "cromer/result.h"

namespace cromer::core {

/// Reads typed values from a TOML table. It remembers the keys that were asked for; finish() reports all
/// others. Only the first error is kept.
class TomlReader {
 public:
  TomlReader(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

  std::string text(std::string_view key, std::string otherwise = "");
  /// One of the names; the first if the key is missing.
  std::string choice(std::string_view key, std::initializer_list<std::string_view> names);
  double number(std::string_view key, double otherwise);
  int whole(std::string_view key, int otherwise);
  bool yes(std::string_view key);
  std::vector<int> wholes(std::string_view key);
  /// A value, or a list of them, as texts for options: 0.2, "217.6 g", true.
  std::vector<std::string> values(std::string_view key);
  std::optional<double> maybe_number(std::string_view key);
  /// The tables of an array of tables; empty if the key is missing.
  std::vector<const toml::table*> tables(std::string_view key);
  /// An array of arrays, as texts.
  std::vector<std::vector<std::string>> rows(std::string_view key);

  bool has(std::string_view key);
  /// Every key was asked for. Where one was not, what seems to be missing may be there, misspelt.
  bool knows_all() const;
  std::vector<std::string> keys() const;
  Place place() const { return place_of(table_); }
  Place place_of(const toml::node& node) const;
  /// The place of a value whose key exists.
  Place place_of_key(std::string_view key) const { return place_of(*table_.get(key)); }
  void fail(const toml::node& node, const Notice& what);
  /// At the table itself, and at a key that exists.
  void fail(const Notice& what) { fail(table_, what); }
  void fail(std::string_view key, const Notice& what) { fail(*table_.get(key), what); }
  /// The first error, or an Error for a key that was never asked for.
  Result<void> finish() const;

 private:
  const toml::node* find(std::string_view key);

  const toml::table& table_;
  std::string file_;
  std::vector<std::string> asked_;
  std::optional<Error> error_;
};

/// A value as the command line would take it; empty for tables and arrays.
std::optional<std::string> as_option_text(const toml::node& node);

/// Why it is no TOML.
Error not_toml(const toml::parse_result& parsed, const std::string& file);

/// Reads one table by a function of a TomlReader.
template <class Read>
auto read_table(const toml::table& table, const std::string& file, Read read)
    -> Result<decltype(read(std::declval<TomlReader&>()))> {
  TomlReader reader(table, file);
  auto value = read(reader);
  if (const auto finished = reader.finish(); !finished) return finished.error();
  return value;
}

/// Reads all tables of a list, up to the first Error.
template <class Spec, class Read>
Result<std::vector<Spec>> read_tables(const std::vector<const toml::table*>& tables, const std::string& file,
                                      Read read) {
  std::vector<Spec> specs;
  for (const toml::table* table : tables) {
    auto spec = read_table(*table, file, read);
    if (!spec) return spec.error();
    specs.push_back(std::move(*spec));
  }
  return specs;
}

/// Reads the tables within a table; `error` keeps their first Error.
template <class Spec, class Read>
std::vector<Spec> inner_tables(TomlReader& toml, const std::string& file, std::string_view key, Read read,
                               std::optional<Error>& error) {
  auto specs = read_tables<Spec>(toml.tables(key), file, read);
  if (specs) return std::move(*specs);
  if (!error) error = specs.error();
  return {};
}

}  // namespace cromer::core
