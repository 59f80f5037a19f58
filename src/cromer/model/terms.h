// Which sets of terms have code of their own; decided once, outside every loop.
#pragma once

#include "cromer/model/drive.h"
#include "cromer/model/law_force.h"
#include "cromer/model/oscillator.h"

namespace cromer::core {

/// Whether sets of terms have code of their own. A term that is absent then costs nothing; the page, which
/// must be small, has one code for all.
#ifdef CROMER_PAGE
inline constexpr bool each_set_of_terms = false;
#else
inline constexpr bool each_set_of_terms = true;
#endif

/// What a system has: a drive, and the terms of its law.
struct Terms {
  bool drive = false;
  Law law = law_with<Spring>;

  friend constexpr bool operator==(const Terms&, const Terms&) = default;
};

/// All that is there.
template <class Real>
constexpr Terms terms_of(const Oscillator<Real>& oscillator, const HarmonicDrive<Real>& drive) {
  return {.drive = drive.amplitude != Real(0), .law = law_of(oscillator)};
}

/// The smooth laws with code of their own: a measured choice. Every other one shares the code of any_terms,
/// which asks for each term whether it is there.
inline constexpr Law compiled_laws[] = {law_of("spring"),        law_of("viscous"),
                                        law_of("viscous+drag"),  law_of("cubic"),
                                        law_of("viscous+cubic"), law_of("viscous+drag+cubic")};

}  // namespace cromer::core
