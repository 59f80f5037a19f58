// A JSON value that can only be written. The page's core has it in place of a JSON library.
//
// It has the part of nlohmann's ordered_json that documents/json uses. Long lists of numbers are not written
// as text but into a block of numbers beside it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace cromer::core {

/// The numbers of all documents since they were last cleared.
std::vector<double>& json_blocks();

class JsonValue {
 public:
  JsonValue(std::nullptr_t = nullptr) {}                                         // NOLINT: as nlohmann's
  JsonValue(bool truth) : kind_(Kind::word), text_(truth ? "true" : "false") {}  // NOLINT
  JsonValue(double number) : kind_(Kind::number), number_(number) {}             // NOLINT
  template <class Integer, std::enable_if_t<std::is_integral_v<Integer>, int> = 0>
  JsonValue(Integer number) : kind_(Kind::word), text_(std::to_string(number)) {}       // NOLINT
  JsonValue(std::string text) : kind_(Kind::text), text_(std::move(text)) {}            // NOLINT
  JsonValue(std::string_view text) : kind_(Kind::text), text_(text) {}                  // NOLINT
  JsonValue(const char* text) : kind_(Kind::text), text_(text) {}                       // NOLINT
  JsonValue(const std::vector<double>& numbers) : kind_(Kind::list), block_(numbers) {  // NOLINT
    is_block_ = true;
  }
  JsonValue(const std::vector<std::string>& texts) : kind_(Kind::list) {  // NOLINT
    for (const std::string& text : texts) items_.emplace_back("", text);
  }
  /// An object if all items are pairs that begin with a text, else a list.
  JsonValue(std::initializer_list<JsonValue> list);  // NOLINT

  static JsonValue array() { return of(Kind::list); }
  static JsonValue object() { return of(Kind::object); }

  /// The member of that name; it is added if it is missing.
  JsonValue& operator[](std::string_view name);
  void push_back(JsonValue value);
  JsonValue& back() { return items_.back().second; }

  /// The document on one line; NaN and infinity are null. Lists of many numbers go to json_blocks(), NaN and
  /// infinity included.
  std::string text() const {
    std::string text;
    write(text, json_blocks());
    return text;
  }

 private:
  void write(std::string& text, std::vector<double>& blocks) const;

  enum class Kind { null, word, number, text, list, object };
  static JsonValue of(Kind kind) {
    JsonValue value;
    value.kind_ = kind;
    return value;
  }
  bool is_numbers() const;

  Kind kind_ = Kind::null;
  bool is_block_ = false;
  double number_ = 0;
  std::string text_{};
  std::vector<double> block_{};
  std::vector<std::pair<std::string, JsonValue>> items_{};
};

}  // namespace cromer::core
