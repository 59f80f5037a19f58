#include "cromer/tasks/sweep/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "cromer/base/ascii.h"
#include "cromer/base/quantity.h"
#include "cromer/ensemble/dispatch.h"
#include "cromer/methods/all.h"
#include "cromer/model/law.h"
#include "cromer/tasks/simulate/drive_setup.h"
#include "cromer/tasks/simulate/simulate_setup.h"
#include "cromer/tasks/sweep/sweep_rows.h"

namespace cromer::core {
namespace {

constexpr double most_rows = 9007199254740992.0;  // 2^53: beyond, rows cannot be told apart

constexpr std::uint64_t most_looked_at = 100000;  // values of a grid

constexpr double enough_steps = 10;  // in a cycle of the drive, to say nothing of it

/// Grids become axes, single values go into the base. A range is a grid, however few points it has. If there
/// is no grid, a single point is swept: along the drive's frequency, or all options that have a value.
Result<void> read_values(const SweepOptions& options, SweepWork& work) {
  std::vector<SweepAxis> single;
  for (const Option& option : point_options(work.base)) {
    const auto typed = options.values.find(option.name);
    if (typed == options.values.end() || typed->second.empty()) continue;
    if (const Notice why = sweep_refusal(option.name, ""); !why.empty()) return Error{why};
    const auto wrong = [&](const Error& error) {
      return Error{"option_is_wrong", {{"option", option.name}, {"what", error.notice}}};
    };
    const std::string_view unit = option.unit == "1" ? std::string_view{} : option.unit;
    const auto grid = parse_grid(typed->second, unit);
    if (!grid) return wrong(grid.error());
    // Both ends, and every value of a list, which may run any way.
    const std::uint64_t looked_at = std::min(grid->size(), most_looked_at);
    for (std::uint64_t i = 0; i < looked_at; ++i) {
      set_number(option.target, (*grid)[i + 1 < looked_at ? i : grid->size() - 1]);
      if (auto good = check(option); !good) return good;
    }
    set_number(option.target, (*grid)[0]);
    const bool swept = grid->size() > 1 || typed->second.find(':') != std::string::npos;
    (swept ? work.axes : single)
        .push_back({std::string(option.name), std::string(unit), *grid, unit_of_grid(typed->second, unit)});
  }
  if (!work.axes.empty()) return {};
  if (single.empty()) return Error{"nothing_swept"};
  const auto frequency = std::find_if(single.begin(), single.end(),
                                      [](const SweepAxis& a) { return a.name == "drive-frequency"; });
  if (frequency != single.end())
    work.axes = {*frequency};
  else
    work.axes = std::move(single);
  return {};
}

Result<SweepDirection> direction_of(std::string_view name) {
  if (name.empty()) return SweepDirection::none;
  if (name == "up") return SweepDirection::up;
  if (name == "down") return SweepDirection::down;
  if (name == "both") return SweepDirection::both;
  return Error{"no_such_direction", {{"typed", name}}};
}

/// The axis along which points follow each other comes last: the drive's frequency, if it is swept. The
/// method's settings come first, so that points that share them run side by side.
Result<void> order_axes(SweepWork& work) {
  std::stable_partition(work.axes.begin(), work.axes.end(),
                        [](const SweepAxis& axis) { return is_method_setting(axis.name); });
  const auto move_last = [&](std::string_view name) {
    const auto at =
        std::find_if(work.axes.begin(), work.axes.end(), [&](const SweepAxis& a) { return a.name == name; });
    if (at == work.axes.end()) return false;
    std::rotate(at, at + 1, work.axes.end());
    return true;
  };
  const bool along = move_last("drive-frequency") ||
                     (work.direction != SweepDirection::none && move_last("drive-amplitude"));
  if (work.direction != SweepDirection::none && !along) return Error{"direction_along_nothing"};
  return {};
}

double first_of(const Grid& grid) { return grid[0]; }
double lowest_of(const Grid& grid) { return grid.lowest(); }
double highest_of(const Grid& grid) { return grid.highest(); }

/// The options with this value of every axis.
SimulateOptions options_at(const SweepWork& work, double (*value_of)(const Grid&)) {
  SimulateOptions options = work.base;
  const auto table = point_options(options);
  for (const SweepAxis& axis : work.axes)
    set_number(std::find_if(table.begin(), table.end(), [&](const Option& o) { return o.name == axis.name; })
                   ->target,
               value_of(axis.grid));
  return options;
}

/// The run that these options describe; what `simulate` refuses is refused.
Result<SimulatedRun> run_of(const SimulateOptions& options) {
  auto runs = set_up_runs(options);
  if (!runs) return runs.error();
  if (runs->front().general) return Error{"sweep_drives_go_on", {{"drive", options.drive}}};
  return std::move(runs->front());
}

bool has_term(const SweepWork& work, double value, std::initializer_list<std::string_view> names) {
  return value != 0 || std::any_of(work.axes.begin(), work.axes.end(), [&](const SweepAxis& axis) {
           return axis.grid.size() > 1 && std::find(names.begin(), names.end(), axis.name) != names.end();
         });
}

/// Chooses how the points are computed.
Result<void> choose_way(const SweepOptions& options, SweepWork& work) {
  const SimulateOptions& o = work.base;
  const MethodInfo& info = *find_method(work.method);
  Law law;
  for_each_term([&]<class T>() {
    if (has_term(work, o.law.*T::template members<double>[0], { T::coefficients[0].option }))
      law = law.with(law_with<T>);
  });
  if (has_term(work, o.static_friction.value_or(0), {"static-friction"})) law = law.with(law_with<Friction>);
  const bool rubs = law.has<Friction>(), linear = is_linear(law);
  const bool to_end = work.runs_to_end();
  for (const Measure* measure : work.measures)
    if (to_end && measure->of_settled_motion)
      return Error{"until_of_settled_motion", {{"measure", measure->name}}};
  if (to_end && options.settle) return Error{"settle_and_until"};
  if (to_end && work.direction != SweepDirection::none) return Error{"direction_and_until"};

  const bool in_closed_form = std::all_of(work.measures.begin(), work.measures.end(),
                                          [](const Measure* m) { return m->in_closed_form; });
  // Without a spring only stepping tells about which place the mass comes to swing.
  const bool held = has_term(work, o.stiffness.value_or(1), {"stiffness"});
  if (linear && held && !to_end && !options.settle && in_closed_form &&
      work.direction == SweepDirection::none && !info.is_adaptive())
    work.way = SweepWay::closed_form;
  else if (rubs || !info.takes_fixed_steps())
    work.way = SweepWay::one_by_one;
  else
    work.way = to_end ? SweepWay::to_end : SweepWay::settled;
  if (work.way == SweepWay::one_by_one && work.direction != SweepDirection::none)
    return Error{
        "direction_one_by_one",
        {rubs ? NoticeValue{"what", Notice{"sweep_with_friction"}} : NoticeValue{"what", work.method}}};
  return {};
}

/// Checks that the points whose motion has to settle have cycles.
Result<void> check_cycles(const SweepWork& work) {
  if (work.runs_to_end()) return {};
  for (const SweepAxis& axis : work.axes) {
    if (axis.name != "drive-frequency" && axis.name != "drive-amplitude") continue;
    const double low = axis.grid.lowest();
    if (!(low > 0)) return Error{"nothing_swings", {{"axis", axis.name}, {"low", shortest(low)}}};
  }
  return {};
}

/// Checks along each axis, the others at their first value, that every value gives an oscillator that can be
/// run.
Result<void> check_along_axes(const SweepWork& work) {
  SweepPoints points(work.base, work.axes);
  std::vector<double> values(work.axes.size());
  for (std::size_t k = 0; k < work.axes.size(); ++k) {
    points.values_of(0, values.data());
    const SweepAxis& axis = work.axes[k];
    for (std::uint64_t i = 0; i < std::min(axis.grid.size(), most_looked_at); ++i) {
      values[k] = axis.grid[i];
      const auto at = points.at(values.data());
      if (!at)
        return Error{"point_cannot_run",
                     {{"axis", axis.name},
                      {"value", shortest(values[k])},
                      {"unit", axis.unit},
                      {"what", at.error().notice}}};
    }
  }
  return {};
}

/// Why --check finds no closed form to check; empty if there is one.
Notice nothing_to_check(const SweepOptions& options, const SweepWork& work) {
  const auto none = [](const Notice& why) { return Notice{"nothing_to_check", {{"why", why}}}; };
  const MethodInfo& info = *find_method(work.method);
  if (work.way == SweepWay::closed_form)
    return info.is_exact() ? Notice{"nothing_to_check_by", {{"method", work.method}}} : Notice{};
  if (work.direction != SweepDirection::none) return none(Notice{"each_goes_on"});
  if (options.settle) return none(Notice{"settle_asks_for_steps"});
  if (work.runs_to_end()) return none(Notice{"stepped_to_an_end"});
  for (const Measure* measure : work.measures)
    if (!measure->in_closed_form) return none(Notice{"measure_by_steps", {{"measure", measure->name}}});
  if (info.is_adaptive()) return none(Notice{"chooses_its_steps", {{"method", work.method}}});
  return none(Notice{"law_not_linear"});
}

/// For a drive with few steps in its cycle.
Notice few_steps(const SimulatedRun& one, const SimulatedRun& other) {
  double fewest = enough_steps;
  for (const SimulatedRun* run : {&one, &other})
    if (run->drive.amplitude > 0 && run->drive.frequency > 0 && run->method != "exact")
      fewest = std::min(fewest, drive_period(*run) / run->step);
  return fewest < enough_steps ? Notice{"few_steps_in_a_cycle", {{"steps", fewest}}} : Notice{};
}

bool is_swept(const SweepWork& work, std::string_view option) {
  return std::any_of(work.axes.begin(), work.axes.end(),
                     [&](const SweepAxis& axis) { return axis.name == option; });
}

Notice step_notice(const SweepWork& work) {
  const MethodInfo& info = *find_method(work.method);
  const bool takes_none = info.is_exact() && work.way == SweepWay::closed_form;
  if (takes_none || info.is_adaptive() || is_swept(work, "step")) return {};
  if (work.base.step) return Notice{"steps_of", {{"step", *work.base.step}}};
  return work.driven ? Notice{"steps_in_the_shorter_period", {{"steps", default_steps_per_period}}}
                     : Notice{"steps_in_a_natural_period", {{"steps", default_steps_per_period}}};
}

Notice end_notice(const SweepWork& work) {
  if (!work.runs_to_end() || is_swept(work, "until")) return {};
  if (work.base.until) return Notice{"to_the_time", {{"until", *work.base.until}}};
  return Notice{"for_natural_periods", {{"periods", default_periods}}};
}

/// The code of its sentence.
std::string code_of(SweepWay way) {
  switch (way) {
    case SweepWay::closed_form:
      return "closed_form";
    case SweepWay::settled:
      return "stepped_until_settled";
    case SweepWay::to_end:
      return "stepped_to_the_end";
    case SweepWay::one_by_one:
      return "run_one_by_one";
  }
  return "";
}

/// Files have the code with blanks: "closed form".
std::string with_blanks(std::string code) {
  std::replace(code.begin(), code.end(), '_', ' ');
  return code;
}

/// How long the steps are and how far they go, unless that is swept or the method settles it; may be empty.
Notice steps_notice(const SweepWork& work) {
  const Notice step = step_notice(work), end = end_notice(work);
  if (step.empty() || end.empty()) return step.empty() ? end : step;
  return Notice{"steps_and_end", {{"steps", step}, {"end", end}}};
}

/// All that the rows depend on, in a fixed order, as JSON; `settings` are those of the first row.
std::string description_of(const SweepOptions& options, const SweepWork& work, const MethodSettings& settings,
                           const SweepPlan& plan) {
  std::string text = fmt::format("{{\"method\": \"{}\", \"way\": \"{}\", \"direction\": \"{}\"", work.method,
                                 with_blanks(code_of(work.way)), options.direction);
  if (work.way == SweepWay::settled || work.way == SweepWay::to_end)
    text += fmt::format(", \"simd\": \"{}\"", work.unit.name);
  if (options.settle) text += fmt::format(", \"settle\": {}", shortest(*options.settle));
  text += fmt::format(", \"tolerance\": {}, \"beta\": {}, \"gamma\": {}, \"rho_inf\": {}",
                      shortest(settings.newton.tolerance), shortest(settings.beta), shortest(settings.gamma),
                      shortest(settings.rho_inf));
  if (!is_swept(work, "step") && !work.base.step)
    text += fmt::format(", \"steps_per_period\": {:g}", default_steps_per_period);
  if (work.runs_to_end() && !work.base.until) text += fmt::format(", \"periods\": {:g}", default_periods);
  if (!work.base.drive.empty()) text += fmt::format(", \"drive\": \"{}\"", work.base.drive);
  for (const auto& [name, value] : options.values)
    if (!value.empty()) text += fmt::format(", \"{}\": \"{}\"", name, value);
  text += ", \"columns\": [";
  for (std::size_t i = 0; i < plan.rows.columns.size(); ++i)
    text += fmt::format("{}\"{}\"", i ? ", " : "", plan.rows.columns[i]);
  return text + "]}";
}

std::string axis_column(const SweepAxis& axis, std::string_view unit) {
  const std::string name = with_underscores(axis.name);
  return unit.empty() ? name : fmt::format("{} ({})", name, unit);
}

/// Describes the rows and how they are made.
void describe_rows(const SweepOptions& options, const SweepWork& work, SweepPlan& plan) {
  plan.method = work.method;
  plan.simd = work.unit.name;
  plan.way = work.settling.dropped ? Notice{"cycles_dropped", {{"cycles", *options.settle}}}
                                   : Notice{code_of(work.way)};
  plan.steps = steps_notice(work);
  for (const SweepAxis& axis : work.axes)
    plan.swept.push_back({axis.name, axis_column(axis, axis.unit), axis.grid.size(),
                          axis_column(axis, axis.typed.name), axis.typed.factor});
  for (const SweptOption& swept : plan.swept) plan.rows.columns.push_back(swept.column);
  for (const Measure* measure : work.measures)
    for (const std::string& column : measure->columns) plan.measured.push_back(column);
  plan.rows.columns.insert(plan.rows.columns.end(), plan.measured.begin(), plan.measured.end());
  plan.rows.columns.emplace_back("status");
  plan.rows.rows = 1;
  for (const SweepAxis& axis : work.axes) plan.rows.rows *= axis.grid.size();
  plan.rows.rows_per_chunk = work.rows_per_chunk();
  plan.rows.description =
      description_of(options, work, SweepPoints(work.base, work.axes).settings_of(0), plan);
}

}  // namespace

Result<SweepPlan> plan_sweep(const SweepOptions& options) {
  auto work = std::make_shared<SweepWork>();
  work->base = options.simulate;
  if (work->base.method.empty()) work->base.method = {has_loss_factor(options) ? "exact" : "euler-cromer"};
  if (work->base.method.size() > 1) return Error{"one_method", {{"methods", work->base.method.size()}}};
  work->method = work->base.method.front();
  if (auto good = read_values(options, *work); !good) return good.error();
  const auto direction = direction_of(options.direction);
  if (!direction) return direction.error();
  work->direction = *direction;
  if (auto good = order_axes(*work); !good) return good.error();
  if (auto good = check_loss_factor(options, *work); !good) return good.error();

  double rows = 1;
  for (const SweepAxis& axis : work->axes) rows *= static_cast<double>(axis.grid.size());
  if (!(rows < most_rows)) return Error{"too_many_points", {{"points", rows}}};
  if (const auto first = run_of(options_at(*work, first_of)); !first) return first.error();
  if (auto good = check_along_axes(*work); !good) return good.error();
  const SimulateOptions highest = options_at(*work, highest_of);
  const auto low = run_of(options_at(*work, lowest_of)), high = run_of(highest);
  if (!low) return low.error();
  if (!high) return high.error();
  if (work->direction == SweepDirection::both)
    work->axes.insert(work->axes.begin(), {std::string(direction_axis), "", Grid({1, -1})});
  work->driven = high->drive.amplitude > 0 && high->drive.frequency > 0;

  auto measures = find_measures(options.measure, work->driven);
  if (!measures) return measures.error();
  work->measures = *std::move(measures);
  for (const Measure* measure : work->measures)
    if (measure->of_base && work->base.drive != "base")
      return Error{"measure_of_base", {{"measure", measure->name}}};
  if (auto good = check_settled_loss(options, *work); !good) return good.error();
  if (auto good = choose_way(options, *work); !good) return good.error();
  if (auto good = check_cycles(*work); !good) return good.error();
  work->settling.dropped = options.settle;
  auto unit = choose_unit_by_environment();
  if (!unit) return unit.error();
  work->unit = *unit;

  SweepPlan plan;
  describe_rows(options, *work, plan);
  plan.rows.make = [work, per_chunk = plan.rows.rows_per_chunk, all = plan.rows.rows](
                       std::uint64_t chunk, double* to, const Watch& watch) {
    const std::uint64_t first = chunk * per_chunk;
    return make_rows(*work, first, std::min(per_chunk, all - first), to, watch);
  };
  plan.notices = setup_notices(highest, {*low, *high});
  std::erase_if(plan.notices, [](const Notice& notice) { return notice.code == "last_step_is_shorter"; });
  if (Notice few = few_steps(*low, *high); !few.empty()) plan.notices.push_back(std::move(few));
  if (options.check)
    if (Notice none = nothing_to_check(options, *work); !none.empty())
      plan.notices.push_back(std::move(none));
  plan.work = work;
  return plan;
}

}  // namespace cromer::core
