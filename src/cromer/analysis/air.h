// Dry air at atmospheric pressure.
#pragma once

namespace cromer::core {

/// Density [kg/m^3] and viscosities of dry air at 101325 Pa and temperature T [K], 0 < T; within 0.5 % from
/// 200 to 500 K. Ideal gas with M = 28.9647 g/mol, and Sutherland's law (Phil. Mag. 36, 507 (1893)) with the
/// constants of the U.S. Standard Atmosphere 1976.
double air_density(double T);
double air_dynamic_viscosity(double T);    // [Pa s]
double air_kinematic_viscosity(double T);  // [m^2/s] 1.51e-5 at 293.15 K

}  // namespace cromer::core
