// What the document of `modes` consists of.
#pragma once

#include "cromer/documents/described/describe.h"
#include "cromer/documents/described/methods.h"
#include "cromer/tasks/modes/modes.h"

namespace cromer::core {

template <>
struct Described<ModeByMethod> {
  static constexpr std::string_view name = "ModeByMethod";
  static constexpr auto entries = members(
      field("method", &ModeByMethod::method, "", "name, as typed"),
      field("step", &ModeByMethod::step, "s", "its time step").known(),
      field("frequency", &ModeByMethod::frequency, "Hz",
            "|eigenvalue|/2 pi of what it simulates; null if nothing oscillates"),
      field("damping_ratio", &ModeByMethod::damping_ratio, "", "likewise; negative if the mode grows"),
      field(
          "stable", [](const ModeByMethod& m) { return m.effect.stable; }, "",
          "whether the mode stays bounded"),
      field("in_words", &ModeByMethod::words, "", "the same in words"));
};

template <>
struct Described<NaturalMode> {
  static constexpr std::string_view name = "NaturalMode";
  static constexpr auto entries =
      members(field(
                  "frequency",
                  [](const NaturalMode& m) {
                    return Parameter{"frequency", m.frequency, "Hz"};
                  },
                  "", "|eigenvalue|/2 pi, 0 of a free body; null if the mode falls away from rest"),
              field(
                  "damping_ratio",
                  [](const NaturalMode& m) {
                    return Parameter{"damping_ratio", m.damping_ratio, "1"};
                  },
                  "", "minus the eigenvalue's real part over its size; null without a frequency"),
              field(
                  "shape",
                  [](const NaturalMode& m) {
                    std::vector<Pair> shape;
                    for (const std::complex<double>& each : m.shape)
                      shape.push_back({each.real(), each.imag()});
                    return shape;
                  },
                  "", "of each of `names`, as [re, im]; the largest is 1"),
              field("participation", &NaturalMode::participation, "",
                    "effective modal mass over the whole mass, for ground that shakes all the same; null for "
                    "recordings"),
              field("methods", &NaturalMode::methods, "", "what each method really simulates of it"));
};

template <>
struct Described<ModesResult> {
  static constexpr std::string_view name = "Modes";
  static constexpr auto entries =
      members(field("file", &ModesResult::file, "", "the file"),
              field("names", &ModesResult::names, "", "the masses, in the order of the components of shapes"),
              field("modes", &ModesResult::modes, "", "by rising frequency"), notices(&ModesResult::notices));
};

}  // namespace cromer::core
