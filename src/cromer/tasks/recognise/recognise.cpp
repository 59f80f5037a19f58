#include "cromer/tasks/recognise/recognise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "cromer/analysis/measured_oscillator.h"
#include "cromer/base/pi.h"
#include "cromer/methods/all.h"
#include "cromer/model/law.h"
#include "cromer/model/linear_quantities.h"
#include "cromer/run/step_control.h"
#include "cromer/tasks/methods/law_before_method.h"
#include "cromer/tasks/recognise/maker.h"
#include "cromer/tasks/recognise/recorded_states.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

constexpr std::size_t rows_to_screen = 100, most_listed = 8;
/// That may be asked for under a law that is not linear: its steps are gone through one by one.
constexpr long long most_steps_per_row = 500;
/// Rows that a method made are off its states by at most this many times what rounding does to them.
constexpr double most_roundings = 3;
/// Two programs that add up the same law differ by at least this.
constexpr double least_rounding = 2e-13;
/// What a step in single precision adds to that.
constexpr double single_rounding = 6e-8;

/// How many steps rows may be apart: every number up to 100, then round ones.
std::vector<long long> steps_per_row() {
  std::vector<long long> all;
  for (long long k = 1; k <= 100; ++k) all.push_back(k);
  for (const long long k :
       {120, 125, 128, 144, 150, 160, 180, 200, 240, 250, 256, 300, 400, 480, 500, 600, 1000})
    all.push_back(k);
  return all;
}

struct CandidateMaker {
  Maker maker;
  MakerFit fit{};
};

/// What all candidates are measured by.
struct Evidence {
  Trajectory rows;
  Yardstick yardstick;
  Freedom freedom;
  Origin guess{};
  std::vector<long long> steps_per_row;
  MethodSettings settings;
  double rounding = 0;

  std::size_t size() const { return rows.size(); }
};

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

Trajectory first_rows(const Trajectory& rows, std::size_t count) {
  const auto cut = [&](const std::vector<double>& values) {
    return std::vector<double>(values.begin(),
                               values.begin() + static_cast<std::ptrdiff_t>(std::min(count, values.size())));
  };
  return {cut(rows.t), cut(rows.x), cut(rows.v)};
}

/// Whether the closed form can be run.
bool has_closed_form(const Oscillator<double>& law) {
  const std::string_view why_not = why_not_exact(law);
  return why_not.empty() || why_not == Friction::coefficients[0].option;
}

MethodSettings with_tolerance(MethodSettings settings, double tolerance) {
  settings.newton.tolerance = tolerance;
  return settings;
}

/// Those whose states show no step.
std::vector<Maker> makers_without_steps(const Evidence& evidence) {
  std::vector<Maker> makers;
  for (const MethodInfo& info : method_infos) {
    if (info.is_adaptive())
      for (const double tolerance : {StepControl::default_tolerance, 1e-13})
        makers.push_back({info.name, with_tolerance(evidence.settings, tolerance)});
    if (info.is_exact() && has_closed_form(evidence.guess.law))
      makers.push_back({info.name, evidence.settings});
  }
  return makers;
}

/// The law itself: its closed form, else an adaptive method of the smallest tolerance.
Maker law_itself(const Evidence& evidence) { return makers_without_steps(evidence).back(); }

/// Whether so many steps a row are too many to go through; a linear law has one matrix for all, and the one
/// number that is asked for is tried in any case.
bool too_many_steps(const Evidence& evidence, long long steps_per_row, std::size_t rows) {
  constexpr double most = 3e3;
  return evidence.steps_per_row.size() > 1 && !is_linear(law_of(evidence.guess.law)) &&
         static_cast<double>(steps_per_row) * static_cast<double>(rows) > most;
}

/// All methods with all steps, those of fixed steps with as few steps as tell them from the law itself.
std::vector<CandidateMaker> all_candidates(const Evidence& evidence, const Trajectory& few) {
  std::vector<CandidateMaker> candidates;
  for (const Maker& maker : makers_without_steps(evidence)) candidates.push_back({maker});
  const Trajectory itself = states_made_by(law_itself(evidence), evidence.guess, few.size());
  const Yardstick of_few{rms(few.x), rms(few.v)};
  // What is off in the first rows grows with time.
  const double growth = static_cast<double>(evidence.size()) / static_cast<double>(few.size());
  for (const MethodInfo& info : method_infos) {
    if (!info.takes_fixed_steps()) continue;
    for (const long long k : evidence.steps_per_row) {
      if (too_many_steps(evidence, k, few.size())) break;
      const Maker maker{info.name, evidence.settings, k};
      const Trajectory made = states_made_by(maker, evidence.guess, few.size());
      if (made.size() == few.size() && growth * of_few.distance(made, itself) < 0.03 * evidence.rounding)
        break;
      candidates.push_back({maker});
      if (info.name == EulerCromer::info.name)
        candidates.push_back({Maker{info.name, evidence.settings, k, true}});
    }
  }
  return candidates;
}

/// Where the fit begins: the guess; where the law is sought, the law that this method turns into the guess;
/// and of a velocity that is ahead, the one a step before.
Origin start_of(const Maker& maker, const Evidence& evidence) {
  Origin start = evidence.guess;
  constexpr int rounds = 8;
  for (int i = 0; i < rounds && maker.velocity_ahead; ++i)
    if (const Trajectory first = states_made_by(maker, start, 1); first.size() == 1)
      start.start.v += evidence.guess.start.v - first.v.front();
  if (!evidence.freedom.law || !maker.shows_steps()) return start;
  const double step = start.spacing / static_cast<double>(maker.steps_per_row);
  const auto before = law_before_method(maker.method, maker.settings, step,
                                        natural_frequency(start.law) / two_pi, damping_ratio(start.law));
  if (before)
    start.law = {.mass = 1, .stiffness = before->law.stiffness, .damping = 2 * before->law.decay_rate};
  return start;
}

/// Fits the candidates to the rows, and puts the nearest first.
template <class Iterations>
void fit_all(std::vector<CandidateMaker>& candidates, const Trajectory& rows, const Evidence& evidence,
             const Watch& watch, const Iterations& iterations) {
  for (CandidateMaker& each : candidates)
    if (!watch.interrupted())
      each.fit = fit_maker(each.maker, rows, evidence.yardstick, evidence.freedom,
                           start_of(each.maker, evidence), iterations(each.maker));
  std::stable_sort(
      candidates.begin(), candidates.end(),
      [](const CandidateMaker& a, const CandidateMaker& b) { return a.fit.distance < b.fit.distance; });
}

/// Of candidates sorted by distance: keeps the nearest of each method, and the nearest of all others.
void keep_nearest(std::vector<CandidateMaker>& candidates) {
  constexpr std::size_t of_all = 40, of_each = 8;
  std::map<std::pair<std::string_view, bool>, std::size_t> kept;
  std::size_t place = 0;
  std::erase_if(candidates, [&](const CandidateMaker& each) {
    return ++kept[{each.maker.method, each.maker.velocity_ahead}] > of_each && ++place > of_all;
  });
}

/// Methods that carry an acceleration of their own, where the first row is not the start of their run: those
/// of which nothing is left beside rounding.
std::vector<CandidateMaker> begun_before(const Evidence& evidence, const Watch& watch) {
  std::vector<CandidateMaker> candidates;
  for (const MethodInfo& info : method_infos)
    for (const long long k : evidence.steps_per_row) {
      const Maker maker{info.name, evidence.settings, k, false, true};
      if (!carries_acceleration(maker) || too_many_steps(evidence, k, rows_to_screen)) break;
      // Where the motion has died out by then, nothing is told by what follows.
      const std::size_t left_out = rows_left_out(maker, evidence.size());
      const double rest =
          rms({evidence.rows.x.begin() + static_cast<std::ptrdiff_t>(left_out), evidence.rows.x.end()});
      if (rest > 0.1 * evidence.yardstick.x) candidates.push_back({maker});
    }
  const int tries = evidence.freedom.law ? 4 : 1;
  fit_all(candidates, first_rows(evidence.rows, 2 * rows_to_screen), evidence, watch,
          [&](const Maker&) { return tries; });
  keep_nearest(candidates);
  fit_all(candidates, evidence.rows, evidence, watch, [&](const Maker&) { return 2 * tries + 2; });
  std::erase_if(candidates, [&](const CandidateMaker& each) {
    return !(each.fit.distance <= most_roundings * evidence.rounding);
  });
  return candidates;
}

/// All methods, as near to the rows as they come, the nearest first.
std::vector<CandidateMaker> try_all(const Evidence& evidence, const Watch& watch) {
  const Trajectory few = first_rows(evidence.rows, rows_to_screen);
  std::vector<CandidateMaker> candidates = all_candidates(evidence, few);
  // At a first look the first row will do as a start, where it shows all of the state.
  fit_all(candidates, few, evidence, watch, [&](const Maker&) { return evidence.freedom.law ? 3 : 0; });
  keep_nearest(candidates);
  fit_all(candidates, evidence.rows, evidence, watch,
          [&](const Maker&) { return evidence.freedom.law ? 15 : 4; });
  if (candidates.front().fit.distance <= most_roundings * evidence.rounding) return candidates;
  std::vector<CandidateMaker> others = begun_before(evidence, watch);
  candidates.insert(candidates.begin(), others.begin(), others.end());
  return candidates;
}

/// How much worse than the best, in the digits of the file: the rise of chi^2.
double rise_of(const CandidateMaker& each, const CandidateMaker& best, const Evidence& evidence) {
  const double unit = std::max(best.fit.distance, evidence.rounding);
  const double d = each.fit.distance / unit, least = best.fit.distance / unit;
  return 2 * static_cast<double>(evidence.size()) * (d * d - least * least);
}

/// Brings those that the digits do not tell from the nearest to the front: among them the law itself comes
/// first, then those with the fewest steps a row. Their number.
std::size_t settle_ties(std::vector<CandidateMaker>& candidates, const Evidence& evidence) {
  constexpr double told_apart = 12;
  const CandidateMaker best = candidates.front();
  const auto end = std::stable_partition(
      candidates.begin(), candidates.end(),
      [&](const CandidateMaker& each) { return rise_of(each, best, evidence) < told_apart; });
  // A law that was fitted with a damping below 0 is the less likely one.
  const auto feeds = [&](const CandidateMaker& each) {
    return evidence.freedom.law && damping_ratio(each.fit.origin.law) < -1e-9;
  };
  std::stable_sort(candidates.begin(), end, [&](const CandidateMaker& a, const CandidateMaker& b) {
    if (feeds(a) != feeds(b)) return feeds(b);
    if (a.maker.shows_steps() != b.maker.shows_steps()) return b.maker.shows_steps();
    return a.maker.steps_per_row < b.maker.steps_per_row;
  });
  return static_cast<std::size_t>(end - candidates.begin());
}

/// Whether two methods give the same states, from one origin. Those that show no step are the same if the
/// digits of the file show no difference.
bool same_states(const Maker& one, const Maker& other, const Origin& origin, const Evidence& evidence) {
  constexpr std::size_t rows_to_compare = 30;
  const std::size_t rows = std::min(evidence.size(), one.shows_steps() ? rows_to_compare : evidence.size());
  const Trajectory made = states_made_by(one, origin, rows), beside = states_made_by(other, origin, rows);
  if (made.size() < rows || beside.size() < rows) return false;
  const bool by_steps = !is_linear(law_of(origin.law));
  const double steps = by_steps ? static_cast<double>(rows) * static_cast<double>(one.steps_per_row) : 0;
  const double most = one.shows_steps() ? 1e-14 + 1e-15 * steps : evidence.rounding;
  return Yardstick{rms(made.x), rms(made.v)}.distance(made, beside) < most;
}

/// All methods that make the states of this one with the same steps, in the order of the registry.
std::vector<std::string_view> methods_like(const CandidateMaker& of, const Evidence& evidence) {
  std::vector<std::string_view> names;
  for (const MethodInfo& info : method_infos) {
    Maker other = of.maker;
    other.method = info.name;
    const bool itself = info.name == of.maker.method;
    if (!itself && (of.maker.velocity_ahead || info.takes_fixed_steps() != of.maker.shows_steps() ||
                    (info.is_exact() && !has_closed_form(of.fit.origin.law))))
      continue;
    if (info.is_adaptive() && !itself) other.settings.newton.tolerance = StepControl::default_tolerance;
    if (itself || same_states(of.maker, other, of.fit.origin, evidence)) names.push_back(info.name);
  }
  return names;
}

/// What the method added: of a linear law from its map, of others from the turning points of its states and
/// of those of the law itself.
void say_what_it_added(const CandidateMaker& candidate, const Evidence& evidence, RecognisedMethod& found) {
  if (!candidate.maker.shows_steps()) {
    if (find_method(candidate.maker.method)->is_exact()) found.decay_rate_added = found.frequency_shift = 0;
    return;
  }
  Origin origin = candidate.fit.origin;
  const auto k = static_cast<double>(candidate.maker.steps_per_row);
  const double step = origin.spacing / k;
  if (is_linear(law_of(origin.law))) {
    const LinearLaw<double> law = linear_law(origin.law);
    const EffectiveOscillator effective =
        effective_oscillator_of(candidate.maker.method, candidate.maker.settings, law, step);
    if (!effective.decay_rate || !effective.angular_frequency || !(damped_frequency(law) > 0)) return;
    const auto beside = [&](double difference) {
      constexpr double rounding = 1e-13;  // of the effective oscillator
      return std::abs(difference) > rounding * natural_frequency(origin.law) ? difference : 0;
    };
    found.decay_rate_added = beside(*effective.decay_rate - law.decay_rate);
    found.frequency_shift = beside(*effective.angular_frequency - damped_frequency(law));
    return;
  }
  origin.spacing = step;
  const std::size_t states =
      (evidence.size() - 1) * static_cast<std::size_t>(candidate.maker.steps_per_row) + 1;
  Maker every_step = candidate.maker;
  every_step.steps_per_row = 1;
  every_step.velocity_ahead = false;
  const auto made = measure_oscillator(states_made_by(every_step, origin, states));
  const auto itself = measure_oscillator(states_made_by(law_itself(evidence), origin, states));
  if (!made || !itself) return;
  found.decay_rate_added = made->decay_rate - itself->decay_rate;
  found.frequency_shift = made->angular_frequency - itself->angular_frequency;
}

/// Whether the list has a method already, by itself or among those of the same map; `with_step`: with this
/// step.
bool lists(const std::vector<RecognisedMethod>& all, const Maker& maker, std::string_view method,
           bool with_step) {
  return std::any_of(all.begin(), all.end(), [&](const RecognisedMethod& found) {
    return (!with_step || found.steps_per_row == maker.steps_per_row) &&
           found.velocity_ahead == maker.velocity_ahead && found.step.has_value() == maker.shows_steps() &&
           (found.method == method ||
            std::find(found.same_map.begin(), found.same_map.end(), method) != found.same_map.end());
  });
}

/// Puts the nearest into the result, those with the same map in one: the first `tied`, which are alike, and
/// each other method with the step by which it comes nearest.
void list(const std::vector<CandidateMaker>& candidates, std::size_t tied, const Evidence& evidence,
          RecogniseResult& result) {
  result.recognised.clear();
  result.alike = 0;
  for (std::size_t i = 0; i < candidates.size() && result.recognised.size() < most_listed; ++i) {
    const CandidateMaker& each = candidates[i];
    const auto is_listed = [&](std::string_view method) {
      return lists(result.recognised, each.maker, method, i < tied);
    };
    if (!std::isfinite(each.fit.distance) || is_listed(each.maker.method)) continue;
    const std::vector<std::string_view> like = methods_like(each, evidence);
    if (std::any_of(like.begin(), like.end(), is_listed)) continue;
    RecognisedMethod& found = result.recognised.emplace_back();
    found.method = like.front();
    found.same_map.assign(like.begin() + 1, like.end());
    found.steps_per_row = each.maker.steps_per_row;
    found.velocity_ahead = each.maker.velocity_ahead;
    found.distance = each.fit.distance;
    if (each.maker.shows_steps())
      found.step = each.fit.origin.spacing / static_cast<double>(each.maker.steps_per_row);
    say_what_it_added(each, evidence, found);
    if (i < tied) ++result.alike;
  }
}

/// Whether the first made the rows: it is as near as rounding allows, or far nearer than the next that the
/// digits tell from it.
bool has_made(const std::vector<CandidateMaker>& candidates, std::size_t tied, const Evidence& evidence) {
  constexpr double far_nearer = 0.02, near = 1e-3;
  const double best = candidates.front().fit.distance;
  if (best <= most_roundings * evidence.rounding) return true;
  return best < near && tied < candidates.size() && best < far_nearer * candidates[tied].fit.distance;
}

/// The frequency and the decay that the rows themselves show, as a law to begin with.
std::optional<Oscillator<double>> law_of_rows(const RecordedStates& states, const Yardstick& yardstick) {
  const auto seen = measure_recurrence(states.rows.x, states.spacing, yardstick.v / yardstick.x);
  if (!seen) return std::nullopt;
  const double w = seen->angular_frequency, b = seen->decay_rate;
  return Oscillator<double>{.mass = 1, .stiffness = w * w + b * b, .damping = 2 * b};
}

Result<std::vector<long long>> steps_asked_for(const MethodsOptions& options, double spacing) {
  if (!options.step) return steps_per_row();
  const double steps = spacing / *options.step, whole = std::round(steps);
  constexpr double slack = 1e-5;
  if (!(whole >= 1) || std::abs(steps / whole - 1) > slack)
    return Error{"step_not_part_of_spacing", {{"step", *options.step}, {"spacing", spacing}}};
  return std::vector<long long>{static_cast<long long>(whole)};
}

Notice step_in_words(const RecognisedMethod& found) {
  if (!found.step) return Notice{"maker_without_step", {{"method", found.method}}};
  return Notice{found.velocity_ahead ? "maker_with_velocity_ahead" : "maker_with_step",
                {{"method", found.method}, {"step", *found.step}}};
}

/// The methods that make the same states, as a bracket; empty if there is none.
Notice same_map_in_words(const RecognisedMethod& found) {
  if (found.same_map.empty()) return {};
  return Notice{"the_same_map",
                {{"methods", std::vector<std::string>(found.same_map.begin(), found.same_map.end())}}};
}

/// How many others the digits do not tell from the first; empty if there is none.
Notice others_in_words(const RecogniseResult& result) {
  if (result.alike < 2) return {};
  return Notice{"or_others_alike", {{"count", result.alike - 1}}};
}

/// What it added, as a sentence; empty where nothing swings.
Notice added_in_words(const RecognisedMethod& found) {
  if (!found.step || !found.decay_rate_added || !found.frequency_shift) return {};
  return Notice{"method_added", {{"rate", *found.decay_rate_added}, {"shift", *found.frequency_shift}}};
}

/// The damping ratio of the law, 0 where it is rounding.
double ratio_to_say(const RecogniseResult& result) {
  const double ratio = result.damping_ratio.value_or(0);
  return std::abs(ratio) > 1e-12 ? ratio : 0;
}

/// `one_step`: no others were tried.
Notice answer_in_words(const RecogniseResult& result, bool one_step) {
  if (result.recognised.empty()) return Notice{"no_method_gets_through"};
  const RecognisedMethod& best = result.recognised.front();
  switch (result.verdict) {
    case Verdict::made:
      return Notice{"rows_made_by",
                    {{"maker", step_in_words(best)},
                     {"same", same_map_in_words(best)},
                     {"others", others_in_words(result)},
                     {"added", added_in_words(best)}}};
    case Verdict::the_law: {
      std::vector<std::string> names{std::string(best.method)};
      names.insert(names.end(), best.same_map.begin(), best.same_map.end());
      if (best.distance > most_roundings * result.rounding)
        return Notice{"rows_follow_the_law_nearly", {{"percent", 100 * best.distance}, {"methods", names}}};
      return Notice{"rows_follow_the_law", {{"methods", names}}};
    }
    case Verdict::other_law:
      return Notice{"rows_made_from_other_law",
                    {{"maker", step_in_words(best)},
                     {"same", same_map_in_words(best)},
                     {"others", others_in_words(result)},
                     {"frequency", result.natural_frequency.value_or(0)},
                     {"ratio", ratio_to_say(result)}}};
    case Verdict::none:
      break;
  }
  constexpr double alike = 2;
  const bool all_alike =
      !one_step && result.recognised.size() > 1 && result.recognised.back().distance < alike * best.distance;
  return Notice{all_alike ? "rows_made_by_none_of_all_alike" : "rows_made_by_none",
                {{"maker", step_in_words(best)},
                 {"percent", 100 * best.distance},
                 {"times", best.distance / result.rounding}}};
}

void set_law(RecogniseResult& result, const Oscillator<double>& law) {
  result.law = law;
  if (const double w = natural_frequency(law); w > 0) {
    result.natural_frequency = w;
    result.damping_ratio = damping_ratio(law);
  }
}

/// Whether the rows follow the law itself, if not to their digits, and nothing comes much nearer: then it
/// comes to the front.
bool follows_the_law(std::vector<CandidateMaker>& candidates) {
  constexpr double near = 1e-4, as_well = 5;
  const auto itself = std::find_if(candidates.begin(), candidates.end(),
                                   [](const CandidateMaker& each) { return !each.maker.shows_steps(); });
  double best = candidates.front().fit.distance;
  for (const CandidateMaker& each : candidates) best = std::min(best, each.fit.distance);
  if (itself == candidates.end() || itself->fit.distance > near || itself->fit.distance > as_well * best)
    return false;
  std::rotate(candidates.begin(), itself, itself + 1);
  return true;
}

/// Tries all methods and puts the nearest into the result; whether the first made the rows.
bool judge(const Evidence& evidence, RecogniseResult& result, const Watch& watch) {
  std::vector<CandidateMaker> candidates = try_all(evidence, watch);
  std::size_t tied = settle_ties(candidates, evidence);
  bool made = has_made(candidates, tied, evidence);
  if (!made && !evidence.freedom.law && follows_the_law(candidates)) {
    made = true;
    tied = 1;
  }
  list(candidates, made ? tied : 0, evidence, result);
  result.verdict = !made                                    ? Verdict::none
                   : candidates.front().maker.shows_steps() ? Verdict::made
                                                            : Verdict::the_law;
  if (made) set_law(result, candidates.front().fit.origin.law);
  return made;
}

/// The law that the options give; nothing where they give none.
Result<std::optional<Oscillator<double>>> law_given(const RecogniseOptions& options) {
  SimulateOptions law = options.simulate;
  law.natural_frequency = options.methods.natural_frequency;
  law.damping_ratio = options.methods.damping_ratio;
  if (law.stiffness && law.natural_frequency) return Error{"spring_set_twice"};
  if (law.damping.has_value() + law.damping_ratio.has_value() + law.quality_factor.has_value() > 1)
    return Error{"damping_set_twice"};
  const bool spring = law.stiffness || law.natural_frequency;
  const bool others = !(law.law == Oscillator<double>{}) || law.static_friction || law.damping ||
                      law.damping_ratio || law.quality_factor;
  if (!spring && !others) return std::optional<Oscillator<double>>();
  if (!spring && law.law.pendulum == 0) return Error{"law_without_spring"};
  if (!spring) law.stiffness = 0;
  auto oscillator = oscillator_of(law);
  if (!oscillator) return oscillator.error();
  return std::optional(*oscillator);
}

Result<void> check_ranges_of(RecogniseOptions options) {
  for (const auto& option : options_of(options))
    if (auto good = check(option); !good) return good;
  return {};
}

/// What candidates are measured by, but for the law.
Evidence evidence_of(const RecordedStates& states, const MethodsOptions& options,
                     std::vector<long long> steps) {
  Evidence evidence;
  evidence.rows = states.rows;
  evidence.yardstick = {rms(states.rows.x), rms(states.rows.v)};
  const double x_rounding = states.x_rounding / evidence.yardstick.x;
  const double v_rounding = states.v_rounding / evidence.yardstick.v;
  evidence.rounding = std::max(
      std::sqrt((x_rounding * x_rounding + v_rounding * v_rounding) / 2),
      states.single ? single_rounding * std::sqrt(static_cast<double>(evidence.size())) : least_rounding);
  evidence.freedom = {.spacing_error = states.spacing_error, .rounding = evidence.rounding};
  evidence.guess = {.start = {evidence.rows.x.front(), evidence.rows.v.front()}, .spacing = states.spacing};
  evidence.steps_per_row = std::move(steps);
  evidence.settings.newton.tolerance = 1e-14;
  evidence.settings.beta = options.beta.value_or(evidence.settings.beta);
  evidence.settings.gamma = options.gamma.value_or(evidence.settings.gamma);
  evidence.settings.rho_inf = options.rho_inf.value_or(evidence.settings.rho_inf);
  return evidence;
}

void add_notices(RecogniseResult& result) {
  if (result.verdict == Verdict::made &&
      result.recognised.front().distance > most_roundings * result.rounding)
    result.notices.push_back(Notice{"more_is_left_than_rounding",
                                    {{"times", result.recognised.front().distance / result.rounding}}});
  if (result.law_fitted && result.ok() && result.natural_frequency)
    result.notices.push_back(Notice{
        "law_was_fitted", {{"frequency", *result.natural_frequency}, {"ratio", ratio_to_say(result)}}});
}

}  // namespace

Result<RecogniseResult> recognise(const Recording& recording, const RecogniseOptions& options,
                                  const Watch& watch) {
  if (auto good = check_ranges_of(options); !good) return good.error();
  const auto law = law_given(options);
  if (!law) return law.error();
  const auto states = recorded_states(
      recording, {options.column, options.velocity_column, options.run.value_or(0)}, options.read);
  if (!states) return states.error();
  auto steps = steps_asked_for(options.methods, states->spacing);
  if (!steps) return steps.error();
  if (options.methods.step && *law && !is_linear(law_of(**law)) && steps->back() > most_steps_per_row)
    return Error{"too_many_steps_a_row", {{"steps", steps->back()}, {"most", most_steps_per_row}}};
  Evidence evidence = evidence_of(*states, options.methods, *std::move(steps));
  if (!(evidence.yardstick.x > 0 && evidence.yardstick.v > 0)) return Error{"run_stands_still"};
  const auto of_rows = law_of_rows(*states, evidence.yardstick);
  if (!*law && !of_rows) return Error{"law_is_needed"};
  evidence.freedom.law = !*law;
  evidence.guess.law = *law ? **law : *of_rows;

  RecogniseResult result;
  result.file = recording.file;
  result.rows = evidence.size();
  result.spacing = states->spacing;
  result.rounding = evidence.rounding;
  result.law_fitted = !*law;
  set_law(result, evidence.guess.law);
  if (!judge(evidence, result, watch) && *law && is_linear(law_of(**law)) && of_rows) {
    Evidence free = evidence;
    free.freedom.law = true;
    free.guess.law = *of_rows;
    RecogniseResult other = result;
    if (judge(free, other, watch)) {
      result = std::move(other);
      result.verdict = Verdict::other_law;
      result.law_fitted = true;
    }
  }
  result.words = watch.interrupted() ? Notice{"recognising_was_interrupted"}
                                     : answer_in_words(result, options.methods.step.has_value());
  add_notices(result);
  return result;
}

}  // namespace cromer::core
