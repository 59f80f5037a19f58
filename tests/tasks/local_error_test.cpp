#include "cromer/tasks/curves/local_error.h"

#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

LocalErrorOptions spring(std::vector<std::string> methods) {
  LocalErrorOptions options;
  options.simulate.mass = 0.2008;
  options.simulate.stiffness = 16.6;
  options.simulate.position = 0.03;
  options.simulate.method = std::move(methods);
  return options;
}

TEST(LocalErrors, of_first_order_methods_have_slope_two_and_the_missing_taylor_terms) {
  const auto result = local_errors(spring({"forward-euler", "euler-cromer"}));
  ASSERT_TRUE(result) << in_words(result.error());
  for (const LocalErrorCurve& curve : result->curves) {
    EXPECT_NEAR(curve.x_slope, 2, 0.1) << curve.method;
    EXPECT_NEAR(curve.v_slope, 2, 0.1) << curve.method;
    // h^2/2 F/m missed (forward Euler) or taken twice (Euler-Cromer); of the velocity both miss h^2/2
    // d(F/m)/dt.
    EXPECT_NEAR(curve.x_over_predicted, 1, 0.01) << curve.method;
    EXPECT_NEAR(curve.v_over_predicted, 1, 0.01) << curve.method;
  }
}

TEST(LocalErrors, of_higher_order_methods_are_steeper) {
  const auto result = local_errors(spring({"verlet"}));
  ASSERT_TRUE(result) << in_words(result.error());
  EXPECT_NEAR(result->curves[0].x_slope, 3, 0.1);
  EXPECT_LT(result->curves[0].x_over_predicted, 0.01);
}

TEST(LocalErrors, need_a_closed_form_and_a_period) {
  auto dragged = spring({"euler-cromer"});
  dragged.simulate.law.drag = 0.02;
  EXPECT_NE(in_words(local_errors(dragged).error()).find("--drag"), std::string::npos);
  auto free = spring({"euler-cromer"});
  free.simulate.stiffness = 0;
  free.simulate.step = 0.01;
  free.simulate.until = 1;
  EXPECT_NE(in_words(local_errors(free).error()).find("--stiffness"), std::string::npos);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
