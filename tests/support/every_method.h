// Tests over the registry: a loop over all methods, and the fixture that is given the name of one.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "cromer/methods/all.h"
#include "cromer/run/solve.h"

namespace cromer::core {

/// Calls f(method) for every method, in the order of the list.
template <class F>
void for_each_method(const MethodSettings& settings, F&& f) {
  [&]<class... M>(std::type_identity<std::tuple<M...>>) {
    (f(make_method<M>(settings)), ...);
  }(std::type_identity<AllMethods>{});
}

class EveryMethod : public testing::TestWithParam<std::string_view> {
 protected:
  const MethodInfo& info() const { return *find_method(GetParam()); }

  template <class F>
  auto with_method(F&& f) const {
    return visit_method(GetParam(), MethodSettings{.newton = {.tolerance = 1e-14}}, f);
  }

  /// The end of a run in steps of one length, also for methods that would choose their own.
  template <class S, class Real>
  State<Real> end(const S& system, State<Real> start, double until, double step) const {
    return with_method([&](const auto& method) {
      State<Real> y = start;
      using M = std::decay_t<decltype(method)>;
      if constexpr (AdaptiveMethod<M, S, Real>) {
        const Steps steps = count_steps({0, until}, step);
        auto memory = method.start(system, 0.0, y);
        for (long long n = 0; n < steps.whole; ++n)
          y = method.step(system, static_cast<double>(n) * step, step, y, memory).y;
        if (steps.last > 0) y = method.step(system, until - steps.last, steps.last, y, memory).y;
      } else {
        const Outcome outcome = solve(system, method, {0, until}, start, step,
                                      [&](double, const State<Real>& reached) { y = reached; });
        EXPECT_EQ(outcome.status, Status::reached_end);
      }
      return y;
    });
  }

  template <class S>
  State<double> end(const S& system, State<double> start, double until, double step) const {
    return end<S, double>(system, start, until, step);
  }
};

/// The method of a test, as a part of its name.
inline std::string name_of_test(const testing::TestParamInfo<std::string_view>& test) {
  std::string name(test.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace cromer::core
