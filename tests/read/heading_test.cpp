// Names and units as loggers write them above their columns.
#include "cromer/documents/words/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/base/concat.h"
#include "cromer/read/header.h"
#include "cromer/read/recording.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

struct Spelling {
  const char* test;
  const char* time;
  double step;  // [s] of 1 in that column
};

void PrintTo(const Spelling& spelling, std::ostream* out) { *out << spelling.time; }

class TimeUnit : public testing::TestWithParam<Spelling> {};

TEST_P(TimeUnit, IsTakenFromTheHeader) {
  const std::string text = concat({"\"", GetParam().time, "\",\"Position (m)\"\n0,1\n1,2\n2,1\n3,0\n"});
  const auto recording = read_recording(text, "lab.csv", {});
  ASSERT_TRUE(recording.ok()) << in_words(recording.error());
  const auto series = take_series(*recording, "", 1, {});
  ASSERT_TRUE(series.ok()) << in_words(series.error());
  EXPECT_NEAR(series->t.at(1) / GetParam().step, 1, 1e-14);
  EXPECT_NEAR(series->rate * GetParam().step, 1, 1e-11);
  EXPECT_THAT(in_words(series->notices), Not(Contains(HasSubstr("has no unit"))));
}

INSTANTIATE_TEST_SUITE_P(
    Header, TimeUnit,
    testing::Values(Spelling{"Minutes", "Time (minutes)", 60}, Spelling{"Mins", "Time (mins)", 60},
                    Spelling{"Minute", "Time [minute]", 60}, Spelling{"Seconds", "Time (seconds)", 1},
                    Spelling{"Secs", "Time (Secs)", 1}, Spelling{"Hours", "Time (hours)", 3600},
                    Spelling{"Hr", "Time (hr)", 3600}, Spelling{"Msec", "Time (msec)", 1e-3},
                    Spelling{"Usec", "Time (usec)", 1e-6}, Spelling{"Capitals", "TIME (MS)", 1e-3},
                    Spelling{"Stroke", "Time/ms", 1e-3}, Spelling{"StrokeOfSymbol", "t / ms", 1e-3},
                    Spelling{"StrokeAndBrackets", "t/(ms)", 1e-3}, Spelling{"In", "t in ms", 1e-3},
                    Spelling{"Comma", "Time, ms", 1e-3}, Spelling{"LastWord", "timestamp ms", 1e-3},
                    Spelling{"Suffix", "time_millis", 1e-3}, Spelling{"Millis", "millis", 1e-3},
                    Spelling{"MillisCall", "millis()", 1e-3}, Spelling{"Micros", "micros", 1e-6},
                    Spelling{"NameIsUnit", "ms", 1e-3}, Spelling{"Within", "Time (ms) of the logger", 1e-3}),
    [](const auto& test) { return std::string(test.param.test); });

TEST(Heading, UnitsOfOtherColumns) {
  const auto heading = [](const char* cell) {
    const dialects::Heading taken = dialects::parse_heading(cell);
    return concat({taken.name, "|", taken.unit});
  };
  EXPECT_EQ(heading("Position/cm"), "Position|cm");
  EXPECT_EQ(heading("pos cm"), "pos|cm");
  EXPECT_EQ(heading("v/(m/s)"), "v|m/s");
  EXPECT_EQ(heading("acc g"), "acc|g");
  EXPECT_EQ(heading("Position (cm) smoothed"), "Position smoothed|cm");
  EXPECT_EQ(heading("Position/furlong"), "Position|furlong");
  // No units: a sensor's letter, an axis, a fraction, a path and a minimum.
  EXPECT_EQ(heading("Pos A"), "Pos A|");
  EXPECT_EQ(heading("Gyroscope x"), "Gyroscope x|");
  EXPECT_EQ(heading("Distance/s"), "Distance/s|");
  EXPECT_EQ(heading("s"), "s|");
  EXPECT_EQ(heading("min"), "min|");
}

TEST(Heading, ATimesUnitIsNeverGuessed) {
  const auto refusal = [](const char* time, const ReadOptions& options = {}) {
    const auto recording = read_recording(concat({time, ",x (m)\n0,1\n1,2\n2,1\n"}), "lab.csv", options);
    return recording ? "read" : in_words(recording.error());
  };
  EXPECT_THAT(refusal("Time (fortnights)"),
              HasSubstr("column \"Time (fortnights)\": the unit \"fortnights\" is not known"));
  EXPECT_THAT(refusal("Time/ticks"), HasSubstr("the unit \"ticks\" is not known"));
  EXPECT_THAT(refusal("Time (m)"), HasSubstr("the unit \"m\" is no unit of time"));
  ReadOptions named;
  named.time_column = "clock";
  EXPECT_THAT(refusal("clock (V)", named), HasSubstr("the unit \"V\" is no unit of time"));
  // Beside a good time another may be anything.
  EXPECT_TRUE(read_recording("Time (s),Local time (UTC),x\n0,7,1\n1,8,2\n2,9,1\n", "lab.csv", {}).ok());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
