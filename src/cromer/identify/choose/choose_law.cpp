#include "cromer/identify/choose/choose_law.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "cromer/base/at_once.h"
#include "cromer/base/for_page.h"
#include "cromer/base/pi.h"
#include "cromer/identify/choose/criterion.h"
#include "cromer/identify/choose/readings.h"
#include "cromer/identify/diagnose/doubts.h"
#include "cromer/identify/diagnose/outliers.h"
#include "cromer/identify/diagnose/refusal.h"
#include "cromer/identify/fit_motion.h"
#include "cromer/identify/fit_settings.h"
#include "cromer/model/law_force.h"

namespace cromer::core {
namespace {

// The most samples that laws are compared on: this bounds the time that a choice takes. A record of up to
// 200,000 samples, 5 enough_samples or 2 enough_driven, is compared whole: a part would cost a second fit
// to all.
constexpr std::size_t enough_samples = 40'000, enough_driven = 100'000;
constexpr double samples_per_period = 16;

struct Selection {
  std::vector<double> t, y;
  Record like;
  std::size_t stride = 1;
  std::size_t end = 0;  ///< one past the last sample of the record that was considered

  Record record() const {
    Record part = like;
    part.t = t;
    part.y = y;
    return part;
  }
};

// As long a beginning of the record as laws are compared on in so many steps, to within the noise that is
// left from sample to sample: the less of it, the finer the steps, and the sooner laws are told apart.
double time_to_compare(const Record& record, const LawFit& viscous) {
  constexpr double most_steps = 50'000;
  const double amplitude = sinusoid_amplitude(record.y);
  const double noise = noise_of(motion_residuals(viscous.motion, viscous.drive, record, viscous.step));
  const double error = comparing_share * std::max(noise / amplitude, least_residual / std::sqrt(2.0)) /
                       std::sqrt(static_cast<double>(enough_samples));
  double time = record.t.back() - record.t.front();
  while (time > most_steps * motion_step(viscous.angular_frequency().value, time, error)) time *= 0.9;
  return time;
}

// One sample in `stride`, at least sixteen in a period, of as long a beginning of the record as that takes
// and as laws are compared on.
Selection select(const Record& record, const LawFit& viscous) {
  Selection part;
  part.like = record;
  const double end = record.t.front() + time_to_compare(record, viscous);
  const auto n = std::max(
      enough_samples,
      static_cast<std::size_t>(std::upper_bound(record.t.begin(), record.t.end(), end) - record.t.begin()));
  const double h = (record.t[n - 1] - record.t.front()) / static_cast<double>(n - 1);
  const double most = two_pi / (viscous.angular_frequency().value * h * samples_per_period);
  const std::size_t wanted = (n + enough_samples - 1) / enough_samples;
  part.stride = static_cast<std::size_t>(std::clamp(most, 1.0, static_cast<double>(wanted)));
  part.end = std::min(n, part.stride * enough_samples);
  for (std::size_t i = 0; i < part.end; i += part.stride) {
    part.t.push_back(record.t[i]);
    part.y.push_back(record.y[i]);
  }
  return part;
}

// Every sum of dampings with each spring that is met often, and for angles as a pendulum; the simplest first,
// then those most often found.
std::vector<Law> free_candidates(bool angle) {
  std::vector<Law> laws{law_of("viscous"), law_of("viscous+drag"), law_of("viscous+cubic"),
                        law_of("viscous+drag+cubic")};
  std::vector<Law> shapes{law_with<Spring>, law_with<Spring, Cubic>, law_with<Spring, OddQuadratic>};
  if (angle) shapes.push_back(law_with<Pendulum>);
  const Law each[] = {law_with<Viscous>, law_with<Drag>, law_with<Friction>};
  for (const Law& shape : shapes)
    for (unsigned set = 1; set < 8; ++set) {
      Law law = shape;
      for (unsigned i = 0; i < 3; ++i)
        if (set >> i & 1U) law = law.with(each[i]);
      if (std::find(laws.begin(), laws.end(), law) == laws.end()) laws.push_back(law);
    }
  return laws;
}

// Of a driven motion: the springs that are met often, each by itself and with drag or friction; under a
// harmonic drive also drag alone, which a steady amplitude does not tell from viscous damping.
std::vector<Law> driven_candidates(const Law& linear, DriveKind drive) {
  std::vector<Law> laws;
  if (drive == DriveKind::harmonic) laws.push_back(linear.without(law_with<Viscous>).with(law_with<Drag>));
  for (const Law& shape :
       {Law{}, law_with<Cubic>, law_with<Quadratic>, law_with<Quadratic, Cubic>, law_with<OddQuadratic>})
    for (const Law& damping : {Law{}, law_with<Drag>, law_with<Friction>})
      if (linear.shares(springs) || shape == Law{}) laws.push_back(linear.with(shape).with(damping));
  return laws;
}

// What may be added where something is left.
constexpr Law additions[] = {
    law_with<Drag>,         law_with<Friction>,           law_with<Cubic>,
    law_with<OddQuadratic>, law_with<Quadratic>,          law_with<Quadratic, Cubic>,
    law_with<Quintic>,      law_with<Viscous, VanDerPol>, law_with<OddQuadratic, Quintic>,
    law_with<Hysteresis>};

// Terms that look alike unless the record is good: both make the same change at the record's middle
// amplitude.
struct LookAlikes {
  Law met_often, rare;
};
constexpr LookAlikes look_alikes[] = {{law_with<Drag>, law_with<Viscous, VanDerPol>},
                                      {law_with<Cubic>, law_with<Quintic>}};

// True if a law may be compared with others.
bool is_comparable(const LawFit& fit) {
  return fit.has_values() && (fit.status == FitStatus::converged || fit.status == FitStatus::iteration_limit);
}

// Place of the candidate of lowest BIC but one.
std::optional<std::size_t> runner_up(const std::vector<LawFit>& candidates, std::size_t best) {
  std::optional<std::size_t> second;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (i != best && candidates[i].status == FitStatus::converged &&
        (!second || candidates[i].bic < candidates[*second].bic))
      second = i;
  return second;
}

// The fits of one record under one drive, and the choice among them as it grows.
class LawSearch {
 public:
  /// `before`: fits of the same motion without some of its samples, or with more; each law begins at its own.
  LawSearch(const Record& record, const LawFitOptions& options, const Watch& watch,
            std::span<const LawFit> before = {})
      : record_(record),
        options_(options),
        watch_(watch),
        quiet_{watch.interrupt, {}, watch.pulse, watch.steps_left},
        before_(before),
        expected_(options.on_arc ? law_with<Pendulum> : Law{}) {}

  LawChoice among_free(double progress_end) {
    const Beginning beginning = begin_fit(record_, options_, watch_);
    add(beginning.linear, true);
    if (!beginning.usable()) return alone();
    std::vector<Law> laws = free_candidates(options_.angle);
    laws.erase(
        std::remove_if(laws.begin() + 1, laws.end(), [&](const Law& law) { return too_many_terms(law); }),
        laws.end());
    try_laws(
        laws, [&](const Law& law) { return beginning.known(law, record_); }, 0, progress_end);
    try_rare_terms(beginning);
    return chosen(laws);
  }

  // From the linear law; under a recorded force from one with a quadratic and a cubic spring.
  LawChoice among_driven() {
    LawFitOptions leading = options_;
    const Law linear = Law{options_.law.terms & springs.terms}.with(law_with<Viscous>);
    leading.law = linear;
    if (is_recorded(options_.drive.kind) && linear.shares(springs))
      leading.law = linear.with(law_with<Quadratic, Cubic>);
    Beginning beginning = begin_fit(record_, leading, watch_);
    if (!beginning.usable() && leading.law != linear) {
      leading.law = linear;
      beginning = begin_fit(record_, leading, watch_);
    }
    if (!beginning.usable()) {
      add(beginning.linear, true);
      return alone();
    }
    if (leading.law != linear) try_law(linear, beginning.known(linear, record_));
    add(beginning.linear, true);
    const std::vector<Law> laws = driven_candidates(linear, options_.drive.kind);
    try_laws(
        laws, [&](const Law& law) { return beginning.known(law, record_); }, 0.15, 1);
    try_rare_terms(beginning);
    return chosen({});
  }

 private:
  void add(LawFit fit, bool fine) {
    candidates_.push_back(std::move(fit));
    fine_.push_back(fine);
  }

  bool tried(const Law& law) const {
    return std::any_of(candidates_.begin(), candidates_.end(),
                       [&](const LawFit& fit) { return fit.law == law; });
  }
  KnownMotion nearest(const Law& law, const KnownMotion& known) const {
    for (const LawFit& fit : before_)
      if (fit.law == law && fit.status == FitStatus::converged)
        return {fit.motion, record_.t.size(), known.decay_rate};
    return known;
  }
  bool too_many_terms(const Law& law) const {
    LawFitOptions one = options_;
    one.law = law;
    return refuse_record(record_, one).has_value();
  }

  // As finely as it takes to tell whether the law leaves less than the candidates and these.
  LawFit rough_fit(const Law& law, const KnownMotion& known, const Watch& watch,
                   std::span<const LawFit> more = {}) const {
    LawFitOptions one = options_;
    one.law = law;
    for (const std::span<const LawFit> list : {std::span<const LawFit>(candidates_), more})
      for (const LawFit& fit : list)
        if (fit.status == FitStatus::converged && fit.residual.rms > 0)
          one.rms_to_beat = std::min(one.rms_to_beat, fit.residual.rms);
    return fit_motion(record_, one, nearest(law, known), watch, true);
  }

  void try_law(const Law& law, const KnownMotion& known) {
    if (tried(law) || too_many_terms(law) || watch_.interrupted()) return;
    LawFit fit = rough_fit(law, known, watch_);
    if (!watch_.interrupted()) add(std::move(fit), false);
  }

  // Those of most terms first: what they leave tells which of the others can be given up. Each is compared
  // with those four and more before it, also on one thread: with the same ones on every machine. The progress
  // goes from one share to another.
  template <class Start>
  void try_laws(const std::vector<Law>& wanted, const Start& start_of, double from = 0, double to = 0) {
    constexpr std::size_t few = 4;
    std::vector<Law> laws;
    for (const Law& law : wanted)
      if (std::find(laws.begin(), laws.end(), law) == laws.end() && !tried(law) && !too_many_terms(law))
        laws.push_back(law);
    std::vector<std::size_t> order(laws.size()), place(laws.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return laws[a].size() > laws[b].size(); });
    for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
    std::vector<LawFit> fits(laws.size());
    std::vector<char> whole(laws.size());  // not interrupted
    at_once(
        laws.size(),
        [&](std::size_t i) {
          if (quiet_.interrupted()) return;
          const Law& law = laws[order[i]];
          fits[i] = rough_fit(law, start_of(law), quiet_, std::span(fits).first(i < few ? 0 : i - few + 1));
          whole[i] = !quiet_.interrupted();
        },
        few,
        [&](std::size_t i) {
          const double done = static_cast<double>(i + 1) / static_cast<double>(laws.size());
          if (whole[i] && watch_.progress && to > from) watch_.progress(from + (to - from) * done);
        });
    for (const std::size_t i : place)
      if (whole[i]) add(std::move(fits[i]), false);
  }

  void try_rare_terms(const Beginning& beginning) {
    settle();
    drop_terms();
    try_look_alikes(beginning);
    try_quadratic(beginning);
    try_named_hysteresis();
    add_terms(beginning);
    if constexpr (!for_page) try_driven_hysteresis();
    try_longer_spring(beginning);
    add_to_bounded();
  }

  // The best law with a term that is met rarely in the place of one that is met often.
  void try_look_alikes(const Beginning& beginning) {
    const Law base = candidates_[best_].law;
    const Law plain = Law{base.terms & springs.terms}.with(law_with<Viscous>);
    for (const auto& [often, rare] : look_alikes)
      if (base.contains(often))
        for (const Law& law : {base.without(often).with(rare), plain.with(rare)})
          try_law(law, beginning.known(law, record_));
    settle();
    drop_old_terms(base);
  }

  // A spring that is not symmetric leaves little about the swing's frequency: the middle of the swing moves
  // as it dies down, and there is a second harmonic. A zero that wanders leaves the first alone.
  void try_quadratic(const Beginning& beginning) {
    const LawFit base = candidates_[best_];
    const Law law = base.law.with(law_with<Quadratic>);
    const std::vector<double> left = residuals_of(base, record_);
    if (!base.law.shares(springs) || tried(law) || left.size() != record_.t.size()) return;
    try_law(law, nearer_start(base, law, beginning, 1));
    if (!tried(law)) return;
    const double if_it_wanders = base.residual.rms * std::sqrt(1 - wandering_share(record_, left));
    if (!(candidates_.back().residual.rms < if_it_wanders)) {
      candidates_.pop_back();
      fine_.pop_back();
    }
    settle();
    drop_old_terms(base.law);
  }

  // Whoever gives an exponent looks for hysteresis.
  void try_named_hysteresis() {
    if (options_.hysteresis_exponent != 1) try_hysteresis();
  }

  // Under a drive loops take more energy the wider the swing, or, once they are much narrower than that, as
  // friction does: drag or friction can stand in for them and leave nothing.
  void try_driven_hysteresis() {
    if (options_.drive.kind == DriveKind::harmonic && candidates_[best_].law.shares(law_with<Drag, Friction>))
      try_hysteresis();
  }

  void try_hysteresis() {
    if (!candidates_.front().law.shares(springs)) return;
    const Law law = law_of("viscous+hysteresis");
    try_law(law, of_fit(candidates_.front(), law));
    settle();
    drop_terms();
  }

  // What stood in for a term that was missing may not be needed beside it: the best law without each of the
  // terms that it has from `before`.
  void drop_old_terms(const Law& before) {
    const LawFit now = candidates_[best_];
    for (std::size_t i = 0; i < term_count && !(now.law == before); ++i) {
      const Law term{std::uint32_t{1} << i}, law = now.law.without(term);
      const bool old = now.law.contains(term) && before.contains(term);
      if (old && !springs.contains(term) && law.shares(dissipative_terms)) try_law(law, of_fit(now, law));
    }
    settle();
    drop_terms();
  }

  // Tries the best law with each addition, and the closest law that is not sure likewise, as long as
  // something is left and a new law is chosen or comes closer, in at most five rounds.
  void add_terms(const Beginning& beginning) {
    // Each round of a hysteretic law takes many steps of integration, which the other laws then lack.
    const auto most_rounds = [&] {
      if (!candidates_[best_].law.has<Hysteresis>()) return 5;
      return closest() == best_ ? 2 : 3;
    };
    for (int round = 0; round < most_rounds() && !watch_.interrupted(); ++round) {
      const LawFit base = candidates_[best_];
      if (!something_is_left(record_, base)) return;
      const std::size_t before = best_, closest_before = closest();
      add_each(base, beginning, round);
      if (closest_before != before) add_each(LawFit(candidates_[closest_before]), beginning, round);
      settle();
      drop_old_terms(base.law);
      if (best_ == before && closest() == closest_before) return;
    }
  }

  // One bend of a spring is the first term of a series: what a second one would change counts in what is
  // known of the rest, also where it is not needed.
  void try_longer_spring(const Beginning& beginning) {
    constexpr Law bends = law_with<Cubic, OddQuadratic>;
    const LawFit base = candidates_[best_];
    const Law law = base.law.with(bends);
    if (options_.drive.kind != DriveKind::none || !base.law.has<Spring>() || tried(law) ||
        Law{base.law.terms & bends.terms}.size() != 1 || watch_.interrupted())
      return;
    try_law(law, nearer_start(base, law, beginning, 1));
    settle();
    drop_old_terms(base.law);
  }

  // A body that feeds itself is looked for among fewer laws: whatever else damps or bends it is tried.
  void add_to_bounded() {
    for (int round = 0; round < 3 && !watch_.interrupted(); ++round) {
      const std::size_t before = best_;
      const LawFit base = candidates_[before];
      if (!base.law.shares(bounding_terms)) return;
      std::vector<Law> laws;
      for (const Law& addition :
           {law_with<Drag>, law_with<Friction>, law_with<Cubic>, law_with<OddQuadratic>})
        if (!base.law.contains(addition)) laws.push_back(base.law.with(addition));
      try_laws(laws, [&](const Law& law) { return of_fit(base, law); });
      settle();
      drop_terms();
      if (best_ == before) return;
    }
  }

  void add_each(const LawFit& base, const Beginning& beginning, int round) {
    std::vector<Law> laws;
    for (const Law& addition : additions) {
      if (base.law.contains(addition)) continue;
      // Without a spring there is no place to pull back to.
      if (!base.law.shares(springs) && addition.shares(terms_of_position)) continue;
      // A hysteretic force damps by itself, and bends the spring: it stands in the place of all else.
      laws.push_back(addition.has<Hysteresis>()
                         ? Law{base.law.terms & springs.terms}.with(law_with<Viscous>).with(addition)
                         : base.law.with(addition));
    }
    try_laws(laws, [&](const Law& law) {
      const bool recorded = is_recorded(options_.drive.kind);
      if (!recorded || !law.contains(law_with<OddQuadratic, Quintic>))
        return nearer_start(base, law, beginning, round);
      LawFitOptions one = options_;
      one.law = law;
      return begin_fit(record_, one, quiet_).known(law, record_);
    });
  }

  // A start from the fit of most of the law, or along the record's amplitudes: in the first round along
  // these, later the one that leaves less.
  KnownMotion nearer_start(const LawFit& base, const Law& law, const Beginning& beginning, int round) const {
    const KnownMotion from_base = of_fit(base, law);
    if (options_.drive.kind != DriveKind::none || law.has<Hysteresis>()) return from_base;
    const KnownMotion along = beginning.known(law, record_);
    constexpr double close = 0.95;  // of the motion's squares
    if (round == 0 || base.explained < close) return along;
    const auto left = [&](const KnownMotion& known) {
      const std::vector<double> r =
          motion_residuals(known.motion, {}, record_, motion_step(known.motion.angular_frequency(), 0, 1));
      double sum = r.size() == record_.t.size() ? 0 : HUGE_VAL;
      for (const double each : r) sum += each * each;
      return sum;
    };
    return left(along) < left(from_base) ? along : from_base;
  }

  // A candidate that leaves much less than the best, of terms that are not sure; else the best.
  std::size_t closest() const {
    const std::optional<std::size_t> other = runner_up(candidates_, best_);
    const bool closer = other && candidates_[*other].residual.rms < 0.7 * candidates_[best_].residual.rms;
    return closer ? *other : best_;
  }

  // A law that beats the chosen one, but for terms that are not sure, is tried without each of them.
  void drop_terms() {
    for (bool any = true; any && !watch_.interrupted();) {
      any = false;
      const std::optional<std::size_t> lowest = runner_up(candidates_, best_);
      if (!lowest || candidates_[*lowest].bic >= candidates_[best_].bic) return;
      const LawFit better = candidates_[*lowest];
      for (const Law& law : without_unsure_terms(better)) {
        any = any || !tried(law);
        try_law(law, of_fit(better, law));
      }
      settle();
    }
  }

  // The motion of a fit, for a law with other terms.
  KnownMotion of_fit(const LawFit& fit, const Law& law) const {
    return {fit.motion.under(law), record_.t.size(), candidates_.front().decay_rate().value};
  }

  // Whether its BIC is close to the best one's: rough fits know it to about 10.
  bool is_close(std::size_t candidate) const {
    return candidates_[candidate].bic <= candidates_[best_].bic + 30;
  }

  // Fits these as finely as the record asks for. A law whose minimum is not found takes no more than its
  // share of the steps that are left: the others are to be tried too.
  void refine(std::vector<std::size_t> candidates) {
    std::erase_if(candidates, [&](std::size_t each) { return fine_[each]; });
    std::vector<LawFit> fits(candidates.size());
    const double share = std::min(0.25, 1 / static_cast<double>(fits.size() + 1)),
                 steps = share * *watch_.steps_left;
    at_once(fits.size(), [&](std::size_t k) {
      const LawFit& rough = candidates_[candidates[k]];
      LawFitOptions one = options_;
      one.law = rough.law;
      Watch own = k == 0 ? watch_ : quiet_;
      own.steps_left = std::make_shared<std::atomic<double>>(steps);
      fits[k] = fit_motion(record_, one, of_fit(rough, rough.law), own);
      watch_.take_steps(steps - *own.steps_left);
    });
    for (std::size_t k = 0; k < fits.size(); ++k) {
      LawFit& candidate = candidates_[candidates[k]];
      if (fits[k].status == FitStatus::converged)
        candidate = std::move(fits[k]);
      else if (!watch_.interrupted() && fits[k].status == FitStatus::iteration_limit)
        candidate.status = fits[k].status, candidate.message = fits[k].message;
      fine_[candidates[k]] = true;
    }
  }

  // Refines the chosen law and those that come close to it.
  void settle() {
    best_ = choose_candidate(candidates_, record_.resolution, expected_);
    for (std::optional<std::size_t> next = best_; next && !watch_.interrupted();) {
      std::vector<std::size_t> rough{*next};
      if (const auto other = runner_up(candidates_, best_); other && next == best_ && is_close(*other))
        rough.push_back(*other);
      refine(rough);
      best_ = choose_candidate(candidates_, record_.resolution, expected_);
      next = runner_up(candidates_, best_);
      if (!fine_[best_]) next = best_;
      if (const auto open = left_unsettled()) next = open;
      if (next && (fine_[*next] || !is_close(*next))) break;
    }
  }

  // A law that leaves less, whose rough fit ran out of steps.
  std::optional<std::size_t> left_unsettled() const {
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      if (!fine_[i] && candidates_[i].status == FitStatus::iteration_limit && candidates_[i].has_values() &&
          candidates_[i].bic < candidates_[best_].bic - strong_evidence)
        return i;
    return std::nullopt;
  }

  // Their numbers count beside the chosen law's.
  void refine_rivals() {
    for (std::size_t before = candidates_.size(); best_ != before && !watch_.interrupted();) {
      before = best_;
      std::vector<std::size_t> rivals;
      for (const LawFit* rival : rivals_of(candidates_[best_], candidates_))
        rivals.push_back(static_cast<std::size_t>(rival - candidates_.data()));
      refine(std::move(rivals));
      settle();
    }
  }

  LawChoice alone() {
    LawChoice choice{candidates_.front(), candidates_};
    if (watch_.interrupted()) mark_interrupted(choice, {}, watch_);
    return choice;
  }
  LawChoice chosen(const std::vector<Law>& laws) {
    refine_rivals();
    LawChoice choice{candidates_[best_], candidates_};
    if (watch_.interrupted()) mark_interrupted(choice, laws, watch_);
    choice.rivals = rival_laws(record_, candidates_, best_);
    // begin_fit() lets a linear law pass whose frequency is unknown, for the sake of the others.
    if (const auto refusal = refuse_frequency(choice.chosen);
        refusal && choice.chosen.status == FitStatus::converged) {
      refuse(choice.chosen, *refusal);
      choice.rivals = {};
    }
    return choice;
  }

 public:
  // A choice among only some of the laws does not count: the message says which ones were not tried.
  static void mark_interrupted(LawChoice& choice, const std::vector<Law>& laws, const Watch& watch) {
    LawFit& fit = choice.chosen;
    if (fit.status != FitStatus::converged) return;
    fit.status = FitStatus::iteration_limit;
    std::vector<std::string> missing;
    for (const Law& law : laws) {
      const bool done = std::any_of(choice.candidates.begin(), choice.candidates.end(),
                                    [&](const LawFit& candidate) { return candidate.law == law; });
      if (!done) missing.push_back(to_text(law));
    }
    fit.message = Notice{missing.empty() ? "ended_before_all_laws" : "ended_before_these_laws",
                         {{"why", why_ended(watch)},
                          {"law", to_text(fit.law)},
                          {"laws", choice.candidates.size()},
                          {"missing", missing}}};
  }

 private:
  const Record& record_;
  const LawFitOptions& options_;
  const Watch& watch_;
  const Watch quiet_;  ///< the same for a thread that tells no share
  std::span<const LawFit> before_;
  Law expected_;
  std::vector<LawFit> candidates_;
  std::vector<bool> fine_;
  std::size_t best_ = 0;
};

// The choice on a part, then the chosen law on all samples.
LawChoice choose_free_on_part(const Record& record, const LawFitOptions& options, const Watch& watch) {
  LawFitOptions one = options;
  one.law = law_of("viscous");
  const LawFit viscous = fit_law(record, one, watch);
  if (!is_comparable(viscous)) return {viscous, {viscous}};
  const Selection part = select(record, viscous);
  const Record samples = part.record();
  LawChoice choice = LawSearch(samples, options, watch).among_free(0.5);
  if (!is_comparable(choice.chosen) || choice.chosen.law == law_of("viscous")) {
    choice.chosen = viscous;
  } else if (choice.chosen.status == FitStatus::converged) {
    one.law = choice.chosen.law;
    one.start = KnownMotion{choice.chosen.motion, part.end, viscous.decay_rate().value};
    choice.chosen = fit_law(record, one, watch);
  }
  if (watch.interrupted()) LawSearch::mark_interrupted(choice, free_candidates(options.angle), watch);
  choice.chosen.notices.push_back(Notice{"laws_compared_on_a_part",
                                         {{"compared", part.t.size()},
                                          {"samples", record.t.size()},
                                          {"stride", part.stride},
                                          {"time", part.t.back()}}});
  return choice;
}

LawChoice choose_free(const Record& record, const LawFitOptions& options, const Watch& watch,
                      std::span<const LawFit> before) {
  LawFitOptions viscous = options;
  viscous.law = law_of("viscous");
  if (refuse_record(record, viscous)) {
    const LawFit fit = fit_law(record, viscous, watch);
    return {fit, {fit}};
  }
  return record.t.size() > 5 * enough_samples ? choose_free_on_part(record, viscous, watch)
                                              : LawSearch(record, viscous, watch, before).among_free(1);
}

// One law of a driven motion, or the one that the record asks for, under one reading of its force.
LawChoice choose_driven(const Record& record, const LawFitOptions& options, const GivenLaw& given,
                        const Watch& watch) {
  LawFitOptions one = options;
  if (given.law) {
    one.law = *given.law;
    const LawFit fit = fit_law(record, one, watch);
    return {fit, {fit}};
  }
  if (const auto refusal = refuse_record(record, one)) {
    const LawFit fit = refused(*refusal, one);
    return {fit, {fit}};
  }
  if (record.t.size() <= 2 * enough_driven) return LawSearch(record, one, watch).among_driven();
  const Record part = record.first(enough_driven);
  LawChoice choice = LawSearch(part, one, watch).among_driven();
  if (choice.chosen.status != FitStatus::converged) return choice;
  one.law = choice.chosen.law;
  one.start = KnownMotion{choice.chosen.motion, record.t.size(), 0};
  choice.chosen = fit_law(record, one, watch);
  choice.chosen.notices.push_back(
      Notice{"laws_compared_on_the_first", {{"compared", enough_driven}, {"samples", record.t.size()}}});
  return choice;
}

LawChoice choose_on(const Record& record, const LawFitOptions& options, const GivenLaw& given,
                    const Watch& watch, std::span<const LawFit> before) {
  if (is_recorded(options.drive.kind))
    return choose_reading(
        record, options, given,
        [&](const LawFitOptions& one) { return choose_driven(record, one, given, watch); }, watch);
  if (options.drive.kind == DriveKind::harmonic) return choose_driven(record, options, given, watch);
  return choose_free(record, options, watch, before);
}

}  // namespace

LawChoice choose_law(const Record& record, const LawFitOptions& options, const Watch& caller,
                     const GivenLaw& given) {
  const Watch watch = within_steps(caller, record, options.drive.kind);
  // All candidates see the same samples: those that are no outliers from the chosen one.
  LawFitOptions every = options;
  every.every_sample = true;
  const auto choose = [&](const Record& samples, std::span<const LawFit> before = {}) {
    LawChoice choice = choose_on(samples, every, given, watch, before);
    if (!choice.rivals.empty()) choice.chosen.notices.push_back(choice.rivals);
    return choice;
  };
  if (options.every_sample || options.drive.kind != DriveKind::none) return choose(record);
  // Outliers are found with one law: to choose among all each time takes far longer. The viscous law may
  // begin: what a wrong law leaves does not stand out.
  const auto settle = [&](const LawFit& from, const Law& law, std::vector<std::size_t> aside) {
    LawFitOptions one = every;
    one.law = law;
    return settle_outliers(
        record, from, std::move(aside), [&](const Record& samples) { return fit_law(samples, one, watch); },
        residuals_of);
  };
  const auto choose_without = [&](const WithoutOutliers<LawFit>& settled,
                                  std::span<const LawFit> before = {}) {
    return choose(KeptSamples(record, settled.aside, settled.residuals).record(), before);
  };
  std::vector<std::size_t> aside;
  LawChoice choice;
  if (record.t.size() <= 5 * enough_samples) {
    LawFitOptions viscous = every;
    viscous.law = law_of("viscous");
    const auto settled = settle(fit_law(record, viscous, watch), viscous.law, {});
    aside = settled.aside;
    choice = aside.empty() ? choose(record) : choose_without(settled);
  } else {
    choice = choose(record);
  }
  for (int round = 0; round < 2; ++round) {
    const auto settled = settle(choice.chosen, choice.chosen.law, aside);
    if (settled.aside == aside) break;
    aside = settled.aside;
    choice = choose_without(settled, choice.candidates);
  }
  choice.chosen.outliers = std::move(aside);
  return choice;
}

}  // namespace cromer::core
