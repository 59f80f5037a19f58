// Notices and refusals for recordings that are no plain free swing, from the bytes of a file on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <random>

#include "cromer/base/concat.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/fit/fit.h"
#include "tests/support/cases.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

struct Sensor {
  double duration = 60, rate = 50, noise = 3e-4, resolution = 0;
  unsigned seed = 1;
};

/// A file of a motion as a sensor with normal noise sees it.
std::string recorded(const Sensor& sensor, const std::function<double(double)>& motion) {
  std::mt19937_64 engine(sensor.seed);
  std::normal_distribution<double> normal(0, sensor.noise);
  std::string text = "Time (s),Position (m)\n";
  for (int i = 0; i < sensor.duration * sensor.rate; ++i) {
    const double t = i / sensor.rate;
    double y = motion(t) + normal(engine);
    if (sensor.resolution > 0) y = sensor.resolution * std::nearbyint(y / sensor.resolution);
    text += concat({shortest(t), ",", shortest(y), "\n"});
  }
  return text;
}

FittedRecording fitted(const std::string& bytes, const FitOptions& options = {}) {
  const auto fits = fit(bytes, "lab.csv", options);
  EXPECT_TRUE(fits.ok()) << in_words(fits.error());
  return fits ? fits->front() : FittedRecording{};
}

/// exp(-g t) cos(w t + phase).
double swing(double t, double w, double g, double phase = 0) {
  return std::exp(-g * t) * std::cos(w * t + phase);
}

std::string driven_at(double w) { return concat({shortest(w), " rad/s"}); }

// A generator that runs down a little looks like a swing with a very high quality factor.
TEST(SaidOfRecordings, AnAmplitudeThatHardlyFallsMayBeADrives) {
  for (const double quality : cases({16000.0, 60000.0}))
    for (const double periods : cases({30.0, 100.0, 300.0})) {
      const double w = 6, fall = periods * std::numbers::pi / quality;
      const auto bytes = recorded({.duration = periods * two_pi / w, .noise = 2e-5},
                                  [&](double t) { return 0.05 * swing(t, w, w / (2 * quality)); });
      EXPECT_THAT(in_words(fitted(bytes).notices),
                  Contains(HasSubstr("If something drives it, the frequency is the drive's")))
          << quality << ' ' << fall;
    }
  // Good swings in air are not doubted.
  for (const double quality : {30.0, 300.0, 1500.0})
    EXPECT_THAT(
        in_words(fitted(recorded({.duration = 60}, [&](double t) { return 0.05 * swing(t, 6, 3 / quality); }))
                     .notices),
        Not(Contains(HasSubstr("drives it"))))
        << quality;
}

TEST(SaidOfRecordings, ASensorThatLosesTheMotionIsNamed) {
  for (unsigned seed = 1; seed <= cases(6u); ++seed)
    for (const double level : {0.0, 0.3, -1.2})
      for (const double spikes : {0.0, 0.05, 0.2}) {
        const double lost = 12 + 3.1 * seed;
        std::mt19937_64 engine(seed);
        std::uniform_real_distribution<double> share(0, 1);
        std::normal_distribution<double> spike(0, 1);
        std::string text = "Time (s),Position (m)\n";
        for (int i = 0; i < 2000; ++i) {
          const double t = 0.02 * i, noise = 3e-4 * spike(engine);
          double y = 0.2 + 0.05 * swing(t, 6, 0.03, seed) + noise;
          if (t > lost) y = 0.2 + level + (share(engine) < spikes ? spike(engine) : 0);
          text += concat({shortest(t), ",", shortest(1e-4 * std::nearbyint(1e4 * y)), "\n"});
        }
        const FittedRecording fit = fitted(text);
        ASSERT_EQ(fit.fit.status, FitStatus::converged) << seed << ' ' << level << ' ' << spikes;
        EXPECT_NEAR(fit.find("angular_frequency")->value, 6, 1e-3);
        EXPECT_NEAR(fit.series.t.back(), lost, 0.06) << seed << ' ' << level << ' ' << spikes;
        EXPECT_THAT(in_words(fit.notices), Contains(HasSubstr("the sensor loses the motion at")));
        EXPECT_THAT(in_words(fit.notices), Not(Contains(HasSubstr("set going"))));
      }
}

TEST(SaidOfRecordings, AMotionThatComesToRestIsNotLost) {
  // Dry friction and an encoder without noise; a swing that dies down into its rounding.
  const double w = 6, shift = 0.002;
  const auto friction = recorded({.noise = 0, .resolution = 1e-4}, [&](double t) {
    const double half = std::floor(w * t / std::numbers::pi), side = std::fmod(half, 2) == 0 ? 1 : -1;
    const double amplitude = 0.05 - (2 * half + 1) * shift;
    const double last = std::floor((0.05 / shift - 1) / 2);
    if (amplitude <= shift) return (std::fmod(last, 2) == 0 ? -1 : 1) * (0.05 - 2 * (last + 1) * shift);
    return side * shift + amplitude * std::cos(w * t);
  });
  EXPECT_THAT(in_words(fitted(friction).notices), Not(Contains(HasSubstr("loses the motion"))));
  for (const double resolution : {1e-4, 1e-3, 5e-3}) {
    const auto damped = recorded({.duration = 80, .noise = 0, .resolution = resolution},
                                 [&](double t) { return 0.2 + 0.05 * swing(t, w, 0.15); });
    EXPECT_THAT(in_words(fitted(damped).notices), Not(Contains(HasSubstr("loses the motion")))) << resolution;
  }
}

// A hand catches it, at rest or aside: the law is that of the swing before.
TEST(SaidOfRecordings, ACaughtSwingIsFittedUntilThen) {
  const double w = 9, g = 0.03;
  for (const double caught : {13.0, 21.3, 36.8})
    for (const bool aside : {false, true})
      for (const unsigned seed : cases({1u, 2u})) {
        const double held = aside ? 0.05 * swing(caught, w, g) : 0;
        const FittedRecording fit =
            fitted(recorded({.duration = 40, .noise = 2e-4, .seed = seed}, [&](double t) {
              return 0.2 + (t < caught
                                ? 0.05 * swing(t, w, g)
                                : held + (0.05 * swing(t, w, g) - held) * std::exp(-(t - caught) / 0.05));
            }));
        ASSERT_TRUE(fit.succeeded()) << caught << aside << seed;
        const Estimate rate = *fit.find("decay_rate");
        EXPECT_NEAR(rate.value, g, 4 * rate.standard_error)
            << caught << aside << seed << to_text(fit.fit.law);
        EXPECT_FALSE(fit.fit.law.has<Friction>() && fit.find("friction")->low > 0);
        EXPECT_LE(fit.series.t.back(), caught);
        EXPECT_GT(fit.series.t.back(), caught - 2.6);  // and the last period is left out, too
        EXPECT_THAT(in_words(fit.notices), Contains(HasSubstr("as when a hand catches it: only what comes")));
      }
}

// A drive that ends leaves a strongly damped swing no time: what is fitted is the driven motion before.
TEST(SaidOfRecordings, ADrivenMotionIsFittedUntilItsDriveEnds) {
  const std::complex<double> own(-1.8, std::sqrt(36 - 1.8 * 1.8)), drive(0, 5);
  const std::complex<double> steady = 0.5 / (drive * drive + 3.6 * drive + 36.0);
  // From rest at the origin: x = Re(steady e^(i 5 t) + rest e^(own t)).
  const double position = -steady.real(), velocity = -(drive * steady).real();
  const std::complex<double> rest(position, (own.real() * position - velocity) / own.imag());
  const auto moved = [&](double t) {
    return (steady * std::exp(drive * t) + rest * std::exp(own * t)).real();
  };
  const double end = 35;
  const auto bytes = recorded({.duration = 50, .noise = 1e-4}, [&](double t) {
    return t < end ? moved(t) : moved(end) * std::exp(-1.8 * (t - end)) * std::cos(own.imag() * (t - end));
  });
  const FittedRecording fit = fitted(bytes);
  ASSERT_TRUE(fit.driven);
  EXPECT_NEAR(fit.find("drive_frequency")->value, 5, 1e-3);
  EXPECT_NEAR(fit.find("decay_rate")->value, 1.8, 0.2);
  EXPECT_LT(fit.series.t.back(), end);
  EXPECT_THAT(in_words(fit.notices), Contains(AllOf(HasSubstr("the motion stops between"),
                                                    HasSubstr("as when its drive ends: only what comes"))));
  EXPECT_THAT(in_words(fit.notices), Not(Contains(HasSubstr("hand"))));
}

// After a pause the swing is weaker: nobody saw it stop.
TEST(SaidOfRecordings, APauseIsNoCatch) {
  std::string bytes = "Time (s),Position (m)\n";
  for (int i = 0; i < 3000; ++i) {
    const double t = 0.02 * i + (i >= 1000 ? 100 : 0);
    bytes += concat({shortest(t), ",", shortest(0.05 * swing(t, 9, 0.03)), "\n"});
  }
  const FittedRecording fit = fitted(bytes);
  EXPECT_THAT(in_words(fit.notices), Not(Contains(HasSubstr("stops between"))));
  EXPECT_NEAR(fit.series.t.back(), 160, 0.03);
}

// What friction stops is no catch, however few swings are left.
TEST(SaidOfRecordings, WhatFrictionStopsWasNotCaught) {
  for (const double swings : {3.0, 5.0, 9.0, 20.0, 40.0}) {
    const double shift = 0.05 / (4 * swings);
    const auto bytes = recorded({.duration = 60, .noise = 1e-4}, [&](double t) {
      const double half = std::floor(6 * t / std::numbers::pi), side = std::fmod(half, 2) == 0 ? 1 : -1;
      const double last = std::floor((0.05 / shift - 1) / 2), amplitude = 0.05 - (2 * half + 1) * shift;
      if (amplitude <= shift) return (std::fmod(last, 2) == 0 ? -1 : 1) * (0.05 - 2 * (last + 1) * shift);
      return side * shift + amplitude * std::cos(6 * t);
    });
    EXPECT_THAT(in_words(fitted(bytes).notices), Not(Contains(HasSubstr("catches it")))) << swings;
  }
}

// Who asks for what comes after as well is told.
TEST(SaidOfRecordings, OfACaughtSwingNoDecayIsKnownWhicheverTheLaw) {
  for (const double caught : {27.0, 25.6})
    for (const unsigned seed : {1u, 2u}) {
      const auto bytes = recorded({.duration = 28, .rate = 36, .noise = 2e-4, .seed = seed}, [&](double t) {
        const double then = std::min(t, caught);
        return 0.2 + 0.05 * swing(then, 9, 0.02) * std::exp(-(t - then) / 0.03);
      });
      const auto said = in_words(fitted(bytes, {.to = 1000}).notices);
      EXPECT_THAT(said, Contains(HasSubstr("as when a hand catches it")));
      EXPECT_THAT(said, Not(Contains(HasSubstr("whichever law is right"))));
    }
}

// A long rest after the stop looks like much work for a nonlinear law. The reason is the stop.
TEST(SaidOfRecordings, ACaughtSwingIsSaidToStopEvenIfNoLawSettles) {
  int unsettled = 0;
  for (const unsigned seed : cases({1u, 2u})) {
    const auto bytes = recorded({.rate = 20, .noise = 5e-4, .seed = seed}, [&](double t) {
      return 0.2 + 0.05 * swing(std::min(t, 20.0), two_pi * 1.1, 0.03) * std::clamp(21 - t, 0.0, 1.0);
    });
    const FittedRecording fit = fitted(bytes, {.to = 1000});
    std::vector<std::string> said = in_words(fit.notices);
    said.push_back(in_words(fit.fit.message));
    const auto stops = AllOf(HasSubstr("the swing stops between"), HasSubstr("end before with --to"));
    EXPECT_THAT(said, Contains(stops)) << seed;
    if (fit.succeeded()) continue;
    ++unsettled;
    EXPECT_THAT(in_words(fit.fit.message), stops) << seed;
    EXPECT_THAT(in_words(fit.notices), Not(Contains(stops)));
  }
  EXPECT_GT(unsettled, 0);
}

TEST(SaidOfRecordings, CoarseRoundingIsCalledThat) {
  for (unsigned seed = 1; seed <= cases(4u); ++seed)
    for (const double size : {0.3, 0.6, 0.8}) {
      const double offset = 0.01 * std::fmod(0.3819660113 * seed, 1.0);
      const FittedRecording fit =
          fitted(recorded({.noise = 1e-3, .resolution = 0.01, .seed = seed},
                          [&](double t) { return offset + 0.01 * size * swing(t, 6, 0.01, seed); }));
      EXPECT_NE(fit.fit.status, FitStatus::clipped) << seed << ' ' << size;
      EXPECT_THAT(in_words(fit.notices), Not(Contains(HasSubstr("out of its range"))));
      if (fit.succeeded())
        EXPECT_THAT(in_words(fit.notices),
                    Contains(AllOf(HasSubstr("take only"), HasSubstr("levels, 0.01 m apart"))));
      else
        EXPECT_THAT(in_words(fit.fit.message), HasSubstr("the resolution is too coarse"))
            << seed << ' ' << size;
    }
}

TEST(SaidOfRecordings, TimesRoundedToHalfTheirSpacingMakeNoGapsAndNoModes) {
  for (const auto& [rate, to] :
       {std::pair{60.0, 0.01}, {70.0, 0.005}, {70.0, 0.01}, {97.3, 0.005}, {30.0, 0.02}}) {
    std::mt19937_64 engine(3);
    std::normal_distribution<double> normal(0, 1e-4);
    std::string text = "Time (s),Position (m)\n";
    for (int i = 0; i < 60 * rate; ++i)
      text += concat({shortest(to * std::nearbyint(i / rate / to)), ",",
                      shortest(0.2 + 0.05 * swing(i / rate, 8, 0.02) + normal(engine)), "\n"});
    const FittedRecording fit = fitted(text);
    EXPECT_THAT(fit.series.gaps, IsEmpty()) << rate << ' ' << to;
    EXPECT_THAT(fit.modes, IsEmpty());
    EXPECT_THAT(in_words(fit.notices), Not(Contains(HasSubstr("mode")))) << rate << ' ' << to;
    EXPECT_LT(fit.fit.residual.rms, 1.1e-4) << rate << ' ' << to;
    EXPECT_NEAR(fit.find("angular_frequency")->value, 8,
                4 * fit.find("angular_frequency")->standard_error + 1e-4);
  }
}

TEST(SaidOfRecordings, HarmonicsAreNoModes) {
  // A sensor that is not linear: sin² makes the second, sin³ the third harmonic.
  int made = 0, named = 0;
  for (const auto& [g, seed] : cases({std::pair{0.005, 1u}, {0.02, 2u}}))
    for (const auto& [second, third] :
         cases({std::pair{0.03, 0.03}, {0.05, 0.0}, {0.0, 0.05}, {0.02, 0.01}})) {
      const FittedRecording fit =
          fitted(recorded({.noise = 1e-4, .seed = seed}, [g = g, second = second, third = third](double t) {
            const double u = swing(t, 6, g);
            return 0.2 + 0.05 * (u + second * u * u + third * u * u * u);
          }));
      EXPECT_THAT(fit.modes, IsEmpty()) << g << ' ' << second << ' ' << third;
      EXPECT_THAT(in_words(fit.notices), Not(Contains(HasSubstr("two modes"))))
          << g << ' ' << second << ' ' << third;
      ASSERT_EQ(fit.fit.status, FitStatus::converged) << g << ' ' << second << ' ' << third;
      ++made;
      // What a law takes up as if it were the motion's leaves nothing to be named.
      constexpr double noise = 1e-4;
      if (fit.fit.residual.rms > 1.1 * noise) {
        ++named;
        EXPECT_THAT(in_words(fit.notices), Contains(HasSubstr("harmonic")))
            << g << ' ' << second << ' ' << third;
      }
    }
  EXPECT_GE(named, made - 1);
}

TEST(SaidOfRecordings, BeatsAreNamed) {
  unsigned seed = 0;
  for (const double part : cases({1.0, 0.5, 0.2}))
    for (const auto& [g, duration] :
         cases({std::pair{0.01, 120.0}, {0.02, 60.0}, {0.003, 240.0}, {0.005, 50.0}})) {
      ++seed;
      const FittedRecording fit =
          fitted(recorded({.duration = duration, .rate = 20, .seed = seed}, [&, g = g](double t) {
            return 0.2 + 0.05 * (swing(t, two_pi * 0.7085, g) + part * swing(t, two_pi * 0.73, g, seed));
          }));
      ASSERT_EQ(fit.modes.size(), 2u) << seed << ' ' << part << ' ' << g << ": " << in_words(fit.fit.message);
      double low = fit.modes[0].angular_frequency.value, high = fit.modes[1].angular_frequency.value;
      if (low > high) std::swap(low, high);
      EXPECT_NEAR(low / two_pi, 0.7085, 5e-4);
      EXPECT_NEAR(high / two_pi, 0.73, 5e-4);
      std::vector<std::string> said = in_words(fit.notices);
      said.push_back(in_words(fit.fit.message));
      EXPECT_THAT(said, Contains(AllOf(HasSubstr("two modes swing here"), HasSubstr("beat every 46"))))
          << seed << ' ' << part << ' ' << g;
    }
}

// Neither line decays: either may be the drive's, and no frequency is the body's for sure.
TEST(SaidOfRecordings, OfTwoReadingsNeitherIsInTheHeadline) {
  const FittedRecording fit = fitted(recorded({.duration = 120, .rate = 20}, [](double t) {
    return 0.05 * std::cos(two_pi * 0.7085 * t) + 0.04 * std::cos(two_pi * 0.8 * t + 1);
  }));
  EXPECT_EQ(fit.fit.status, FitStatus::undetermined) << in_words(fit.fit.message);
  EXPECT_THAT(in_words(fit.fit.message), AllOf(HasSubstr("at 0.708"), HasSubstr("and 0.800")));
  EXPECT_THAT(fit.headline, IsEmpty());
}

// The own swing of a driven body as it dies down.
TEST(SaidOfRecordings, WhatBeatsWithItsDriveIsDriven) {
  unsigned seed = 0;
  for (const double own : cases({0.9, 0.97, 1.06}))
    for (const double part : cases({0.5, 1.0, 2.0})) {
      ++seed;
      const FittedRecording fit = fitted(recorded({.duration = 200, .rate = 20, .seed = seed}, [&](double t) {
        return 0.2 + 0.05 * (swing(t, two_pi, 0) + part * swing(t, two_pi * own, 0.03, seed));
      }));
      ASSERT_TRUE(fit.driven) << seed << ": " << in_words(fit.fit.message);
      const auto near = [&](std::string_view name, double truth) {
        const Estimate* found = fit.find(name);
        ASSERT_TRUE(found) << name;
        EXPECT_NEAR(found->value, truth, 4.5 * found->standard_error) << seed << ' ' << name;
      };
      near("drive_frequency", two_pi);
      near("decay_rate", 0.03);
      near("angular_frequency", std::hypot(two_pi * own, 0.03));
      EXPECT_THAT(in_words(fit.notices), Contains(HasSubstr("beats at first"))) << seed;
    }
}

// One beat alone shows before the own swing has died down; free laws that chase it take all steps there are.
TEST(SaidOfRecordings, WhatBeatsOnceWithItsDriveIsDriven) {
  const double own = 6.308, g = 0.0792;
  const FittedRecording fit = fitted(recorded({.duration = 140, .rate = 25, .noise = 2e-4}, [&](double t) {
    return 0.1 + 0.05 * std::cos(6.0792 * t) + 0.04 * swing(t, own, g, 2);
  }));
  ASSERT_TRUE(fit.driven) << in_words(fit.fit.message);
  EXPECT_NEAR(fit.find("decay_rate")->value, g, 4.5 * fit.find("decay_rate")->standard_error);
}

// One law for two modes of like size would have a frequency that nothing swings at.
TEST(SaidOfRecordings, OfTwoModesNoSingleFrequencyIsGiven) {
  unsigned seed = 0;
  for (const auto& [one, other] : cases({std::pair{0.955, 1.05}, {1.05, 0.955}}))
    for (const double part : {1.0, 0.6, 0.2}) {
      const auto bytes = recorded({.noise = 2e-4, .seed = ++seed}, [&, one = one, other = other](double t) {
        return 0.02 * (swing(t, two_pi * one, 0.02) + part * swing(t, two_pi * other, 0.02, 0.4));
      });
      const FittedRecording fit = fitted(bytes);
      ASSERT_EQ(fit.modes.size(), 2u) << one << ' ' << part;
      EXPECT_NEAR(fit.modes[0].angular_frequency.value / two_pi, part < 1 ? one : std::min(one, other),
                  part < 1 ? 1e-3 : std::abs(one - other) + 1e-3);
      if (part > 0.3) {
        EXPECT_EQ(fit.fit.status, FitStatus::no_oscillation) << one << ' ' << part;
        EXPECT_THAT(in_words(fit.fit.message), HasSubstr("no single swing: two modes swing here"));
        EXPECT_EQ(fit.find("frequency"), nullptr);
        EXPECT_THAT(fit.headline, IsEmpty());
        EXPECT_THAT(fit.simulate, IsEmpty());
        EXPECT_THAT(in_words(fit.notices), Not(Contains(HasSubstr("uncertaint")))) << one << ' ' << part;
      } else {
        // The law is that of the larger, and the other stands beside it.
        EXPECT_EQ(fit.fit.status, FitStatus::converged) << one << ' ' << part;
        EXPECT_NEAR(fit.find("frequency")->value, one, 0.25 * std::abs(one - other)) << one << ' ' << part;
        EXPECT_THAT(in_words(fit.notices), Contains(HasSubstr("two modes swing here")));
      }
    }
}

TEST(SaidOfRecordings, NoiseHasNoModes) {
  for (unsigned seed = 1; seed <= 6; ++seed)
    for (const double correlation : {0.5, 0.95, 0.995}) {
      double noise = 0;
      std::mt19937_64 engine(seed);
      std::normal_distribution<double> normal(0, 1e-3);
      const FittedRecording fit = fitted(
          recorded({.noise = 0}, [&](double) { return noise = correlation * noise + normal(engine); }));
      EXPECT_THAT(fit.modes, IsEmpty()) << seed << ' ' << correlation;
    }
}

TEST(SaidOfRecordings, ASecondSteadyLineHasTwoReadings) {
  for (const auto& [one, other] : cases({std::pair{5.0, 7.0}, {4.3, 6.5}, {5.5, 5.9}}))
    for (const double part : {1.0, 0.3})
      for (const bool first : {true, false}) {
        const double named = first ? one : other, second = first ? other : one;
        const auto bytes = recorded({.noise = 1e-4}, [&, a = one, b = other](double t) {
          return std::cos(a * t) / (36 - a * a) + part * std::cos(b * t + 1) / (36 - b * b);
        });
        const FittedRecording fit = fitted(bytes, {.drive_frequency = driven_at(named)});
        EXPECT_THAT(in_words(fit.notices), Contains(AllOf(HasSubstr("another drive and an undamped body"),
                                                          HasSubstr(shortest(second / two_pi).substr(0, 5)))))
            << named << ' ' << second << ' ' << part;
      }
}

TEST(SaidOfRecordings, ADrivenBodyThatRingsDownHasOneReading) {
  for (unsigned seed = 1; seed <= cases(4u); ++seed) {
    const auto bytes = recorded({.noise = 1e-4, .seed = seed},
                                [](double t) { return 0.05 * std::cos(5 * t) - 0.05 * swing(t, 6, 0.05); });
    EXPECT_THAT(in_words(fitted(bytes, {.drive_frequency = driven_at(5)}).notices),
                Not(Contains(HasSubstr("another drive"))));
  }
}

TEST(SaidOfRecordings, UncertaintiesKeepTheirSecondDigit) {
  const auto bytes = recorded({.duration = 120, .rate = 20}, [](double t) {
    return 0.05 * (swing(t, two_pi * 0.7085, 0.01) + 0.5 * swing(t, two_pi * 0.73, 0.01));
  });
  const FittedRecording fit = fitted(bytes);
  ASSERT_EQ(fit.modes.size(), 2u);
  const Estimate& g = fit.modes[0].decay_rate;
  EXPECT_THAT(in_words(fit.fit.message), HasSubstr(format_quantity({g.value, g.standard_error}, "1/s")));
}

TEST(SaidOfRecordings, UsedAreTheSamplesThatTheFitSaw) {
  const FittedRecording fit = fitted(recorded({.duration = 30}, [](double t) {
    return 0.05 * swing(t, 6, 0.05) + (std::lround(50 * t) % 211 == 200 ? 0.02 : 0);
  }));
  ASSERT_EQ(fit.series.outliers.size(), 7u);
  EXPECT_EQ(fit.samples, 1500u);
  EXPECT_EQ(fit.used(), 1493u);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
