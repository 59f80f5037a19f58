#include "cromer/identify/choose/kind_of_motion.h"

#include <algorithm>
#include <cmath>

#include "cromer/base/pi.h"
#include "cromer/identify/choose/criterion.h"
#include "cromer/identify/diagnose/second_mode.h"
#include "cromer/identify/start/driven_start.h"

namespace cromer::core {
namespace {

// The two lines to begin with: the swing's own and the steady one.
std::optional<std::array<ModeStart, 2>> lines_of(const Record& record, const LawFit& driven) {
  Motion motion = driven.motion;
  if (driven.status != FitStatus::converged) {
    const std::optional<Motion> start = driven_start({record.t, record.y, record.resolution}, {});
    if (!start) return std::nullopt;
    motion = *start;
  }
  const double g = motion.decay_rate(), w0 = motion.angular_frequency();
  if (!(w0 > g)) return std::nullopt;
  return std::array<ModeStart, 2>{ModeStart{std::sqrt(w0 * w0 - g * g), g},
                                  ModeStart{motion.drive_frequency, 0}};
}

// A generator's amplitude is not quite constant: what falls by less than a tenth over the record, and twenty
// times slower than the swing beside it, lasts.
bool lasts(const Mode& mode, const Mode& other, double duration) {
  if (!mode.decays()) return true;
  const double g = mode.decay_rate.value;
  return g * duration < 0.1 && g < 0.05 * other.decay_rate.value;
}

// The smaller line is a harmonic of the larger.
bool is_harmonic(const std::array<Mode, 2>& modes, double duration) {
  const Estimate &larger = modes[0].angular_frequency, &smaller = modes[1].angular_frequency;
  return harmonic_of(smaller.value, smaller.standard_error,
                     {larger.value, larger.value, larger.standard_error}, duration) > 0;
}

}  // namespace

MotionJudgement judge_motion(const Record& record, const LawFit& free, const LawFit& driven,
                             bool frequency_known) {
  MotionJudgement judgement;
  if (record.t.size() < 32 || !(free.residual.rms > 0)) return judgement;
  const auto lines = lines_of(record, driven);
  if (lines) {
    const auto& [own, steady] = *lines;
    const double g = std::max(own.decay_rate, 0.0);
    judgement.modes = fit_two_modes(record, {*lines, {own, {steady.angular_frequency, g}}});
  }
  const std::optional<TwoModes>& modes = judgement.modes;
  const bool drives = driven.status == FitStatus::converged;

  double independent = free.independent_samples, least = free.residual.rms;
  if (drives && driven.residual.rms < least)
    independent = driven.independent_samples, least = driven.residual.rms;
  if (modes && modes->residual.rms < least) independent = modes->independent_samples;
  const auto criterion = [&](const auto& fit, double parameters) {
    return bayesian_criterion(std::max(2.0, independent), fit.residual.rms, parameters, record.resolution);
  };
  // A search over N frequencies costs 2 ln N. N is half the samples where all were searched; the few about
  // one that was named count as 8.
  constexpr double few = 8;
  const auto searched = [](double frequencies) { return 2 * std::log(std::max(1.0, frequencies)); };
  const double all = 0.5 * static_cast<double>(record.t.size());
  const double of_free = criterion(free, free.fitted);
  const double of_driven =
      drives ? criterion(driven, driven.fitted) + searched(frequency_known ? few : all) : HUGE_VAL;
  const double of_modes = modes ? criterion(*modes, TwoModes::parameters) + searched(all) : HUGE_VAL;
  if (std::min(of_driven, of_modes) > of_free - strong_evidence) return judgement;

  const bool linear = is_linear(driven.law);
  if (!modes || (drives && !linear && of_driven < of_modes - strong_evidence)) {
    if (of_driven < of_free - strong_evidence) judgement.kind = MotionKind::driven;
    return judgement;
  }
  const auto& [one, other] = modes->modes;
  const auto shows = [](const Mode& mode) { return mode.amplitude > 4 * mode.amplitude_error; };
  const double duration = record.t.back() - record.t.front(), resolution = two_pi / duration;
  if (!frequency_known && is_harmonic(modes->modes, duration)) return judgement;
  const bool one_lasts = lasts(one, other, duration), other_lasts = lasts(other, one, duration);
  const bool apart = std::abs(one.angular_frequency.value - other.angular_frequency.value) > 0.5 * resolution;
  if (!one_lasts && !other_lasts) {
    // Two decays at one frequency are one swing that decays in another way than its law.
    if (apart && shows(one) && shows(other) && of_modes < of_free - strong_evidence)
      judgement.kind = MotionKind::two_modes;
  } else if (drives && of_driven < of_free - strong_evidence) {
    // A drive that was searched is told by its line: it lasts, and the swing's own surely decays faster.
    const Estimate &g = one.decay_rate, &f = other.decay_rate;
    const bool alike = std::abs(g.value - f.value) < 2 * std::hypot(g.standard_error, f.standard_error);
    const bool open = (one_lasts && other_lasts) || (alike && !frequency_known);
    judgement.kind =
        open && shows(one) && shows(other) ? MotionKind::driven_or_two_modes : MotionKind::driven;
  }
  return judgement;
}

}  // namespace cromer::core
