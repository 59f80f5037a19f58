// The numbers and texts of a described result by name: "id.stiffness", "id.segment.1.rate".
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "cromer/documents/described/describe.h"
#include "cromer/documents/words/words.h"
#include "cromer/study/results.h"

namespace cromer::core {

/// Sets the numbers and texts of a described result. Their names are the paths in the JSON document, unless
/// the description has another name for studies. An Estimate is a number with its uncertainty; .low and .high
/// are beside it. Infinities become NaN. Lists of numbers, bools and empty optionals are left out. `unit_of`
/// replaces units that depend on the recording, such as "of the column".
class Facts {
 public:
  using UnitOf = std::function<std::string_view(std::string_view)>;

  Facts(Results& results, UnitOf unit_of) : results_(results), unit_of_(std::move(unit_of)) {}

  template <IsDescribed Result>
  void set(const std::string& id, const Result& result) const {
    entries(id + ".", Described<Result>::entries, result);
  }

  void set(const std::string& name, const Estimate& estimate, std::string_view unit) const {
    results_.set(name, Quantity{estimate.value, estimate.standard_error}, unit);
    results_.set(name + ".low", estimate.low, unit);
    results_.set(name + ".high", estimate.high, unit);
  }

 private:
  static std::string within(const std::string& prefix, std::string_view name, std::string_view in_study) {
    if (in_study == Field<int>::no_name) return prefix;
    return prefix + std::string(in_study.empty() ? name : in_study) + ".";
  }

  template <class Value>
  void value(const std::string& prefix, std::string_view name, std::string_view in_study,
             std::string_view unit, const Value& found) const {
    const std::string path = prefix + std::string(in_study.empty() ? name : in_study);
    if constexpr (IsDescribed<Value>) {
      entries(within(prefix, name, in_study), Described<Value>::entries, found);
    } else if constexpr (described::is_optional<Value>) {
      if (found) value(prefix, name, in_study, unit, *found);
    } else if constexpr (std::is_same_v<Value, Notice>) {
      results_.set(path, in_words(found, {results_.language()}));
    } else if constexpr (std::is_same_v<described::ItemOf<Value>, Parameter>) {
      for (const Parameter& each : found) set(prefix + each.name, each.estimate, each.unit);
    } else if constexpr (described::List<Value>) {
      if constexpr (IsDescribed<described::ItemOf<Value>>) {
        std::size_t n = 0;
        for (const auto& each : found)
          entries(path + "." + std::to_string(++n) + ".", Described<described::ItemOf<Value>>::entries, each);
      }
    } else if constexpr (described::Text<Value>) {
      results_.set(path, std::string(std::string_view(found)));
    } else if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
      const double number = static_cast<double>(found);
      results_.set(path, std::isfinite(number) ? number : std::numeric_limits<double>::quiet_NaN(),
                   unit_of_(unit));
    }
  }

  template <class Get, class Result>
  void entry(const std::string& prefix, const Field<Get>& field, const Result& result) const {
    if (!field.only_document)
      value<described::ValueOf<Field<Get>, Result>>(prefix, field.name, field.in_study, field.unit,
                                                    field.of(result));
  }
  template <class Get, class Result>
  void entry(const std::string& prefix, const Estimated<Get>& each, const Result& result) const {
    if (const std::optional<Estimate> found = std::invoke(each.get, result))
      set(prefix + std::string(each.name), *found, unit_of_(each.unit));
  }
  template <class When, class Entries, class Result>
  void entry(const std::string& prefix, const Group<When, Entries>& group, const Result& result) const {
    if (group.when(result)) entries(within(prefix, group.name, ""), group.entries, result);
  }
  template <class Get, class Result>
  void entry(const std::string& prefix, const AllOf<Get>& all, const Result& result) const {
    using Base = std::remove_cvref_t<std::invoke_result_t<Get, const Result&>>;
    entries(prefix, Described<Base>::entries, std::invoke(all.get, result));
  }
  template <class Get, class Sample, class Result>
  void entry(const std::string& prefix, const ByName<Get, Sample>& named, const Result& result) const {
    for (const Named& each : std::invoke(named.get, result))
      results_.set(prefix + each.name, each.value, each.unit);
  }
  template <class Get, class Result>
  void entry(const std::string&, const Notices<Get>&, const Result&) const {}

  template <class Entries, class Result>
  void entries(const std::string& prefix, const Entries& all, const Result& result) const {
    for_each_entry(all, [&](const auto& each) { entry(prefix, each, result); });
  }

  Results& results_;
  UnitOf unit_of_;
};

}  // namespace cromer::core
