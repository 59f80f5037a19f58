// The noise of a force, beside dense matrices.
#include "cromer/identify/least_squares/force_noise.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "cromer/identify/least_squares/normal_equations.h"

namespace cromer::core {
namespace CROMER_FILE {

using Eigen::MatrixXd, Eigen::VectorXd;

// A turn of 0.4 rad and a decay of 2 % from step to step.
AnswerToForce answer(double directly) {
  const double c = 0.98 * std::cos(0.4), s = 0.98 * std::sin(0.4);
  return {.transition = {{{c, s}, {-s, c}}}, .entry = {0.3, 0.8}, .sight = {1, -0.2}, .directly = directly};
}

// What each place of the grid sees of a force at each.
MatrixXd answers(const AnswerToForce& of, const SampleGrid& grid, std::size_t samples) {
  const auto places = static_cast<Eigen::Index>(grid.at(samples - 1) + 1);
  MatrixXd all = MatrixXd::Zero(places, places);
  for (Eigen::Index force = 0; force < places; ++force) {
    double x = of.entry[0], v = of.entry[1];
    all(force, force) = of.directly;
    for (Eigen::Index place = force + 1; place < places; ++place) {
      all(place, force) = of.sight[0] * x + of.sight[1] * v;
      const double next = of.transition[0][0] * x + of.transition[0][1] * v;
      v = of.transition[1][0] * x + of.transition[1][1] * v;
      x = next;
    }
  }
  MatrixXd seen(static_cast<Eigen::Index>(samples), places);
  for (std::size_t i = 0; i < samples; ++i)
    seen.row(static_cast<Eigen::Index>(i)) = all.row(static_cast<Eigen::Index>(grid.at(i)));
  return seen;
}

TEST(ForceNoise, IsThatOfTheDenseLikelihood) {
  for (const double directly : {0.0, 0.7})
    for (const bool gap : {false, true}) {
      constexpr std::size_t n = 80;
      constexpr int size = 3;
      SampleGrid grid;
      if (gap)
        for (std::size_t i = 0; i < n; ++i) grid.place.push_back(i + (i < 30 ? 0 : 7));
      const AnswerToForce of = answer(directly);
      const MatrixXd H = answers(of, grid, n);
      std::mt19937_64 engine(3);
      std::normal_distribution<double> normal;
      VectorXd u(H.cols()), r(n);
      for (double& each : u) each = 0.5 * normal(engine);
      for (double& each : r) each = 0.1 * normal(engine);
      r += H * u;
      MatrixXd J(n, size);
      for (Eigen::Index i = 0; i < J.rows(); ++i)
        J.row(i) << 1, std::cos(0.4 * static_cast<double>(i)), std::sin(0.3 * static_cast<double>(i));
      const MatrixXd inverse = (J.transpose() * J).inverse();
      r -= J * (inverse * (J.transpose() * r));

      // Deviance and a of a rho.
      const auto likelihood = [&](double rho) {
        const MatrixXd C = MatrixXd::Identity(n, n) + rho * H * H.transpose();
        const Eigen::LLT<MatrixXd> factor(C);
        const MatrixXd W = factor.matrixL().solve(J);
        const VectorXd w = factor.matrixL().solve(r);
        const MatrixXd K = W.transpose() * W;
        const double rest = w.squaredNorm() - w.dot(W * K.inverse() * (W.transpose() * w)), left = n - size;
        const double determinant = 2 * factor.matrixLLT().diagonal().array().log().sum();
        return std::pair(determinant + std::log(K.determinant()) + left * std::log(rest / left), rest / left);
      };
      double best = 0, least = HUGE_VAL;
      for (double log_rho = -10; log_rho < 15; log_rho += 0.02)
        if (const double here = likelihood(std::exp(log_rho)).first; here < least)
          least = here, best = log_rho;

      std::vector<double> rows;
      SquareMatrix inverse_matrix{};
      for (Eigen::Index i = 0; i < J.rows(); ++i)
        for (int a = 0; a < size; ++a) rows.push_back(J(i, a));
      for (int a = 0; a < size; ++a)
        for (int b = 0; b < size; ++b) inverse_matrix[a][b] = inverse(a, b);
      const std::vector<double> residuals(r.data(), r.data() + n);
      const auto found = find_force_noise(grid, residuals, rows, size, inverse_matrix, of, HUGE_VAL);
      ASSERT_TRUE(found);
      ASSERT_TRUE(found->shows);
      const double a = likelihood(std::exp(best)).second;
      EXPECT_NEAR(std::log(found->deviation / std::sqrt(a * std::exp(best))), 0, 0.1);
      // The inverse of each variance, over all rho, those with the same deviation of the force being alike
      // likely.
      const MatrixXd effect = J * inverse;
      VectorXd inverses = VectorXd::Zero(size);
      double all = 0;
      for (double log_rho = -10; log_rho < 15; log_rho += 0.1) {
        const auto [deviance, variance] = likelihood(std::exp(log_rho));
        const double weight = std::exp(-0.5 * (deviance - least - log_rho + best));
        const MatrixXd C = MatrixXd::Identity(n, n) + std::exp(log_rho) * H * H.transpose();
        const MatrixXd covariance = variance * effect.transpose() * C * effect;
        inverses += weight * covariance.diagonal().cwiseInverse();
        all += weight;
      }
      for (int p = 0; p < size; ++p)
        EXPECT_NEAR(found->of_estimates.covariance[p][p] * inverses(p) / all, 1, 0.05) << p;
      EXPECT_NEAR(found->deviation, 0.5, 0.2);
    }
}

TEST(ForceNoise, TheNormIsThatOfTheDenseMatrix) {
  for (const double directly : {0.0, 0.7}) {
    const MatrixXd H = answers(answer(directly), {}, 60);
    EXPECT_NEAR(answer_norm(answer(directly), 60), H.squaredNorm(), 1e-9 * H.squaredNorm());
  }
}

TEST(ForceNoise, OfTheMotionsSensorAloneIsNone) {
  constexpr std::size_t n = 200;
  int told = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal;
    std::vector<double> residuals, rows(n, 1.0);
    double mean = 0;
    for (std::size_t i = 0; i < n; ++i) residuals.push_back(normal(engine));
    for (const double each : residuals) mean += each / n;
    for (double& each : residuals) each -= mean;
    SquareMatrix inverse_matrix{};
    inverse_matrix[0][0] = 1.0 / n;
    told += find_force_noise({}, residuals, rows, 1, inverse_matrix, answer(0), HUGE_VAL)->shows;
  }
  EXPECT_LE(told, 7);  // of 2 expected
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
