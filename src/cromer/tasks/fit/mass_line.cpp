#include "cromer/tasks/fit/mass_line.h"

#include <fmt/format.h>

#include <cmath>

#include "cromer/base/pi.h"
#include "cromer/identify/least_squares/uncertainty.h"

namespace cromer::core {

Result<MassLine> mass_line(const std::vector<FittedRecording>& fits, const std::vector<Quantity>& masses) {
  if (fits.size() != masses.size())
    return Error{
        fmt::format("--masses: {} masses are given for {} recording{}; each recording, and each run in one, "
                    "needs its own",
                    masses.size(), fits.size(), fits.size() == 1 ? "" : "s")};
  MassLine result;
  std::vector<UncertainPoint> points;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const FittedRecording& fitted = fits[i];
    if (!fitted.succeeded()) {
      result.warnings.push_back(fmt::format("{}, run {} is left out of the line: {}", fitted.file,
                                            fitted.series.run, fitted.fit.message));
      continue;
    }
    const Estimate w = fitted.fit.angular_frequency();
    const double T2 = two_pi * two_pi / (w.value * w.value);
    const Estimate square = make_estimate(T2, 2 * T2 * w.standard_error / w.value, fitted.fit.student);
    result.points.push_back({fitted.file, fitted.series.run, masses[i], square});
    points.push_back({masses[i].value, T2, masses[i].uncertainty, square.standard_error});
  }
  const auto line = fit_line_with_errors(points);
  if (!line) return Error{"--mass-line needs at least two recordings of different masses"};
  if (!(line->slope > 0))
    return Error{
        "--mass-line: the period does not grow with the mass; are --masses in the order of the recordings?"};
  result.line = *line;
  const double t = line->extra_scatter > 0 ? student_95(line->degrees) : student_95(1e9);
  const double s = line->slope, a = line->intercept, k = two_pi * two_pi / s;
  result.stiffness = make_estimate(k, k * line->slope_error / s, t);
  const double by_a = 1 / s, by_s = -a / (s * s);
  const double variance = by_a * by_a * line->intercept_error * line->intercept_error +
                          by_s * by_s * line->slope_error * line->slope_error +
                          2 * by_a * by_s * line->covariance;
  const double error = std::sqrt(std::max(0.0, variance));
  result.effective_mass = make_estimate(a / s, error, t);
  result.spring_mass = make_estimate(3 * a / s, 3 * error, t);
  if (points.size() == 2)
    result.warnings.emplace_back("two masses give a line whatever they are: nothing shows whether it is one");
  if (line->extra_scatter > 0)
    result.warnings.push_back(
        fmt::format("the points scatter about the line by {:.2g} s², more than their errors say: this is "
                    "added to all, and the "
                    "intervals are those of {} degree{} of freedom",
                    line->extra_scatter, line->degrees, line->degrees == 1 ? "" : "s"));
  return result;
}

}  // namespace cromer::core
