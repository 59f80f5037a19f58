// What a result consists of. Each struct of a result has one table; from it come its JSON, its names in a
// study, the page's types and the table of the docs.
//
//   template <>
//   struct Described<Gap> {
//     static constexpr std::string_view name = "Gap";
//     static constexpr auto entries = members(field("t", &Gap::t, "s", "where it begins").known(),
//                                             field("length", &Gap::length, "s", "how long it is").known());
//   };
#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "cromer/notice.h"
#include "cromer/quantity.h"

namespace cromer::core {

/// `name` is the name of the page's type; `entries` stand in the order of the document.
template <class Result>
struct Described;

template <class Result>
concept IsDescribed = requires {
  Described<Result>::entries;
};

/// A result that may hold an error in place of numbers. Where `is_refused`, its document has only the entries
/// `refused`.
template <class Result>
concept MayBeRefused = requires(const Result& result) {
  Described<Result>::refused;
  Described<Result>::is_refused(result);
};

/// The meaning; empty in the page, which shows none and must be small.
#ifdef CROMER_PAGE
constexpr std::string_view meaning_if_shown(std::string_view) { return {}; }
#else
constexpr std::string_view meaning_if_shown(std::string_view meaning) { return meaning; }
#endif

/// One number, bool, text, list or described struct. `get` is a member or a function of the result. A double
/// that is not finite is written as null, and so is an empty optional.
template <class Get>
struct Field {
  std::string_view name;
  Get get;
  std::string_view unit;  ///< SI; "" where there is none
  std::string_view meaning;
  bool finite = false;             ///< its numbers are never null
  bool if_any = false;             ///< left out where the optional is empty
  std::string_view in_study = "";  ///< its name in a study, if it is a different one
  bool only_document = false;      ///< not in a study

  constexpr Field known() const { return with(&Field::finite); }
  constexpr Field left_out() const { return with(&Field::if_any); }
  constexpr Field not_in_study() const { return with(&Field::only_document); }
  /// In a study its entries stand without its name before them.
  constexpr Field unnamed() const { return called(no_name); }
  static constexpr std::string_view no_name = "-";
  constexpr Field called(std::string_view word) const {
    Field changed = *this;
    changed.in_study = word;
    return changed;
  }

  template <class Result>
  decltype(auto) of(const Result& result) const {
    return std::invoke(get, result);
  }

 private:
  constexpr Field with(bool Field::*flag) const {
    Field changed = *this;
    changed.*flag = true;
    return changed;
  }
};

template <class Get>
constexpr Field<Get> field(std::string_view name, Get get, std::string_view unit, std::string_view meaning) {
  return {name, get, unit, meaning_if_shown(meaning)};
}

/// An Estimate. The document has it as `name`, "standard_error" and, with `interval`, "confidence_95".
template <class Get>
struct Estimated {
  std::string_view name;
  Get get;
  std::string_view unit, meaning;
  bool interval = false;
  bool finite = false;  ///< the value is never null
  std::string_view error_name = "standard_error";

  constexpr Estimated with_interval() const {
    Estimated changed = *this;
    changed.interval = true;
    return changed;
  }
  constexpr Estimated known() const {
    Estimated changed = *this;
    changed.finite = true;
    return changed;
  }
  constexpr Estimated with_error(std::string_view called) const {
    Estimated changed = *this;
    changed.error_name = called;
    return changed;
  }
};

template <class Get>
constexpr Estimated<Get> estimated(std::string_view name, Get get, std::string_view unit,
                                   std::string_view meaning) {
  return {name, get, unit, meaning_if_shown(meaning)};
}

/// An object within the document, made of the same result; null where `when` is false.
template <class When, class Entries>
struct Group {
  std::string_view name, meaning;
  When when;
  Entries entries;
  bool sometimes = false;  ///< it may be null
};

/// All entries of another described struct, among these: a document that extends another one.
template <class Get>
struct AllOf {
  Get get;
};

template <class Get>
constexpr AllOf<Get> all_of(Get get) {
  return {get};
}

/// "warnings": sentences, and "notices": the same as objects.
template <class Get>
struct Notices {
  Get get;
};

template <class Get>
constexpr Notices<Get> notices(Get get) {
  return {get};
}

namespace described {

template <class Part>
constexpr auto as_tuple(Part part) {
  return std::tuple{part};
}
template <class... Parts>
constexpr auto as_tuple(std::tuple<Parts...> parts) {
  return parts;
}

struct Always {
  template <class Result>
  constexpr bool operator()(const Result&) const {
    return true;
  }
};

}  // namespace described

/// A table of entries, and of other tables, in this order.
template <class... Parts>
constexpr auto members(Parts... parts) {
  return std::tuple_cat(described::as_tuple(parts)...);
}

template <class... Parts>
constexpr auto group(std::string_view name, std::string_view meaning, std::tuple<Parts...> entries) {
  return Group<described::Always, std::tuple<Parts...>>{name, meaning_if_shown(meaning), {}, entries};
}

template <class When, class... Parts>
constexpr auto group_if(std::string_view name, std::string_view meaning, When when,
                        std::tuple<Parts...> entries) {
  return Group<When, std::tuple<Parts...>>{name, meaning_if_shown(meaning), when, entries, true};
}

/// A number whose name comes from a registry.
struct Named {
  std::string name;
  double value = 0;
  std::string unit;
  std::string_view meaning;
};

/// Numbers named by a registry. `sample()` gives their names without a result.
template <class Get, class Sample>
struct ByName {
  Get get;
  Sample sample;
};

template <class Get, class Sample>
constexpr ByName<Get, Sample> by_name(Get get, Sample sample) {
  return {get, sample};
}

/// Two numbers as a list: an interval, a complex number.
struct Pair {
  double first = 0, second = 0;
};

/// Rows of a table, `width` numbers each, one after another in memory. Written as a list of lists.
struct TableRows {
  std::span<const double> numbers;
  std::size_t width = 1;
};

inline Pair interval_of(const Estimate& estimate) { return {estimate.low, estimate.high}; }

/// Empty for 0, which means unknown in rates and durations.
inline std::optional<double> unless_zero(double value) {
  return value == 0 ? std::nullopt : std::optional(value);
}

/// Empty for an empty text.
inline std::optional<std::string> unless_empty(std::string_view text) {
  return text.empty() ? std::nullopt : std::optional(std::string(text));
}

namespace described {

template <class Value>
struct OptionalTraits : std::false_type {
  using Inner = Value;
};
template <class Value>
struct OptionalTraits<std::optional<Value>> : std::true_type {
  using Inner = Value;
};
template <class Value>
inline constexpr bool is_optional = OptionalTraits<Value>::value;

template <class Value>
concept Text = std::convertible_to<Value, std::string_view>;

/// The type of a list's items; void if it is no list.
template <class Value>
struct ListTraits {
  using Item = void;
};
template <class Value>
struct ListTraits<std::vector<Value>> {
  using Item = Value;
};
template <class Value>
using ItemOf = typename ListTraits<Value>::Item;
template <class Value>
concept List = !std::is_void_v<ItemOf<Value>>;

/// The type of an entry's value.
template <class Entry, class Result>
using ValueOf = std::remove_cvref_t<decltype(std::declval<const Entry&>().of(std::declval<const Result&>()))>;

}  // namespace described

/// Calls `visit` with each entry in order.
template <class Entries, class Visit>
void for_each_entry(const Entries& entries, Visit visit) {
  std::apply([&](const auto&... entry) { (visit(entry), ...); }, entries);
}

template <>
struct Described<Parameter> {
  static constexpr std::string_view name = "Estimate";
  static constexpr auto entries =
      members(field(
                  "value", [](const Parameter& p) { return p.estimate.value; }, "", "estimate"),
              field(
                  "standard_error", [](const Parameter& p) { return p.estimate.standard_error; }, "",
                  "its standard error, with correlated residuals taken into account"),
              field(
                  "confidence_95", [](const Parameter& p) { return interval_of(p.estimate); }, "",
                  "95 % interval from Student's t"),
              field("unit", &Parameter::unit, "", "SI unit of all of these; 1 for a plain number"));
};

/// A member that is an Estimate, as an object of its value, standard error, interval and unit.
template <class Result>
constexpr auto quantity(std::string_view name, Estimate Result::*member, std::string_view unit,
                        std::string_view meaning) {
  return field(
      name,
      [name, member, unit](const Result& result) {
        return Parameter{std::string(name), result.*member, std::string(unit)};
      },
      "", meaning);
}

}  // namespace cromer::core
