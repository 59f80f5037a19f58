// Curves cut at the frame: what a panel shows of them.
#pragma once

#include <vector>

#include "cromer/report/labels.h"

namespace cromer::core {

/// A hundredth of a px outside, which nobody sees, still counts as inside.
bool inside(Spot p, const Box& frame);

/// What of an unbroken line lies in the frame: as many pieces as it enters, cut at the edge, each of two
/// spots or more.
std::vector<std::vector<Spot>> pieces_inside(const std::vector<Spot>& line, const Box& frame);

/// The columns in the frame, cut at its upper and lower edge; NaN still parts the pieces.
Band band_inside(const Band& band, const Box& frame);

}  // namespace cromer::core
