#include "cromer/identify/forced_quantities.h"

#include <cmath>

#include "cromer/base/dual.h"
#include "cromer/identify/motion/recorded_force.h"
#include "cromer/identify/motion/sinusoidal_force.h"

namespace cromer {
namespace {

using Real = Dual<double, max_parameters>;

// The parameters by name, as functions of themselves.
struct Coefficients {
  Real bias, decay, drag, s1, s2, s3, position, velocity;
  int derivative;  // of the record

  Coefficients(const Parameters& p, const ForcedLayout& at, int of_record)
      : bias(of(p, at.bias)),
        decay(of(p, at.decay)),
        drag(of(p, at.drag)),
        s1(of(p, at.stiffness)),
        s2(of(p, at.quadratic)),
        s3(of(p, at.cubic)),
        position(of(p, at.position)),
        velocity(of(p, at.velocity)),
        derivative(of_record) {}

  static Real of(const Parameters& p, int i) {
    return i < 0 ? Real(0.0) : Real::variable(p[static_cast<std::size_t>(i)], static_cast<std::size_t>(i));
  }

  Real pull(const Real& z) const { return bias - z * (s1 + z * (s2 + z * s3)); }
  Real stiffness_at(const Real& z) const { return s1 + z * (2.0 * s2 + 3.0 * s3 * z); }

  // The z nearest 0 at which nothing pulls; Newton's iteration, whose last step has the exact derivatives.
  Real rest() const {
    Real z(0.0);
    if (derivative > 0) return z;  // it is measured from there
    for (int i = 0; i < 50; ++i) z = Real(z.value) + pull(Real(z.value)) / stiffness_at(Real(z.value));
    return z;
  }
};

void add(ForcedQuantities& list, const char* name, const Real& quantity) {
  list.names.emplace_back(name);
  list.values.push_back(quantity.value);
  list.derivatives.push_back(quantity.derivative);
}

// The law about e, z of the equilibrium.
void add_law(ForcedQuantities& list, const Coefficients& c, ForcedTerms terms, const Real& e) {
  add(list, "angular_frequency", sqrt(c.stiffness_at(e)));
  add(list, "decay_rate", c.decay);
  if (terms.drag) add(list, "drag", c.drag);
  if (terms.curved) {
    add(list, "cubic", c.s3);
    add(list, "quadratic", c.s2 + 3.0 * c.s3 * e);
  }
}

void add_start(ForcedQuantities& list, const Coefficients& c, double level, const Real& e) {
  add(list, "equilibrium", Real(level) + (c.derivative == 0 ? e : c.bias));
  add(list, "position", c.position - e);
  add(list, "velocity", c.velocity);
}

}  // namespace

ForcedQuantities recorded_quantities(const Parameters& parameters, ForcedTerms terms, double level,
                                     int derivative, bool zero_is_equilibrium) {
  const Coefficients c(parameters, forced_layout(RecordedForce::parameters, terms), derivative);
  const Real gain = Coefficients::of(parameters, RecordedForce::gain);
  const bool amid = derivative == 0 && zero_is_equilibrium;
  const Real e = amid ? Real(-level) : c.rest();
  ForcedQuantities list;
  add_law(list, c, terms, e);
  add(list, "force_gain", gain);
  if (derivative == 0) add(list, "force_offset", amid ? c.pull(e) / gain : Real(0.0));
  add_start(list, c, level, e);
  return list;
}

ForcedQuantities driven_quantities(const Parameters& parameters, ForcedTerms terms, double level,
                                   int derivative) {
  const Coefficients c(parameters, forced_layout(SinusoidalForce::parameters, terms), derivative);
  const Real cosine = Coefficients::of(parameters, SinusoidalForce::cosine);
  const Real sine = Coefficients::of(parameters, SinusoidalForce::sine);
  const Real e = c.rest();
  ForcedQuantities list;
  add_law(list, c, terms, e);
  add(list, "drive_frequency", Coefficients::of(parameters, SinusoidalForce::frequency));
  add(list, "drive_amplitude", hypot(cosine, sine));
  add(list, "drive_phase", atan2(-sine, cosine));  // C cos + S sin = A cos(w s + phase)
  add_start(list, c, level, e);
  return list;
}

}  // namespace cromer
