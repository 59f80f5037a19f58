// The published truths of tests/problems.
#pragma once

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "cromer/base/state.h"
#include "cromer/model/oscillator.h"

namespace cromer::core::problems {

inline nlohmann::json read(const std::string& name) {
  std::ifstream file(std::string(CROMER_SOURCE_DIR) + "/tests/problems/" + name);
  return nlohmann::json::parse(file);
}

/// Numbers are written as text, to keep their 25 digits.
inline double number(const nlohmann::json& value) {
  return value.is_string() ? std::strtod(value.get<std::string>().c_str(), nullptr) : value.get<double>();
}

inline double number(const nlohmann::json& object, const char* key) {
  return object.contains(key) ? number(object.at(key)) : 0.0;
}

/// "parameters" of a problem.
struct Problem {
  Oscillator<double> oscillator;
  HarmonicDrive<double> drive;
  State<double> start;

  explicit Problem(const nlohmann::json& p)
      : oscillator{number(p, "m"), number(p, "k"), number(p, "c"),
                   number(p, "d"), number(p, "f"), number(p, "k3")},
        drive{number(p, "F"), number(p, "w"), number(p, "phi")},
        start{number(p, "x0"), number(p, "v0")} {}
};

}  // namespace cromer::core::problems
