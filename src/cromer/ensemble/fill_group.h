// Points as the plain numbers of a group, and back.
#pragma once

#include <span>

#include "cromer/ensemble/group.h"
#include "cromer/ensemble/point.h"

namespace cromer::core {

/// The points at their starts; places that are left over repeat the last one.
void fill_group(std::span<const Point> points, cromer_group::Group& group);

/// What to ask of the unit: so many steps, with weights (one a step) for the sums, or nullptr.
cromer_group::Order order_of(const Stepping& stepping, long long steps, const double* weights = nullptr);

/// not_finite or no_convergence where that is so of the i-th; else done.
PointStatus status_of(const cromer_group::Group& group, int i);

}  // namespace cromer::core
