// Dry air at atmospheric pressure, and how fast a disc moves through it.
#pragma once

#include <span>
#include <vector>

namespace cromer::core {

/// Density [kg/m^3] and viscosities of dry air at 101325 Pa and temperature T [K], 0 < T; within 0.5 % from
/// 200 to 500 K. Ideal gas with M = 28.9647 g/mol, and Sutherland's law (Phil. Mag. 36, 507 (1893)) with the
/// constants of the U.S. Standard Atmosphere 1976.
double air_density(double T);
double air_dynamic_viscosity(double T);    // [Pa s]
double air_kinematic_viscosity(double T);  // [m^2/s] 1.51e-5 at 293.15 K

/// Re = |v| D / nu, with D [m] the diameter and nu [m^2/s] > 0 the kinematic viscosity.
double reynolds_number(double v, double D, double nu);

/// The largest |v| within [t, t + length).
struct SpeedWindow {
  double t = 0;      // [s] where the window begins
  double speed = 0;  // [m/s]
  double at = 0;     // [s] when it is reached
};

/// Whole windows of `length` [s] > 0 from t.front() on; those without a sample are left out. Between samples
/// the speed is taken at the top of the parabola through three of them. A window shorter than half a period
/// may miss every top: then its value says nothing of the motion's scale.
std::vector<SpeedWindow> speed_windows(std::span<const double> t, std::span<const double> v, double length);

}  // namespace cromer::core
