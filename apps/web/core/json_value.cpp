#include "json_value.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "cromer/base/quantity.h"

namespace cromer::core {
namespace {

constexpr std::size_t shortest_block = 16;

void write_text(std::string_view text, std::string& to) {
  constexpr std::string_view digits = "0123456789abcdef";
  to += '"';
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      to += '\\';
      to += c;
    } else if (code < 0x20) {
      to += "\\u00";
      to += digits[code >> 4];
      to += digits[code & 15];
    } else {
      to += c;
    }
  }
  to += '"';
}

void write_number(double number, std::string& to) { to += std::isfinite(number) ? shortest(number) : "null"; }

void write_block(const std::vector<double>& numbers, std::string& to, std::vector<double>& blocks) {
  to += "{\"block\":[" + std::to_string(blocks.size()) + ',' + std::to_string(numbers.size()) + "]}";
  const std::size_t before = blocks.size();
  blocks.resize(before + numbers.size());
  // insert() would copy them one by one
  if (!numbers.empty()) std::memcpy(blocks.data() + before, numbers.data(), numbers.size() * sizeof(double));
}

}  // namespace

JsonValue::JsonValue(std::initializer_list<JsonValue> list) {
  const bool pairs = std::all_of(list.begin(), list.end(), [](const JsonValue& each) {
    return each.kind_ == Kind::list && each.items_.size() == 2 &&
           each.items_.front().second.kind_ == Kind::text;
  });
  kind_ = pairs ? Kind::object : Kind::list;
  for (const JsonValue& each : list)
    if (pairs)
      items_.emplace_back(each.items_[0].second.text_, each.items_[1].second);
    else
      items_.emplace_back("", each);
}

JsonValue& JsonValue::operator[](std::string_view name) {
  kind_ = Kind::object;
  const auto at =
      std::find_if(items_.begin(), items_.end(), [&](const auto& item) { return item.first == name; });
  if (at != items_.end()) return at->second;
  return items_.emplace_back(std::string(name), JsonValue()).second;
}

void JsonValue::push_back(JsonValue value) {
  kind_ = Kind::list;
  items_.emplace_back("", std::move(value));
}

bool JsonValue::is_numbers() const {
  return items_.size() >= shortest_block && std::all_of(items_.begin(), items_.end(), [](const auto& item) {
           return item.second.kind_ == Kind::number;
         });
}

void JsonValue::write(std::string& text, std::vector<double>& blocks) const {
  switch (kind_) {
    case Kind::null:
      text += "null";
      return;
    case Kind::word:
      text += text_;
      return;
    case Kind::number:
      return write_number(number_, text);
    case Kind::text:
      return write_text(text_, text);
    case Kind::list:
      if (is_block_) return write_block(block_, text, blocks);
      if (is_numbers()) {
        std::vector<double> numbers;
        for (const auto& item : items_) numbers.push_back(item.second.number_);
        return write_block(numbers, text, blocks);
      }
      [[fallthrough]];
    case Kind::object: {
      const bool object = kind_ == Kind::object;
      text += object ? '{' : '[';
      for (std::size_t i = 0; i < items_.size(); ++i) {
        if (i > 0) text += ',';
        if (object) {
          write_text(items_[i].first, text);
          text += ':';
        }
        items_[i].second.write(text, blocks);
      }
      text += object ? '}' : ']';
      return;
    }
  }
}

std::vector<double>& json_blocks() {
  static std::vector<double> blocks;
  return blocks;
}

}  // namespace cromer::core
