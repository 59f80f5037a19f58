#include "cromer/tasks/fit/stiffness_budget.h"

#include <algorithm>
#include <cmath>

#include "cromer/model/sensor.h"

namespace cromer::core {
namespace {

/// Chi-squared over its degrees of freedom: G. Marsaglia, W. W. Tsang, ACM Trans. Math. Softw. 26, 363
/// (2000).
class ChiSquared {
 public:
  ChiSquared(double degrees, std::uint64_t seed)
      : degrees_(std::max(2.0, degrees)), normal_(seed), uniform_(~seed) {}

  double next() {
    const double d = degrees_ / 2 - 1.0 / 3, c = 1 / std::sqrt(9 * d);
    for (;;) {
      const double x = normal_.next(), root = 1 + c * x;
      if (root <= 0) continue;
      const double v = root * root * root;
      const double u = 0.5 * (uniform_.next_signed_unit() + 1);
      if (u <= 0 || portable_log(u) < 0.5 * x * x + d - d * v + d * portable_log(v))
        return 2 * d * v / degrees_;
    }
  }

 private:
  double degrees_;
  NormalDeviates normal_;
  SplitMix64 uniform_;
};

}  // namespace

std::vector<Contribution> stiffness_budget(const Estimate& angular_frequency, const Body& body) {
  const double w = angular_frequency.value, m = body.effective_mass().value;
  std::vector<Contribution> all;
  const auto add = [&](const char* quantity, double value, double uncertainty, const char* unit,
                       double sensitivity) {
    all.push_back({quantity, value, uncertainty, unit, sensitivity, std::abs(sensitivity) * uncertainty, 0});
  };
  add("mass", body.mass->value, body.mass->uncertainty, "kg", w * w);
  if (body.spring_mass)
    add("spring_mass", body.spring_mass->value, body.spring_mass->uncertainty, "kg", w * w / 3);
  add("angular_frequency", w, angular_frequency.standard_error, "rad/s", 2 * m * w);
  double variance = 0;
  for (const Contribution& each : all) variance += each.contribution * each.contribution;
  for (Contribution& each : all)
    each.share = variance > 0 ? each.contribution * each.contribution / variance : 0;
  return all;
}

std::optional<MonteCarlo> stiffness_monte_carlo(const Estimate& w, double degrees, const Body& body,
                                                long long trials, std::uint64_t seed, const Watch& watch) {
  MonteCarlo result{trials, seed, 0, 0, 0, 0};
  const Quantity mass = *body.mass, spring = body.spring_mass.value_or(Quantity{});
  NormalDeviates normal(seed);
  ChiSquared chi_squared(degrees, seed + 1);
  std::vector<double> k(static_cast<std::size_t>(trials));
  constexpr long long between_looks = 1 << 14;
  long long until_look = 1;
  for (double& each : k) {
    if (--until_look == 0) {
      if (watch.interrupted()) return std::nullopt;
      until_look = between_looks;
    }
    // Drawn one by one: within one sum a compiler may draw them in any order.
    const double of_mass = normal.next(), of_spring = normal.next(), of_frequency = normal.next();
    const double m =
        mass.value + mass.uncertainty * of_mass + (spring.value + spring.uncertainty * of_spring) / 3;
    const double drawn = w.value + w.standard_error * of_frequency / std::sqrt(chi_squared.next());
    each = m * drawn * drawn;
  }
  const double n = static_cast<double>(trials), about = k.front();
  double sum = 0, squares = 0;
  for (const double each : k) sum += each - about;
  result.mean = about + sum / n;
  for (const double each : k) squares += (each - result.mean) * (each - result.mean);
  result.standard_deviation = std::sqrt(squares / (n - 1));
  std::sort(k.begin(), k.end());
  // JCGM 101, 7.7: q of the ordered values lie in the interval, as many below it as above.
  const auto below = static_cast<std::size_t>(std::llround(0.025 * n));
  result.low = k[below];
  result.high = k[k.size() - 1 - below];
  return result;
}

}  // namespace cromer::core
