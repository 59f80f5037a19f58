// The numbers of a forced or driven fit, named and with units.
#pragma once

#include <string_view>
#include <vector>

#include "cromer/identify/forced_fit.h"
#include "cromer/study/task/fitted_quantities.h"

namespace cromer {

/// In the contract's order, per unit mass and then, with a mass and a record of lengths, in SI. `observed` is
/// the unit of the record, which is this derivative of the displacement, `force_unit` that of the force
/// column; "" where there is none or it is not known.
std::vector<NamedEstimate> forced_parameters(const ForcedFit& fit, std::string_view observed, int derivative,
                                             std::string_view force_unit, const Body& body);

}  // namespace cromer
