// Which terms of the law are there; decided once, outside every loop.
#pragma once

#include "cromer/model/drive.h"
#include "cromer/model/oscillator.h"

namespace cromer {

/// Whether each set of terms has code of its own. A term that is absent then costs nothing; the page, which
/// must be small, has one code for all (any_terms.h).
#ifdef CROMER_PAGE
inline constexpr bool each_set_of_terms = false;
#else
inline constexpr bool each_set_of_terms = true;
#endif

/// Inertia and stiffness are always there.
struct Terms {
  bool drive = false;
  bool damping = false;
  bool cubic = false;
  bool drag = false;
  bool friction = false;

  friend constexpr bool operator==(const Terms&, const Terms&) = default;
};

/// All that a linear law may have, and all that any smooth one may.
inline constexpr Terms some_linear_terms{.drive = true, .damping = true};
inline constexpr Terms all_smooth_terms{.drive = true, .damping = true, .cubic = true, .drag = true};

/// The terms with a coefficient other than zero.
template <class Real>
constexpr Terms terms_of(const Oscillator<Real>& oscillator, const HarmonicDrive<Real>& drive) {
  return {.drive = drive.amplitude != Real(0),
          .damping = oscillator.damping != Real(0),
          .cubic = oscillator.cubic != Real(0),
          .drag = oscillator.drag != Real(0),
          .friction = oscillator.friction != Real(0) || oscillator.static_friction != Real(0)};
}

/// The linear law with harmonic drive: the one with a closed form.
constexpr bool is_linear(Terms terms) { return !terms.cubic && !terms.drag && !terms.friction; }

/// Empty if the oscillator has a closed form in one piece (with friction it is made of arcs); otherwise the
/// term that prevents it, for people: "drag (0.02 kg/m)"-like is the caller's.
template <class Real>
constexpr const char* why_not_exact(const Oscillator<Real>& oscillator) {
  if (oscillator.cubic != Real(0)) return "cubic";
  if (oscillator.drag != Real(0)) return "drag";
  if (oscillator.friction != Real(0) || oscillator.static_friction != Real(0)) return "friction";
  return "";
}

}  // namespace cromer
