// How large a figure is, and which of its panels stand side by side.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cromer/report/figure.h"

namespace cromer::core {

/// Sizes in pixels; the text's is a factor.
struct Canvas {
  double width, row_height, text_scale;
};

/// Of a figure with so many rows of panels.
Canvas canvas_of(const Figure& figure, int rows);

/// a, b, ... z, aa, ab, ...
std::string letter_of(std::size_t panel);

/// Panels in rows: one row after the other, each as many columns wide as it says.
std::vector<std::vector<std::size_t>> rows_of(const Figure& figure);

}  // namespace cromer::core
