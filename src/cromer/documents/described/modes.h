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
struct Described<ModeOfNetwork> {
  static constexpr std::string_view name = "ModeOfNetwork";
  static constexpr auto entries =
      members(field("mode", &ModeOfNetwork::mode, "", "from 1, by rising frequency"),
              field("frequency", &ModeOfNetwork::frequency, "Hz", "the network's").known(),
              field("damping_ratio", &ModeOfNetwork::damping_ratio, "", "the network's").known(),
              field("mac", &ModeOfNetwork::mac, "",
                    "modal assurance criterion of the two shapes, 0.5 to 1: 1 for the same")
                  .known());
};

template <>
struct Described<NaturalMode> {
  static constexpr std::string_view name = "NaturalMode";
  static constexpr auto entries = members(
      quantity("frequency", &NaturalMode::frequency, "Hz",
               "|eigenvalue|/2 pi, 0 of a free body; null if the mode falls away from rest"),
      quantity("damping_ratio", &NaturalMode::damping_ratio, "1",
               "minus the eigenvalue's real part over its size; null where the frequency is 0 or null"),
      field(
          "shape",
          [](const NaturalMode& m) {
            std::vector<Pair> shape;
            for (const std::complex<double>& each : m.shape) shape.push_back({each.real(), each.imag()});
            return shape;
          },
          "", "of each of `names`, as [re, im]; the largest is 1"),
      field(
          "shape_standard_error",
          [](const NaturalMode& m) {
            std::vector<Pair> errors;
            for (const std::complex<double>& each : m.shape_error)
              errors.push_back({each.real(), each.imag()});
            return errors;
          },
          "", "of the parts of `shape`, likewise; empty of a network"),
      field("participation", &NaturalMode::participation, "",
            "effective modal mass over the whole mass, for ground that shakes all the same; null for "
            "recordings"),
      field("of_network", &NaturalMode::of_network, "",
            "the network's mode that matches this one; null without one"),
      field("methods", &NaturalMode::methods, "", "what each method really simulates of it"));
};

template <>
struct Described<SpectralPeak> {
  static constexpr std::string_view name = "SpectralPeak";
  static constexpr auto entries = members(
      field("frequency", &SpectralPeak::frequency, "Hz", "where it stands").known(),
      field("prominence", &SpectralPeak::prominence, "", "its height over the median around it").known());
};

template <>
struct Described<StabilityPole> {
  static constexpr std::string_view name = "StabilityPole";
  static constexpr auto entries = members(
      field("order", &StabilityPole::order, "", "of the model"),
      field("frequency", &StabilityPole::frequency, "Hz", "|eigenvalue|/2 pi").known(),
      field("damping_ratio", &StabilityPole::damping_ratio, "", "of the pole").known(),
      field("stable", &StabilityPole::stable, "",
            "frequency within 1 %, damping ratio within a half and shape within a MAC of 0.95 of a pole of "
            "the order before"));
};

template <>
struct Described<ModalSource> {
  static constexpr std::string_view name = "ModalSource";
  static constexpr auto entries = members(
      field(
          "motion",
          [](const ModalSource& s) {
            return s.found.motion == ModalMotion::free_decay ? "free_decay" : "ambient";
          },
          "", "free_decay (it was let go, or grows by itself) or ambient (random forces keep it moving)"),
      field("run", &ModalSource::run, "", "run of the file, from 1"),
      field("quantity", &ModalSource::quantity, "", "what the channels measure"),
      field("unit", &ModalSource::unit, "", "SI unit of the channels"),
      field("samples", &ModalSource::samples, "", "that all channels have"),
      field("rate", &ModalSource::rate, "1/s", "samples per second").known(),
      field("duration", &ModalSource::duration, "s", "from the first sample to the last").known(),
      field("gaps", &ModalSource::gaps, "", "how many"),
      field(
          "highest_order", [](const ModalSource& s) { return s.found.highest_order; }, "",
          "of the models; 0 if the recording is too short for any"),
      field(
          "lines", [](const ModalSource& s) { return s.found.lines; }, "Hz",
          "steady oscillations among random forces: of machines, no modes"),
      field(
          "peaks", [](const ModalSource& s) { return s.found.peaks; }, "",
          "of the largest singular value of the spectral matrix (frequency domain decomposition)"),
      field(
          "poles", [](const ModalSource& s) { return s.found.poles; }, "",
          "the stabilisation diagram: the poles of all orders"),
      field("in_words", &ModalSource::words, "", "what kind of motion it is, and how its modes were found"));
};

template <>
struct Described<Beat> {
  static constexpr std::string_view name = "Beat";
  static constexpr auto entries = members(
      quantity("frequency", &Beat::frequency, "Hz", "difference of the two frequencies"),
      quantity("period", &Beat::period, "s", "time from one beat to the next"),
      quantity("coupling", &Beat::coupling, "1", "difference of the squared frequencies over their sum"));
};

template <>
struct Described<ModesResult> {
  static constexpr std::string_view name = "Modes";
  static constexpr auto entries = members(
      field("file", &ModesResult::file, "", "the file"),
      field("names", &ModesResult::names, "",
            "the masses or channels, in the order of the components of shapes"),
      field("modes", &ModesResult::modes, "", "by rising frequency"),
      field("beat", &beat_of, "",
            "how two modes beat and are coupled; null unless there are two that swing and whose frequencies "
            "surely differ"),
      field("recording", &ModesResult::recording, "", "what the modes were found in; null of a network"),
      field(
          "message", [](const ModesResult& r) { return r.ok() ? std::nullopt : std::optional(r.message); },
          "", "why no mode was found")
          .left_out(),
      notices(&ModesResult::notices));
};

}  // namespace cromer::core
