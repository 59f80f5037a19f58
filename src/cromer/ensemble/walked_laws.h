// Laws that are walked along one recording together, and bounds on what the walk did not look at.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cromer/analysis/response_filter.h"
#include "cromer/base/function_ref.h"
#include "cromer/ensemble/filter_walk.h"
#include "cromer/ensemble/response_peaks.h"

namespace cromer::core {

/// One oscillator of a walk.
struct WalkedLaw {
  LinearLaw<double> law;
  ResponseQuantity<double> quantity;
  IntervalMap<double> map;
  ResponseFilter<double> filter;
  double step;  // [s]
};

inline double value(const ResponseQuantity<double>& quantity, const State<double>& y) {
  return quantity.x * y.x + quantity.v * y.v;
}

/// The quantity of a law, on the mirrored motion, driven by +a: the absolute acceleration is what spring and
/// damper give it.
ResponseQuantity<double> quantity_of(const LinearLaw<double>& law, ResponseOf of);

double period_of(const LinearLaw<double>& law);  // [s]

/// A bound on how far |q| may exceed both its end values in any interval, from bounds on |q| at its ends and
/// on the force in it.
struct BlockBound {
  double of_q, of_force;

  BlockBound(const WalkedLaw& w, std::size_t substeps, bool hold);

 private:
  void by_state(const WalkedLaw& w, std::size_t substeps, bool hold);
};

/// Largest |force| in each block, the next sample included.
std::vector<double> largest_forces(const cromer_walk::Walk& walk);

/// At most cromer_walk::lanes laws. Lanes without a law rest: their filters are 0.
struct LawGroup {
  cromer_walk::Filters filters{};
  std::vector<WalkedLaw> laws{};

  void add(const LinearLaw<double>& law, const ResponseQuantity<double>& quantity, double step, bool hold,
           double force);
};

/// What is done with a group: `walk` is along the samples, `places` say which of the laws they are.
using WalkGroup = FunctionRef<void(const LawGroup& group, const cromer_walk::Walk& walk,
                                   std::span<const std::size_t> places)>;

/// Calls `walk_group` with all laws, in groups. `samples` are walked_samples(ground); `steps` are the
/// substeps that each law asks for.
void for_each_group(std::span<const double> samples, const GroundMotion& ground,
                    std::span<const LinearLaw<double>> laws, std::span<const std::size_t> steps, Peaks peaks,
                    ResponseOf quantity, WalkGroup walk_group);

/// The samples that a walk asks for.
std::vector<double> walked_samples(const GroundMotion& ground);

}  // namespace cromer::core
