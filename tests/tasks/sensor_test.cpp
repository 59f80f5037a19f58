#include "cromer/model/sensor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cromer::core {
namespace CROMER_FILE {

TEST(SplitMix64, GivesThePublishedNumbers) {
  // The sequence of seed 1234567 that implementations in other languages are checked against.
  SplitMix64 generator(1234567);
  EXPECT_EQ(generator.next(), 6457827717110365317u);
  EXPECT_EQ(generator.next(), 3203168211198807973u);
  EXPECT_EQ(generator.next(), 9817491932198370423u);
  EXPECT_EQ(generator.next(), 4593380528125082431u);
  EXPECT_EQ(generator.next(), 16408922859458223821u);
}

TEST(PortableLog, AgreesWithTheLibraryToTwoUnitsInTheLastPlace) {
  EXPECT_EQ(portable_log(1.0), 0.0);
  SplitMix64 generator(3);
  for (int i = 0; i < 10000; ++i) {
    const double x =
        std::ldexp(1.0 + 0.5 * generator.next_signed_unit(), static_cast<int>(generator.next() % 60) - 55);
    const double truth = std::log(x);
    EXPECT_NEAR(portable_log(x), truth, 5e-16 * std::abs(truth)) << x;
  }
}

TEST(SensorReadings, AreFiniteWhateverTheNoise) {
  SensorReadings loud({.noise = 1e308, .resolution = 0, .offset = 1e308, .seed = 1});
  SensorReadings fine({.noise = 1e300, .resolution = 1e-300, .offset = 0, .seed = 1});
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(std::isfinite(loud.next(0)));
    EXPECT_TRUE(std::isfinite(fine.next(0)));
  }
}

TEST(NormalDeviates, HaveTheMomentsOfTheNormalDistribution) {
  NormalDeviates deviates(1);
  constexpr int n = 200000;
  double mean = 0, square = 0, fourth = 0;
  int beyond_two = 0;
  for (int i = 0; i < n; ++i) {
    const double z = deviates.next();
    mean += z / n;
    square += z * z / n;
    fourth += z * z * z * z / n;
    beyond_two += std::abs(z) > 2;
  }
  // Four standard errors each: 1/sqrt n, sqrt(2/n), sqrt(96/n); and the tails that a sum of uniforms would
  // lack.
  EXPECT_NEAR(mean, 0, 4 / std::sqrt(n));
  EXPECT_NEAR(square, 1, 4 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourth, 3, 4 * std::sqrt(96.0 / n));
  EXPECT_NEAR(beyond_two / double(n), 0.0455, 0.0019);
}

TEST(SensorReadings, AreTheSameBitsForTheSameSeedEverywhere) {
  SensorReadings sensor({.noise = 1, .seed = 42});
  // The bits that g++ and clang++ agree on; another platform must too.
  SensorReadings same({.noise = 1, .seed = 42}), other({.noise = 1, .seed = 43});
  bool differs = false;
  for (int i = 0; i < 1000; ++i) {
    const double reading = sensor.next(0);
    EXPECT_EQ(reading, same.next(0));
    differs = differs || reading != other.next(0);
  }
  EXPECT_TRUE(differs);
}

TEST(SensorReadings, WithoutNoiseAreOffsetPlusPosition) {
  SensorReadings sensor({.offset = 0.25});
  EXPECT_EQ(sensor.next(0.5), 0.75);
}

TEST(SensorReadings, AreCleanMultiplesOfTheResolution) {
  SensorReadings sensor({.resolution = 1e-4});
  EXPECT_EQ(sensor.next(0.23614), 0.2361);  // 2361 x 1e-4 is 0.23610000000000003
  EXPECT_EQ(sensor.next(-0.23616), -0.2362);
  EXPECT_EQ(sensor.next(0.00004), 0.0);
}

TEST(SensorReadings, HaveTheNoiseAskedFor) {
  SensorReadings sensor({.noise = 3e-4, .seed = 5});
  double square = 0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double error = sensor.next(0.1) - 0.1;
    square += error * error / n;
  }
  EXPECT_NEAR(std::sqrt(square), 3e-4, 3e-4 * 4 / std::sqrt(2.0 * n));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
