/* The C interface, which other languages call: a request and arrays in, a document and arrays out. C99, no
 * exceptions, no globals: any number of threads may call at once. */
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

/* Called up to twenty times a second with the share done, 0 to 1: from the calling thread or from one that
 * works for it, never from two at once. Returning 0 ends the work. */
typedef int (*cromer_progress)(double done, void* user);

/* Status of a call: the document says more. */
enum {
  CROMER_DONE = 0,
  CROMER_NO_SUCCESS = 1, /* not converged, diverged, interrupted: what exists comes back */
  /* the document is {"message", "argument", "code", "values"}: a sentence, the argument at fault or null, and
   * what the sentence is made of */
  CROMER_BAD_INPUT = 2
};

/* verb: read, fit, simulate, compare, methods, modes, spectrum or sweep.
 *
 * request: a JSON object (UTF-8; NULL or "" for {}) whose names are the options of the program with _ for -:
 * {"mass": "217.6 ± 0.3 g", "law": "auto"}. Numbers are SI, texts may have units, [0.2176, 0.0003] is a value
 * with its standard uncertainty; an option that has a grid or may be given several times takes a list. "file"
 * names the recording of read, fit, compare, modes and spectrum. "network", of simulate, fit and modes, is a
 * network of masses: its file, or an object as the file would be, {"mass": [{"name": "left", "mass": "2 kg"},
 * ...], "link": [...]}. "language" is the language of the document's sentences, "en" (if not given) or "de".
 *
 * Arrays in. fit: t [s], y [SI unit of "observed": position (if not given), angle, velocity,
 * angular_velocity or acceleration] and force [N]; with a network t and one array for each mass, in the order
 * of the network. modes: t, and all others are channels [SI unit of "observed"]. compare: t and y. simulate:
 * force [N] or acceleration [m/s^2] of the ground, with "spacing" [s]. spectrum: acceleration [m/s^2], second
 * [m/s^2] and periods [s], with "spacing" [s]. sweep: any option that has a grid, by its name, for instance
 * drive_frequency.
 *
 * Arrays out. read: each column by its title. fit: of run 1 "1.t", "1.measured", "1.residual", "1.x", "1.v".
 * simulate: of the first run "1.t", "1.x", "1.v", "1.energy", and "1.sensor" if there is one; a run for each
 * "method". Of a network's mass left "1.left.x" and "1.left.v", and if it is fitted "1.left.measured" and
 * "1.left.residual". compare: of the first curve of run 1 "1.1.t", "1.1.x", "1.1.v". spectrum: "period",
 * "displacement" (of the first component), of two components "rotd50" and "rotd100"; with several damping
 * ratios "1.displacement" and so on. sweep: each column of its rows by its title, "amplitude (m)". NULL only
 * if memory has run out. */
CROMER_API cromer_result* cromer_call(const char* verb, const char* request, const cromer_array* arrays,
                                      size_t count, cromer_progress progress, void* user);

/* The document of the program's --json, without what the arrays hold. */
CROMER_API const char* cromer_document(const cromer_result* result);
/* The result once more, its document as the program writes it: form is "text" (for people, in English), "csv"
 * or "svg" (its figure). A result of its own, with CROMER_BAD_INPUT where there is none in that form. */
CROMER_API cromer_result* cromer_written_as(const cromer_result* result, const char* form);
/* The motion of a fit's law, of the run of that number, at times t [s] that strictly increase from the first
 * used sample's on: arrays "t", "x" [displacement from the equilibrium] and "v". Not of a motion that a
 * recorded force drives. */
CROMER_API cromer_result* cromer_motion_at(const cromer_result* fit, int run, const double* t, size_t length);
/* CROMER_DONE, CROMER_NO_SUCCESS or CROMER_BAD_INPUT (of NULL as well). */
CROMER_API int cromer_status(const cromer_result* result);
/* The arrays that came back; `count` is set to their number. They end with the result. */
CROMER_API const cromer_array* cromer_arrays(const cromer_result* result, size_t* count);
/* NULL is allowed. */
CROMER_API void cromer_free(cromer_result* result);

/* "0.1.0" */
CROMER_API const char* cromer_version(void);

#ifdef __cplusplus
}
#endif

#endif
