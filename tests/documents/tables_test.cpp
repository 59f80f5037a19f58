// Tables of results that are made by hand, and of spectra in HDF5, word for word.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "cromer/documents/csv.h"
#include "cromer/documents/hdf5.h"
#include "cromer/documents/text.h"
#include "cromer/version.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::ElementsAre;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Two modes of two channels, the second of which is none of the network's.
ModesResult recorded_modes() {
  ModesResult result{.file = "tower.csv", .names = {"a", "b"}};
  result.recording.emplace();
  result.recording->words = Notice{"interrupted"};
  result.network.emplace();
  result.modes = {{.frequency = {2, 0.125, 1.75, 2.25},
                   .damping_ratio = {0.25, 0.0625, 0.125, 0.375},
                   .shape = {1, {0, -0.5}},
                   .shape_error = {{0.25, 0}, {0.5, 0.75}},
                   .of_network = ModeOfNetwork{2, 2.5, 0.5, 0.875}},
                  {.frequency = {4, 0, 4, 4},
                   .damping_ratio = {none, 0, none, none},
                   .shape = {-0.5, 1},
                   .shape_error = {{0, 0}, {0, 0}}}};
  return result;
}

TEST(ModesTable, OfARecordingHasErrorsAndTheNetworksModes) {
  EXPECT_EQ(
      modes_csv(recorded_modes()),
      "mode,frequency (Hz),frequency standard error (Hz),frequency 95 % low (Hz),frequency 95 % high (Hz),"
      "damping ratio,damping ratio standard error,damping ratio 95 % low,damping ratio 95 % high,"
      "participation,a re,a im,b re,b im,a re standard error,a im standard error,b re standard error,"
      "b im standard error,mode of the network,frequency of the network (Hz),"
      "damping ratio of the network,MAC\n"
      "1,2,0.125,1.75,2.25,0.25,0.0625,0.125,0.375,,1,0,0,-0.5,0.25,0,0.5,0.75,2,2.5,0.5,0.875\n"
      "2,4,0,4,4,,0,,,,-0.5,0,1,0,0,0,0,0,,,,\n");
}

TEST(ModesTable, OfANetworkHasSharesAndNoErrors) {
  ModesResult result = recorded_modes();
  result.recording.reset();
  result.modes[0].participation = 0.75;
  EXPECT_EQ(
      modes_csv(result),
      "mode,frequency (Hz),frequency standard error (Hz),frequency 95 % low (Hz),frequency 95 % high (Hz),"
      "damping ratio,damping ratio standard error,damping ratio 95 % low,damping ratio 95 % high,"
      "participation,a re,a im,b re,b im\n"
      "1,2,0.125,1.75,2.25,0.25,0.0625,0.125,0.375,0.75,1,0,0,-0.5\n"
      "2,4,0,4,4,,0,,,,-0.5,0,1,0\n");
  result.modes.clear();
  EXPECT_TRUE(modes_csv(result).ends_with("participation,a re,a im,b re,b im\n"));
}

TEST(ModesTable, InWordsHasADashForWhatIsNotKnown) {
  EXPECT_EQ(modes_text(recorded_modes()),
            "mode  frequency (Hz)                   95 %  damping ratio                   95 %\n"
            "1        2.00 ± 0.12  between 1.75 and 2.25    0.25 ± 0.06  between 0.12 and 0.38\n"
            "2                  4                                     -\n"
            "\n"
            "the two beat every 0.50 ± 0.03 s, 95 % between 0.444 and 0.571; coupling, the difference of "
            "their squared frequencies over the sum: 0.60 ± 0.04, 95 % between 0.520 and 0.680\n"
            "\n"
            "shape         mode 1  mode 2\n"
            "a              1.000  -0.500\n"
            "b      0.500 at -90°   1.000\n"
            "\n"
            "mode  of the network  frequency (Hz)  off by  damping ratio  off by     MAC\n"
            "1             mode 2             2.5   +25 %            0.5  +100 %  0.8750\n"
            "2                  -\n"
            "\n"
            "interrupted\n");
  ModesResult result = recorded_modes();
  result.recording.reset();
  result.modes[0].participation = 0.75;
  EXPECT_EQ(
      modes_text(result),
      "mode  frequency (Hz)                   95 %  damping ratio                   95 %  participation\n"
      "1        2.00 ± 0.12  between 1.75 and 2.25    0.25 ± 0.06  between 0.12 and 0.38           75 %\n"
      "2                  4                                     -                                     -\n"
      "\n"
      "the two beat every 0.50 ± 0.03 s, 95 % between 0.444 and 0.571; coupling, the difference of "
      "their squared frequencies over the sum: 0.60 ± 0.04, 95 % between 0.520 and 0.680\n"
      "\n"
      "shape         mode 1  mode 2\n"
      "a              1.000  -0.500\n"
      "b      0.500 at -90°   1.000\n");
  result.message = Notice{"interrupted"};
  EXPECT_EQ(modes_text(result), "");
}

TEST(ModesTable, ShapesAreShownOfUpToEightMassesAndModes) {
  const auto shown = [](std::size_t masses, std::size_t modes) {
    ModesResult result{.file = "chain.toml", .names = std::vector<std::string>(masses, "m")};
    result.modes.resize(modes);
    for (NaturalMode& mode : result.modes) mode.shape.resize(masses);
    return modes_text(result).find("\nshape") != std::string::npos;
  };
  EXPECT_TRUE(shown(8, 8));
  EXPECT_FALSE(shown(9, 8));
  EXPECT_FALSE(shown(8, 9));
}

TEST(ModesTable, AnglesAreShownFromHalfADegreeOn) {
  const auto component = [](double size, double degrees) {
    ModesResult result{.file = "chain.toml", .names = {"m"}};
    result.modes.resize(1);
    result.modes[0].shape = {std::polar(size, degrees * std::numbers::pi / 180)};
    const std::string text = modes_text(result), row = text.substr(text.find("\nm ") + 1);
    return row.substr(row.find_first_not_of(' ', 1));
  };
  EXPECT_EQ(component(0.25, 0.4), "0.250\n");
  EXPECT_EQ(component(0.25, 0.6), "0.250 at 1°\n");
  EXPECT_EQ(component(0.25, -0.6), "0.250 at -1°\n");
  EXPECT_EQ(component(0.25, 179.4), "0.250 at 179°\n");
  EXPECT_EQ(component(0.25, -179.6), "-0.250\n");
  EXPECT_EQ(component(0.0004, 90), "0.000\n");
  EXPECT_EQ(component(0.0006, 90), "0.001 at 90°\n");
}

/// The ground stands still but for one sample.
std::vector<Component> one_push() {
  Component component;
  component.file = "push.csv";
  component.column = "a (m/s^2)";
  component.acceleration = std::vector<double>(20, 0.0);
  component.acceleration[3] = 2;
  component.spacing = 0.01;
  return {component};
}

TEST(SpectrumTables, HaveTheAxesOfWhatWasAskedFor) {
  const auto of = [](const SpectrumOptions& options) {
    const auto result = response_spectrum(one_push(), options);
    EXPECT_TRUE(result.ok());
    return spectrum_tables(*result, "cromer spectrum push.csv").at(0);
  };
  const Hdf5Table elastic = of({.damping_ratio = {"0.02,0.05"}, .periods = "0.5,1,2"});
  ASSERT_EQ(elastic.columns.size(), 5u);
  EXPECT_EQ(elastic.columns[0].name, "damping_ratio");
  EXPECT_THAT(elastic.columns[0].values, ElementsAre(0.02, 0.05));
  EXPECT_EQ(elastic.columns[1].name, "period (s)");
  EXPECT_THAT(elastic.columns[1].values, ElementsAre(0.5, 1, 2));
  EXPECT_EQ(elastic.columns[2].name, "SD (m)");
  EXPECT_THAT(elastic.columns[2].shape, ElementsAre(2u, 3u));
  EXPECT_EQ(elastic.columns[2].axes, "damping_ratio period");
  EXPECT_EQ(elastic.columns[4].values.size(), 6u);

  const Hdf5Table hysteretic = of({.loss_factor = {"0.1"}, .periods = "0.5,1,2"});
  EXPECT_EQ(hysteretic.columns[0].name, "loss_factor");
  EXPECT_THAT(hysteretic.columns[0].values, ElementsAre(0.1));
  EXPECT_EQ(hysteretic.columns[2].axes, "loss_factor period");

  const Hdf5Table yielding = of({.damping_ratio = {"0.02,0.05"}, .ductility = {"2,4,8"}, .periods = "0.5,1"});
  EXPECT_THAT(yielding.columns[0].values, ElementsAre(0.02, 0.05));
  EXPECT_EQ(yielding.columns[1].name, "ductility");
  EXPECT_EQ(yielding.columns[2].name, "period (s)");
  ASSERT_GT(yielding.columns.size(), 3u);
  EXPECT_EQ(yielding.columns[3].axes, "damping_ratio ductility period");
  EXPECT_THAT(yielding.columns[1].values, ElementsAre(2, 4, 8));
  EXPECT_THAT(yielding.columns[3].shape, ElementsAre(2u, 3u, 2u));
  for (std::size_t i = 3; i < yielding.columns.size(); ++i)
    EXPECT_EQ(yielding.columns[i].values.size(), 12u) << yielding.columns[i].name;
}

TEST(SpectrumTables, InCsvNameTheDampingAndTheComponents) {
  const auto head_of = [](const SpectrumOptions& options) {
    const std::string csv = spectrum_csv(*response_spectrum(one_push(), options), "");
    return csv.substr(0, csv.find('\n'));
  };
  EXPECT_EQ(head_of({.periods = "1,2"}), "period (s),damping_ratio,SD (m),PSV (m/s),PSA (m/s²)");
  EXPECT_EQ(head_of({.loss_factor = {"0.1"}, .periods = "1,2"}),
            "period (s),loss_factor,SD (m),PSV (m/s),PSA (m/s²)");
  SpectrumResult result;
  result.components = one_push();
  result.components[0].fourier = {.step = 0.5, .amplitude = {1, 2, 3}};
  EXPECT_EQ(fourier_csv(result, ""), "frequency (Hz),amplitude (m/s)\n0,1\n0.5,2\n1,3\n");
  result.components.push_back(result.components[0]);
  result.components[1].fourier.amplitude = {4, 5, 6};
  EXPECT_EQ(fourier_csv(result, ""),
            "frequency (Hz),amplitude 1 (m/s),amplitude 2 (m/s)\n0,1,4\n0.5,2,5\n1,3,6\n");
}

TEST(SpectrumTables, OfManyMotionsAreThoseThatSucceeded) {
  const auto result = response_spectrum(one_push(), {.periods = "0.5,1,2"});
  ASSERT_TRUE(result.ok());
  const std::vector<MotionSpectra> motions{
      {{"none.csv"}, Error{"interrupted"}}, {{"push.csv"}, result}, {{"x.csv", "y.csv"}, result}};
  const auto tables = spectra_tables(motions, "cromer spectrum");
  ASSERT_EQ(tables.size(), 3u);
  EXPECT_EQ(tables[0].name, "");
  EXPECT_THAT(tables[0].texts, ElementsAre(std::pair("program", "cromer " CROMER_VERSION),
                                           std::pair("command", "cromer spectrum")));
  EXPECT_TRUE(tables[0].columns.empty());
  EXPECT_EQ(tables[1].name, "motion_2");
  EXPECT_EQ(tables[1].texts[0], std::pair(std::string("file"), std::string("push.csv")));
  EXPECT_EQ(tables[1].texts[1].first, "description");
  EXPECT_EQ(tables[1].texts[1].second.find("\"period\": ["), std::string::npos) << "the table has the curves";
  EXPECT_EQ(tables[2].name, "motion_3");
  EXPECT_EQ(tables[2].texts[0].second, "x.csv + y.csv");
  EXPECT_EQ(tables[2].columns.size(), 5u);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
