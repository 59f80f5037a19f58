// Where something stands in a file.
#pragma once

#include <string>

#include "cromer/result.h"

namespace cromer::core {

/// Line and column count from 1; 0 where it stands in no file.
struct Place {
  std::string file;
  unsigned line = 0, column = 0;

  Error error(const Notice& what) const {
    if (line == 0) return Error{"in_file", {{"file", file}, {"what", what}}};
    return Error{"at_place", {{"file", file}, {"line", line}, {"column", column}, {"what", what}}};
  }
};

}  // namespace cromer::core
