#include "cromer/identify/modal/stabilisation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cromer/analysis/complex_modes.h"
#include "cromer/base/disjoint_sets.h"
#include "cromer/base/pi.h"

namespace cromer::core {
namespace {

constexpr double near_frequency = 0.01;

bool continues(const StabilityPole& pole, const StabilityPole& before) {
  return std::abs(before.frequency - pole.frequency) < near_frequency * pole.frequency &&
         std::abs(before.damping_ratio - pole.damping_ratio) < 0.5 * std::abs(pole.damping_ratio) + 0.002 &&
         modal_assurance(before.shape, pole.shape) > 0.95;
}

// Groups of poles that are joined by neighbours of one frequency and shape.
std::vector<std::vector<std::size_t>> join_poles(const std::vector<StabilityPole>& poles) {
  std::vector<std::size_t> stable;
  for (std::size_t i = 0; i < poles.size(); ++i)
    if (poles[i].stable || poles[i].first) stable.push_back(i);
  std::sort(stable.begin(), stable.end(),
            [&](std::size_t a, std::size_t b) { return poles[a].frequency < poles[b].frequency; });
  DisjointSets joined(poles.size());
  for (std::size_t i = 0; i < stable.size(); ++i)
    for (std::size_t j = i; j-- > 0;) {
      const StabilityPole &a = poles[stable[i]], &b = poles[stable[j]];
      if (a.frequency - b.frequency > near_frequency * a.frequency) break;
      if (modal_assurance(a.shape, b.shape) > 0.9) joined.join(stable[i], stable[j]);
    }
  std::map<std::size_t, std::vector<std::size_t>> groups;
  for (const std::size_t i : stable) groups[joined.leader(i)].push_back(i);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [first, members] : groups) result.push_back(std::move(members));
  return result;
}

}  // namespace

int Stabilisation::orders(const std::vector<std::size_t>& group) const {
  std::set<int> different;
  for (const std::size_t i : group) different.insert(poles[i].order);
  return static_cast<int>(different.size());
}

int Stabilisation::first_common_order(const std::vector<std::vector<std::size_t>>& some) const {
  int order = 0;
  for (const auto& group : some) order = std::max(order, poles[group.front()].order);
  return order;
}

Stabilisation stabilise(const Subspace& subspace, int highest_order, double step, double from, double to,
                        double growth) {
  Stabilisation result;
  std::size_t before = 0;  // first pole of the order before
  for (int order = 2; order <= highest_order; order += 2) {
    const std::size_t begin = result.poles.size();
    ModelPoles model = subspace.poles(order);
    for (Eigen::Index j = 0; j < model.values.size(); ++j) {
      if (!(model.values(j).imag() > 0)) continue;
      const std::complex<double> rate = std::log(model.values(j)) / step;
      StabilityPole pole;
      pole.order = order;
      pole.frequency = std::abs(rate) / two_pi;
      pole.damping_ratio = -rate.real() / std::abs(rate);
      if (!(rate.real() < growth && std::abs(pole.damping_ratio) < 0.25 && pole.frequency >= from &&
            pole.frequency <= to))
        continue;
      pole.index = j;
      const Eigen::VectorXcd shape = subspace.shape(model, j);
      pole.shape.assign(shape.data(), shape.data() + shape.size());
      for (std::size_t i = before; i < begin; ++i)
        if (continues(pole, result.poles[i])) {
          pole.stable = true;
          result.poles[i].first = !result.poles[i].stable;
        }
      result.poles.push_back(std::move(pole));
    }
    before = begin;
    result.models.push_back(std::move(model));
  }
  for (std::vector<std::size_t>& members : join_poles(result.poles)) {
    std::sort(members.begin(), members.end());
    const int first = result.poles[members.front()].order, possible = (highest_order - first) / 2 + 1;
    if (result.orders(members) < std::max(5.0, 0.4 * possible) || first > 0.6 * highest_order) continue;
    for (const std::size_t i : members) result.poles[i].mode = static_cast<int>(result.groups.size());
    result.groups.push_back(std::move(members));
  }
  return result;
}

}  // namespace cromer::core
