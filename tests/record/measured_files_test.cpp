// Files that other people's loggers wrote, as they published them (../shared/data; not part of the project).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "cromer/record/dialects/recording.h"

namespace cromer {
namespace {

using testing::Contains;
using testing::HasSubstr;

const std::filesystem::path folder = std::filesystem::path(CROMER_SOURCE_DIR) / ".." / "shared" / "data";

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What a file is known to hold: counted and read off in it by hand.
struct Known {
  const char* file;
  const char* dialect;
  const char* separator;
  const char* decimal;
  std::size_t columns;
  std::size_t rows;
  int runs;
  const char* column;  ///< to take
  double rate;         ///< to give, 0 where the file has times
  double expected_rate, rate_tolerance;
  double first, last;  ///< values in SI
};

void PrintTo(const Known& known, std::ostream* out) { *out << known.file; }

/// The file's name in letters and digits.
std::string test_name(const testing::TestParamInfo<Known>& test) {
  std::string name;
  for (const char c : std::filesystem::path(test.param.file).stem().string())
    name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

class MeasuredFile : public testing::TestWithParam<Known> {};

TEST_P(MeasuredFile, IsReadRightly) {
  const Known& known = GetParam();
  if (!std::filesystem::exists(folder / known.file)) GTEST_SKIP() << "no " << (folder / known.file);
  ReadOptions options;
  options.rate = known.rate;
  const auto recording = read_recording(bytes_of(folder / known.file), known.file, options);
  ASSERT_TRUE(recording.ok()) << recording.error().message;
  EXPECT_EQ(recording->dialect.name, known.dialect);
  EXPECT_EQ(recording->dialect.separator, known.separator);
  EXPECT_EQ(recording->dialect.decimal, known.decimal);
  EXPECT_EQ(recording->table.columns.size(), known.columns);
  EXPECT_EQ(recording->table.rows(), known.rows);
  EXPECT_EQ(runs(*recording).size(), static_cast<std::size_t>(known.runs));
  const auto series = take_series(*recording, known.column, 1, options);
  ASSERT_TRUE(series.ok()) << series.error().message;
  EXPECT_NEAR(series->rate, known.expected_rate, known.rate_tolerance);
  EXPECT_DOUBLE_EQ(series->y.front(), known.first);
  EXPECT_DOUBLE_EQ(series->y.back(), known.last);
}

INSTANTIATE_TEST_SUITE_P(
    Shared, MeasuredFile,
    testing::Values(Known{"spring-disc-pasco/molla_durissima_discopieno_14.91945_0.2016_1.csv", "plain",
                          "semicolon", "point", 4, 11886, 1, "", 0, 100, 1e-6, 0.4788, 0.4182},
                    Known{"spring-disc-pasco/molla_dura_discopieno_0.1223kg.csv", "PASCO Capstone",
                          "semicolon", "comma", 3, 7230, 1, "", 0, 100, 1e-6, 0.46, 0.36},
                    Known{"spring-disc-pasco/molla_dura_discopieno_battimenti_0.1419kg_frequenza_1.207hz.csv",
                          "PASCO Capstone", "semicolon", "comma", 4, 38335, 1, "", 0, 100, 1e-6, 0.01, -0.03},
                    Known{"spring-disc-capstone-mm/Oscillazioni non_pretensionata_cd_3e1masse.csv",
                          "PASCO Capstone", "semicolon", "comma", 2, 3058, 2, "", 100, 100, 1e-6, 0.0603847,
                          -0.0122646},
                    Known{"spring-disc-capstone-mm/Misure k statiche non_pretensionata.csv", "PASCO Capstone",
                          "semicolon", "comma", 3, 1710, 3, "", 100, 100, 1e-6, -0.000172, 0.000344},
                    Known{"pendulum-tracker/8047.txt", "Tracker", "tab", "point", 3, 4206, 1, "x", 0, 30,
                          1e-6, 0.4143889733848767, 0.1686570972713174},
                    Known{"pendulum-tracker/8051.txt", "Tracker", "tab", "point", 4, 4123, 1, "x", 0, 30,
                          1e-6, 0.24835480730132775, -0.03877977880587191},
                    Known{"pendulum-plain/lab1_data.txt", "plain", "blanks", "point", 3, 2330, 1, "", 0, 20,
                          0.1, 0.7020338666008175, -0.12161902326134658},
                    Known{"pendulum-plain/encoder_comma_space.csv", "plain", "comma", "point", 2, 13604, 1,
                          "", 0, 100, 0.1, 1.6441001553786583, 0},
                    Known{"pendulum-plain/two_sensors_alternating.txt", "plain", "tab", "point", 4, 356, 1,
                          "Pos A", 0, 19.6, 0.1, 387, 377},
                    Known{"seismometer-datastudio/Q1.txt", "DataStudio", "tab", "point", 2, 618, 1, "", 0, 10,
                          1e-6, -0.009, -0.004},
                    Known{"seismometer-datastudio/75mm damping.txt", "DataStudio", "tab", "point", 2, 2616, 1,
                          "", 0, 10, 1e-6, 0.014, -0.002},
                    Known{"seismometer-datastudio/train2.txt", "DataStudio", "tab", "point", 2, 6132, 1, "",
                          0, 10, 1e-6, -0.002, 0.002},
                    Known{"pendulum-phyphox/gyro_comma.csv", "phyphox", "comma", "point", 5, 2239, 1,
                          "Gyroscope x", 0, 99.6, 0.1, 4.023174345e-1, -9.834413975e-2},
                    Known{"pendulum-phyphox/acceleration_tab.csv", "phyphox", "tab", "point", 5, 419, 1,
                          "Linear Acceleration x", 0, 99.6, 0.1, -2.589148553e-1, -4.545689768e-1},
                    Known{"torsion-50hz/0.96500.1.csv", "plain", "tab", "comma", 5, 15017, 1, "Pendolo", 0,
                          50, 1e-6, 0.013, 0.018},
                    Known{"ground-motion/elcentro_chopra.csv", "plain", "comma", "point", 2, 1560, 1, "", 0,
                          50, 1e-6, 0, 0},
                    Known{"wheel-gyro/bicycle-wheel-radial-inertia-rate-gyro-measurement.csv", "plain",
                          "comma", "point", 2, 1001, 1, "", 0, 500, 1e-6, 3.236790061330015,
                          -0.030127249708722107},
                    Known{"silverbox/silverbox_train.csv", "plain", "comma", "point", 2, 65062, 1, "V2",
                          610.3515625, 610.3515625, 1e-6, 0.036451, -0.0036059}),
    test_name);

TEST(MeasuredFiles, TrackerNeedsAChoiceOfColumn) {
  const auto path = folder / "pendulum-tracker" / "8047.txt";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const auto recording = read_recording(bytes_of(path), "8047.txt", {});
  ASSERT_TRUE(recording.ok());
  const auto series = take_series(*recording, "", 1, {});
  ASSERT_FALSE(series.ok());
  EXPECT_THAT(series.error().message, HasSubstr("\"x\", \"y\""));
}

TEST(MeasuredFiles, TheLongRunsHaveNoOutliersButRoundingSteps) {
  const auto path = folder / "spring-disc-pasco" / "molla_durissima_discopieno_14.91945_0.2016_1.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const auto recording = read_recording(bytes_of(path), "lab.csv", {});
  ASSERT_TRUE(recording.ok());
  const auto series = take_series(*recording, "", 1, {});
  ASSERT_TRUE(series.ok());
  EXPECT_TRUE(series->outliers.empty());
  EXPECT_DOUBLE_EQ(series->resolution, 1e-4);
  EXPECT_THAT(series->warnings, Contains(HasSubstr("\"position\" has no unit: m is assumed")));
}

}  // namespace
}  // namespace cromer
