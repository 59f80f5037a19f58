// Steps of fixed length that are looked into: with events, or while a mass slides with dry friction.
#pragma once

#include <limits>

#include "cromer/base/interrupt.h"
#include "cromer/run/course.h"
#include "cromer/run/keep.h"
#include "cromer/run/look_inside.h"
#include "cromer/run/stepper.h"

namespace cromer::core {

/// Goes on from where the course stands, from row to row, until the last one, the end of the phase (rest, or
/// phase_end [s], to 1e-9 of a step), or an early end. A phase that begins between two rows first makes a
/// shorter step to the next: a method's partial step is as good as its step, so phases and events keep its
/// order. The stepper has been started where the course stands.
void take_fixed_steps(Stepper& stepper, const Rows& rows, const Lookout& look, Course<double>& course,
                      AnyRecorder record, const Watch& watch, const Limits& limits,
                      double phase_end = std::numeric_limits<double>::infinity());

}  // namespace cromer::core
