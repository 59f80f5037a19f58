#include "cromer/ensemble/dispatch.h"

#include <cstdlib>

extern "C" {
bool cromer_advance_baseline(cromer_group::Group& group, const cromer_group::Order& order);
#if defined(__x86_64__)
bool cromer_advance_avx2(cromer_group::Group& group, const cromer_group::Order& order);
bool cromer_advance_avx512(cromer_group::Group& group, const cromer_group::Order& order);
#endif
}
cromer_walk::Functions cromer_walk_baseline();
#if defined(__x86_64__)
cromer_walk::Functions cromer_walk_avx2();
cromer_walk::Functions cromer_walk_avx512();
#endif

namespace cromer::core {
namespace {

constexpr std::string_view names[] = {"baseline", "avx2", "avx512"};

}  // namespace

std::vector<KernelUnit> units_here() {
  std::vector<KernelUnit> units{{names[0], cromer_advance_baseline, cromer_walk_baseline()}};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    units.push_back({names[1], cromer_advance_avx2, cromer_walk_avx2()});
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") &&
      __builtin_cpu_supports("avx512vl"))
    units.push_back({names[2], cromer_advance_avx512, cromer_walk_avx512()});
#endif
  return units;
}

Result<KernelUnit> choose_unit(std::string_view name) {
  const std::vector<KernelUnit> units = units_here();
  if (name.empty()) return units.back();
  for (const KernelUnit& unit : units)
    if (unit.name == name) return unit;
  for (const std::string_view known : names)
    if (known == name) return Error{"simd_not_here", {{"name", name}}};
  return Error{"simd_unknown", {{"name", name}}};
}

Result<KernelUnit> choose_unit_by_environment() {
  const char* name = std::getenv("CROMER_SIMD");
  return choose_unit(name ? name : "");
}

}  // namespace cromer::core
