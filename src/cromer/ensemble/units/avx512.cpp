#define CROMER_UNIT avx512
#define CROMER_PACK_ARCH xsimd::avx512bw
#include "cromer/ensemble/units/unit.h"
