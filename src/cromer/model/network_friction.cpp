#include "cromer/model/network_friction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace cromer::core {
namespace {

/// A largest flow from nodes that have too much to those with too little, through lines that carry up to
/// their capacity both ways: by shortest paths, all of one length at a time (Y. Dinitz, Sov. Math. Dokl. 11,
/// 1277 (1970)).
class ForceFlow {
 public:
  explicit ForceFlow(std::size_t nodes) : at_(nodes), spare_(nodes), depth_(nodes), next_(nodes) {}

  void add_line(std::size_t a, std::size_t b, double capacity) {
    at_[a].push_back(lines_.size());
    lines_.push_back({b, capacity});
    at_[b].push_back(lines_.size());
    lines_.push_back({a, capacity});
  }

  /// spare: too much (+) or too little (-) of each node; amounts up to `least` count as none. Returns the
  /// nodes behind the bottleneck, on the side of too much; all false where everything could flow.
  std::vector<bool> run(const std::vector<double>& spare, double least) {
    spare_ = spare;
    least_ = least;
    while (find_depths()) {
      std::fill(next_.begin(), next_.end(), std::size_t{0});
      for (std::size_t i = 0; i < at_.size(); ++i)
        while (spare_[i] > least_) {
          const double sent = send(i, spare_[i]);
          if (!(sent > 0)) break;
          spare_[i] -= sent;
        }
    }
    std::vector<bool> behind(at_.size());
    for (std::size_t i = 0; i < at_.size(); ++i) behind[i] = depth_[i] >= 0;
    return behind;
  }

 private:
  struct Line {
    std::size_t to;
    double room;
  };

  /// Of every node that what is too much can still reach; true if somewhere there is too little.
  bool find_depths() {
    std::fill(depth_.begin(), depth_.end(), -1);
    std::vector<std::size_t> queue;
    for (std::size_t i = 0; i < at_.size(); ++i)
      if (spare_[i] > least_) {
        depth_[i] = 0;
        queue.push_back(i);
      }
    bool reached = false;
    for (std::size_t k = 0; k < queue.size(); ++k) {
      const std::size_t i = queue[k];
      reached = reached || spare_[i] < -least_;
      for (const std::size_t line : at_[i])
        if (const auto& [to, room] = lines_[line]; room > least_ && depth_[to] < 0) {
          depth_[to] = depth_[i] + 1;
          queue.push_back(to);
        }
    }
    return reached;
  }

  /// Up to `amount` from node i to nodes with too little; returns how much. Not by recursion: chains are
  /// long.
  double send(std::size_t start, double amount) {
    std::vector<std::size_t> path;  // lines
    std::size_t i = start;
    for (;;) {
      if (i != start && spare_[i] < -least_) {
        double flow = std::min(amount, -spare_[i]);
        for (const std::size_t line : path) flow = std::min(flow, lines_[line].room);
        for (const std::size_t line : path) {
          lines_[line].room -= flow;
          lines_[line ^ 1].room += flow;
        }
        spare_[i] += flow;
        return flow;
      }
      bool on = false;
      for (; next_[i] < at_[i].size(); ++next_[i]) {
        const std::size_t line = at_[i][next_[i]];
        const auto& [to, room] = lines_[line];
        if (room > least_ && depth_[to] == depth_[i] + 1) {
          path.push_back(line);
          i = to;
          on = true;
          break;
        }
      }
      if (on) continue;
      if (path.empty()) return 0;
      i = lines_[path.back() ^ 1].to;
      path.pop_back();
      ++next_[i];
    }
  }

  std::vector<std::vector<std::size_t>> at_;
  std::vector<Line> lines_;  ///< in pairs, there and back
  std::vector<double> spare_;
  std::vector<int> depth_;
  std::vector<std::size_t> next_;
  double least_ = 0;
};

}  // namespace

NetworkFriction::NetworkFriction(const Network& network) {
  for (const NetworkMass& mass : network.masses) mass_.push_back(mass.mass);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> places;
  for (const NetworkLink& link : network.links) {
    const double kinetic = link.law.friction, holding = std::max(kinetic, link.law.static_friction);
    if (holding == 0) continue;
    const auto [place, fresh] = places.emplace(std::minmax(link.from, link.to), contacts_.size());
    if (fresh) contacts_.push_back({link.from, link.to, 0, 0});
    contacts_[place->second].kinetic += kinetic;
    contacts_[place->second].holding += holding;
  }
}

void NetworkFriction::decide(const Vector& acceleration, std::vector<int>& directions,
                             const std::vector<bool>& held) const {
  const std::size_t count = mass_.size();
  const auto node = [&](std::size_t mass) { return mass == ground ? count : mass; };
  // Forces without those of contacts at rest; the ground has any.
  std::vector<double> force(count + 1);
  for (std::size_t i = 0; i < count; ++i) force[i] = mass_[i] * acceleration[i];
  const auto slide = [&](std::size_t c, int direction) {
    directions[c] = direction;
    force[node(contacts_[c].to)] -= direction * contacts_[c].kinetic;
    force[node(contacts_[c].from)] += direction * contacts_[c].kinetic;
  };
  std::vector<std::vector<std::size_t>> resting(count + 1);
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    if (directions[c] != 0) {
      slide(c, directions[c]);
      continue;
    }
    resting[node(contacts_[c].from)].push_back(c);
    resting[node(contacts_[c].to)].push_back(c);
  }

  std::vector<std::size_t> local(count + 1, count + 1), todo;
  std::vector<bool> known(count + 1);
  for (std::size_t i = 0; i <= count; ++i)
    if (!resting[i].empty()) todo.push_back(i);
  while (!todo.empty()) {
    if (known[todo.back()]) {
      todo.pop_back();
      continue;
    }
    // All that rests together with the last one.
    std::vector<std::size_t> nodes{todo.back()}, inside;
    local[nodes[0]] = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (const std::size_t c : resting[nodes[k]]) {
        if (directions[c] != 0) continue;
        const std::size_t a = node(contacts_[c].from), b = node(contacts_[c].to);
        const std::size_t other = a == nodes[k] ? b : a;
        if (local[other] > count) {
          local[other] = nodes.size();
          nodes.push_back(other);
        }
        if (a == nodes[k]) inside.push_back(c);
      }

    const bool grounded = local[count] <= count;
    double total = 0, weight = 0, scale = 0;
    for (const std::size_t i : nodes)
      if (i < count) {
        total += force[i];
        weight += mass_[i];
        scale += std::abs(force[i]);
      }
    std::vector<double> spare(nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k)
      spare[k] =
          nodes[k] == count ? -total : force[nodes[k]] - (grounded ? 0 : mass_[nodes[k]] * (total / weight));
    const double least = 16 * std::numeric_limits<double>::epsilon() * scale;
    ForceFlow flow(nodes.size());
    for (const std::size_t c : inside)
      flow.add_line(
          local[node(contacts_[c].from)], local[node(contacts_[c].to)],
          !held.empty() && held[c] ? std::numeric_limits<double>::infinity() : contacts_[c].holding);
    const std::vector<bool> faster = flow.run(spare, least);
    bool parted = false;
    for (const std::size_t c : inside) {
      const bool from = faster[local[node(contacts_[c].from)]], to = faster[local[node(contacts_[c].to)]];
      if (from == to) continue;
      slide(c, to ? 1 : -1);
      parted = true;
    }
    for (const std::size_t i : nodes) {
      known[i] = !parted;
      local[i] = count + 1;
    }
    // Where they part, both sides are looked at again.
    if (parted) todo.insert(todo.end(), nodes.begin(), nodes.end());
  }
}

}  // namespace cromer::core
