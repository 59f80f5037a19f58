// The methods of integration, and what each of them really simulates.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cromer/export.h>
#include <cromer/result.h>

namespace cromer {

/// A method by its name: "euler-cromer", "rk4", "exact", ... (methods() lists them).
class Method {
 public:
  template <std::convertible_to<std::string_view> Text>
  Method(const Text& name) : name_(std::string_view(name)) {}  // NOLINT: implicit on purpose
  const std::string& name() const { return name_; }
  friend bool operator==(const Method&, const Method&) = default;

 private:
  std::string name_;
};

/// What a method with a given step makes of a linear oscillator: exactly the motion of another one.
struct MethodEffect {
  std::optional<double> decay_rate{};  // [1/s] negative where it feeds the swing; empty where nothing swings
  std::optional<double> angular_frequency{};  // [rad/s] at most pi/step; empty where nothing swings
  double spectral_radius = 0;                 ///< of one step's map: above 1 the motion grows without end
  bool stable = true;
  /// [s] All shorter steps are stable; 0 where no step is; empty where there is no limit. A Simulation has it
  /// only where its step is not stable.
  std::optional<double> stability_limit{};
};

struct MethodInfo {
  std::string name;
  std::optional<int> order{};            ///< of the global error; empty for exact
  bool implicit = false;                 ///< a step solves an equation
  bool symplectic = false;               ///< said of the undamped law
  bool adaptive = false;                 ///< chooses its own steps
  bool reversible = false;               ///< a step back undoes a step
  bool a_stable = false;                 ///< stable at any step where the linear law is
  std::string source;                    ///< where it is published
  std::optional<MethodEffect> effect{};  ///< where asked for, of methods that do not choose their steps
};

/// Asks what each method simulates of x'' + 2 zeta w0 x' + w0^2 x = 0 with this step.
struct EffectOptions {
  double natural_frequency = 0;  // [rad/s] > 0
  double damping_ratio = 0;      // >= 0
  double step = 0;               // [s] > 0
};

/// All of them, in the order of the registry.
CROMER_API std::vector<MethodInfo> methods();

/// The same, each with its effect, found from the eigenvalues of the method's own step (error 1e-13 of the
/// natural frequency for w0 h > 1e-3, growing as 1e-16/(w0 h) below).
CROMER_API Result<std::vector<MethodInfo>> methods(const EffectOptions& options);

}  // namespace cromer
