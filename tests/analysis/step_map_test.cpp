// What is read from a step's map, of maps whose eigenvalues are chosen.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

#include "cromer/analysis/effective_oscillator.h"
#include "cromer/base/pi.h"
#include "cromer/methods/all.h"
#include "tests/support/every_method.h"

namespace cromer::core {
namespace CROMER_FILE {

using Matrix = std::array<std::array<double, 3>, 3>;  // rows
template <class Number = Precise>
StepMapOf<Number> map_of(const Matrix& m, std::size_t size) {
  StepMapOf<Number> map;
  map.size = size;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) map.column[j][i] = m[i][j];
  return map;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

/// The same in other coordinates, which are inverses of each other; the first two keep to themselves.
Matrix in_a_plane(const Matrix& m) {
  return product(product({{{1, 2, 0}, {1, 3, 0}, {0, 0, 1}}}, m), {{{3, -2, 0}, {-1, 1, 0}, {0, 0, 1}}});
}
Matrix in_space(const Matrix& m) {
  return product(product({{{1, 2, 3}, {1, 3, 5}, {1, 2, 4}}}, m), {{{2, -2, 1}, {1, 1, -2}, {-1, 0, 1}}});
}

Matrix diagonal(double a, double b, double c) { return {{{a, 0, 0}, {0, b, 0}, {0, 0, c}}}; }
Matrix turn(double radius, double angle, double c) {
  const double re = radius * std::cos(angle), im = radius * std::sin(angle);
  return {{{re, -im, 0}, {im, re, 0}, {0, 0, c}}};
}

std::vector<double> reals(const EffectiveOscillator& found) {
  std::vector<double> values;
  for (const auto& z : found.eigenvalues) {
    EXPECT_EQ(z.im, 0);
    values.push_back(z.re);
  }
  return values;
}

TEST(StepMap, RealEigenvaluesAreTheirOwnAndNothingSwings) {
  for (const auto& [a, b] : {std::array{0.5, 0.25}, {-0.5, 0.25}, {-0.5, -0.75}, {2.0, 0.0}, {0.5, -0.5}}) {
    const auto found = analyse(map_of(in_a_plane(diagonal(a, b, 0)), 2), 0.1, 0);
    auto values = reals(found);
    std::sort(values.begin(), values.end());
    ASSERT_EQ(values.size(), 2u);
    EXPECT_NEAR(values[0], std::min(a, b), 1e-15);
    EXPECT_NEAR(values[1], std::max(a, b), 1e-15);
    EXPECT_NEAR(found.spectral_radius, std::max(std::abs(a), std::abs(b)), 1e-15);
    EXPECT_FALSE(found.decay_rate || found.angular_frequency || found.energy_factor() || found.steady_state);
  }
  EXPECT_EQ(reals(analyse(map_of({}, 2), 0.1, 0)), (std::vector{0.0, 0.0}));
  // Both are 0 of this one too, whose entries are not.
  EXPECT_EQ(reals(analyse(map_of({{{2, -4, 0}, {1, -2, 0}, {0, 0, 0}}}, 2), 0.1, 0)),
            (std::vector{0.0, 0.0}));
}

TEST(StepMap, APairTurnsAndDecays) {
  for (const double angle : {0.01, 1.0, 3.0}) {
    const auto found = analyse(map_of(in_a_plane(turn(0.9, angle, 0)), 2), 0.1, 0);
    ASSERT_TRUE(found.decay_rate && found.angular_frequency);
    EXPECT_NEAR(*found.decay_rate, -std::log(0.9) / 0.1, 1e-12);
    EXPECT_NEAR(*found.angular_frequency, angle / 0.1, 1e-11);
    EXPECT_NEAR(*found.energy_factor(), std::pow(0.9, 2 * 2 * pi / angle), 1e-12);
    EXPECT_NEAR(found.spectral_radius, 0.9, 1e-14);
  }
}

TEST(StepMap, OfThreeTheOneThatStandsAloneIsTheMethodsOwn) {
  for (const auto& around : {in_space, +[](const Matrix& m) { return m; }}) {
    for (const auto& [pair, own] : {std::pair{std::array{0.9, 0.8}, -0.3},
                                    {{-0.9, -0.8}, 0.3},
                                    {{0.2, 0.3}, 1.5},
                                    {{-0.2, -0.3}, -1.5},
                                    {{0.6, 0.6}, 0.1}}) {
      const auto found = analyse(map_of(around(diagonal(pair[0], own, pair[1])), 3), 0.1, 0);
      auto values = reals(found);
      ASSERT_EQ(values.size(), 3u);
      EXPECT_NEAR(values[2], own, 1e-14);
      EXPECT_NEAR(values[0] + values[1], pair[0] + pair[1], 1e-13);
      EXPECT_NEAR(values[0] * values[1], pair[0] * pair[1], 1e-13);
      EXPECT_NEAR(found.spectral_radius, std::max({std::abs(pair[0]), std::abs(pair[1]), std::abs(own)}),
                  1e-7);
    }
    for (const double own : {-0.95, -0.2, 0.0, 0.3, 0.99}) {
      const auto found = analyse(map_of(around(turn(0.9, 0.7, own)), 3), 0.1, 0);
      ASSERT_EQ(found.eigenvalues.size(), 3u);
      EXPECT_NEAR(found.eigenvalues[0].re, 0.9 * std::cos(0.7), 1e-13) << own;
      EXPECT_NEAR(found.eigenvalues[0].im, 0.9 * std::sin(0.7), 1e-13) << own;
      EXPECT_NEAR(found.eigenvalues[1].im, -0.9 * std::sin(0.7), 1e-13) << own;
      EXPECT_NEAR(found.eigenvalues[2].re, own, 1e-14);
      EXPECT_NEAR(*found.decay_rate, -std::log(0.9) / 0.1, 1e-11);
    }
  }
}

/// The plane turns and the third number decays alone, whichever of the three it is.
TEST(StepMap, ThePlaneOfTheMotionMayLieAnyhow) {
  const double re = 0.9 * std::cos(0.7), im = 0.9 * std::sin(0.7), own = -0.2;
  for (const Matrix& m : {Matrix{{{own, 0, 0}, {0, re, -im}, {0, im, re}}},
                          {{{re, 0, -im}, {0, own, 0}, {im, 0, re}}},
                          {{{re, -im, 0}, {im, re, 0}, {0, 0, own}}},
                          {{{own, 5, 7}, {0, re, -im}, {0, im, re}}},
                          {{{re, 0, -im}, {5, own, 7}, {im, 0, re}}},
                          {{{re, -im, 5}, {im, re, 7}, {0, 0, own}}}}) {
    const auto found = analyse(map_of(m, 3), 0.1, 0);
    EXPECT_NEAR(found.eigenvalues[0].re, re, 1e-14);
    EXPECT_NEAR(found.eigenvalues[0].im, im, 1e-14);
    EXPECT_NEAR(found.eigenvalues[2].re, own, 1e-15);
  }
}

/// x' = 0.5 x + cos(2 n), v' = 0.25 v + 2 cos(2 n + 1): each is a geometric sum.
template <class Number>
StepMapOf<Number> driven() {
  auto map = map_of<Number>(diagonal(0.5, 0.25, 0.125), 2);
  map.drive[0] = {1, 0};
  map.drive[1] = {Number(2 * std::cos(1.0)), Number(2 * std::sin(1.0))};
  return map;
}

void expect_phasor(const SteadyState& found, std::complex<double> truth) {
  EXPECT_NEAR(found.amplitude, std::abs(truth), 1e-14);
  EXPECT_NEAR(std::cos(found.phase_lag), std::cos(-std::arg(truth)), 1e-14);
  EXPECT_NEAR(std::sin(found.phase_lag), std::sin(-std::arg(truth)), 1e-14);
  EXPECT_GE(found.phase_lag, -pi / 2);
  EXPECT_LE(found.phase_lag, 3 * pi / 2);
}

TEST(StepMap, TheSteadyStateIsTheSumOfAllThatTheDriveDid) {
  const auto z = std::polar(1.0, 2.0);
  const std::complex<double> x = 1.0 / (z - 0.5), v = std::polar(2.0, 1.0) / (z - 0.25);
  auto map = driven<Precise>();
  for (const std::size_t size : {2u, 3u}) {
    map.size = size;
    if (size == 3) map.column[2][2] = 0.125;
    const auto found = analyse(map, 0.1, 20);
    ASSERT_TRUE(found.steady_state && found.steady_velocity);
    expect_phasor(*found.steady_state, x);
    expect_phasor(*found.steady_velocity, v / 0.1);
  }
  for (const std::size_t size : {2u, 3u}) {
    auto quick = driven<double>();
    quick.size = size;
    if (size == 3) quick.column[2][2] = 0.125;
    double uncertainty = 1;
    const auto steady = steady_state_of(quick, 20, 0.1, uncertainty);
    ASSERT_TRUE(steady);
    expect_phasor(steady->position, x);
    EXPECT_NEAR(steady->velocity, std::abs(v) / 0.1, 1e-13);
    EXPECT_GT(uncertainty, 0);
    EXPECT_LT(uncertainty, 1e-14);
  }
}

TEST(StepMap, OneHalfOfADriveIsADrive) {
  for (const auto& force : {Complex<Precise>{1, 0}, {0, 1}}) {
    auto map = map_of(diagonal(0.5, 0.25, 0), 2);
    map.drive[1] = force;
    EXPECT_TRUE(analyse(map, 0.1, 20).steady_velocity);
  }
  EXPECT_FALSE(analyse(map_of(diagonal(0.5, 0.25, 0), 2), 0.1, 20).steady_state) << "nothing drives";
}

TEST(StepMap, WithoutASolutionNothingIsSaid) {
  auto map = driven<Precise>();
  map.converged = false;
  const auto found = analyse(map, 0.1, 20);
  EXPECT_TRUE(std::isnan(found.spectral_radius));
  EXPECT_FALSE(found.stable());
  EXPECT_FALSE(found.steady_state);
  auto quick = driven<double>();
  quick.converged = false;
  double uncertainty = 1;
  EXPECT_FALSE(steady_state_of(quick, 20, 0.1, uncertainty));
  EXPECT_EQ(uncertainty, 0);
}

TEST(StepMap, IsStableToRounding) {
  const auto stable = [](double radius) { return EffectiveOscillator{.spectral_radius = radius}.stable(); };
  EXPECT_TRUE(stable(1));
  EXPECT_TRUE(stable(1 + 1e-12));
  EXPECT_FALSE(stable(std::nextafter(1 + 1e-12, 2)));
}

TEST(StepMap, SettlesWhereAllEigenvaluesLieInside) {
  const double values[] = {-1.2, -1.0001, -0.9999, -0.5, 0, 0.3, 0.9999, 1.0001, 1.2};
  const auto inside = [](std::initializer_list<double> all) {
    return std::all_of(all.begin(), all.end(), [](double z) { return std::abs(z) < 1; });
  };
  for (const double a : values)
    for (const double b : values) {
      EXPECT_EQ(settles(map_of<double>(in_a_plane(diagonal(a, b, 0)), 2)), inside({a, b})) << a << ' ' << b;
      for (const double c : values)
        EXPECT_EQ(settles(map_of<double>(diagonal(a, b, c), 3)), inside({a, b, c}))
            << a << ' ' << b << ' ' << c;
    }
  for (const double radius : {0.2, 0.999, 1.001, 3.0})
    for (const double angle : {0.1, 1.5, 1.7, 3.1}) {
      EXPECT_EQ(settles(map_of<double>(in_a_plane(turn(radius, angle, 0)), 2)), radius < 1)
          << radius << ' ' << angle;
      for (const double own : {-1.01, -0.99, -0.3, 0.0, 0.3, 0.99, 1.01})
        EXPECT_EQ(settles(map_of<double>(in_space(turn(radius, angle, own)), 3)), inside({radius, own}))
            << radius << ' ' << angle << ' ' << own;
    }
}

TEST(MethodSteadyState, IsThatOfTheWholeAnalysis) {
  for (const double zeta : {0.0, 0.05, 2.0})
    for (const double h : {0.003, 0.05, 0.2}) {
      const LinearLaw<double> law{
          .decay_rate = 6 * zeta, .stiffness = 36, .drive_amplitude = 1.5, .drive_frequency = 7};
      for_each_method(MethodSettings{.newton = {}, .rho_inf = 0.6}, [&](const auto& method) {
        const auto whole = effective_oscillator(method, law, h);
        const auto quick = method_steady_state(method, law, h);
        if (std::abs(whole.spectral_radius - 1) < 1e-9) return;
        ASSERT_EQ(quick.has_value(), whole.spectral_radius < 1)
            << method.info.name << ' ' << zeta << ' ' << h;
        if (!quick) return;
        EXPECT_NEAR(quick->position.amplitude / whole.steady_state->amplitude, 1, 1e-11) << method.info.name;
        EXPECT_NEAR(quick->position.phase_lag, whole.steady_state->phase_lag, 1e-10) << method.info.name;
        EXPECT_NEAR(quick->velocity / whole.steady_velocity->amplitude, 1, 1e-11) << method.info.name;
      });
    }
}

TEST(MethodSteadyState, OfTheExactMethodIsTheOscillatorsHoweverShortTheStep) {
  const Oscillator<double> o{.mass = 1, .stiffness = 36, .damping = 1.2};
  for (const double w : {0.5, 5.9, 6.0, 40.0})
    for (const double h : {0.05, 1e-3, 1e-4, 1e-5}) {
      const LinearLaw<double> law{
          .decay_rate = 0.6, .stiffness = 36, .drive_amplitude = 1.5, .drive_frequency = w};
      const auto found = method_steady_state(Exact{}, law, h);
      const SteadyState truth = frequency_response(o, 1.5, w);
      ASSERT_TRUE(found) << h;
      EXPECT_NEAR(found->position.amplitude / truth.amplitude, 1, 1e-11) << w << ' ' << h;
      EXPECT_NEAR(found->velocity / (w * truth.amplitude), 1, 1e-11) << w << ' ' << h;
    }
}

TEST(FirstUnstableStep, IsWhereTheRadiusLeavesOne) {
  const LinearLaw<double> law{.decay_rate = 0, .stiffness = 9};
  const auto limit = [&](auto radius) { return first_unstable_step(law, radius); };
  const auto falls = [](double h) { return h <= 0.25 ? 0.5 : 2.0; };
  EXPECT_EQ(limit(falls), 0.25);
  EXPECT_EQ(limit([](double h) { return h <= 0.25 ? 1.0 : 2.0; }), 0.25) << "bounded all the way";
  EXPECT_EQ(limit([](double h) { return h <= 0.25 ? 0.5 : std::numeric_limits<double>::quiet_NaN(); }), 0.25);
  EXPECT_EQ(limit([](double) { return 2.0; }), 0.0);
  EXPECT_EQ(limit([](double h) { return 1 + h; }), 0.0) << "growth that is no more than rounding at first";
  EXPECT_EQ(limit([](double) { return 0.5; }), std::nullopt);
  EXPECT_EQ(limit([](double) { return 1.0; }), std::nullopt);
  // Of steps that damp the limit is where they cease to, and the first one counts.
  EXPECT_EQ(limit([](double h) { return h <= 0.25 ? 0.5 : h < 0.5 ? 2.0 : 0.5; }), 0.25);
  // Found up to a thousand times 1/w.
  EXPECT_EQ(limit([](double h) { return h <= 300 ? 0.5 : 2.0; }), 300.0);
  EXPECT_EQ(limit([](double h) { return h <= 400 ? 0.5 : 2.0; }), std::nullopt);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
