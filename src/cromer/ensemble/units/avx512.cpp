#define CROMER_UNIT avx512
#define CROMER_PACK_ARCH xsimd::avx512bw
#define CROMER_ADVANCE cromer_advance_avx512
#include "cromer/ensemble/units/unit.h"
