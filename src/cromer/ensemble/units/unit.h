// What one unit does: everything of the kernel, for one instruction set.
//
// A unit defines CROMER_UNIT, a name, CROMER_PACK_ARCH, its architecture in xsimd, and CROMER_ADVANCE, the
// name of its function, and includes this first. The linker may keep any one of the copies of an inline
// function that units emit, and an older machine would meet instructions it has not: so all code of a unit,
// xsimd's too, lies in namespaces of its own, and only plain numbers go in and out (group.h). A test looks
// through the symbols.
#define CROMER_JOINED(a, b) a##_##b
#define CROMER_JOIN(a, b) CROMER_JOINED(a, b)
#define cromer CROMER_JOIN(cromer_in, CROMER_UNIT)
#define xsimd CROMER_JOIN(xsimd_in, CROMER_UNIT)

#include <cstddef>
#include <tuple>
#include <utility>

#include "cromer/ensemble/group.h"
#include "cromer/ensemble/members.h"
#include "cromer/methods/all.h"

namespace cromer::core {

/// By the method at that place of the list; false if it has no formula of fixed steps.
template <class Real, std::size_t place>
bool advance_by(cromer_group::Group& group, const cromer_group::Order& order,
                const MethodSettings& settings) {
  using M = std::tuple_element_t<place, AllMethods>;
  if constexpr (M::info.order > 0 && M::info.error_order == 0) {
    const M method = make_method<M>(settings);
    order.weights ? advance_with_terms<Real, M, true>(group, method, order)
                  : advance_with_terms<Real, M, false>(group, method, order);
    return true;
  } else {
    return false;
  }
}

}  // namespace cromer::core

extern "C" bool CROMER_ADVANCE(cromer_group::Group& group, const cromer_group::Order& order) {
  using namespace cromer::core;
  const MethodSettings settings{.newton = {.tolerance = order.tolerance},
                                .beta = order.beta,
                                .gamma = order.gamma,
                                .rho_inf = order.rho_inf};
  return [&]<std::size_t... place>(std::index_sequence<place...>) {
    return ((order.method == place && advance_by<Pack<CROMER_PACK_ARCH>, place>(group, order, settings)) ||
            ...);
  }
  (std::make_index_sequence<std::tuple_size_v<AllMethods>>{});
}
