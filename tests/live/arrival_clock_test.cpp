// Arrivals that are simulated; the times of sending are known.
#include "cromer/live/arrival_clock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "arrivals.h"
#include "cromer/documents/words/words.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double no_time = 2e-6;  // [s] the stamps are rounded to the microsecond

std::vector<std::string> texts(const Stamped& stamped) {
  std::vector<std::string> all;
  for (const auto& each : stamped.notices) all.push_back(in_words(each.what));
  return all;
}

/// Every sample has a time, these begin at 0 and rise, and none was held back for longer than it may be.
void expect_good_order(const Stamped& stamped, const Sent& sent) {
  ASSERT_EQ(stamped.times.size(), sent.size());
  EXPECT_EQ(stamped.times.front(), 0);
  for (std::size_t i = 1; i < sent.size(); ++i) ASSERT_GT(stamped.times[i], stamped.times[i - 1]) << i;
  EXPECT_LE(stamped.longest_held, ArrivalClock::first_hold + 0.05 + no_time);
  EXPECT_LE(stamped.longest_held_later, ArrivalClock::hold + 0.05 + no_time);
}

class Rates : public ::testing::TestWithParam<double> {
 protected:
  Sent sent_with(const Delay& delay) const {
    Sent sent;
    send(sent, GetParam(), static_cast<int>(60 * GetParam()), delay);
    return sent;
  }
};

TEST_P(Rates, AreExactWhereNothingIsDelayed) {
  const Sent sent = sent_with([](double) { return 0.02; });
  const Stamped stamped = stamp(sent);
  expect_good_order(stamped, sent);
  EXPECT_LT(worst_error(stamped.times, sent), no_time);
  EXPECT_NEAR(stamped.by.rate, GetParam(), 1e-9 * GetParam());
  EXPECT_THAT(texts(stamped), IsEmpty());
}

TEST_P(Rates, AreFoundBelowExponentialDelays) {
  const Sent sent = sent_with(exponential(1e-3));
  const Stamped stamped = stamp(sent);
  expect_good_order(stamped, sent);
  EXPECT_GT(worst_error(sent.arrival, sent), 5e-3);
  EXPECT_LT(worst_error(stamped.times, sent), 1e-3);
  EXPECT_NEAR(stamped.by.rate, GetParam(), 1e-5 * GetParam());
  EXPECT_THAT(texts(stamped), IsEmpty());
}

TEST_P(Rates, AreFoundWhereAllIsHeldUpForTenthsOfASecond) {
  const Sent sent = sent_with(held_up());
  const Stamped stamped = stamp(sent);
  expect_good_order(stamped, sent);
  EXPECT_GT(worst_error(sent.arrival, sent), 0.2);
  EXPECT_LT(worst_error(stamped.times, sent), 1e-3);
  EXPECT_GT(stamped.by.longest_delay, 0.2);
  EXPECT_EQ(stamped.by.by, TimesBy::rate);
  EXPECT_THAT(texts(stamped), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(OfSamples, Rates, ::testing::Values(100.02, 1000.3));

// The first samples wait longer where that is needed to find the rate.
TEST(ArrivalClock, IsNotMisledByAHoldUpAtTheBegin) {
  for (const double length : {0.1, 0.3, 0.45}) {
    for (const double begin : {0.0, 0.2, 0.35}) {
      Sent sent;
      send(sent, 100.02, 1000, [&](double t) {
        const double u = t - 1000.123;
        return u >= begin && u < begin + length ? begin + length - u : 1e-5;
      });
      const Stamped stamped = stamp(sent);
      expect_good_order(stamped, sent);
      EXPECT_LT(worst_error(stamped.times, sent), 1e-3) << length << " at " << begin;
    }
  }
}

TEST(ArrivalClock, SeesThroughBundles) {
  for (const double rate : {101.7, 1000.3}) {
    Sent sent;
    send(sent, rate, static_cast<int>(60 * rate), bundles(0.016));
    const Stamped stamped = stamp(sent);
    expect_good_order(stamped, sent);
    EXPECT_GT(worst_error(sent.arrival, sent), 7e-3);
    EXPECT_LT(worst_error(stamped.times, sent, sent.size() / 10), 1e-3) << rate;
    EXPECT_LT(worst_error(stamped.times, sent), 2e-3) << rate;
  }
}

TEST(ArrivalClock, FollowsARateThatDrifts) {
  // 1e-4 and 1e-2 of it in a minute, slower and faster.
  for (const double drift : {1e-4, 1e-2, -1e-2}) {
    Sent sent;
    Delay delay = exponential(2e-4);
    for (int i = 0; i < 6000; ++i) {
      const double u = i / 100.0, t = 1000 + u * (1 + drift * u / 120);
      sent.add(t, delay(t));
    }
    const Stamped stamped = stamp(sent);
    expect_good_order(stamped, sent);
    EXPECT_LT(worst_error(stamped.times, sent), 1e-3) << drift;
    EXPECT_GT(stamped.by.by_rate, 5900u);
  }
}

TEST(ArrivalClock, KeepsTheArrivalsOfASensorWhoseIntervalDependsOnTheDistance) {
  Sent sent;
  Delay delay = exponential(5e-5);
  for (double t = 1000; t < 1060; t += 0.01 * (1 + 0.03 * std::sin(2 * M_PI * t))) sent.add(t, delay(t));
  const Stamped stamped = stamp(sent);
  expect_good_order(stamped, sent);
  EXPECT_EQ(stamped.by.by, TimesBy::arrival);
  const std::size_t settled = sent.size() / 30;
  EXPECT_LT(worst_error(stamped.times, sent, settled), 1e-3);
  for (std::size_t i = settled; i < sent.size(); ++i)
    ASSERT_NEAR(stamped.times[i] - stamped.times[settled], sent.arrival[i] - sent.arrival[settled], no_time);
}

TEST(ArrivalClock, KeepsTheArrivalsOfARandomSource) {
  Sent sent;
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> interval(0.1, 0.3);
  for (double t = 1000; t < 1120; t += interval(engine)) sent.add(t, 0);
  const Stamped stamped = stamp(sent);
  expect_good_order(stamped, sent);
  EXPECT_EQ(stamped.by.by_rate, 0u);
  EXPECT_LT(worst_error(stamped.times, sent), no_time);
  EXPECT_THAT(in_words(sentence(stamped.by)), HasSubstr("those of arrival; no steady rate was found"));
}

TEST(ArrivalClock, NoticesASampleThatIsMissing) {
  for (const Delay& delay : {exponential(2e-4), bundles(0.016), held_up()}) {
    Sent all, sent;
    send(all, 101.7, 3000, delay);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (i != 1500) sent.add(all.sent[i], all.arrival[i] - all.sent[i]);
    const Stamped stamped = stamp(sent);
    expect_good_order(stamped, sent);
    // Where all is held up just then, it may take one sample more to see it.
    for (std::size_t i = 0; i < sent.size(); ++i)
      if (i < 1500 || i > 1502) {
        ASSERT_NEAR(stamped.times[i] - stamped.times[2000], sent.sent[i] - sent.sent[2000], 2e-3) << i;
      }
    ASSERT_EQ(stamped.notices.size(), 1u);
    EXPECT_EQ(stamped.notices[0].kind, RemarkKind::gap);
    EXPECT_THAT(in_words(stamped.notices[0].what), HasSubstr("1 sample is missing after 14.7"));
  }
}

TEST(ArrivalClock, GoesOnBehindAPause) {
  Sent sent;
  Delay delay = exponential(2e-4);
  send(sent, 100.02, 2000, delay);
  for (const double pause : {0.3333, 7.12345}) {
    const double end = sent.sent.back();
    for (int i = 1; i <= 2000; ++i) sent.add(end + pause + i / 100.02, delay(0));
  }
  const Stamped stamped = stamp(sent);
  expect_good_order(stamped, sent);
  EXPECT_LT(worst_error(stamped.times, sent), 1e-3);
  EXPECT_THAT(texts(stamped), ElementsAre(HasSubstr("paused for 0.333 s after 19.986"),
                                          HasSubstr("nothing for 7.13 s from 40.3")));
}

TEST(ArrivalClock, TellsThatTheRateIsAnother) {
  Sent sent;
  Delay delay = exponential(2e-4);
  send(sent, 100, 2000, delay);
  send(sent, 99, 2000, delay);
  send(sent, 200, 4000, delay);
  const Stamped stamped = stamp(sent);
  expect_good_order(stamped, sent);
  EXPECT_LT(worst_error(stamped.times, sent), 2e-3);  // by arrival for two seconds, twice
  EXPECT_NEAR(stamped.by.rate, 200, 1e-3);
  EXPECT_THAT(texts(stamped),
              ElementsAre(HasSubstr("no steady rate from 20.0"), HasSubstr("a steady rate of "),
                          HasSubstr("no steady rate from"), HasSubstr("a steady rate of 200")));
  EXPECT_LT(stamped.by.by_arrival, 700u);
}

TEST(ArrivalClock, AFilePipedInAtOnceHasNoRate) {
  Sent sent;
  for (int i = 0; i < 50000; ++i) sent.add(1000 + 1e-3 * (i / 5000), 0);
  const Stamped stamped = stamp(sent);
  expect_good_order(stamped, sent);
  EXPECT_EQ(stamped.by.by_rate, 0u);
  EXPECT_LT(stamped.times.back(), 1);
}

// The computer sleeps, or the program was stopped: what had been sent meanwhile comes at once.
TEST(ArrivalClock, CatchesUpAfterALongHoldUp) {
  Sent sent;
  send(sent, 100.02, 4000, [](double t) { return t > 1020 && t < 1023 ? 1023 - t : 1e-5; });
  const Stamped stamped = stamp(sent);
  expect_good_order(stamped, sent);
  EXPECT_LT(worst_error(stamped.times, sent), 1e-3);
  EXPECT_NEAR(stamped.by.longest_delay, 3, 0.02);
  EXPECT_THAT(texts(stamped), IsEmpty());
}

// What was sent while the computer was busy comes in portions, as much as a terminal's buffer holds.
TEST(ArrivalClock, CatchesUpSlowly) {
  Sent sent;
  send(sent, 1000.3, 40000, [](double t) {
    if (t < 1020) return 1e-5;
    return std::max(1e-5, 1022 + 0.05 * std::floor((t - 1020) / 0.4) - t);
  });
  const Stamped stamped = stamp(sent);
  expect_good_order(stamped, sent);
  EXPECT_LT(worst_error(stamped.times, sent), 1e-3);
  EXPECT_THAT(texts(stamped), IsEmpty());
}

TEST(ArrivalClock, SaysWhatItDid) {
  EXPECT_EQ(in_words(sentence({TimesBy::rate, 5988, 12, 100.02, 0.213})),
            "times: by the steady rate that was found, 100.02/s; delays up to 0.21 s; 12 of 6000 by arrival");
  EXPECT_EQ(in_words(sentence({TimesBy::device})), "");
  EXPECT_EQ(in_words(sentence({})), "");
}

TEST(ArrivalClock, HoldsSamplesForFourTenthsOfASecond) {
  ArrivalClock clock;
  std::vector<double> times;
  std::vector<Remark> notices;
  for (int i = 0; i <= 200; ++i) clock.take(100 + i / 100.0);
  clock.release(102, times, notices);
  EXPECT_EQ(times.size(), 161u);
  EXPECT_EQ(clock.held(), 40u);
  clock.release(102.0049, times, notices);
  EXPECT_EQ(times.size(), 161u);
  clock.release(102.0151, times, notices);
  EXPECT_EQ(times.size(), 162u);
  clock.release_all(times, notices);
  EXPECT_EQ(times.size(), 201u);
  EXPECT_EQ(clock.held(), 0u);
  EXPECT_NEAR(times.back(), 2, 1e-6);
  EXPECT_EQ(clock.sample_times().by_rate, 201u);
}

TEST(ArrivalClock, TheFirstWaitForARate) {
  ArrivalClock clock;
  std::vector<double> times;
  std::vector<Remark> notices;
  for (int i = 0; i < 10; ++i) clock.take(100 + 0.01 * i);
  clock.release(100.79, times, notices);
  EXPECT_EQ(times.size(), 0u);
  clock.release(100.801, times, notices);
  EXPECT_EQ(times.size(), 10u);
  EXPECT_EQ(clock.sample_times().by, TimesBy::arrival);
  EXPECT_EQ(ArrivalClock().sample_times().by, TimesBy::nothing);
}

/// Arrivals of which no rate is found, a tenth of a second apart, with a pause.
std::vector<std::string> with_pause(double pause, int before = 30) {
  Sent sent;
  double t = 1000;
  for (int i = 0; i < 60; ++i, t += i == before ? pause : 0.1 + 0.03 * ((7 * i) % 5 - 2)) sent.add(t, 0);
  return texts(stamp(sent));
}

TEST(ArrivalClock, HalfASecondAndFiveStepsAreAPause) {
  EXPECT_THAT(with_pause(0.45), IsEmpty());
  EXPECT_THAT(with_pause(0.62), ElementsAre(HasSubstr("nothing for 0.62 s from ")));
  EXPECT_THAT(with_pause(0.62, 1), ::testing::Each(::testing::Not(HasSubstr("nothing for"))));
}

// A pause of a whole number of periods is of samples that are missing, any other is one of the device.
TEST(ArrivalClock, APauseIsOfWholePeriodsOrOfTheDevice) {
  const auto said = [](double periods) {
    Sent sent;
    for (int i = 0; i < 400; ++i) sent.add(1000 + 0.05 * (i + (i < 200 ? 0 : periods)), 0);
    std::vector<std::string> all = texts(stamp(sent));
    EXPECT_EQ(all.at(0), "a steady rate of 20/s from 1.95 s on: the times follow it");
    all.erase(all.begin());
    return all;
  };
  EXPECT_THAT(said(1), ElementsAre("1 sample is missing after 9.95 s"));
  EXPECT_THAT(said(2), ElementsAre("2 samples are missing after 9.95 s"));
  EXPECT_THAT(said(1.1), ElementsAre("the device paused for 0.055 s after 9.95 s"));
  EXPECT_THAT(said(1.4), ElementsAre("the device paused for 0.07 s after 9.95 s"));
  EXPECT_THAT(said(0.7), IsEmpty());
  EXPECT_THAT(said(0.8), ElementsAre("the device paused for 0.04 s after 9.95 s"));
}

TEST(ArrivalClock, SaysHowManyByTheRate) {
  EXPECT_EQ(in_words(sentence({TimesBy::arrival, 3, 7, 100, 0.2})),
            "times: those of arrival; no steady rate was found for long; 3 of 10 samples follow one");
  EXPECT_EQ(in_words(sentence({TimesBy::arrival, 0, 7})),
            "times: those of arrival; no steady rate was found");
  EXPECT_EQ(in_words(sentence({TimesBy::rate, 7, 0, 100, 0.2})),
            "times: by the steady rate that was found, 100/s; delays up to 0.2 s");
  EXPECT_EQ(in_words(sentence({TimesBy::count})), "times: counted, at the rate of --rate");
  EXPECT_EQ(name(TimesBy::device), "device");
  EXPECT_EQ(name(TimesBy::count), "count");
  EXPECT_EQ(name(TimesBy::rate), "rate");
  EXPECT_EQ(name(TimesBy::arrival), "arrival");
  EXPECT_EQ(name(TimesBy::nothing), "");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
