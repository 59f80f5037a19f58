// What the document of `fit` consists of.
#pragma once

#include "cromer/documents/described/describe.h"
#include "cromer/tasks/fit/fit.h"

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
          "where it was read from"),
      field(
          "column", [](const FittedFrom& r) -> const std::string& { return r.series().column; }, "",
          "the column that was fitted, as the file spells it"),
      field(
          "observed", [](const FittedFrom& r) { return unless_empty(r.series().quantity); }, "",
          "what it records: position, angle, velocity, ...; null where it is not known"),
      field(
          "run", [](const FittedFrom& r) { return r.series().run; }, "", "which run of the file, from 1"),
      field(
          "samples", [](const FittedFrom& r) { return r.fitted.samples; }, "", "how many the file has"),
      field(
          "used", [](const FittedFrom& r) { return r.fitted.used(); }, "", "how many of them were fitted"),
      field("from", &FittedFrom::first, "s", "time of the first sample used"),
      field("to", &FittedFrom::last, "s", "time of the last one"),
      field(
          "rate", [](const FittedFrom& r) { return unless_zero(r.series().rate); }, "1/s",
          "samples per second; null where they are not even"),
      field(
          "duration",
          [](const FittedFrom& r) -> std::optional<double> {
            if (r.series().t.empty()) return std::nullopt;
            return *r.last() - *r.first();
          },
          "s", "from the first sample used to the last"),
      field(
          "gaps", [](const FittedFrom& r) { return r.series().gaps.size(); }, "",
          "how often samples are missing in between"),
      field(
          "outliers", [](const FittedFrom& r) { return r.series().outliers.size(); }, "",
          "how many samples were set aside"));
};

template <>
struct Described<Residual> {
  static constexpr std::string_view name = "Residual";
  static constexpr auto entries = members(
      field("rms", &Residual::rms, unit_of_column,
            "root mean square of what the law leaves, over the samples used without outliers"),
      field("normality", &Residual::normality, "", "p of the Jarque-Bera test"),
      field("autocorrelation", &Residual::autocorrelation, "", "from sample to sample"),
      field("white", &Residual::white, "", "compatible with no correlation up to lag 20 (Ljung-Box, 1 %)"));
};

template <>
struct Described<Candidate> {
  static constexpr std::string_view name = "Candidate";
  static constexpr auto entries =
      members(field(
                  "law", [](const Candidate& c) { return to_text(c.law); }, "", "a law that was tried"),
              field("rms", &Candidate::rms, unit_of_column, "what it leaves"),
              field("bic", &Candidate::bic, "", "Bayesian information criterion: the smaller, the better"),
              field(
                  "between_samples", [](const Candidate& c) { return unless_empty(c.between_samples); }, "",
                  "how a recorded force was read; only where there is one")
                  .left_out());
};

template <>
struct Described<Mode> {
  static constexpr std::string_view name = "Mode";
  static constexpr auto entries = members(
      field(
          "angular_frequency", [](const Mode& m) { return m.angular_frequency.value; }, "rad/s",
          "of the damped oscillation")
          .known(),
      field(
          "angular_frequency_standard_error",
          [](const Mode& m) { return m.angular_frequency.standard_error; }, "rad/s", "its standard error"),
      field(
          "decay_rate", [](const Mode& m) { return m.decay_rate.value; }, "1/s", "below 0 where it grows")
          .known(),
      field(
          "decay_rate_standard_error", [](const Mode& m) { return m.decay_rate.standard_error; }, "1/s",
          "its standard error"),
      field("amplitude", &Mode::amplitude, unit_of_column, "at the first sample").known(),
      field("amplitude_standard_error", &Mode::amplitude_error, unit_of_column, "its standard error"));
};

template <>
struct Described<HeldOut> {
  static constexpr std::string_view name = "HeldOut";
  static constexpr auto entries =
      members(field("from", &HeldOut::from, "s", "first time of the samples that were held out").known(),
              field("to", &HeldOut::to, "s", "their last time").known(),
              field("samples", &HeldOut::samples, "", "how many"),
              field("rms", &HeldOut::rms, unit_of_column, "what the law, carried on, leaves of them"));
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
  static constexpr auto entries = members(
      field("amplitude", &AmplitudeRate::amplitude, "of the displacement", "in the middle of the stretch")
          .known(),
      estimated("rate", &AmplitudeRate::rate, "1/s",
                "decay rate of one sinusoid fitted to this stretch alone")
          .with_interval(),
      field("law_rate", &AmplitudeRate::law_rate, "1/s",
            "the law's at that amplitude, averaged over a cycle"),
      field("from", &AmplitudeRate::from, "s", "where the stretch begins").known(),
      field("to", &AmplitudeRate::to, "s", "where it ends").known());
};

template <>
struct Described<ReynoldsWindow> {
  static constexpr std::string_view name = "ReynoldsWindow";
  static constexpr auto entries =
      members(field("t", &ReynoldsWindow::t, "s", "where the half second begins").known(),
              field("value", &ReynoldsWindow::value, "", "the largest Reynolds number in it").known());
};

template <>
struct Described<Contribution> {
  static constexpr std::string_view name = "Contribution";
  static constexpr auto entries =
      members(field("quantity", &Contribution::quantity, "", "mass, spring_mass or angular_frequency"),
              field("value", &Contribution::value, "its own", "what it was taken to be").known(),
              field("standard_uncertainty", &Contribution::standard_uncertainty, "its own", "of the value"),
              field("unit", &Contribution::unit, "", "its own unit"),
              field("sensitivity", &Contribution::sensitivity, "N/m per its own",
                    "derivative of the spring constant"),
              field("contribution", &Contribution::contribution, "N/m",
                    "what its uncertainty makes of the spring constant's"),
              field("share", &Contribution::share, "", "of the spring constant's variance, 0 to 1"));
};

template <>
struct Described<RecordingPlan> {
  static constexpr std::string_view name = "RecordingPlan";
  static constexpr auto entries = members(
      field("quantity", &RecordingPlan::quantity, "", "what is to be known better"),
      field("unit", &RecordingPlan::unit, "", "its unit"),
      field("goal", &RecordingPlan::goal, "its own", "standard uncertainty wanted").known(),
      field("now", &RecordingPlan::now, "its own", "standard uncertainty of this record").known(),
      field("met", &RecordingPlan::met, "", "this record is enough"),
      field("possible", &RecordingPlan::possible, "", "a longer record from such a start reaches it"),
      field("duration", &RecordingPlan::duration, "s",
            "that reaches it; where none does, beyond which nothing is gained"),
      field(
          "best", [](const RecordingPlan& p) { return p.possible ? std::nullopt : std::optional(p.best); },
          "its own", "where it is not possible: what the longest record gives"),
      field("text", &RecordingPlan::text, "", "all this in a sentence"));
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
                  "", "logarithmic decrement of a period, from the peaks"),
              field("peaks", &PeakDecrement::peaks, "", "how many stand out of the noise"),
              field(
                  "bias", [](const PeakDecrement&) { return TextbookDamping::decrement_bias(); }, "",
                  "what is wrong about it"));
};

template <>
struct Described<HalfPowerBandwidth> {
  static constexpr std::string_view name = "HalfPowerBandwidth";
  static constexpr auto entries = members(
      field("value", &HalfPowerBandwidth::width, "rad/s", "full width of the spectrum's line"),
      field(
          "unit", [](const HalfPowerBandwidth&) { return std::string_view("rad/s"); }, "", "of the width"),
      field(
          "decay_rate", [](const HalfPowerBandwidth& line) { return line.width / 2; }, "1/s",
          "half the width"),
      field(
          "damping_ratio",
          [](const HalfPowerBandwidth& line) { return line.width / (2 * line.angular_frequency); }, "",
          "that over the line's frequency"),
      field("narrowest", &HalfPowerBandwidth::narrowest, "rad/s",
            "an undamped line's width in a record of this length"),
      field(
          "bias", [](const HalfPowerBandwidth&) { return TextbookDamping::bandwidth_bias(); }, "",
          "what is wrong about it"));
};

template <>
struct Described<TextbookDamping> {
  static constexpr std::string_view name = "Textbook";
  static constexpr auto entries =
      members(field("logarithmic_decrement", &TextbookDamping::decrement, "", "null with fewer than 3 peaks"),
              field("half_power_bandwidth", &TextbookDamping::bandwidth, "",
                    "null where the line does not fall to half its power on both sides"));
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
          "quantity", [](const Drawn&) { return std::string_view("stiffness"); }, "", "what was drawn"),
      field(
          "trials", [](const Drawn& d) { return d.trials.trials; }, "", "how many"),
      field(
          "seed", [](const Drawn& d) { return d.trials.seed; }, "", "of the random numbers"),
      field(
          "mean", [](const Drawn& d) { return d.trials.mean; }, "N/m", "of the trials")
          .known(),
      field(
          "standard_deviation", [](const Drawn& d) { return d.trials.standard_deviation; }, "N/m",
          "of the trials")
          .known(),
      field(
          "interval_95",
          [](const Drawn& d) {
            return Pair{d.trials.low, d.trials.high};
          },
          "N/m", "95 % of the trials lie between, as many below as above")
          .known(),
      group("propagated", "the same by the law of propagation",
            members(estimated("value", &Drawn::propagated, "N/m", "spring constant").with_interval())),
      field(
          "unit", [](const Drawn&) { return std::string_view("N/m"); }, "", "of all of these"));
};

inline std::optional<DrawnStiffness> drawn_stiffness(const FittedRecording& fitted) {
  const Estimate* stiffness = fitted.find("stiffness");
  if (!fitted.monte_carlo || !stiffness) return std::nullopt;
  return DrawnStiffness{*fitted.monte_carlo, *stiffness};
}

/// The covariance matrix, row by row.
inline std::vector<std::vector<double>> covariance_rows(const LawFit& fit) {
  std::vector<std::vector<double>> rows;
  const auto n = static_cast<std::ptrdiff_t>(fit.names.size());
  for (auto row = fit.covariance.begin(); static_cast<std::ptrdiff_t>(rows.size()) < n; row += n)
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
          "recording", [](const Fitted& f) { return FittedFrom{f}; }, "", "what was fitted")
          .unnamed(),
      field(
          "law",
          [](const Fitted& f) { return f.wrong_input ? std::nullopt : std::optional(to_text(f.fit.law)); },
          "", "its terms, \"viscous+drag\"; null where the recording could not be read"),
      field("status", &Fitted::status, "", "converged, or why there is no fit").not_in_study(),
      field(
          "message",
          [](const Fitted& f) { return f.succeeded() ? std::nullopt : std::optional(f.fit.message); }, "",
          "why, where it did not converge")
          .left_out()
          .not_in_study());
  static constexpr auto entries = members(
      refused,
      field(
          "iterations", [](const Fitted& f) { return f.fit.iterations; }, "", "of least squares"),
      field(
          "between_samples", [](const Fitted& f) { return unless_empty(f.between_samples); }, "",
          "linear, hold or band-limited: how a recorded force is read; null without one"),
      field("parameters", &Fitted::parameters, "",
            "as fitted, per unit mass, by name; then, with a mass, what they are as forces"),
      group_if(
          "covariance", "of the fitted parameters; its diagonal is the squares of their standard errors",
          [](const Fitted& f) { return !f.parameters.empty(); },
          members(field(
                      "parameters", [](const Fitted& f) { return f.fit.names; }, "", "their names"),
                  field(
                      "matrix", [](const Fitted& f) { return covariance_rows(f.fit); }, "", "row by row")
                      .not_in_study())),
      field("derived", &Fitted::derived, "", "what follows from the law, by name"),
      field(
          "simulate", [](const Fitted& f) { return unless_empty(f.simulate); }, "",
          "the command line that simulates this law; null where there is none"),
      field(
          "residual", [](const Fitted& f) { return f.fit.residual; }, "", "what the law leaves")
          .unnamed(),
      field("candidates", &Fitted::candidates, "", "the laws that were tried").not_in_study(),
      field("modes", &Fitted::modes, "", "where two oscillations were found, the larger first")
          .called("mode"),
      field("held_out", &Fitted::held_out, "", "the samples that were kept from the fit").left_out(),
      field("decay_segments", &Fitted::segments, "", "a decay rate for each segment").called("segment"),
      estimated("decay_rate_mean", &Fitted::decay_rate_mean, "1/s", "of the segments; null without")
          .with_error("decay_rate_mean_standard_error"),
      field("decay_by_amplitude", &Fitted::decay_by_amplitude, "",
            "the decay rate of each stretch against its amplitude")
          .not_in_study(),
      group_if(
          "reynolds", "null without a disc", [](const Fitted& f) { return f.reynolds_max.has_value(); },
          members(
              estimated(
                  "max", [](const Fitted& f) { return *f.reynolds_max; }, "", "the largest Reynolds number")
                  .known(),
              field("t", &Fitted::reynolds_max_t, "s", "where it is").known(),
              field("windows", &Fitted::reynolds, "", "half a second each").not_in_study())),
      group_if(
          "keulegan_carpenter", "null without a disc",
          [](const Fitted& f) { return f.keulegan_carpenter.has_value(); },
          members(estimated(
                      "max", [](const Fitted& f) { return *f.keulegan_carpenter; }, "",
                      "2 pi A/D at the largest amplitude")
                      .with_interval()
                      .known())),
      field("stiffness_budget", &Fitted::stiffness_budget, "",
            "what the spring constant's uncertainty comes from")
          .not_in_study(),
      field("monte_carlo", drawn_stiffness, "",
            "the spring constant by trials; null where none were asked for"),
      field("plan", &Fitted::plan, "", "how long to record; null where no goal was given").not_in_study(),
      field("textbook", &Fitted::textbook, "", "what textbooks would say; null where that was not asked for"),
      notices(&Fitted::notices));
};

}  // namespace cromer::core
