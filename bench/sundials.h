// SUNDIALS' CVODE (Adams, fixed-point iteration) and ARKODE (explicit, Dormand-Prince's table) on the cases.
#pragma once

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <vector>

#include "bench/cases.h"
#include "cromer/model/law_force.h"

namespace cromer::core::bench {

/// The law as SUNDIALS calls it.
template <Terms terms>
int sundials_law(realtype t, N_Vector y, N_Vector slope, void* run) {
  const double* u = NV_DATA_S(y);
  double* s = NV_DATA_S(slope);
  s[0] = u[1];
  s[1] = acceleration<terms>(*static_cast<const ForcedRun*>(run), t, u[0], u[1]);
  return 0;
}

/// The start as a vector.
inline N_Vector sundials_start(const ForcedRun& run, SUNContext context) {
  N_Vector y = N_VNew_Serial(2, context);
  NV_DATA_S(y)[0] = run.start.x;
  NV_DATA_S(y)[1] = run.start.v;
  return y;
}

/// Positions at the rows; returns the number of evaluations.
template <Terms terms>
long long cvode(const ForcedRun& run, double row_spacing, double tolerance, std::vector<double>& x) {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  N_Vector y = sundials_start(run, context);
  void* solver = CVodeCreate(CV_ADAMS, context);
  CVodeInit(solver, sundials_law<terms>, run.interval.from, y);
  CVodeSStolerances(solver, tolerance, tolerance);
  CVodeSetUserData(solver, const_cast<ForcedRun*>(&run));
  CVodeSetMaxNumSteps(solver, 1'000'000);
  SUNNonlinearSolver iteration = SUNNonlinSol_FixedPoint(y, 0, context);
  CVodeSetNonlinearSolver(solver, iteration);
  x.push_back(run.start.x);
  const long long rows = count_steps(run.interval, row_spacing).whole;
  for (long long i = 1; i <= rows; ++i) {
    realtype t = 0;
    if (CVode(solver, run.interval.from + static_cast<double>(i) * row_spacing, y, &t, CV_NORMAL) < 0) break;
    x.push_back(NV_DATA_S(y)[0]);
  }
  long evaluations = 0;
  CVodeGetNumRhsEvals(solver, &evaluations);
  CVodeFree(&solver);
  SUNNonlinSolFree(iteration);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return evaluations;
}

/// Likewise.
template <Terms terms>
long long arkode(const ForcedRun& run, double row_spacing, double tolerance, std::vector<double>& x) {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  N_Vector y = sundials_start(run, context);
  void* solver = ERKStepCreate(sundials_law<terms>, run.interval.from, y, context);
  ERKStepSetTableNum(solver, ARKODE_DORMAND_PRINCE_7_4_5);
  ERKStepSStolerances(solver, tolerance, tolerance);
  ERKStepSetUserData(solver, const_cast<ForcedRun*>(&run));
  ERKStepSetMaxNumSteps(solver, 1'000'000);
  x.push_back(run.start.x);
  const long long rows = count_steps(run.interval, row_spacing).whole;
  for (long long i = 1; i <= rows; ++i) {
    realtype t = 0;
    if (ERKStepEvolve(solver, run.interval.from + static_cast<double>(i) * row_spacing, y, &t, ARK_NORMAL) <
        0)
      break;
    x.push_back(NV_DATA_S(y)[0]);
  }
  long evaluations = 0;
  ERKStepGetNumRhsEvals(solver, &evaluations);
  ERKStepFree(&solver);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return evaluations;
}

}  // namespace cromer::core::bench
