#include "cromer/identify/choose/kind_of_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cromer/base/pi.h"
#include "cromer/identify/choose/criterion.h"
#include "cromer/identify/diagnose/second_mode.h"
#include "cromer/identify/least_squares/levenberg_marquardt.h"
#include "cromer/identify/start/driven_start.h"

namespace cromer::core {
namespace {

constexpr std::size_t most_judged = 100'000;

// Where the iteration begins.
struct ModeStart {
  double angular_frequency = 0;  // [rad/s] > 0
  double decay_rate = 0;         // [1/s]
};

// Order of the parameters: E, and w, g, A, B of each mode.
constexpr int first_of[] = {1, 5};
enum Place { frequency, decay, cosine, sine };

// The model and, in `row`, its derivatives.
double model_at(const Parameters& p, double s, Parameters& row) {
  double value = p[0];
  row[0] = 1;
  for (const int at : first_of) {
    const double fall = std::exp(-p[at + decay] * s), phase = p[at + frequency] * s;
    const double c = fall * std::cos(phase), d = fall * std::sin(phase);
    const double y = p[at + cosine] * c + p[at + sine] * d;
    value += y;
    row[at + frequency] = s * (p[at + sine] * c - p[at + cosine] * d);
    row[at + decay] = -s * y;
    row[at + cosine] = c;
    row[at + sine] = d;
  }
  return value;
}

NormalEquations equations_at(const Record& record, const Parameters& p) {
  NormalEquations equations{.size = TwoModes::parameters};
  Parameters row{};
  for (std::size_t i = 0; i < record.t.size(); ++i) {
    const double r = record.y[i] - model_at(p, record.t[i] - record.t.front(), row);
    equations.add_row(std::span(row).first<TwoModes::parameters>(), r);
  }
  return equations;
}

// Equilibrium and amplitudes are linear: those that fit best at the start's frequencies and decay rates.
std::optional<Parameters> with_amplitudes(const Record& record, const std::array<ModeStart, 2>& start) {
  Parameters p{};
  for (std::size_t mode = 0; mode < 2; ++mode) {
    p[first_of[mode] + frequency] = start[mode].angular_frequency;
    p[first_of[mode] + decay] = start[mode].decay_rate;
  }
  const NormalEquations equations = equations_at(record, p);
  std::array<bool, max_parameters> linear{};
  linear[0] = true;
  for (const int at : first_of) linear[at + cosine] = linear[at + sine] = true;
  const ScaledCholesky factor(equations.matrix, equations.size, 1e-12, linear);
  if (!factor.ok()) return std::nullopt;
  const Parameters step = factor.solve(equations.right);
  for (int j = 0; j < equations.size; ++j) p[j] += step[j];
  return p;
}

TwoModes described(const Record& record, const LeastSquaresSummary& minimum) {
  const Parameters& p = minimum.parameters;
  const auto n = static_cast<double>(record.t.size());
  std::vector<double> residuals;
  Parameters row{};
  for (std::size_t i = 0; i < record.t.size(); ++i)
    residuals.push_back(record.y[i] - model_at(p, record.t[i] - record.t.front(), row));
  const std::vector<double> rho = autocorrelations(residuals, first_lags(residuals.size()));
  TwoModes fit;
  fit.residual = describe_residual(residuals, rho);
  const double h = (record.t.back() - record.t.front()) / (n - 1);
  const SquareMatrix covariance = inverse(minimum.equations.matrix, TwoModes::parameters);
  double widest = 1;
  for (std::size_t mode = 0; mode < 2; ++mode) {
    const int at = first_of[mode];
    const double factor = std::min(n, correlation_factor(residuals, rho, p[at + frequency] * h));
    widest = std::max(widest, factor);
    const double variance = factor * std::max(minimum.equations.sum_of_squares / (n - TwoModes::parameters),
                                              record.resolution * record.resolution / 12);
    const double student = student_95(std::max(1.0, n / factor - TwoModes::parameters));
    const auto error = [&](int i) { return std::sqrt(variance * covariance[at + i][at + i]); };
    Mode& found = fit.modes[mode];
    found.angular_frequency = make_estimate(p[at + frequency], error(frequency), student);
    found.decay_rate = make_estimate(p[at + decay], error(decay), student);
    found.amplitude = std::hypot(p[at + cosine], p[at + sine]);
    found.amplitude_error = std::max(error(cosine), error(sine));
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
  const auto model = [&](const Parameters& p) {
    const bool possible = p[first_of[0] + frequency] > 0 && p[first_of[1] + frequency] > 0;
    if (possible) return equations_at(part, p);
    NormalEquations nowhere;
    nowhere.sum_of_squares = HUGE_VAL;
    return nowhere;
  };
  LeastSquaresOptions options;
  options.iteration_limit = 40;
  options.error_tolerance = 1e-3;
  options.scale = centred_norm(part.y);
  options.residuals = static_cast<int>(part.t.size());
  std::optional<LeastSquaresSummary> best;
  for (const auto& start : starts) {
    const std::optional<Parameters> p = with_amplitudes(part, start);
    if (!p) continue;
    const LeastSquaresSummary minimum = minimise(model, *p, options);
    if (minimum.reason != LeastSquaresReason::converged) continue;
    if (!best || minimum.equations.sum_of_squares < best->equations.sum_of_squares) best = minimum;
  }
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

// The smaller line is a harmonic of the larger.
bool is_harmonic(const std::array<Mode, 2>& modes, double duration) {
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
