// An estimate as the contract's object.
#pragma once

#include <string_view>

#include "cromer/documents/json/json.h"
#include "cromer/identify/least_squares/uncertainty.h"

namespace cromer::core {

/// {"value", "standard_error", "confidence_95", "unit"}
inline Json estimate_object(const Estimate& estimate, std::string_view unit) {
  return {{"value", estimate.value},
          {"standard_error", estimate.standard_error},
          {"confidence_95", {estimate.low, estimate.high}},
          {"unit", unit}};
}

}  // namespace cromer::core
