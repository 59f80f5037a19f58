#include "cromer/identify/choose_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cromer/identify/criterion.h"

namespace cromer {
namespace {

// What the choice is made on: most records whole.
constexpr std::size_t enough_samples = 100'000;
constexpr double samples_per_period = 16;

struct Selection {
  std::vector<double> t, y;
  double resolution = 0;
  std::size_t stride = 1;
  std::size_t end = 0;  ///< one past the last sample of the record that was considered

  Record record() const { return {t, y, resolution}; }
};

// Every so manieth sample, at least sixteen in a period, of as long a beginning as then suffices.
Selection select(const Record& record, double angular_frequency) {
  Selection part;
  part.resolution = record.resolution;
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

LawChoice choose_on(const Record& record, const FreeDecayOptions& options, const Watch& watch,
                    double progress_end) {
  LawChoice choice;
  const Law laws[] = {{.viscous = true},
                      {.viscous = true, .drag = true},
                      {.viscous = true, .cubic = true},
                      {.viscous = true, .drag = true, .cubic = true}};
  for (const Law& law : laws) {
    FreeDecayOptions one = options;
    one.law = law;
    FreeDecay fit = fit_free_decay(record, one, watch);
    if (watch.interrupted() && !choice.candidates.empty()) break;
    choice.candidates.push_back(std::move(fit));
    const FitStatus status = choice.candidates.front().status;
    if (status != FitStatus::converged && status != FitStatus::iteration_limit) break;
    if (watch.progress) watch.progress(progress_end * static_cast<double>(choice.candidates.size()) / 4);
  }
  choice.chosen = choice.candidates[choose_candidate(choice.candidates)];
  if (watch.interrupted() && choice.chosen.status == FitStatus::converged) {
    choice.chosen.status = FitStatus::iteration_limit;
    choice.chosen.message = "interrupted before all laws were tried";
  }
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
  if (!has_values(viscous) || watch.interrupted()) return {viscous, {viscous}};
  const Selection part = select(record, viscous.angular_frequency.value);
  LawChoice choice = choose_on(part.record(), options, watch, 0.5);
  if (!has_values(choice.chosen) || choice.chosen.law == Law{}) {
    choice.chosen = viscous;
  } else if (choice.chosen.status == FitStatus::converged) {
    one.law = choice.chosen.law;
    one.start = KnownMotion{choice.chosen.motion(), part.end, viscous.decay_rate.value};
    choice.chosen = fit_free_decay(record, one, watch);
  }
  if (watch.interrupted() && choice.chosen.status == FitStatus::converged) {
    choice.chosen.status = FitStatus::iteration_limit;
    choice.chosen.message = "interrupted before all laws were tried";
  }
  choice.chosen.warnings.push_back(fmt::format(
      "the laws were compared on {} of the {} samples, one in {} up to {:.6g} s; the one chosen is "
      "fitted to all",
      part.t.size(), record.t.size(), part.stride, part.t.back()));
  return choice;
}

}  // namespace

LawChoice choose_law(const Record& record, const FreeDecayOptions& options, const Watch& watch) {
  return record.t.size() > 2 * enough_samples ? choose_on_part(record, options, watch)
                                              : choose_on(record, options, watch, 1);
}

}  // namespace cromer
