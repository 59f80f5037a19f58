// A network as a drawing: masses as boxes in a row, in the order of the file, links as springs, dampers and
// sliders between them and to the ground below.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cromer/model/network.h"
#include "cromer/report/figure.h"

namespace cromer::core {

/// Networks of more masses are not drawn.
inline constexpr std::size_t most_masses_drawn = 8;

/// Names and values stand at masses and links. With `moved`, how far each mass is out of its place (1: as far
/// as a drawing shows well), the masses at rest are drawn in grey and values left out: the shape of a mode.
Panel network_drawing(const Network& network, const std::vector<double>& moved = {});

}  // namespace cromer::core
