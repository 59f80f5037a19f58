// The benchmarks time these runs; here it is checked that they are the runs they claim to be.
#include <gtest/gtest.h>

#include <cmath>

#include "bench/cases.h"
#include "cromer/methods/all.h"
#include "cromer/model/terms.h"
#include "cromer/study/task/run_law.h"

namespace cromer {
namespace {

TEST(BenchCases, EveryMethodRunsThemAndAgrees) {
  for (const bench::ForcedRun& run : bench::forced_runs) {
    const auto end = [&](std::string_view method, double step, long long& kept) {
      KeepEvery keep(1, count_steps(run.interval, step));
      const Outcome outcome = run_law({.oscillator = run.oscillator,
                                       .drive = run.drive,
                                       .method = method,
                                       .interval = run.interval,
                                       .start = run.start,
                                       .control = step},
                                      keep);
      EXPECT_EQ(outcome.status, Status::reached_end) << method;
      kept = static_cast<long long>(keep.take().size());
      return outcome.y;
    };
    long long kept = 0;
    const State<double> fine = end("rk4", run.step / 8, kept);
    for (const MethodInfo& info : method_infos) {
      if (info.name == "exact" && *why_not_exact(run.oscillator)) continue;
      const State<double> y = end(info.name, run.step, kept);
      EXPECT_EQ(kept, 8001) << info.name;
      // Euler's methods, one per cent steps at resonance: they get the amplitude wrong by up to three
      // quarters.
      const double tolerance = info.order == 1 ? 1.5 : info.order == 2 ? 3e-3 : 2e-6;
      EXPECT_NEAR(y.x, fine.x, tolerance) << run.name << ' ' << info.name;
    }
  }
}

}  // namespace
}  // namespace cromer
