// Sums of many numbers at once against the same sums number by number, to the last bit.
#include "cromer/base/vector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "cromer/base/coupled.h"

namespace cromer::core {
namespace CROMER_FILE {

// Shorter and longer than any processor takes at once, and with a rest.
constexpr std::size_t sizes[] = {1, 3, 16, 17, 63, 1000, 1003};

Vector numbers(std::size_t size, double seed) {
  Vector made = Vector::of_size(size);
  for (std::size_t i = 0; i < size; ++i) made[i] = std::sin(seed + static_cast<double>(i)) / 3;
  return made;
}

template <class Expected>
void expect_each(const Vector& found, std::size_t size, const Expected& expected) {
  ASSERT_EQ(found.size(), size);
  for (std::size_t i = 0; i < size; ++i)
    EXPECT_EQ(std::as_const(found)[i], expected(i)) << "component " << i << " of " << size;
}

TEST(Vector, SumsOfMultiplesAreThoseOfTheirComponents) {
  for (const std::size_t size : sizes) {
    const Vector a = numbers(size, 1), b = numbers(size, 2);
    expect_each(a + 0.1 * b, size, [&](std::size_t i) { return a[i] + 0.1 * b[i]; });
    expect_each(0.3 * a - b, size, [&](std::size_t i) { return 0.3 * a[i] - b[i]; });
    expect_each(a - b * 0.1, size, [&](std::size_t i) { return a[i] - b[i] * 0.1; });
    expect_each(0.7 * a + 0.1 * b, size, [&](std::size_t i) { return 0.7 * a[i] + 0.1 * b[i]; });
    expect_each(a + b, size, [&](std::size_t i) { return a[i] + b[i]; });
    expect_each(-a, size, [&](std::size_t i) { return -a[i]; });
    expect_each(a / 3.0, size, [&](std::size_t i) { return a[i] / 3.0; });
    expect_each(0.1 * a, size, [&](std::size_t i) { return 0.1 * a[i]; });
  }
}

TEST(Vector, AMultipleOfAMultipleIsRoundedTwice) {
  const Vector a = numbers(100, 1), b = numbers(100, 2);
  expect_each(b + 0.1 * (0.3 * a), 100, [&](std::size_t i) { return b[i] + 0.1 * (0.3 * a[i]); });
}

TEST(Vector, WhatIsAboutToGoLendsItsMemory) {
  for (const std::size_t size : sizes) {
    const Vector a = numbers(size, 1), b = numbers(size, 2);
    Vector going = b;
    const double* memory = going.data();
    const Vector sum = a + 0.1 * std::move(going);
    EXPECT_EQ(sum.data(), memory);
    expect_each(sum, size, [&](std::size_t i) { return a[i] + 0.1 * b[i]; });
    Vector other = b;
    memory = other.data();
    const Vector multiple = 0.1 * std::move(other);
    EXPECT_EQ(multiple.data(), memory);
    expect_each(multiple, size, [&](std::size_t i) { return 0.1 * b[i]; });
  }
}

TEST(Vector, OneNumberStandsForAll) {
  const Vector a = numbers(20, 1), one = 2.0;
  expect_each(a + 0.1 * one, 20, [&](std::size_t i) { return a[i] + 0.1 * 2.0; });
  expect_each(0.1 * one - a, 20, [&](std::size_t i) { return 0.1 * 2.0 - a[i]; });
  EXPECT_EQ(value_of(one + 3 * one), 8);
}

TEST(Vector, PairsOfThemToo) {
  const Vector a = numbers(20, 1), b = numbers(20, 2);
  const Coupled<Vector> pair{a, b}, moved = pair + 0.1 * pair, multiple = 0.1 * pair;
  expect_each(moved.second, 20, [&](std::size_t i) { return b[i] + 0.1 * b[i]; });
  expect_each(multiple.first, 20, [&](std::size_t i) { return 0.1 * a[i]; });
}

TEST(Vector, OneComponentThatIsNotFiniteIsFound) {
  for (const std::size_t size : sizes) {
    const Vector good = numbers(size, 1);
    EXPECT_TRUE(all_finite(good));
    for (std::size_t i = 0; i < size; i += size < 100 ? 1 : 97)
      for (const double bad :
           {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
            std::numeric_limits<double>::quiet_NaN()}) {
        Vector a = good;
        a[i] = bad;
        EXPECT_FALSE(all_finite(a)) << "component " << i << " of " << size;
      }
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
