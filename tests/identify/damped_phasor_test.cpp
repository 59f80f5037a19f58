#include "cromer/identify/motion/damped_phasor.h"

#include <gtest/gtest.h>

#include <random>

#include "cromer/base/dual.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

// The same sums from the definition, sample by sample, with derivatives by dual numbers.
NormalEquations direct(const Record& record, const Parameters& p) {
  using D = Dual<double, 5>;
  NormalEquations e;
  e.size = 5;
  for (std::size_t n = 0; n < record.t.size(); ++n) {
    const double s = record.t[n] - record.t[0];
    D q[5];
    for (std::size_t i = 0; i < 5; ++i) q[i] = D::variable(p[i], i);
    const D y = q[2] + exp(-q[1] * D(s)) * (q[3] * cos(q[0] * D(s)) + q[4] * sin(q[0] * D(s)));
    const double r = record.y[n] - y.value;
    for (std::size_t i = 0; i < 5; ++i) {
      e.right[i] += y.derivative[i] * r;
      for (std::size_t j = 0; j < 5; ++j) e.matrix[i][j] += y.derivative[i] * y.derivative[j];
    }
    e.sum_of_squares += r * r;
  }
  return e;
}

void expect_same(const NormalEquations& a, const NormalEquations& b) {
  EXPECT_NEAR(a.sum_of_squares, b.sum_of_squares, 1e-11 * b.sum_of_squares);
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(a.right[i], b.right[i], 1e-11 * std::sqrt(b.matrix[i][i] * b.sum_of_squares)) << i;
    for (int j = 0; j < 5; ++j)
      EXPECT_NEAR(a.matrix[i][j], b.matrix[i][j], 1e-11 * std::sqrt(b.matrix[i][i] * b.matrix[j][j]))
          << i << ' ' << j;
  }
}

constexpr Parameters near_truth{8.85, 0.031, 0.201, 0.035, 0.002};

TEST(DampedPhasor, SumsAreThoseOfTheDefinition) {
  for (std::size_t n : {9u, 256u, 257u, 3000u}) {
    const SyntheticRecord record = viscous_record({}, even_times(n, 0.01), 1e-3);
    expect_same(DampedPhasor(record.record())(near_truth), direct(record.record(), near_truth));
  }
}

TEST(DampedPhasor, SumsHoldForUnevenTimesAndGaps) {
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> jitter(-0.004, 0.004);
  std::vector<double> uneven = even_times(1500, 0.01), gaps;
  for (double& t : uneven) t += jitter(engine);
  for (int i = 0; i < 2000; ++i)
    if (i % 97 != 13 && (i < 700 || i > 900) && i != 500) gaps.push_back(5 + 0.01 * i);
  for (const auto& t : {uneven, gaps}) {
    const SyntheticRecord record = viscous_record({}, t, 1e-3);
    expect_same(DampedPhasor(record.record())(near_truth), direct(record.record(), near_truth));
  }
}

TEST(DampedPhasor, ResidualsAreDataMinusModel) {
  const SyntheticRecord record = viscous_record({}, even_times(1000, 0.01), 1e-3);
  std::vector<double> r;
  DampedPhasor(record.record()).residuals(near_truth, r);
  double sum = 0;
  for (double value : r) sum += value * value;
  EXPECT_NEAR(sum, direct(record.record(), near_truth).sum_of_squares, 1e-11 * sum);
}

TEST(DampedPhasor, TheSwingIsTheModelWithoutItsEquilibrium) {
  std::vector<double> gaps;
  for (int i = 0; i < 1000; ++i)
    if (i % 97 != 13 && i < 700) gaps.push_back(5 + 0.01 * i);
  for (const std::vector<double>& t : {even_times(1, 0.01), even_times(300, 0.01), gaps}) {
    const auto [w, g, E, A, B] = std::array{8.85, 0.031, 0.201, 0.035, 0.002};
    const std::vector<double> x = DampedPhasor({t, {}, 0}).swing({w, g, E, A, B});
    ASSERT_EQ(x.size(), t.size());
    for (std::size_t i = 0; i < t.size(); ++i) {
      const double s = t[i] - t[0];
      EXPECT_NEAR(x[i], std::exp(-g * s) * (A * std::cos(w * s) + B * std::sin(w * s)), 1e-14) << i;
    }
  }
}

TEST(DampedPhasor, BestAmplitudesAreExactAtTheTrueRates) {
  const ViscousTruth truth;
  const SyntheticRecord record = viscous_record(truth, even_times(1000, 0.01));
  const auto best =
      DampedPhasor(record.record()).best_linear(std::sqrt(truth.w0 * truth.w0 - truth.g * truth.g), truth.g);
  EXPECT_NEAR(best.equilibrium, truth.equilibrium, 1e-12);
  EXPECT_NEAR(best.cosine, truth.position, 1e-12);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
