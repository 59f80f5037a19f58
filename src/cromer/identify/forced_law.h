// The law of a forced motion, as a sum of coefficients each times a term.
//
//   z'' = drive(t) + a - 2 g z' - q z'|z'| - s1 z - s2 z^2 - s3 z^3,   z from a fixed level near its mean
//
// The bias a holds what force and level are off by; which part is whose comes after the fit
// (forced_quantities.h). Of a record of velocities or accelerations z is measured from where the law rests,
// and the parameter bias is the sensor's offset, from the record's mean.
#pragma once

#include "cromer/identify/least_squares/normal_equations.h"

namespace cromer {

/// Terms beside stiffness and viscous damping.
struct ForcedTerms {
  bool drag = false;
  bool curved = false;  ///< quadratic and cubic stiffness

  friend bool operator==(const ForcedTerms&, const ForcedTerms&) = default;
};

/// Where each parameter of a fit stands: the drive's own first; -1 where the law lacks it.
struct ForcedLayout {
  int bias = 0, decay = 0, drag = -1, stiffness = 0, quadratic = -1, cubic = -1, position = 0, velocity = 0;
  int size = 0;
};

constexpr ForcedLayout forced_layout(int drive_parameters, ForcedTerms terms) {
  ForcedLayout at;
  int next = drive_parameters;
  at.bias = next++;
  at.decay = next++;
  if (terms.drag) at.drag = next++;
  at.stiffness = next++;
  if (terms.curved) at.quadratic = next++;
  if (terms.curved) at.cubic = next++;
  at.position = next++;
  at.velocity = next++;
  at.size = next;
  return at;
}

/// The parameters of one law as those of another under the same drive; terms that only the other has are 0.
inline Parameters adapt_forced(const Parameters& from, ForcedTerms had, ForcedTerms has,
                               int drive_parameters) {
  const ForcedLayout a = forced_layout(drive_parameters, had), b = forced_layout(drive_parameters, has);
  Parameters result{};
  for (int i = 0; i < drive_parameters; ++i) result[i] = from[i];
  for (int ForcedLayout::*place :
       {&ForcedLayout::bias, &ForcedLayout::decay, &ForcedLayout::drag, &ForcedLayout::stiffness,
        &ForcedLayout::quadratic, &ForcedLayout::cubic, &ForcedLayout::position, &ForcedLayout::velocity})
    if (a.*place >= 0 && b.*place >= 0) result[b.*place] = from[a.*place];
  return result;
}

}  // namespace cromer
