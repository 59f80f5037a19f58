#include "cromer/identify/diagnose/free_part.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "cromer/identify/motion/motion_model.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

// A motion with noise at 50 Hz.
template <class TrueSwing>
SyntheticRecord recorded(double duration, double noise, const TrueSwing& motion) {
  SyntheticRecord record{even_times(static_cast<std::size_t>(duration * 50), 0.02), {}, 0};
  std::mt19937_64 engine(5);
  std::normal_distribution<double> normal(0, noise);
  for (const double t : record.t) record.y.push_back(motion(t) + normal(engine));
  return record;
}

// Amplitude 1 where free, from t on.
double decay(double t, double rate = 0.05) { return t < 0 ? 1 : std::exp(-rate * t); }

// Set going at 6 s by a hand that shakes it until 16 s.
TEST(FreePart, BeginsWhenTheHandShakesNoMore) {
  auto record =
      recorded(120, 0.01, [](double t) { return t < 6 ? 0 : std::sin(0.7 * (t - 6)) * decay(t, 0.02); });
  std::mt19937_64 engine(9);
  std::normal_distribution<double> normal(0, 0.1);
  for (std::size_t i = 0; i < record.t.size(); ++i)
    if (record.t[i] > 6 && record.t[i] < 16) record.y[i] += normal(engine);
  const auto part = find_free_part(record.record());
  ASSERT_TRUE(part.has_value());
  EXPECT_GE(part->from, 15);
  EXPECT_LE(part->from, 22);
}

// A swing of a few steps of the sensor, begun where it turns: neither the level it shows there, which comes
// back, nor a slow change by steps is a hold.
TEST(FreePart, AStepOfTheSensorIsNoHold) {
  for (const double steps : {0.7, 1.2, 2.0, 3.3})
    for (const double phase : {-0.9, -0.5, 0.0, 0.4}) {
      auto record = recorded(
          20, 0, [&](double t) { return std::round(steps * decay(t, 0.003) * std::cos(6.6 * t + phase)); });
      Record coarse = record.record();
      coarse.resolution = 1;
      EXPECT_FALSE(find_free_part(coarse).has_value()) << steps << " " << phase;
    }
}

TEST(FreePart, ADriveThatStops) {
  for (const double rate : {0.02, 0.05, 0.2}) {
    const auto record = recorded(150, 0.01, [&](double t) {
      return (1 - std::exp(-rate * t)) * decay(t - 90, rate) * std::cos(6 * t) + 0.3;
    });
    const auto part = find_free_part(record.record());
    ASSERT_TRUE(part.has_value()) << rate;
    EXPECT_GE(part->from, 89.9) << rate;
    EXPECT_LE(part->from, 93) << rate;
    EXPECT_NE(in_words(part->reason).find("drive"), std::string::npos);
  }
}

TEST(FreePart, ADriveThatStopsShortlyBeforeTheEnd) {
  // What is left at the end: from 90 % to 20 % of the steady swing.
  for (const double left : {0.9, 0.8, 0.7, 0.5, 0.35, 0.2})
    for (const double rate : {0.02, 0.05})
      for (const double noise : {1e-4, 0.01}) {
        const double fall = -std::log(left) / rate, stop = 120;
        if (fall < 10) continue;  // too few periods to tell
        const auto record = recorded(stop + fall, noise, [&](double t) {
          return (t < stop ? 1 - std::exp(-2 * rate * t) : 1 - std::exp(-2 * rate * stop)) *
                     decay(t - stop, rate) * std::cos(6 * t) +
                 0.3;
        });
        const auto part = find_free_part(record.record());
        ASSERT_TRUE(part.has_value()) << left << " " << rate << " " << noise;
        EXPECT_GE(part->from, stop - 0.1) << left << " " << rate << " " << noise;
        EXPECT_LE(part->from, stop + 4) << left << " " << rate << " " << noise;
      }
}

TEST(FreePart, NoFreeDecayOrBeatCutAnywhereIsADriveThatStops) {
  int seen = 0;
  for (const double duration : {20.0, 35.0, 60.0, 90.0, 130.0}) {
    for (const double noise : {1e-4, 0.01, 0.05})
      for (const double rate : {0.001, 0.003, 0.01, 0.02, 0.05}) {
        const auto record =
            recorded(duration, noise, [&](double t) { return decay(t, rate) * std::cos(6 * t); });
        seen += find_free_part(record.record()).has_value();
      }
    for (const TrueSwing& motion :
         {TrueSwing{.angular_frequency = 6, .friction = 0.1, .position = 1},
          TrueSwing{.angular_frequency = 6, .friction = 0.3, .position = 1},
          TrueSwing{.angular_frequency = 6, .decay_rate = 0.01, .drag = 0.03, .position = 1},
          TrueSwing{.angular_frequency = 6, .drag = 0.1, .cubic = -8, .position = 1},
          TrueSwing{.angular_frequency = 4, .decay_rate = 0.01, .position = 2.5, .pendulum = true},
          TrueSwing{.angular_frequency = 6, .decay_rate = 0.004, .friction = 0.05, .position = 1}}) {
      SyntheticRecord record{even_times(static_cast<std::size_t>(duration * 50), 0.02), {}, 0};
      record.y = free_motion(motion, record.t, 5e-3).x;
      seen += find_free_part(record.record()).has_value();
    }
    for (const double beat : {0.02, 0.05, 0.1, 0.2, 0.3})
      for (const double share : {0.05, 0.1, 0.2, 0.3, 0.6, 0.9})
        for (const double phase : {-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0})
          for (const double rate : {0.0, 0.005}) {
            const auto record = recorded(duration, 0.005, [&](double t) {
              return decay(t, rate) * (std::cos(6 * t) + share * std::cos((6 + beat) * t + phase));
            });
            const bool told = find_free_part(record.record()).has_value();
            EXPECT_FALSE(told) << duration << " " << beat << " " << share << " " << phase << " " << rate;
            seen += told;
          }
  }
  EXPECT_EQ(seen, 0);
}

TEST(FreePart, HeldDisplacedAndLetGo) {
  for (const double release : {0.8, 3.0, 20.0}) {
    const auto record = recorded(80, 0.005, [&](double t) {
      return t < release ? 1.0 : decay(t - release) * std::cos(6 * (t - release));
    });
    const auto part = find_free_part(record.record());
    ASSERT_TRUE(part.has_value()) << release;
    EXPECT_NEAR(part->from, release, 0.1);
  }
}

TEST(FreePart, NoiseAndASpikeDoNotLetGo) {
  for (const double noise : {0.02, 0.03, 0.05}) {
    auto record =
        recorded(80, noise, [&](double t) { return t < 3 ? 1.0 : decay(t - 3) * std::cos(6 * (t - 3)); });
    record.y[100] = record.y[101] = 7;  // at 2 s
    const auto part = find_free_part(record.record());
    ASSERT_TRUE(part.has_value()) << noise;
    EXPECT_NEAR(part->from, 3, 0.15) << noise;
  }
}

TEST(FreePart, AtRestAndSetGoing) {
  const auto record = recorded(80, 0.005, [](double t) {
    return t < 5 ? 0 : t < 6 ? 0.5 * (1 - std::cos(pi * (t - 5))) : decay(t - 6) * std::cos(6 * (t - 6));
  });
  const auto part = find_free_part(record.record());
  ASSERT_TRUE(part.has_value());
  EXPECT_GE(part->from, 6);
  EXPECT_LE(part->from, 7);
}

TEST(FreePart, NoneWhereItIsFreeFromTheStart) {
  for (const double noise : {1e-4, 0.02, 0.1})
    for (const double phase : {0.0, 0.7, pi / 2, pi})
      for (const double rate : {0.0, 0.002, 0.01, 0.05, 0.3}) {
        const auto record =
            recorded(120, noise, [&](double t) { return decay(t, rate) * std::cos(6 * t + phase); });
        EXPECT_FALSE(find_free_part(record.record()).has_value()) << noise << " " << phase << " " << rate;
      }
  // Friction, drag, and all the frequency does in a large swing.
  const TrueSwing motions[] = {
      {.angular_frequency = 6, .friction = 0.3, .position = 1},
      {.angular_frequency = 6, .friction = 0.3, .position = -1, .velocity = 1},
      {.angular_frequency = 6, .drag = 0.1, .position = 1},
      {.angular_frequency = 4, .decay_rate = 0.03, .position = 2.5, .pendulum = true}};
  for (const TrueSwing& motion : motions) {
    SyntheticRecord record{even_times(6000, 0.02), {}, 0};
    record.y = free_motion(motion, record.t, 5e-3).x;
    EXPECT_FALSE(find_free_part(record.record()).has_value());
  }
}

TEST(FreePart, BeatsAreNotADriveThatStops) {
  for (const double beat : {0.05, 0.1, 0.3})
    for (const double share : {0.3, 0.8, 1.0})
      for (const double phase : {0.0, 1.5, 3.0}) {
        const auto record = recorded(100, 0.01, [&](double t) {
          return decay(t, 0.005) * (std::cos(6 * t) + share * std::cos((6 + beat) * t + phase));
        });
        EXPECT_FALSE(find_free_part(record.record()).has_value()) << beat << " " << share << " " << phase;
      }
}

TEST(LostMotion, OneThatFreezesOrJumpsAway) {
  for (const double lost : {20.0, 20.4, 20.9, 33.0})
    for (const double level : {-2.0, 0.3, 0.9, 5.0}) {
      auto record = recorded(60, 0.003, [&](double t) { return decay(t) * std::cos(6 * t); });
      const auto first = static_cast<std::size_t>(lost * 50);
      const double frozen = record.y[first - 1];
      for (const double value : {level, frozen}) {
        for (std::size_t i = first; i < record.y.size(); ++i) record.y[i] = value;
        const auto found = find_lost_motion(record.record());
        ASSERT_TRUE(found.has_value()) << lost << ' ' << value;
        EXPECT_NEAR(static_cast<double>(found->seen), static_cast<double>(first), 1.5);
        EXPECT_EQ(found->value, value);
        EXPECT_GT(found->share, 0.99);
      }
    }
}

TEST(LostMotion, NoneWhereItIsSeenToTheEnd) {
  for (const double noise : {0.0, 0.003})
    for (const double rate : {0.02, 0.3}) {
      auto record = recorded(60, noise, [&](double t) { return decay(t, rate) * std::cos(6 * t); });
      EXPECT_FALSE(find_lost_motion(record.record())) << noise << ' ' << rate;
      for (const double resolution : {0.001, 0.1, 1.0}) {
        for (double& y : record.y) y = resolution * std::round(y / resolution);
        record.resolution = resolution;
        EXPECT_FALSE(find_lost_motion(record.record())) << noise << ' ' << rate << ' ' << resolution;
      }
    }
}

// A kink in an amplitude, on curves that have one at a known place.

struct Curve {
  std::vector<double> t, amplitude;

  std::optional<Kink> kink() const { return find_kink(t, amplitude); }
};

/// So many amplitudes, whose logarithm grows by `before` and from the one at `place` on falls, more slowly
/// with time.
Curve bent(std::size_t n, std::size_t place, double before, double from = 0, double step = 1) {
  Curve curve;
  for (std::size_t i = 0; i < n; ++i) {
    const double s = static_cast<double>(i) - static_cast<double>(place);
    curve.t.push_back(from + step * static_cast<double>(i));
    curve.amplitude.push_back(0.3 * std::exp(s < 0 ? before * s : -0.1 * s + 0.001 * s * s));
  }
  return curve;
}

TEST(Kink, StandsAtItsPlace) {
  for (const std::size_t place : {8u, 9u, 20u, 31u, 32u})
    for (const double before : {0.0, 0.01, -0.01, 0.05}) {
      const auto kink = bent(40, place, before).kink();
      ASSERT_TRUE(kink) << place << ' ' << before;
      EXPECT_NEAR(kink->t, static_cast<double>(place), 1e-9) << before;
      EXPECT_NEAR(kink->before, before, 1e-9) << place;
      EXPECT_NEAR(kink->after, -0.1, 1e-9) << place;
    }
}

TEST(Kink, AtTimesOfItsOwn) {
  const auto kink = bent(50, 30, 0.02, 100, 0.25).kink();
  ASSERT_TRUE(kink);
  EXPECT_NEAR(kink->t, 107.5, 1e-9);
  EXPECT_NEAR(kink->before, 0.08, 1e-9);
  EXPECT_NEAR(kink->after, -0.4, 1e-9);
}

TEST(Kink, HasEightOnEachSide) {
  ASSERT_TRUE(bent(16, 8, 0).kink());
  EXPECT_NEAR(bent(16, 8, 0).kink()->t, 8, 1e-9);
  EXPECT_FALSE(bent(15, 8, 0).kink());
  EXPECT_FALSE(bent(15, 7, 0).kink());
  EXPECT_FALSE(Curve{}.kink());
}

// A polynomial of the fourth degree and two sinusoids that beat account for these as well.
TEST(Kink, IsNoneInASmoothCurve) {
  for (const double rate : {0.0, 0.02, 0.1}) {
    Curve curve;
    for (int i = 0; i < 60; ++i) {
      const double s = i / 30.0 - 1;
      curve.t.push_back(i);
      curve.amplitude.push_back(
          std::exp(-rate * i + 0.5 * s - s * s + 0.3 * s * s * s - 0.4 * s * s * s * s));
    }
    EXPECT_FALSE(curve.kink()) << rate;
  }
}

TEST(Kink, IsNoneInABeat) {
  for (const double share : {0.3, 0.8, 0.97})
    for (const double turn : {0.7, 1.5, 3.0, 6.0, 12.0})
      for (const double rate : {0.0, 1.2}) {
        Curve beat;
        for (int i = 0; i < 60; ++i) {
          const double s = 2 * i / 59.0 - 1;
          beat.t.push_back(i);
          beat.amplitude.push_back(
              std::sqrt(std::exp(-rate * s) * (1 + share * share + 2 * share * std::cos(turn * s + 1))));
        }
        EXPECT_FALSE(beat.kink()) << share << ' ' << turn << ' ' << rate;
      }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
