#include "cromer/ensemble/filter_walk.h"

#include "cromer/ensemble/filter_walk_body.h"

namespace cromer {
namespace {

/// One lane.
struct One {
  static constexpr std::size_t width = 1;
  double value = 0;

  One() = default;
  explicit One(double number) : value(number) {}
  static One load(const double* from) { return One(*from); }
  void store(double* to) const { *to = value; }

  friend One operator+(One a, One b) { return One(a.value + b.value); }
  friend One operator-(One a, One b) { return One(a.value - b.value); }
  friend One operator*(One a, One b) { return One(a.value * b.value); }
  friend One min(One a, One b) { return a.value < b.value ? a : b; }
  friend One max(One a, One b) { return a.value > b.value ? a : b; }
};

using Walker = FilterWalker<One, 4>;

}  // namespace

std::size_t filter_lanes() { return Walker::lanes; }

void walk_filters(const FilterWalk& walk, const FilterRows& rows, double* blocks) {
  Walker(rows).run(walk, blocks);
}

}  // namespace cromer
