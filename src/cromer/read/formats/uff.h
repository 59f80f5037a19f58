// Universal files (UFF), dataset 58: functions at nodal degrees of freedom, as text and as binary (58b).
// Source: SDRC, University of Cincinnati, "Universal File Datasets", dataset 58.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "cromer/read/sets.h"
#include "cromer/result.h"

namespace cromer::core::dialects {

/// One axis: record 8, 9 or 10.
struct UffAxis {
  int kind = 0;  ///< 8 displacement, 11 velocity, 12 acceleration, 13 force, 17 time, 18 frequency, ...
  std::string label, unit;  ///< "" for NONE
};

struct UffFunction {
  std::string identity;  ///< first ID line
  int function = 0;      ///< 1: time response
  long node = 0, load_case = 0;
  int direction = 0;  ///< 1 +X, -1 -X, 2 +Y, ..., 4 rotation about +X
  int type = 0;       ///< of the values: 2 single, 4 double, 5 and 6 complex
  double points = 0;
  bool even = true;  ///< abscissa given by start and step, else by values
  double start = 0, step = 0;
  UffAxis abscissa, ordinate;
};

constexpr std::size_t uff_header_lines = 11;

/// Reads the header; fields that are missing stay 0.
UffFunction uff_function(const std::array<std::string_view, uff_header_lines>& lines);

/// "Acceleration 3 +Z": what is measured, and where.
std::string uff_name(const UffFunction& function);

/// acceleration, position, ...; "" where the axis tells neither by its kind nor by its unit.
std::string uff_quantity(const UffAxis& axis, std::string_view name);

/// Whether the bytes begin with the line "    -1" (empty lines may stand before it) and a dataset's number.
bool is_uff(std::string_view bytes);

/// Every time response is a column with its times; responses at the same times share them. Other datasets,
/// other functions (spectra, frequency responses) and complex values are left out, with a notice. The bytes
/// are the file's, since binary values stand between the lines.
Result<Sets> read_uff(std::string_view bytes);

}  // namespace cromer::core::dialects
