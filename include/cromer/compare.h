// A recording beside its law, one constant decay rate, and simulations.
#pragma once

#include <concepts>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cromer/export.h>
#include <cromer/fit.h>
#include <cromer/methods.h>
#include <cromer/notice.h>
#include <cromer/result.h>
#include <cromer/trajectory.h>

namespace cromer {

namespace core {
struct CompareResult;
}

/// One method or several: `"rk4"`, `{"euler-cromer", "rk4"}`.
class MethodList {
 public:
  template <std::convertible_to<std::string_view> Text>
  MethodList(const Text& name) : methods_{Method(name)} {}    // NOLINT: implicit on purpose
  MethodList(Method method) : methods_{std::move(method)} {}  // NOLINT: likewise
  MethodList(std::initializer_list<Method> methods) : methods_(methods) {}
  MethodList(std::vector<Method> methods) : methods_(std::move(methods)) {}  // NOLINT: likewise
  auto begin() const { return methods_.begin(); }
  auto end() const { return methods_.end(); }

 private:
  std::vector<Method> methods_;
};

struct CompareOptions {
  /// Which simulate the law, each a curve of its own.
  MethodList method = "euler-cromer";
  /// [s] > 0, at most the recording's length; by default the sample spacing, divided until a period has at
  /// least 200 steps.
  std::optional<double> step{};
  Progress progress{};
};

/// One motion laid beside the recording, at the recording's own times; x is the displacement from the
/// fitted equilibrium. The figures are NaN if it ended early; those at the end also if the measured motion
/// has stopped by then.
struct ComparedCurve {
  std::string label;  ///< "one constant decay rate", "viscous+drag", "viscous+drag by rk4"
  std::string law;
  double step = 0;  // [s] of the method; 0 of the law itself
  Trajectory trajectory;
  bool complete = true;            ///< it reached the recording's end
  double rms = 0;                  ///< of measured minus simulated, in the unit of the record
  double r_squared = 0;            ///< share of the record's variance that it accounts for
  double amplitude_ratio_end = 0;  ///< simulated over measured, at the end
  double phase_drift = 0;          // [rad] simulated minus measured, at the end
  std::string method{};            ///< "exact" of a law without any method's error
};

struct Comparison {
  LawFit fit;
  /// One constant decay rate and the fitted law, without a method's error, then the law by each method; none
  /// where the fit's status is `undetermined`, or where progress ended it before.
  std::vector<ComparedCurve> curves;
  std::string explanation;      ///< whether one decay rate is enough and what methods add, in English
  bool complete = true;         ///< all curves are
  bool interrupted = false;     ///< progress ended it
  std::vector<Notice> notices;  ///< what else there is to know, the fit's first
  std::shared_ptr<const core::CompareResult> detail{};
};

/// Simulates what was fitted and lays it beside the record. An Error if the fit was refused, if something
/// drives the motion, if velocities or accelerations were recorded, or if an argument is wrong, which it
/// names.
CROMER_API Result<Comparison> compare(const LawFit& fit, const CompareOptions& options = {});

}  // namespace cromer
