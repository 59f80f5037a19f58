#include "cromer/documents/json/documents.h"
#include "cromer/documents/json/estimate.h"
#include "cromer/documents/json/json.h"
#include "cromer/documents/json/notices.h"
#include "cromer/documents/json/recording.h"

namespace cromer::core {
namespace {

Json object_of(const Quantity& quantity, std::string_view unit) {
  return {{"value", quantity.value}, {"standard_uncertainty", quantity.uncertainty}, {"unit", unit}};
}

Json object_of(const LineWithErrors& line, std::string_view slope_unit, std::string_view unit) {
  return {{"slope", line.slope},
          {"slope_standard_error", line.slope_error},
          {"slope_unit", slope_unit},
          {"intercept", line.intercept},
          {"intercept_standard_error", line.intercept_error},
          {"intercept_unit", unit},
          {"covariance", line.covariance},
          {"chi_squared", line.chi_squared},
          {"degrees_of_freedom", line.degrees},
          {"extra_scatter", line.extra_scatter}};
}

}  // namespace

std::string to_json(const StaticStiffness& found) {
  Json object;
  object["status"] = "converged";
  object["parameters"] = {{"stiffness", estimate_object(found.stiffness, "N/m")}};
  object["gravity"] = object_of(found.gravity, "m/s²");
  object["line"] = object_of(found.line, "m/kg", "m");
  Json& holds = object["holds"] = Json::array();
  for (const Hold& hold : found.holds)
    holds.push_back({{"file", hold.file},
                     {"run", hold.run},
                     {"from", hold.from},
                     {"to", hold.to},
                     {"samples", hold.samples},
                     {"mass", object_of(hold.mass, "kg")},
                     {"position", hold.position},
                     {"scatter", hold.scatter},
                     {"standard_error", hold.standard_error}});
  add_notices(object, found.notices, {});
  return to_text(object);
}

std::string to_json(std::span<const FittedRecording> fits, const MassLine& line) {
  Json all = Json::parse(to_json(fits, true));
  Json& object = all["mass_line"] = Json::object();
  object["stiffness"] = estimate_object(line.stiffness, "N/m");
  object["effective_mass"] = estimate_object(line.effective_mass, "kg");
  object["spring_mass"] = estimate_object(line.spring_mass, "kg");
  object["line"] = object_of(line.line, "s²/kg", "s²");
  Json& points = object["points"] = Json::array();
  for (const MassLinePoint& point : line.points)
    points.push_back({{"file", point.file},
                      {"run", point.run},
                      {"mass", object_of(point.mass, "kg")},
                      {"period_squared", estimate_object(point.period_square, "s²")}});
  add_notices(object, line.notices, {});
  return to_text(all);
}

}  // namespace cromer::core
