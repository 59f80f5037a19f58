#include "cromer/tasks/curves/resonance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "cromer/analysis/frequency_response.h"
#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

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
  ASSERT_TRUE(result) << in_words(result.error());
  ASSERT_EQ(result->curves.size(), 3u);
  EXPECT_TRUE(in_words(result->notices).empty());
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

TEST(Resonance, what_gets_through_is_the_closed_form_of_law_and_method) {
  auto asked = options({"exact", "implicit-euler"});
  asked.simulate.damping.reset();
  asked.damping_ratio = {0.05, 0.5};
  asked.points = 7;
  for (const std::string drive : {"harmonic", "unbalance", "base"}) {
    asked.simulate.drive = drive;
    asked.simulate.drive_amplitude = drive == "harmonic" ? 3 : 0;
    if (drive == "unbalance") asked.simulate.unbalance_mass = 0.1, asked.simulate.eccentricity = 0.2;
    if (drive == "base") {
      asked.simulate.unbalance_mass.reset(), asked.simulate.eccentricity.reset();
      asked.simulate.base_displacement = 0.04;
    }
    const auto result = resonance(asked);
    ASSERT_TRUE(result) << in_words(result.error());
    ASSERT_EQ(result->curves.size(), 4u);
    EXPECT_EQ(result->of_motion, drive == "base");
    for (std::size_t c = 0; c < 4; ++c) {
      const ResonanceCurve& curve = result->curves[c];
      const double ratio = asked.damping_ratio[c / 2], b = 3 * ratio;
      EXPECT_NEAR(curve.damping_ratio, ratio, 1e-15);
      for (std::size_t i = 0; i < 7; ++i) {
        const double w = curve.frequency[i], h = 0.01;
        // Implicit Euler's derivative is the backward difference, of its base and force as of its motion.
        const Complex s = c % 2 == 0 ? Complex(0, w) : (1.0 - std::exp(Complex(0, -w * h))) / h;
        const Complex compliance = 1.0 / (s * s + 2 * b * s + 9.0);
        const Complex through = drive == "base" ? 1.0 + w * w * compliance : (9.0 + 2 * b * s) * compliance;
        const double error = c % 2 == 0 ? 1e-13 : 2e-5;
        EXPECT_NEAR(curve.transmissibility[i] / std::abs(through), 1, error) << drive << " " << w;
        EXPECT_NEAR(curve.transmitted_phase[i], -std::arg(through), error) << drive << " " << w;
        EXPECT_NEAR(curve.frequency_ratio[i], w / 3, 1e-15);
        const double sent = drive == "harmonic" ? 3 : drive == "base" ? 0.04 : 0.1 * 0.2 * w * w;
        EXPECT_NEAR(curve.transmitted[i], sent * curve.transmissibility[i], 1e-15);
        const double amplification = (drive == "harmonic" ? 9 : w * w) * std::abs(compliance);
        EXPECT_NEAR(curve.amplification[i] / amplification, 1, error) << drive << " " << w;
      }
    }
  }
}

TEST(Resonance, a_method_that_grows_has_no_steady_amplitude) {
  auto growing = options({"forward-euler"});
  growing.simulate.step = 0.03;
  growing.points = 2;
  const auto result = resonance(growing);
  ASSERT_TRUE(result) << in_words(result.error());
  EXPECT_TRUE(std::isnan(result->curves[0].amplitude[0]));
  ASSERT_EQ(in_words(result->notices).size(), 1u);
  EXPECT_NE(in_words(result->notices)[0].find("forward-euler did not settle at 2 of 2"), std::string::npos);
}

TEST(Resonance, says_what_prevents_it) {
  auto undamped = options({"euler-cromer"});
  undamped.simulate.damping = 0;
  EXPECT_NE(in_words(resonance(undamped).error()).find("--damping"), std::string::npos);
  auto dragged = options({"euler-cromer"});
  dragged.simulate.law.drag = 0.1;
  EXPECT_NE(in_words(resonance(dragged).error()).find("--drag"), std::string::npos);
  auto pulsed = options({"euler-cromer"});
  pulsed.simulate.drive = "step";
  EXPECT_FALSE(resonance(pulsed).ok());
  auto twice = options({"euler-cromer"});
  twice.damping_ratio = {0.1};
  EXPECT_NE(in_words(resonance(twice).error()).find("--damping-ratios"), std::string::npos);
  auto backward = options({"euler-cromer"});
  backward.frequency_to = 0.1;
  EXPECT_NE(in_words(resonance(backward).error()).find("--frequency-to"), std::string::npos);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
