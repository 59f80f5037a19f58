#include "cromer/read/toml_reader.h"

#include <algorithm>

#include "cromer/base/nearest.h"
#include "cromer/base/quantity.h"

namespace cromer::core {

std::optional<std::string> as_option_text(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
  if (const auto* number = node.as_floating_point()) return shortest(number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  return std::nullopt;
}

const toml::node* TomlReader::find(std::string_view key) {
  asked_.emplace_back(key);
  return table_.get(key);
}

Place TomlReader::place_of(const toml::node& node) const {
  const auto begin = node.source().begin;
  return Place{file_, begin.line, begin.column};
}

void TomlReader::fail(const toml::node& node, const Notice& what) {
  if (!error_) error_ = place_of(node).error(what);
}

bool TomlReader::has(std::string_view key) { return find(key) != nullptr; }

bool TomlReader::knows_all() const {
  return std::all_of(table_.begin(), table_.end(), [&](const auto& entry) {
    return std::find(asked_.begin(), asked_.end(), entry.first.str()) != asked_.end();
  });
}

std::vector<std::string> TomlReader::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, node] : table_) names.emplace_back(key.str());
  return names;
}

std::string TomlReader::text(std::string_view key, std::string otherwise) {
  const toml::node* node = find(key);
  if (!node) return otherwise;
  if (const auto* value = node->as_string()) return value->get();
  fail(*node, Notice{"key_takes_text", {{"key", key}}});
  return otherwise;
}

std::string TomlReader::choice(std::string_view key, std::initializer_list<std::string_view> names) {
  const std::string value = text(key, std::string(*names.begin()));
  if (std::find(names.begin(), names.end(), value) != names.end()) return value;
  fail(*table_.get(key),
       Notice{"key_is_one_of",
              {{"key", key}, {"names", std::vector<std::string>(names.begin(), names.end())}}});
  return std::string(*names.begin());
}

double TomlReader::number(std::string_view key, double otherwise) {
  return maybe_number(key).value_or(otherwise);
}

std::optional<double> TomlReader::maybe_number(std::string_view key) {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  if (const auto value = node->value<double>()) return value;
  fail(*node, Notice{"key_takes_number", {{"key", key}}});
  return std::nullopt;
}

int TomlReader::whole(std::string_view key, int otherwise) {
  const toml::node* node = find(key);
  if (!node) return otherwise;
  if (const auto value = node->value_exact<std::int64_t>();
      value && *value >= -1'000'000 && *value <= 1'000'000)
    return static_cast<int>(*value);
  fail(*node, Notice{"key_takes_whole_number", {{"key", key}}});
  return otherwise;
}

bool TomlReader::yes(std::string_view key) {
  const toml::node* node = find(key);
  if (!node) return false;
  if (const auto value = node->value_exact<bool>()) return *value;
  fail(*node, Notice{"key_takes_true_or_false", {{"key", key}}});
  return false;
}

std::vector<std::string> TomlReader::values(std::string_view key) {
  const toml::node* node = find(key);
  if (!node) return {};
  if (const auto single = as_option_text(*node)) return {*single};
  std::vector<std::string> texts;
  if (const auto* array = node->as_array()) {
    for (const toml::node& element : *array) {
      const auto text = as_option_text(element);
      if (!text)
        fail(element, Notice{"key_takes_numbers_or_texts", {{"key", key}}});
      else
        texts.push_back(*text);
    }
  } else {
    fail(*node, Notice{"key_takes_one_or_several", {{"key", key}}});
  }
  return texts;
}

std::vector<int> TomlReader::wholes(std::string_view key) {
  constexpr int most = 1000;
  std::vector<int> numbers;
  const toml::node* node = find(key);
  if (!node) return numbers;
  if (const auto* array = node->as_array()) {
    for (const toml::node& element : *array) {
      const auto value = element.value_exact<std::int64_t>();
      if (!value || *value < 0 || *value > most)
        fail(element, Notice{"key_takes_counts", {{"key", key}, {"most", most}}});
      else
        numbers.push_back(static_cast<int>(*value));
    }
  } else {
    fail(*node, Notice{"key_takes_whole_numbers", {{"key", key}}});
  }
  return numbers;
}

std::vector<const toml::table*> TomlReader::tables(std::string_view key) {
  std::vector<const toml::table*> found;
  const toml::node* node = find(key);
  if (!node) return found;
  const auto* array = node->as_array();
  if (!array) {
    fail(*node, Notice{"key_is_list_of_tables_so", {{"key", key}}});
    return found;
  }
  for (const toml::node& element : *array) {
    if (const auto* table = element.as_table())
      found.push_back(table);
    else
      fail(element, Notice{"key_is_list_of_tables", {{"key", key}}});
  }
  return found;
}

std::vector<std::vector<std::string>> TomlReader::rows(std::string_view key) {
  std::vector<std::vector<std::string>> all;
  const toml::node* node = find(key);
  if (!node) return all;
  const auto* array = node->as_array();
  if (!array) {
    fail(*node, Notice{"key_takes_rows", {{"key", key}}});
    return all;
  }
  for (const toml::node& element : *array) {
    const auto* row = element.as_array();
    if (!row) {
      fail(element, Notice{"row_is_list"});
      continue;
    }
    auto& cells = all.emplace_back();
    for (const toml::node& cell : *row) {
      const auto text = as_option_text(cell);
      if (!text)
        fail(cell, Notice{"cell_is_text_or_number"});
      else
        cells.push_back(*text);
    }
  }
  return all;
}

Result<void> TomlReader::finish() const {
  if (error_) return *error_;
  for (const auto& [key, node] : table_) {
    if (std::find(asked_.begin(), asked_.end(), key.str()) != asked_.end()) continue;
    const std::vector<std::string_view> known(asked_.begin(), asked_.end());
    const std::string near = nearest(key.str(), known);
    return place_of(node).error(
        Notice{"key_not_known",
               {{"key", key.str()},
                {"near", near.empty() ? Notice{} : Notice{"perhaps_quoted", {{"near", near}}}}}});
  }
  return {};
}

Error not_toml(const toml::parse_result& parsed, const std::string& file) {
  const auto begin = parsed.error().source().begin;
  return Place{file, begin.line, begin.column}.error(
      Notice{"not_toml", {{"why", parsed.error().description()}}});
}

}  // namespace cromer::core
