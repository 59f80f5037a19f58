#include "cromer/tasks/fit/decay_rates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>

#include "cromer/base/pi.h"
#include "cromer/identify/least_squares/levenberg_marquardt.h"
#include "cromer/identify/motion/damped_phasor.h"

namespace cromer::core {
namespace {

constexpr double wanted_certainty = 0.05;  // of each rate
constexpr std::size_t most_stretches = 60;
constexpr std::size_t fewest_samples = 12;  // of a stretch
constexpr double beats = 3;                 // in a stretch: what swings along then moves its rate little

/// Of a swing between its turning points, the amplitude of its fundamental over half the way between these:
/// cos(theta) at its times, as Swing::angular_frequency has them.
double share_of_fundamental(const Swing<double>& swing, double amplitude) {
  if (!swing.is_bent()) return 1;
  constexpr int points = 48;  // of half a cycle
  const double c = swing.middle(amplitude);
  std::array<double, points> cosine{}, lasts{};
  for (int i = 0; i < points; ++i) {
    cosine[i] = std::cos((i + 0.5) * pi / points);
    lasts[i] = 1 / swing.turning(c, amplitude, cosine[i]);
  }
  const double half = std::accumulate(lasts.begin(), lasts.end(), 0.0);
  double sum = 0, time = 0;
  for (int i = 0; i < points; ++i) {
    sum += cosine[i] * std::cos(pi * (time + 0.5 * lasts[i]) / half) * lasts[i];
    time += lasts[i];
  }
  const double share = 2 * sum / half;
  return std::isfinite(share) ? share : 1;
}

/// A stretch freed of how the law itself changes rate and frequency in it: one decaying sinusoid where the
/// law is right. The noise stays about as even as it is.
struct Levelled {
  std::vector<double> t;  // [s] as the law's phase goes on, in units of time in the middle
  std::vector<double> y;  ///< about the equilibrium
  double rate = 0;        // [1/s] of the record's amplitude in the middle, by the law
  double end = 0;         ///< the law's amplitude at the end
  double power = 1;       ///< with what power of the displacement's amplitude that of the record goes
};

/// From this amplitude on. Empty where the swing ends within the stretch.
std::optional<Levelled> level(std::span<const double> t, std::span<const double> y, int derivative,
                              const LawFit& fit, double amplitude) {
  constexpr std::size_t nodes = 32;
  constexpr int points = 24;  // of a swing: good to 1e-6 up to 2 rad of a pendulum
  const Swing<double> swing = swing_of(fit);
  const AmplitudeDecay decay = amplitude_decay(fit);
  const double each = (t.back() - t.front()) / nodes, w0 = fit.motion.angular_frequency();
  std::array<double, nodes + 1> A{}, w{}, phase{};
  for (std::size_t i = 0; i <= nodes; ++i) {
    A[i] = amplitude;
    w[i] = swing.is_bent() ? swing.angular_frequency(amplitude, points) : w0;
    if (!std::isfinite(w[i])) w[i] = w0;
    if (i > 0) phase[i] = phase[i - 1] + 0.5 * each * (w[i - 1] + w[i]);
    // Two steps of the averaged law: by the rate in the middle.
    const double half = amplitude * std::exp(-std::min(5.0, 0.5 * each * decay.rate(amplitude)));
    amplitude *= std::exp(-std::min(5.0, each * decay.rate(half)));
  }
  constexpr double gone = 0.1;  // of the amplitude at its beginning: the rest of a stretch is then noise
  const double at_rest = 2 * fit.motion.per_mass.friction / (w0 * w0);  // a half swing before it
  if (!(A.back() > std::max(gone * A.front(), at_rest))) return std::nullopt;
  const double middle = w[nodes / 2], mean = fit.motion.equilibrium;
  // The record sees the fundamental, of which a wide swing has another share.
  double own = 1;  // its power of the amplitude
  Levelled levelled;
  if (swing.is_bent() && A.front() != A.back()) {
    const double fallen = std::log(A.front() / A.back());
    own += std::log(share_of_fundamental(swing, A.front()) / share_of_fundamental(swing, A.back())) / fallen;
    levelled.power = own + derivative * std::log(w.front() / w.back()) / fallen;
  }
  std::array<double, nodes + 1> size{};
  for (std::size_t i = 0; i <= nodes; ++i)
    size[i] = own * std::log(A[i] / A[nodes / 2]) + derivative * std::log(w[i] / middle);
  levelled.end = A.back();
  constexpr double least_power = 0.2;  // below it the record's amplitude hardly tells the displacement's
  if (!(levelled.power > least_power)) return std::nullopt;
  levelled.rate = levelled.power * decay.rate(A[nodes / 2]);
  const double middle_time = t.front() + (swing.is_bent() ? phase[nodes / 2] / middle : each * nodes / 2);
  levelled.t.reserve(t.size());
  levelled.y.reserve(t.size());
  for (std::size_t k = 0; k < t.size(); ++k) {
    const double place = (t[k] - t.front()) / each;
    const std::size_t i = std::min(static_cast<std::size_t>(place), nodes - 1);
    const double share = place - static_cast<double>(i);
    const double within = each * share * (w[i] + 0.5 * share * (w[i + 1] - w[i]));
    levelled.t.push_back(swing.is_bent() ? t.front() + (phase[i] + within) / middle : t[k]);
    const double by_law = size[i] + share * (size[i + 1] - size[i]),
                 evenly = -levelled.rate * (levelled.t.back() - middle_time);
    levelled.y.push_back(mean + (y[k] - mean) * std::exp(evenly - by_law));
  }
  return levelled;
}

/// The length of the stretches. Each error shows how long the next stretch must be, by sd(b) = sqrt(24 h/T^3)
/// sigma/A of a short one.
class StretchLength {
 public:
  StretchLength(const Record& record, double angular_frequency, double beat) {
    const double duration = record.t.back() - record.t.front();
    const double spacing = duration / static_cast<double>(record.t.size() - 1);
    shortest_ = std::max({2 * two_pi / angular_frequency, fewest_samples * spacing,
                          duration / static_cast<double>(most_stretches)});
    longest_ = std::max(duration / 6, shortest_);
    shortest_ = std::max(shortest_, std::min(beats * beat, longest_));
    length_ = std::clamp(duration / 20, shortest_, longest_);
  }

  /// Where the swing dies down at this rate [1/s]: one rate is told of no more than the halving of a swing.
  double length(double rate) const {
    return rate > 0 ? std::clamp(length_, shortest_, std::max(shortest_, std::log(2.0) / rate)) : length_;
  }
  double shortest() const { return shortest_; }

  /// After a stretch whose rate had this error over the wanted one; NaN if it had none.
  void learn(double error_over_wanted) {
    const double change = std::pow(error_over_wanted, 2.0 / 3);
    length_ = std::clamp(length_ * (change >= 0 ? std::clamp(change, 0.5, 2.0) : 2.0), shortest_, longest_);
  }

 private:
  double length_ = 0, shortest_ = 0, longest_ = 0;
};

/// Fits one decaying sinusoid, with a frequency near `w`, which is then set to the fitted one.
std::optional<AmplitudeRate> fit_stretch(const Record& part, double& w, double g) {
  const DampedPhasor model(part);
  const DampedPhasor::Linear linear = model.best_linear(w, g);
  Parameters start{};
  start[DampedPhasor::angular_frequency] = w;
  start[DampedPhasor::decay_rate] = g;
  start[DampedPhasor::equilibrium] = linear.equilibrium;
  start[DampedPhasor::cosine] = linear.cosine;
  start[DampedPhasor::sine] = linear.sine;
  LeastSquaresOptions settings;
  double square = 0;
  for (const double y : part.y) square += (y - linear.equilibrium) * (y - linear.equilibrium);
  settings.scale = std::sqrt(square);
  settings.residuals = static_cast<int>(part.t.size());
  settings.lower[DampedPhasor::angular_frequency] = 0.5 * w;
  settings.error_tolerance = 1e-3;
  const LeastSquaresSummary summary = minimise(model, start, settings);
  if (summary.reason != LeastSquaresReason::converged) return std::nullopt;
  constexpr int n = DampedPhasor::parameter_count;
  const double degrees = static_cast<double>(part.t.size()) - n;
  // From the stretch's own residuals: a law that does not fit the whole record widens nothing here.
  std::vector<double> residuals;
  model.residuals(summary.parameters, residuals);
  const double spacing = (part.t.back() - part.t.front()) / static_cast<double>(part.t.size() - 1);
  const double widening = correlation_factor(residuals, w * spacing);
  const double rounding = part.resolution * part.resolution / 12;
  const double variance = std::max(summary.equations.sum_of_squares / degrees, rounding) * widening;
  const SquareMatrix covariance = inverse(summary.equations.matrix, n);
  const Parameters& p = summary.parameters;
  const double rate = p[DampedPhasor::decay_rate];
  const auto error_of = [&](int i) { return std::sqrt(variance * covariance[i][i]); };
  const double error = error_of(DampedPhasor::decay_rate);
  const double from = part.t.front(), to = part.t.back();
  const double middle = std::exp(-rate * 0.5 * (to - from));
  const double amplitude = std::hypot(p[DampedPhasor::cosine], p[DampedPhasor::sine]) * middle;
  // What the noise alone would show is no swing: one that friction has stopped.
  const double of_noise = std::sqrt(2 * variance / static_cast<double>(part.t.size()));
  if (!std::isfinite(error) || !(amplitude > 4 * of_noise)) return std::nullopt;
  w = p[DampedPhasor::angular_frequency];
  const double t = student_95(std::max(1.0, degrees / widening));
  return AmplitudeRate{.from = from,
                       .to = to,
                       .amplitude = amplitude,
                       .rate = make_estimate(rate, error, t),
                       .angular_frequency = make_estimate(w, error_of(DampedPhasor::angular_frequency), t),
                       .law_rate = 0,
                       .law_angular_frequency = 0};
}

Estimate widened(const Estimate& e, double times) {
  return {e.value, times * e.standard_error, e.value - times * (e.value - e.low),
          e.value + times * (e.high - e.value)};
}

/// That of the displacement, of which the record's amplitude goes with this power.
Estimate of_displacement(const Estimate& rate, double power) {
  return {rate.value / power, rate.standard_error / power, rate.low / power, rate.high / power};
}

/// Adds to the errors what the line, r times as large, moves rate and frequency by: at most r D, D how far
/// apart their frequencies are, and by the weights of a slope over T at most 12 r/(T^2 D); the rms of all
/// phases. The amplitude is in the unit of the record. Times since `begin`.
void widen_beside(const ResidualLine& line, double begin, AmplitudeRate& stretch) {
  const double middle = 0.5 * (stretch.from + stretch.to) - begin, length = stretch.to - stretch.from;
  const double ratio = line.amplitude * std::exp(-line.decay_rate * middle) / stretch.amplitude,
               apart = std::abs(line.angular_frequency - stretch.angular_frequency.value);
  const double moved = ratio * std::min(apart, 12 / (length * length * apart)) / std::sqrt(2.0);
  for (Estimate* each : {&stretch.rate, &stretch.angular_frequency}) {
    const double wider = std::hypot(each->standard_error, moved) / each->standard_error;
    if (std::isfinite(wider)) *each = widened(*each, wider);
  }
}

/// Multiplies the errors of what is measured by the rms of the second differences of (measured - law), in
/// units of their errors and without the largest, where that exceeds 1 by more than chance. Returns by what.
double widen_by_neighbours(std::vector<AmplitudeRate>& stretches, Estimate AmplitudeRate::*measured,
                           double AmplitudeRate::*law) {
  constexpr std::size_t fewest = 8;
  if (stretches.size() < fewest) return 1;
  const auto off = [&](std::size_t i) { return (stretches[i].*measured).value - stretches[i].*law; };
  const auto error = [&](std::size_t i) { return (stretches[i].*measured).standard_error; };
  double sum = 0, largest = 0;
  for (std::size_t i = 1; i + 1 < stretches.size(); ++i) {
    const double each = std::pow(
        (off(i - 1) - 2 * off(i) + off(i + 1)) / std::hypot(error(i - 1), 2 * error(i), error(i + 1)), 2);
    sum += each;
    largest = std::max(largest, each);
  }
  // Of so many squares of normal noise the largest takes its share, and more than one of the mean.
  const double all = static_cast<double>(stretches.size() - 2), count = all - 1, log = std::log(all),
               expected = 2 * log - std::log(log) - std::log(pi) + 2 * std::numbers::egamma;
  const double square = (sum - largest) / (all - expected);
  // The squares of those that share stretches are correlated, by (4/6)^2 and (1/6)^2 of normal noise: their
  // mean has a variance of 2 (1 + 2 (16 + 1)/36) over their number.
  constexpr double variance = 2 * (1 + 2 * 17.0 / 36), surely = 3;
  if (!(square > 1 + surely * std::sqrt(variance / count))) return 1;
  const double times = std::sqrt(square);
  for (AmplitudeRate& each : stretches) each.*measured = widened(each.*measured, times);
  return times;
}

}  // namespace

DecaySegments fit_segments(const Record& record, double period, std::optional<double> length,
                           std::optional<int> count, const Watch& watch) {
  DecaySegments result;
  if ((!length && !count) || record.t.size() < 2) return result;
  const double t0 = record.t.front();
  const double duration = record.t.back() - t0;
  const double step = duration / static_cast<double>(record.t.size() - 1);
  const double each = length ? *length : duration / *count;
  const double shortest_segment = std::max(1.5 * period, 8 * step);
  if (each < shortest_segment) {
    result.notices.push_back(
        length ? Notice{"segment_too_short", {{"length", each}, {"shortest", shortest_segment}}}
               : Notice{"segments_too_short",
                        {{"count", *count}, {"length", each}, {"shortest", shortest_segment}}});
    return result;
  }
  // The last sample stands for one step more: 3000 samples at 100 a second are one segment of 30 s.
  const auto whole = static_cast<long long>((duration + step) / each + 1e-9);
  const long long wanted = count ? std::min<long long>(*count, whole) : whole;
  if (count && wanted < *count)
    result.notices.push_back(Notice{
        "fewer_segments", {{"duration", duration}, {"whole", wanted}, {"count", *count}, {"length", each}}});
  constexpr double to_speak_of = 0.02;  // of the record
  const double rest = duration - static_cast<double>(wanted) * each;
  if (length && wanted > 0 && wanted == whole && rest > to_speak_of * duration)
    result.notices.push_back(Notice{"rest_in_no_segment", {{"rest", rest}, {"length", each}}});
  if (!count && whole == 0)
    result.notices.push_back(Notice{"shorter_than_a_segment", {{"duration", duration}, {"length", each}}});

  const auto index_at = [&](double t) {
    return static_cast<std::size_t>(std::lower_bound(record.t.begin(), record.t.end(), t - 1e-6 * step) -
                                    record.t.begin());
  };
  double sum = 0, variance = 0, student = 0;
  long long left_out = 0;
  double failed_from = 0, failed_to = 0;  // [s] of the first
  Notice why;
  for (long long i = 0; i < wanted; ++i) {
    const double from = t0 + static_cast<double>(i) * each, to = t0 + static_cast<double>(i + 1) * each;
    const std::size_t first = index_at(from),
                      last = i + 1 == wanted && !length ? record.t.size() : index_at(to);
    const Record part{record.t.subspan(first, last - first), record.y.subspan(first, last - first),
                      record.resolution};
    const LawFit fit = fit_law(part, {.may_grow = true}, watch);
    if (watch.interrupted()) {
      result.notices.push_back(Notice{"segments_interrupted", {{"done", i}, {"count", wanted}}});
      break;
    }
    if (fit.status != FitStatus::converged) {
      if (left_out++ == 0) {
        failed_from = from;
        failed_to = to;
        why = fit.message;
      }
      continue;
    }
    result.segments.push_back({from, to, fit.decay_rate()});
    sum += fit.decay_rate().value;
    variance += fit.decay_rate().standard_error * fit.decay_rate().standard_error;
    student = std::max(student, fit.student);
  }
  if (left_out > 0)
    result.notices.push_back(Notice{
        left_out == 1 ? "segment_left_out" : "segments_left_out",
        {{"left_out", left_out}, {"count", wanted}, {"from", failed_from}, {"to", failed_to}, {"why", why}}});
  if (!result.segments.empty()) {
    const auto n = static_cast<double>(result.segments.size());
    result.mean = make_estimate(sum / n, std::sqrt(variance) / n, student);
  }
  return result;
}

const Parameter* named(const std::vector<Parameter>& list, std::string_view name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const Parameter& each) { return each.name == name; });
  return found == list.end() ? nullptr : &*found;
}

bool are_apart(const Estimate& one, const Estimate& other) {
  return one.low > other.high || other.low > one.high;
}

bool is_one_rate(const Estimate& start, const Estimate& end) {
  const double change = std::abs(end.value - start.value), rate = std::abs(start.value);
  return change <= 1e-9 * rate || (!are_apart(start, end) && change < alike_rates * rate);
}

AmplitudeDecay amplitude_decay(const LawFit& fit) {
  return {.angular_frequency = fit.motion.angular_frequency(), .per_mass = fit.motion.per_mass};
}

double law_angular_frequency(const LawFit& fit, double amplitude) {
  const double undamped = swing_of(fit).angular_frequency(amplitude),
               rate = amplitude_decay(fit).rate(amplitude);
  return std::sqrt(std::max(0.0, undamped * undamped - rate * rate));
}

Swing<double> swing_of(const LawFit& fit) { return {fit.motion.per_mass}; }

double first_amplitude(const LawFit& fit) {
  if (fit.law.has<Hysteresis>()) return std::numeric_limits<double>::quiet_NaN();
  return swing_of(fit).amplitude(fit.position().value, fit.velocity().value);
}

std::vector<AmplitudeRate> decay_by_amplitude(const Record& record, const LawFit& fit,
                                              const std::vector<ResidualLine>& lines, const Watch& watch) {
  std::vector<AmplitudeRate> result;
  const AmplitudeDecay decay = amplitude_decay(fit);
  const double amplitude = first_amplitude(fit);
  if (record.t.size() < 24 || !(amplitude > 0) || !std::isfinite(amplitude)) return result;
  // The first stretch starts from the frequency at the first amplitude, at least half of that of small
  // swings; each other one from the stretch before.
  const double lowest = 0.5 * fit.angular_frequency().value,
               there = swing_of(fit).angular_frequency(amplitude);
  double w = there > lowest ? there : lowest;
  double at = amplitude;
  StretchLength stretch(record, w, slowest_beat(lines, fit));
  const auto t = record.t;
  for (std::size_t first = 0; t.back() - t[first] > 0.75 * stretch.shortest() && !watch.interrupted();) {
    // A rest that is too short for a stretch of its own belongs to this one.
    const double length = stretch.length(decay.rate(at)), end = t[first] + length;
    const bool last = t.back() - end < 0.5 * length;
    const auto next =
        last ? t.size() : static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), end) - t.begin());
    const std::size_t n = next - first;
    if (n >= fewest_samples) {
      const std::span<const double> times = t.subspan(first, n);
      const auto levelled = level(times, record.y.subspan(first, n), record.derivative, fit, at);
      if (!levelled) break;
      auto found = fit_stretch({levelled->t, levelled->y, record.resolution}, w, levelled->rate);
      at = levelled->end;
      stretch.learn(found ? found->rate.standard_error / (wanted_certainty * decay.rate(at)) : HUGE_VAL);
      if (found) {
        found->from = times.front();
        found->to = times.back();
        for (const ResidualLine& line : lines) widen_beside(line, t.front(), *found);
        found->rate = of_displacement(found->rate, levelled->power);
        found->amplitude /= std::pow(w, record.derivative);
        found->amplitude /= share_of_fundamental(swing_of(fit), found->amplitude);
        found->law_rate = decay.rate(found->amplitude);
        found->law_angular_frequency = law_angular_frequency(fit, found->amplitude);
        if (found->rate.standard_error < std::max(std::abs(found->rate.value), found->law_rate))
          result.push_back(*found);
      }
    }
    if (last) break;
    first = next;
  }
  const double times = widen_by_neighbours(result, &AmplitudeRate::rate, &AmplitudeRate::law_rate);
  for (AmplitudeRate& each : result) each.widened = times;
  widen_by_neighbours(result, &AmplitudeRate::angular_frequency, &AmplitudeRate::law_angular_frequency);
  return result;
}

bool span_a_decade(const std::vector<AmplitudeRate>& stretches) {
  const auto [smallest, largest] = std::minmax_element(
      stretches.begin(), stretches.end(),
      [](const AmplitudeRate& a, const AmplitudeRate& b) { return a.amplitude < b.amplitude; });
  return smallest != stretches.end() && largest->amplitude > 10 * smallest->amplitude;
}

ExtremeRates extreme_rates(const std::vector<AmplitudeRate>& stretches) {
  const auto [lowest, highest] = std::minmax_element(
      stretches.begin(), stretches.end(),
      [](const AmplitudeRate& a, const AmplitudeRate& b) { return a.rate.value < b.rate.value; });
  return {*lowest, *highest};
}

bool stretches_differ(const std::vector<AmplitudeRate>& stretches, double sign) {
  if (stretches.size() < 2) return false;
  const Estimate &first = stretches.front().rate, &last = stretches.back().rate;
  return sign * (first.value - last.value) > 3 * std::hypot(first.standard_error, last.standard_error);
}

}  // namespace cromer::core
