// What is taken off a recorded acceleration before it shakes anything.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "cromer/analysis/butterworth.h"
#include "cromer/result.h"

namespace cromer::core {

struct SpectrumOptions;
struct Component;

/// Baselines by the degree of their polynomial.
inline constexpr std::array<std::string_view, 4> baselines{"constant", "linear", "quadratic", "cubic"};

/// First the baseline, then the filter.
struct Correction {
  std::optional<int> baseline{};   ///< degree of the polynomial of least squares
  std::optional<PassBand> band{};  ///< of a Butterworth filter
  int order = 4;                   ///< of the filter
  bool causal = false;             ///< the filter runs forwards alone

  bool any() const { return baseline || band; }
};

/// What the options ask for; an Error names the option, its value and the cure.
Result<Correction> correction_of(const SpectrumOptions& options);

/// Corrects the component. A filter lengthens it by zeros, in which what it rings with dies down: behind the
/// recording and, unless causal, before it. An Error names option and file.
Result<void> correct(Component& component, const Correction& correction);

}  // namespace cromer::core
