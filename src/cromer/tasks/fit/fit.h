// Task: from a recording to the law of motion and what follows from it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/analysis/textbook_damping.h"
#include "cromer/base/interrupt.h"
#include "cromer/base/quantity.h"
#include "cromer/identify/choose/kind_of_motion.h"
#include "cromer/identify/diagnose/mean_decay.h"
#include "cromer/identify/law_fit.h"
#include "cromer/read/recording.h"
#include "cromer/result.h"
#include "cromer/tasks/fit/decay_rates.h"
#include "cromer/tasks/fit/fitted_quantities.h"
#include "cromer/tasks/fit/law_doubt.h"
#include "cromer/tasks/fit/plan_recording.h"
#include "cromer/tasks/fit/stiffness_budget.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {

struct FitOptions {
  ReadOptions read{};
  std::string column{};
  std::optional<int> run{};            ///< from 1; all runs when not given
  std::optional<double> from{}, to{};  // [s]
  std::string law = "auto";
  bool no_spring = false;                   ///< a body without a spring, under a recorded force
  double hysteresis_exponent = 1;           ///< >= 1
  std::vector<Quantity> mass{};             // [kg] > 0; one, or one for each run
  std::optional<Quantity> spring_mass{};    // [kg] >= 0; a third of it is added
  std::optional<Quantity> disc_diameter{};  // [m] > 0
  std::optional<Quantity> temperature{};    // [K] of the air; 293.15 by default
  std::optional<double> segment{};          // [s] > 0
  std::optional<int> segments{};            ///< > 0
  std::string force_column{};               ///< of a recorded force; "" if there is none
  std::string between_samples{};            ///< linear, hold, band-limited or auto; "" is auto
  std::string drive_frequency{};  ///< of a harmonic drive, with its unit, or auto; "" if there is none
  bool recognise_drive = true;    ///< a motion that is not free may be fitted as a driven one
  std::optional<double>
      hold_out{};      ///< share of the samples, above 0 to 0.9: the last ones, kept out of the fit
  std::string goal{};  ///< "decay_rate 0.5 %": how long to record
  std::optional<int> monte_carlo{};  ///< trials, 1000 to 1e7
  unsigned long long seed = 1;       ///< of the trials
  bool seed_given = false;
  bool textbook = false;  ///< also the damping by decrement and bandwidth
};

/// The damping by the textbook methods; empty where a method does not apply.
struct TextbookDamping {
  static Notice decrement_bias() { return Notice{"decrement_bias"}; }
  static Notice bandwidth_bias() { return Notice{"bandwidth_bias"}; }
  std::optional<PeakDecrement> decrement;
  std::optional<HalfPowerBandwidth> bandwidth;
};

/// The largest Reynolds number within [t, t + 0.5 s).
struct ReynoldsWindow {
  double t;  // [s]
  double value;
};

struct Candidate {
  Law law;
  double rms;
  double bic;
  bool converged;
  double angular_frequency = 0;   // [rad/s] of small swings
  std::string between_samples{};  ///< how a recorded force was read between samples; "" without one
};

/// The fitted motion of a driven law at the series' times.
struct DrivenMotion {
  std::vector<double> motion;  ///< in the SI unit of the column
  Trajectory states;           ///< displacement from the equilibrium and velocity
};

/// How well the law predicts the samples that were held out of the fit.
struct HeldOut {
  double from, to;  // [s]
  std::size_t samples;
  double rms;                                  ///< in the SI unit of the column
  std::vector<double> t{}, measured{}, law{};  ///< at each of them; [s], SI unit of the column
};

/// Samples outside the part that is used; [s], SI unit of the column.
struct LeftOut {
  std::vector<double> t{}, y{};
};

struct FittedRecording {
  std::string file;
  bool of_arrays = false;   ///< handed over as arrays: `file` is only what to call them
  Series series;            ///< the samples used, in SI units
  LeftOut left_out{};       ///< before and after them; empty unless a file was fitted
  std::size_t samples = 0;  ///< in the file
  FitOptions options;
  LawFit fit;
  std::vector<Parameter> parameters;  ///< as fitted_parameters() orders them, then force_parameters()
  std::vector<Parameter> derived;
  std::vector<LawDoubt> law_doubts{};  ///< those that are in parameters, derived and headline
  std::vector<Parameter> headline;     ///< what is looked for first, as far as it is known: headline_of()
  std::vector<TypedOption> simulate;   ///< options of simulate for this law
  std::vector<Candidate> candidates;
  std::vector<DecaySegment> segments;
  std::optional<Estimate> decay_rate_mean;
  std::vector<ReynoldsWindow> reynolds;
  std::optional<Estimate> reynolds_max;
  double reynolds_max_t = 0;                   // [s]
  std::optional<Estimate> keulegan_carpenter;  ///< 2 pi A/D at the largest amplitude
  std::vector<AmplitudeRate> decay_by_amplitude;
  std::optional<MeanDecay> common_decay{};  ///< at the rms amplitude, beside laws that fit as well
  std::vector<Contribution> stiffness_budget;
  std::optional<MonteCarlo> monte_carlo;
  std::optional<RecordingPlan> plan;
  std::optional<TextbookDamping> textbook;
  std::optional<DrivenMotion> driven{};  ///< of a motion under a force, recorded or harmonic
  std::vector<Mode> modes{};             ///< if two oscillations were found; the larger first
  std::string between_samples{};         ///< how the recorded force is read; "" without one
  std::optional<HeldOut> held_out{};
  std::vector<Notice> notices;
  std::vector<Notice> doubts{};  ///< of a free motion: those of the notices on whether the law describes it
  std::size_t of_file = 0;       ///< so many of the notices, the first ones, are about the whole file
  std::size_t of_record =
      0;  ///< so many, the first ones as the task found them, with those of the file, are about the record
  bool one_of_several = false;  ///< other runs of the file were fitted beside it
  bool wrong_input = false;     ///< the run could not be read: only file, run and the fit's message are set

  /// Number of samples that the fit used: those of the series that are no outliers.
  std::size_t used() const;
  bool succeeded() const { return fit.status == FitStatus::converged; }
  std::string_view status() const { return wrong_input ? "wrong_input" : name(fit.status); }

  const Estimate* find(std::string_view name) const;  ///< among parameters and derived; nullptr if absent
  bool says(std::string_view code) const;             ///< whether one of its notices has this code
};

/// Checks what can be checked of the options without a recording: the range of each, what they require of
/// each other, and the law's name. An Error names option, value and constraint.
Result<void> check_fit_options(const FitOptions& options);

/// The row of a recording that could not be read. Its message is `why` without the file's name.
FittedRecording not_fitted(std::string_view file, int run, const Notice& why);

/// Fits one quantity of one run, from --from to --to, as a free motion. Bad input (a law that cannot be
/// fitted, no sample left) is an Error.
Result<FittedRecording> fit_series(const Series& series, std::string_view file, const FitOptions& options,
                                   const Watch& watch = {});

/// Fits every run that the options ask for. Bad input is an Error. A failed fit is a status in its row; so is
/// a run that could not be read, if others could.
Result<std::vector<FittedRecording>> fit(const Recording& recording, const FitOptions& options,
                                         const Watch& watch = {});

}  // namespace cromer::core
