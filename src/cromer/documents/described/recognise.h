// What the document of `methods --recognise` consists of.
#pragma once

#include "cromer/documents/described/describe.h"
#include "cromer/tasks/recognise/recognise.h"

namespace cromer::core {

template <>
struct Described<RecognisedMethod> {
  using Found = RecognisedMethod;
  static constexpr std::string_view name = "Recognised";
  static constexpr auto entries = members(
      field("method", &Found::method, "",
            "name, as typed; of several with the same map the first that `cromer methods` lists"),
      field("same_map", &Found::same_map, "", "the others that give the same states with this step"),
      field("step", &Found::step, "s", "time step; null if the states show none: exact and adaptive methods"),
      field("steps_per_row", &Found::steps_per_row, "", "steps from one row of the file to the next"),
      field(
          "velocity_ahead", &Found::velocity_ahead, "",
          "whether the velocity of a row is that of one step later, as where the position is stepped first"),
      field(
          "distance", &Found::distance, "",
          "rms of what is left of the rows, positions over the rms of all positions, velocities over that of "
          "all velocities"),
      field("decay_rate_added", &Found::decay_rate_added, "1/s",
            "decay rate of the simulated motion less the law's; null if nothing oscillates"),
      field("frequency_shift", &Found::frequency_shift, "rad/s",
            "angular frequency of the simulated motion less the law's; null if nothing oscillates"));
};

/// "made", "the_law", "other_law" or "none".
constexpr std::string_view name_of(Verdict verdict) {
  constexpr std::string_view names[] = {"made", "the_law", "other_law", "none"};
  return names[static_cast<int>(verdict)];
}

template <>
struct Described<RecogniseResult> {
  using Result = RecogniseResult;
  static constexpr std::string_view name = "Recognition";
  static constexpr auto entries = members(
      field("file", &Result::file, "", "the file"),
      field("rows", &Result::rows, "", "rows that were compared, from the first"),
      field("spacing", &Result::spacing, "s", "time from row to row"),
      field("rounding", &Result::rounding, "", "distance that the rounding of the rows alone makes"),
      field(
          "natural_frequency", [](const Result& r) { return r.natural_frequency; }, "rad/s",
          "of the law, sqrt(k/m); null if no spring pulls back"),
      field(
          "damping_ratio", [](const Result& r) { return r.damping_ratio; }, "",
          "of the law; null if no spring pulls back"),
      field("law_fitted", &Result::law_fitted, "", "whether the law was fitted to the rows, or given"),
      field(
          "verdict", [](const Result& r) { return name_of(r.verdict); }, "",
          "made: by the first of `recognised`; the_law: no error of a method shows; other_law: made by the "
          "first, but from the law that stands here; none: no method made the rows"),
      field("alike", &Result::alike, "",
            "so many of `recognised`, from the first, the digits do not tell apart"),
      field("recognised", &Result::recognised, "", "the nearest methods and steps, nearest first"),
      field("in_words", &Result::words, "", "the verdict in words"), notices(&Result::notices));
};

}  // namespace cromer::core
