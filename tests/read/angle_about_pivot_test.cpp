// The angle of a point on film.
#include "cromer/read/angle_about_pivot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/recording.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::Contains;
using testing::HasSubstr;

constexpr double radius = 0.84, x0 = 0.3, y0 = 1.1;

struct Points {
  std::vector<double> x, y, angle;
};

/// Points on a swing of so many degrees, each off by noise.
Points swing(double degrees, double noise, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<> normal;
  Points points;
  for (int i = 0; i < 600; ++i) {
    const double angle = degrees * std::numbers::pi / 180 * std::exp(-0.001 * i) * std::cos(0.11 * i);
    points.angle.push_back(angle);
    points.x.push_back(x0 + radius * std::sin(angle) + noise * normal(random));
    points.y.push_back(y0 - radius * std::cos(angle) + noise * normal(random));
  }
  return points;
}

TEST(AngleAboutPivot, ArcAndItsErrorAreThoseOfTheSwing) {
  for (const double degrees : {8.0, 30.0, 80.0}) {
    double squares = 0;
    constexpr unsigned runs = 60;
    for (unsigned seed = 0; seed < runs; ++seed) {
      const Points points = swing(degrees, 3e-4, seed);
      const auto arc = find_arc(points.x, points.y);
      ASSERT_TRUE(arc) << degrees;
      squares += std::pow((arc->radius - radius) / arc->radius_error, 2);
      EXPECT_LT(std::hypot(arc->x - x0, arc->y - y0), 6 * arc->radius_error + 1e-4);
    }
    EXPECT_NEAR(squares / runs, 1, 0.6) << degrees;
  }
}

TEST(AngleAboutPivot, FramesOnSomethingElseAreLeftOut) {
  for (const int frames : {1, 3, 40}) {
    Points points = swing(20, 3e-4);
    for (int i = 0; i < frames; ++i)
      points.x[static_cast<std::size_t>(100 + i)] += 0.15, points.y[static_cast<std::size_t>(100 + i)] += 0.2;
    const auto arc = find_arc(points.x, points.y);
    ASSERT_TRUE(arc) << frames;
    EXPECT_NEAR(arc->radius, radius, 4 * arc->radius_error) << frames;
    EXPECT_LT(arc->radius_error, 0.01 * radius);
  }
  Points points = swing(20, 3e-4);
  for (std::size_t i = 0; i < 200; ++i) points.x[i] += 0.15, points.y[i] += 0.2;
  EXPECT_FALSE(find_arc(points.x, points.y));
}

TEST(AngleAboutPivot, NoiseThatHangsTogetherWidensTheError) {
  double squares = 0;
  constexpr unsigned runs = 40;
  for (unsigned seed = 0; seed < runs; ++seed) {
    Points points = swing(20, 0);
    std::mt19937 random(seed);
    std::normal_distribution<> normal(0, 3e-4);
    double dx = 0, dy = 0;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      dx = 0.5 * dx + normal(random), dy = 0.5 * dy + normal(random);
      points.x[i] += dx, points.y[i] += dy;
    }
    const auto arc = find_arc(points.x, points.y);
    ASSERT_TRUE(arc);
    squares += std::pow((arc->radius - radius) / arc->radius_error, 2) / runs;
  }
  EXPECT_NEAR(squares, 1, 0.5);
}

TEST(AngleAboutPivot, NoArcWhereItsRadiusDoesNotShow) {
  Points points = swing(1, 1e-3);
  EXPECT_FALSE(find_arc(points.x, points.y));
  // A straight line, one place, too few, a cloud.
  for (std::size_t i = 0; i < points.x.size(); ++i) points.y[i] = 2 * points.x[i];
  EXPECT_FALSE(find_arc(points.x, points.y));
  const std::vector<double> same(600, 0.5);
  EXPECT_FALSE(find_arc(same, same));
  points = swing(30, 0);
  EXPECT_FALSE(find_arc(std::span(points.x).first(15), std::span(points.y).first(15)));
  EXPECT_TRUE(find_arc(std::span(points.x).first(60), std::span(points.y).first(60)));
  points = swing(30, 0.3);
  EXPECT_FALSE(find_arc(points.x, points.y));
}

std::string file_of(const Points& points, const std::string& header, double to_y = 1) {
  std::string bytes = header + "\n";
  for (std::size_t i = 0; i < points.x.size(); ++i)
    bytes += shortest(static_cast<double>(i) / 30) + "," + shortest(points.x[i]) + "," +
             shortest(to_y * points.y[i]) + "\n";
  return bytes;
}

TEST(AngleAboutPivot, IsTakenByItsName) {
  const Points points = swing(30, 1e-7);
  for (const auto& [header, to_y] :
       {std::pair("t (s),x (m),y (m)", 1.0), std::pair("t (s),x (m),y (cm)", 100.0),
        std::pair("t (s),x (m),y (m)", -1.0)}) {
    const auto recording = read_recording(file_of(points, header, to_y), "film.csv", {});
    ASSERT_TRUE(recording.ok()) << in_words(recording.error());
    for (const char* name : {"angle(x,y)", "Angle( x , y )", "angle(x,y) (rad)", "angle(x (m),y)"}) {
      const auto series = take_series(*recording, name, 1, {});
      ASSERT_TRUE(series.ok()) << in_words(series.error());
      EXPECT_EQ(series->column, "angle(x,y) (rad)");
      EXPECT_EQ(series->quantity, "angle");
      EXPECT_THAT(in_words(series->notices), Contains(HasSubstr("radius 0.8")));
      // From the middle of the swing, and rising to the right.
      double most = 0;
      const double middle = series->y[0] - points.angle[0];
      for (std::size_t i = 0; i < points.angle.size(); ++i)
        most = std::max(most, std::abs(series->y[i] - middle - points.angle[i]));
      EXPECT_LT(most, 1e-6) << header << name;
    }
    EXPECT_THAT(in_words(take_series(*recording, "angle(x,z)", 1, {}).error()), HasSubstr("\"z\""));
  }
}

TEST(AngleAboutPivot, GoesOnOverTheTop) {
  Points points;
  for (int i = 0; i < 600; ++i) {
    points.angle.push_back(0.05 * i);
    points.x.push_back(std::sin(0.05 * i));
    points.y.push_back(std::cos(0.05 * i));
  }
  const auto recording = read_recording(file_of(points, "t (s),x (m),y (m)"), "film.csv", {});
  const auto series = take_series(*recording, "angle(x,y)", 1, {});
  ASSERT_TRUE(series.ok()) << in_words(series.error());
  EXPECT_NEAR(std::abs(series->y.back() - series->y.front()), 0.05 * 599, 1e-6);
}

TEST(AngleAboutPivot, AStraightLineHasNone) {
  Points points = swing(30, 0);
  points.y = points.x;
  const auto recording = read_recording(file_of(points, "t (s),x (m),y (m)"), "film.csv", {});
  EXPECT_THAT(in_words(take_series(*recording, "angle(x,y)", 1, {}).error()),
              HasSubstr("do not lie on an arc"));
}

TEST(AngleAboutPivot, TheFilesOwnColumnComesFirst) {
  const auto recording =
      read_recording("t (s),\"angle(x,y) (rad)\",x,y\n0,0.1,1,2\n0.1,0.2,1,2\n0.2,0.1,1,2\n", "a.csv", {});
  ASSERT_TRUE(recording.ok());
  for (const char* name : {"angle(x,y)", "angle(x,y) (rad)"})
    EXPECT_EQ(take_series(*recording, name, 1, {})->y, (std::vector<double>{0.1, 0.2, 0.1})) << name;
}

TEST(AngleAboutPivot, IsOfTwoOfOneKindAtTheSameTimes) {
  const Points points = swing(30, 1e-5);
  const auto recording = read_recording(file_of(points, "t (s),x (m),v (m/s)"), "film.csv", {});
  for (const char* name : {"angle(x,v)", "angle(t,t)"})
    EXPECT_THAT(in_words(take_series(*recording, name, 1, {}).error()), HasSubstr("not of one quantity"))
        << name;
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
