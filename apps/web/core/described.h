// What the documents of the page have beyond those of the program.
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/documents/described/compare.h"
#include "cromer/documents/described/fit.h"
#include "cromer/documents/described/inspect.h"
#include "cromer/tasks/fit/fitted_motion.h"
#include "cromer/tasks/fit/used_samples.h"
#include "resonance_curves.h"

namespace cromer::core {

template <>
struct Described<Series> {
  static constexpr std::string_view name = "InspectedSeries";
  static constexpr auto entries =
      members(field("run", &Series::run, "", "number of the run, from 1"),
              field("column", &Series::column, "", "title of the column"),
              field(
                  "observed", [](const Series& s) { return unless_empty(s.quantity); }, "",
                  "the recorded quantity; null if not known"),
              field(
                  "unit", [](const Series& s) { return std::string(unit_of(s)); }, "",
                  "unit of x; \"\" if it has no name"),
              field(
                  "rate", [](const Series& s) { return unless_zero(s.rate); }, "1/s",
                  "samples per second; null if their spacing is not even"),
              field("t", &Series::t, "s", "times, increasing; missing values are left out"),
              field("x", &Series::y, "SI", "values of the column"));
};

template <>
struct Described<MotionUnits> {
  static constexpr std::string_view name = "MotionUnits";
  static constexpr auto entries = members(
      field("measured", &MotionUnits::measured, "", "unit of the column and of the residuals"),
      field("displacement", &MotionUnits::displacement, "", "unit of x and of amplitudes"),
      field("velocity", &MotionUnits::velocity, "", "unit of v"),
      field("energy", &MotionUnits::energy, "", "unit of energies: J, or per mass if no mass is known"));
};

namespace page {

/// A file that was inspected, with the numbers of the column that is described.
struct InspectedOnPage {
  const Inspection& seen;
};

/// A fit with its curves.
struct FitOnPage {
  const FittedRecording& fitted;
};

/// A comparison with the states of its curves.
struct ComparedOnPage {
  const CompareResult& compared;
};

/// Curves with one value for each sample used.
struct FitCurves {
  FittedMotion motion;
  std::vector<double> measured_energy, set_aside;
};

/// Empty if there is no fit.
inline std::optional<FitCurves> curves_of(const FittedRecording& fitted) {
  if (!fitted.succeeded() || fitted.series.t.empty()) return std::nullopt;
  FitCurves curves{fitted_motion(fitted), {}, {}};
  std::vector<double> displacement = curves.motion.measured;
  for (double& x : displacement) x -= fitted.fit.equilibrium().value;
  curves.measured_energy = energies_of(fitted, displacement, curves.motion.local_velocity);
  for (const Outlier& outlier : fitted.series.outliers) curves.set_aside.push_back(outlier.t);
  return curves;
}

/// "c x'" for each term of the fitted law.
inline std::vector<std::string> formulas_of(const FittedRecording& fitted) {
  std::vector<std::string> formulas;
  for (std::size_t i = 0; i < term_count; ++i)
    if (fitted.fit.law.has(i)) formulas.emplace_back(term_infos[i].formula);
  return formulas;
}

/// [unit of the displacement] The rms of the residuals. If the column is a derivative of the displacement:
/// the amplitude of a swing whose derivative is as large.
inline double displacement_rms(const FittedRecording& fitted) {
  const int derivative = std::max(0, derivative_order(fitted.series.quantity));
  return fitted.fit.residual.rms / std::pow(fitted.fit.angular_frequency().value, derivative);
}

/// The states of one simulated curve.
struct CurveStates {
  const FittedRecording& fitted;
  const ComparedCurve& curve;
};

}  // namespace page

template <>
struct Described<page::InspectedOnPage> {
  using On = page::InspectedOnPage;
  static constexpr std::string_view name = "Inspection";
  static constexpr auto entries =
      members(all_of([](const On& f) {
                return InspectedFile{f.seen, false};
              }),
              field(
                  "series", [](const On& f) -> const std::vector<Series>& { return f.seen.series; }, "",
                  "the column in each run that has it"));
};

template <>
struct Described<page::FitCurves> {
  using C = page::FitCurves;
  static constexpr std::string_view name = "FitCurves";
  static constexpr auto entries = members(
      field(
          "t", [](const C& c) -> const auto& { return c.motion.t; }, "s", "times of the samples used"),
      field(
          "measured", [](const C& c) -> const auto& { return c.motion.measured; }, unit_of_column,
          "values of the column"),
      field(
          "residual", [](const C& c) -> const auto& { return c.motion.residual; }, unit_of_column,
          "measured minus fitted"),
      field(
          "x", [](const C& c) -> const auto& { return c.motion.x; }, "of the displacement",
          "displacement from the equilibrium, by the law"),
      field(
          "v", [](const C& c) -> const auto& { return c.motion.v; }, "of v", "velocity, by the law"),
      field(
          "energy", [](const C& c) -> const auto& { return c.motion.energy; }, "J, or per mass",
          "energy, by the law"),
      field(
          "measured_velocity", [](const C& c) -> const auto& { return c.motion.local_velocity; }, "of v",
          "velocity from the samples alone; empty if they are no displacement, NaN within half a period of "
          "the ends"),
      field("measured_energy", &C::measured_energy, "J, or per mass",
            "energy from the samples alone; likewise"),
      field("set_aside", &C::set_aside, "s", "times of the samples set aside as outliers"));
};

template <>
struct Described<page::FitOnPage> {
  using On = page::FitOnPage;
  static constexpr std::string_view name = "Fit";
  static constexpr auto entries =
      members(all_of([](const On& f) -> const FittedRecording& { return f.fitted; }),
              field(
                  "formulas", [](const On& f) { return page::formulas_of(f.fitted); }, "",
                  "the forces of the law, \"c x'\""),
              field(
                  "coefficients",
                  [](const On& f) { return coefficient_names(f.fitted.fit.law, f.fitted.parameters); }, "",
                  "names of the parameters that are the law's coefficients, in SI where a mass gives them"),
              field(
                  "units", [](const On& f) { return motion_units(f.fitted); }, "",
                  "units of the curves; \"\" if one has no name"),
              field(
                  "displacement_rms", [](const On& f) { return page::displacement_rms(f.fitted); },
                  "of the displacement", "rms of the residuals as a displacement"),
              field(
                  "curves", [](const On& f) { return page::curves_of(f.fitted); }, "",
                  "the motion beside the law, sample by sample"));
};

template <>
struct Described<page::CurveStates> {
  using S = page::CurveStates;
  static constexpr std::string_view name = "CurveStates";
  static constexpr auto entries = members(
      field(
          "t", [](const S& s) -> const auto& { return s.curve.trajectory.t; }, "s",
          "times of the samples used"),
      field(
          "x", [](const S& s) -> const auto& { return s.curve.trajectory.x; }, "of the displacement",
          "simulated displacement from the fitted equilibrium"),
      field(
          "v", [](const S& s) -> const auto& { return s.curve.trajectory.v; }, "of v", "simulated velocity"),
      field(
          "energy",
          [](const S& s) { return energies_of(s.fitted, s.curve.trajectory.x, s.curve.trajectory.v); },
          "J, or per mass", "energy, as in the curves of a fit"));
};

template <>
struct Described<page::ComparedOnPage> {
  using On = page::ComparedOnPage;
  static constexpr std::string_view name = "Comparison";
  static constexpr auto entries =
      members(all_of([](const On& c) -> const CompareResult& { return c.compared; }),
              field(
                  "states",
                  [](const On& c) {
                    std::vector<page::CurveStates> all;
                    for (const ComparedCurve& curve : c.compared.curves)
                      all.push_back({c.compared.recording, curve});
                    return all;
                  },
                  "", "states of each of the curves"));
};

template <>
struct Described<page::MethodResonance> {
  using Curve = page::MethodResonance;
  static constexpr std::string_view name = "ResonanceCurve";
  static constexpr auto entries =
      members(field("method", &Curve::method, "", "name of the method"),
              field("settled", &Curve::settled, "",
                    "false if the motion grows, never settles or was not tried; the lists are then empty"),
              field("too_many_steps", &Curve::too_many_steps, "",
                    "true if it was not tried because it takes too many steps"),
              field("frequency", &Curve::frequency, "rad/s", "angular frequencies of the drive"),
              field("amplitude", &Curve::amplitude, "m", "steady amplitudes"),
              field("phase", &Curve::phase, "rad", "phase lags behind the force"),
              field("at_drive", &Curve::at_drive, "m",
                    "steady amplitude at the drive's own frequency; null if there is none"));
};

}  // namespace cromer::core
