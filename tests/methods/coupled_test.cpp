// A state with a third number, through the methods.
#include "cromer/base/coupled.h"

#include <gtest/gtest.h>

#include "cromer/base/state.h"
#include "cromer/methods/dormand_prince.h"
#include "cromer/methods/rk4.h"

namespace cromer::core {
namespace CROMER_FILE {

/// x'' = -x - z, z' = 2 v - z.
struct Relaxing {
  template <class Time, class Real>
  Coupled<Real> acceleration(const Time&, const Coupled<Real>& x, const Coupled<Real>& v) const {
    return {-x.first - v.second, 2.0 * v.first - v.second};
  }
};

template <class M, class Real>
State<Coupled<Real>> end(const M& method, const Coupled<Real>& v) {
  State<Coupled<Real>> y{Coupled<Real>{Real(1.0), Real(0.0)}, v};
  auto memory = method.start(Relaxing{}, 0.0, y);
  for (int n = 0; n < 400; ++n) y = method.step(Relaxing{}, n * 0.005, 0.005, y, memory).y;
  return y;
}

TEST(Coupled, CarriesDualsThroughAMethod) {
  // x at t = 2 is linear in z at 0: its derivative is the difference.
  using D = Dual<double, 1>;
  const auto by = [&](const auto& method) {
    const auto y = end(method, Coupled<D>{D(0.0), D::variable(0.5, 0)});
    const double more = end(method, Coupled<double>{0, 1.5}).x.first;
    const double less = end(method, Coupled<double>{0, 0.5}).x.first;
    EXPECT_NEAR(y.x.first.value, less, 1e-15);
    EXPECT_NEAR(y.x.first.derivative[0], more - less, 1e-14);
    return less;
  };
  EXPECT_NEAR(by(Rk4{}), by(DormandPrince{}), 1e-10);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
