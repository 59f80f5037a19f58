#include "cromer/identify/diagnose/slip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/identify/least_squares/residual.h"
#include "cromer/identify/least_squares/sampling.h"
#include "cromer/model/law.h"

namespace cromer::core {
namespace {

// What is left of a viscous swing may be its own parameters, which the fit has where no time slips, or the
// slip.
class SlipSearch {
 public:
  SlipSearch(const Record& record, const LawFit& straight, std::vector<double> residuals)
      : residuals_(std::move(residuals)) {
    const double w0 = straight.motion.angular_frequency(), g = straight.motion.decay_rate();
    const double w = std::sqrt(std::max(0.0, w0 * w0 - g * g));
    const Trajectory motion = motion_of(straight, record.t);
    for (std::size_t i = 0; i < record.t.size(); ++i) {
      const double s = record.t[i] - record.t.front(), decay = std::exp(-g * s),
                   cosine = decay * std::cos(w * s), sine = decay * std::sin(w * s);
      const double x = motion.x[i], v = motion.v[i];
      // Later times show what was due a slip before: minus the derivative of what is seen.
      const double earlier = record.derivative == 0   ? -v
                             : record.derivative == 1 ? w0 * w0 * x + 2 * g * v
                                                      : w0 * w0 * v - 2 * g * (w0 * w0 * x + 2 * g * v);
      rows_.push_back({1, cosine, sine, s * cosine, s * sine, earlier});
    }
  }

  struct Found {
    std::size_t at = 0;
    double rest = HUGE_VAL;
    Parameters x{};  // one for each entry of row_of(); the last is the slip [s]

    double slip() const { return x[5]; }
  };

  // What a slip leaves.
  std::vector<double> left_by(const Found& found) const {
    std::vector<double> left = residuals_;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const std::array<double, 6> row = row_of(i, found.at);
      for (std::size_t j = 0; j < row.size(); ++j) left[i] -= found.x[j] * row[j];
    }
    return left;
  }

  // Of a slip before one of at most so many samples, spread evenly.
  Found best(std::size_t from, std::size_t to, std::size_t most) const {
    Found found;
    const std::size_t stride = std::max<std::size_t>(1, (to - from) / most);
    for (std::size_t at = from; at < to; at += stride)
      if (const Found here = before(at); here.rest < found.rest) found = here;
    return found;
  }

  // Of a slip before this sample.
  Found before(std::size_t at) const {
    NormalEquations sums{.size = 6};
    for (std::size_t i = 0; i < rows_.size(); ++i) sums.add_row(row_of(i, at), residuals_[i]);
    const LinearFit fit = solve(sums);
    return fit.ok ? Found{at, fit.rest, fit.x} : Found{at};
  }

 private:
  std::array<double, 6> row_of(std::size_t i, std::size_t slips_at) const {
    std::array<double, 6> row = rows_[i];
    if (i < slips_at) row[5] = 0;
    return row;
  }

  std::vector<double> residuals_;
  std::vector<std::array<double, 6>> rows_;
};

// The slip as a viscous swing shows it whose times have it no longer: the search takes it as small.
TimeSlip remeasured(TimeSlip slip, const Record& record, const Watch& watch) {
  constexpr int most_rounds = 4;
  for (int round = 0; round < most_rounds && !watch.interrupted(); ++round) {
    std::vector<double> t(record.t.begin(), record.t.end()), y(record.y.begin(), record.y.end());
    const SamplesToldTwice twice = take_out(slip, t);
    for (auto* values : {&t, &y})
      values->erase(values->begin() + static_cast<std::ptrdiff_t>(twice.from),
                    values->begin() + static_cast<std::ptrdiff_t>(twice.to));
    Record without = record;
    without.t = t;
    without.y = y;
    const LawFit fit = fit_law(without, {}, watch);
    std::vector<double> residuals = residuals_of(fit, without);
    if (!fit.is_usable() || residuals.size() != t.size()) break;
    const double rest = SlipSearch(without, fit, std::move(residuals)).before(twice.from).slip();
    if (!std::isfinite(rest)) break;
    slip.by += rest;
    constexpr double small = 0.01;  // of the time between samples
    if (std::abs(rest) < small * median_step(record.t)) break;
  }
  return slip;
}

}  // namespace

Notice TimeSlip::notice(const char* code) const {
  const bool twice = by > 0;
  return Notice{code,
                {{"t", at},
                 {"slip", std::abs(by)},
                 {"how", Notice{twice ? "samples_repeated" : "samples_lost"}},
                 {"shift", Notice{twice ? "shifted_earlier" : "shifted_later"}}}};
}

SamplesToldTwice take_out(const TimeSlip& slip, std::vector<double>& t) {
  const auto first = std::lower_bound(t.begin(), t.end(), slip.at);
  if (first == t.end()) return {};
  const double begins = *first - slip.by;
  const auto twice = std::lower_bound(t.begin(), first, begins);
  std::for_each(first, t.end(), [&](double& each) { each -= slip.by; });
  return {static_cast<std::size_t>(twice - t.begin()), static_cast<std::size_t>(first - t.begin())};
}

std::optional<TimeSlip> find_slip(const Record& record, const LawFit& fit, const Watch& watch) {
  constexpr std::size_t longest = 20'000;  // samples that are worth the search
  constexpr double smooth = 0.2;           // of the residuals, from sample to sample: else they are noise
  const std::size_t n = record.t.size();
  const bool turns = fit.law.has<Pendulum>(), bent = turns || has_bent_spring(fit.law);
  if (!bent && !(fit.residual.autocorrelation > smooth)) return std::nullopt;
  if (fit.drive.kind != DriveKind::none || n < 64 || n > longest) return std::nullopt;
  const LawFit straight = fit_law(record, {}, watch);
  std::vector<double> residuals = residuals_of(straight, record);
  if (!straight.is_usable() || residuals.size() != n || watch.interrupted()) return std::nullopt;

  const SlipSearch search(record, straight, std::move(residuals));
  constexpr std::size_t places = 48;
  const std::size_t edge = n / 10;  // what is odd there may be a beginning or an end
  SlipSearch::Found found = search.best(edge, n - edge, places);
  const std::size_t around = std::max<std::size_t>(1, n / places);
  found = search.best(std::max(edge, found.at - std::min(around, found.at)),
                      std::min(n - edge, found.at + around), places);
  const double steps = std::abs(found.slip()) / median_step(record.t),
               angle = std::abs(found.slip()) * straight.motion.angular_frequency();
  constexpr double fewest = 0.5, most = 10, farthest = 0.7;  // between samples; [rad] where a slip is linear
  if (steps < fewest || steps > most || angle > farthest) return std::nullopt;

  const double rest = std::sqrt(found.rest / static_cast<double>(n));
  constexpr double clearly = 0.9;  // of the rms residual
  if (rest > (bent && !turns ? 1 : clearly) * fit.residual.rms) return std::nullopt;
  // Noise that wanders is part slip by chance: as many samples count as are independent.
  const std::vector<double> left = search.left_by(found);
  const double correlation = std::clamp(autocorrelations(left, find_grid(record.t), 1)[1], 0.0, 0.999);
  const double independent = static_cast<double>(n) * (1 - correlation) / (1 + correlation);
  constexpr double by_chance = 30;  // of twice the logarithm of the likelihood, over all places
  if (independent * 2 * std::log(straight.residual.rms / rest) < by_chance) return std::nullopt;
  // A phase that bends, as a nonlinear spring makes it, is half explained by one that jumps.
  if (!bent) {
    const LawFit softening = fit_law(record, {.law = law_of("viscous+cubic")}, watch);
    if (!softening.is_usable() || rest > clearly * softening.residual.rms) return std::nullopt;
  }
  return remeasured({record.t[found.at], found.slip()}, record, watch);
}

}  // namespace cromer::core
