// What the documents of a spring constant consist of: from held masses, and from periods against mass.
#pragma once

#include "cromer/documents/described/describe.h"
#include "cromer/tasks/fit/spring_constant.h"

namespace cromer::core {

/// A quantity with its unit.
struct QuantityIn {
  Quantity quantity;
  std::string_view unit;
};

template <>
struct Described<QuantityIn> {
  static constexpr std::string_view name = "Quantity";
  static constexpr auto entries =
      members(field(
                  "value", [](const QuantityIn& q) { return q.quantity.value; }, "", "value, as given")
                  .known(),
              field(
                  "standard_uncertainty", [](const QuantityIn& q) { return q.quantity.uncertainty; }, "",
                  "its standard uncertainty; 0 if none was stated")
                  .known(),
              field("unit", &QuantityIn::unit, "", "unit of both"));
};

/// A straight line with the units of its slope and its intercept.
struct LineIn {
  LineWithErrors line;
  std::string_view slope_unit, unit;
};

template <>
struct Described<LineIn> {
  static constexpr std::string_view name = "Line";
  static constexpr auto entries = members(
      field(
          "slope", [](const LineIn& l) { return l.line.slope; }, "slope_unit", "slope of the straight line"),
      field(
          "slope_standard_error", [](const LineIn& l) { return l.line.slope_error; }, "slope_unit",
          "standard error of the slope"),
      field("slope_unit", &LineIn::slope_unit, "", "unit of the slope"),
      field(
          "intercept", [](const LineIn& l) { return l.line.intercept; }, "intercept_unit",
          "intercept, at no mass"),
      field(
          "intercept_standard_error", [](const LineIn& l) { return l.line.intercept_error; },
          "intercept_unit", "standard error of the intercept"),
      field("intercept_unit", &LineIn::unit, "", "unit of the intercept"),
      field(
          "covariance", [](const LineIn& l) { return l.line.covariance; }, "product of both units",
          "covariance of slope and intercept"),
      field(
          "chi_squared", [](const LineIn& l) { return l.line.chi_squared; }, "",
          "chi squared of the points about the line"),
      field(
          "degrees_of_freedom", [](const LineIn& l) { return l.line.degrees; }, "",
          "degrees of freedom: points less two"),
      field(
          "extra_scatter", [](const LineIn& l) { return l.line.extra_scatter; }, "intercept_unit",
          "scatter of the points beyond their own errors"));
};

template <>
struct Described<Hold> {
  static constexpr std::string_view name = "Hold";
  static constexpr auto entries =
      members(field("file", &Hold::file, "", "name of the file"),
              field("run", &Hold::run, "", "number of the run, from 1"),
              field("from", &Hold::from, "s", "beginning of the time at rest"),
              field("to", &Hold::to, "s", "end of the time at rest"),
              field("samples", &Hold::samples, "", "number of samples at rest"),
              field(
                  "mass",
                  [](const Hold& h) {
                    return QuantityIn{h.mass, "kg"};
                  },
                  "", "mass that hung there"),
              field("position", &Hold::position, "m", "mean position"),
              field("scatter", &Hold::scatter, "m", "standard deviation of the samples"),
              field("standard_error", &Hold::standard_error, "m",
                    "standard error of the mean, with correlation taken into account"));
};

template <>
struct Described<StaticStiffness> {
  using Static = StaticStiffness;
  static constexpr std::string_view name = "StaticStiffness";
  static constexpr auto entries = members(
      field(
          "status", [](const Static&) { return std::string_view("converged"); }, "", "always converged"),
      field(
          "parameters",
          [](const Static& s) {
            return std::vector<Parameter>{{"stiffness", s.stiffness, "N/m"}};
          },
          "", "the spring constant"),
      field(
          "gravity",
          [](const Static& s) {
            return QuantityIn{s.gravity, "m/s²"};
          },
          "", "gravity that was used"),
      field(
          "line",
          [](const Static& s) {
            return LineIn{s.line, "m/kg", "m"};
          },
          "", "straight line of position against mass"),
      field("holds", &Static::holds, "", "the masses at rest"), notices(&Static::notices));
};

template <>
struct Described<MassLinePoint> {
  using Point = MassLinePoint;
  static constexpr std::string_view name = "MassLinePoint";
  static constexpr auto entries =
      members(field("file", &Point::file, "", "name of the file"),
              field("run", &Point::run, "", "number of the run, from 1"),
              field(
                  "mass",
                  [](const Point& p) {
                    return QuantityIn{p.mass, "kg"};
                  },
                  "", "mass that swung"),
              quantity("period_squared", &Point::period_square, "s²", "squared period of the fit"));
};

template <>
struct Described<MassLine> {
  static constexpr std::string_view name = "MassLine";
  static constexpr auto entries =
      members(quantity("stiffness", &MassLine::stiffness, "N/m", "spring constant: 4 pi² over the slope"),
              quantity("effective_mass", &MassLine::effective_mass, "kg",
                       "effective mass of the spring, which swings with the mass"),
              quantity("spring_mass", &MassLine::spring_mass, "kg",
                       "mass of the spring: three times its effective mass"),
              field(
                  "line",
                  [](const MassLine& l) {
                    return LineIn{l.line, "s²/kg", "s²"};
                  },
                  "", "straight line of squared period against mass"),
              field("points", &MassLine::points, "", "the fits"), notices(&MassLine::notices));
};

}  // namespace cromer::core
