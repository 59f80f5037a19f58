// What the C interface gives back, freed by itself: its document, and its arrays by name.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cromer/c.h"

namespace cromer::tests {

struct Free {
  void operator()(cromer_result* result) const { cromer_free(result); }
};
using Answer = std::unique_ptr<cromer_result, Free>;

inline nlohmann::json document(const Answer& answer) {
  return nlohmann::json::parse(cromer_document(answer.get()));
}

inline std::vector<double> array(const Answer& answer, const std::string& name) {
  std::size_t count = 0;
  const cromer_array* arrays = cromer_arrays(answer.get(), &count);
  for (std::size_t i = 0; i < count; ++i)
    if (arrays[i].name == name) return {arrays[i].values, arrays[i].values + arrays[i].length};
  ADD_FAILURE() << "no array " << name;
  return {};
}

}  // namespace cromer::tests
