#include "cromer/study/task/resonance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "cromer/analysis/frequency_response.h"

namespace cromer {
namespace {

using Complex = std::complex<double>;

ResonanceOptions options(std::vector<std::string> methods) {
  ResonanceOptions options;
  options.simulate.stiffness = 9;
  options.simulate.damping = 0.2;
  options.simulate.drive_amplitude = 1;
  options.simulate.method = std::move(methods);
  options.simulate.step = 0.01;
  options.frequency_from = 0.5;
  options.frequency_to = 5.5;
  options.points = 21;
  return options;
}

/// Steady response of x'' + 2 b x' + w0^2 x = e^{iWt} as Euler-Cromer steps it (a second difference, damping
/// one step back).
Complex euler_cromer_response(double w0, double b, double w, double h) {
  const Complex z = std::exp(Complex(0, w * h));
  return 1.0 / (w0 * w0 - 4 / (h * h) * std::pow(std::sin(w * h / 2), 2) + 2 * b / h * (1.0 - 1.0 / z));
}

/// The same as implicit Euler steps it: derivatives become backward differences.
Complex implicit_euler_response(double w0, double b, double w, double h) {
  const Complex s = (1.0 - std::exp(Complex(0, -w * h))) / h;
  return 1.0 / (s * s + 2 * b * s + w0 * w0);
}

TEST(Resonance, each_method_settles_where_its_difference_equation_says) {
  const auto result = resonance(options({"exact", "euler-cromer", "implicit-euler"}));
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->curves.size(), 3u);
  EXPECT_TRUE(result->warnings.empty());
  const Oscillator<double> law{.mass = 1, .stiffness = 9, .damping = 0.2};
  for (std::size_t i = 0; i < 21; ++i) {
    const double w = result->curves[0].frequency[i];
    EXPECT_DOUBLE_EQ(w, 0.5 + 0.25 * static_cast<double>(i));
    EXPECT_DOUBLE_EQ(result->curves[0].amplitude[i], frequency_response(law, 1, w).amplitude);
    const double euler_cromer = std::abs(euler_cromer_response(3, 0.1, w, 0.01));
    const double implicit_euler = std::abs(implicit_euler_response(3, 0.1, w, 0.01));
    EXPECT_NEAR(result->curves[1].amplitude[i] / euler_cromer, 1, 1e-5) << w;
    EXPECT_NEAR(result->curves[2].amplitude[i] / implicit_euler, 1, 1e-5) << w;
  }
  // The test could tell the methods apart: at resonance they differ by a third.
  EXPECT_LT(result->curves[2].amplitude[10], 0.75 * result->curves[1].amplitude[10]);
}

TEST(Resonance, a_method_that_grows_has_no_steady_amplitude) {
  auto growing = options({"forward-euler"});
  growing.simulate.step = 0.03;
  growing.points = 2;
  const auto result = resonance(growing);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(std::isnan(result->curves[0].amplitude[0]));
  ASSERT_EQ(result->warnings.size(), 1u);
  EXPECT_NE(result->warnings[0].find("forward-euler did not settle at 2 of 2"), std::string::npos);
}

TEST(Resonance, says_what_prevents_it) {
  auto undamped = options({"euler-cromer"});
  undamped.simulate.damping = 0;
  EXPECT_NE(resonance(undamped).error().message.find("--damping"), std::string::npos);
  auto dragged = options({"euler-cromer"});
  dragged.simulate.drag = 0.1;
  EXPECT_NE(resonance(dragged).error().message.find("--drag"), std::string::npos);
  auto backward = options({"euler-cromer"});
  backward.frequency_to = 0.1;
  EXPECT_NE(resonance(backward).error().message.find("--frequency-to"), std::string::npos);
}

}  // namespace
}  // namespace cromer
