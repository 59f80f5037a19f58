// Effective oscillators on the page, by the same code as its runs. This file replaces the one of the same
// name in tasks/methods, which is compiled for each set of terms and computes with more digits.
#include "any_method.h"
#include "cromer/tasks/methods/method_effect.h"

namespace cromer::core {

EffectiveOscillator effective_oscillator_of(std::string_view method, const MethodSettings& settings,
                                            const LinearLaw<double>& law, double h) {
  using Image = std::array<double, 3>;
  const auto image = [&]<Terms>(const Oscillator<double>& per_mass, const HarmonicForce<double>& force,
                                const Image& z, StepMap& map) {
    const AnyTerms system(per_mass, force);
    const State<double> y{z[0], z[1] / h};
    const auto stepper = page::stepper_of(method, settings, system, 0, y);
    double* carried = stepper->carried();
    if (carried) {
      map.size = 3;
      *carried = z[2] / (h * h);
    }
    const Trial<double> trial = stepper->step(0, h, y);
    map.converged = map.converged && trial.converged;
    return Image{trial.y.x, h * trial.y.v, carried ? h * h * *carried : 0};
  };
  return analyse(step_map_of<double>(image, law), h, law.drive_frequency);
}

}  // namespace cromer::core
