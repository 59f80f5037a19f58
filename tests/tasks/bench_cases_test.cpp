// The benchmarks time these runs; here it is checked that they are the runs they claim to be.
#include <gtest/gtest.h>

#include <cmath>

#include "bench/cases.h"
#include "cromer/methods/all.h"
#include "cromer/model/law_force.h"
#include "cromer/tasks/simulate/run_law.h"

namespace cromer::core {
namespace CROMER_FILE {

/// The end of the run by a method in so many steps for each of the benchmark's.
State<double> end_of(const bench::ForcedRun& run, std::string_view method, int finer) {
  KeepEvery keep(1, count_steps(run.interval, run.step / finer));
  const Outcome outcome = run_law({.oscillator = run.oscillator,
                                   .drive = run.drive,
                                   .method = method,
                                   .interval = run.interval,
                                   .start = run.start,
                                   .control = run.step / finer},
                                  keep);
  EXPECT_EQ(outcome.status, Status::reached_end) << method;
  EXPECT_EQ(keep.take().size(), 8000u * static_cast<unsigned>(finer) + 1) << method;
  return outcome.y;
}

/// Of position and velocity, in metres.
double distance(const State<double>& a, const State<double>& b) {
  return std::hypot(a.x - b.x, (a.v - b.v) / 3);
}

TEST(BenchCases, EveryMethodRunsThemWithTheErrorOfItsOrder) {
  for (const bench::ForcedRun& run : bench::forced_runs) {
    const bool linear = why_not_exact(run.oscillator).empty();
    const State<double> truth = linear ? end_of(run, "exact", 1) : end_of(run, "gauss-legendre4", 32);
    ASSERT_LT(distance(end_of(run, "rk4", 32), truth), 3e-12) << run.name << ": two ways to the truth";
    ASSERT_GT(std::abs(truth.x), 0.5);
    for (const MethodInfo& info : method_infos) {
      if (info.is_exact()) continue;
      const auto error = [&](int finer) { return distance(end_of(run, info.name, finer), truth); };
      if (info.is_adaptive()) {
        EXPECT_LT(error(1), 25 * StepControl::default_tolerance) << run.name << ' ' << info.name;
        continue;
      }
      // Euler's damping at this step is not small beside the law's; the drag, which is not smooth where the
      // mass turns, unsettles order four.
      const double bend = info.order == 1 ? 0.5 : linear || info.order < 4 ? 0.05 : 0.7;
      EXPECT_NEAR(std::log2(error(1) / error(2)), info.order, bend) << run.name << ' ' << info.name;
      if (info.order == 1) {
        EXPECT_NEAR(std::log2(error(8) / error(16)), 1, 0.05) << run.name << ' ' << info.name;
      }
    }
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
