// fmt asks for printf only to write hexadecimal fractions, which nothing does; with it would come the
// arithmetic of long double in software.
#include <cstdio>

extern "C" int snprintf(char*, std::size_t, const char*, ...) { return 0; }
