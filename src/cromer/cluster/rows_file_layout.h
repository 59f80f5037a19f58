// How work is laid out in an HDF5 file.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cromer/cluster/rows_file.h"

namespace cromer::core {

/// A dataset of the file.
struct LaidOut {
  std::string name, unit;
  std::vector<std::uint64_t> shape;
  std::size_t column = 0;      ///< of the rows, where it is no axis
  const Grid* axis = nullptr;  ///< its values, where it is one
  std::uint64_t offset = 0;    ///< of its first number in the file [bytes]
  std::uint64_t numbers() const;
};

/// The datasets of such work, axes first; offsets are not set.
std::vector<LaidOut> layout_of(const ChunkedRows& work, const std::vector<RowsAxis>& axes);

/// Makes the file at `path` with all its numbers, NaN but for the axes; sets the offsets.
Result<void> make_file(const std::string& path, const ChunkedRows& work, const RowsFileOptions& options,
                       std::vector<LaidOut>& datasets, const Watch& watch);

/// Finds the datasets in a file made before; an Error where it is of other work.
Result<void> find_in_file(const ChunkedRows& work, const RowsFileOptions& options,
                          std::vector<LaidOut>& datasets);

}  // namespace cromer::core
