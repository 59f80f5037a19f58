#include "cromer/identify/motion/motion_model.h"

#include <algorithm>
#include <cmath>

#include "cromer/base/pi.h"
#include "cromer/identify/motion/integrate_through.h"

namespace cromer::core {
namespace {

const MotionFunctions& functions_of(const Drive& drive) {
  if (is_recorded(drive.kind)) return recorded_motions;
  return drive.kind == DriveKind::none ? free_motions : harmonic_motions;
}

}  // namespace

double motion_step(double angular_frequency, double duration, double error) {
  const double period = two_pi / angular_frequency;
  const double phase = std::max(1.0, angular_frequency * duration);
  const double h = std::pow(3600 * std::max(error, 0.0) / phase, 0.2) / angular_frequency;
  return std::clamp(h, period / 600, period / 20);
}

Trajectory motion_states(const Motion& motion, const Drive& drive, std::span<const double> t, double h) {
  return t.empty() ? Trajectory{} : functions_of(drive).states(motion, drive, t, h);
}

std::vector<double> observed_motion(const Motion& motion, const Drive& drive, std::span<const double> t,
                                    int derivative, double h) {
  return t.empty() ? std::vector<double>{} : functions_of(drive).observed(motion, drive, t, derivative, h);
}

std::vector<double> motion_residuals(const Motion& motion, const Drive& drive, const Record& record,
                                     double h) {
  std::vector<double> r = observed_motion(motion, drive, record.t, record.derivative, h);
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = record.y[i] - r[i];
  return r;
}

NormalEquations motion_equations(const FittedParameters& fitted, const Parameters& parameters,
                                 const Drive& drive, const Record& record, double h) {
  return functions_of(drive).equations(fitted, parameters, drive, record, h);
}

std::vector<double> jacobian_of(const FittedParameters& fitted, const Parameters& parameters,
                                const Drive& drive, const Record& record, double h) {
  return functions_of(drive).jacobian(fitted, parameters, drive, record, h);
}

}  // namespace cromer::core
