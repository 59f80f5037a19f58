// Files that other people's loggers wrote, as they published them (../shared/data; not part of the project),
// and what is in them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "cromer/base/concat.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/columns.h"
#include "cromer/read/recording.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace CROMER_FILE {

/// What a file is known to hold: counted and read off in it by hand, beside what its author says of it.
struct Known {
  const char* file;
  double rate;                       ///< to give, 0 where the file has times
  const char* dialect;               ///< name, encoding, separator, decimal mark
  std::vector<std::string> columns;  ///< run, title, quantity, values that are there
  const char* column;                ///< to take
  std::vector<std::string> series;   ///< of each run: samples, rate, duration, gaps, outliers
  double first, last;                ///< values of run 1 in SI
  std::vector<std::string> notices;  ///< of the file, then of run 1
};

void PrintTo(const Known& known, std::ostream* out) { *out << known.file; }

std::vector<Known> measured_files() {
  return {

      Known{"spring-disc-pasco/molla_durissima_discopieno_14.91945_0.2016_1.csv",
            0,
            "plain, UTF-8, semicolon, point",
            {"1 time: time 11886", "1 position: position 11886", "1 velocity: velocity 11885",
             "1 acceleration: acceleration 11883"},
            "",
            {"11886 at 100 Hz, 118.850 s, 0 gaps, 0 outliers"},
            0.4788,
            0.4182,
            {"column \"velocity\": 1 missing value, the first in line 11887",
             "column \"acceleration\": 3 missing values, the first in line 11885",
             "column \"position\" has no unit: m is assumed; the header can name another, in brackets behind "
             "the column's name",
             "column \"time\" has no unit: s is assumed; the header can name another, in brackets behind the "
             "column's name"}},
      Known{"spring-disc-pasco/molla_dura_discopieno_0.1223kg.csv",
            0,
            "PASCO Capstone, UTF-8 with BOM, semicolon, comma",
            {"1 Time (s): time 7230", "1 Position (m): position 7230", "1 Velocity (m/s): velocity 7228"},
            "",
            {"7230 at 100 Hz, 72.2900 s, 0 gaps, 0 outliers"},
            0.46,
            0.36,
            {"column \"Velocity (m/s)\": 2 missing values, the first in line 2"}},
      Known{"spring-disc-pasco/molla_dura_discopieno_battimenti_0.1419kg_frequenza_1.207hz.csv",
            0,
            "PASCO Capstone, UTF-8 with BOM, semicolon, comma",
            {"1 Time (s): time 38335", "1 Position (m): position 38335", "1 Velocity (m/s): velocity 38333",
             "1 Acceleration (m/s²): acceleration 38330"},
            "",
            {"38335 at 100 Hz, 383.340 s, 0 gaps, 0 outliers"},
            0.01,
            -0.03,
            {"column \"Velocity (m/s)\": 2 missing values, the first in line 2",
             "column \"Acceleration (m/s²)\": 5 missing values, the first in line 2"}},
      Known{
          "spring-disc-capstone-mm/Oscillazioni non_pretensionata_cd_3e1masse.csv",
          100,
          "PASCO Capstone, UTF-8 with BOM, semicolon, comma",
          {"1 Position (mm): position 3058", "2 Position (mm): position 2558"},
          "",
          {"3058 at 100 Hz, 30.5700 s, 0 gaps, 0 outliers", "2558 at 100 Hz, 25.5700 s, 0 gaps, 0 outliers"},
          0.060384700000000006,
          -0.0122646,
          {}},
      Known{"spring-disc-capstone-mm/Misure k statiche non_pretensionata.csv",
            100,
            "PASCO Capstone, UTF-8 with BOM, semicolon, comma",
            {"1 Position (mm): position 1275", "2 Position (mm): position 1710",
             "3 Position (mm): position 1223"},
            "",
            {"1275 at 100 Hz, 12.7400 s, 0 gaps, 0 outliers", "1710 at 100 Hz, 17.0900 s, 0 gaps, 0 outliers",
             "1223 at 100 Hz, 12.2200 s, 0 gaps, 0 outliers"},
            -0.00017199999999999998,
            0.00034399999999999996,
            {}},
      Known{"pendulum-tracker/8047.txt",
            0,
            "Tracker, UTF-8, tab, point",
            {"1 t: time 4206", "1 x: position 4206", "1 y: position 4206"},
            "x",
            {"4206 at 30.0 Hz, 140.225 s, 0 gaps, 0 outliers"},
            0.4143889733848767,
            0.1686570972713174,
            {"column \"x\" has no unit: m is assumed; the header can name another, in brackets behind the "
             "column's name",
             "column \"t\" has no unit: s is assumed; the header can name another, in brackets behind the "
             "column's name"}},
      Known{"pendulum-tracker/8051.txt",
            0,
            "Tracker, UTF-8, tab, point",
            {"1 t: time 4123", "1 x: position 4123", "1 y: position 4123", "1 func:  4123"},
            "x",
            {"4123 at 30.0 Hz, 137.458 s, 0 gaps, 0 outliers"},
            0.24835480730132775,
            -0.03877977880587191,
            {"column \"x\" has no unit: m is assumed; the header can name another, in brackets behind the "
             "column's name",
             "column \"t\" has no unit: s is assumed; the header can name another, in brackets behind the "
             "column's name"}},
      Known{"pendulum-plain/lab1_data.txt",
            0,
            "plain, UTF-8, blanks, point",
            {"1 column 1: time 2330", "1 column 2:  2330", "1 column 3:  2330"},
            "",
            {"2330 at 20.0 Hz, 116.409 s, 0 gaps, 0 outliers"},
            0.7020338666008175,
            -0.12161902326134658,
            {"the first column runs evenly upward: it is taken as the time in seconds",
             "no column is known to be a position, angle or velocity: of \"column "
             "2\", \"column 3\", \"column 2\" is taken; --column names another",
             "column \"column 2\" has no unit: its values are taken as they are",
             "column \"column 1\" has no unit: s is assumed; the header can name another, in brackets behind "
             "the column's name"}},
      Known{"pendulum-plain/encoder_comma_space.csv",
            0,
            "plain, UTF-8, comma, point",
            {"1 time: time 13604", "1 angle: angle 13604"},
            "",
            {"13604 at 99.6 Hz, 136.563 s, 0 gaps, 0 outliers"},
            1.6441001553786583,
            0,
            {"column \"angle\" has no unit: rad is assumed; the header can name another, in brackets behind "
             "the column's name",
             "column \"time\" has no unit: s is assumed; the header can name another, in brackets behind the "
             "column's name"}},
      Known{"pendulum-plain/two_sensors_alternating.txt",
            0,
            "plain, UTF-8, tab, point",
            {"1 Time A (s): time 356", "1 Pos A (au): position 356", "1 Time B (s): time 356",
             "1 Pos B (au): position 356"},
            "Pos B",
            {"356 at 19.7 Hz, 17.9950 s, 0 gaps, 0 outliers"},
            465,
            468,
            {"unit \"au\" of column \"Pos B\" is not known: its values are taken as they are"}},
      Known{"seismometer-datastudio/Q1.txt",
            0,
            "DataStudio, UTF-8, tab, point",
            {"1 Time (s): time 618", "1 Voltage (V): voltage 618"},
            "",
            {"618 at 10 Hz, 61.7000 s, 0 gaps, 0 outliers"},
            -0.009,
            -0.004,
            {"no column is known to be a position, angle or velocity: \"Voltage (V)\" is taken"}},
      Known{"seismometer-datastudio/75mm damping.txt",
            0,
            "DataStudio, UTF-8, tab, point",
            {"1 Time (s): time 2616", "1 Voltage (V): voltage 2616"},
            "",
            {"2616 at 10 Hz, 261.500 s, 0 gaps, 0 outliers"},
            0.014,
            -0.002,
            {"no column is known to be a position, angle or velocity: \"Voltage (V)\" is taken"}},
      Known{"seismometer-datastudio/train2.txt",
            0,
            "DataStudio, UTF-8, tab, point",
            {"1 Time (s): time 6132", "1 Voltage (V): voltage 6132"},
            "",
            {"6132 at 10 Hz, 613.100 s, 0 gaps, 0 outliers"},
            -0.002,
            0.002,
            {"no column is known to be a position, angle or velocity: \"Voltage (V)\" is taken"}},
      Known{"pendulum-phyphox/gyro_comma.csv",
            0,
            "phyphox, UTF-8, comma, point",
            {"1 Time (s): time 2239", "1 Gyroscope x (rad/s): angular velocity 2239",
             "1 Gyroscope y (rad/s): angular velocity 2239", "1 Gyroscope z (rad/s): angular velocity 2239",
             "1 Absolute (rad/s): angular velocity 2239"},
            "Gyroscope x",
            {"2239 at 99.6 Hz, 22.4669 s, 0 gaps, 0 outliers"},
            0.4023174345,
            -0.09834413975,
            {}},
      Known{"pendulum-phyphox/acceleration_tab.csv",
            0,
            "phyphox, UTF-8, tab, point",
            {"1 Time (s): time 419", "1 Linear Acceleration x (m/s^2): acceleration 419",
             "1 Linear Acceleration y (m/s^2): acceleration 419",
             "1 Linear Acceleration z (m/s^2): acceleration 419",
             "1 Absolute acceleration (m/s^2): acceleration 419"},
            "Linear Acceleration x",
            {"419 at 99.6 Hz, 4.19719 s, 0 gaps, 0 outliers"},
            -0.2589148553,
            -0.4545689768,
            {}},
      Known{"pendulum-phyphox/RawData_converted_from_xls.csv",
            0,
            "phyphox, UTF-8, comma, point",
            {"1 Time (s): time 484", "1 Rotation x (rad/s): angular velocity 484",
             "1 Rotation y (rad/s): angular velocity 484", "1 Rotation z (rad/s): angular velocity 484"},
            "Rotation x",
            {"484 at 48.4 Hz, 9.97533 s, 0 gaps, 1 outliers"},
            0.1078176349401474,
            0.24205516278743744,
            {"1 sample sticks out alone, the first in line 485"}},
      Known{"torsion-50hz/0.96500.1.csv",
            0,
            "plain, UTF-8, tab, comma",
            {"1 Tempo: time 15017", "1 Forzante:  15017", "1 Pendolo:  15017", "1 Ampiezza:  15017",
             "1 Fase:  15017"},
            "Pendolo",
            {"15017 at 50 Hz, 300.320 s, 0 gaps, 0 outliers"},
            0.013,
            0.018,
            {"column \"Pendolo\" has no unit: its values are taken as they are",
             "column \"Tempo\" has no unit: s is assumed; the header can name another, in brackets behind "
             "the column's name"}},
      Known{"ground-motion/elcentro_chopra.csv",
            0,
            "plain, UTF-8, comma, point",
            {"1 time: time 1560", "1 acc (g): acceleration 1560"},
            "",
            {"1560 at 50 Hz, 31.1800 s, 0 gaps, 0 outliers"},
            0,
            0,
            {"column \"time\" has no unit: s is assumed; the header can name another, in brackets behind the "
             "column's name"}},
      Known{"ground-motion/RSN753_LOMAP_CLS000-hor1.AT2",
            0,
            "PEER, UTF-8, blanks, point",
            {"1 Time (s): time 7997", "1 Acceleration (g): acceleration 7997"},
            "",
            {"7997 at 200 Hz, 39.9800 s, 0 gaps, 0 outliers"},
            0.0136793745382,
            0.0001688755143915,
            {}},
      Known{"ground-motion/RSN8883_14383980_13849090.AT2",
            0,
            "PEER, UTF-8, blanks, point",
            {"1 Time (s): time 16396", "1 Acceleration (g): acceleration 16396"},
            "",
            {"16396 at 200 Hz, 81.9750 s, 0 gaps, 0 outliers"},
            8.5220220973265e-07,
            0.00022923534707499998,
            {}},
      Known{"ground-motion/RSN8883_14383980_13849360.AT2",
            0,
            "PEER, UTF-8, blanks, point",
            {"1 Time (s): time 16396", "1 Acceleration (g): acceleration 16396"},
            "",
            {"16396 at 200 Hz, 81.9750 s, 0 gaps, 0 outliers"},
            -4.1715287507075e-06,
            -0.0057512500295285,
            {}},
      Known{"ground-motion/eqsig_motion_dt0p01.txt",
            0,
            "plain, UTF-8, none, point",
            {"1 Time (s): time 4684", "1 test-motion:  4684"},
            "",
            {"4684 at 100 Hz, 46.8300 s, 0 gaps, 0 outliers"},
            2.42e-07,
            -3.15e-05,
            {"the line \"4684 0.0100\" counts the rows: 0.01 s is taken as their step",
             "no column is known to be a position, angle or velocity: \"test-motion\" is taken",
             "column \"test-motion\" has no unit: its values are taken as they are"}},
      Known{"ground-motion/eqsig_motion_spectrum_5pct.csv",
            100,
            "plain, UTF-8 with BOM, comma, point",
            {"1 Period (s):  113", "1 5% Damped Spectral Acceleration (g): acceleration 113"},
            "5% Damped Spectral Acceleration",
            {"113 at 100 Hz, 1.12000 s, 0 gaps, 0 outliers"},
            1.4198371680017,
            0.039548218893399996,
            {}},
      Known{"ground-motion/reference_psa_rsn8883_z0.05.csv",
            100,
            "plain, UTF-8, comma, point",
            {"1 period_s:  111", "1 h1_psa_g:  111", "1 h2_psa_g:  111", "1 rotd50_psa_g:  111"},
            "h1_psa_g",
            {"111 at 100 Hz, 1.10000 s, 0 gaps, 0 outliers"},
            0.1602728,
            0.00023846,
            {"column \"h1_psa_g\" has no unit: its values are taken as they are"}},
      Known{"wheel-gyro/bicycle-wheel-radial-inertia-rate-gyro-measurement.csv",
            0,
            "plain, UTF-8, comma, point",
            {"1 time: time 1001", "1 angular_velocity: angular velocity 1001"},
            "",
            {"1001 at 500 Hz, 2.00000 s, 0 gaps, 0 outliers"},
            3.236790061330015,
            -0.030127249708722107,
            {"column \"angular_velocity\" has no unit: rad/s is assumed; the header can name another, in "
             "brackets "
             "behind the column's name",
             "column \"time\" has no unit: s is assumed; the header can name another, in brackets behind the "
             "column's name"}},
      Known{"silverbox/silverbox_train.csv",
            610.3515625,
            "plain, UTF-8, comma, point",
            {"1 V1:  65062", "1 V2:  65062"},
            "V2",
            {"65062 at 610.3515625 Hz, 106.596 s, 0 gaps, 0 outliers"},
            0.036451,
            -0.0036059,
            {"column \"V2\" has no unit: its values are taken as they are"}},
      Known{"dialects/labview.lvm",
            0,
            "LabVIEW, UTF-8, tab, point",
            {"1 X_Value (s): time 3941", "1 Voltage (V): voltage 3941", "1 Force (Pounds): force 3941",
             "1 Acceleratio (g): acceleration 3941"},
            "Acceleratio",
            {"3941 at 200 Hz, 19.7000 s, 0 gaps, 0 outliers"},
            -0.1637122151,
            0.055309505999999994,
            {"the header says 1050000 samples per channel, but there are 3941 rows: the rows are taken",
             "the header says Delta_X 1.953125e-05, but X_Value goes in steps of 0.005: X_Value is taken"}},
      Known{"tables/chopra_elcentro_peaks.csv",
            100,
            "plain, UTF-8, comma, point",
            {"1 Tn_s:  5", "1 zeta:  5", "1 chopra_peak_u_in:  5", "1 exact_piecewise_linear_in:  5"},
            "chopra_peak_u_in",
            {"5 at 100 Hz, 0.0400000 s, 0 gaps, 0 outliers"},
            2.67,
            5.37,
            {"column \"chopra_peak_u_in\" has no unit: its values are taken as they are"}},
      Known{"tables/chopra_sdof_halfsine.csv",
            0,
            "plain, UTF-8, comma, point",
            {"1 t: time 11", "1 theoretical:  11", "1 ex5_1_interpolation:  11",
             "1 ex5_2_central_difference:  11", "1 ex5_3_avg_accel_u: acceleration 11",
             "1 ex5_3_avg_accel_v: acceleration 11", "1 ex5_3_avg_accel_a: acceleration 11",
             "1 ex5_4_lin_accel_u: acceleration 11", "1 ex5_4_lin_accel_v: acceleration 11",
             "1 ex5_4_lin_accel_a: acceleration 11", "1 ex5_5_epp_newton_u:  11", "1 ex5_5_epp_newton_v:  11",
             "1 ex5_5_epp_newton_a:  11"},
            "theoretical",
            {"11 at 10 Hz, 1.00000 s, 0 gaps, 0 outliers"},
            0,
            -1.2718,
            {"column \"theoretical\" has no unit: its values are taken as they are",
             "column \"t\" has no unit: s is assumed; the header can name another, in brackets behind the "
             "column's name"}}};
}

using testing::Contains;
using testing::HasSubstr;

const std::filesystem::path folder = std::filesystem::path(CROMER_SOURCE_DIR) / ".." / "shared" / "data";

/// The file's name in letters and digits.
std::string test_name(const testing::TestParamInfo<Known>& test) {
  std::string name;
  for (const char c : std::filesystem::path(test.param.file).stem().string())
    name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

std::string dialect_of(const Recording& recording) {
  const Dialect& dialect = recording.dialect;
  return concat({dialect.name, ", ", dialect.encoding, ", ", dialect.separator, ", ", dialect.decimal});
}

std::vector<std::string> columns_of(const Recording& recording) {
  std::vector<std::string> all;
  for (const Column& column : recording.table.columns) {
    const auto there = std::count_if(column.values.begin(), column.values.end(),
                                     [](double value) { return !std::isnan(value); });
    all.push_back(concat({std::to_string(column.run), " ", column_title(column), ": ", column.quantity, " ",
                          std::to_string(there)}));
  }
  return all;
}

/// Jitter moves the median step: three digits of the rate.
std::string series_of(const Series& series) {
  const std::string rate = series.jitter > 1e-6 ? rounded(series.rate, 3) : shortest(series.rate);
  return concat({std::to_string(series.t.size()), " at ", rate, " Hz, ",
                 rounded(series.t.back() - series.t.front(), 6), " s, ", std::to_string(series.gaps.size()),
                 " gaps, ", std::to_string(series.outliers.size()), " outliers"});
}

class MeasuredFile : public testing::TestWithParam<Known> {};

TEST_P(MeasuredFile, IsReadRightly) {
  const Known& known = GetParam();
  if (!std::filesystem::exists(folder / known.file)) GTEST_SKIP() << "no " << (folder / known.file);
  ReadOptions options;
  options.rate = known.rate;
  const auto recording = read_recording(bytes_of(folder / known.file), known.file, options);
  ASSERT_TRUE(recording.ok()) << in_words(recording.error());
  EXPECT_EQ(dialect_of(*recording), known.dialect);
  EXPECT_EQ(columns_of(*recording), known.columns);
  std::vector<std::string> all, notices = in_words(recording->notices);
  for (const int run : runs(*recording)) {
    const auto series = take_series(*recording, known.column, run, options);
    ASSERT_TRUE(series.ok()) << in_words(series.error());
    all.push_back(series_of(*series));
    if (run > 1) continue;
    EXPECT_DOUBLE_EQ(series->y.front(), known.first);
    EXPECT_DOUBLE_EQ(series->y.back(), known.last);
    for (const std::string& said : in_words(series->notices)) notices.push_back(said);
  }
  EXPECT_EQ(all, known.series);
  EXPECT_EQ(notices, known.notices);
}

INSTANTIATE_TEST_SUITE_P(Shared, MeasuredFile, testing::ValuesIn(measured_files()), test_name);

TEST(MeasuredFiles, ATableOfWordsIsRefused) {
  const auto path = folder / "silverbox" / "published_rmse_van_mulders.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const auto recording = read_recording(bytes_of(path), "published.csv", {});
  ASSERT_FALSE(recording.ok());
  EXPECT_THAT(in_words(recording.error()),
              HasSubstr("column \"num_parameters\": \"490 (support vectors)\" is not a number"));
}

TEST(MeasuredFiles, TrackerNeedsAChoiceOfColumn) {
  const auto path = folder / "pendulum-tracker" / "8047.txt";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const auto recording = read_recording(bytes_of(path), "8047.txt", {});
  ASSERT_TRUE(recording.ok());
  const auto series = take_series(*recording, "", 1, {});
  ASSERT_FALSE(series.ok());
  EXPECT_THAT(in_words(series.error()), HasSubstr("\"x\", \"y\""));
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
  EXPECT_THAT(in_words(series->notices),
              Contains(HasSubstr("\"position\" has no unit: m is assumed; the header can name another, in "
                                 "brackets behind the column's name")));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
