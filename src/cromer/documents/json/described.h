// A described result as JSON. For .cpp files only.
#pragma once

#include <string>
#include <type_traits>
#include <utility>

#include "cromer/documents/described/describe.h"
#include "cromer/documents/json/json.h"

namespace cromer::core {

template <IsDescribed Result>
Json json_of(const Result& result, const Voice& voice);

namespace described {

template <class Value>
Json value_json(const Value& value, const Voice& voice) {
  if constexpr (IsDescribed<Value>) {
    return json_of(value, voice);
  } else if constexpr (is_optional<Value>) {
    return value ? value_json(*value, voice) : Json(nullptr);
  } else if constexpr (std::is_same_v<Value, Notice>) {
    return said(value, voice);
  } else if constexpr (std::is_same_v<Value, Pair>) {
    return {value.first, value.second};
  } else if constexpr (std::is_same_v<Value, TableRows>) {
    Json rows = Json::array();
    for (std::size_t at = 0; at < value.numbers.size(); at += value.width) {
      Json row = Json::array();
      for (const double number : value.numbers.subspan(at, value.width)) row.push_back(number);
      rows.push_back(std::move(row));
    }
    return rows;
  } else if constexpr (std::is_same_v<ItemOf<Value>, Parameter>) {
    Json object = Json::object();
    for (const Parameter& each : value) object[each.name] = json_of(each, voice);
    return object;
  } else if constexpr (std::is_same_v<ItemOf<Value>, double> || std::is_same_v<ItemOf<Value>, std::string>) {
    return value;
  } else if constexpr (List<Value>) {
    Json list = Json::array();
    for (const auto& each : value) list.push_back(value_json(each, voice));
    return list;
  } else if constexpr (Text<Value>) {
    return std::string_view(value);
  } else {
    static_assert(std::is_arithmetic_v<Value>, "this type has no description");
    return value;
  }
}

template <class Entries, class Result>
void add_entries(Json& object, const Entries& entries, const Result& result, const Voice& voice);

template <class Get, class Result>
void add(Json& object, const Field<Get>& entry, const Result& result, const Voice& voice) {
  const auto& value = entry.of(result);
  if constexpr (is_optional<std::remove_cvref_t<decltype(value)>>)
    if (entry.if_any && !value) return;
  object[std::string(entry.name)] = value_json(value, voice);
}

template <class Get, class Result>
void add(Json& object, const Estimated<Get>& entry, const Result& result, const Voice&) {
  const std::optional<Estimate> estimate = std::invoke(entry.get, result);
  object[std::string(entry.name)] = estimate ? Json(estimate->value) : Json(nullptr);
  object[std::string(entry.error_name)] = estimate ? Json(estimate->standard_error) : Json(nullptr);
  if (entry.interval)
    object["confidence_95"] = estimate ? Json{estimate->low, estimate->high} : Json(nullptr);
}

template <class When, class Entries, class Result>
void add(Json& object, const Group<When, Entries>& entry, const Result& result, const Voice& voice) {
  if (!entry.when(result)) {
    object[std::string(entry.name)] = nullptr;
    return;
  }
  Json inner = Json::object();
  add_entries(inner, entry.entries, result, voice);
  object[std::string(entry.name)] = std::move(inner);
}

template <class Result>
void add_all(Json& object, const Result& result, const Voice& voice);

template <class Get, class Result>
void add(Json& object, const AllOf<Get>& entry, const Result& result, const Voice& voice) {
  add_all(object, std::invoke(entry.get, result), voice);
}

template <class Get, class Sample, class Result>
void add(Json& object, const ByName<Get, Sample>& entry, const Result& result, const Voice&) {
  for (const Named& each : std::invoke(entry.get, result)) object[each.name] = each.value;
}

template <class Get, class Result>
void add(Json& object, const Notices<Get>& entry, const Result& result, const Voice& voice) {
  add_notices(object, std::invoke(entry.get, result), voice);
}

template <class Entries, class Result>
void add_entries(Json& object, const Entries& entries, const Result& result, const Voice& voice) {
  for_each_entry(entries, [&](const auto& entry) { add(object, entry, result, voice); });
}

template <class Result>
void add_all(Json& object, const Result& result, const Voice& voice) {
  if constexpr (MayBeRefused<Result>)
    if (Described<Result>::is_refused(result))
      return add_entries(object, Described<Result>::refused, result, voice);
  add_entries(object, Described<Result>::entries, result, voice);
}

}  // namespace described

/// The object of a described struct, with its entries in order.
template <IsDescribed Result>
Json json_of(const Result& result, const Voice& voice) {
  Json object = Json::object();
  described::add_all(object, result, voice);
  return object;
}

}  // namespace cromer::core
