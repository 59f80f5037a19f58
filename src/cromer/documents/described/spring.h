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
                  "value", [](const QuantityIn& q) { return q.quantity.value; }, "", "as given")
                  .known(),
              field(
                  "standard_uncertainty", [](const QuantityIn& q) { return q.quantity.uncertainty; }, "",
                  "0 where none was stated")
                  .known(),
              field("unit", &QuantityIn::unit, "", "of both"));
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
          "slope", [](const LineIn& l) { return l.line.slope; }, "slope_unit", "of the straight line"),
      field(
          "slope_standard_error", [](const LineIn& l) { return l.line.slope_error; }, "slope_unit",
          "of the slope"),
      field("slope_unit", &LineIn::slope_unit, "", "of the slope"),
      field(
          "intercept", [](const LineIn& l) { return l.line.intercept; }, "intercept_unit", "at no mass"),
      field(
          "intercept_standard_error", [](const LineIn& l) { return l.line.intercept_error; },
          "intercept_unit", "of the intercept"),
      field("intercept_unit", &LineIn::unit, "", "of the intercept"),
      field(
          "covariance", [](const LineIn& l) { return l.line.covariance; }, "product of both units",
          "of slope and intercept"),
      field(
          "chi_squared", [](const LineIn& l) { return l.line.chi_squared; }, "", "of the points about it"),
      field(
          "degrees_of_freedom", [](const LineIn& l) { return l.line.degrees; }, "", "points less two"),
      field(
          "extra_scatter", [](const LineIn& l) { return l.line.extra_scatter; }, "intercept_unit",
          "what the points scatter beyond their own errors"));
};

template <>
struct Described<Hold> {
  static constexpr std::string_view name = "Hold";
  static constexpr auto entries =
      members(field("file", &Hold::file, "", "where it was recorded"), field("run", &Hold::run, "", "from 1"),
              field("from", &Hold::from, "s", "where the rest begins"),
              field("to", &Hold::to, "s", "where it ends"), field("samples", &Hold::samples, "", "of it"),
              field(
                  "mass",
                  [](const Hold& h) {
                    return QuantityIn{h.mass, "kg"};
                  },
                  "", "that hung there"),
              field("position", &Hold::position, "m", "mean of the samples"),
              field("scatter", &Hold::scatter, "m", "their standard deviation"),
              field("standard_error", &Hold::standard_error, "m", "of the mean, widened for correlation"));
};

template <>
struct Described<StaticStiffness> {
  using Static = StaticStiffness;
  static constexpr std::string_view name = "StaticStiffness";
  static constexpr auto entries = members(
      field(
          "status", [](const Static&) { return std::string_view("converged"); }, "", "there is a line"),
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
          "", "that was taken"),
      field(
          "line",
          [](const Static& s) {
            return LineIn{s.line, "m/kg", "m"};
          },
          "", "position against mass"),
      field("holds", &Static::holds, "", "the masses at rest"), notices(&Static::notices));
};

template <>
struct Described<MassLinePoint> {
  using Point = MassLinePoint;
  static constexpr std::string_view name = "MassLinePoint";
  static constexpr auto entries = members(field("file", &Point::file, "", "where it was recorded"),
                                          field("run", &Point::run, "", "from 1"),
                                          field(
                                              "mass",
                                              [](const Point& p) {
                                                return QuantityIn{p.mass, "kg"};
                                              },
                                              "", "that swung"),
                                          field(
                                              "period_squared",
                                              [](const Point& p) {
                                                return Parameter{"", p.period_square, "s²"};
                                              },
                                              "", "of the fit"));
};

template <>
struct Described<MassLine> {
  static constexpr std::string_view name = "MassLine";
  static constexpr auto entries =
      members(field(
                  "stiffness",
                  [](const MassLine& l) {
                    return Parameter{"", l.stiffness, "N/m"};
                  },
                  "", "4 pi² over the slope"),
              field(
                  "effective_mass",
                  [](const MassLine& l) {
                    return Parameter{"", l.effective_mass, "kg"};
                  },
                  "", "of the spring, that swings with the mass"),
              field(
                  "spring_mass",
                  [](const MassLine& l) {
                    return Parameter{"", l.spring_mass, "kg"};
                  },
                  "", "three times that"),
              field(
                  "line",
                  [](const MassLine& l) {
                    return LineIn{l.line, "s²/kg", "s²"};
                  },
                  "", "period squared against mass"),
              field("points", &MassLine::points, "", "the fits"), notices(&MassLine::notices));
};

}  // namespace cromer::core
