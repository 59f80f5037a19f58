#define CROMER_UNIT baseline
#if defined(__x86_64__)
#define CROMER_PACK_ARCH xsimd::sse2
#else
#define CROMER_PACK_ARCH xsimd::default_arch
#endif
#include "cromer/ensemble/units/unit.h"
