// Replaces fast_float's header of this name: it is included first, and its include guard keeps the other out.
#ifndef FASTFLOAT_FAST_TABLE_H
#define FASTFLOAT_FAST_TABLE_H

#include <fast_float/float_common.h>

#include "powers_of_five.h"

namespace fast_float {

struct powers {
  static constexpr int smallest_power_of_five = binary_format<double>::smallest_power_of_ten();
  static constexpr int largest_power_of_five = binary_format<double>::largest_power_of_ten();
  inline static const auto power_of_five_128 =
      cromer::core::page::powers_of_five<smallest_power_of_five, largest_power_of_five>();
};

}  // namespace fast_float

#endif
