// What is handed to a function is what is kept, whichever loop runs.
#include "cromer/run/keep.h"

#include <gtest/gtest.h>

#include "cromer/methods/dormand_prince.h"
#include "cromer/methods/rk4.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace CROMER_FILE {

const Oscillator<double> spring{.mass = 1, .stiffness = 9};
const DrivenOscillator<double, Terms{.drive = true}> pushed(spring, {1, 3, 0});

/// The states of a run that ends with a shorter step, kept and handed on.
template <class S, class M>
void expect_the_same(const S& system, const M& method, EventLog* events = nullptr) {
  const Interval interval{0, 10.005};
  const auto run = [&](KeepEvery& keep) {
    return solve(system, method, interval, State<double>{1, 0.2}, StepControl(0.01), keep, {}, {}, events);
  };
  Trajectory seen;
  const auto see = [&](double t, const State<double>& y) {
    seen.t.push_back(t);
    seen.x.push_back(y.x);
    seen.v.push_back(y.v);
  };
  KeepEvery each{AnyRecorder(see)}, keep(1, count_steps(interval, 0.01));
  const Outcome handed = run(each), kept = run(keep);
  const Trajectory all = keep.take();
  EXPECT_EQ(all.size(), 1002u);
  EXPECT_EQ(seen.t, all.t);
  EXPECT_EQ(seen.x, all.x);
  EXPECT_EQ(seen.v, all.v);
  EXPECT_EQ(handed.y, kept.y);
}

TEST(KeepEvery, HandsOnAllStatesOfTheFastLoop) { expect_the_same(pushed, Rk4{}); }

TEST(KeepEvery, HandsOnAllStatesOfARunThatIsWatched) {
  EventLog log{.events = {{.quantity = Event::Quantity::position}}};
  expect_the_same(pushed, Rk4{}, &log);
}

TEST(KeepEvery, HandsOnAllStatesOfAnAdaptiveMethod) { expect_the_same(pushed, DormandPrince{}); }

TEST(KeepEvery, HandsOnAllStatesOfAMassThatSlidesAndSticks) {
  const DryFriction rubbing(DrivenOscillator<double, Terms{}>(spring, {}), 0.5, 0.7);
  expect_the_same(rubbing, Rk4{});
  expect_the_same(rubbing, DormandPrince{});
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
