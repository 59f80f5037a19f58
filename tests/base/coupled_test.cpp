#include "cromer/base/coupled.h"

#include <gtest/gtest.h>

namespace cromer::core {
namespace CROMER_FILE {

TEST(Coupled, AddsAndMultipliesByComponents) {
  const Coupled<double> a{1, 2}, b{10, 20};
  EXPECT_EQ(a + b, (Coupled<double>{11, 22}));
  EXPECT_EQ(b - a, (Coupled<double>{9, 18}));
  EXPECT_EQ(2 * a, (Coupled<double>{2, 4}));
  EXPECT_EQ(b / 2.0, (Coupled<double>{5, 10}));
  EXPECT_EQ(value_of(b), 10);
}

TEST(Coupled, IsTurnedComparedAndMeasured) {
  Coupled<double> a{1, -2};
  EXPECT_EQ(-a, (Coupled<double>{-1, 2}));
  EXPECT_EQ((a * 3.0), (Coupled<double>{3, -6}));
  a += Coupled<double>{2, 5};
  EXPECT_EQ(a, (Coupled<double>{3, 3}));
  a -= Coupled<double>{5, 4};
  EXPECT_EQ(a, (Coupled<double>{-2, -1}));
  EXPECT_EQ(Coupled<double>(7), (Coupled<double>{7, 7}));
  EXPECT_TRUE((Coupled<double>{1, 9} < Coupled<double>{2, 0}));
  EXPECT_FALSE((Coupled<double>{1, 0} < Coupled<double>{1, 9}));
  EXPECT_EQ(magnitude(a), (Coupled<double>{2, 1}));
  EXPECT_EQ(larger(Coupled<double>{1, 5}, Coupled<double>{2, 3}), (Coupled<double>{2, 5}));
  EXPECT_EQ(larger(2, 1), 2);
  EXPECT_TRUE(all(true));
  EXPECT_FALSE(all(false));
  EXPECT_EQ(choose(true, 1, 2), 1);
  EXPECT_EQ(choose(false, 1, 2), 2);
}

TEST(Coupled, OfNumbersBecomesOneOfDuals) {
  const Coupled<Dual<double, 1>> pair{Coupled<double>{1, 2}};
  EXPECT_EQ(pair.first.value, 1);
  EXPECT_EQ(pair.second.value, 2);
  EXPECT_EQ(pair.second.derivative[0], 0);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
