// What the document of `compare` consists of.
#pragma once

#include "cromer/documents/described/fit.h"
#include "cromer/tasks/compare/compare.h"

namespace cromer::core {

template <>
struct Described<ComparedCurve> {
  using Curve = ComparedCurve;
  static constexpr std::string_view name = "ComparedCurve";
  static constexpr auto entries =
      members(field(
                  "label", [](const Curve& c) { return in_words(c.label); }, "",
                  "one constant decay rate, the law, or the law by a method"),
              field(
                  "law", [](const Curve& c) { return to_text(c.law); }, "", "terms of the law"),
              field("method", &Curve::method, "", "method of the simulation; `exact`: none, the law itself"),
              field("rms", &Curve::rms, unit_of_column, "rms of measured minus simulated"),
              field("r_squared", &Curve::r_squared, "", "explained share of the measured variance"),
              field("amplitude_ratio_end", &Curve::amplitude_ratio_end, "",
                    "simulated over measured amplitude at the end; null if the measured motion has stopped"),
              field("phase_drift", &Curve::phase_drift, "rad",
                    "simulated minus measured phase at the end; null if the measured motion has stopped"),
              field(
                  "step", [](const Curve& c) { return unless_zero(c.step); }, "s", "step of the method"),
              field("law_rms", &Curve::law_rms, unit_of_column,
                    "rms of measured minus the exact solution of the law"),
              field("method_amplitude_ratio", &Curve::method_amplitude_ratio, "",
                    "simulated over exact amplitude at the end"),
              field("method_phase", &Curve::method_phase, "rad", "simulated minus exact phase at the end"),
              field("diverged", &Curve::diverged, "", "whether the method is unstable at this step"));
};

template <>
struct Described<CompareResult> {
  using Compared = CompareResult;
  static constexpr std::string_view name = "ComparedRecording";
  static constexpr auto entries = members(
      field(
          "recording", [](const Compared& c) { return FittedFrom{c.recording}; }, "",
          "the measured recording"),
      field(
          "status", [](const Compared& c) { return c.recording.status(); }, "", "status of the fit"),
      field(
          "message",
          [](const Compared& c) -> std::optional<Notice> {
            if (c.recording.fit.status != FitStatus::converged) return c.recording.fit.message;
            return c.complete ? std::nullopt : std::optional(c.notices.back());
          },
          "", "why there is no fit, or why a simulation ended early; only then")
          .left_out(),
      field("curves", &Compared::curves, "",
            "one constant decay rate and the law, without a method's error, then the law by each method"),
      field(
          "measured_at_rest",
          [](const Compared& c) {
            return c.curves.empty() ? std::nullopt : std::optional(c.curves.front().measured_at_rest);
          },
          "", "whether the measured motion is below the noise at the end")
          .left_out(),
      field(
          "explanation",
          [](const Compared& c) {
            const Notice sentence = explanation(c);
            return sentence.empty() ? std::nullopt : std::optional(sentence);
          },
          "", "whether one decay rate is enough")
          .left_out(),
      field("fit", &Compared::recording, "", "the same as from `fit`"), notices(&Compared::notices));
};

}  // namespace cromer::core
