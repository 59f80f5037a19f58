#include "cromer/tasks/inspect/take_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "cromer/base/number.h"
#include "cromer/documents/words/words.h"
#include "cromer/model/sensor.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::HasSubstr;

/// A phone that swings by these amplitudes along its axes at 0.8 Hz and 50 samples a second, for 20 s and
/// then, put down, for as long again. At 1 s it is let go: every axis jumps for half a second.
std::string phone(std::array<double, 3> amplitudes, const std::string& header) {
  std::string text = header + "\n";
  for (int i = 0; i < 2000; ++i) {
    const double t = 0.02 * i;
    text += shortest(t);
    double square = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double swing = t > 1.5 && t < 20 ? amplitudes[axis] * std::cos(5.0 * t + axis) : 0;
      const double hand = t > 1 && t < 1.5 ? (axis == 0 ? 6 : 1) * std::sin(40 * t) : 0;
      const double value = (axis == 2 ? 9.8 : 0) + swing + hand + 0.01 * std::sin(1e4 * t * (axis + 1));
      text += "," + shortest(value);
      square += value * value;
    }
    text += "," + shortest(std::sqrt(square)) + "\n";
  }
  return text;
}

constexpr const char* of_phyphox =
    "\"Time (s)\",\"Acceleration x (m/s^2)\",\"Acceleration y (m/s^2)\",\"Acceleration z (m/s^2)\","
    "\"Absolute acceleration (m/s^2)\"";

TEST(Axis, TheLiveliestIsTakenAndSaid) {
  const auto recording = read_recording(phone({0.3, 2, 0.5}, of_phyphox), "phone.csv", {});
  const auto series = take_motion(*recording, "", 1, {});
  ASSERT_TRUE(series.ok()) << in_words(series.error());
  EXPECT_EQ(series->column, "Acceleration y (m/s^2)");
  EXPECT_THAT(in_words(series->notices).front(),
              HasSubstr("\"Acceleration y (m/s^2)\" is taken: it swings most clearly, by 2 m/s²"));
  EXPECT_THAT(in_words(series->notices).front(), HasSubstr("\"Acceleration z (m/s^2)\""));
  const auto named = take_motion(*recording, "Acceleration x", 1, {});
  EXPECT_EQ(named->column, "Acceleration x (m/s^2)");
  EXPECT_EQ(inspect(*recording, {})->column, "Acceleration y (m/s^2)");
}

TEST(Axis, OfTwoThatSwingAlikeNoneIsCalledClearer) {
  const auto recording = read_recording(phone({0.3, 2, 1.9}, of_phyphox), "phone.csv", {});
  const auto series = take_motion(*recording, "", 1, {});
  ASSERT_TRUE(series.ok()) << in_words(series.error());
  const std::string said = in_words(series->notices).front();
  EXPECT_THAT(said, HasSubstr("swings about as far"));
  EXPECT_THAT(said, HasSubstr("\"Acceleration z (m/s^2)\""));
  EXPECT_THAT(said, testing::Not(HasSubstr("most clearly")));
}

// A phone that spins about z sees what does not spin with it come round, in x and in y a quarter turn later.
TEST(Axis, OfAPhoneThatSpinsNeitherAxisHasASwingOfItsOwn) {
  for (const double spin : {4.1, 0.0}) {
    std::string text = "Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s)\n";
    NormalDeviates noise(3);
    for (int i = 0; i < 1500; ++i) {
      const double t = 0.01 * i;
      text += shortest(t) + "," + shortest(2 * std::cos(4.1 * t) + 0.05 * noise.next()) + "," +
              shortest(1.9 * std::sin(4.1 * t) + 0.05 * noise.next()) + "," +
              shortest(spin + 0.3 * std::sin(2 * t) + 0.05 * noise.next()) + "\n";
    }
    const auto series = take_motion(*read_recording(text, "gyro.csv", {}), "", 1, {});
    ASSERT_TRUE(series.ok()) << in_words(series.error());
    EXPECT_EQ(series->column, "Gyroscope x (rad/s)");
    const auto told = testing::Contains(HasSubstr("\"Gyroscope z (rad/s)\" keeps turning at 4.1 rad/s"));
    if (spin > 0)
      EXPECT_THAT(in_words(series->notices), told);
    else
      EXPECT_THAT(in_words(series->notices), testing::Not(told));
  }
}

// Of columns without names the first is taken: another may be the same motion, its velocity, or across it.
TEST(Axis, AColumnThatSwingsAcrossIsSaid) {
  const std::pair<const char*, double> kinds[] = {
      {"again", 0}, {"across", 0.78}, {"rate", 0.5 * std::numbers::pi}};
  for (const auto& [kind, phase] : kinds) {
    std::string text;
    NormalDeviates noise(4);
    for (int i = 0; i < 1200; ++i) {
      const double t = 0.05 * i;
      text += shortest(t) + " " + shortest(0.7 * std::cos(3.8 * t) + 2e-3 * noise.next()) + " " +
              shortest(0.2 * std::cos(3.8 * t + phase) + 2e-3 * noise.next()) + "\n";
    }
    const auto series = take_motion(*read_recording(text, "lab.txt", {}), "", 1, {});
    ASSERT_TRUE(series.ok()) << in_words(series.error());
    const auto told = testing::Contains(HasSubstr("\"column 3\" swings at the same frequency"));
    if (std::string_view(kind) == "across")
      EXPECT_THAT(in_words(series->notices), told);
    else
      EXPECT_THAT(in_words(series->notices), testing::Not(told)) << kind;
  }
}

// The swing dies down, the phone is picked up at the end; x is noisy.
TEST(Axis, AHandAtTheEndIsNoSwing) {
  std::string text = std::string(of_phyphox) + "\n";
  for (int i = 0; i < 1500; ++i) {
    const double t = 0.02 * i, hand = t > 26 ? 4 * std::exp(-std::pow(t - 27, 2)) : 0;
    const double x = 0.3 * std::sin(1e4 * t * t * t) + hand,
                 y = std::exp(-0.2 * t) * std::cos(5 * t) + 0.5 * hand;
    text += shortest(t) + "," + shortest(x) + "," + shortest(y) + "," + shortest(9.8 - 0.6 * hand) + ",9.8\n";
  }
  EXPECT_EQ(take_motion(*read_recording(text, "phone.csv", {}), "", 1, {})->column, "Acceleration y (m/s^2)");
}

TEST(Axis, OfWhateverNamesWithXYAndZ) {
  for (const char* header :
       {"t (s),gFx (g),gFy (g),gFz (g),magnitude (g)",
        "t (s),X acceleration (m/s²),Y acceleration (m/s²),Z acceleration (m/s²),note"}) {
    const auto series =
        take_motion(*read_recording(phone({0.3, 0.4, 2}, header), "phone.csv", {}), "", 1, {});
    ASSERT_TRUE(series.ok()) << in_words(series.error());
    EXPECT_THAT(series->column, testing::AnyOf(HasSubstr("gFz"), HasSubstr("Z acc")));
  }
}

TEST(Axis, OtherColumnsAlikeAreAskedFor) {
  for (const char* header : {"t (s),x (m),y (m),w (m),note", "t (s),left (m),right (m),third (m),note",
                             "t (s),x1 (m),y2 (m),z3 (m),note"}) {
    const auto series = take_motion(*read_recording(phone({1, 2, 3}, header), "two.csv", {}), "", 1, {});
    ASSERT_FALSE(series.ok()) << header;
    EXPECT_THAT(in_words(series.error()), HasSubstr("several columns are alike"));
  }
}

TEST(Axis, WhereNothingSwingsNoneIsChosen) {
  std::string still = "t (s),x (m),y (m),z (m)\n";
  for (int i = 0; i < 100; ++i) still += shortest(0.01 * i) + ",1,2,3\n";
  EXPECT_FALSE(take_motion(*read_recording(still, "still.csv", {}), "", 1, {}).ok());
}

/// x and y of a point on film: of a pendulum of 0.84 m, or on a spring that moves along y.
std::string film(bool of_pendulum, const std::string& header) {
  std::string text = header + "\n";
  for (int i = 0; i < 600; ++i) {
    const double t = i / 30.0, swing = 0.3 * std::exp(-0.03 * t) * std::cos(3.4 * t);
    const double x = of_pendulum ? 0.84 * std::sin(swing) : 0.0003 * std::sin(1e4 * t * t),
                 y = of_pendulum ? -0.84 * std::cos(swing) : swing;
    text += shortest(t) + "\t" + shortest(x) + "\t" + shortest(y) + "\n";
  }
  return text;
}

/// A viscous pendulum let go at `start` [rad], by rk4 in eight steps from sample to sample.
std::vector<double> pendulum_swing(double start, double w, double g, double spacing, int samples) {
  const auto pull = [&](double x, double v) { return -w * w * std::sin(x) - 2 * g * v; };
  const double h = spacing / 8;
  std::vector<double> swing;
  double x = start, v = 0;
  for (int i = 0; i < 8 * samples; ++i) {
    if (i % 8 == 0) swing.push_back(x);
    const double a1 = pull(x, v), a2 = pull(x + h / 2 * v, v + h / 2 * a1),
                 a3 = pull(x + h / 2 * (v + h / 2 * a1), v + h / 2 * a2),
                 a4 = pull(x + h * (v + h / 2 * a2), v + h * a3);
    x += h * v + h * h / 6 * (a1 + a2 + a3);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return swing;
}

TEST(Axis, OfAPendulumOnFilmTheAngleIsTaken) {
  for (const char* header : {"mass A\nt\tx\ty", "t (s)\tx (m)\ty (m)"}) {
    const auto recording = read_recording(film(true, header), "film.txt", {});
    const auto series = take_motion(*recording, "", 1, {});
    ASSERT_TRUE(series.ok()) << in_words(series.error());
    EXPECT_EQ(series->column, "angle(x,y) (rad)");
    EXPECT_THAT(in_words(series->notices).front(), HasSubstr("x and y lie on an arc of radius 0.8"));
    const auto fitted = fit(*recording, {});
    ASSERT_TRUE(fitted.ok()) << in_words(fitted.error());
    EXPECT_NEAR(fitted->front().find("frequency")->value, 3.4 / 6.283185, 1e-4);
    // Also where the law is none of a pendulum; but one without a bend tells no small swings.
    FitOptions other;
    other.law = "viscous+cubic";
    EXPECT_THAT(in_words(fit(*recording, other)->front().notices),
                testing::Contains(HasSubstr("longer than the radius 0.8")));
    other.law = "viscous";
    EXPECT_THAT(in_words(fit(*recording, other)->front().notices),
                testing::Not(testing::Contains(HasSubstr("simple pendulum"))));
    FitOptions of_x;
    of_x.column = "x";
    EXPECT_THAT(in_words(fit(*recording, of_x)->front().notices),
                testing::Contains(HasSubstr("--column \"angle(x,y)\" fits the angle")));
  }
}

// Its frequency tells how long a simple pendulum is, and the film how far the bob is from the pivot.
TEST(Axis, OfAPendulumOnFilmBothLengthsAreCompared) {
  const double w = 3.4, length = 9.80665 / (w * w);
  const std::vector<double> swing = pendulum_swing(0.3, w, 0.03, 1 / 30.0, 600);
  for (const double seen : {1.0, 0.9, 1.1}) {
    std::string text = "t (s)\tx (m)\ty (m)\n";
    NormalDeviates noise(2);
    for (std::size_t i = 0; i < swing.size(); ++i)
      text += shortest(static_cast<double>(i) / 30) + "\t" +
              shortest(seen * length * std::sin(swing[i]) + 2e-4 * noise.next()) + "\t" +
              shortest(-seen * length * std::cos(swing[i]) + 2e-4 * noise.next()) + "\n";
    const auto fitted = fit(*read_recording(text, "film.txt", {}), {});
    ASSERT_TRUE(fitted.ok()) << in_words(fitted.error());
    const Estimate* found = fitted->front().find("pendulum_length");
    ASSERT_NE(found, nullptr);
    EXPECT_NEAR(found->value, length, 5e-4);
    EXPECT_LT(std::abs(found->value - length), 3 * found->standard_error);
    EXPECT_LT(found->low, found->value);
    EXPECT_GT(found->high, found->value);
    const auto told = testing::Contains(
        HasSubstr(seen < 1 ? "11 % longer than the radius 0.76" : "9 % shorter than the radius 0.9"));
    if (seen == 1)
      EXPECT_THAT(in_words(fitted->front().notices),
                  testing::Contains(HasSubstr("which agrees with the arc's radius 0.8")));
    else
      EXPECT_THAT(in_words(fitted->front().notices), told);
  }
}

// Of a swing that hardly bends the law may take a cubic: whether that is a pendulum's is said.
TEST(Axis, TheCubicOfAnAngleStandsBesideThatOfAPendulum) {
  const double w = 3.4;
  for (const bool straight : {false, true}) {
    std::vector<double> swing = pendulum_swing(0.2, w, 0.03, 1 / 30.0, 600);
    if (straight)
      for (std::size_t i = 0; i < swing.size(); ++i) {
        const double t = static_cast<double>(i) / 30;
        swing[i] = 0.2 * std::exp(-0.03 * t) * std::cos(w * t);
      }
    std::string text = "t (s)\tangle (rad)\n";
    NormalDeviates noise(2);
    for (std::size_t i = 0; i < swing.size(); ++i)
      text += shortest(static_cast<double>(i) / 30) + "\t" + shortest(swing[i] + 2e-4 * noise.next()) + "\n";
    FitOptions options;
    options.law = "viscous+cubic";
    const auto fitted = fit(*read_recording(text, "angle.txt", {}), options);
    ASSERT_TRUE(fitted.ok()) << in_words(fitted.error());
    const auto told = testing::Contains(HasSubstr("it may be a pendulum"));
    if (straight)
      EXPECT_THAT(in_words(fitted->front().notices), testing::Not(told));
    else
      EXPECT_THAT(in_words(fitted->front().notices), told);
  }
}

TEST(Axis, OfASpringOnFilmTheLivelierIsTaken) {
  const auto recording = read_recording(film(false, "t (s)\tx (m)\ty (m)"), "film.txt", {});
  const auto series = take_motion(*recording, "", 1, {});
  ASSERT_TRUE(series.ok()) << in_words(series.error());
  EXPECT_EQ(series->column, "y (m)");
  EXPECT_THAT(in_words(series->notices).front(), HasSubstr("it swings most clearly"));
}

// The error of the radius is one of every angle.
TEST(Axis, OnFilmTheIntervalsHoldTheErrorOfTheRadius) {
  for (const double degrees : {8.0, 35.0}) {
    const double start = degrees * std::numbers::pi / 180;
    const std::vector<double> swing = pendulum_swing(start, 3.4, 0.03, 1.0 / 30, 600);
    double of_start = 0, of_frequency = 0;
    constexpr unsigned runs = 24;
    for (unsigned seed = 0; seed < runs; ++seed) {
      std::mt19937 random(seed);
      std::normal_distribution<> noise(0, 1e-3);
      std::string text = "t (s),x (m),y (m)\n";
      for (std::size_t i = 0; i < swing.size(); ++i)
        text += shortest(static_cast<double>(i) / 30) + "," +
                shortest(0.85 * std::sin(swing[i]) + noise(random)) + "," +
                shortest(-0.85 * std::cos(swing[i]) + noise(random)) + "\n";
      const auto fitted = fit(text, "film.csv", {});
      ASSERT_TRUE(fitted.ok()) << in_words(fitted.error());
      EXPECT_TRUE(fitted->front().fit.law.has<Pendulum>()) << to_text(fitted->front().fit.law);
      const LawFit& law = fitted->front().fit;
      // The angle is told from the middle of the swing.
      of_start += std::pow((law.motion.position - start) / law.position().standard_error, 2) / runs;
      of_frequency +=
          std::pow((law.motion.angular_frequency() - 3.4) / law.angular_frequency().standard_error, 2) / runs;
    }
    EXPECT_LT(of_start, 2) << degrees;
    EXPECT_LT(of_frequency, 2) << degrees;
    EXPECT_GT(of_start, 0.3) << degrees;
  }
}

TEST(Axis, OfASpringThatTheCameraBendsTheLivelierIsTaken) {
  std::string text = "t (s),x (m),y (m)\n";
  for (int i = 0; i < 600; ++i) {
    const double t = i / 30.0, y = 0.1 * std::exp(-0.03 * t) * std::cos(6 * t);
    text +=
        shortest(t) + "," + shortest(0.3 * y * y + 1e-4 * std::sin(1e4 * t * t)) + "," + shortest(y) + "\n";
  }
  const auto recording = read_recording(text, "film.csv", {});
  EXPECT_EQ(take_motion(*recording, "", 1, {})->column, "y (m)");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
