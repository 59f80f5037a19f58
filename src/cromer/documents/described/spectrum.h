// What the document of `spectrum` consists of.
#pragma once

#include "cromer/documents/described/describe.h"
#include "cromer/tasks/spectrum/response_spectrum.h"

namespace cromer::core {

/// Spectral displacements at all periods, and the pseudo-velocities and -accelerations that follow from them.
struct SpectralValues {
  const SpectrumResult& of;
  const std::vector<double>& displacement;

  template <class Value>
  std::vector<double> each(Value value) const {
    std::vector<double> all;
    for (std::size_t i = 0; i < displacement.size(); ++i)
      all.push_back(value(displacement[i], of.periods[i]));
    return all;
  }
};

/// Accelerations are written in m/s² or in g, as asked for: the name of the unit, and its size [m/s^2].
inline constexpr std::string_view unit_as_written = "m/s² or g";
inline std::string_view written_unit(const SpectrumResult& result) {
  return result.options.in_g ? "g" : "m/s²";
}
inline double written_acceleration(const SpectrumResult& result) {
  return result.options.in_g ? standard_gravity : 1;
}

/// The unit of a shock spectrum as it is written, and its size in SI.
inline constexpr std::string_view shock_unit_as_written = "m/s², g, m/s or m";
inline bool shock_is_acceleration(const SpectrumResult& result) {
  return result.shock_of == ShockResponse::absolute_acceleration ||
         result.shock_of == ShockResponse::equivalent_static_acceleration;
}
inline std::string_view shock_unit(const SpectrumResult& result) {
  return shock_is_acceleration(result)                             ? written_unit(result)
         : result.shock_of == ShockResponse::relative_displacement ? "m"
                                                                   : "m/s";
}
inline double written_shock(const SpectrumResult& result) {
  return shock_is_acceleration(result) ? written_acceleration(result) : 1;
}

template <>
struct Described<SpectralValues> {
  using V = SpectralValues;
  static constexpr std::string_view name = "SpectralValues";
  static constexpr auto entries = members(
      field(
          "SD", [](const V& v) { return v.displacement; }, "m", "spectral displacement at each period"),
      field(
          "PSV", [](const V& v) { return v.each(pseudo_velocity); }, "m/s", "pseudo-velocity at each period"),
      field(
          "PSA",
          [](const V& v) {
            const double unit = written_acceleration(v.of);
            return v.each([unit](double d, double period) { return pseudo_acceleration(d, period) / unit; });
          },
          unit_as_written, "pseudo-acceleration at each period"));
};

/// The spectrum of one damping ratio.
struct SpectrumOf {
  const SpectrumResult& of;
  const ResponseSpectrum& spectrum;
  bool with_curves = true;  ///< of one component that is no shock: else they stand beside the document

  bool one() const { return spectrum.shock.empty() && spectrum.displacement.size() == 1; }
  bool two() const { return spectrum.shock.empty() && spectrum.displacement.size() != 1; }
  SpectralValues values(const std::vector<double>& displacement) const { return {of, displacement}; }
  std::optional<SpectralValues> of_two(const std::vector<double>& displacement) const {
    return two() ? std::optional(values(displacement)) : std::nullopt;
  }
  /// A value of each shock; empty unless it is a shock spectrum.
  template <class Value>
  std::optional<std::vector<double>> shocks(Value value) const {
    if (spectrum.shock.empty()) return std::nullopt;
    std::vector<double> all;
    for (const Shock& shock : spectrum.shock) all.push_back(std::invoke(value, shock) / written_shock(of));
    return all;
  }
};

/// An entry that only shock spectra have.
template <class Value>
constexpr auto shock_entry(std::string_view name, Value value, std::string_view meaning) {
  return field(
             name, [value](const SpectrumOf& s) { return s.shocks(value); }, shock_unit_as_written, meaning)
      .left_out();
}

/// An entry of SpectralValues as an entry of the spectrum itself, if there is only one component.
template <class Get>
constexpr auto entry_of_one(const Field<Get>& value) {
  return field(
             value.name,
             [value](const SpectrumOf& s) {
               return s.one() && s.with_curves ? std::optional(value.of(s.values(s.spectrum.displacement[0])))
                                               : std::nullopt;
             },
             value.unit, value.meaning)
      .left_out();
}

template <>
struct Described<SpectrumOf> {
  using S = SpectrumOf;
  static constexpr std::string_view name = "Spectrum";
  static constexpr auto entries = members(
      field(
          "loss_factor",
          [](const S& s) {
            return s.of.hysteretic() ? std::optional(s.spectrum.damping_ratio) : std::nullopt;
          },
          "", "loss factor of hysteretic springs")
          .left_out(),
      field(
          "damping_ratio",
          [](const S& s) {
            return s.of.hysteretic() ? std::nullopt : std::optional(s.spectrum.damping_ratio);
          },
          "", "damping ratio of viscous damping")
          .left_out(),
      field(
          "ductility",
          [](const S& s) { return s.of.inelastic() ? std::optional(s.spectrum.ductility) : std::nullopt; },
          "",
          "of springs that yield: the largest displacement over that of yielding, which SD, PSV and PSA are "
          "of")
          .left_out(),
      field(
          "period",
          [](const S& s) { return s.one() && !s.with_curves ? std::nullopt : std::optional(s.of.periods); },
          "s", "natural periods of the oscillators")
          .left_out(),
      shock_entry("primary", &Shock::primary, "largest response during the shock"),
      shock_entry("residual", &Shock::residual, "largest response after the shock"),
      shock_entry("maximax", &Shock::maximax, "largest response at any time"),
      shock_entry("positive", &Shock::positive, "largest positive response at any time"),
      shock_entry("negative", &Shock::negative, "largest negative response at any time, as a magnitude"),
      std::apply([](const auto&... value) { return members(entry_of_one(value)...); },
                 Described<SpectralValues>::entries),
      field(
          "components",
          [](const S& s) -> std::optional<std::vector<SpectralValues>> {
            if (!s.two()) return std::nullopt;
            std::vector<SpectralValues> all;
            for (const auto& displacement : s.spectrum.displacement) all.push_back(s.values(displacement));
            return all;
          },
          "", "each of two components")
          .left_out(),
      field(
          "geometric_mean", [](const S& s) { return s.of_two(s.spectrum.geometric_mean); }, "",
          "geometric mean of both components")
          .left_out(),
      field(
          "rotd50", [](const S& s) { return s.of_two(s.spectrum.rotd50); }, "",
          "RotD50: median over all directions")
          .left_out(),
      field(
          "rotd100", [](const S& s) { return s.of_two(s.spectrum.rotd100); }, "",
          "RotD100: largest over all directions")
          .left_out());
};

template <>
struct Described<Correction> {
  using C = Correction;
  static constexpr std::string_view name = "Correction";
  static constexpr auto entries = members(
      field(
          "baseline",
          [](const C& c) {
            return c.baseline ? std::optional(baselines[static_cast<std::size_t>(*c.baseline)])
                              : std::nullopt;
          },
          "",
          "the polynomial taken off, by least squares: constant, linear, quadratic or cubic; null for none"),
      group_if(
          "band_pass", "the Butterworth filter after it; null for none",
          [](const C& c) { return c.band.has_value(); },
          members(field(
                      "low", [](const C& c) { return unless_zero(c.band->low); }, "Hz",
                      "low corner; null for none"),
                  field(
                      "high", [](const C& c) { return c.band->high; }, "Hz", "high corner; null for none"),
                  field("order", &C::order, "", "order of the filter"),
                  field("causal", &C::causal, "",
                        "it runs forwards alone; otherwise backwards too, without phase shift and with 6 dB "
                        "in place of 3 dB at the corners"))));
};

struct ComponentOf {
  const SpectrumResult& of;
  const Component& component;
};

template <>
struct Described<ComponentOf> {
  using C = ComponentOf;
  static constexpr std::string_view name = "Component";
  static constexpr auto entries = members(
      field(
          "file", [](const C& c) { return c.component.file; }, "", "name of the file"),
      field(
          "column", [](const C& c) { return c.component.column; }, "", "title of the column"),
      field(
          "samples", [](const C& c) { return c.component.samples; }, "", "number of samples"),
      field(
          "spacing", [](const C& c) { return c.component.spacing; }, "s", "spacing of the samples"),
      field(
          "duration", [](const C& c) { return c.component.duration(); }, "s", "duration of the record"),
      field(
          "begins", [](const C& c) { return c.component.begins; }, "s",
          "time of the first sample; below 0 where a filter needed zeros before the recording"),
      field(
          "baseline",
          [](const C& c) {
            return c.of.correction.baseline ? std::optional(c.component.baseline / written_acceleration(c.of))
                                            : std::nullopt;
          },
          unit_as_written, "largest magnitude of the baseline that was taken off; only then")
          .left_out(),
      field(
          "peak_acceleration", [](const C& c) { return c.component.peak / written_acceleration(c.of); },
          unit_as_written, "PGA: largest magnitude of the acceleration"),
      field(
          "peak_velocity", [](const C& c) { return c.component.path.peak_velocity; }, "m/s",
          "PGV: largest magnitude of the velocity, from rest at the first sample"),
      field(
          "peak_displacement", [](const C& c) { return c.component.path.peak_displacement; }, "m",
          "PGD: largest magnitude of the displacement, likewise"),
      field(
          "cumulative_absolute_velocity", [](const C& c) { return c.component.absolute_velocity; }, "m/s",
          "CAV: integral of |a|"),
      field(
          "arias_intensity", [](const C& c) { return c.component.intensity.arias; }, "m/s",
          "Arias intensity: pi/(2 g) times the integral of a²"),
      field(
          "from_5", [](const C& c) { return c.component.intensity.from; }, "s",
          "time when 5 % of the Arias intensity are reached"),
      field(
          "duration_5_75", [](const C& c) { return c.component.intensity.duration_75; }, "s",
          "time from 5 % to 75 % of the Arias intensity"),
      field(
          "duration_5_95", [](const C& c) { return c.component.intensity.duration; }, "s",
          "time from 5 % to 95 % of the Arias intensity"),
      field(
          "duration_bracketed", [](const C& c) { return c.component.bracketed_duration; }, "s",
          "time from the first to the last acceleration of 0.05 g; 0 where there is none"));
};

template <>
struct Described<FourierAmplitude> {
  static constexpr std::string_view name = "Fourier";
  static constexpr auto entries = members(
      field("frequency_step", &FourierAmplitude::step, "Hz", "frequency from one amplitude to the next"),
      field("amplitude", &FourierAmplitude::amplitude, "m/s",
            "Fourier amplitudes of the acceleration, from 0 Hz on"));
};

/// All spectra, with or without Fourier amplitudes.
struct SpectrumDocument {
  const SpectrumResult& result;
  bool with_fourier;
  bool with_curves = true;

  bool one() const { return result.components.size() == 1; }
  /// The value of the only recording; empty if there are two.
  template <class Value>
  auto of_one(Value value) const {
    return one() ? std::optional(value(result.components[0])) : std::nullopt;
  }
  /// The values of both recordings; empty if there is one.
  template <class Value>
  auto of_each(Value value) const {
    std::vector<decltype(value(result.components[0]))> all;
    for (const Component& component : result.components) all.push_back(value(component));
    return one() ? std::nullopt : std::optional(all);
  }
};

/// A number of one recording, or a list of two.
template <class Value>
constexpr auto one_or_both(std::string_view name, Value value, std::string_view unit,
                           std::string_view meaning) {
  return members(field(
                     name, [value](const SpectrumDocument& s) { return s.of_one(value); }, unit, meaning)
                     .left_out(),
                 field(
                     name, [value](const SpectrumDocument& s) { return s.of_each(value); }, unit,
                     "the same of two components, as a list")
                     .left_out());
}

template <>
struct Described<SpectrumDocument> {
  using S = SpectrumDocument;
  static constexpr std::string_view name = "SpectrumDocument";
  static constexpr auto arias = [](const Component& c) { return c.intensity.arias; };
  static constexpr auto duration = [](const Component& c) { return c.intensity.duration; };
  static constexpr auto fourier = [](const Component& c) { return c.fourier; };
  static constexpr auto unless_shock = [](const S& s, std::string_view unit) {
    return s.result.options.shock ? std::nullopt : std::optional(unit);
  };
  static constexpr auto entries = members(
      field(
          "components",
          [](const S& s) {
            std::vector<ComponentOf> all;
            for (const Component& component : s.result.components) all.push_back({s.result, component});
            return all;
          },
          "", "the recordings"),
      field(
          "peaks", [](const S& s) { return s.result.options.peaks; }, "",
          "how peaks are found: continuous, samples or peer"),
      field(
          "between_samples", [](const S& s) { return s.result.options.between_samples; }, "",
          "interpolation of the record: linear, hold or band-limited"),
      field(
          "correction",
          [](const S& s) {
            return s.result.correction.any() ? std::optional(s.result.correction) : std::nullopt;
          },
          "", "what was taken off the recordings first; only then")
          .left_out(),
      field(
          "shock_response",
          [](const S& s) {
            return s.result.options.shock ? std::optional(cromer::name(s.result.shock_of)) : std::nullopt;
          },
          "", "of which response a shock spectrum is: absolute-acceleration, ...")
          .left_out(),
      group(
          "units", "units of the columns",
          members(field(
                      "period", [](const S&) { return std::string_view("s"); }, "", "unit of the periods"),
                  field(
                      "acceleration",
                      [](const S& s) {
                        return s.result.options.shock && shock_is_acceleration(s.result)
                                   ? std::optional(written_unit(s.result))
                                   : std::nullopt;
                      },
                      "", "unit of shock spectra of an acceleration")
                      .left_out(),
                  field(
                      "shock",
                      [](const S& s) {
                        return s.result.options.shock && !shock_is_acceleration(s.result)
                                   ? std::optional(shock_unit(s.result))
                                   : std::nullopt;
                      },
                      "", "unit of other shock spectra")
                      .left_out(),
                  field(
                      "SD", [](const S& s) { return unless_shock(s, "m"); }, "", "unit of the displacements")
                      .left_out(),
                  field(
                      "PSV", [](const S& s) { return unless_shock(s, "m/s"); }, "",
                      "unit of the pseudo-velocities")
                      .left_out(),
                  field(
                      "PSA", [](const S& s) { return unless_shock(s, written_unit(s.result)); }, "",
                      "unit of the pseudo-accelerations")
                      .left_out())),
      field(
          "spectra",
          [](const S& s) {
            std::vector<SpectrumOf> all;
            for (const ResponseSpectrum& spectrum : s.result.spectra)
              all.push_back({s.result, spectrum, s.with_curves});
            return all;
          },
          "", "one for each damping ratio"),
      one_or_both("arias_intensity", arias, "m/s", "Arias intensity: pi/(2 g) times the integral of a²"),
      one_or_both("duration_5_95", duration, "s", "time from 5 % to 95 % of the Arias intensity"),
      field(
          "fourier", [](const S& s) { return s.with_fourier ? s.of_one(fourier) : std::nullopt; }, "",
          "Fourier amplitudes; only if asked for")
          .left_out(),
      field(
          "fourier", [](const S& s) { return s.with_fourier ? s.of_each(fourier) : std::nullopt; }, "",
          "the same of two components, as a list")
          .left_out(),
      notices([](const S& s) -> const std::vector<Notice>& { return s.result.notices; }),
      field(
          "message",
          [](const S& s) {
            return s.result.interrupted ? std::optional(Notice{"interrupted"}) : std::nullopt;
          },
          "", "that it was interrupted; only then")
          .left_out());
};

/// One of many motions. If its spectra could not be computed, only its files and the message are known.
template <>
struct Described<MotionSpectra> {
  using M = MotionSpectra;
  static constexpr std::string_view name = "MotionSpectra";
  static bool is_refused(const M& m) { return !m.succeeded(); }
  static constexpr auto refused = members(
      field("files", &M::files, "", "names of the files: one, or two components"),
      field(
          "message",
          [](const M& m) { return m.succeeded() ? std::nullopt : std::optional(m.result.error().notice); },
          "", "why there are no spectra; only then")
          .left_out());
  static constexpr auto entries = members(refused, all_of([](const M& m) {
                                            return SpectrumDocument{*m.result, false};
                                          }));
};

}  // namespace cromer::core
