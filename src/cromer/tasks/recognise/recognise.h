// Task: which method, with which step, made the states in a file.
//
// A method with a step makes each row of the next from the one before. So every method runs the law from the
// first row, with the spacing of the rows divided into 1, 2, 3, ... steps, and what is left between its
// states and the rows says whether it made them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/methods/method_settings.h"
#include "cromer/notice.h"
#include "cromer/read/recording.h"
#include "cromer/result.h"
#include "cromer/tasks/methods/methods.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// What `cromer methods` takes with --recognise.
struct RecogniseOptions {
  std::string recognise{};                  ///< the file: time, position and velocity
  std::string column{}, velocity_column{};  ///< of position and velocity; "": found
  std::optional<int> run{};                 ///< of several in the file, from 1
  MethodsOptions methods{};    ///< step, beta, gamma, rho-inf; natural frequency and damping ratio
  SimulateOptions simulate{};  ///< the law alone
  ReadOptions read{};
  bool about_a_run = false;  ///< an option was given that only a file to recognise has a use for
};

/// A method with a step, and what it is to the rows.
struct RecognisedMethod {
  std::string_view method;                 ///< the first in the registry of those with the same map
  std::vector<std::string_view> same_map;  ///< the others
  std::optional<double> step{};  // [s] empty where the states are the law's own: no step shows in them
  long long steps_per_row = 1;
  bool velocity_ahead = false;               ///< the velocity of a row is that of one step later
  double distance = 0;                       ///< rms of what is left, over the rms of the motion
  std::optional<double> decay_rate_added{};  // [1/s] simulated less the law's; empty if nothing swings
  std::optional<double> frequency_shift{};   // [rad/s] likewise
};

/// What there is to say of the best one.
enum class Verdict {
  made,       ///< it made the rows
  the_law,    ///< the rows follow the law itself: no method's error shows in their digits
  other_law,  ///< no method made them from the law given, one did from `law`
  none        ///< no method made them
};

struct RecogniseResult {
  std::string file;
  std::size_t rows = 0;    ///< that were compared
  double spacing = 0;      // [s] of the rows
  double rounding = 0;     ///< the distance that the rounding of the file alone makes
  Oscillator<double> law;  ///< as given, or as fitted
  bool law_fitted = false;
  std::optional<double> natural_frequency{};  // [rad/s] of the law; empty where nothing pulls back
  std::optional<double> damping_ratio{};      ///< likewise
  Verdict verdict = Verdict::none;
  std::vector<RecognisedMethod> recognised;  ///< the nearest, nearest first
  std::size_t alike = 1;                     ///< so many of them the digits of the file do not tell apart
  Notice words{};                            ///< the answer in a sentence or two
  std::vector<Notice> notices{};

  bool ok() const { return verdict == Verdict::made || verdict == Verdict::the_law; }
};

/// Without a file to recognise: an Error if options were given that are about one.
Result<void> only_with_file(const RecogniseOptions& options);

/// Reads the rows of the recording and runs all methods. An Error names column, option and cure.
Result<RecogniseResult> recognise(const Recording& recording, const RecogniseOptions& options,
                                  const Watch& watch = {});

}  // namespace cromer::core
