// The kernel's units: they do what the scalar run does, however a run is cut, and share no code.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "cromer/analysis/energy.h"
#include "cromer/documents/words/words.h"
#include "cromer/ensemble/dispatch.h"
#include "cromer/ensemble/group.h"
#include "cromer/methods/all.h"
#include "cromer/run/keep.h"
#include "cromer/tasks/simulate/run_law.h"
#include "tests/support/cases.h"

namespace cromer::core {
namespace CROMER_FILE {

using cromer_group::Group;
using cromer_group::Order;

struct Case {
  const char* name;
  Oscillator<double> oscillator;  // of mass 1
  double drive = 0;               // [m/s^2]
};

/// Small enough for the spring to lead, whichever they are.
Oscillator<double> every_smooth_term() {
  Oscillator<double> o{.stiffness = 1};
  for_each_term([&]<class T>() {
    if (smooth_terms.without(law_with<Spring>).template has<T>()) o.*T::template members<double>[0] = 0.1;
  });
  return o;
}

/// Damped enough for forward Euler.
const Case laws[] = {
    {"linear", {.stiffness = 1, .damping = 0.05}},
    {"cubic", {.stiffness = 1, .damping = 0.1, .cubic = 0.4}},
    {"drag", {.stiffness = 1, .damping = 0.1, .drag = 0.1, .cubic = 0.4}},
    {"linear_driven", {.stiffness = 1, .damping = 0.05}, 0.3},
    {"cubic_driven", {.stiffness = 1, .damping = 0.2, .cubic = 0.1}, 0.3},
    {"drag_driven", {.stiffness = 1, .damping = 0.2, .drag = 0.1, .cubic = 0.1}, 0.3},
    {"any", every_smooth_term()},
    {"any_driven", every_smooth_term(), 0.3},
    {"van_der_pol", {.stiffness = 1, .damping = 0.1, .van_der_pol = 0.4}},
};

/// Every member a little different.
double nearby(double value, int i) { return value * (1 + 0.01 * i); }

Oscillator<double> oscillator_of(const Case& law, int i) {
  Oscillator<double> o = law.oscillator;
  o.stiffness = nearby(o.stiffness, i);
  o.damping = nearby(o.damping, i);
  return o;
}
HarmonicDrive<double> drive_of(const Case& law, int i) { return {law.drive, nearby(0.4, 3 * i), 0.1 * i}; }
State<double> start_of(int i) { return {nearby(1, i), 0.02 * i}; }
double step_of(int i) { return nearby(0.02, i); }

std::unique_ptr<Group> group_of(const Case& law) {
  auto group = std::make_unique<Group>();
  for (int i = 0; i < cromer_group::size; ++i) {
    const Oscillator<double> o = oscillator_of(law, i);
    const HarmonicDrive<double> drive = drive_of(law, i);
    for_each_term(
        [&]<class T>() { group->coefficients[place_of_term<T>].of[i] = o.*T::template members<double>[0]; });
    group->drive_amplitude.of[i] = drive.amplitude;
    group->drive_frequency.of[i] = drive.frequency;
    group->drive_phase.of[i] = drive.phase;
    group->step.of[i] = step_of(i);
    group->x.of[i] = start_of(i).x;
    group->v.of[i] = start_of(i).v;
  }
  group->driven = law.drive != 0;
  group->law = law_of(law.oscillator).terms;
  return group;
}

Trajectory scalar_run(const Case& law, int i, std::string_view method, long long steps) {
  const Interval interval{0, static_cast<double>(steps) * step_of(i)};
  KeepEvery keep(1, count_steps(interval, step_of(i)));
  run_law({.oscillator = oscillator_of(law, i),
           .drive = drive_of(law, i),
           .method = method,
           .interval = interval,
           .start = start_of(i),
           .control = step_of(i)},
          keep);
  return keep.take();
}

Order order_of(std::size_t method, long long steps) {
  return {static_cast<unsigned>(method), 1e-12, 0.25, 0.5, 0.8, steps, nullptr};
}

class OfUnit : public testing::TestWithParam<KernelUnit> {};
INSTANTIATE_TEST_SUITE_P(Units, OfUnit, testing::ValuesIn(units_here()),
                         [](const auto& unit) { return std::string(unit.param.name); });

TEST_P(OfUnit, LanesAgreeWithTheScalarRun) {
  constexpr long long steps = cases(10000);
  for (const Case& law : laws)
    for (std::size_t m = 0; m < method_infos.size(); ++m) {
      const MethodInfo& info = method_infos[m];
      if (!info.takes_fixed_steps()) continue;
      auto group = group_of(law);
      ASSERT_TRUE(GetParam().advance(*group, order_of(m, steps)));
      for (int i = 0; i < cromer_group::size; i += 5) {
        const Trajectory scalar = scalar_run(law, i, info.name, steps);
        ASSERT_EQ(scalar.size(), steps + 1);
        double peak = 0;
        for (std::size_t n = 1; n <= steps; ++n) peak = std::max(peak, std::abs(scalar.x[n]));
        const double limit = (law.drive != 0 ? 1e-12 : 1e-13) * peak;
        EXPECT_NEAR(group->x.of[i], scalar.x.back(), limit) << law.name << ' ' << info.name << ' ' << i;
        EXPECT_NEAR(group->v.of[i], scalar.v.back(), limit) << law.name << ' ' << info.name << ' ' << i;
        EXPECT_NEAR(group->peak.of[i], peak, limit) << law.name << ' ' << info.name;
        EXPECT_EQ(group->failed.of[i], 0);
      }
    }
}

TEST_P(OfUnit, ARunCutInPiecesIsTheSameToTheBit) {
  for (const Case& law : laws)
    for (std::size_t m = 0; m < method_infos.size(); ++m) {
      auto whole = group_of(law), cut = group_of(law);
      if (!GetParam().advance(*whole, order_of(m, 1000))) continue;
      for (const long long steps : {1, 127, 128, 300, 444}) GetParam().advance(*cut, order_of(m, steps));
      EXPECT_EQ(std::memcmp(whole.get(), cut.get(), sizeof(Group)), 0) << law.name << ' ' << method_names[m];
    }
}

TEST_P(OfUnit, AMemberDoesNotDependOnItsNeighbours) {
  for (std::size_t m = 0; m < method_infos.size(); ++m) {
    auto one = group_of(laws[5]), other = group_of(laws[5]);
    for (int i = 1; i < cromer_group::size; ++i) other->x.of[i] *= 50;
    if (!GetParam().advance(*one, order_of(m, 500))) continue;
    GetParam().advance(*other, order_of(m, 500));
    EXPECT_EQ(one->x.of[0], other->x.of[0]) << method_names[m];
    EXPECT_NE(one->x.of[1], other->x.of[1]);
  }
}

TEST_P(OfUnit, AMemberDoesNotDependOnItsPlace) {
  // The packs of a group are compiled one after the other, and roundings may be the compiler's choice.
  for (const Case& law : laws)
    for (std::size_t m = 0; m < method_infos.size(); ++m) {
      auto group = group_of(law);
      const auto like_the_third = [](cromer_group::Numbers& all) {
        std::fill(std::begin(all.of), std::end(all.of), all.of[3]);
      };
      for (cromer_group::Numbers& coefficient : group->coefficients) like_the_third(coefficient);
      for (cromer_group::Numbers* all : {&group->drive_amplitude, &group->drive_frequency,
                                         &group->drive_phase, &group->step, &group->x, &group->v})
        like_the_third(*all);
      if (!GetParam().advance(*group, order_of(m, 500))) continue;
      for (int i = 1; i < cromer_group::size; ++i) {
        EXPECT_EQ(group->x.of[i], group->x.of[0]) << law.name << ' ' << method_names[m] << ' ' << i;
        EXPECT_EQ(group->v.of[i], group->v.of[0]) << law.name << ' ' << method_names[m] << ' ' << i;
      }
    }
}

TEST_P(OfUnit, SumsGiveAmplitudePhaseAndEnergyOfTheSteadyState) {
  // With the exact weights of a motion that is known: the sums are those of its samples.
  const Case& law = laws[3];
  auto group = group_of(law);
  const std::size_t euler_cromer = 1;
  constexpr long long steps = 4000;
  std::vector<double> weights(steps);
  for (long long n = 0; n < steps; ++n) weights[n] = 1 + 0.5 * std::sin(0.01 * static_cast<double>(n));
  Order order = order_of(euler_cromer, steps);
  order.weights = weights.data();
  ASSERT_TRUE(GetParam().advance(*group, order));
  for (int i = 0; i < cromer_group::size; i += 7) {
    double x = 0, xc = 0, cs = 0, ss = 0, xx = 0, energy = 0;
    const HarmonicDrive<double> drive = drive_of(law, i);
    const Trajectory scalar = scalar_run(law, i, "euler-cromer", steps);
    for (std::size_t n = 0; n < steps; ++n) {
      const double w = weights[n], angle = drive.frequency * scalar.t[n] + drive.phase;
      const double c = std::cos(angle), sine = std::sin(angle);
      x += w * scalar.x[n], xc += w * scalar.x[n] * c, cs += w * c * sine, ss += w * sine * sine;
      xx += w * scalar.x[n] * scalar.x[n];
      energy += w * cromer::core::energy(oscillator_of(law, i), {scalar.x[n], scalar.v[n]});
    }
    EXPECT_NEAR(group->sums.x.of[i], x, 1e-10 * steps);
    EXPECT_NEAR(group->sums.xc.of[i], xc, 1e-10 * steps);
    EXPECT_NEAR(group->sums.cs.of[i], cs, 1e-10 * steps);
    EXPECT_NEAR(group->sums.ss.of[i], ss, 1e-10 * steps);
    EXPECT_NEAR(group->sums.xx.of[i], xx, 1e-10 * steps);
    EXPECT_NEAR(group->sums.energy.of[i], energy, 1e-10 * steps);
  }
}

TEST_P(OfUnit, TellsWhichLanesFoundNoSolution) {
  const std::size_t implicit_euler = 2;
  auto group = group_of(laws[1]);
  group->step.of[3] = 1e9;  // a cubic far beyond the limit of iterations
  group->coefficients[place_of_term<Cubic>].of[3] = -1e9;
  group->x.of[3] = 1e6;
  GetParam().advance(*group, order_of(implicit_euler, 20));
  EXPECT_NE(group->failed.of[3], 0);
  EXPECT_EQ(group->failed.of[2], 0);
  EXPECT_EQ(group->failed.of[4], 0);
}

TEST_P(OfUnit, UsesItsOwnRegisters) {
  auto group = group_of(laws[0]);
  GetParam().advance(*group, order_of(0, 1));
  EXPECT_EQ(group->lanes, GetParam().name == "avx512" ? 8 : GetParam().name == "avx2" ? 4 : 2);
}

TEST(Dispatch, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(choose_unit("baseline")->name, "baseline");
  EXPECT_EQ(choose_unit()->name, units_here().back().name);
  const auto refused = choose_unit("sse9");
  ASSERT_FALSE(refused);
  EXPECT_NE(in_words(refused.error()).find("CROMER_SIMD=sse9"), std::string::npos);
}

#if defined(__x86_64__) && defined(NDEBUG)
TEST(Symbols, AUnitSharesNoCode) {
  // The linker keeps any one copy of a weak symbol: none may be common to two instruction sets.
  std::FILE* pipe = popen("nm --defined-only -A -C " CROMER_ENSEMBLE_ARCHIVE, "r");
  ASSERT_NE(pipe, nullptr);
  char line[4096];
  int own = 0;
  while (std::fgets(line, sizeof line, pipe)) {
    const std::string text = line;
    const auto unit = text.find("avx512.cpp") != std::string::npos ? "_in_avx512"
                      : text.find("avx2.cpp") != std::string::npos ? "_in_avx2"
                                                                   : "";
    const bool weak = text.find(" W ") != std::string::npos || text.find(" V ") != std::string::npos ||
                      text.find(" u ") != std::string::npos;
    if (!*unit || !weak || text.find("DW.ref.") != std::string::npos) continue;
    ++own;
    EXPECT_NE(text.find(unit), std::string::npos) << text;
  }
  pclose(pipe);
  EXPECT_GT(own, 10);
}
#endif

}  // namespace CROMER_FILE
}  // namespace cromer::core
