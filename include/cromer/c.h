/* The door for other languages: a request and arrays in, a document and arrays out. C99, no exceptions, no
 * globals: any number of threads may call at once. */
#ifndef CROMER_C_H
#define CROMER_C_H

#include <stddef.h>

#include <cromer/export.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A named column of numbers. Which names a call takes depends on the verb; arrays that come back belong to
 * the result. */
typedef struct cromer_array {
  const char* name;
  const double* values;
  size_t length;
} cromer_array;

typedef struct cromer_result cromer_result;

/* Called now and then with the share done, 0 to 1, from a working thread; returning 0 ends the work. */
typedef int (*cromer_progress)(double done, void* user);

/* Status of a call: the document says more. */
enum {
  CROMER_DONE = 0,
  CROMER_NO_SUCCESS = 1, /* not converged, diverged, interrupted: what exists comes back */
  /* the document is {"message", "argument", "code", "values"}: a sentence, the argument at fault or null, and
   * what the sentence is made of */
  CROMER_BAD_INPUT = 2
};

/* verb: read, fit, simulate, compare, methods, spectrum or sweep. request: a JSON object (UTF-8; NULL or ""
 * for {}) whose names are the options of the program with _ for -: {"mass": "217.6 ± 0.3 g", "law": "auto"};
 * numbers are SI, texts may have units, an option that may be given several times takes a list. "file"
 * names a file; "language" is the language of the document's sentences, "en" (if not given) or "de".
 *
 * Arrays: fit and compare take t [s], y [SI unit of "observed": position, angle, velocity, angular_velocity,
 * acceleration] and force [N]; simulate takes force [N] or acceleration [m/s^2] of the ground, with "spacing"
 * [s]; spectrum takes acceleration [m/s^2], second and periods [s], with "spacing" [s]; sweep takes any
 * option that has a grid, by its name, for instance drive_frequency.
 *
 * What comes back: read: each column by its title; fit: t, measured, residual, x, v of each run as "1.t";
 * simulate: t, x, v, energy of each run; compare: t, x, v of each curve; spectrum: period, displacement;
 * sweep: a column each. NULL only if memory has run out. */
CROMER_API cromer_result* cromer_call(const char* verb, const char* request, const cromer_array* arrays,
                                      size_t count, cromer_progress progress, void* user);

/* The document of the program's --json, without what the arrays hold. */
CROMER_API const char* cromer_document(const cromer_result* result);
CROMER_API int cromer_status(const cromer_result* result);
CROMER_API const cromer_array* cromer_arrays(const cromer_result* result, size_t* count);
CROMER_API void cromer_free(cromer_result* result);

/* "0.1.0" */
CROMER_API const char* cromer_version(void);

#ifdef __cplusplus
}
#endif

#endif
