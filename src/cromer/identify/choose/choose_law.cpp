#include "cromer/identify/choose/choose_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>

#include "cromer/identify/choose/criterion.h"
#include "cromer/identify/fit_motion.h"
#include "cromer/identify/diagnose/outliers.h"
#include "cromer/identify/diagnose/refusal.h"
#include "cromer/identify/choose/rival_laws.h"

namespace cromer {
namespace {

// What the choice is made on: most records whole.
constexpr std::size_t enough_samples = 40'000;
constexpr double samples_per_period = 16;

struct Selection {
  std::vector<double> t, y;
  double resolution = 0;
  int derivative = 0;
  std::size_t stride = 1;
  std::size_t end = 0;  ///< one past the last sample of the record that was considered

  Record record() const { return {t, y, resolution, derivative}; }
};

// One sample in so many, at least sixteen in a period, of as long a beginning as then suffices.
Selection select(const Record& record, double angular_frequency) {
  Selection part;
  part.resolution = record.resolution;
  part.derivative = record.derivative;
  const std::size_t n = record.t.size();
  const double h = (record.t.back() - record.t.front()) / static_cast<double>(n - 1);
  const double most = 2 * std::numbers::pi / (angular_frequency * h * samples_per_period);
  const std::size_t wanted = (n + enough_samples - 1) / enough_samples;
  part.stride = std::clamp<std::size_t>(most < 1e6 ? static_cast<std::size_t>(most) : 1'000'000, 1, wanted);
  part.end = std::min(n, part.stride * enough_samples);
  for (std::size_t i = 0; i < part.end; i += part.stride) {
    part.t.push_back(record.t[i]);
    part.y.push_back(record.y[i]);
  }
  return part;
}

// Every sum of dampings with a linear and a cubic spring, and for angles as a pendulum; the simplest first,
// then those most often found.
std::vector<Law> candidate_laws(bool angle) {
  std::vector<Law> laws{{.viscous = true},
                        {.viscous = true, .drag = true},
                        {.viscous = true, .cubic = true},
                        {.viscous = true, .drag = true, .cubic = true}};
  for (int restoring = 0; restoring < (angle ? 3 : 2); ++restoring)
    for (int damping = 1; damping < 8; ++damping) {
      const Law law{.viscous = (damping & 1) != 0,
                    .drag = (damping & 2) != 0,
                    .friction = (damping & 4) != 0,
                    .cubic = restoring == 1,
                    .pendulum = restoring == 2};
      if (std::find(laws.begin(), laws.end(), law) == laws.end()) laws.push_back(law);
    }
  return laws;
}

// A choice among some of the laws is none: which ones it lacks is said.
void mark_interrupted(LawChoice& choice, const std::vector<Law>& laws) {
  FreeDecay& fit = choice.chosen;
  if (fit.status != FitStatus::converged) return;
  fit.status = FitStatus::iteration_limit;
  std::string missing;
  for (const Law& law : laws) {
    const bool done = std::any_of(choice.candidates.begin(), choice.candidates.end(),
                                  [&](const FreeDecay& candidate) { return candidate.law == law; });
    if (!done) missing += (missing.empty() ? "" : ", ") + to_text(law);
  }
  fit.message = missing.empty()
                    ? "interrupted before all laws were tried: none is missing, but the last steps of the "
                      "comparison are"
                    : fmt::format(
                          "interrupted before all laws were tried: {} is only the best of {}, and not "
                          "compared yet are {}",
                          to_text(fit.law), choice.candidates.size(), missing);
}

// Place of the candidate of lowest BIC but one.
std::optional<std::size_t> runner_up(const std::vector<FreeDecay>& candidates, std::size_t best) {
  std::optional<std::size_t> second;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (i != best && candidates[i].status == FitStatus::converged &&
        (!second || candidates[i].bic < candidates[*second].bic))
      second = i;
  return second;
}

LawChoice choose_on(const Record& record, const FreeDecayOptions& options, const Watch& watch,
                    double progress_end) {
  LawChoice choice;
  std::vector<FreeDecay>& candidates = choice.candidates;
  const Beginning beginning = begin_fit(record, options, watch);
  candidates.push_back(beginning.viscous);
  choice.chosen = beginning.viscous;
  if (!beginning.usable()) return choice;
  std::vector<Law> laws = candidate_laws(options.angle);
  const auto too_many_terms = [&](const Law& law) { return refuse_record(record, law).has_value(); };
  laws.erase(std::remove_if(laws.begin() + 1, laws.end(), too_many_terms), laws.end());
  if (watch.interrupted()) {
    mark_interrupted(choice, laws);
    return choice;
  }
  const auto progress = [&](std::size_t done) {
    if (watch.progress)
      watch.progress(progress_end * static_cast<double>(done) / static_cast<double>(laws.size()));
  };
  progress(1);
  std::vector<bool> fine(laws.size());
  fine[0] = true;
  FreeDecayOptions one = options;
  for (std::size_t i = 1; i < laws.size() && !watch.interrupted(); ++i) {
    one.law = laws[i];
    FreeDecay fit = fit_motion(record, one, beginning.known(one.law, record.t.front()), watch, true);
    if (watch.interrupted()) break;
    candidates.push_back(std::move(fit));
    progress(i + 1);
  }
  // The one chosen, and what it is chosen over, as finely as the record asks for.
  std::size_t best = choose_candidate(candidates);
  for (std::optional<std::size_t> next = best; next && !watch.interrupted();) {
    FreeDecay& rough = candidates[*next];
    if (!fine[*next]) {
      one.law = rough.law;
      const KnownMotion known{rough.motion(), record.t.size(), beginning.viscous.decay_rate.value};
      FreeDecay fit = fit_motion(record, one, known, watch);
      if (fit.status == FitStatus::converged) rough = std::move(fit);
      fine[*next] = true;
    }
    best = choose_candidate(candidates);
    next = runner_up(candidates, best);
    if (!fine[best]) next = best;
    if (next && fine[*next]) break;
  }
  choice.chosen = candidates[best];
  if (const std::string rivals = rival_laws(record, candidates, best); !rivals.empty())
    choice.chosen.warnings.push_back(rivals);
  if (watch.interrupted()) mark_interrupted(choice, laws);
  return choice;
}

bool has_values(const FreeDecay& fit) {
  return fit.status == FitStatus::converged || fit.status == FitStatus::iteration_limit;
}

// The choice on a part, then the chosen law on all samples.
LawChoice choose_on_part(const Record& record, const FreeDecayOptions& options, const Watch& watch) {
  FreeDecayOptions one = options;
  one.law = Law{};
  const FreeDecay viscous = fit_free_decay(record, one, watch);
  if (!has_values(viscous)) return {viscous, {viscous}};
  if (watch.interrupted()) {
    LawChoice choice{viscous, {viscous}};
    mark_interrupted(choice, candidate_laws(options.angle));
    return choice;
  }
  const Selection part = select(record, viscous.angular_frequency.value);
  LawChoice choice = choose_on(part.record(), options, watch, 0.5);
  if (!has_values(choice.chosen) || choice.chosen.law == Law{}) {
    choice.chosen = viscous;
  } else if (choice.chosen.status == FitStatus::converged) {
    one.law = choice.chosen.law;
    one.start = KnownMotion{choice.chosen.motion(), part.end, viscous.decay_rate.value};
    choice.chosen = fit_free_decay(record, one, watch);
  }
  if (watch.interrupted()) mark_interrupted(choice, candidate_laws(options.angle));
  choice.chosen.warnings.push_back(fmt::format(
      "the laws were compared on {} of the {} samples, one in {} up to {:.6g} s; the one chosen is "
      "fitted to all",
      part.t.size(), record.t.size(), part.stride, part.t.back()));
  return choice;
}

LawChoice choose_on_all(const Record& record, const FreeDecayOptions& options, const Watch& watch) {
  if (refuse_record(record, Law{})) {
    FreeDecayOptions viscous = options;
    viscous.law = Law{};
    const FreeDecay fit = fit_free_decay(record, viscous, watch);
    return {fit, {fit}};
  }
  return record.t.size() > 5 * enough_samples ? choose_on_part(record, options, watch)
                                              : choose_on(record, options, watch, 1);
}

}  // namespace

LawChoice choose_law(const Record& record, const FreeDecayOptions& options, const Watch& watch) {
  // All candidates see the same samples: those that are no outliers from the chosen one.
  FreeDecayOptions every = options;
  every.every_sample = true;
  const auto choose = [&](const Record& samples) { return choose_on_all(samples, every, watch); };
  if (options.every_sample) return choose(record);
  auto [choice, aside] = fit_without_outliers(
      record, choose,
      [](const LawChoice& made, const Record& samples) { return residuals_of(made.chosen, samples); });
  choice.chosen.outliers = std::move(aside);
  return std::move(choice);
}

}  // namespace cromer
