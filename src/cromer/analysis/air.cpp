#include "cromer/analysis/air.h"

#include <cmath>

namespace cromer::core {

double air_density(double T) {
  constexpr double pressure = 101325;                                // [Pa]
  constexpr double specific_gas_constant = 8.314462618 / 0.0289647;  // [J/(kg K)]
  return pressure / (specific_gas_constant * T);
}

double air_dynamic_viscosity(double T) {
  constexpr double beta = 1.458e-6;  // [kg/(s m K^0.5)]
  constexpr double S = 110.4;        // [K]
  return beta * T * std::sqrt(T) / (T + S);
}

double air_kinematic_viscosity(double T) { return air_dynamic_viscosity(T) / air_density(T); }

}  // namespace cromer::core
