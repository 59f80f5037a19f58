#include "cromer/ensemble/fill_group.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "cromer/methods/all.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/terms.h"

namespace cromer::core {

static_assert(term_count <= cromer_group::most_terms);

void fill_group(std::span<const Point> points, cromer_group::Group& group) {
  assert(!points.empty() && points.size() <= static_cast<std::size_t>(cromer_group::size));
  group = {};
  for (int i = 0; i < cromer_group::size; ++i) {
    const Point& point = points[std::min<std::size_t>(i, points.size() - 1)];
    const Oscillator<double> per_mass = divided_by_mass(point.oscillator);
    for_each_term([&]<class T>() {
      group.coefficients[place_of_term<T>].of[i] = per_mass.*T::template members<double>[0];
    });
    const HarmonicForce<double> force = force_of(point.drive, point.oscillator.mass);
    group.drive_amplitude.of[i] = force.amplitude;
    group.drive_frequency.of[i] = force.frequency;
    group.drive_phase.of[i] = force.phase;
    group.step.of[i] = point.step;
    group.x.of[i] = point.start.x;
    group.v.of[i] = point.start.v;
    const Terms terms = terms_of(point.oscillator, point.drive);
    assert(smooth_terms.contains(terms.law));
    group.driven |= terms.drive;
    group.law |= terms.law.terms;
  }
}

cromer_group::Order order_of(const Stepping& stepping, long long steps, const double* weights) {
  const auto place = std::find(method_names.begin(), method_names.end(), stepping.method);
  assert(place != method_names.end());
  return {static_cast<unsigned>(place - method_names.begin()),
          stepping.settings.newton.tolerance,
          stepping.settings.beta,
          stepping.settings.gamma,
          stepping.settings.rho_inf,
          steps,
          weights};
}

PointStatus status_of(const cromer_group::Group& group, int i) {
  if (group.failed.of[i] != 0) return PointStatus::no_convergence;
  return std::isfinite(group.x.of[i] - group.v.of[i]) ? PointStatus::done : PointStatus::not_finite;
}

}  // namespace cromer::core
