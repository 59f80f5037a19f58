#include "cromer/identify/choose/criterion.h"

#include <optional>

#include "cromer/base/quantity.h"
#include "cromer/identify/diagnose/mean_decay.h"
#include "cromer/identify/motion/parameter_unit.h"

namespace cromer::core {
namespace {

bool excludes_zero(const Estimate& term) { return term.low > 0 || term.high < 0; }

// The estimate of one of the law's terms that could be left out; nullptr where it could not.
const Estimate* removable(const LawFit& fit, const TermInfo& info, Law term) {
  if (springs.contains(term)) return nullptr;
  // A lone damping term may be as small as it is.
  const Law taking = dampings.with(bounding_terms);
  if (info.damps && Law{fit.law.terms & taking.terms}.size() < 2) return nullptr;
  const Estimate* found = nullptr;
  for_each_term([&]<class T>() {
    if (T::info.name == info.name) found = fit.find(T::coefficients[0].parameter);
  });
  return found;
}

bool is_admissible(const LawFit& fit, const std::vector<LawFit>& candidates) {
  if (fit.status != FitStatus::converged) return false;
  // Damping that is less the wider the swing: such a term stands in for something else, as for a brake or a
  // beat.
  if (const Estimate* growing = fit.find("van_der_pol"); growing && growing->high < 0) return false;
  const std::vector<Law> simpler_laws = without_unsure_terms(fit);
  return std::all_of(simpler_laws.begin(), simpler_laws.end(), [&](const Law& law) {
    const auto simpler = std::find_if(candidates.begin(), candidates.end(), [&](const LawFit& other) {
      return other.law == law && other.residual.rms > 0;
    });
    return simpler != candidates.end() && simpler->bic >= fit.bic + strong_evidence;
  });
}

}  // namespace

std::vector<Law> without_unsure_terms(const LawFit& fit) {
  std::vector<Law> laws;
  for (std::size_t i = 0; i < term_count; ++i) {
    const Law term{std::uint32_t{1} << i};
    if (!fit.law.shares(term)) continue;
    const Estimate* estimate = removable(fit, term_infos[i], term);
    if (estimate && !excludes_zero(*estimate)) laws.push_back(fit.law.without(term));
  }
  return laws;
}

Criterion::Criterion(const std::vector<const LawFit*>& fits, double resolution) : resolution_(resolution) {
  const LawFit* closest = fits.front();
  const LawFit* with_noise = nullptr;
  for (const LawFit* fit : fits) {
    if (fit->status != FitStatus::converged) continue;
    const auto is_closer = [&](const LawFit* than) {
      return !than || than->status != FitStatus::converged || fit->residual.rms < than->residual.rms;
    };
    if (is_closer(closest)) closest = fit;
    if (fit->force_noise && is_closer(with_noise)) with_noise = fit;
  }
  independent_ = closest->independent_samples;
  constexpr double as_close = 1.2;  // times the least rms
  // Rounding is no noise.
  if (with_noise && with_noise->force_noise->shows &&
      with_noise->residual.rms < as_close * closest->residual.rms &&
      !is_rounding(with_noise->residual.rms, resolution))
    by_noise_ = with_noise->force_noise->bic - plain(*with_noise);
}

double Criterion::plain(const LawFit& fit) const {
  return bayesian_criterion(independent_, fit.residual.rms, fit.fitted, resolution_);
}

double Criterion::of(const LawFit& fit) const {
  if (!(fit.residual.rms > 0 && independent_ > 0)) return fit.bic;
  if (!by_noise_) return plain(fit);
  return fit.force_noise ? fit.force_noise->bic : plain(fit) + *by_noise_;
}

std::size_t choose_candidate(std::vector<LawFit>& candidates, double resolution, Law expected) {
  std::vector<const LawFit*> all;
  for (const LawFit& fit : candidates) all.push_back(&fit);
  const Criterion criterion(all, resolution);
  for (LawFit& fit : candidates) fit.bic = criterion.of(fit);
  std::vector<bool> admissible;
  for (const LawFit& fit : candidates) admissible.push_back(is_admissible(fit, candidates));
  std::size_t best = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (admissible[i] && (!admissible[best] || candidates[i].bic < candidates[best].bic)) best = i;
  // Evidence that is not strong does not speak against a simpler law: the fewest terms then. Of as many terms
  // a law met more often stays unless the other is clearly better; rival_laws() says where neither is.
  constexpr double clear = 5;
  const double lowest = candidates[best].bic;
  const auto eligible = [&](std::size_t i) {
    return admissible[i] && candidates[i].bic < lowest + strong_evidence;
  };
  int fewest = candidates[best].fitted;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (eligible(i)) fewest = std::min(fewest, candidates[i].fitted);
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (eligible(i) && candidates[i].fitted == fewest) least = std::min(least, candidates[i].bic);
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (admissible[i] && candidates[i].fitted == fewest && candidates[i].law.shares(expected) &&
        candidates[i].bic < lowest + 2 * strong_evidence)
      return i;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (eligible(i) && candidates[i].fitted == fewest && candidates[i].bic < least + clear) return i;
  return best;
}

namespace {

bool is_off(const Estimate& here, double there) {
  return std::abs(there - here.value) > 3 * here.standard_error;
}

// Another law would give other numbers for the same coefficients.
bool moves_the_numbers(const LawFit& chosen, const LawFit& rival) {
  for (std::size_t i = 0; i < chosen.names.size(); ++i) {
    if (chosen.names[i] == "equilibrium" || is_of_the_start(chosen.names[i])) continue;
    const Estimate* there = rival.find(chosen.names[i]);
    if (there && is_off(chosen.estimates[i], there->value)) return true;
  }
  return false;
}

bool has_other_damping(const LawFit& chosen, const LawFit& rival) {
  const Law of_energy = dampings.with(bounding_terms);
  return Law{chosen.law.terms & of_energy.terms}.without(rival.law) != Law{};
}

Notice named_rival(const LawFit& fit, const Record& record) {
  std::vector<Notice> coefficients;
  for (std::size_t i = 0; i < fit.names.size(); ++i) {
    const std::string& name = fit.names[i];
    if (name == "equilibrium" || name == "angular_frequency" || name.starts_with("drive_") ||
        name.starts_with("force_") || is_of_the_start(name))
      continue;
    coefficients.push_back(Notice{
        "coefficient",
        {{"parameter", parameter_named(name, fit.law)},
         {"value", format_quantity({fit.estimates[i].value, fit.estimates[i].standard_error},
                                   unit_of_parameter(name, fit.motion, record.unit, record.derivative))}}});
  }
  return Notice{"law_with_coefficients", {{"law", to_text(fit.law)}, {"coefficients", coefficients}}};
}

bool is_about_as_simple(const LawFit& other, const LawFit& chosen) {
  return other.status == FitStatus::converged &&
         (other.fitted == chosen.fitted || other.fitted == chosen.fitted + 1);
}

}  // namespace

bool fits_as_well(const LawFit& rival, const LawFit& chosen) {
  return is_about_as_simple(rival, chosen) && rival.bic <= chosen.bic + strong_evidence;
}

std::vector<const LawFit*> alternatives_to(const LawFit& chosen, const std::vector<LawFit>& candidates) {
  std::vector<const LawFit*> others;
  if (chosen.status != FitStatus::converged || !chosen.law.shares(springs)) return others;
  for (const LawFit& other : candidates)
    if (is_about_as_simple(other, chosen) && other.law != chosen.law &&
        other.drive.force.between == chosen.drive.force.between)
      others.push_back(&other);
  return others;
}

const LawFit* among(const std::vector<LawFit>& candidates, const LawFit& fit) {
  const auto found = std::find_if(candidates.begin(), candidates.end(), [&](const LawFit& each) {
    return each.law == fit.law && each.drive.force.between == fit.drive.force.between;
  });
  return found == candidates.end() ? nullptr : &*found;
}

std::vector<const LawFit*> rivals_of(const LawFit& chosen, const std::vector<LawFit>& candidates) {
  std::vector<const LawFit*> rivals = alternatives_to(chosen, candidates);
  std::erase_if(rivals, [&](const LawFit* rival) {
    return !fits_as_well(*rival, chosen) ||
           !(moves_the_numbers(chosen, *rival) ||
             (rival->fitted == chosen.fitted && has_other_damping(chosen, *rival)));
  });
  std::sort(rivals.begin(), rivals.end(),
            [](const LawFit* one, const LawFit* other) { return one->bic < other->bic; });
  return rivals;
}

Notice rival_laws(const Record& record, const std::vector<LawFit>& candidates, std::size_t chosen) {
  const LawFit& best = candidates[chosen];
  const std::vector<const LawFit*> rivals = rivals_of(best, candidates);
  if (rivals.empty()) return {};
  const std::optional<MeanDecay> decay = mean_decay(best, record);  // a hysteretic force has none
  if (decay && !(decay->rate.low > 0 || is_fed(best))) return {};   // no damping is seen, whichever it be
  constexpr std::size_t most = 3;
  std::vector<Notice> named;
  for (std::size_t i = 0; i < std::min(most, rivals.size()); ++i)
    named.push_back(named_rival(*rivals[i], record));
  // At which rate a driven motion would die down each law says for itself.
  if (!decay || is_fed(best) || best.drive.kind != DriveKind::none)
    return Notice{"rival_laws_of_a_fed_swing", {{"law", to_text(best.law)}, {"rivals", named}}};
  return Notice{"rival_laws", {{"law", to_text(best.law)}, {"rivals", named}, {"known", as_clause(*decay)}}};
}

}  // namespace cromer::core
