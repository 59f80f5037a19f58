#include "cromer/live/phyphox.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* config = R"json({"title": "Acceleration", "buffers": [{"name": "acc_time", "size": 0}],
  "inputs": [{"source": "accelerometer", "outputs": [{"x": "accX"}, {"y": "accY"}, {"t": "acc_time"}]}],
  "export": [{"set": "Settings", "sources": [{"label": "Mass (kg)", "buffer": "m"}]},
             {"set": "Raw Data", "sources": [{"label": "Time (s)", "buffer": "acc_time"},
               {"label": "Acceleration x (m/s^2)", "buffer": "accX"},
               {"label": "y, \"up\"", "buffer": "acc Y"}]}]})json";

PhyphoxSet set() { return *read_phyphox_config(config); }

TEST(Phyphox, TheConfigNamesBuffersAndHeadings) {
  EXPECT_THAT(set().buffers, ElementsAre("acc_time", "accX", "acc Y"));
  EXPECT_THAT(set().headings, ElementsAre("Time (s)", "Acceleration x (m/s^2)", "y   up"));
  EXPECT_EQ(set().experiment, "Acceleration");
  // Without an exported set, the sensor's own outputs.
  const auto sensor = read_phyphox_config(
      R"json({"inputs": [{"source": "gyroscope", "outputs": [{"x": "gyrX"}, {"t": "gyr_time"}]}]})json");
  ASSERT_TRUE(sensor);
  EXPECT_THAT(sensor->buffers, ElementsAre("gyr_time", "gyrX"));
}

TEST(Phyphox, AnExperimentWithoutTimeIsRefusedByName) {
  const auto none =
      read_phyphox_config(R"json({"title": "Spring", "export": [{"sources": [{"label": "Period (s)",
    "buffer": "T"}]}]})json");
  ASSERT_FALSE(none);
  EXPECT_THAT(in_words(none.error()), HasSubstr("\"Spring\""));
  for (const char* text : {"", "<html>", "[]", "{\"export\": 3}", "{\"export\": [3, {\"sources\": {}}]}"})
    EXPECT_FALSE(read_phyphox_config(text)) << text;
  EXPECT_FALSE(read_phyphox_config(std::string(100000, '[')));
}

TEST(Phyphox, AsksForAllOrForWhatIsNew) {
  EXPECT_EQ(phyphox_query(set(), std::nullopt), "/get?acc_time=full&accX=full&acc%20Y=full");
  EXPECT_EQ(phyphox_query(set(), 12.345678),
            "/get?acc_time=12.345678&accX=12.345678%7Cacc_time&acc%20Y=12.345678%7Cacc_time");
}

TEST(Phyphox, AnAnswerHasNullsAndBuffersOfUnequalLength) {
  const auto answer = read_phyphox_answer(
      R"json({"buffer": {"acc_time": {"size": 0, "updateMode": "partial", "buffer": [0.1, null, 0.3, 0.4]},
        "accX": {"buffer": [1, 2, null]}, "acc Y": {"buffer": [-1e-3, 5, 6, 7]}},
        "status": {"session": "abc", "measuring": true, "timedRun": false, "countDown": 0}})json",
      set());
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->rows.t, ElementsAre(0.1, 0.3));
  EXPECT_EQ(answer->rows.row(0)[1], -1e-3);
  EXPECT_TRUE(std::isnan(answer->rows.row(1)[0]));
  EXPECT_EQ(answer->uneven, 1u);
  EXPECT_TRUE(answer->measuring);
}

TEST(Phyphox, WhatIsNoAnswerIsAnError) {
  EXPECT_FALSE(read_phyphox_answer("busy", set()));
  EXPECT_FALSE(read_phyphox_answer(R"json({"buffer": []})json", set()));
  const auto other = read_phyphox_answer(R"json({"buffer": {"acc_time": {"buffer": [1]}}})json", set());
  ASSERT_FALSE(other);
  EXPECT_THAT(in_words(other.error()), HasSubstr("\"accX\""));
}

TEST(Phyphox, TheFirstTimeOfASetIsTaken) {
  const auto buffers = [](const std::string& sources) {
    const auto set = read_phyphox_config("{\"export\": [{\"sources\": [" + sources + "]}]}");
    return set ? set->buffers : std::vector<std::string>{};
  };
  const std::string x = R"json({"label": "x (m)", "buffer": "x"})json";
  for (const char* label : {"Time", "t (s)", "ZEIT in s"})
    EXPECT_THAT(buffers(x + ", {\"label\": \"" + label + "\", \"buffer\": \"t\"}"), ElementsAre("t", "x"))
        << label;
  EXPECT_THAT(
      buffers(x + R"json(, {"label": "Time a", "buffer": "t"}, {"label": "Time b", "buffer": "u"})json"),
      ElementsAre("t", "x"));
  EXPECT_THAT(buffers(x + R"json(, {"label": "Time", "buffer": "t"}, {"label": "y"})json"),
              ElementsAre("t", "x"));
  EXPECT_THAT(buffers(R"json({"label": "Time", "buffer": "t"})json"), ElementsAre());
  EXPECT_THAT(buffers(x + ", " + x), ElementsAre());
}

TEST(Phyphox, ASensorNeedsATimeAndAValue) {
  const auto headings = [](const std::string& outputs) {
    const auto set = read_phyphox_config(
        "{\"title\": \"a\", \"inputs\": [{\"source\": \"light\", \"outputs\": [" + outputs + "]}]}");
    return set ? set->headings : Headings{in_words(set.error())};
  };
  EXPECT_THAT(headings(R"json({"x": "a"}, 7, {"y": 8}, {"t": "b"}, {"z": "c"})json"),
              ElementsAre("Time (s)", "light x", "light z"));
  const std::string none =
      "the phone's experiment \"a\" has no values with a time; choose one with raw data, such as "
      "Acceleration (without g)";
  EXPECT_THAT(headings(R"json({"x": "a"})json"), ElementsAre(none));
  EXPECT_THAT(headings(R"json({"t": "a"})json"), ElementsAre(none));
}

TEST(Phyphox, NamesAreEncodedInQuestions) {
  EXPECT_EQ(phyphox_query({"", {"aZ-_.09", "a/b{~\xFF@"}, {}}, std::nullopt),
            "/get?aZ-_.09=full&a%2Fb%7B%7E%FF%40=full");
}

TEST(Phyphox, WhetherThePhoneMeasuresStandsInItsStatus) {
  const auto measuring = [](const std::string& status) {
    return read_phyphox_answer(R"json({"buffer": {"t": {"buffer": [1]}}, "status": )json" + status + "}",
                               {"", {"t"}, {}})
        ->measuring;
  };
  EXPECT_TRUE(measuring("{\"measuring\": true}"));
  for (const char* other : {"{\"measuring\": false}", "{\"measuring\": 1}", "{}", "[]", "true"})
    EXPECT_FALSE(measuring(other)) << other;
}

}  // namespace
}  // namespace cromer::core
