// Which samples of a recording a fit sees.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "cromer/read/recording.h"
#include "cromer/result.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// The samples from --from to --to, both included; an Error where none is left.
Result<Series> used_part(const Series& series, const FitOptions& options);

/// What the estimator sees: outliers stay in the series and out of the fit.
struct FittedSamples {
  std::vector<double> t, y;
};
FittedSamples without_outliers(const Series& series);

/// Cuts off what comes after a sensor has lost the motion for good, with a notice.
void leave_lost_motion(Series& series);

/// Flat runs far outside the motion are no motion: they join the outliers, with a notice.
void set_drop_outs_aside(Series& series);

/// Samples that the fit itself set aside (indices into those it saw) join the outliers too.
void list_outliers(Series& series, const FittedSamples& samples, const std::vector<std::size_t>& aside,
                   std::vector<Notice>& notices);

/// Which derivative of the displacement or angle a quantity is: -1 where that is not known to be any.
int derivative_order(std::string_view quantity);

/// Of a length or a quantity unknown, not of an angle.
bool is_linear_quantity(std::string_view quantity);

/// What a column holds, as a part of a sentence.
Notice kind_of(std::string_view quantity);

/// That a column of velocities or accelerations is no displacement.
Notice fitted_as_it_is(std::string_view quantity, std::string_view column);

}  // namespace cromer::core
