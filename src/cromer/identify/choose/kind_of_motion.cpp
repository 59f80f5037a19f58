#include "cromer/identify/choose/kind_of_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cromer/base/at_once.h"
#include "cromer/base/pi.h"
#include "cromer/identify/choose/criterion.h"
#include "cromer/identify/diagnose/second_mode.h"
#include "cromer/identify/start/driven_start.h"
#include "cromer/identify/start/two_lines.h"

namespace cromer::core {
namespace {

constexpr std::size_t most_judged = 100'000;

// Where the iteration begins.
struct ModeStart {
  double angular_frequency = 0;  // [rad/s] > 0
  double decay_rate = 0;         // [1/s]
};

TwoModes described(const Record& record, const LeastSquaresSummary& minimum) {
  const Parameters& p = minimum.parameters;
  const auto n = static_cast<double>(record.t.size());
  const std::vector<double> residuals = two_lines::residuals(record, p);
  const std::vector<double> rho = autocorrelations(residuals, first_lags(residuals.size()));
  TwoModes fit;
  fit.residual = describe_residual(residuals, rho);
  const double h = (record.t.back() - record.t.front()) / (n - 1);
  const SquareMatrix covariance = inverse(minimum.equations.matrix, TwoModes::parameters);
  double widest = 1;
  for (std::size_t mode = 0; mode < 2; ++mode) {
    const int at = two_lines::first_of[mode];
    const double factor = std::min(n, correlation_factor(residuals, rho, p[at + two_lines::frequency] * h));
    widest = std::max(widest, factor);
    const double variance = factor * std::max(minimum.equations.sum_of_squares / (n - TwoModes::parameters),
                                              record.resolution * record.resolution / 12);
    const double student = student_95(std::max(1.0, n / factor - TwoModes::parameters));
    const auto error = [&](int i) { return std::sqrt(variance * covariance[at + i][at + i]); };
    Mode& found = fit.modes[mode];
    found.angular_frequency =
        make_estimate(p[at + two_lines::frequency], error(two_lines::frequency), student);
    found.decay_rate = make_estimate(p[at + two_lines::decay], error(two_lines::decay), student);
    found.amplitude = std::hypot(p[at + two_lines::cosine], p[at + two_lines::sine]);
    found.amplitude_error = std::max(error(two_lines::cosine), error(two_lines::sine));
  }
  fit.independent_samples = n / widest;
  if (fit.modes[0].amplitude < fit.modes[1].amplitude) std::swap(fit.modes[0], fit.modes[1]);
  return fit;
}

// The best of the least-squares fits from each of the starts. Empty where none converges. Only the first
// 100,000 samples are used.
std::optional<TwoModes> fit_two_modes(const Record& record,
                                      const std::vector<std::array<ModeStart, 2>>& starts) {
  Record part = record;
  part.t = record.t.first(std::min(record.t.size(), most_judged));
  part.y = record.y.first(part.t.size());
  const double scale = centred_norm(part.y);
  std::vector<std::optional<LeastSquaresSummary>> minima(starts.size());
  at_once(starts.size(), [&](std::size_t i) {
    Parameters lines{};
    for (std::size_t mode = 0; mode < 2; ++mode) {
      lines[two_lines::first_of[mode] + two_lines::frequency] = starts[i][mode].angular_frequency;
      lines[two_lines::first_of[mode] + two_lines::decay] = starts[i][mode].decay_rate;
    }
    if (const auto p = two_lines::with_amplitudes(part, lines))
      minima[i] = two_lines::fit(part, *p, TwoModes::parameters, scale);
  });
  const LeastSquaresSummary* best = nullptr;
  for (const auto& minimum : minima)
    if (minimum && minimum->reason == LeastSquaresReason::converged &&
        (!best || minimum->equations.sum_of_squares < best->equations.sum_of_squares))
      best = &*minimum;
  if (!best) return std::nullopt;
  return described(part, *best);
}

// The two lines to begin with: the swing's own and the steady one.
std::optional<std::array<ModeStart, 2>> two_lines_of(const Record& record, const LawFit& driven) {
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

// The smaller line is a harmonic of the larger, which it is not where it decays and the larger lasts.
bool is_harmonic(const std::array<Mode, 2>& modes, double duration) {
  if (modes[1].decays() && lasts(modes[0], modes[1], duration)) return false;
  const Estimate &larger = modes[0].angular_frequency, &smaller = modes[1].angular_frequency;
  return harmonic_of(smaller.value, smaller.standard_error,
                     {larger.value, larger.value, larger.standard_error}, duration) > 0;
}

}  // namespace

bool Mode::decays() const { return decay_rate.value > 3 * decay_rate.standard_error; }

MotionJudgement judge_motion(const Record& record, const LawFit& free, const LawFit& driven,
                             bool frequency_known) {
  MotionJudgement judgement;
  if (record.t.size() < 32 || !(free.residual.rms > 0)) return judgement;
  const auto lines = two_lines_of(record, driven);
  if (lines) {
    const auto& [own, steady] = *lines;
    const double g = std::max(own.decay_rate, 0.0);
    judgement.modes = fit_two_modes(record, {*lines, {own, {steady.angular_frequency, g}}});
  }
  const std::optional<TwoModes>& modes = judgement.modes;
  // In resonance the iteration of a drive that was named may end before the minimum, and leave less all the
  // same.
  const bool drives = driven.status == FitStatus::converged ||
                      (frequency_known && driven.status == FitStatus::iteration_limit && driven.has_values());

  double independent = free.independent_samples, least = free.residual.rms;
  if (drives && driven.residual.rms < least)
    independent = driven.independent_samples, least = driven.residual.rms;
  if (modes && modes->residual.rms < least) independent = modes->independent_samples;
  const auto criterion = [&](const auto& fit, double parameters) {
    return bayesian_criterion(std::max(2.0, independent), fit.residual.rms, parameters, record.resolution);
  };
  // A search over N frequencies costs 2 ln N. N is half the samples where all were searched.
  const double all = 2 * std::log(0.5 * static_cast<double>(record.t.size()));
  const double of_free = criterion(free, free.fitted);
  const double of_driven = drives ? criterion(driven, driven.fitted) + (frequency_known ? 0 : all) : HUGE_VAL;
  const double of_modes = modes ? criterion(*modes, TwoModes::parameters) + all : HUGE_VAL;
  // Who names a drive's frequency has seen the drive: it takes evidence to say that there is none.
  const bool driven_holds = of_driven < of_free + (frequency_known ? strong_evidence : -strong_evidence);
  const bool modes_hold = of_modes < of_free - strong_evidence;
  if (!driven_holds && !modes_hold) return judgement;

  const bool linear = is_linear(driven.law);
  if (!modes || (drives && !linear && of_driven < of_modes - strong_evidence)) {
    if (driven_holds) judgement.kind = MotionKind::driven;
    return judgement;
  }
  const auto& [one, other] = modes->modes;
  const auto shows = [](const Mode& mode) { return mode.amplitude > 4 * mode.amplitude_error; };
  const double duration = record.t.back() - record.t.front(), resolution = two_pi / duration;
  if (!frequency_known && is_harmonic(modes->modes, duration)) return judgement;
  const bool one_lasts = lasts(one, other, duration), other_lasts = lasts(other, one, duration);
  const bool apart = std::abs(one.angular_frequency.value - other.angular_frequency.value) > 0.5 * resolution;
  if (!one_lasts && !other_lasts) {
    // Two decays at one frequency are one swing that decays in another way than its law, or one in resonance,
    // where neither line shows how long it lasts.
    if (apart && shows(one) && shows(other) && modes_hold)
      judgement.kind = MotionKind::two_modes;
    else if (frequency_known && driven_holds)
      judgement.kind = MotionKind::driven;
  } else if (driven_holds) {
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
