// What phyphox says, and a phone that is played by a server.
#include "cromer/live/phyphox.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <cmath>

#include "cromer/documents/words/words.h"
#include "cromer/live/source.h"
#include "server.h"

namespace cromer::core {
namespace CROMER_FILE {

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

}  // namespace CROMER_FILE
}  // namespace cromer::core

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;

/// What it holds may be changed while it is asked.
class Phone {
 public:
  Phone() : server([this](const std::string& target) { return answer(target); }) {}

  void hold(const std::vector<double>& times) {
    const std::lock_guard lock(mutex_);
    t_ = times;
  }
  std::vector<std::string> asked() const {
    std::vector<std::string> targets;
    for (const auto& request : server.requests())
      targets.push_back(request.substr(4, request.find(" HTTP") - 4));
    return targets;
  }

  std::atomic<bool> measuring{true}, broken{false};

 private:
  Reply answer(const std::string& target) {
    if (broken) return {"HTTP/1.1 500 No\r\nContent-Length: 0\r\n\r\n"};
    if (target == "/config")
      return {http(R"json({"title": "Spring", "export": [{"sources": [
        {"label": "Time (s)", "buffer": "t"}, {"label": "x (m)", "buffer": "x"}]}]})json")};
    if (target.starts_with("/control")) return measuring = true, Reply{http("{\"result\": true}")};
    const std::lock_guard lock(mutex_);
    std::string t, x;
    const bool all = target.find("t=full") != std::string::npos;
    const double after = all ? -1e9 : std::stod(target.substr(target.find("t=") + 2));
    for (const double each : t_)
      if (each >= after) t += fmt::format("{}{}", t.empty() ? "" : ",", each), x += x.empty() ? "5" : ",5";
    return {http(fmt::format(R"({{"buffer": {{"t": {{"buffer": [{}]}}, "x": {{"buffer": [{}]}}}},
                             "status": {{"measuring": {}}}}})",
                             t, x, measuring.load()))};
  }

  std::mutex mutex_;
  std::vector<double> t_;

 public:
  Server server;
};

struct Reading {
  explicit Reading(const Phone& phone) : source("127.0.0.1", phone.server.port()) {}
  void receive(double seconds = 0.2) { EXPECT_TRUE(source.receive(seconds, rows, notices)); }
  std::vector<std::string> texts() const {
    std::vector<std::string> all;
    for (const Remark& notice : notices) all.push_back(in_words(notice.what));
    return all;
  }

  PhyphoxSource source;
  SampleRows rows;
  std::vector<Remark> notices;
};

TEST(PhyphoxSource, TakesWhatIsNew) {
  Phone phone;
  phone.hold({1, 2});
  Reading reading(phone);
  ASSERT_TRUE(reading.source.open());
  EXPECT_THAT(reading.source.headings(), ElementsAre("Time (s)", "x (m)"));
  phone.hold({1, 2, 2.5, 3});
  reading.receive();
  phone.hold({1, 2, 2.5, 3, 3.25});
  reading.receive();
  EXPECT_THAT(reading.rows.t, ElementsAre(2.5, 3, 3.25));
  EXPECT_THAT(reading.rows.values, ElementsAre(5, 5, 5));
  EXPECT_EQ(reading.rows.width, 1u);
  EXPECT_THAT(reading.texts(), IsEmpty());
  EXPECT_THAT(phone.asked(),
              ElementsAre("/config", "/get?t=full&x=full", "/get?t=2&x=2%7Ct", "/get?t=3&x=3%7Ct"));
}

TEST(PhyphoxSource, AsksTenTimesASecond) {
  Phone phone;
  Reading reading(phone);
  ASSERT_TRUE(reading.source.open());
  const double begun = steady_seconds();
  for (int i = 0; i < 3; ++i) reading.receive();
  EXPECT_GE(steady_seconds() - begun, 0.28);
  EXPECT_LT(steady_seconds() - begun, 0.9);
  // But not later than it is told.
  const double soon = steady_seconds();
  for (int i = 0; i < 8; ++i) reading.receive(0.01);
  EXPECT_LT(steady_seconds() - soon, 0.6);
}

TEST(PhyphoxSource, StartsAPhoneThatIsNotMeasuring) {
  Phone phone;
  phone.measuring = false;
  phone.hold({1, 2});
  Reading reading(phone);
  ASSERT_TRUE(reading.source.open());
  EXPECT_THAT(phone.asked(), ElementsAre("/config", "/get?t=full&x=full", "/control?cmd=start"));
  phone.hold({1, 2, 3});
  reading.receive();
  reading.receive();
  EXPECT_THAT(reading.rows.t, ElementsAre(3));
  EXPECT_THAT(
      reading.texts(),
      ElementsAre("the phone was not measuring; its experiment \"Spring\" was started and is left running"));
}

TEST(PhyphoxSource, SaysThatTheMeasurementWasStopped) {
  Phone phone;
  Reading reading(phone);
  ASSERT_TRUE(reading.source.open());
  reading.receive();
  phone.measuring = false;
  reading.receive();
  reading.receive();
  phone.measuring = true;
  reading.receive();
  EXPECT_THAT(reading.texts(),
              ElementsAre("the measurement was stopped on the phone; start it there to go on",
                          "the phone measures again"));
}

TEST(PhyphoxSource, IsAskedAgainWhereItDoesNotAnswer) {
  Phone phone;
  Reading reading(phone);
  ASSERT_TRUE(reading.source.open());
  phone.broken = true;
  reading.receive(0.1);
  const double begun = steady_seconds();
  reading.receive(0.05);
  EXPECT_GE(steady_seconds() - begun, 0.08);
  phone.broken = false;
  phone.hold({1});
  reading.receive();
  EXPECT_THAT(reading.rows.t, ElementsAre(1));
  EXPECT_THAT(
      reading.texts(),
      ElementsAre(MatchesRegex("phyphox at 127.0.0.1:[0-9]+ does not answer: /get is answered with status "
                               "500; it is asked again"),
                  MatchesRegex("phyphox at 127.0.0.1:[0-9]+ is back after [0-9.]+ s")));
}

TEST(PhyphoxSource, SeesThatItsDataWereCleared) {
  for (const std::vector<double>& held : {std::vector<double>{}, {0.5}}) {
    Phone phone;
    phone.hold({5});
    Reading reading(phone);
    ASSERT_TRUE(reading.source.open());
    phone.hold({5, 6});
    reading.receive();
    phone.hold(held);
    const double begun = steady_seconds();
    while (reading.notices.empty() && steady_seconds() - begun < 3) reading.receive();
    EXPECT_GE(steady_seconds() - begun, 0.95);
    EXPECT_LT(steady_seconds() - begun, 1.9);
    EXPECT_THAT(reading.texts(), ElementsAre("the phone's data were cleared; its times begin anew"));
    phone.hold({0.5, 0.75});
    reading.receive();
    ASSERT_EQ(reading.rows.size(), 3u);
    EXPECT_THAT(in_words(reading.notices.at(1).what), HasSubstr("jumped back by 5.5 s"));
  }
}

TEST(PhyphoxSource, AQuietPhoneWasNotCleared) {
  Phone phone;
  phone.hold({5});
  Reading reading(phone);
  ASSERT_TRUE(reading.source.open());
  const double begun = steady_seconds();
  while (steady_seconds() - begun < 1.3) reading.receive();
  EXPECT_THAT(reading.texts(), IsEmpty());
  EXPECT_THAT(phone.asked(), ::testing::Contains("/get?t=full"));
}

TEST(PhyphoxSource, WhatItCannotOpenIsAnError) {
  Phone phone;
  phone.broken = true;
  Reading reading(phone);
  const auto opened = reading.source.open();
  ASSERT_FALSE(opened);
  EXPECT_THAT(in_words(opened.error()),
              MatchesRegex("phyphox:127.0.0.1:[0-9]+: /config is answered with status 500"));
  Server other([](const std::string&) { return Reply{http("{}")}; });
  PhyphoxSource source("127.0.0.1", other.port());
  EXPECT_THAT(in_words(source.open().error()),
              HasSubstr("the phone's experiment \"\" has no values with a time"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
