// What one unit of the filter walk does, for one instruction set; as unit.h. A unit defines CROMER_UNIT and
// CROMER_PACK_ARCH, CROMER_IN_FLIGHT, how many packs it walks together, and CROMER_WALK, the name of its
// function.
#define CROMER_JOINED(a, b) a##_##b
#define CROMER_JOIN(a, b) CROMER_JOINED(a, b)
#define cromer CROMER_JOIN(cromer_in, CROMER_UNIT)
#define xsimd CROMER_JOIN(xsimd_in, CROMER_UNIT)

#include "cromer/ensemble/filter_lanes.h"
#include "cromer/ensemble/pack.h"

extern "C" void CROMER_WALK(const cromer_walk::Filters& filters, const cromer_walk::Walk& walk,
                            cromer_walk::Block* blocks) {
  cromer::core::walk_lanes<cromer::core::Pack<CROMER_PACK_ARCH>, CROMER_IN_FLIGHT>(filters, walk, blocks);
}
