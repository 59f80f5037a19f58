#include <limits>

#include "cromer/analysis/envelope.h"
#include "cromer/base/ascii.h"
#include "cromer/documents/described/compare.h"
#include "cromer/documents/described/fit.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/column_kind.h"
#include "cromer/study/collect.h"
#include "cromer/study/facts.h"
#include "cromer/tasks/fit/fitted_motion.h"

namespace cromer::core {
namespace {

/// "of the column" becomes the unit of this recording.
Facts facts_of(const FittedRecording& fitted, Results& results) {
  return Facts(results, [&fitted](std::string_view unit) -> std::string_view {
    if (unit == unit_of_column) return si_unit_of(fitted.series.quantity);
    return unit;
  });
}

void set_optional(Results& results, const std::string& name, const std::optional<Quantity>& quantity,
                  std::string_view unit) {
  if (quantity) results.set(name, *quantity, unit);
}

void collect_mean_damping(const std::string& id, const FittedRecording& fitted, Results& results) {
  if (!fitted.decay_rate_mean) return;
  // The damping that gives the mean decay rate: c = 2 m gamma.
  if (const Estimate* stiffness = fitted.find("stiffness")) {
    const double w = fitted.fit.angular_frequency().value;
    results.set(id + ".damping_mean", 2 * fitted.decay_rate_mean->value * stiffness->value / (w * w), "kg/s");
  }
}

void collect_reynolds(const std::string& id, const FittedRecording& fitted, Results& results) {
  if (fitted.reynolds.empty()) return;
  std::vector<double> t, value;
  for (const ReynoldsWindow& window : fitted.reynolds) {
    t.push_back(window.t);
    value.push_back(window.value);
  }
  results.set(id + ".reynolds_last", value.back());
  results.set_column(id + ".window_t", std::move(t), "s", "time *t*");
  results.set_column(id + ".reynolds", std::move(value), "", "Reynolds number Re");
}

/// Decay rates against amplitude: measured, their error bars (with a NaN after each), and by the law.
void collect_decay(const std::string& id, const FittedRecording& fitted, Results& results) {
  if (fitted.decay_by_amplitude.empty()) return;
  const std::string unit = motion_units(fitted).displacement;
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> amplitude, rate, law, bar_at, bar;
  for (const AmplitudeRate& each : fitted.decay_by_amplitude) {
    amplitude.push_back(each.amplitude);
    rate.push_back(each.rate.value);
    law.push_back(each.law_rate);
    bar_at.insert(bar_at.end(), {each.amplitude, each.amplitude, each.amplitude});
    bar.insert(bar.end(),
               {each.rate.value - each.rate.standard_error, each.rate.value + each.rate.standard_error, gap});
  }
  results.set(id + ".first_rate", law.front(), "1/s");
  results.set(id + ".last_rate", law.back(), "1/s");
  results.set(id + ".stretches", static_cast<double>(rate.size()));
  results.set_column(id + ".amplitude", std::move(amplitude), unit, "amplitude");
  results.set_column(id + ".rate", std::move(rate), "1/s", "decay rate");
  results.set_column(id + ".law_rate", std::move(law), "1/s", "decay rate");
  results.set_column(id + ".bar_amplitude", std::move(bar_at), unit, "amplitude");
  results.set_column(id + ".bar_rate", std::move(bar), "1/s", "decay rate");
}

void collect_columns(const std::string& id, const FittedRecording& fitted, Results& results) {
  const std::string_view unit = si_unit_of(fitted.series.quantity);
  const std::vector<double>& t = fitted.series.t;
  std::vector<double> since_start = t;
  for (double& time : since_start) time -= t.front();
  results.set_column(id + ".t", t, "s", "time *t*");
  results.set_column(id + ".since_start", std::move(since_start), "s", "time since the first sample");
  results.set_column(id + ".measured", fitted.series.y, unit, "measured " + fitted.series.quantity);
  if (!fitted.fit.has_values()) return;
  const double mean = fitted.fit.equilibrium().value;
  const std::string axis = fitted.series.quantity == "position" ? "position *x*" : fitted.series.quantity;
  std::vector<double> displacement = fitted.series.y;
  for (double& value : displacement) value -= mean;
  FittedMotion motion = law_motion(fitted);
  std::vector<double> by_law = displacement;
  for (std::size_t i = 0; i < by_law.size(); ++i) by_law[i] -= motion.residual[i];
  results.set_column(id + ".displacement", std::move(displacement), unit, axis);
  results.set_column(id + ".fitted_displacement", std::move(by_law), unit, axis);
  results.set_column(id + ".residual", std::move(motion.residual), unit, "residual");
  results.set_column(id + ".mean", std::vector<double>(t.size(), mean), unit, "mean");
}

/// The largest excess of the simulated amplitude over the law's, relative, and when it is.
void collect_excess(const std::string& name, const Envelope& simulated, const Envelope& law,
                    Results& results) {
  double most = 0, when = 0;
  for (std::size_t i = 0; i < simulated.top.size() && !law.top.empty(); ++i) {
    const double excess = simulated.top[i] / interpolate(law.top_t, law.top, simulated.top_t[i]) - 1;
    if (excess > most) {
      most = excess;
      when = simulated.top_t[i];
    }
  }
  results.set(name + ".excess_max", most);
  results.set(name + ".excess_max_t", when, "s");
}

}  // namespace

void collect(const std::string& id, const FittedRecording& fitted, Results& results) {
  facts_of(fitted, results).set(id, fitted);
  for (const auto& [option, value] : fitted.simulate)
    results.set(id + ".simulate." + with_underscores(option), value);
  set_optional(results, id + ".mass", body_of(fitted.options).mass, "kg");
  set_optional(results, id + ".disc_diameter", fitted.options.disc_diameter, "m");
  collect_mean_damping(id, fitted, results);
  collect_reynolds(id, fitted, results);
  collect_decay(id, fitted, results);
  collect_columns(id, fitted, results);
}

void collect(const std::string& id, const CompareResult& compared, Results& results) {
  collect(id, compared.recording, results);
  results.set(id + ".explanation", in_words(explanation(compared), {results.language()}));
  const std::string_view unit = si_unit_of(compared.recording.series.quantity);
  std::vector<Envelope> envelopes;
  for (const ComparedCurve& curve : compared.curves)
    envelopes.push_back(envelope(curve.trajectory.t, curve.trajectory.x));
  for (std::size_t i = 0; i < compared.curves.size(); ++i) {
    const ComparedCurve& curve = compared.curves[i];
    const std::string name = id + "." + std::to_string(i + 1);
    facts_of(compared.recording, results).set(name, curve);
    results.set(name + ".amplitude_error_end", curve.amplitude_ratio_end - 1);
    // The second curve is the fitted law.
    collect_excess(name, envelopes[i], envelopes[1], results);
    results.set_column(name + ".t", curve.trajectory.t, "s", "time *t*");
    results.set_column(name + ".x", curve.trajectory.x, unit, "position *x*");
    results.set_column(name + ".top_t", envelopes[i].top_t, "s", "time *t*");
    results.set_column(name + ".top", envelopes[i].top, unit, "position *x*");
    results.set_column(name + ".bottom_t", envelopes[i].bottom_t, "s", "time *t*");
    results.set_column(name + ".bottom", envelopes[i].bottom, unit, "position *x*");
  }
}

}  // namespace cromer::core
