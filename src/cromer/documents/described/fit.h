// What the document of `fit` consists of.
#pragma once

#include "cromer/documents/described/describe.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/fit/lab_quantities.h"
#include "cromer/tasks/fit/law_doubt.h"

namespace cromer::core {

/// The SI unit of the recorded quantity.
inline constexpr std::string_view unit_of_column = "of the column";

/// The recording that a fit was made from.
struct FittedFrom {
  const FittedRecording& fitted;

  const Series& series() const { return fitted.series; }
  std::optional<double> first() const {
    return series().t.empty() ? std::nullopt : std::optional(series().t.front());
  }
  std::optional<double> last() const {
    return series().t.empty() ? std::nullopt : std::optional(series().t.back());
  }
};

template <>
struct Described<FittedFrom> {
  static constexpr std::string_view name = "Recording";
  static constexpr auto entries = members(
      field(
          "file", [](const FittedFrom& r) -> const std::string& { return r.fitted.file; }, "",
          "name of the file"),
      field(
          "column", [](const FittedFrom& r) { return unless_empty(r.series().column); }, "",
          "title of the fitted column, as in the file; only if it was read")
          .left_out(),
      field(
          "observed", [](const FittedFrom& r) { return unless_empty(r.series().quantity); }, "",
          "the recorded quantity: position, angle, velocity, ...; null if not known"),
      field(
          "run", [](const FittedFrom& r) { return r.series().run; }, "",
          "number of the run in the file, from 1"),
      field(
          "samples", [](const FittedFrom& r) { return r.fitted.samples; }, "",
          "number of samples in the file"),
      field(
          "used", [](const FittedFrom& r) { return r.fitted.used(); }, "", "number of fitted samples"),
      field("from", &FittedFrom::first, "s", "time of the first sample used"),
      field("to", &FittedFrom::last, "s", "time of the last sample used"),
      field(
          "rate", [](const FittedFrom& r) { return unless_zero(r.series().rate); }, "1/s",
          "samples per second; null if their spacing is not even"),
      field(
          "duration",
          [](const FittedFrom& r) -> std::optional<double> {
            if (r.series().t.empty()) return std::nullopt;
            return *r.last() - *r.first();
          },
          "s", "from the first sample used to the last"),
      field(
          "gaps", [](const FittedFrom& r) { return r.series().gaps.size(); }, "",
          "number of gaps, where samples are missing"),
      field(
          "outliers", [](const FittedFrom& r) { return r.series().outliers.size(); }, "",
          "number of samples set aside"));
};

template <>
struct Described<Residual> {
  static constexpr std::string_view name = "Residual";
  static constexpr auto entries = members(
      field("rms", &Residual::rms, unit_of_column,
            "root mean square of the residuals, over the samples used without outliers"),
      field("normality", &Residual::normality, "", "p value of the Jarque-Bera test"),
      field("autocorrelation", &Residual::autocorrelation, "", "correlation of neighbouring residuals"),
      field("white", &Residual::white, "", "no correlation up to lag 20 is found (Ljung-Box test at 1 %)"));
};

template <>
struct Described<Candidate> {
  static constexpr std::string_view name = "Candidate";
  static constexpr auto entries =
      members(field(
                  "law", [](const Candidate& c) { return to_text(c.law); }, "", "a law that was tried"),
              field("rms", &Candidate::rms, unit_of_column,
                    "rms of its residuals; of a law that is clearly worse, fitted in coarse steps, to about "
                    "a thousandth"),
              field("bic", &Candidate::bic, "", "Bayesian information criterion; smaller is better"),
              field(
                  "between_samples", [](const Candidate& c) { return unless_empty(c.between_samples); }, "",
                  "interpolation of a recorded force; only with one")
                  .left_out());
};

template <>
struct Described<Mode> {
  static constexpr std::string_view name = "Mode";
  static constexpr auto entries = members(
      field(
          "angular_frequency", [](const Mode& m) { return m.angular_frequency.value; }, "rad/s",
          "damped angular frequency")
          .known(),
      field(
          "angular_frequency_standard_error",
          [](const Mode& m) { return m.angular_frequency.standard_error; }, "rad/s", "its standard error"),
      field(
          "decay_rate", [](const Mode& m) { return m.decay_rate.value; }, "1/s",
          "decay rate; negative if the mode grows")
          .known(),
      field(
          "decay_rate_standard_error", [](const Mode& m) { return m.decay_rate.standard_error; }, "1/s",
          "its standard error"),
      field("amplitude", &Mode::amplitude, unit_of_column, "amplitude at the first sample").known(),
      field("amplitude_standard_error", &Mode::amplitude_error, unit_of_column, "its standard error"));
};

template <>
struct Described<HeldOut> {
  static constexpr std::string_view name = "HeldOut";
  static constexpr auto entries =
      members(field("from", &HeldOut::from, "s", "time of the first sample held out").known(),
              field("to", &HeldOut::to, "s", "time of the last one").known(),
              field("samples", &HeldOut::samples, "", "number of samples held out"),
              field("rms", &HeldOut::rms, unit_of_column, "rms of their residuals under the fitted law"));
};

template <>
struct Described<DecaySegment> {
  static constexpr std::string_view name = "DecaySegment";
  static constexpr auto entries =
      members(field("from", &DecaySegment::from, "s", "where the segment begins").known(),
              field("to", &DecaySegment::to, "s", "where it ends").known(),
              estimated("rate", &DecaySegment::rate, "1/s", "decay rate fitted to this segment alone"));
};

template <>
struct Described<AmplitudeRate> {
  static constexpr std::string_view name = "AmplitudeRate";
  static constexpr auto entries =
      members(field("amplitude", &AmplitudeRate::amplitude, "of the displacement",
                    "amplitude in the middle of the stretch")
                  .known(),
              estimated("rate", &AmplitudeRate::rate, "1/s",
                        "decay rate by a fit to this stretch alone, beside the law's course within it")
                  .with_interval(),
              field("law_rate", &AmplitudeRate::law_rate, "1/s",
                    "rate at which the fitted law's amplitude falls there, averaged over a cycle"),
              estimated("angular_frequency", &AmplitudeRate::angular_frequency, "rad/s",
                        "angular frequency by that fit")
                  .with_error("angular_frequency_standard_error"),
              field("law_angular_frequency", &AmplitudeRate::law_angular_frequency, "rad/s",
                    "angular frequency of the fitted law's swings of that amplitude"),
              field("from", &AmplitudeRate::from, "s", "where the stretch begins").known(),
              field("to", &AmplitudeRate::to, "s", "where it ends").known());
};

template <>
struct Described<ReynoldsWindow> {
  static constexpr std::string_view name = "ReynoldsWindow";
  static constexpr auto entries =
      members(field("t", &ReynoldsWindow::t, "s", "where the half second begins").known(),
              field("value", &ReynoldsWindow::value, "", "largest Reynolds number in it").known());
};

template <>
struct Described<Contribution> {
  static constexpr std::string_view name = "Contribution";
  static constexpr auto entries = members(
      field("quantity", &Contribution::quantity, "",
            "what contributes: mass, spring_mass or angular_frequency"),
      field("value", &Contribution::value, "its own", "value used").known(),
      field("standard_uncertainty", &Contribution::standard_uncertainty, "its own",
            "standard uncertainty of that value"),
      field("unit", &Contribution::unit, "", "unit of both"),
      field("sensitivity", &Contribution::sensitivity, "N/m per its own",
            "derivative of the spring constant by this quantity"),
      field("contribution", &Contribution::contribution, "N/m",
            "its part of the standard uncertainty of the spring constant"),
      field("share", &Contribution::share, "", "its share of the variance of the spring constant, 0 to 1"));
};

template <>
struct Described<RecordingPlan> {
  static constexpr std::string_view name = "RecordingPlan";
  static constexpr auto entries = members(
      field("quantity", &RecordingPlan::quantity, "", "the quantity of the goal"),
      field("unit", &RecordingPlan::unit, "", "its unit"),
      field("goal", &RecordingPlan::goal, "its own", "wanted standard uncertainty").known(),
      field("now", &RecordingPlan::now, "its own", "standard uncertainty of this record").known(),
      field("met", &RecordingPlan::met, "", "whether this record is long enough"),
      field("possible", &RecordingPlan::possible, "",
            "whether a longer record from the same start reaches the goal"),
      field("duration", &RecordingPlan::duration, "s",
            "duration that reaches the goal; if none does, the duration beyond which nothing is gained"),
      field(
          "best", [](const RecordingPlan& p) { return p.possible ? std::nullopt : std::optional(p.best); },
          "its own", "only if it is not possible: standard uncertainty of the longest useful record"),
      field("text", &RecordingPlan::text, "", "the plan in a sentence"));
};

template <>
struct Described<PeakDecrement> {
  static constexpr std::string_view name = "PeakDecrement";
  static constexpr auto entries =
      members(estimated(
                  "value",
                  [](const PeakDecrement& p) {
                    return Estimate{p.value, p.standard_error};
                  },
                  "", "logarithmic decrement per period, from the peaks"),
              field("peaks", &PeakDecrement::peaks, "", "number of peaks above the noise"),
              field(
                  "bias", [](const PeakDecrement&) { return TextbookDamping::decrement_bias(); }, "",
                  "what is wrong with this method"));
};

template <>
struct Described<HalfPowerBandwidth> {
  static constexpr std::string_view name = "HalfPowerBandwidth";
  static constexpr auto entries =
      members(field("value", &HalfPowerBandwidth::width, "rad/s", "full width of the line in the spectrum"),
              field(
                  "unit", [](const HalfPowerBandwidth&) { return std::string_view("rad/s"); }, "",
                  "unit of the width"),
              field(
                  "decay_rate", [](const HalfPowerBandwidth& line) { return line.width / 2; }, "1/s",
                  "half the width"),
              field(
                  "damping_ratio",
                  [](const HalfPowerBandwidth& line) { return line.width / (2 * line.angular_frequency); },
                  "", "decay rate over the frequency of the line"),
              field("narrowest", &HalfPowerBandwidth::narrowest, "rad/s",
                    "width of an undamped line in a record of this length"),
              field(
                  "bias", [](const HalfPowerBandwidth&) { return TextbookDamping::bandwidth_bias(); }, "",
                  "what is wrong with this method"));
};

template <>
struct Described<TextbookDamping> {
  static constexpr std::string_view name = "Textbook";
  static constexpr auto entries =
      members(field("logarithmic_decrement", &TextbookDamping::decrement, "",
                    "by the peaks; null with fewer than 3 of them"),
              field("half_power_bandwidth", &TextbookDamping::bandwidth, "",
                    "by the spectrum; null if the line does not fall to half its power on both sides"));
};

/// A spring constant with its uncertainty by Monte Carlo trials and by propagation.
struct DrawnStiffness {
  MonteCarlo trials;
  Estimate propagated;
};

template <>
struct Described<DrawnStiffness> {
  using Drawn = DrawnStiffness;
  static constexpr std::string_view name = "MonteCarlo";
  static constexpr auto entries = members(
      field(
          "quantity", [](const Drawn&) { return std::string_view("stiffness"); }, "",
          "the quantity of the trials"),
      field(
          "trials", [](const Drawn& d) { return d.trials.trials; }, "", "number of trials"),
      field(
          "seed", [](const Drawn& d) { return d.trials.seed; }, "", "seed of the random numbers"),
      field(
          "mean", [](const Drawn& d) { return d.trials.mean; }, "N/m", "mean of the trials")
          .known(),
      field(
          "standard_deviation", [](const Drawn& d) { return d.trials.standard_deviation; }, "N/m",
          "standard deviation of the trials")
          .known(),
      field(
          "interval_95",
          [](const Drawn& d) {
            return Pair{d.trials.low, d.trials.high};
          },
          "N/m", "interval with 95 % of the trials, and as many below it as above")
          .known(),
      group("propagated", "the same by propagation of uncertainty",
            members(estimated("value", &Drawn::propagated, "N/m", "spring constant").with_interval())),
      field(
          "unit", [](const Drawn&) { return std::string_view("N/m"); }, "", "unit of all of these"));
};

inline std::optional<DrawnStiffness> drawn_stiffness(const FittedRecording& fitted) {
  const Estimate* stiffness = fitted.find("stiffness");
  if (!fitted.monte_carlo || !stiffness) return std::nullopt;
  return DrawnStiffness{*fitted.monte_carlo, *stiffness};
}

/// The covariance matrix, row by row.
inline std::vector<std::vector<double>> covariance_rows(const FittedRecording& fitted) {
  std::vector<std::vector<double>> rows;
  const std::vector<double> covariance = covariance_with_doubts(fitted);
  const auto n = static_cast<std::ptrdiff_t>(fitted.fit.names.size());
  for (auto row = covariance.begin(); static_cast<std::ptrdiff_t>(rows.size()) < n; row += n)
    rows.emplace_back(row, row + n);
  return rows;
}

/// If the recording could not be read, only file, run, status and message are known.
template <>
struct Described<FittedRecording> {
  using Fitted = FittedRecording;
  static constexpr std::string_view name = "FittedRecording";
  static bool is_refused(const Fitted& f) { return f.wrong_input; }
  static constexpr auto refused = members(
      field(
          "recording", [](const Fitted& f) { return FittedFrom{f}; }, "", "the fitted recording")
          .unnamed(),
      field(
          "law",
          [](const Fitted& f) { return f.wrong_input ? std::nullopt : std::optional(to_text(f.fit.law)); },
          "", "terms of the law, \"viscous+drag\"; null if the recording could not be read"),
      field("status", &Fitted::status, "", "converged, or why there is no fit").not_in_study(),
      field(
          "message",
          [](const Fitted& f) { return f.succeeded() ? std::nullopt : std::optional(f.fit.message); }, "",
          "why there is no fit; only then")
          .left_out()
          .not_in_study());
  static constexpr auto entries = members(
      refused,
      field(
          "iterations", [](const Fitted& f) { return f.fit.iterations; }, "", "iterations of least squares"),
      field(
          "between_samples", [](const Fitted& f) { return unless_empty(f.between_samples); }, "",
          "interpolation of a recorded force: linear, hold or band-limited; null without one"),
      field("headline", &Fitted::headline, "",
            "what is looked for first, as far as it is known: frequency; stiffness (with a mass); "
            "decay_rate_start and decay_rate_end, by all terms of the law, of a free motion; reynolds_max "
            "(with a disc)"),
      field("parameters", &Fitted::parameters, "",
            "fitted parameters by name, per unit mass; with a mass also those of the forces"),
      group_if(
          "covariance",
          "covariance of the fitted parameters; its diagonal is the squares of their standard errors",
          [](const Fitted& f) { return !f.parameters.empty(); },
          members(field(
                      "parameters", [](const Fitted& f) { return f.fit.names; }, "", "their names"),
                  field(
                      "matrix", [](const Fitted& f) { return covariance_rows(f); }, "",
                      "the covariance matrix, row by row")
                      .not_in_study())),
      field("derived", &Fitted::derived, "", "quantities that follow from the law, by name"),
      field(
          "simulate",
          [](const Fitted& f) { return unless_empty(command_of("simulate", simulate_and_lay_over(f))); }, "",
          "command line that simulates this law, over the recording; null if there is none"),
      field(
          "residual", [](const Fitted& f) { return f.fit.residual; }, "", "residuals: measured minus fitted")
          .unnamed(),
      field("candidates", &Fitted::candidates, "", "the laws that were tried").not_in_study(),
      field("modes", &Fitted::modes, "", "two oscillations, the larger first; empty if only one was found")
          .called("mode"),
      field("held_out", &Fitted::held_out, "", "samples that were kept out of the fit").left_out(),
      field("decay_segments", &Fitted::segments, "", "a decay rate for each segment").called("segment"),
      estimated("decay_rate_mean", &Fitted::decay_rate_mean, "1/s",
                "mean decay rate of the segments; null without segments")
          .with_error("decay_rate_mean_standard_error"),
      field("decay_by_amplitude", &Fitted::decay_by_amplitude, "",
            "decay rate and frequency against amplitude, stretch by stretch")
          .not_in_study(),
      group_if(
          "reynolds", "Reynolds numbers; null without a disc",
          [](const Fitted& f) { return f.reynolds_max.has_value(); },
          members(estimated(
                      "max", [](const Fitted& f) { return *f.reynolds_max; }, "", "largest Reynolds number")
                      .known(),
                  field("t", &Fitted::reynolds_max_t, "s", "when it is reached").known(),
                  field("windows", &Fitted::reynolds, "", "largest Reynolds number of each half second")
                      .not_in_study())),
      group_if(
          "keulegan_carpenter", "Keulegan-Carpenter number; null without a disc",
          [](const Fitted& f) { return f.keulegan_carpenter.has_value(); },
          members(estimated(
                      "max", [](const Fitted& f) { return *f.keulegan_carpenter; }, "",
                      "2 pi A/D at the largest amplitude")
                      .with_interval()
                      .known())),
      field("stiffness_budget", &Fitted::stiffness_budget, "",
            "contributions to the uncertainty of the spring constant")
          .called("budget"),
      field("monte_carlo", drawn_stiffness, "",
            "spring constant by Monte Carlo trials; null if not asked for"),
      field("plan", &Fitted::plan, "", "how long to record; null without a goal").not_in_study(),
      field("textbook", &Fitted::textbook, "", "damping by textbook methods; null if not asked for"),
      notices(&Fitted::notices));
};

}  // namespace cromer::core
