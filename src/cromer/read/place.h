// Where something stands in a file.
#pragma once

#include <string>

#include "cromer/result.h"

namespace cromer::core {

/// Line and column count from 1.
struct Place {
  std::string file;
  unsigned line = 0, column = 0;

  Error error(const Notice& what) const {
    return Error{"at_place", {{"file", file}, {"line", line}, {"column", column}, {"what", what}}};
  }
};

}  // namespace cromer::core
