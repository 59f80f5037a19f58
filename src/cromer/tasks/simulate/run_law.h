// A law, a method and a drive, by their values and names: what every task runs.
#pragma once

#include <string_view>

#include "cromer/base/interrupt.h"
#include "cromer/base/state.h"
#include "cromer/methods/method.h"
#include "cromer/methods/method_settings.h"
#include "cromer/model/general_drive.h"
#include "cromer/model/oscillator.h"
#include "cromer/run/course.h"
#include "cromer/run/event.h"
#include "cromer/run/keep.h"
#include "cromer/run/step_control.h"

namespace cromer::core {

/// What to run.
struct LawRun {
  Oscillator<double> oscillator;
  HarmonicDrive<double> drive{};                  ///< ignored if there is a general one
  const GeneralDrive<double>* general = nullptr;  ///< outlives the run
  std::string_view method;                        ///< in the list of methods; it can integrate the law
  MethodSettings settings{};
  Interval interval{};
  State<double> start{};
  StepControl control;
  EventLog* events = nullptr;  ///< what to watch for and what was found, without hysteresis; nullptr: none
  bool compensated = false;    ///< states in compensated sums: without friction and events, under a harmonic
                               ///< drive or none, by a method that takes_fixed_steps
};

/// Runs it as solve does. Every law is compiled with every method here, once for all tasks, in a unit for
/// each kind of drive: a task that called solve by itself would compile them again.
Outcome run_law(const LawRun& run, KeepEvery& keep, const Watch& watch = {});

/// How many steps, 1 to `most`, forward Euler takes of this swing before it goes to where a spring gives way
/// or a pendulum is over its top, or `times` as far as its amplitude (> 0), which negative damping lets grow.
long long steps_within_swing(const Oscillator<double>& law, const State<double>& start, double amplitude,
                             double times, double step, long long most);

}  // namespace cromer::core
