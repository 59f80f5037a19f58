// The laws of fitted motions that have code of their own: a measured choice. Every other law shares that of
// the smallest one here which has all of its terms, at the price of derivatives that nobody asks for.
#pragma once

#include "cromer/model/law_force.h"

namespace cromer::core {

inline constexpr Law every_law_that_rubs = smooth_terms.with(law_with<Friction>);
inline constexpr Law every_law = every_law_that_rubs.with(law_with<Hysteresis>);

#ifdef CROMER_PAGE
inline constexpr Law free_laws[] = {law_of("viscous+drag"), law_of("viscous+drag+cubic"), every_law_that_rubs,
                                    every_law};
inline constexpr Law driven_laws[] = {law_of("viscous"), law_of("viscous+drag+quadratic+cubic"), every_law};
#else
inline constexpr Law free_laws[] = {law_of("viscous"),
                                    law_of("viscous+drag"),
                                    law_of("viscous+cubic"),
                                    law_of("viscous+odd-quadratic"),
                                    law_of("viscous+drag+cubic"),
                                    law_of("viscous+drag+odd-quadratic"),
                                    law_of("viscous+drag+pendulum"),
                                    law_of("viscous+drag+friction"),
                                    law_of("viscous+drag+friction+cubic"),
                                    law_of("viscous+drag+friction+odd-quadratic"),
                                    law_of("viscous+hysteresis"),
                                    smooth_terms,
                                    every_law_that_rubs,
                                    every_law};
inline constexpr Law driven_laws[] = {law_of("viscous"),
                                      law_of("viscous+drag"),
                                      law_of("viscous+quadratic+cubic"),
                                      law_of("viscous+drag+quadratic+cubic"),
                                      law_of("viscous+friction"),
                                      law_of("viscous+hysteresis"),
                                      smooth_terms,
                                      every_law_that_rubs,
                                      every_law};
#endif

}  // namespace cromer::core
