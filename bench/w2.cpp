// W2: many driven Duffing oscillators, the final state and the peak of each kept; ours in every instruction
// set beside odeint and a plain loop, and beside what the processor can add and multiply at all. Prints lines
// of tab-separated "method, who, seconds a step"; bench/run makes the table of rates.
#include <immintrin.h>

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/integrate/integrate_n_steps.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <cmath>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "bench/stopwatch.h"
#include "cromer/ensemble/dispatch.h"
#include "cromer/ensemble/group.h"
#include "cromer/ensemble/point.h"
#include "cromer/ensemble/run_group.h"

namespace {

using namespace cromer::core;

constexpr int oscillators = 1024, steps = 2000;
constexpr double h = 0.02;

Point point_of(int i) {
  return {.oscillator = {.stiffness = 1, .damping = 0.1, .cubic = 0.3},
          .drive = {0.2, 0.5 + static_cast<double>(i) / oscillators, 0},
          .start = {1, 0},
          .step = h};
}

std::vector<cromer_group::Group> groups(int first, int last) {
  std::vector<cromer_group::Group> all(static_cast<std::size_t>((last - first) / cromer_group::size));
  for (std::size_t g = 0; g < all.size(); ++g) {
    std::vector<Point> points;
    for (int i = 0; i < cromer_group::size; ++i)
      points.push_back(point_of(first + static_cast<int>(g) * cromer_group::size + i));
    fill_group(points, all[g]);
  }
  return all;
}

void run(const KernelUnit& unit, std::string_view method, std::vector<cromer_group::Group>& all) {
  for (auto& group : all) unit.advance(group, order_of({.method = method}, steps));
}

void print(std::string_view method, const std::string& who, double seconds) {
  std::printf("%.*s\t%s\t%.6g\n", static_cast<int>(method.size()), method.data(), who.c_str(), seconds);
  std::fflush(stdout);
}

/// As a plain loop has it: what a careful programmer writes without vectors.
double plain_loop(int i) {
  const Point p = point_of(i);
  double x = p.start.x, v = p.start.v, peak = 1;
  for (int n = 0; n < steps; ++n) {
    const double t = n * h;
    v += h * (p.drive.amplitude * std::cos(p.drive.frequency * t) - 0.1 * v - x - 0.3 * x * x * x);
    x += h * v;
    peak = std::max(peak, std::abs(x));
  }
  return x + peak;
}

/// odeint, one oscillator after the other.
double odeint_rk4(int i) {
  using State = std::array<double, 2>;
  const Point p = point_of(i);
  State y{p.start.x, p.start.v};
  double peak = 1;
  boost::numeric::odeint::runge_kutta4<State> stepper;
  const auto law = [&](const State& u, State& du, double t) {
    du[0] = u[1];
    du[1] =
        p.drive.amplitude * std::cos(p.drive.frequency * t) - 0.1 * u[1] - u[0] - 0.3 * u[0] * u[0] * u[0];
  };
  boost::numeric::odeint::integrate_n_steps(
      stepper, law, y, 0.0, h, static_cast<std::size_t>(steps),
      [&](const State& u, double) { peak = std::max(peak, std::abs(u[0])); });
  return y[0] + peak;
}

constexpr int fma_rounds = 4000000, fma_chains = 12;

/// Chains of multiplications with additions, as many side by side as keep the processor busy.
__attribute__((target("avx512f"))) double fma_chains_avx512() {
  __m512d sums[fma_chains];
  for (int i = 0; i < fma_chains; ++i) sums[i] = _mm512_set1_pd(i);
  const __m512d a = _mm512_set1_pd(0.9999), b = _mm512_set1_pd(1e-4);
  for (int n = 0; n < fma_rounds; ++n)
    for (auto& sum : sums) sum = _mm512_fmadd_pd(sum, a, b);
  __m512d all = sums[0];
  for (int i = 1; i < fma_chains; ++i) all = _mm512_add_pd(all, sums[i]);
  return _mm512_reduce_add_pd(all);
}

__attribute__((target("avx2,fma"))) double fma_chains_avx2() {
  __m256d sums[fma_chains];
  for (int i = 0; i < fma_chains; ++i) sums[i] = _mm256_set1_pd(i);
  const __m256d a = _mm256_set1_pd(0.9999), b = _mm256_set1_pd(1e-4);
  for (int n = 0; n < fma_rounds; ++n)
    for (auto& sum : sums) sum = _mm256_fmadd_pd(sum, a, b);
  __m256d all = sums[0];
  for (int i = 1; i < fma_chains; ++i) all = _mm256_add_pd(all, sums[i]);
  return _mm256_cvtsd_f64(all);
}

/// Seconds for one operation, a multiplication with its addition counted as two.
double seconds_an_operation(double (*chains)(), int lanes) {
  volatile double used = 0;
  return bench::median_seconds([&] { used = used + chains(); }, 5) / (2.0 * lanes * fma_chains * fma_rounds);
}

}  // namespace

int main() {
  for (const std::string_view method :
       {"euler-cromer", "rk4", "implicit-euler", "verlet", "newmark", "heun"}) {
    const double count = static_cast<double>(oscillators) * steps;
    for (const KernelUnit& unit : units_here()) {
      auto all = groups(0, oscillators);
      print(method, "cromer " + std::string(unit.name),
            bench::median_seconds([&] { run(unit, method, all); }, 9) / count);
    }
    const KernelUnit unit = units_here().back();
    auto low = groups(0, oscillators / 2), high = groups(oscillators / 2, oscillators);
    // Twenty rounds each: starting a thread must not count.
    constexpr int rounds = 20;
    const auto many = [&](std::vector<cromer_group::Group>& all) {
      for (int i = 0; i < rounds; ++i) run(unit, method, all);
    };
    print(method, "cromer, two threads",
          bench::median_seconds(
              [&] {
                std::thread other([&] { many(high); });
                many(low);
                other.join();
              },
              5) /
              count / rounds);
  }
  const double count = static_cast<double>(oscillators) * steps;
  volatile double used = 0;
  print("euler-cromer", "plain loop",
        bench::median_seconds(
            [&] {
              for (int i = 0; i < oscillators; ++i) used = used + plain_loop(i);
            },
            3) /
            count);
  print("rk4", "odeint",
        bench::median_seconds(
            [&] {
              for (int i = 0; i < oscillators; ++i) used = used + odeint_rk4(i);
            },
            3) /
            count);
  if (__builtin_cpu_supports("avx512f"))
    print("FMA peak", "avx512", seconds_an_operation(fma_chains_avx512, 8));
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    print("FMA peak", "avx2", seconds_an_operation(fma_chains_avx2, 4));
}
