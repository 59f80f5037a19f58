// Modes of linear networks against their characteristic equation, and what a step makes of them.
#include "cromer/analysis/complex_modes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace cromer::core {
namespace CROMER_FILE {

using Complex128 = std::complex<double>;

LinearNetwork one_mass(double mass, double stiffness, double damping) {
  return {1, {mass}, {stiffness}, {damping}};
}

TEST(ComplexModes, OfASingleMassAreTheRootsOfItsEquation) {
  struct Case {
    double stiffness, damping;
    Complex128 first, second;
  };
  const double root = std::sqrt(3.0);
  for (const Case& c : {Case{10, 4, {-1, 2}, {-1, -2}},
                        {8, 0, {0, 2}, {0, -2}},
                        {8, 8, -2, -2},
                        {2, 8, -2 - root, -2 + root},
                        {0, 8, -4, 0},
                        {0, 0, 0, 0},
                        {2, -8, 2 + root, 2 - root}}) {
    const auto modes = complex_modes(one_mass(2, c.stiffness, c.damping));
    ASSERT_EQ(modes.size(), 1u);
    EXPECT_NEAR(std::abs(modes[0].first - c.first), 0, 1e-14) << c.stiffness << ' ' << c.damping;
    EXPECT_NEAR(std::abs(modes[0].second - c.second), 0, 1e-14) << c.stiffness << ' ' << c.damping;
    EXPECT_EQ(modes[0].shape, std::vector<Complex128>{1});
    EXPECT_NEAR(modes[0].law().stiffness, c.stiffness / 2, 1e-14);
    EXPECT_NEAR(modes[0].law().decay_rate, c.damping / 4, 1e-14);
    EXPECT_NEAR(participation(one_mass(2, c.stiffness, c.damping), modes[0]), 1, 1e-15);
  }
}

/// (M z^2 + C z + K) shape, its largest component.
double left_over(const LinearNetwork& network, Complex128 z, const std::vector<Complex128>& shape) {
  double most = 0;
  for (std::size_t i = 0; i < network.size; ++i) {
    Complex128 sum = network.mass[i] * z * z * shape[i];
    for (std::size_t j = 0; j < network.size; ++j)
      sum += (network.damping[i * network.size + j] * z + network.stiffness[i * network.size + j]) * shape[j];
    most = std::max(most, std::abs(sum));
  }
  return most;
}

TEST(ComplexModes, TiedByDampingSolveTheEquationsOfMotion) {
  // A damper at the first of two or three masses in a row: light, and so heavy that it holds the mass.
  for (const double damper : {0.3, 2.0, 9.0, 40.0}) {
    const LinearNetwork two{2, {1, 2}, {5, -2, -2, 6}, {damper, 0, 0, 0}};
    const LinearNetwork three{
        3, {1, 2, 0.5}, {5, -2, 0, -2, 6, -4, 0, -4, 4}, {damper, 0, 0, 0, 0, 0, 0, 0, 0.1}};
    for (const LinearNetwork* network : {&two, &three}) {
      const auto modes = complex_modes(*network);
      ASSERT_EQ(modes.size(), network->size);
      double before = 0, trace = 0, product = 1;
      for (const ComplexMode& mode : modes) {
        EXPECT_GE(mode.law().stiffness, before);
        before = mode.law().stiffness;
        trace += 2 * mode.law().decay_rate;
        product *= mode.law().stiffness;
        double largest = 0;
        for (const Complex128& each : mode.shape) largest = std::max(largest, std::abs(each));
        EXPECT_NEAR(largest, 1, 1e-9);
        if (mode.first.imag() != 0) {
          EXPECT_GT(mode.first.imag(), 0);
          EXPECT_EQ(mode.second, std::conj(mode.first));
          EXPECT_LT(left_over(*network, mode.first, mode.shape), 1e-11) << damper;
        } else {
          const Complex128 slower = std::abs(mode.first) < std::abs(mode.second) ? mode.first : mode.second;
          EXPECT_LT(left_over(*network, slower, mode.shape), 1e-11) << damper;
        }
      }
      // Sum and product of all eigenvalues: the trace of C/M, det K/det M.
      const bool small = network == &two;
      EXPECT_NEAR(trace, small ? damper : damper + 0.2, 1e-11 * damper);
      EXPECT_NEAR(product, small ? 26 / 2.0 : (5 * (24 - 16) - 2 * 8) / 1.0, 1e-10);
    }
  }
}

TEST(ComplexModes, OfAFreeBodyWithATiedDamperHaveOneThatStands) {
  // Three masses in a row, the damper beside one of the springs only.
  const LinearNetwork network{
      3, {1, 2, 1}, {4, -4, 0, -4, 7, -3, 0, -3, 3}, {0.5, -0.5, 0, -0.5, 0.5, 0, 0, 0, 0}};
  const auto modes = complex_modes(network);
  ASSERT_EQ(modes.size(), 3u);
  EXPECT_EQ(modes[0].first, 0.0);
  EXPECT_EQ(modes[0].second, 0.0);
  for (const Complex128& each : modes[0].shape) EXPECT_NEAR(std::abs(each - 1.0), 0, 1e-6);
  EXPECT_NEAR(participation(network, modes[0]), 1, 1e-6);
  for (const std::size_t j : {1u, 2u}) {
    EXPECT_LT(left_over(network, modes[j].first, modes[j].shape), 1e-11);
    EXPECT_NEAR(participation(network, modes[j]), 0, 1e-12);
  }
}

TEST(ComplexModes, OfTwoComponentsAsLargeTheFirstIsTheUnit) {
  const auto modes = complex_modes({2, {2, 2}, {9, -1, -1, 9}, {0, 0, 0, 0}});
  for (const ComplexMode& mode : modes) EXPECT_EQ(mode.shape[0], 1.0);
  EXPECT_NEAR(std::abs(modes[0].shape[1] - 1.0), 0, 1e-14);
  EXPECT_NEAR(std::abs(modes[1].shape[1] + 1.0), 0, 1e-14);
  EXPECT_NEAR(modal_assurance({1, 1}, {1, 0}), 0.5, 1e-15);
  EXPECT_NEAR(modal_assurance({1, Complex128(0, 2)}, {Complex128(0, 3), -6}), 1, 1e-15);
  EXPECT_NEAR(modal_assurance({1, 1}, {1, -1}), 0, 1e-15);
}

TEST(EffectiveNetwork, OfForwardEulerIsItsClosedForm) {
  // x + h v and v + h a: each mode is multiplied by 1 +- i w h.
  const LinearNetwork network{2, {2, 2}, {9, -1, -1, 9}, {0, 0, 0, 0}};  // w^2 = 4, 5
  const double h = 0.2;
  const auto step = [&](const std::vector<double>& z) {
    std::vector<double> next(4);
    for (std::size_t i = 0; i < 2; ++i) {
      next[i] = z[i] + z[2 + i];
      next[2 + i] =
          z[2 + i] - h * h * (network.stiffness[2 * i] * z[0] + network.stiffness[2 * i + 1] * z[1]) / 2;
    }
    return next;
  };
  const auto modes = complex_modes(network);
  const EffectiveNetwork found = effective_network(modes, 2, h, step);
  ASSERT_EQ(found.modes.size(), 2u);
  EXPECT_NEAR(found.spectral_radius, std::sqrt(1 + 5 * h * h), 1e-13);
  for (std::size_t j = 0; j < 2; ++j) {
    const double w = std::sqrt(4.0 + static_cast<double>(j)), size = std::sqrt(1 + w * w * h * h);
    const EffectiveOscillator& mode = found.modes[j];
    ASSERT_EQ(mode.eigenvalues.size(), 2u);
    EXPECT_NEAR(mode.eigenvalues[0].re, 1, 1e-13);
    EXPECT_NEAR(mode.eigenvalues[0].im, w * h, 1e-13);
    EXPECT_NEAR(mode.eigenvalues[1].re, 1, 1e-13);
    EXPECT_NEAR(mode.eigenvalues[1].im, -w * h, 1e-13);
    EXPECT_NEAR(mode.spectral_radius, size, 1e-13);
    ASSERT_TRUE(mode.decay_rate && mode.angular_frequency);
    EXPECT_NEAR(*mode.decay_rate, -std::log(size) / h, 1e-12);
    EXPECT_NEAR(*mode.angular_frequency, std::atan(w * h) / h, 1e-12);
  }
  const EffectiveNetwork none = effective_network(modes, 2, h, [](const std::vector<double>& z) {
    return std::vector<double>(z.size(), std::numeric_limits<double>::infinity());
  });
  EXPECT_TRUE(std::isnan(none.spectral_radius));
  ASSERT_EQ(none.modes.size(), 2u);
  EXPECT_FALSE(none.modes[1].decay_rate || none.modes[1].angular_frequency);
}

TEST(EffectiveNetwork, BeyondTheLimitEachModeHasBothItsEigenvalues) {
  // Euler-Cromer on two masses whose dampers tie the modes: the fast one has two real eigenvalues, of which
  // the larger grows.
  const LinearNetwork network{2, {1, 1}, {50, -30, -30, 30}, {0.6, -0.1, -0.1, 0.1}};
  const double h = 0.5;
  const auto step = [&](const std::vector<double>& z) {
    std::vector<double> next(4);
    for (std::size_t i = 0; i < 2; ++i) {
      next[2 + i] = z[2 + i];
      for (std::size_t j = 0; j < 2; ++j)
        next[2 + i] -=
            h * h * network.stiffness[2 * i + j] * z[j] + h * network.damping[2 * i + j] * z[2 + j];
    }
    for (std::size_t i = 0; i < 2; ++i) next[i] = z[i] + next[2 + i];
    return next;
  };
  const EffectiveNetwork found = effective_network(complex_modes(network), 2, h, step);
  ASSERT_GT(found.spectral_radius, 10);
  const auto product = [](const EffectiveOscillator& mode) {
    return Complex128(mode.eigenvalues[0].re, mode.eigenvalues[0].im) *
           Complex128(mode.eigenvalues[1].re, mode.eigenvalues[1].im);
  };
  EXPECT_TRUE(found.modes[0].stable());
  EXPECT_FALSE(found.modes[1].stable());
  EXPECT_EQ(found.modes[1].spectral_radius, found.spectral_radius);
  EXPECT_FALSE(found.modes[1].decay_rate);
  // The determinant of the map is 1 - tr(C) h + det(C) h^2.
  const Complex128 all = product(found.modes[0]) * product(found.modes[1]);
  EXPECT_NEAR(std::abs(all - (1 - 0.7 * h + 0.05 * h * h)), 0, 1e-12);
}

TEST(EffectiveNetwork, OfModesThatCreepEachHasTwoEigenvalues) {
  // Forward Euler multiplies by 1 + z h for each z of the network, real or not.
  const LinearNetwork network{2, {1, 2}, {3, -1, -1, 4}, {9, -2, -2, 1}};
  const double h = 0.01;
  const auto modes = complex_modes(network);
  const EffectiveNetwork found = effective_network(modes, 2, h, [&](const std::vector<double>& z) {
    std::vector<double> next = z;
    for (std::size_t i = 0; i < 2; ++i) {
      next[i] += z[2 + i];
      for (std::size_t j = 0; j < 2; ++j)
        next[2 + i] -=
            (h * h * network.stiffness[2 * i + j] * z[j] + h * network.damping[2 * i + j] * z[2 + j]) /
            network.mass[i];
    }
    return next;
  });
  for (std::size_t j = 0; j < 2; ++j) {
    const auto has = [&](const Complex128& z) {
      const auto& of = found.modes[j].eigenvalues;
      return std::any_of(of.begin(), of.end(), [&](const auto& each) {
        return std::abs(Complex128(each.re, each.im) - (1.0 + z * h)) < 1e-12;
      });
    };
    EXPECT_TRUE(has(modes[j].first)) << j;
    EXPECT_TRUE(has(modes[j].second)) << j;
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
