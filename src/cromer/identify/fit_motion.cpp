#include "cromer/identify/fit_motion.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "cromer/analysis/swing.h"
#include "cromer/base/at_once.h"
#include "cromer/base/extent.h"
#include "cromer/base/for_page.h"
#include "cromer/base/pi.h"
#include "cromer/identify/describe_fit.h"
#include "cromer/identify/diagnose/refusal.h"
#include "cromer/identify/fit_settings.h"
#include "cromer/identify/fit_viscous.h"
#include "cromer/identify/least_squares/noise.h"
#include "cromer/identify/rest_minima.h"
#include "cromer/identify/start/driven_start.h"
#include "cromer/model/law_force.h"

namespace cromer::core {
namespace {

constexpr double coarsest = 1.0 / 20;  // step, in periods: off by a millionth a radian

// A record beside the motions of one law, as the minimiser asks for them.
class Problem {
 public:
  Problem(const Record& record, const LawFitOptions& options, const FittedParameters& fitted,
          const Watch& watch)
      : record_(record), options_(options), fitted_(fitted), watch_(watch) {}

  const Record& record() const { return record_; }

  auto model(const Record& part, double h) const {
    return interruptible(
        [this, part, h](const Parameters& parameters) {
          return motion_equations(fitted_, parameters, options_.drive, part, h);
        },
        watch_, (options_.law.has<Hysteresis>() ? 3 : 1) * steps_through(part.t, h));
  }
  auto model(double h) const { return model(record_, h); }

  LeastSquaresOptions settings(const Record& part) const {
    LeastSquaresOptions settings = least_squares_options(part, options_);
    settings.lower = fitted_.lower_bounds();
    settings.along_bounds = !is_recorded(options_.drive.kind);
    return settings;
  }

  // The rms difference between the motions at steps of h and of h/2 over the first so many samples.
  double method_error(const Parameters& p, std::size_t samples, double h) const {
    const Motion motion = fitted_.unpack(p);
    const Record part = record_.first(samples);
    const std::vector<double> y = observed_motion(motion, options_.drive, part.t, part.derivative, h),
                              finer = observed_motion(motion, options_.drive, part.t, part.derivative, h / 2);
    double sum = 0;
    const std::size_t n = std::min(y.size(), finer.size());
    for (std::size_t i = 0; i < n; ++i) sum += (y[i] - finer[i]) * (y[i] - finer[i]);
    return std::sqrt(sum / static_cast<double>(n));
  }

  const FittedParameters& fitted() const { return fitted_; }
  const LawFitOptions& options() const { return options_; }

 private:
  const Record& record_;
  const LawFitOptions& options_;
  const FittedParameters& fitted_;
  const Watch& watch_;
};

// The amplitude of a sinusoid as strong as the record, as a displacement.
double amplitude_of(const Record& record, double w) {
  return sinusoid_amplitude(record.y) / std::pow(std::max(1e-300, w), record.derivative);
}

// Every n-th sample, at least twenty in a period; of a motion that is free or harmonically driven.
struct Thinned {
  std::vector<double> t, y;
  Record record;

  Thinned(const Record& all, double period, DriveKind drive) : record(all) {
    if (is_recorded(drive)) return;
    const double h = (all.t.back() - all.t.front()) / static_cast<double>(all.t.size() - 1);
    const auto stride = static_cast<std::size_t>(std::clamp(period / (20 * h), 1.0, 1e6));
    if (stride < 2) return;
    for (std::size_t i = 0; i < all.t.size(); i += stride) t.push_back(all.t[i]), y.push_back(all.y[i]);
    if (t.size() < 64) return;
    record.t = t;
    record.y = y;
  }
};

/// A law is given up that leaves so many times the rms to beat: a part's least sum of squares is a bound on
/// the whole record's.
constexpr double given_up = 2;

struct Grown {
  Parameters parameters;
  bool hopeless = false;
};

// From a first part to the whole record, twice as long each time.
Grown grow(const Problem& problem, const KnownMotion& known, double h, double period) {
  const Record& record = problem.record();
  const LawFitOptions& options = problem.options();
  Grown grown{problem.fitted().pack(known.motion)};
  for (std::size_t samples = known.samples; samples < record.t.size(); samples *= 2) {
    const Thinned part(record.first(samples), period, options.drive.kind);
    LeastSquaresOptions settings = problem.settings(part.record);
    settings.error_tolerance = 0.1;
    settings.iteration_limit = 12;
    const LeastSquaresSummary summary = minimise(problem.model(part.record, h), grown.parameters, settings);
    grown.parameters = summary.parameters;
    const double thinned = static_cast<double>(part.record.t.size()) / static_cast<double>(samples);
    const double most = given_up * options.rms_to_beat;
    grown.hopeless =
        summary.equations.sum_of_squares > most * most * thinned * static_cast<double>(record.t.size());
    if (grown.hopeless) break;
  }
  return grown;
}

// Under a recorded force no step is longer than between two of its samples, or than half a radian.
double recorded_step(double spacing, double w) { return w > 0 ? std::min(spacing, 0.5 / w) : spacing; }

// The highest frequency worth following [rad/s]: a start that is far off may be much faster than the record,
// whose crossings of its mean tell how fast it swings.
double fastest_seen(const Record& record, double w0) {
  double mean = 0;
  for (const double y : record.y) mean += y / static_cast<double>(record.y.size());
  int crossings = 0;
  for (std::size_t i = 1; i < record.y.size(); ++i)
    crossings += (record.y[i] > mean) != (record.y[i - 1] > mean);
  const double seen = crossings * std::numbers::pi / (record.t.back() - record.t.front());
  return std::max(4 * w0, 2 * seen);
}

// How long the steps of a motion may be.
class StepLength {
 public:
  StepLength(const Problem& problem, const KnownMotion& known) : problem_(problem) {
    const Motion& first = known.motion;
    const Record& record = problem.record();
    const double w0 = first.angular_frequency();
    w_ = std::max(w0, first.drive_frequency);
    // A spring that hardens swings faster where it swings far: at the start, or later where the swing grows.
    const auto [low, high] = extent_of(record.y);
    const double widest = 0.5 * (high - low) / std::pow(w0, record.derivative);
    if (const double far = std::max(widest, std::hypot(first.position, first.velocity / w0));
        problem.options().drive.kind == DriveKind::none && std::isfinite(far) && !first.law.has<Pendulum>())
      if (const double w = Swing<double>{first.per_mass}.angular_frequency(far); std::isfinite(w))
        w_ = std::max(w_, std::min(w, fastest_seen(record, w0)));
    amplitude_ = std::max(sinusoid_amplitude(record.y),
                          std::hypot(first.position, first.velocity / w0) * std::pow(w0, record.derivative));
    // The phase goes wrong with the time, and each moment counts by its amplitude.
    const double mean =
        std::accumulate(record.y.begin(), record.y.end(), 0.0) / static_cast<double>(record.y.size());
    double squares = 0;
    for (std::size_t i = 0; i < record.t.size(); ++i) {
      const double gone = (record.t[i] - record.t.front()) * (record.y[i] - mean);
      squares += gone * gone;
    }
    lag_ = std::sqrt(2 * squares / static_cast<double>(record.t.size())) / amplitude_;
  }

  bool recorded() const { return is_recorded(problem_.options().drive.kind); }
  double period() const { return two_pi / w_; }

  // The first step; under a recorded force, one that is off by less than a two-hundredth in the record's
  // beginning.
  double coarse(const Parameters& start) const {
    if (!recorded()) return rough(start, problem_.options().rms_to_beat);
    double h = recorded_step(problem_.options().drive.force.spacing, w_);
    const Record& record = problem_.record();
    const double enough = 0.005 * centred_norm(record.y) / std::sqrt(static_cast<double>(record.t.size()));
    for (int halvings = 0; halvings < 4; ++halvings, h /= 2)
      if (problem_.method_error(start, std::min<std::size_t>(record.t.size(), 1000), h) < enough) break;
    return h;
  }

  // As fine as it takes to compare laws at a residual of this rms.
  double rough(const Parameters& at, double rms) const {
    return std::min(coarsest * period(), for_share(at, rms, comparing_share));
  }

  // The method's error may move a parameter by a twentieth of its standard error, under a recorded force by a
  // tenth. `measured`: found by halving, as it is under a recorded force; else by the formula for a sinusoid.
  double fine(const LeastSquaresSummary& at, double samples, double h, bool measured) const {
    const double n = static_cast<double>(problem_.record().t.size());
    const double rms = rms_of(at, samples);
    if (!recorded()) {
      h = for_share(at.parameters, rms, 0.05);
      constexpr double shortest = 1.0 / 300;  // of a period: what needs less does not belong to the record
      return measured ? halved(at.parameters, h, 0.0025 * rms * rms / n, shortest * period()) : h;
    }
    // A standard error moves the motion by one residual's rms in all. Steps shorter than this are not tried:
    // such a motion does not belong to the record.
    constexpr double shortest = 1.0 / 256;
    return halved(at.parameters, h, 0.01 * rms * rms / n,
                  shortest * recorded_step(problem_.options().drive.force.spacing, w_));
  }

  double rms_of(const LeastSquaresSummary& at, double samples) const {
    return std::max(std::sqrt(at.equations.sum_of_squares / samples),
                    least_residual * centred_norm(problem_.record().y) /
                        std::sqrt(static_cast<double>(problem_.record().t.size())));
  }

 private:
  // Where the method's error moves the motion by this share of what a standard error does.
  double for_share(const Parameters& at, double rms, double share) const {
    const double n = static_cast<double>(problem_.record().t.size());
    return motion_step(w_, time_gone_wrong(at), share * rms / (std::sqrt(n) * amplitude_));
  }

  // The time [s] over which the phase goes wrong, an rms weighted by the amplitude. What a drive keeps up
  // forgets after 1/g.
  double time_gone_wrong(const Parameters& at) const {
    if (problem_.options().drive.kind == DriveKind::none) return lag_;
    return std::min(lag_, 1 / std::max(1e-300, problem_.fitted().unpack(at).decay_rate()));
  }

  // Down to a step whose mean square error is small enough.
  double halved(const Parameters& at, double h, double enough, double least_step) const {
    for (int halvings = 0; halvings < 6 && h > least_step; ++halvings, h /= 2) {
      const double error = problem_.method_error(at, problem_.record().t.size(), h);
      if (error * error <= enough) break;
    }
    return h;
  }

  const Problem& problem_;
  double w_ = 0, lag_ = 0, amplitude_ = 0;
};

// Where the iteration ended, and with steps of which length.
struct FoundMinimum {
  Minimum minimum;
  double h = 0;
  int iterations = 0;
  bool refined = true;  // else it was left where it could not beat `rms_to_beat`
};

// Whether friction stops the motion after so few half swings that the next number of them may be the right
// one: a search seldom changes it.
bool may_rest_elsewhere(const Problem& problem, const Parameters& parameters, double h) {
  const LawFitOptions& options = problem.options();
  if (options.drive.kind != DriveKind::none || !options.law.has<Friction>()) return false;
  constexpr int few = 30;
  const Rest rest = rest_of(problem.fitted(), parameters, problem.record(), h);
  return rest.first < problem.record().t.size() && rest.half_swings <= few;
}

// Most of the way in coarse steps and on few samples, then as fine as the residuals ask for.
FoundMinimum find_minimum(const Problem& problem, const KnownMotion& known, bool roughly) {
  const Record& record = problem.record();
  const LawFitOptions& options = problem.options();
  const StepLength steps(problem, known);
  const auto n = static_cast<double>(record.t.size());
  FoundMinimum found;
  found.h = steps.coarse(problem.fitted().pack(known.motion));
  LeastSquaresOptions settings = problem.settings(record);
  const Thinned thinned(record, steps.period(), options.drive.kind);
  LeastSquaresOptions coarse = settings;
  coarse.error_tolerance = roughly || steps.recorded() ? 1e-2 : 1e-1;
  if (roughly) coarse.iteration_limit = std::min(20, options.iteration_limit);
  coarse.residuals = static_cast<int>(thinned.record.t.size());
  const Grown start = grow(problem, known, found.h, steps.period());
  // A law that is given up is described at the parameters that it has.
  const auto as_it_is = [&](const Parameters& parameters, LeastSquaresReason reason) {
    LeastSquaresSummary& here = found.minimum.bounded;
    here = {.reason = reason, .parameters = parameters, .equations = problem.model(found.h)(parameters)};
    if (!std::isfinite(here.equations.sum_of_squares)) here.reason = LeastSquaresReason::not_finite;
    found.minimum.free = here;
    found.refined = false;
    return found;
  };
  if (start.hopeless) return as_it_is(start.parameters, LeastSquaresReason::iteration_limit);
  LeastSquaresSummary summary = minimise(problem.model(thinned.record, found.h), start.parameters, coarse);
  found.iterations = summary.iterations;
  for (int round = 0; round < 4 && !steps.recorded(); ++round) {
    const double finer = steps.rough(summary.parameters, steps.rms_of(summary, coarse.residuals));
    if (finer > 0.8 * found.h) break;
    found.h = finer;
    summary = minimise(problem.model(thinned.record, found.h), summary.parameters, coarse);
    found.iterations += summary.iterations;
  }
  const auto leaves = [&](double times) {
    const double most = times * options.rms_to_beat;
    return summary.equations.sum_of_squares > most * most * static_cast<double>(coarse.residuals);
  };
  constexpr double close = 1.2, of_another_rest = 4;
  if (leaves(close) && (leaves(of_another_rest) || !may_rest_elsewhere(problem, summary.parameters, found.h)))
    return as_it_is(summary.parameters, summary.reason);
  if (roughly) {
    settings.error_tolerance = 1e-2;
    settings.iteration_limit = std::min(20, options.iteration_limit);
    found.minimum.bounded = found.minimum.free =
        minimise(problem.model(found.h), summary.parameters, settings);
    found.iterations += found.minimum.bounded.iterations;
    return found;
  }
  if (steps.recorded()) settings.error_tolerance = 1e-3;
  // Corners that fall between steps, now here, now there, make the sum of squares rough.
  if (options.law.has<Hysteresis>() && !steps.recorded()) settings.roughness = 0.1;
  // What feeds itself swings in bursts, or grows, and a hysteretic force has corners: a formula for sinusoids
  // knows nothing of either.
  const bool measured = options.law.has<VanDerPol>() || options.law.has<Hysteresis>() || options.may_grow;
  // Corners make a coarse sum of squares too rough to descend.
  found.h = steps.fine(summary, coarse.residuals, found.h, options.law.has<Hysteresis>());
  Parameters from = summary.parameters;
  for (int round = 0; round < 4; ++round) {
    found.minimum = minimise_both(problem.model(found.h), from, settings);
    found.iterations += found.minimum.bounded.iterations;
    from = found.minimum.bounded.parameters;
    if (!std::isfinite(found.minimum.bounded.equations.sum_of_squares)) break;
    // It wanders along a valley: where such a law is right, a few steps end at the minimum.
    if (measured && found.minimum.bounded.reason == LeastSquaresReason::iteration_limit) break;
    const double finer = steps.fine(found.minimum.bounded, n, found.h, measured);
    if (finer > 0.8 * found.h) break;
    found.h = finer;
  }
  return found;
}

Parameters rounding_bias_of(const Problem& problem, const FoundMinimum& found,
                            std::span<const double> residuals) {
  Parameters bias{};
  const std::vector<double> y = rounded_motion(problem.record(), residuals);
  if (y.empty()) return bias;
  Record pulled = problem.record();
  pulled.y = y;
  const int size = problem.fitted().count;
  const NormalEquations pull = motion_equations(problem.fitted(), found.minimum.bounded.parameters,
                                                problem.options().drive, pulled, found.h);
  const SquareMatrix inverse_matrix = inverse(found.minimum.free.equations.matrix, size);
  if (!std::isfinite(inverse_matrix[0][0])) return bias;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) bias[i] += inverse_matrix[i][j] * pull.right[j];
  return bias;
}

// A minimum was found, but its law accounts for less than three tenths of the motion's variance.
void refuse_what_explains_too_little(LawFit& fit) {
  constexpr double least = 0.3;
  if (fit.drive.kind == DriveKind::none || fit.status != FitStatus::converged || fit.explained >= least)
    return;
  refuse(fit, {FitStatus::too_noisy, explains_too_little(fit)});
}

// The frequency of a large swing depends on its amplitude: a start from the whole record's viscous fit would
// then lose count of the periods, and a few periods' does not.
KnownMotion linear_motion(const Record& record, const LawFitOptions& options, const LawFit& viscous,
                          const Watch& watch) {
  constexpr double certain = 0.95;
  const double decay_rate = viscous.decay_rate().value;
  if (viscous.explained > certain) return {viscous.motion, record.t.size(), decay_rate};
  const auto first = fit_first_periods(record, viscous.angular_frequency().value, options, watch);
  if (!first) return {viscous.motion, record.t.size(), decay_rate};
  return {first->fit.motion, first->samples, decay_rate};
}

// The start of a driven motion follows most of it, or is grown from a first part, in which a frequency that
// is a little off has no time to lose step.
KnownMotion known_driven(const Record& record, const Drive& drive, const Motion& start) {
  KnownMotion known{start, record.t.size(), 0};
  if (!is_recorded(drive.kind)) return known;
  const double spacing = drive.force.spacing, w0 = start.angular_frequency();
  const std::vector<double> r = motion_residuals(start, drive, record, recorded_step(spacing, w0));
  double squares = 0;
  for (const double each : r) squares += each * each;
  constexpr double followed = 0.3;  // of the motion's squares
  const double norm = centred_norm(record.y);
  if (r.size() == record.t.size() && squares < followed * norm * norm) return known;
  const std::size_t fewest = std::min<std::size_t>(64, record.t.size());
  known.samples = w0 > 0 ? std::max(fewest, first_periods(record, w0, 6).t.size()) : fewest;
  return known;
}

// The fundamental of a hysteretic force over a steady swing, per unit of its amplitude [1/s^2]: along the
// displacement, and along the velocity as the imaginary part. The force starts with this slope and levels off
// at `top`. N. Krylov & N. Bogoliubov, Introduction to Non-linear Mechanics, 1943.
[[maybe_unused]] std::complex<double> loop_of(double slope, double top, double exponent, double amplitude) {
  constexpr int steps = 200;
  double z = 0;
  std::complex<double> sum = 0;
  for (int i = 0; i < 3 * steps; ++i) {  // in the third turn it repeats itself
    const double angle = two_pi * (i + 0.5) / steps, dx = -amplitude * std::sin(angle) * two_pi / steps;
    const double before = z, level = std::pow(std::abs(z) / top, exponent);
    z = std::clamp(z + slope * (dx - std::abs(dx) * std::copysign(level, z)), -top, top);
    if (i >= 2 * steps) sum += (before + z) / 2 * std::polar(2.0 / steps, -angle);
  }
  return sum / amplitude;
}

// A hysteretic force beside the spring: shares of the stiffness that the linear law has, loops of the width
// that the motion has, and most of the damping in them. The drive keeps up the swing that it has by the
// linear law.
std::vector<Motion> hysteretic_starts(const Motion& linear, const LawFitOptions& options, double amplitude) {
  std::vector<Motion> starts;
  const double stiffness = linear.angular_frequency() * linear.angular_frequency();
  // The page, which must be small, begins with the linear law's drive.
  const bool is_driven = !for_page && options.drive.kind == DriveKind::harmonic;
  const std::vector<double> widths =
      is_driven ? std::vector{0.03, 0.1, 0.3, 1.0, 3.0} : std::vector{0.3, 1.0, 3.0};
  for (const double share : {0.3, 0.6})
    for (const double width : widths) {
      Motion motion = linear;
      motion.law = options.law;
      motion.set_decay_rate(0.3 * linear.decay_rate());
      // The force levels off where beta |z|^n = A, at z = 2 width amplitude A.
      const double slope = share * stiffness, n = options.hysteresis_exponent,
                   top = 2 * width * amplitude * slope;
      motion.per_mass.hysteresis_stiffness = slope;
      motion.per_mass.hysteresis_beta = slope / std::pow(top, n);
      motion.per_mass.hysteresis_gamma = 0;
      motion.per_mass.hysteresis_exponent = n;
      if (is_driven) {
        const std::complex<double> loop = loop_of(slope, top, n, amplitude);
        motion.set_angular_frequency(std::sqrt(stiffness - loop.real()));
        const double w = linear.drive_frequency, elastic = stiffness - w * w;
        const std::complex<double> by_linear(elastic, w * linear.per_mass.damping),
            by_loop(elastic, w * motion.per_mass.damping + loop.imag());
        if (std::abs(by_linear) > 0) {
          const auto drive = std::complex(motion.cosine, -motion.sine) * by_loop / by_linear;
          motion.cosine = drive.real();
          motion.sine = -drive.imag();
        }
      } else {
        motion.set_angular_frequency(std::sqrt((1 - share) * stiffness));
      }
      starts.push_back(motion);
    }
  return starts;
}

// Starts for a motion that friction stops within a few half swings, whose envelope does not tell how many.
// They differ in the number of half swings, in the other damping, in where within the friction band the body
// rests, and in the frequency: a damped swing fitted to such a record is off by up to a tenth.
std::vector<Motion> friction_starts(const Motion& known, const Record& record) {
  std::vector<Motion> starts;
  const std::span<const double> end = record.y.last(std::max<std::size_t>(1, record.y.size() / 10));
  const double rest = std::accumulate(end.begin(), end.end(), 0.0) / static_cast<double>(end.size());
  const double first = record.y.front();
  const double amplitude = std::hypot(first - rest, known.velocity / known.angular_frequency());
  for (const double faster : {0.9, 1.0, 1.1})
    for (const double damping : {0.02, 0.2})
      for (const double half_swings : {0.7, 1.0, 1.3, 1.6, 2.0, 2.4, 2.9, 3.4, 4.0, 4.7, 5.5})
        for (const double place : {-0.7, 0.0, 0.7}) {
          Motion motion = known;
          const double w = faster * known.angular_frequency();
          motion.set_angular_frequency(w);
          for_each_term([&]<class T>() {
            if constexpr (T::info.damps) motion.per_mass.*T::template members<double>[0] *= damping;
          });
          const double band = amplitude / (2 * half_swings);
          motion.per_mass.friction = band * w * w;
          motion.equilibrium = rest - place * band;
          motion.position = first - motion.equilibrium;
          starts.push_back(motion);
        }
  return starts;
}

// For each number of half swings before the rest, the two starts of least squares: a search seldom changes
// that number.
std::vector<Motion> closest_of_each(const std::vector<Motion>& starts, const Problem& problem, double h) {
  std::map<int, std::vector<std::pair<double, std::size_t>>> sums;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    double sum = 0;
    for (const double r : motion_residuals(starts[i], {}, problem.record(), h)) sum += r * r;
    const Rest rest = rest_of(problem.fitted(), problem.fitted().pack(starts[i]), problem.record(), h);
    if (std::isfinite(sum)) sums[rest.half_swings].emplace_back(sum, i);
  }
  std::vector<Motion> best;
  for (auto& [number, each] : sums) {
    std::sort(each.begin(), each.end());
    for (std::size_t i = 0; i < std::min<std::size_t>(2, each.size()); ++i)
      best.push_back(starts[each[i].second]);
  }
  return best;
}

// The one of several starts from which some steps lead furthest down. Of many not all go on after the first
// few steps, but the `followed` lowest.
KnownMotion best_start(const std::vector<Motion>& starts, const KnownMotion& known, const Problem& problem,
                       std::size_t followed) {
  const std::size_t samples = std::min<std::size_t>(problem.record().t.size(), 4000);
  const Record part = problem.record().first(samples);
  LeastSquaresOptions settings = problem.settings(part);
  settings.error_tolerance = 0.1;
  std::vector<LeastSquaresSummary> tried(starts.size());
  for (std::size_t i = 0; i < starts.size(); ++i) tried[i].parameters = problem.fitted().pack(starts[i]);
  const auto is_lower = [](const LeastSquaresSummary& a, const LeastSquaresSummary& b) {
    return a.equations.sum_of_squares < b.equations.sum_of_squares;
  };
  constexpr int few = 8, all = 25;
  for (const int limit :
       followed < starts.size() ? std::vector<int>{few, all - few} : std::vector<int>{all}) {
    settings.iteration_limit = limit;
    at_once(tried.size(), [&](std::size_t i) {
      const Parameters p = tried[i].parameters;
      if (tried[i].reason == LeastSquaresReason::converged) return;
      const StepLength steps(problem, {problem.fitted().unpack(p), samples, 0});
      tried[i] = minimise(problem.model(part, steps.coarse(p)), p, settings);
    });
    while (tried.size() > followed) tried.erase(std::max_element(tried.begin(), tried.end(), is_lower));
  }
  const LeastSquaresSummary& lowest = *std::min_element(tried.begin(), tried.end(), is_lower);
  if (!std::isfinite(lowest.equations.sum_of_squares)) return known;
  return {problem.fitted().unpack(lowest.parameters), samples, known.decay_rate};
}

}  // namespace

KnownMotion Beginning::known(const Law& law, const Record& record) const {
  KnownMotion result = known_motion;
  const double w0 = result.motion.angular_frequency();
  result.motion = result.motion.under(law);
  if (law.shares(springs)) result.motion.set_angular_frequency(w0);
  const double cubic = known_motion.motion.per_mass.cubic;
  if (cubic != 0 && !law.has<Cubic>()) {
    const double amplitude = amplitude_of(record, w0),
                 shift = cubic * cycle_average<Cubic>(amplitude, w0).shift;
    // What softens a spring is the lower power: the higher would let it run away.
    if (law.has<OddQuadratic>() && (cubic < 0 || !law.has<Quintic>()))
      result.motion.per_mass.odd_quadratic = shift / cycle_average<OddQuadratic>(amplitude, w0).shift;
    else if (law.has<Quintic>())
      result.motion.per_mass.quintic = shift / cycle_average<Quintic>(amplitude, w0).shift;
  }
  if (is_recorded(linear.drive.kind)) return known_driven(record, linear.drive, result.motion);
  if (track) {
    result.motion = motion_along(*track, law, record.t.front());
    // Where it comes to rest depends on how many half swings there are: the swing itself must tell that
    // before the rest may pull.
    result.samples = law.has<Friction>() ? track->swinging : track->samples;
    // Where the frequency changes much along the record, a start that is a little off loses step.
    constexpr double much = 0.1;
    const double w = result.motion.angular_frequency();
    if (std::abs(track->frequency - w) > much * w)
      result.samples = std::min(result.samples, track->samples / 8);
  }
  return result;
}

Beginning begin_fit(const Record& record, const LawFitOptions& options, const Watch& watch) {
  Beginning beginning;
  if (options.drive.kind == DriveKind::none) {
    beginning.linear = fit_viscous(record, options, watch);
    // Where friction stops the motion after a swing, damping is a wrong law: its frequency may be unknown,
    // and that of the right one not.
    LawFit& linear = beginning.linear;
    if (linear.status == FitStatus::too_noisy && linear.explained > 0.9 && refuse_frequency(linear)) {
      linear.status = FitStatus::converged;
      linear.message = {};
    }
    if (!beginning.usable()) return beginning;
    beginning.known_motion = linear_motion(record, options, beginning.linear, watch);
    beginning.track = track_envelope(record, beginning.known_motion.motion.angular_frequency(),
                                     beginning.known_motion.decay_rate);
    return beginning;
  }
  // The linear law leads the way: it has the widest valley. A recorded force shows a bent spring from the
  // start: there a cubic one leads all others.
  LawFitOptions linear = options;
  const bool recorded = is_recorded(options.drive.kind);
  constexpr Law odd = law_with<OddQuadratic, Quintic>;
  const bool both = options.law.contains(odd);
  const Law bends = both ? odd : law_with<Quadratic, Cubic>;
  const Law leading = recorded ? springs.with(bends) : springs;
  linear.law = Law{options.law.terms & leading.terms}.with(law_with<Viscous>);
  if (recorded && options.law.shares(springs) && options.law.shares(odd) && !both)
    linear.law = linear.law.with(law_with<Cubic>);
  const std::optional<Motion> start = options.drive.kind != DriveKind::harmonic
                                          ? forced_start(record, options.drive.force, linear.law)
                                      : options.start ? std::optional(options.start->motion)
                                                      : driven_start(record, options.drive_frequency);
  if (!start) {
    beginning.linear =
        refused({FitStatus::no_oscillation,
                 Notice{options.drive.kind == DriveKind::harmonic ? "no_line" : "no_resonance"}},
                options);
    return beginning;
  }
  beginning.linear = fit_motion(record, linear, known_driven(record, linear.drive, *start), watch);
  beginning.known_motion = {beginning.linear.motion, record.t.size(), 0};
  return beginning;
}

namespace {

/// Whether a record under a recorded force tells offset and equilibrium apart: where the spring bends, and
/// not so that moving the origin turns one law into another of the same terms.
bool tells_its_origin(const Law& law) {
  constexpr Law cubic_and_below = law_with<Spring, Quadratic, Cubic>;
  const Law bent{law.terms & terms_of_position.terms};
  if (bent == law_with<Spring>) return false;
  return !bent.has<Quadratic>() || !cubic_and_below.contains(bent);
}

/// The same motion as far as the spring does not bend: about this equilibrium, with the force's offset to
/// match.
Motion about(double equilibrium, Motion motion) {
  const double moved = equilibrium - motion.equilibrium, w = motion.angular_frequency();
  if (motion.force_gain != 0) motion.force_offset -= w * w * moved / motion.force_gain;
  motion.equilibrium = equilibrium;
  motion.position -= moved;
  return motion;
}

/// About the place of rest where the force has no offset.
Motion without_offset(const Motion& motion) {
  const double w = motion.angular_frequency();
  const double stretched = motion.force_gain * motion.force_offset / (w * w);
  Motion moved = std::isfinite(stretched) ? about(motion.equilibrium + stretched, motion) : motion;
  moved.force_offset = 0;
  return moved;
}

LawFit fit_holding(const HeldParameters& held, const Record& record, const LawFitOptions& options,
                   KnownMotion known, const Watch& watch, bool roughly) {
  LawFit fit;
  fit.law = options.law;
  fit.drive = options.drive;
  if (held.equilibrium && known.motion.equilibrium != 0) known.motion = about(0, known.motion);
  if (held.force_offset && known.motion.force_offset != 0) known.motion = without_offset(known.motion);
  Motion values = known.motion;
  values.per_mass.hysteresis_exponent = options.hysteresis_exponent;
  const FittedParameters fitted =
      fitted_parameters(options.law, options.drive.kind, held, values, options.may_grow);
  const Problem problem(record, options, fitted, watch);
  KnownMotion from = known;
  if (options.law.has<Hysteresis>() && !(known.motion.per_mass.hysteresis_stiffness > 0)) {
    const double amplitude = amplitude_of(record, known.motion.angular_frequency());
    const std::vector<Motion> starts = hysteretic_starts(known.motion, options, amplitude);
    // A driven motion shows late which start is the right one.
    const bool is_free = options.drive.kind == DriveKind::none;
    from = best_start(starts, known, problem, is_free ? 3 : starts.size());
  }
  // More than a fifth of the amplitude is lost in a period: friction may stop it within a few half swings.
  const bool may_stop_early = options.drive.kind == DriveKind::none && options.law.has<Friction>() &&
                              record.derivative == 0 &&
                              known.decay_rate * two_pi > 0.2 * known.motion.angular_frequency();
  if (may_stop_early) {
    // Its first swings are enough to begin with.
    const double w = known.motion.angular_frequency();
    const Thinned few(first_periods(record, w, 8), two_pi / w, options.drive.kind);
    const Problem beginning(few.record, options, fitted, watch);
    std::vector<Motion> starts =
        closest_of_each(friction_starts(known.motion, record), beginning, coarsest * two_pi / w);
    starts.push_back(known.motion);
    from = {best_start(starts, known, beginning, (starts.size() + 1) / 2).motion, record.t.size(),
            known.decay_rate};
  }
  FoundMinimum found = find_minimum(problem, from, roughly);
  Minimum& minimum = found.minimum;

  // Of the minima for several numbers of half swings before a rest the lowest counts.
  std::vector<LeastSquaresSummary> minima{minimum.bounded};
  if (options.drive.kind == DriveKind::none && options.law.has<Friction>() && found.refined) {
    const LeastSquaresOptions settings = problem.settings(record);
    minima = rest_minima(record, fitted, minimum.bounded, settings, found.h, watch);
    if (minima.front().equations.sum_of_squares < minimum.bounded.equations.sum_of_squares) {
      minimum = minimise_both(problem.model(found.h), minima.front().parameters, settings);
      found.iterations += minimum.bounded.iterations;
    }
    if (minimum.bounded.reason == LeastSquaresReason::iteration_limit)
      minimum.bounded = minimum.free =
          end_of_band_minimum(record, fitted, minimum.bounded, settings, found.h, watch);
    minima.front() = minimum.bounded;
  }

  if (watch.interrupted()) return interrupted_fit(options, watch);
  fit.iterations = found.iterations;
  fit.step = found.h;
  const Motion motion = fitted.unpack(minimum.bounded.parameters);
  const std::vector<double> residuals = motion_residuals(motion, options.drive, record, found.h);
  if (residuals.size() != record.t.size() || !std::isfinite(residuals.back())) {
    set_status(fit, LeastSquaresReason::not_finite);
    return fit;
  }
  DescribedMinimum described{.fitted = fitted,
                             .parameters = minimum.bounded.parameters,
                             .without_bounds = minimum.free.parameters,
                             .matrix = minimum.free.equations.matrix,
                             .residuals = residuals};
  if (!roughly) {
    described.rounding_bias = rounding_bias_of(problem, found, residuals);
    described.jacobian = [&] {
      return jacobian_of(fitted, minimum.bounded.parameters, options.drive, record, found.h);
    };
  }
  describe_fit(fit, record, described);
  spread_over(fit, fitted, minima);
  set_status(fit, minimum.bounded.reason);
  for (const auto& reason : {refuse_frequency, refuse_harmonic})
    if (const auto refusal = reason(fit); refusal && fit.status == FitStatus::converged)
      refuse(fit, *refusal);
  refuse_what_explains_too_little(fit);
  return fit;
}

LawFit fit_of_either_zero(const Record& record, const LawFitOptions& options, const KnownMotion& known,
                          const Watch& watch, bool roughly) {
  const HeldParameters held = held_parameters(record, options.law, options.drive.kind);
  LawFit fit = fit_holding(held, record, options, known, watch, roughly);
  if (options.drive.kind == DriveKind::none && !watch.interrupted())
    fit = or_growing(
        std::move(fit), options,
        [&](const LawFitOptions& growing) {
          return fit_holding(held, record, growing, known, watch, roughly);
        },
        known.decay_rate < 0);
  const bool by_convention = held.equilibrium && record.derivative == 0 && options.law.shares(springs);
  if (!by_convention || !tells_its_origin(options.law)) return fit;
  // The zero may lie amid the motion by chance: the record tells.
  constexpr double clearly = 2;  // of the residuals' variance
  LawFit other =
      fit_holding({.force_offset = true}, record, options,
                  fit.is_usable() ? KnownMotion{fit.motion, record.t.size(), 0} : known, watch, roughly);
  if (!other.is_usable()) return fit;
  const auto squares = [&](const LawFit& each) {
    return each.residual.rms * each.residual.rms * static_cast<double>(record.t.size());
  };
  const double variance = other.residual.rms * other.residual.rms;
  return fit.is_usable() && squares(fit) < squares(other) + clearly * variance ? fit : other;
}

// A pendulum a whole turn on swings in the same way: its rest is the one that it swings about.
void take_nearest_rest(LawFit& fit) {
  constexpr Law everywhere_alike = law_with<Viscous, Drag, Friction>;
  if (fit.law.without(everywhere_alike) != law_with<Pendulum>) return;
  const double turns = two_pi * std::round(fit.motion.position / two_pi);
  if (turns == 0) return;
  fit.motion.position -= turns;
  fit.motion.equilibrium += turns;
  for (const auto& [name, by] : {std::pair{"position", -turns}, std::pair{"equilibrium", turns}})
    if (Estimate* moved = fit.find(name)) moved->value += by, moved->low += by, moved->high += by;
}

}  // namespace

LawFit fit_motion(const Record& record, const LawFitOptions& options, const KnownMotion& known,
                  const Watch& watch, bool roughly) {
  LawFit fit = fit_of_either_zero(record, options, known, watch, roughly);
  if (record.derivative == 0 && options.drive.kind == DriveKind::none && fit.has_values())
    take_nearest_rest(fit);
  return fit;
}

}  // namespace cromer::core
