#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "cromer/analysis/air.h"
#include "cromer/analysis/envelope.h"
#include "cromer/base/ascii.h"
#include "cromer/base/extent.h"
#include "cromer/base/pi.h"
#include "cromer/documents/described/compare.h"
#include "cromer/documents/described/fit.h"
#include "cromer/documents/text/words.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/column_kind.h"
#include "cromer/study/collect.h"
#include "cromer/study/facts.h"
#include "cromer/tasks/fit/decay_rates.h"
#include "cromer/tasks/fit/fitted_motion.h"
#include "cromer/tasks/fit/lab_quantities.h"

namespace cromer::core {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// "of the column" becomes the unit of this recording.
Facts facts_of(const FittedRecording& fitted, Results& results) {
  return Facts(results, [own = unit_of(fitted.series)](std::string_view unit) -> std::string_view {
    return unit == unit_of_column ? own : unit;
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

/// Decay rates and frequencies against amplitude: measured, their error bars (with a NaN after each), and by
/// the law.
void collect_decay(const std::string& id, const FittedRecording& fitted, Results& results) {
  if (fitted.decay_by_amplitude.empty()) return;
  const std::string unit = motion_units(fitted).displacement;
  std::vector<double> amplitude, rate, frequency, law, bar_at, rate_bar, frequency_bar;
  const auto add = [](const Estimate& measured, double size, std::vector<double>& to,
                      std::vector<double>& bar) {
    const double value = measured.value / size, error = measured.standard_error / size;
    to.push_back(value);
    bar.insert(bar.end(), {value - error, value + error, none});
  };
  for (const AmplitudeRate& each : fitted.decay_by_amplitude) {
    amplitude.push_back(each.amplitude);
    law.push_back(each.law_rate);
    bar_at.insert(bar_at.end(), {each.amplitude, each.amplitude, each.amplitude});
    add(each.rate, 1, rate, rate_bar);
    add(each.angular_frequency, two_pi, frequency, frequency_bar);
  }
  const auto set_stretch = [&](const std::string& name, const AmplitudeRate& stretch) {
    results.set(id + name, Quantity{stretch.rate.value, stretch.rate.standard_error}, "1/s");
    results.set(id + name + ".amplitude", stretch.amplitude, unit);
    const Estimate& w = stretch.angular_frequency;
    results.set(id + name + ".frequency", Quantity{w.value / two_pi, w.standard_error / two_pi}, "Hz");
  };
  set_stretch(".first_stretch", fitted.decay_by_amplitude.front());
  set_stretch(".last_stretch", fitted.decay_by_amplitude.back());
  const auto [lowest, highest] = extreme_rates(fitted.decay_by_amplitude);
  set_stretch(".lowest_stretch", lowest);
  set_stretch(".highest_stretch", highest);
  const auto [least, most] = extent_of(amplitude);
  const AmplitudeDecay decay = amplitude_decay(fitted.fit);
  constexpr int points = 200;
  std::vector<double> along, rates, frequencies;
  for (int i = 0; i <= points; ++i) {
    const double share = static_cast<double>(i) / points;
    along.push_back(span_a_decade(fitted.decay_by_amplitude) ? least * std::pow(most / least, share)
                                                             : std::lerp(least, most, share));
    rates.push_back(decay.rate(along.back()));
    frequencies.push_back(law_angular_frequency(fitted.fit, along.back()) / two_pi);
  }
  results.set_column(id + ".law_amplitude", std::move(along), unit, "amplitude");
  results.set_column(id + ".law_curve", std::move(rates), "1/s", "decay rate");
  results.set_column(id + ".law_frequency", std::move(frequencies), "Hz", "frequency");
  results.set(id + ".first_rate", law.front(), "1/s");
  results.set(id + ".last_rate", law.back(), "1/s");
  results.set(id + ".stretches", static_cast<double>(rate.size()));
  results.set_column(id + ".amplitude", std::move(amplitude), unit, "amplitude");
  results.set_column(id + ".rate", std::move(rate), "1/s", "decay rate");
  results.set_column(id + ".law_rate", std::move(law), "1/s", "decay rate");
  results.set_column(id + ".stretch_frequency", std::move(frequency), "Hz", "frequency");
  results.set_column(id + ".bar_amplitude", std::move(bar_at), unit, "amplitude");
  results.set_column(id + ".bar_rate", std::move(rate_bar), "1/s", "decay rate");
  results.set_column(id + ".bar_frequency", std::move(frequency_bar), "Hz", "frequency");
}

/// The samples in use; those set aside are NaN.
std::vector<double> used_samples(const Series& series) {
  std::vector<double> y = series.y;
  for (const Outlier& each : series.outliers) {
    const auto at = std::lower_bound(series.t.begin(), series.t.end(), each.t);
    if (at != series.t.end() && *at == each.t) y[at - series.t.begin()] = none;
  }
  return y;
}

void collect_columns(const std::string& id, const FittedRecording& fitted, Results& results) {
  const std::string unit = unit_of(fitted.series);
  const std::vector<double>& t = fitted.series.t;
  std::vector<double> since_start = t;
  for (double& time : since_start) time -= t.front();
  results.set_column(id + ".t", t, "s", "time *t*");
  results.set_column(id + ".since_start", std::move(since_start), "s", "time since the first sample");
  const std::vector<double> measured = used_samples(fitted.series);
  results.set_column(id + ".measured", measured, unit, "measured " + fitted.series.quantity);
  results.set_column(id + ".left_out_t", fitted.left_out.t, "s", "time *t*");
  results.set_column(id + ".left_out", fitted.left_out.y, unit, "measured " + fitted.series.quantity);
  if (!fitted.fit.has_values()) return;
  const double mean = fitted.fit.equilibrium().value;
  const std::string axis = fitted.series.quantity == "position" ? "position *x*" : fitted.series.quantity;
  std::vector<double> displacement = measured, by_law = fitted.series.y;
  FittedMotion motion = law_motion(fitted);
  for (std::size_t i = 0; i < by_law.size(); ++i) {
    displacement[i] -= mean;
    by_law[i] -= mean;
  }
  for (std::size_t i = 0; i < motion.residual.size(); ++i) {
    by_law[i] -= motion.residual[i];
    if (std::isnan(displacement[i])) motion.residual[i] = none;
  }
  results.set_column(id + ".displacement", std::move(displacement), unit, axis);
  results.set_column(id + ".fitted_displacement", std::move(by_law), unit, axis);
  results.set_column(id + ".residual", std::move(motion.residual), unit, "residual");
  results.set_column(id + ".mean", std::vector<double>(t.size(), mean), unit, "mean");
}

/// The envelope of the stretches between the gaps, `broken` with a NaN in each gap.
Envelope envelope_of(const Trajectory& run, const std::vector<Gap>& gaps, bool broken) {
  Envelope all;
  const auto join = [&](std::vector<double>& to, const std::vector<double>& more, bool first) {
    if (broken && !first) to.push_back(none);
    to.insert(to.end(), more.begin(), more.end());
  };
  auto gap = gaps.begin();
  for (std::size_t from = 0, to = 0; from < run.t.size(); from = to) {
    while (gap != gaps.end() && gap->t < run.t[from]) ++gap;
    for (to = from + 1; to < run.t.size() && (gap == gaps.end() || run.t[to] <= gap->t);) ++to;
    const Envelope part =
        envelope(std::span(run.t).subspan(from, to - from), std::span(run.x).subspan(from, to - from));
    join(all.top_t, part.top_t, from == 0);
    join(all.top, part.top, from == 0);
    join(all.bottom_t, part.bottom_t, from == 0);
    join(all.bottom, part.bottom, from == 0);
  }
  return all;
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
  if (fitted.fit.has_values())
    results.set(id + ".law_terms", terms_in_words(fitted.fit.law, results.language()));
  for (const auto& [option, value] : fitted.simulate)
    results.set(id + ".simulate." + with_underscores(option), value);
  if (const auto other = other_stiffness(fitted)) {
    results.set(id + ".other_stiffness", other->stiffness, "N/m");
    results.set(id + ".other_stiffness.rms", other->rms, unit_of(fitted.series));
  }
  if (fitted.common_decay) {
    const MeanDecay& common = *fitted.common_decay;
    results.set(id + ".common_decay", Quantity{common.rate.value, common.rate.standard_error}, "1/s");
    results.set(id + ".common_decay.amplitude", common.amplitude, motion_units(fitted).displacement);
  }
  set_optional(results, id + ".mass", body_of(fitted.options).mass, "kg");
  set_optional(results, id + ".spring_mass", fitted.options.spring_mass, "kg");
  set_optional(results, id + ".disc_diameter", fitted.options.disc_diameter, "m");
  if (fitted.reynolds_max) {
    const Quantity air = body_of(fitted.options).temperature;
    results.set(id + ".air_temperature", air, "K");
    results.set(id + ".air_density", air_density(air.value), "kg/m³");
    results.set(id + ".air_viscosity", air_kinematic_viscosity(air.value), "m²/s");
  }
  collect_mean_damping(id, fitted, results);
  collect_reynolds(id, fitted, results);
  collect_decay(id, fitted, results);
  collect_columns(id, fitted, results);
}

void collect(const std::string& id, const StaticStiffness& found, Results& results) {
  Facts(results, [](std::string_view unit) { return unit; }).set(id + ".stiffness", found.stiffness, "N/m");
  results.set(id + ".gravity", found.gravity, "m/s²");
  std::vector<double> mass, position, residual, bar_at, bar;
  bool several_files = false, several_runs = false;
  for (const Hold& hold : found.holds) {
    several_files = several_files || hold.file != found.holds.front().file;
    several_runs = several_runs || hold.run != found.holds.front().run;
  }
  std::vector<std::string> files;
  for (const Hold& hold : found.holds) files.push_back(hold.file);
  const std::vector<std::string> names = short_names(files);
  for (std::size_t i = 0; i < found.holds.size(); ++i) {
    const Hold& hold = found.holds[i];
    const std::string name = id + "." + std::to_string(i + 1);
    const Notice which = several_runs ? Notice{"report_run_of", {{"file", names[i]}, {"run", hold.run}}}
                                      : Notice{"stretch", {{"from", hold.from}, {"to", hold.to}}};
    results.set(name + ".label",
                several_files && !several_runs ? names[i] : in_words(which, {results.language()}));
    results.set(name + ".mass", hold.mass, "kg");
    results.set(name + ".position", Quantity{hold.position, hold.standard_error}, "m");
    mass.push_back(hold.mass.value);
    position.push_back(hold.position);
    residual.push_back(residual_of(found, hold));
    results.set(name + ".residual", residual.back(), "m");
    const double error = error_about_line(found, hold);
    bar_at.insert(bar_at.end(), {mass.back(), mass.back(), mass.back()});
    bar.insert(bar.end(), {residual.back() - error, residual.back() + error, none});
  }
  const auto [least, most] = extent_of(mass);
  const double beyond = 0.05 * (most - least);  // so that no point lies on a figure's frame
  constexpr int points = 20;                    // its name stands beside one of them
  std::vector<double> along, line;
  for (int i = 0; i <= points; ++i) {
    along.push_back(std::lerp(least - beyond, most + beyond, static_cast<double>(i) / points));
    line.push_back(found.line.at(along.back()));
  }
  results.set_column(id + ".line", std::move(line), "m", "position");
  results.set_column(id + ".line_mass", std::move(along), "kg", "mass");
  results.set_column(id + ".bar_mass", std::move(bar_at), "kg", "mass");
  results.set_column(id + ".bar_residual", std::move(bar), "m", "residual");
  results.set_column(id + ".mass", std::move(mass), "kg", "mass");
  results.set_column(id + ".position", std::move(position), "m", "position");
  results.set_column(id + ".residual", std::move(residual), "m", "residual");
}

void collect(const std::string& id, const CompareResult& compared, Results& results) {
  collect(id, compared.recording, results);
  results.set(id + ".explanation", in_words(explanation(compared), {results.language()}));
  const std::string unit = unit_of(compared.recording.series);
  std::vector<Envelope> envelopes;
  for (const ComparedCurve& curve : compared.curves)
    envelopes.push_back(envelope_of(curve.trajectory, compared.recording.series.gaps, false));
  for (std::size_t i = 0; i < compared.curves.size(); ++i) {
    const ComparedCurve& curve = compared.curves[i];
    const std::string name = id + "." + std::to_string(i + 1);
    facts_of(compared.recording, results).set(name, curve);
    results.set(name + ".amplitude_error_end", curve.amplitude_ratio_end - 1);
    // The second curve is the fitted law.
    collect_excess(name, envelopes[i], envelopes[1], results);
    Envelope around = envelope_of(curve.trajectory, compared.recording.series.gaps, true);
    results.set_column(name + ".t", curve.trajectory.t, "s", "time *t*");
    results.set_column(name + ".x", curve.trajectory.x, unit, "position *x*");
    results.set_column(name + ".top_t", std::move(around.top_t), "s", "time *t*");
    results.set_column(name + ".top", std::move(around.top), unit, "position *x*");
    results.set_column(name + ".bottom_t", std::move(around.bottom_t), "s", "time *t*");
    results.set_column(name + ".bottom", std::move(around.bottom), unit, "position *x*");
  }
}

}  // namespace cromer::core
