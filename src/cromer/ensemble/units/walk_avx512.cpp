#define CROMER_UNIT avx512
#define CROMER_PACK_ARCH xsimd::avx512bw
#define CROMER_IN_FLIGHT 3
#define CROMER_WALK cromer_walk_avx512
#include "cromer/ensemble/units/walk.h"
