#include "cromer/tasks/fit/mass_line.h"

#include <cmath>

#include "cromer/base/pi.h"
#include "cromer/identify/least_squares/uncertainty.h"

namespace cromer::core {

Result<MassLine> mass_line(const std::vector<FittedRecording>& fits, const std::vector<Quantity>& masses) {
  if (fits.size() != masses.size())
    return Error{"masses_unlike_recordings", {{"masses", masses.size()}, {"recordings", fits.size()}}};
  MassLine result;
  std::vector<UncertainPoint> points;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const FittedRecording& fitted = fits[i];
    if (!fitted.succeeded()) {
      result.notices.push_back(
          Notice{"run_left_out_of_line",
                 {{"file", fitted.file}, {"run", fitted.series.run}, {"why", fitted.fit.message}}});
      continue;
    }
    const Estimate w = fitted.fit.angular_frequency();
    const double T2 = two_pi * two_pi / (w.value * w.value);
    const Estimate square = make_estimate(T2, 2 * T2 * w.standard_error / w.value, fitted.fit.student);
    result.points.push_back({fitted.file, fitted.series.run, masses[i], square});
    points.push_back({masses[i].value, T2, masses[i].uncertainty, square.standard_error});
  }
  const auto line = fit_line_with_errors(points);
  if (!line) return Error{"mass_line_of_one_mass"};
  if (!(line->slope > 0)) return Error{"period_does_not_grow"};
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
  if (points.size() == 2) result.notices.push_back(Notice{"line_of_two"});
  if (line->extra_scatter > 0)
    result.notices.push_back(
        Notice{"points_scatter", {{"scatter", line->extra_scatter}, {"degrees", line->degrees}}});
  return result;
}

}  // namespace cromer::core
