#include "cromer/tasks/fit/plan_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "cromer/base/nearest.h"
#include "cromer/base/number.h"
#include "cromer/base/pi.h"
#include "cromer/tasks/fit/decay_rates.h"
#include "cromer/tasks/fit/fitted_quantities.h"

namespace cromer::core {
namespace {

// Every number that a fit of a free motion may have.
const std::vector<std::string_view>& known_quantities() {
  static const std::vector<std::string_view> all = [] {
    std::vector<std::string_view> names;
    const auto add = [&](std::string_view name) {
      if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    for (const auto member : {&CoefficientInfo::parameter, &CoefficientInfo::in_si}) {
      for_each_term([&]<class T>() {
        for (const CoefficientInfo& info : T::coefficients) add(info.*member);
      });
      if (member == &CoefficientInfo::parameter)
        for (const std::string_view start : {"equilibrium", "position", "velocity"}) add(start);
    }
    add("drag_coefficient");
    for (const std::string_view derived : derived_names) add(derived);
    return names;
  }();
  return all;
}

constexpr double most_periods = 20'000;

/// What records of other lengths would tell.
class Prospect {
 public:
  Prospect(const LawFit& fit, const Record& record)
      : fit_(fit),
        fitted_(fitted_parameters(fit.law, DriveKind::none, {}, fit.motion)),
        derivative_(record.derivative) {
    const double duration = record.t.back() - record.t.front();
    rate_ = static_cast<double>(record.t.size() - 1) / duration;
    const SquareMatrix now = white(duration);
    const std::size_t n = fit.names.size();
    for (std::size_t i = 0; i < n; ++i) excess_.push_back(std::sqrt(fit.covariance[i * n + i] / now[i][i]));
  }

  double rate() const { return rate_; }

  /// The fit as a record of this length would give it: the same values, its own covariance.
  LawFit after(double duration) const {
    LawFit fit = fit_;
    const SquareMatrix covariance = white(duration);
    const std::size_t n = fit.names.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        fit.covariance[i * n + j] = covariance[i][j] * excess_[i] * excess_[j];
    for (std::size_t i = 0; i < n; ++i)
      fit.estimates[i].standard_error = std::sqrt(std::max(0.0, fit.covariance[i * n + i]));
    return fit;
  }

 private:
  /// The covariance by white noise of the residual's size. Twenty points in a period stand for all samples.
  SquareMatrix white(double duration) const {
    const double period = two_pi / fit_.angular_frequency().value;
    const double points = std::max(24.0, std::ceil(20 * duration / period));
    std::vector<double> t(static_cast<std::size_t>(points)), y(t.size());
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = duration * (static_cast<double>(i) + 0.5) / points;
    t.front() = 0;  // where the motion starts
    NormalEquations equations =
        motion_equations(fitted_, fitted_.pack(fit_.motion), {}, {t, y, 0, derivative_}, period / 40);
    const double samples_per_point = rate_ * duration / points;
    const double variance = fit_.residual.rms * fit_.residual.rms;
    for (int i = 0; i < fitted_.count; ++i)
      for (int j = 0; j < fitted_.count; ++j) equations.matrix[i][j] *= samples_per_point / variance;
    return inverse(equations.matrix, fitted_.count);
  }

  const LawFit& fit_;
  FittedParameters fitted_;
  int derivative_;
  double rate_ = 0;
  std::vector<double> excess_;
};

/// When the swing has become too small to tell anything, or too many periods have passed to count them.
struct SwingEnd {
  double t = 0;  // [s]
  bool dies_down = false;
};

SwingEnd end_of_the_swing(const LawFit& fit) {
  const AmplitudeDecay decay = amplitude_decay(fit);
  const double period = two_pi / decay.angular_frequency;
  const double first = first_amplitude(fit);
  double A = first, t = 0;
  while (A > 1e-3 * first && t < most_periods * period) {
    // A step changes the amplitude by a twentieth at most.
    const double rate = decay.rate(A);
    const double step = std::min(0.05 / std::max(std::abs(rate), 1e-300), 0.01 * most_periods * period);
    A *= std::exp(-rate * step);
    t += step;
  }
  return {std::min(t, most_periods * period), A <= 1e-3 * first};
}

std::string seconds(double t) {
  return format_quantity({leading_number(fmt::format("{:.3g}", t))->value, 0}, "s");
}

std::string certainty(const RecordingPlan& plan, bool relative, double error) {
  const double percent = 100 * error / std::abs(plan.value);
  if (relative) return percent < 99.5 ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
  return fmt::format("{:.2g}{}{}", error, plan.unit == "1" || plan.unit.empty() ? "" : " ",
                     plan.unit == "1" ? "" : plan.unit);
}

/// Quantities that the position of the samples tells, even if nothing swings any more.
bool is_of_the_place(std::string_view quantity) {
  return quantity == "equilibrium" || is_of_the_start(quantity);
}

/// Why a longer record does not reach the goal.
Notice limits_of(const RecordingPlan& plan, const std::string& goal, const std::string& best,
                 bool dies_down) {
  return Notice{
      dies_down ? "swing_dies_down_before" : "record_never_long_enough",
      {{"goal", goal}, {"duration", seconds(plan.duration)}, {"quantity", plan.quantity}, {"best", best}}};
}

Notice sentence(const RecordingPlan& plan, bool relative, double present, double rate, bool dies_down,
                bool linear) {
  const std::string goal = certainty(plan, relative, plan.goal), now = certainty(plan, relative, plan.now);
  if (plan.met)
    return Notice{
        "plan_met",
        {{"quantity", plan.quantity}, {"now", now}, {"goal", goal}, {"duration", seconds(plan.duration)}}};
  if (plan.possible)
    return Notice{"plan_possible",
                  {{"quantity", plan.quantity},
                   {"now", now},
                   {"present", seconds(present)},
                   {"goal", goal},
                   {"duration", seconds(plan.duration)},
                   {"samples", std::ceil(plan.duration * rate)},
                   {"rate", rate}}};
  if (plan.noise_ratio == 0)
    return Notice{"plan_limited_by_values", {{"goal", goal}, {"quantity", plan.quantity}, {"now", now}}};
  const Notice limits = limits_of(plan, goal, certainty(plan, relative, plan.best), dies_down);
  // A larger swing does not help quantities of the place; it helps the terms of a law that is not linear by
  // more than in proportion, or less.
  Notice start;
  if (!is_of_the_place(plan.quantity))
    start = Notice{linear ? "or_a_start_so_much_larger" : "or_a_larger_start", {{"times", plan.noise_ratio}}};
  return Notice{
      "plan_out_of_reach",
      {{"limits", limits}, {"noise", plan.noise_ratio}, {"start", start}, {"rate", plan.rate_ratio}}};
}

/// "did you mean decay_rate?", also for "decay rate 1 %"; else all quantities there are.
Notice meant(std::string_view text, std::string_view quantity) {
  std::string joined(text);
  std::replace(joined.begin(), joined.end(), ' ', '_');
  for (const std::string_view known : known_quantities())
    if (joined.starts_with(known)) return Notice{"quantity_meant", {{"quantity", known}}};
  if (const std::string near = nearest(quantity, known_quantities()); !near.empty())
    return Notice{"quantity_meant", {{"quantity", near}}};
  const std::vector<std::string> all(known_quantities().begin(), known_quantities().end());
  return Notice{"quantities_there_are", {{"quantities", all}}};
}

/// Why a fit lacks a quantity that others have, and the cure.
Notice why_not_there(std::string_view quantity, const Law& law) {
  std::string_view missing;
  for_each_term([&]<class T>() {
    for (const CoefficientInfo& info : T::coefficients)
      if (info.parameter == quantity && !law.has<T>()) missing = T::info.name;
  });
  if (!missing.empty()) return Notice{"term_not_in_law", {{"law", to_text(law)}, {"term", missing}}};
  return Notice{"quantity_needs_more", {{"law", to_text(law)}}};
}

}  // namespace

Result<Goal> parse_goal(std::string_view text) {
  const auto blank = text.find(' ');
  Goal goal{std::string(text.substr(0, blank)), false, ""};
  if (std::find(known_quantities().begin(), known_quantities().end(), goal.quantity) ==
      known_quantities().end()) {
    return Error{"goal_unknown", {{"typed", goal.quantity}, {"hint", meant(text, goal.quantity)}}};
  }
  if (blank == std::string_view::npos)
    return Error{"goal_without_uncertainty", {{"quantity", goal.quantity}}};
  goal.text = text.substr(blank + 1);
  goal.relative = goal.text.find('%') != std::string::npos;
  if (goal.relative) {
    const auto part = parse_quantity(goal.text, "");
    if (!part) return Error{"of_goal", {{"what", part.error().notice}}};
    if (!(part->value > 0))
      return Error{"goal_not_positive", {{"quantity", goal.quantity}, {"uncertainty", goal.text}}};
  }
  return goal;
}

Result<RecordingPlan> plan_recording(const Goal& goal, const LawFit& fit, const Record& record,
                                     const QuantitiesOf& quantities_of) {
  const auto look_up = [&](const LawFit& in) -> std::optional<Parameter> {
    for (const Parameter& number : quantities_of(in))
      if (number.name == goal.quantity) return number;
    return std::nullopt;
  };
  const auto now = look_up(fit);
  if (!now)
    return Error{"goal_not_in_fit",
                 {{"quantity", goal.quantity}, {"why", why_not_there(goal.quantity, fit.law)}}};
  if (fit.law.has<Hysteresis>()) return Error{"goal_with_hysteresis"};
  const bool plain = now->unit == "1";
  const auto wanted = parse_quantity(goal.text, goal.relative || plain ? "" : now->unit);
  if (!wanted) return Error{"of_goal", {{"what", wanted.error().notice}}};
  if (!(wanted->value > 0))
    return Error{"goal_not_positive", {{"quantity", goal.quantity}, {"uncertainty", goal.text}}};

  RecordingPlan plan;
  plan.quantity = goal.quantity;
  plan.unit = now->unit;
  plan.value = now->estimate.value;
  plan.now = now->estimate.standard_error;
  plan.goal = goal.relative ? wanted->value * std::abs(plan.value) : wanted->value;
  plan.met = plan.now <= plan.goal;

  const Prospect prospect(fit, record);
  const auto error_after = [&](double duration) {
    const auto then = look_up(prospect.after(duration));
    return then && std::isfinite(then->estimate.standard_error) ? then->estimate.standard_error : HUGE_VAL;
  };
  const double present = record.t.back() - record.t.front();
  const double period = two_pi / fit.angular_frequency().value;
  const SwingEnd end =
      goal.quantity == "equilibrium" ? SwingEnd{most_periods * period} : end_of_the_swing(fit);
  const double last = std::max(present, end.t);
  double low = std::min(present, 1.5 * period), high = present;
  if (!plan.met) {
    low = present;
    while (high < last && error_after(high) > plan.goal) high = std::min(2 * high, last);
    plan.best = error_after(high);
    plan.possible = plan.best <= plan.goal;
  }
  if (plan.possible) {
    for (int i = 0; i < 24 && high > 1.002 * low; ++i) {
      const double middle = std::sqrt(low * high);
      (error_after(middle) > plan.goal ? low : high) = middle;
    }
    plan.duration = high;
  } else {
    // The part that no record can reduce: that of the mass.
    LawFit certain = prospect.after(last);
    for (double& c : certain.covariance) c = 0;
    for (Estimate& estimate : certain.estimates) estimate.standard_error = 0;
    const double given = look_up(certain)->estimate.standard_error;
    const double own = std::sqrt(std::max(0.0, plan.best * plan.best - given * given));
    const double room = plan.goal * plan.goal - given * given;
    plan.noise_ratio = room > 0 ? own / std::sqrt(room) : 0;
    plan.rate_ratio = plan.noise_ratio * plan.noise_ratio;
    double useful_low = present, useful_high = last;  // within a hundredth of the best
    for (int i = 0; i < 16 && useful_high > 1.01 * useful_low; ++i) {
      const double middle = std::sqrt(useful_low * useful_high);
      (error_after(middle) > 1.01 * plan.best ? useful_low : useful_high) = middle;
    }
    plan.duration = useful_high;
  }
  plan.text = sentence(plan, goal.relative, present, prospect.rate(), end.dies_down, is_linear(fit.law));
  return plan;
}

}  // namespace cromer::core
