// Which samples of a recording a fit sees.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "cromer/identify/diagnose/slip.h"
#include "cromer/identify/record.h"
#include "cromer/read/recording.h"
#include "cromer/result.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// The samples from --from to --to, both included; an Error if none is left.
Result<Series> used_part(Series series, const FitOptions& options);

/// The samples from --from to --to. If neither is given, the series ends where a sensor has lost the motion
/// for good. Drop-outs join the outliers. An Error if no sample is left.
Result<Series> samples_in_use(Series series, const FitOptions& options);

/// The series with the slip taken out of its times. Samples that were told twice are left out.
Series without_slip(Series series, const TimeSlip& slip);

/// The row of a fit before it is fitted: `used` are the samples in use of `series`, with their notices.
FittedRecording row_to_fit(const Series& series, Series used, std::string_view file,
                           const FitOptions& options);

/// The samples that the fit sees: outliers stay in the series, but are not fitted.
struct FittedSamples {
  std::vector<double> t, y;
};
FittedSamples without_outliers(const Series& series);

/// What a fit sees of a series: `t` and `y` are samples of it, and outlive the record.
Record record_of(const Series& series, std::span<const double> t, std::span<const double> y);

/// Adds the samples that the fit itself set aside (indices into `samples`) to the outliers, with a notice.
void list_outliers(Series& series, const FittedSamples& samples, const std::vector<std::size_t>& aside,
                   std::vector<Notice>& notices);

/// Which derivative of a displacement or an angle the quantity is; -1 if it is none, or not known.
int derivative_order(std::string_view quantity);

/// Whether the quantity is a length, a derivative of one, or not known; false for angles.
bool is_linear_quantity(std::string_view quantity);

/// The notice that a column of velocities or accelerations is fitted as what it is.
Notice fitted_as_it_is(std::string_view quantity, std::string_view column);

}  // namespace cromer::core
