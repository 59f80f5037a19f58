#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/analysis/energy_balance.h"
#include "cromer/base/pi.h"
#include "cromer/ensemble/point.h"
#include "cromer/tasks/sweep/sweep.h"
#include "cromer/tasks/sweep/sweep_rows.h"

namespace cromer::core {
namespace {

constexpr double rounding = 1e-12;  // [rad] of a lag

/// How far a lag [rad] lies outside 0 to pi.
double excess(double lag) { return std::max(-lag, lag - pi); }

/// The swept options and their values in a row: "drive-frequency 0.5, damping 0".
std::string place_of(const SweepPlan& plan, std::uint64_t row) {
  std::vector<double> values(plan.swept.size());
  SweepPoints(plan.work->base, plan.work->axes).values_of(row, values.data());
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += fmt::format("{}{} {:.4g}", i ? ", " : "", plan.swept[i].name, values[i]);
  return text;
}

/// Says on what the settled motion of an undamped law rests.
Notice own_damping_notice(const SweepPlan& plan, const SweepCounts& counts) {
  SweepPoints points(plan.work->base, plan.work->axes);
  std::vector<double> values(plan.swept.size());
  points.values_of(counts.first_own_damping, values.data());
  const auto at = points.at(values.data());
  const auto rate = at ? own_decay_rate(*plan.work, at->settings, at->point) : std::nullopt;
  Notice number;
  if (rate && *rate > 0) {
    // Down to a millionth, as stepping does.
    const double cycles = std::log(1e6) / *rate * at->point.drive.frequency / two_pi;
    number =
        Notice{"own_decay_rate",
               {{"rate", *rate}, {"place", place_of(plan, counts.first_own_damping)}, {"cycles", cycles}}};
  }
  return Notice{
      "settles_by_own_damping",
      {{"points", counts.own_damping}, {"all", plan.rows.rows}, {"method", plan.method}, {"number", number}}};
}

Notice phase_notice(const SweepPlan& plan, const SweepCounts& counts) {
  const SweepWork& work = *plan.work;
  Notice why;
  // Stepping leaves some free motion, and so an error in the lag.
  if (work.way != SweepWay::closed_form && work.settling.dropped)
    why = Notice{"free_motion_may_be_there", {{"cycles", *work.settling.dropped}}};
  else if (work.way != SweepWay::closed_form && counts.phase_excess < 10 * work.settling.tolerance)
    why = Notice{"settling_leaves", {{"left", work.settling.tolerance}}};
  return Notice{"lag_outside",
                {{"points", counts.phase_outside},
                 {"all", plan.rows.rows},
                 {"excess", counts.phase_excess},
                 {"place", place_of(plan, counts.phase_worst)},
                 {"why", why},
                 {"method", plan.method}}};
}

/// Whether no term of the law takes energy at any point.
bool undamped(const SweepPlan& plan) {
  const SimulateOptions& base = plan.work->base;
  const bool swept = std::any_of(plan.swept.begin(), plan.swept.end(), [](const SweptOption& option) {
    bool takes =
        option.name == "damping-ratio" || option.name == "static-friction" || option.name == "quality-factor";
    for_each_resistance([&]<class T>() { takes = takes || option.name == T::coefficients[0].option; });
    return takes;
  });
  bool fixed = base.damping.value_or(0) != 0 || base.damping_ratio.value_or(0) != 0 || base.quality_factor;
  for_each_resistance([&]<class T>() {
    if (!std::is_same_v<T, Viscous>) fixed = fixed || base.law.*T::template members<double>[0] != 0;
  });
  return !swept && !fixed;
}

}  // namespace

void count_row(const SweepPlan& plan, std::uint64_t row, const double* made, SweepCounts& counts) {
  switch (static_cast<PointStatus>(static_cast<int>(made[plan.rows.columns.size() - 1]))) {
    case PointStatus::done:
      ++counts.done;
      break;
    case PointStatus::not_settled:
      ++counts.not_settled;
      break;
    case PointStatus::not_finite:
      ++counts.not_finite;
      break;
    case PointStatus::no_convergence:
      ++counts.no_convergence;
      break;
    case PointStatus::unstable:
      ++counts.unstable;
      break;
    case PointStatus::own_damping:
      ++counts.own_damping;
      counts.first_own_damping = std::min(counts.first_own_damping, row);
      break;
  }
  std::size_t column = plan.swept.size();
  for (const Measure* measure : plan.work->measures) {
    if (measure->name == "phase") {
      const double beyond = excess(made[column]);
      if (beyond > rounding) {
        ++counts.phase_outside;
        // Chunks come in any order.
        if (beyond > counts.phase_excess || (beyond == counts.phase_excess && row < counts.phase_worst))
          counts.phase_excess = beyond, counts.phase_worst = row;
      }
    }
    column += measure->columns.size();
  }
}

std::string_view status_word(const SweepPlan& plan, unsigned char status) {
  if (status == SweepResult::not_reached) return "not_reached";
  const SweepWork& work = *plan.work;
  switch (static_cast<PointStatus>(status)) {
    case PointStatus::done:
      if (work.runs_to_end()) return "reached_end";
      return work.settling.dropped ? "measured" : "settled";
    case PointStatus::not_settled:
      return "not_settled";
    case PointStatus::not_finite:
      return "not_finite";
    case PointStatus::no_convergence:
      return "no_convergence";
    case PointStatus::unstable:
      return "unstable";
    case PointStatus::own_damping:
      return "settled_by_own_damping";
  }
  return "";
}

std::string status_counts(const SweepResult& result) {
  const SweepCounts& c = result.counts;
  const std::uint64_t all = result.plan.rows.rows;
  const std::uint64_t ended = c.with_numbers() + c.not_settled + c.not_finite + c.no_convergence + c.unstable;
  std::string text = fmt::format("{} points:", all);
  bool first = true;
  const auto add = [&](std::uint64_t count, unsigned char status) {
    if (count == 0) return;
    text += fmt::format("{} {} {}", first ? "" : ",", count, status_word(result.plan, status));
    first = false;
  };
  const auto of = [](PointStatus status) { return static_cast<unsigned char>(status); };
  add(c.done, of(PointStatus::done));
  add(c.own_damping, of(PointStatus::own_damping));
  add(c.not_settled, of(PointStatus::not_settled));
  add(c.unstable, of(PointStatus::unstable));
  add(c.not_finite, of(PointStatus::not_finite));
  add(c.no_convergence, of(PointStatus::no_convergence));
  add(all - ended, SweepResult::not_reached);
  return text;
}

std::vector<Notice> notices_of(const SweepResult& result) {
  std::vector<Notice> notices = result.plan.notices;
  if (result.counts.own_damping > 0) notices.push_back(own_damping_notice(result.plan, result.counts));
  if (result.counts.phase_outside > 0) notices.push_back(phase_notice(result.plan, result.counts));
  return notices;
}

std::vector<Notice> failure_notices(const SweepResult& result) {
  const SweepCounts& counts = result.counts;
  const std::uint64_t all = result.plan.rows.rows;
  std::vector<Notice> points;
  if (counts.not_settled > 0 && undamped(result.plan))
    points.push_back(Notice{"points_not_settled_undamped", {{"points", counts.not_settled}, {"all", all}}});
  else if (counts.not_settled > 0)
    points.push_back(Notice{"points_not_settled", {{"points", counts.not_settled}, {"all", all}}});
  if (counts.unstable > 0)
    points.push_back(Notice{"points_unstable",
                            {{"points", counts.unstable}, {"all", all}, {"method", result.plan.method}}});
  if (counts.not_finite > 0)
    points.push_back(Notice{"points_ran_away", {{"points", counts.not_finite}, {"all", all}}});
  if (counts.no_convergence > 0)
    points.push_back(Notice{"points_without_solution", {{"points", counts.no_convergence}, {"all", all}}});
  return points;
}

}  // namespace cromer::core
