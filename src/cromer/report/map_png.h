// The colours of a map as a small PNG: 8 bits a px, looked up in the map's palette.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cromer::core {

/// `values`, 0 darkest to 1 lightest, run along the columns, the lowest row first; as many as columns (>= 1)
/// times rows (>= 1). What is no number is transparent.
std::string map_png(const std::vector<double>& values, int columns, int rows);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace cromer::core
