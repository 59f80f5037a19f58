// An HDF5 file of finished tables, written at once.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cromer/result.h"

namespace cromer::core {

/// One dataset of doubles. Without a shape it has one dimension.
struct Hdf5Column {
  std::string name;  ///< with its unit: "SD (m)"; no "/"
  std::vector<double> values{};
  std::vector<std::uint64_t> shape{};  ///< outermost first; multiplies to the values
  std::string axes{};                  ///< names of the datasets its dimensions run over, with blanks between
};

/// Datasets that belong together: a group of the file, or with an empty name its root.
struct Hdf5Table {
  std::string name{};
  std::vector<std::pair<std::string, std::string>> texts{};  ///< attributes
  std::vector<Hdf5Column> columns{};                         ///< empty ones are left out
};

/// Checks, before long work, that such a file can be written: an Error if the module is missing, or if there
/// is a device or a pipe in its place.
Result<void> can_write_tables(const std::string& path);

/// Writes the file whole or not at all, over what was there. Each dataset has the attribute unit. The same
/// bytes for the same tables. Errors: no module, no room, no leave to write.
Result<void> write_tables(const std::string& path, const std::vector<Hdf5Table>& tables);

}  // namespace cromer::core
