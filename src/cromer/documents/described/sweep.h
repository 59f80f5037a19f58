// What the document of `sweep` consists of.
#pragma once

#include "cromer/documents/described/describe.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

template <>
struct Described<SweptOption> {
  static constexpr std::string_view name = "SweptOption";
  static constexpr auto entries = members(field("name", &SweptOption::name, "", "name of the option"),
                                          field("column", &SweptOption::column, "", "its column, with unit"),
                                          field("points", &SweptOption::points, "", "number of its values"));
};

template <>
struct Described<SweepCheck> {
  static constexpr std::string_view name = "SweepCheck";
  static constexpr auto entries =
      members(field("points", &SweepCheck::points, "", "number of points that were stepped as well"),
              field("difference", &SweepCheck::difference, "",
                    "largest relative difference of the amplitude from the closed form"),
              field("left_out", &SweepCheck::left_out, "", "number of points that could not be checked"));
};

/// A sweep with or without its rows.
struct SweepDocument {
  const SweepResult& result;
  bool with_rows;

  std::size_t width() const { return result.plan.rows.columns.size() - 1; }
  std::vector<std::string> columns() const {
    return {result.plan.rows.columns.begin(), result.plan.rows.columns.end() - 1};
  }
  std::optional<TableRows> rows() const {
    return with_rows ? std::optional(TableRows{result.rows, width()}) : std::nullopt;
  }
  std::vector<std::string> statuses() const {
    std::vector<std::string> words;
    for (const unsigned char status : result.statuses) words.emplace_back(status_word(result.plan, status));
    return words;
  }
};

/// The number of points that ended in one way.
template <class Count>
constexpr auto sweep_count(std::string_view called, Count SweepCounts::*which, std::string_view meaning) {
  return field(
      called, [which](const SweepDocument& s) { return s.result.counts.*which; }, "", meaning);
}

template <>
struct Described<SweepDocument> {
  using S = SweepDocument;
  static constexpr std::string_view name = "Sweep";
  static constexpr auto entries = members(
      field(
          "swept", [](const S& s) { return s.result.plan.swept; }, "", "the swept options, outermost first"),
      field(
          "method", [](const S& s) { return s.result.plan.method; }, "", "name of the method"),
      field(
          "way", [](const S& s) { return in_words(s.result.plan.way); }, "", "how the points are computed"),
      field(
          "steps", [](const S& s) { return in_words(s.result.plan.steps); }, "",
          "lengths of steps and runs, in words"),
      field(
          "simd", [](const S& s) { return s.result.plan.simd; }, "",
          "vector instructions that were used: baseline, avx2 or avx512"),
      field(
          "points", [](const S& s) { return s.result.plan.rows.rows; }, "", "number of rows"),
      sweep_count("not_settled", &SweepCounts::not_settled, "number of points that never settled"),
      sweep_count("not_finite", &SweepCounts::not_finite, "number of points that ran away"),
      sweep_count("no_convergence", &SweepCounts::no_convergence,
                  "number of points whose step has no solution"),
      sweep_count("unstable", &SweepCounts::unstable, "number of points whose free motion grows without end"),
      sweep_count("settled_by_own_damping", &SweepCounts::own_damping,
                  "number of points that only the method damps"),
      sweep_count("phase_outside", &SweepCounts::phase_outside, "number of lags outside 0 to pi"),
      field(
          "check", [](const S& s) { return s.result.check; }, "",
          "check of the closed form by stepping; only if asked for")
          .left_out(),
      field("columns", &S::columns, "", "names of the columns, with units"),
      field("rows", &S::rows, "of each column", "a list for each row: the swept values, then the measures")
          .left_out(),
      field("statuses", &S::statuses, "", "how each row ended, in a word"),
      notices([](const S& s) { return notices_of(s.result); }),
      field(
          "message",
          [](const S& s) {
            return s.result.interrupted ? std::optional(Notice{"rows_not_reached"}) : std::nullopt;
          },
          "", "that it was interrupted; only then")
          .left_out());
};

}  // namespace cromer::core
