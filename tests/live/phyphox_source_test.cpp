// A phone that is played by a server.
#include "cromer/live/phyphox_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "cromer/documents/words/words.h"
#include "cromer/live/source.h"
#include "server.h"

namespace cromer::core::test {
namespace {

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
  Rows rows;
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

}  // namespace
}  // namespace cromer::core::test
