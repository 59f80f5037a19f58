// Which of the kernel's units runs, chosen at run time.
#pragma once

#include <string_view>
#include <vector>

#include "cromer/ensemble/filter_walk.h"
#include "cromer/ensemble/group.h"
#include "cromer/result.h"

namespace cromer::core {

/// The kernel for one instruction set.
struct KernelUnit {
  std::string_view name;          ///< baseline, avx2 or avx512
  cromer_group::Advance advance;  ///< runs a group
  cromer_walk::Functions walk;    ///< walks response filters
};

/// The units that this machine can run, the fastest last.
std::vector<KernelUnit> units_here();

/// The fastest unit, or the one of that name. An Error if there is none of that name or this machine cannot
/// run it.
Result<KernelUnit> choose_unit(std::string_view name = {});

/// The same with the name in the environment variable CROMER_SIMD, where it is set.
Result<KernelUnit> choose_unit_by_environment();

}  // namespace cromer::core
