#include "cromer/base/complex.h"

#include <gtest/gtest.h>

#include <complex>

namespace cromer::core {
namespace CROMER_FILE {

TEST(Complex, CalculatesAsTheStandardLibraryDoes) {
  const Complex<double> a{3, -2}, b{0.5, 4};
  const std::complex<double> p(3, -2), q(0.5, 4);
  const auto expect = [](const Complex<double>& got, const std::complex<double>& wanted) {
    EXPECT_DOUBLE_EQ(got.re, wanted.real());
    EXPECT_DOUBLE_EQ(got.im, wanted.imag());
  };
  expect(a + b, p + q);
  expect(a - b, p - q);
  expect(a * b, p * q);
  expect(a / b, p / q);
  expect(2.5 * a, 2.5 * p);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
