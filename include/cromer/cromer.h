// Cromer: the oscillator on a spring, from a recording to its law of motion and back.
//
// Eight verbs: read, fit, simulate, compare, methods, modes, response_spectrum, sweep. Arrays go in as spans
// of doubles in SI units, results come out as plain structs. A bad argument gives an Error in a Result. How a
// computation went is a status in its result; what else there is to know stands in its notices. Nothing
// throws, except the standard library when memory runs out, and value() of an Error. Every call depends on
// its arguments alone (those that read a file on it as well) and may run in any thread.
#pragma once

#include <cromer/compare.h>     // IWYU pragma: export
#include <cromer/document.h>    // IWYU pragma: export
#include <cromer/drive.h>       // IWYU pragma: export
#include <cromer/fit.h>         // IWYU pragma: export
#include <cromer/methods.h>     // IWYU pragma: export
#include <cromer/network.h>     // IWYU pragma: export
#include <cromer/notice.h>      // IWYU pragma: export
#include <cromer/oscillator.h>  // IWYU pragma: export
#include <cromer/quantity.h>    // IWYU pragma: export
#include <cromer/read.h>        // IWYU pragma: export
#include <cromer/result.h>      // IWYU pragma: export
#include <cromer/simulate.h>    // IWYU pragma: export
#include <cromer/spectrum.h>    // IWYU pragma: export
#include <cromer/sweep.h>       // IWYU pragma: export
#include <cromer/version.h>     // IWYU pragma: export
