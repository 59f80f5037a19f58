// Response spectra that others published.
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/analysis/yielding.h"
#include "cromer/documents/words/words.h"
#include "tests/tasks/ground_motion.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using test::ground_motion;
using test::list_of;
using test::number_rows;
using test::shared;

// A. K. Chopra, Dynamics of Structures, section 6.4: El Centro 1940, his figures to their digits, and the
// exact recurrence at the samples.
TEST(PublishedSpectra, ChopraElCentro) {
  const auto rows = number_rows(shared + "tables/chopra_elcentro_peaks.csv");
  if (rows.empty()) GTEST_SKIP() << "no ../shared/data";
  const SpectrumFile file = ground_motion("elcentro_chopra.csv");
  // The table has g = 386.4 in/s^2; the motion is linear in it.
  const double inch = 0.0254, g = 386.4 * inch / standard_gravity;
  ASSERT_EQ(rows.size(), 5u);
  for (const auto& row : rows) {
    SpectrumOptions options;
    options.periods = std::to_string(row[0]);
    options.damping_ratio = {std::to_string(row[1])};
    options.peaks = "samples";
    const auto at_samples = response_spectrum({&file, 1}, options);
    ASSERT_TRUE(at_samples.ok()) << in_words(at_samples.error());
    const double found = at_samples->spectra[0].displacement[0][0] * g / inch;
    EXPECT_NEAR(found / row[3], 1, 2e-4) << row[0] << " " << row[1];
    EXPECT_NEAR(found, row[2], 0.011) << row[0] << " " << row[1];
    options.peaks = "continuous";
    EXPECT_GE(response_spectrum({&file, 1}, options)->spectra[0].displacement[0][0] * g / inch, found);
  }
}

// A. K. Chopra, Dynamics of Structures, section 7.4: the same motion, T = 0.5 s and 5 % damping, of springs
// with a half, a quarter and an eighth of the strength that stays elastic.
TEST(PublishedSpectra, ChopraYielding) {
  const SpectrumFile file = ground_motion("elcentro_chopra.csv");
  if (file.bytes.empty()) GTEST_SKIP() << "no ../shared/data";
  const double strengths[] = {0.5, 0.25, 0.125}, ductilities[] = {1.44, 3.11, 7.36};
  SpectrumOptions options;
  options.periods = "0.5";
  const auto elastic = response_spectrum({&file, 1}, options);
  ASSERT_TRUE(elastic.ok()) << in_words(elastic.error());
  const double unyielding = elastic->spectra[0].displacement[0][0];
  const Component& ground = elastic->components[0];
  const YieldingOscillator oscillator{ground.acceleration, ground.spacing, 4 * M_PI, 0.05};
  for (const double ductility : {3.11, 7.36}) options.ductility.push_back(std::to_string(ductility));
  const auto yielding = response_spectrum({&file, 1}, options);
  ASSERT_TRUE(yielding.ok()) << in_words(yielding.error());
  for (std::size_t i = 0; i < 3; ++i) {
    const double yield = strengths[i] * unyielding;
    EXPECT_NEAR(oscillator.peak(yield) / yield, ductilities[i], 0.005 * ductilities[i]);
    if (i == 0) continue;  // a stronger spring reaches 1.44 as well
    EXPECT_NEAR(yielding->spectra[i - 1].displacement[0][0] / yield, 1, 0.01) << strengths[i];
  }
}

// PEER NGA-West2, RSN 8883: its own spectra of both components and of their rotations.
TEST(PublishedSpectra, Peer) {
  const auto rows = number_rows(shared + "ground-motion/reference_psa_rsn8883_z0.05.csv");
  if (rows.empty()) GTEST_SKIP() << "no ../shared/data";
  ASSERT_EQ(rows.size(), 111u);
  const SpectrumFile files[] = {ground_motion("RSN8883_14383980_13849360.AT2"),
                                ground_motion("RSN8883_14383980_13849090.AT2")};
  SpectrumOptions options;
  options.periods = list_of(rows, 0);
  options.peaks = "peer";
  const auto result = response_spectrum(files, options);
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  const ResponseSpectrum& spectrum = result->spectra[0];
  double off = 0, off_rotated = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double period = rows[i][0];
    const auto psa = [&](double sd) { return pseudo_acceleration(sd, period) / standard_gravity; };
    for (std::size_t c = 0; c < 2; ++c)
      off = std::max(off, std::abs(psa(spectrum.displacement[c][i]) / rows[i][1 + c] - 1));
    off_rotated = std::max(off_rotated, std::abs(psa(spectrum.rotd50[i]) / rows[i][3] - 1));
    EXPECT_GE(spectrum.rotd100[i], spectrum.rotd50[i]);
    EXPECT_GE(spectrum.rotd100[i],
              0.9999 * std::max(spectrum.displacement[0][i], spectrum.displacement[1][i]));
  }
  EXPECT_LT(off, 1e-4);
  EXPECT_LT(off_rotated, 1e-3);
  RecordProperty("largest_difference", std::to_string(off));
  std::printf("PEER: components within %.2g, RotD50 within %.2g\n", off, off_rotated);
}

// The spectrum that comes with eqsig's (MIT licence) own test motion. It is not what eqsig's own recurrence
// gives, but that of the band-limited motion looked at where it was sampled, with g = 9.81 m/s^2.
TEST(PublishedSpectra, Eqsig) {
  std::ifstream motion(shared + "ground-motion/eqsig_motion_dt0p01.txt");
  if (!motion) GTEST_SKIP() << "no ../shared/data";
  const auto rows = number_rows(shared + "ground-motion/eqsig_motion_spectrum_5pct.csv");
  ASSERT_EQ(rows.size(), 113u);
  const SpectrumFile file = ground_motion("eqsig_motion_dt0p01.txt");
  SpectrumOptions options;
  options.unit = "m/s^2";
  options.between_samples = "band-limited";
  options.peaks = "samples";
  options.periods = list_of(rows, 0);
  const auto result = response_spectrum({&file, 1}, options);
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  std::printf("eqsig, per period (s) the difference in %%:\n");
  double worst = 0, between = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double period = rows[i][0];
    const double psa = pseudo_acceleration(result->spectra[0].displacement[0][i], period);
    const double off = psa / standard_gravity / rows[i][1] - 1;
    EXPECT_LT(std::abs(off), 0.015) << "at " << period << " s";
    worst = std::max(worst, std::abs(off));
    // With three samples a period and ten periods in the recording, both are accurate.
    if (period > 0.0287 && period < 4.6) {
      const double with_their_g = std::abs(psa / 9.81 / rows[i][1] - 1);
      EXPECT_LT(with_their_g, 3e-4) << "at " << period << " s";
      between = std::max(between, with_their_g);
    }
    std::printf("%.4g: %+.3f%s", period, 100 * off, i % 8 == 7 || i + 1 == rows.size() ? "\n" : "   ");
  }
  std::printf("eqsig: within %.3g %%, from 0.029 to 4.6 s with g = 9.81 within %.3g %%\n", 100 * worst,
              100 * between);
  // The ground that is straight between samples is another motion: that is the 4.7 % of the default.
  options.between_samples = options.peaks = "";
  const auto straight = response_spectrum({&file, 1}, options);
  double most = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    most = std::max(most, std::abs(pseudo_acceleration(straight->spectra[0].displacement[0][i], rows[i][0]) /
                                       standard_gravity / rows[i][1] -
                                   1));
  EXPECT_NEAR(most, 0.047, 0.002);
}

// PEER filters its records so that velocity and displacement end where they began.
TEST(PublishedGround, IntegratesBackToRest) {
  for (const char* name : {"RSN753_LOMAP_CLS000-hor1.AT2", "RSN8883_14383980_13849090.AT2"}) {
    const SpectrumFile file = ground_motion(name);
    if (file.bytes.empty()) GTEST_SKIP() << "no ../shared/data";
    SpectrumOptions options;
    options.periods = "1";
    const auto result = response_spectrum({&file, 1}, options);
    ASSERT_TRUE(result.ok());
    const GroundPath& path = result->components[0].path;
    EXPECT_LT(std::abs(path.velocity.back()), 2e-5 * path.peak_velocity) << name;
    EXPECT_LT(std::abs(path.displacement.back()), 1e-4 * path.peak_displacement) << name;
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
