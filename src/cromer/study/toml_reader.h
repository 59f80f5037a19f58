// Typed look at a TOML table that remembers which keys were asked for, so that the others can be called
// wrong.
#pragma once

#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/result.h"
#include "cromer/study/study_file.h"

namespace cromer::core {

/// The first error stays; later ones are dropped. Ask for everything, then call finish().
class TomlReader {
 public:
  TomlReader(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

  std::string text(std::string_view key, std::string otherwise = "");
  /// One of the names; the first where the key is not there.
  std::string choice(std::string_view key, std::initializer_list<std::string_view> names);
  double number(std::string_view key, double otherwise);
  int whole(std::string_view key, int otherwise);
  bool yes(std::string_view key);
  std::vector<std::string> texts(std::string_view key);
  std::vector<int> wholes(std::string_view key);
  /// A TOML value as the text that the command line would take: 0.2, "217.6 g", true.
  std::vector<std::string> values(std::string_view key);
  std::optional<double> maybe_number(std::string_view key);
  /// Tables of an array of tables (or none).
  std::vector<const toml::table*> tables(std::string_view key);
  /// An array of arrays of texts.
  std::vector<std::vector<std::string>> rows(std::string_view key);

  bool has(std::string_view key);
  std::vector<std::string> keys() const;
  Place place() const { return place_of(table_); }
  Place place_of(const toml::node& node) const;
  /// Of the value of a key that is there.
  Place place_of_key(std::string_view key) const { return place_of(*table_.get(key)); }
  void fail(const toml::node& node, const Notice& what);
  /// The first error, or that a key is none of those asked for.
  Result<void> finish() const;

 private:
  const toml::node* find(std::string_view key);

  const toml::table& table_;
  std::string file_;
  std::vector<std::string> asked_;
  std::optional<Error> error_;
};

}  // namespace cromer::core
