// Marks what the library shows; everything else is hidden.
#pragma once

#if defined(_WIN32) && defined(CROMER_BUILDING)
#define CROMER_API __declspec(dllexport)
#elif defined(_WIN32)
#define CROMER_API
#else
#define CROMER_API __attribute__((visibility("default")))
#endif
