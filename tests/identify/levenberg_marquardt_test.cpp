#include "cromer/identify/least_squares/levenberg_marquardt.h"

#include <gtest/gtest.h>

#include <vector>

namespace cromer::core {
namespace CROMER_FILE {

// y = a exp(-b t): its normal equations, given data.
struct Exponential {
  std::vector<double> t, y;

  NormalEquations operator()(const Parameters& p) const {
    NormalEquations e;
    e.size = 2;
    for (std::size_t i = 0; i < t.size(); ++i) {
      const double f = std::exp(-p[1] * t[i]), r = y[i] - p[0] * f;
      const double j[] = {f, -p[0] * t[i] * f};
      for (int k = 0; k < 2; ++k) {
        e.right[k] += j[k] * r;
        for (int l = 0; l < 2; ++l) e.matrix[k][l] += j[k] * j[l];
      }
      e.sum_of_squares += r * r;
    }
    return e;
  }
};

Exponential decay(double a, double b) {
  Exponential model;
  for (int i = 0; i < 50; ++i) {
    model.t.push_back(0.1 * i);
    model.y.push_back(a * std::exp(-b * 0.1 * i));
  }
  return model;
}

TEST(LevenbergMarquardt, FindsTheMinimumFromFarAway) {
  for (const Parameters& start :
       {Parameters{1, 1}, Parameters{10, 0.01}, Parameters{0.1, 5}, Parameters{-2, 2}}) {
    LeastSquaresOptions options;
    options.residuals = 50;
    options.iteration_limit = 200;
    const LeastSquaresSummary summary = minimise(decay(3, 0.7), start, options);
    EXPECT_EQ(summary.reason, LeastSquaresReason::converged);
    EXPECT_NEAR(summary.parameters[0], 3, 1e-9);
    EXPECT_NEAR(summary.parameters[1], 0.7, 1e-9);
  }
}

TEST(LevenbergMarquardt, StaysWithinItsBoundsAndFindsTheMinimumThere) {
  LeastSquaresOptions options;
  options.residuals = 50;
  options.lower[1] = 0;
  options.error_tolerance = 0;
  const Exponential growing = decay(1, -0.2);
  const LeastSquaresSummary summary = minimise(growing, {1, 0.5}, options);
  EXPECT_EQ(summary.reason, LeastSquaresReason::converged);
  EXPECT_EQ(summary.parameters[1], 0);
  double mean = 0;
  for (double y : growing.y) mean += y / 50;
  EXPECT_NEAR(summary.parameters[0], mean, 1e-9);  // the best constant
}

// A line through points on a steeper one, its slope bounded from below: where the slope stops at its bound,
// the intercept must go where it does best beside that slope. The two are strongly correlated.
TEST(LevenbergMarquardt, LeavesNoParameterBehindThatMeetsItsBound) {
  const auto line = [](const Parameters& p) {
    NormalEquations e;
    e.size = 2;
    for (int i = 0; i < 10; ++i) {
      const double x = 10 + 0.1 * i;
      e.add_row(std::array{1.0, x}, 3 - 2 * x - p[0] - p[1] * x);
    }
    return e;
  };
  LeastSquaresOptions options;
  options.residuals = 10;
  options.lower[1] = 0;
  options.along_bounds = true;
  const LeastSquaresSummary summary = minimise(line, {-18.945, 0.1}, options);
  EXPECT_EQ(summary.reason, LeastSquaresReason::converged);
  EXPECT_EQ(summary.parameters[1], 0);
  EXPECT_NEAR(summary.parameters[0], 3 - 2 * 10.45, 1e-9);
  EXPECT_LE(summary.iterations, 3);
  options.along_bounds = false;
  EXPECT_GT(minimise(line, {-18.945, 0.1}, options).iterations, 3);
}

TEST(LevenbergMarquardt, SaysWhenTheLimitIsReached) {
  LeastSquaresOptions options;
  options.residuals = 50;
  options.iteration_limit = 1;
  EXPECT_EQ(minimise(decay(3, 0.7), {1, 2}, options).reason, LeastSquaresReason::iteration_limit);
}

TEST(LevenbergMarquardt, SaysWhenNothingDependsOnAParameter) {
  const auto flat = [](const Parameters& p) {
    NormalEquations e;
    e.size = 2;
    e.matrix[0][0] = 1;
    e.right[0] = 1 - p[0];
    e.sum_of_squares = (1 - p[0]) * (1 - p[0]);
    return e;
  };
  const LeastSquaresSummary summary = minimise(flat, {0, 0}, {});
  EXPECT_EQ(summary.reason, LeastSquaresReason::singular);
}

TEST(NormalEquations, InverseTimesMatrixIsOne) {
  SquareMatrix matrix{};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      matrix[i][j] = std::pow(10, i + j) * (i == j ? 1 : 0.5);  // parameters of very different units
  const SquareMatrix inverted = inverse(matrix, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      double sum = 0;
      for (int k = 0; k < 4; ++k) sum += matrix[i][k] * inverted[k][j];
      EXPECT_NEAR(sum, i == j, 1e-12 * std::pow(10, std::abs(i - j)));
    }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
