#include "cromer/live/line_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"
#include "server.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;

/// Pipes that are opened one after the other; an Error where there is none.
struct Pipes {
  Result<Descriptor> open() {
    if (ready == 0) return Error{"not there"};
    --ready;
    int ends[2];
    EXPECT_EQ(::pipe(ends), 0);
    to = Descriptor(ends[1]);
    return Descriptor(ends[0]);
  }
  void send(const std::string& text) {
    EXPECT_EQ(::write(to.number(), text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  int ready = 1;
  Descriptor to;
};

struct Reading {
  explicit Reading(bool comes_back) : source("lab", [this] { return pipes.open(); }, comes_back, false, {}) {}
  bool receive(double seconds = 0.01) { return source.receive(seconds, rows, notices); }

  Pipes pipes;
  LineSource source;
  SampleRows rows;
  std::vector<Remark> notices;
};

TEST(LineSource, EndsWithItsInput) {
  Reading reading(false);
  ASSERT_TRUE(reading.source.open());
  EXPECT_TRUE(reading.receive());
  EXPECT_EQ(reading.rows.size(), 0u);
  reading.pipes.send("0.00 1.5\n0.01 1.");
  EXPECT_TRUE(reading.receive());
  EXPECT_THAT(reading.rows.values, ElementsAre(1.5));
  reading.pipes.send("25");
  EXPECT_TRUE(reading.receive());
  reading.pipes.to.close();
  EXPECT_FALSE(reading.receive());
  EXPECT_THAT(reading.rows.values, ElementsAre(1.5, 1.25));
  EXPECT_THAT(reading.source.headings(), ElementsAre("Time (s)", "Value"));
  EXPECT_EQ(reading.source.times().by, TimesBy::device);
  EXPECT_THAT(reading.notices, IsEmpty());
}

TEST(LineSource, WaitsAsLongAsItIsTold) {
  Reading reading(true);
  ASSERT_TRUE(reading.source.open());
  const double begun = steady_seconds();
  reading.receive(0.06);
  EXPECT_GE(steady_seconds() - begun, 0.055);
  EXPECT_LT(steady_seconds() - begun, 0.5);
}

TEST(LineSource, IsTriedAgainUntilItIsBack) {
  Reading reading(true);
  ASSERT_TRUE(reading.source.open());
  reading.pipes.send("0.00 1\n0.01 7");
  EXPECT_TRUE(reading.receive());
  reading.pipes.to.close();
  EXPECT_TRUE(reading.receive());
  ASSERT_EQ(reading.notices.size(), 1u);
  EXPECT_EQ(in_words(reading.notices[0].what), "lab is gone; it is tried again until it is back");
  EXPECT_EQ(reading.notices[0].kind, RemarkKind::connection);
  const double begun = steady_seconds();
  EXPECT_TRUE(reading.receive(0.1));
  EXPECT_GE(steady_seconds() - begun, 0.1);
  EXPECT_EQ(reading.notices.size(), 1u);
  reading.pipes.ready = 1;
  EXPECT_TRUE(reading.receive());
  ASSERT_EQ(reading.notices.size(), 2u);
  EXPECT_THAT(in_words(reading.notices[1].what), MatchesRegex("lab is back after [0-9.]+ s"));
  reading.pipes.send("0.02 2\n");
  EXPECT_TRUE(reading.receive());
  EXPECT_THAT(reading.rows.values, ElementsAre(1, 2));
}

TEST(LineSource, WhatCannotBeOpenedIsAnError) {
  Reading reading(true);
  reading.pipes.ready = 0;
  const auto opened = reading.source.open();
  ASSERT_FALSE(opened);
  EXPECT_EQ(in_words(opened.error()), "not there");
}

TEST(LineSource, ValuesWaitForTheirTimes) {
  Reading reading(false);
  ASSERT_TRUE(reading.source.open());
  reading.pipes.send("1\n2\n3\n");
  EXPECT_TRUE(reading.receive());
  EXPECT_EQ(reading.rows.size(), 0u);
  reading.source.finish(reading.rows, reading.notices);
  EXPECT_THAT(reading.rows.values, ElementsAre(1, 2, 3));
  EXPECT_EQ(reading.source.pace(), 0);
}

TEST(Sources, AreMadeByTheirNames) {
  Server server([](const std::string&) { return Reply{}; });
  LineSettings lines;
  const auto tcp = make_source({SourceKind::tcp, "127.0.0.1", server.port()}, lines);
  ASSERT_TRUE(tcp->open());
  SampleRows rows;
  std::vector<Remark> notices;
  EXPECT_TRUE(tcp->receive(0.01, rows, notices));
  const auto serial = make_source({SourceKind::serial, "/dev/null", 9600}, lines)->open();
  ASSERT_FALSE(serial);
  EXPECT_THAT(in_words(serial.error()), HasSubstr("serial:/dev/null: that is no serial line"));
  const auto phone = make_source({SourceKind::phyphox, "127.0.0.1", 1}, lines)->open();
  ASSERT_FALSE(phone);
  EXPECT_EQ(in_words(phone.error()), "phyphox:127.0.0.1:1: 127.0.0.1:1: Connection refused");
  const auto input = make_source({}, lines);
  EXPECT_TRUE(input->open());
  EXPECT_EQ(input->times().by, TimesBy::nothing);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
