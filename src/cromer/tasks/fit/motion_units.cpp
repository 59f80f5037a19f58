#include "cromer/tasks/fit/motion_units.h"

#include "cromer/tasks/fit/fitted_quantities.h"
#include "cromer/tasks/fit/used_samples.h"

namespace cromer::core {

MotionUnits motion_units(const FittedRecording& fitted) {
  MotionUnits units;
  units.measured = unit_of(fitted.series);
  units.displacement = displacement_unit(units.measured, derivative_order(fitted.series.quantity));
  if (!units.displacement.empty()) units.velocity = units.displacement + "/s";
  if (fitted.find("stiffness"))
    units.energy = "J";
  else if (units.displacement == "m")
    units.energy = "J/kg";
  else if (units.displacement == "rad")
    units.energy = "J/(kg m²)";
  return units;
}

}  // namespace cromer::core
