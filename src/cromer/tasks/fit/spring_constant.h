// The spring constant from several masses: how far they stretch the spring at rest, and how their periods
// grow.
//
//   static   extension = extension_0 + (g/k) mass
//   moving   T0^2 = (4 pi^2/k)(mass + m_e)
//
// T0 is the undamped period, so that damping does not bend the line. m_e is what moves along with the mass, a
// third of the spring's own: the line's intercept over its slope.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/analysis/ground_motion.h"
#include "cromer/analysis/line.h"
#include "cromer/base/quantity.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// A mass at rest: the mean of its samples.
struct Hold {
  std::string file;
  int run = 1;
  double from = 0, to = 0;  // [s]
  std::size_t samples = 0;
  double position = 0;        // [m]
  double scatter = 0;         // [m] standard deviation of the samples
  double standard_error = 0;  // [m] of the mean, widened for correlation
  bool moves = false;         ///< slowly, as a swing does; noise changes from sample to sample
  double drift = 0;           // [m] from the first sample to the last, where it is none by chance
  std::size_t set_aside = 0;  ///< of the samples: they lie far from all others
  Quantity mass;              // [kg]
};

struct StaticStiffness {
  std::vector<Hold> holds;
  LineWithErrors line;  ///< position [m] against mass [kg]
  Estimate stiffness;   // [N/m]
  Quantity gravity;     // [m/s²]
  std::vector<Notice> notices;
};

/// How many levels a series of positions rests at, one after the other and most of the time; 0 if it moves.
std::size_t levels_at_rest(const Series& series);

/// The samples at rest, in the order of `masses`: one hold for each run or, of a single run, one for each
/// plateau. A column that is no position is an Error, and so is another number of runs or plateaus than of
/// masses.
Result<std::vector<Hold>> find_holds(const std::vector<Series>& runs, std::string_view file,
                                     const std::vector<Quantity>& masses);

/// Fits a line, weighted, with errors in both coordinates. Scatter beyond the errors of the means (hooking
/// masses on, friction, creep) is estimated from the line and added; with three masses that rests on one
/// degree of freedom, and the interval is as wide. Fewer than two holds, or all masses alike, are Errors.
Result<StaticStiffness> static_stiffness(std::vector<Hold> holds, const Quantity& gravity);

/// What the line leaves of a hold [m].
double residual_of(const StaticStiffness& found, const Hold& hold);

/// [m] The standard uncertainty of its position, with the scatter that was added.
double error_about_line(const StaticStiffness& found, const Hold& hold);

struct StaticOptions {
  FitOptions fit{};                       ///< reading, column, run, from and to are used
  std::vector<Quantity> masses{};         // [kg] >= 0; one for each hold
  Quantity gravity{standard_gravity, 0};  // [m/s²] > 0
};

/// Takes the holds in the order of the files and their runs; a single file of one run may hold several
/// plateaus. Files without times need no rate. Bad input is an Error.
Result<StaticStiffness> fit_static(const std::vector<Recording>& recordings, const StaticOptions& options);

struct MassLinePoint {
  std::string file;
  int run = 1;
  Quantity mass;           // [kg]
  Estimate period_square;  // [s²]
};

struct MassLine {
  std::vector<MassLinePoint> points;
  LineWithErrors line;      ///< period squared [s²] against mass [kg]
  Estimate stiffness;       // [N/m]
  Estimate effective_mass;  // [kg] m_e
  Estimate spring_mass;     // [kg] 3 m_e
  std::vector<Notice> notices;
};

/// `masses` has one for each fit, in their order. Fits that did not succeed are left out, with a notice.
/// Errors: another number of masses than of fits, fewer than two different masses left, periods that do not
/// grow.
Result<MassLine> mass_line(const std::vector<FittedRecording>& fits, const std::vector<Quantity>& masses);

}  // namespace cromer::core
