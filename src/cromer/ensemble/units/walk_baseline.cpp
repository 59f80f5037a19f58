#define CROMER_UNIT baseline
#define CROMER_PACK_ARCH xsimd::sse2
#define CROMER_IN_FLIGHT 3
#define CROMER_WALK cromer_walk_baseline
#include "cromer/ensemble/units/walk.h"
