#include "cromer/analysis/line.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cromer/model/sensor.h"

namespace cromer::core {
namespace CROMER_FILE {

// Pearson's points with York's weights: the published test of every such line. D. York, Can. J. Phys. 44,
// 1079 (1966); slope and intercept as in B. C. Reed, Am. J. Phys. 57, 642 (1989).
std::vector<UncertainPoint> pearson() {
  const double x[] = {0, 0.9, 1.8, 2.6, 3.3, 4.4, 5.2, 6.1, 6.5, 7.4};
  const double y[] = {5.9, 5.4, 4.4, 4.6, 3.5, 3.7, 2.8, 2.8, 2.4, 1.5};
  const double wx[] = {1000, 1000, 500, 800, 200, 80, 60, 20, 1.8, 1};
  const double wy[] = {1, 1.8, 4, 8, 20, 20, 70, 70, 100, 500};
  std::vector<UncertainPoint> points;
  for (int i = 0; i < 10; ++i) points.push_back({x[i], y[i], 1 / std::sqrt(wx[i]), 1 / std::sqrt(wy[i])});
  return points;
}

TEST(LineWithErrors, MeetsThePublishedLine) {
  auto points = pearson();
  const auto line = fit_line_with_errors(points);
  ASSERT_TRUE(line);
  // Ten points scatter by chi squared 11.866 about it, more than eight: without the extra scatter it is
  // York's.
  EXPECT_NEAR(line->chi_squared, 11.8663531941, 1e-8);
  EXPECT_GT(line->extra_scatter, 0);
  for (auto& point : points) {
    // Twice the errors leave the line where it is, and a quarter of chi squared.
    point.x_error *= 2;
    point.y_error *= 2;
  }
  const auto york = fit_line_with_errors(points);
  EXPECT_NEAR(york->slope, -0.48053340745, 1e-9);
  EXPECT_NEAR(york->intercept, 5.47991022403, 1e-9);
  EXPECT_NEAR(york->slope_error / 2, 0.05799, 6e-6);  // York et al. (2004), table II
  EXPECT_NEAR(york->intercept_error / 2, 0.29497, 6e-6);
  EXPECT_EQ(york->extra_scatter, 0);
  EXPECT_EQ(york->degrees, 8);
}

TEST(LineWithErrors, WithoutErrorsItIsTheOrdinaryLine) {
  const std::vector<UncertainPoint> points{{0, 1, 0, 0}, {1, 3, 0, 0}, {2, 4, 0, 0}, {3, 8, 0, 0}};
  const auto line = fit_line_with_errors(points);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->slope, 2.2, 1e-9);
  EXPECT_NEAR(line->intercept, 0.7, 1e-9);
  // s² = 1.8/2 over Sxx = 5.
  EXPECT_NEAR(line->slope_error, std::sqrt(0.9 / 5), 1e-6);
  EXPECT_NEAR(line->extra_scatter, std::sqrt(0.9), 1e-6);
}

TEST(LineWithErrors, ItsErrorsAreThoseThatRepetitionShows) {
  NormalDeviates normal(7);
  double sum = 0, square = 0, said = 0;
  constexpr int repetitions = 4000;
  for (int i = 0; i < repetitions; ++i) {
    std::vector<UncertainPoint> points;
    for (int j = 0; j < 12; ++j)
      points.push_back({j + 0.1 * normal.next(), 2.0 * j + 1 + 0.3 * normal.next(), 0.1, 0.3});
    const auto line = fit_line_with_errors(points);
    sum += line->slope - 2;
    square += (line->slope - 2) * (line->slope - 2);
    said += line->slope_error * line->slope_error;
  }
  EXPECT_NEAR(sum / repetitions, 0, 4 * std::sqrt(square / repetitions / repetitions));
  // Extra scatter is added in half of the cases and never taken away: of chi squared over its ten degrees of
  // freedom, with a standard deviation of sqrt(2/10), the mean of what exceeds 1 is 0.4 of that.
  EXPECT_NEAR(std::sqrt(said / square), std::sqrt(1 + 0.4 * std::sqrt(0.2)), 0.03);
}

TEST(LineWithErrors, RefusesWhatIsNoLine) {
  EXPECT_FALSE(fit_line_with_errors({{1, 2, 0, 0.1}}));
  EXPECT_FALSE(fit_line_with_errors({{1, 2, 0, 0.1}, {1, 3, 0, 0.1}, {1, 4, 0, 0.1}}));
  EXPECT_FALSE(fit_line_with_errors({{1, 2, 0, 0}, {2, 3, 0, 0}}));
  EXPECT_TRUE(fit_line_with_errors({{1, 2, 0, 0.1}, {2, 3, 0, 0.1}}));
}

TEST(LineWithErrors, OfErrorsInYAloneItIsTheTextbooksWeightedLine) {
  // Sxx = 10, Syy = 9.2, Sxy = 9 about (3, 3.4).
  const double x[] = {1, 2, 3, 4, 5}, y[] = {2, 2, 4, 4, 5}, error = 2;
  std::vector<UncertainPoint> points;
  for (int i = 0; i < 5; ++i) points.push_back({x[i], y[i], 0, error});
  const auto line = fit_line_with_errors(points);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->slope, 0.8, 1e-14);
  EXPECT_NEAR(line->intercept, 1, 1e-14);
  EXPECT_NEAR(line->slope_error, error / std::sqrt(10), 1e-14);
  EXPECT_NEAR(line->intercept_error, error * std::sqrt(1.0 / 5 + 9.0 / 10), 1e-14);
  EXPECT_NEAR(line->covariance, -3 * error * error / 10, 1e-14);
  // Residuals 0.2, -0.6, 0.6, -0.2, 0.
  EXPECT_NEAR(line->chi_squared, 0.8 / 4, 1e-14);
  EXPECT_EQ(line->degrees, 3);
  EXPECT_EQ(line->extra_scatter, 0);
}

TEST(LineWithErrors, OfErrorsInXAloneItIsTheLineOfXOnY) {
  // Sxx = 10, Sxy = 8, Syy = 7.2: x = 1.5 + 10/9 (y - 3.4) + ...
  const double x[] = {1, 2, 3, 4, 5}, y[] = {2, 2, 4, 4, 5}, error = 2;
  std::vector<UncertainPoint> points;
  for (int i = 0; i < 5; ++i) points.push_back({x[i], y[i], error, 0});
  const auto line = fit_line_with_errors(points);
  ASSERT_TRUE(line);
  const double slope = 7.2 / 8;
  EXPECT_NEAR(line->slope, slope, 1e-13);
  EXPECT_NEAR(line->intercept, 3.4 - slope * 3, 1e-13);
  EXPECT_NEAR(line->slope_error, slope * slope * error / std::sqrt(7.2), 1e-13);
  // Sxx - Sxy^2/Syy is left in x.
  EXPECT_NEAR(line->chi_squared, (10 - 64 / 7.2) / 4, 1e-13);
}

TEST(LineWithErrors, WithTheExtraScatterChiSquaredIsWhatIsExpected) {
  auto points = pearson();
  const auto line = fit_line_with_errors(points);
  for (auto& point : points) point.y_error = std::hypot(point.y_error, line->extra_scatter);
  const auto again = fit_line_with_errors(points);
  EXPECT_NEAR(again->chi_squared, 8, 1e-9);
  EXPECT_NEAR(again->slope, line->slope, 1e-9);
  EXPECT_NEAR(again->slope_error, line->slope_error, 1e-9);
  EXPECT_NEAR(again->intercept, line->intercept, 1e-9);
}

TEST(LineWithErrors, OfThreePointsOneDegreeIsLeft) {
  // y = x but for the middle, off by 3: residuals -1, 2, -1.
  const auto scattered = [](double error) {
    return *fit_line_with_errors({{0, 0, 0, error}, {1, 4, 0, error}, {2, 2, 0, error}});
  };
  EXPECT_NEAR(scattered(3).chi_squared, 6.0 / 9, 1e-13);
  EXPECT_EQ(scattered(3).extra_scatter, 0);
  EXPECT_NEAR(scattered(1).extra_scatter, std::sqrt(5), 1e-9);
  EXPECT_EQ(scattered(1).degrees, 1);
}

TEST(LineWithErrors, ScatterOfJustWhatIsExpectedNeedsNoMore) {
  // Six points about y = 0: residuals 1, -1, 0, 0, -1, 1.
  const auto line = fit_line_with_errors(
      {{0, 1, 0, 1}, {1, -1, 0, 1}, {2, 0, 0, 1}, {3, 0, 0, 1}, {4, -1, 0, 1}, {5, 1, 0, 1}});
  ASSERT_TRUE(line);
  EXPECT_EQ(line->chi_squared, 4);
  EXPECT_EQ(line->degrees, 4);
  EXPECT_EQ(line->extra_scatter, 0);
}

TEST(LineWithErrors, PointsWithAndWithoutErrorsMayMix) {
  // Two points that are sure, and one that is not, ten off.
  const auto line = fit_line_with_errors({{0, 1, 0, 0}, {2, 5, 0, 0}, {1, 13, 0, 100}});
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->slope, 2, 1e-3);
  EXPECT_NEAR(line->intercept, 1, 1e-3);
  EXPECT_FALSE(fit_line_with_errors({{1, 2, 0, 0.1}, {2, 3, 0, 0}}));
  EXPECT_TRUE(fit_line_with_errors({{1, 2, 0.1, 0}, {2, 3, 0, 0.1}}));
  EXPECT_FALSE(fit_line_with_errors({}));
}

TEST(LineWithErrors, OfPointsOnALineWithoutErrorsNothingIsLeft) {
  const auto line = fit_line_with_errors({{1, 2, 0, 0}, {2, 4, 0, 0}, {4, 8, 0, 0}});
  ASSERT_TRUE(line);
  EXPECT_EQ(line->slope, 2);
  EXPECT_EQ(line->intercept, 0);
  EXPECT_LT(line->slope_error, 1e-100);
  EXPECT_LT(line->extra_scatter, 1e-100);
}

TEST(FitLine, ThroughPointsOnALine) {
  const std::vector<double> x{1e9, 1e9 + 1, 1e9 + 3}, y{2, 2.5, 3.5};
  EXPECT_NEAR(fit_line(x, y).slope, 0.5, 1e-14);
}

TEST(FitLine, IsThatOfLeastSquares) {
  // About (3, 3.4): Sxx = 10, Sxy = 8.
  const Line line = fit_line(std::vector<double>{1, 2, 3, 4, 5}, std::vector<double>{2, 2, 4, 4, 5});
  EXPECT_NEAR(line.slope, 0.8, 1e-15);
  EXPECT_NEAR(line.intercept, 1, 1e-14);
  const Line two = fit_line(std::vector<double>{-1, 3}, std::vector<double>{5, -3});
  EXPECT_NEAR(two.slope, -2, 1e-15);
  EXPECT_NEAR(two.intercept, 3, 1e-15);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
