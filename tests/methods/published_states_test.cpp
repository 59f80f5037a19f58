// The states that every method must reproduce, to 25 digits, from tests/problems.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "cromer/model/driven_oscillator.h"
#include "tests/support/every_method.h"
#include "tests/support/problems.h"

namespace cromer::core {
namespace CROMER_FILE {

/// Calls f with the law of a problem. The laws of the file are these four; with_terms would compile them all.
template <class F>
auto with_law(const problems::Problem& p, F&& f) {
  const auto call = [&]<Terms terms>() {
    return f(
        DrivenOscillator<double, terms>(divided_by_mass(p.oscillator), force_of(p.drive, p.oscillator.mass)));
  };
  const Terms present = terms_of(p.oscillator, p.drive);
  constexpr Terms driven{.drive = true}, damped{.law = law_of("viscous")},
      both{.drive = true, .law = law_of("viscous")}, all{.drive = true, .law = law_of("viscous+drag+cubic")};
  if (present == driven) return call.template operator()<driven>();
  if (present == damped) return call.template operator()<damped>();
  if (present == both) return call.template operator()<both>();
  EXPECT_EQ(present, all);
  return call.template operator()<all>();
}

using PublishedStates = EveryMethod;

INSTANTIATE_TEST_SUITE_P(Registry, PublishedStates, testing::ValuesIn(method_names), name_of_test);

TEST_P(PublishedStates, AreMet) {
  const auto truth_file = problems::read("discrete.json");
  int compared = 0;
  for (const auto& [name, problem] : truth_file.items()) {
    const auto& methods = problem.at("methods");
    if (!methods.contains(std::string(GetParam()))) continue;
    const problems::Problem p(problem.at("parameters"));
    const double h = problems::number(problem, "step");
    for (const auto& entry : methods.at(std::string(GetParam()))) {
      const double until = entry.at("steps").get<double>() * h;
      const State<double> y = with_law(p, [&](const auto& system) { return end(system, p.start, until, h); });
      const double x = problems::number(entry, "x"), v = problems::number(entry, "v");
      EXPECT_NEAR(y.x, x, 1e-11 * std::max(1.0, std::abs(x))) << name << " after " << entry.at("steps");
      EXPECT_NEAR(y.v, v, 1e-11 * std::max(1.0, std::abs(v))) << name << " after " << entry.at("steps");
      ++compared;
    }
  }
  if (compared == 0) GTEST_SKIP() << "not in the file";
  EXPECT_EQ(compared, 20);
}

TEST(PublishedStatesFile, HasNoMethodThatTheRegistryLacks) {
  const auto truth_file = problems::read("discrete.json");
  for (const auto& [name, problem] : truth_file.items())
    for (const auto& [method, states] : problem.at("methods").items())
      EXPECT_NE(find_method(method), nullptr) << method << " in " << name;
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
