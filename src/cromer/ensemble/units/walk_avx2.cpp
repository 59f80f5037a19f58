#define CROMER_UNIT avx2
#define CROMER_PACK_ARCH xsimd::fma3<xsimd::avx2>
#include "cromer/ensemble/units/walk.h"
