#include "cromer/identify/diagnose/slip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "cromer/base/pi.h"
#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/identify/least_squares/residual.h"
#include "cromer/identify/least_squares/sampling.h"
#include "cromer/model/law.h"

namespace cromer::core {
namespace {

// What is left of a fit may be its own parameters, which are the fit's where no time slips, or the slip: a
// little more of the motion and of its velocity, and of both times the time, as of a frequency and a decay;
// of a bent spring also of a frequency that follows the square of the amplitude.
class SlipSearch {
  static constexpr int most_terms = 7, of_slip = 5;
  using Row = std::array<double, most_terms>;

 public:
  SlipSearch(const Record& record, const LawFit& fit, std::vector<double> residuals)
      : residuals_(std::move(residuals)) {
    const double w0 = fit.motion.angular_frequency(), g = fit.motion.decay_rate();
    const Trajectory motion = motion_of(fit, record.t);
    // The amplitude must change.
    bends_ = has_bent_spring(fit.law) && g * (record.t.back() - record.t.front()) > 1e-3;
    for (std::size_t i = 0; i < record.t.size(); ++i) {
      const double s = record.t[i] - record.t.front(), x = motion.x[i], v = motion.v[i];
      // Later times show what was due a slip before: minus the derivative of what is seen.
      const double earlier = record.derivative == 0   ? -v
                             : record.derivative == 1 ? w0 * w0 * x + 2 * g * v
                                                      : w0 * w0 * v - 2 * g * (w0 * w0 * x + 2 * g * v);
      const double bends = bends_ ? -std::expm1(-2 * g * s) * earlier / w0 : 0;
      rows_.push_back({1, x, v / w0, s * x, s * v / w0, earlier, bends});
    }
    sums_.size = terms();
    for (std::size_t i = 0; i < rows_.size(); ++i) sums_.add_row(rows_[i], residuals_[i]);
    later_.resize(rows_.size() + 1);
    for (std::size_t i = rows_.size(); i-- > 0;) {
      const double slips = rows_[i][of_slip];
      for (int j = 0; j < most_terms; ++j) later_[i].row[j] = later_[i + 1].row[j] + slips * rows_[i][j];
      later_[i].right = later_[i + 1].right + slips * residuals_[i];
    }
  }

  struct Found {
    std::size_t at = 0;
    double rest = HUGE_VAL;
    Parameters x{};  // one for each entry of row_of()

    double slip() const { return x[of_slip]; }
  };

  // What a slip leaves.
  std::vector<double> left_by(const Found& found) const {
    std::vector<double> left = residuals_;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const Row row = row_of(i, found.at);
      for (int j = 0; j < terms(); ++j) left[i] -= found.x[j] * row[j];
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
    NormalEquations sums = sums_;
    for (int j = 0; j < most_terms; ++j)
      sums.matrix[j][of_slip] = sums.matrix[of_slip][j] = later_[at].row[j];
    sums.right[of_slip] = later_[at].right;
    const LinearFit fit = solve(sums);
    return fit.ok ? Found{at, fit.rest, fit.x} : Found{at};
  }

 private:
  int terms() const { return bends_ ? most_terms : most_terms - 1; }

  Row row_of(std::size_t i, std::size_t slips_at) const {
    Row row = rows_[i];
    if (i < slips_at) row[of_slip] = 0;
    return row;
  }

  // Products with the slip's entry, which is 0 before it: summed from a sample to the last one.
  struct Later {
    Row row{};
    double right = 0;
  };

  std::vector<double> residuals_;
  std::vector<Row> rows_;
  std::vector<Later> later_;
  NormalEquations sums_{};  // of a slip before the first sample
  bool bends_ = false;
};

// The first sample after the slip: where the motion before it and the one after it, fitted to the times
// without it, leave least. Looked for among the samples beside it.
double place_of(const TimeSlip& slip, const Record& record, const LawFit& fit) {
  constexpr std::ptrdiff_t beside = 12;  // the search is right to a few samples
  const auto begin = record.t.begin();
  const std::ptrdiff_t n = record.t.end() - begin,
                       at = std::lower_bound(begin, record.t.end(), slip.at) - begin,
                       from = std::max<std::ptrdiff_t>(beside, at - beside), to = std::min(n, at + beside);
  // The motion begins at the first sample.
  const auto left = [&](double late) {
    std::vector<double> t{record.t.front()}, y{record.y.front()};
    for (std::ptrdiff_t i = from; i < to; ++i) {
      t.push_back(begin[i] - late);
      y.push_back(record.y[static_cast<std::size_t>(i)]);
    }
    Record part = record;
    part.t = t;
    part.y = y;
    std::vector<double> residuals = residuals_of(fit, part);
    if (!residuals.empty()) residuals.erase(residuals.begin());
    return residuals;
  };
  const std::vector<double> before = left(0), after = left(slip.by);
  if (before.empty() || before.size() != after.size()) return slip.at;
  double rest = 0, least = 0;
  std::ptrdiff_t best = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {  // all after it; then one more before it each time
    rest += before[i] * before[i] - after[i] * after[i];
    if (rest < least) {
      least = rest;
      best = static_cast<std::ptrdiff_t>(i) + 1;
    }
  }
  return record.t[static_cast<std::size_t>(std::min(n - 1, from + best))];
}

// The law with a linear spring in place of all that restores it.
Law with_straight_spring(Law law) {
  return Law{law.terms & dampings.with(law_with<Friction>).terms}.with(law_with<Spring>);
}

// The place and size that leave least of a fit, not at an end of the record: what is odd there may be a
// beginning or an end.
struct SlipCandidate {
  Law law;
  double rms = 0;  ///< of the fit's residuals
  SlipSearch search;
  SlipSearch::Found found{};

  double rest() const { return found.rest; }
};

std::optional<SlipCandidate> candidate_of(const Record& record, const LawFit& fit) {
  const std::size_t n = record.t.size();
  std::vector<double> residuals = residuals_of(fit, record);
  if (residuals.size() != n) return std::nullopt;
  SlipCandidate candidate{fit.law, fit.residual.rms, SlipSearch(record, fit, std::move(residuals))};
  constexpr std::size_t places = 48;
  const std::size_t edge = n / 20, around = std::max<std::size_t>(1, n / places);
  candidate.found = candidate.search.best(edge, n - edge, places);
  const std::size_t at = candidate.found.at, from = std::max(edge, at - std::min(around, at)),
                    to = std::min(n - edge, at + around);
  candidate.found = candidate.search.best(from, to, places);
  const std::size_t stride = std::max<std::size_t>(1, (to - from) / places);
  if (candidate.found.at < edge + stride || candidate.found.at + stride >= n - edge) return std::nullopt;
  return candidate;
}

}  // namespace

Notice TimeSlip::notice() const {
  const bool twice = by > 0;
  return Notice{"times_slip",
                {{"t", at},
                 {"slip", std::abs(by)},
                 {"how", Notice{twice ? "samples_repeated" : "samples_lost"}},
                 {"shift", Notice{twice ? "shifted_earlier" : "shifted_later"}}}};
}

Notice TimeSlip::notice_when_removed(const LawFit& as_recorded) const {
  Notice taken = notice();
  taken.code = "slip_taken_out";
  taken.values.push_back({"law", to_text(as_recorded.law)});
  taken.values.push_back({"frequency", as_recorded.swing_frequency().value / two_pi});
  return taken;
}

TimeSlip slip_under(const Law& law, TimeSlip slip, const Record& record, const Watch& watch) {
  constexpr int most_rounds = 4;
  for (int round = 0; round < most_rounds && !watch.interrupted(); ++round) {
    std::vector<double> t(record.t.begin(), record.t.end()), y(record.y.begin(), record.y.end());
    const std::size_t first = remove_slip(slip, t, y);
    Record without = record;
    without.t = t;
    without.y = y;
    const LawFit fit = fit_law(without, {.law = law}, watch);
    std::vector<double> residuals = residuals_of(fit, without);
    if (!fit.is_usable() || residuals.size() != t.size()) break;
    const SlipSearch::Found found = SlipSearch(without, fit, std::move(residuals)).before(first);
    const double rest = found.slip();
    if (!std::isfinite(rest) || !std::isfinite(found.rest)) break;
    slip.by += rest;
    constexpr double small = 0.01;  // of the time between samples
    if (std::abs(rest) > small * median_step(record.t)) continue;
    slip.at = place_of(slip, record, fit);
    break;
  }
  return slip;
}

bool is_sudden(double slips_at, const Record& record, const LawFit& fit) {
  constexpr double as_good = 1.7;  // of an rms residual of few samples, by chance
  constexpr std::size_t fewest = 8;
  const double half = 0.5 * two_pi / fit.motion.angular_frequency();
  const std::vector<double> residuals = residuals_of(fit, record);
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i)
    if (std::abs(record.t[i] - slips_at) < half) {
      squares += residuals[i] * residuals[i];
      ++count;
    }
  return count < fewest || std::sqrt(squares / static_cast<double>(count)) <= as_good * fit.residual.rms;
}

std::optional<TimeSlip> find_slip(const Record& record, const LawFit& fit, std::span<const LawFit> others,
                                  const Watch& watch) {
  constexpr std::size_t longest = 20'000;  // samples that are worth the search
  constexpr double smooth = 0.2;           // of the residuals, from sample to sample: else they are noise
  const std::size_t n = record.t.size();
  const bool turns = fit.law.has<Pendulum>(), bent = turns || has_bent_spring(fit.law);
  const bool is_noise = !(fit.residual.autocorrelation > smooth);
  if (fit.drive.kind != DriveKind::none || n < 64 || n > longest) return std::nullopt;
  const LawFit straight = fit_law(record, {}, watch);
  if (!straight.is_usable() || watch.interrupted()) return std::nullopt;
  // A bent spring may be no more than the slip, and other terms be right beside it.
  std::optional<SlipCandidate> candidate = candidate_of(record, straight);
  const Law plain = with_straight_spring(fit.law);
  const auto other = std::find_if(others.begin(), others.end(), [&](const LawFit& each) {
    return each.law == plain && each.is_usable() && !(plain == straight.law);
  });
  if (other != others.end())
    if (auto found = candidate_of(record, *other); found && (!candidate || found->rest() < candidate->rest()))
      candidate = std::move(found);
  constexpr double fewest = 0.5, most = 10, farthest = 0.7;  // between samples; [rad] where a slip is linear
  constexpr double by_chance = 30, likelier = 10;            // over all places; than one other law
  constexpr double clearly = 0.9;  // of the rms residual, where a wrong law may leave it
  const auto rms = [&](const SlipCandidate& each) { return std::sqrt(each.rest() / static_cast<double>(n)); };
  // Twice the logarithm of how much likelier a slip is than another law. Noise that wanders is part slip by
  // chance: as many samples count as are independent.
  const auto evidence = [&](const SlipCandidate& each, double other) {
    const std::vector<double> left = each.search.left_by(each.found);
    const double correlation = std::clamp(autocorrelations(left, find_grid(record.t), 1)[1], 0.0, 0.999);
    return static_cast<double>(n) * (1 - correlation) / (1 + correlation) * 2 * std::log(other / rms(each));
  };
  const auto is_likely = [&](const std::optional<SlipCandidate>& each) {
    if (!each) return false;
    const double steps = std::abs(each->found.slip()) / median_step(record.t),
                 angle = std::abs(each->found.slip()) * straight.motion.angular_frequency();
    return steps >= fewest && steps <= most && angle <= farthest && evidence(*each, each->rms) >= by_chance;
  };
  const auto is_clear = [&](const SlipCandidate& each, const LawFit& other) {
    return is_noise ? evidence(each, other.residual.rms) >= likelier
                    : rms(each) <= clearly * other.residual.rms;
  };
  const auto slip_of = [&](const SlipCandidate& each) {
    return slip_under(each.law, {record.t[each.found.at], each.found.slip()}, record, watch);
  };
  const bool may_be_straight = is_likely(candidate) && (bent && !turns ? rms(*candidate) <= fit.residual.rms
                                                                       : is_clear(*candidate, fit));
  if (may_be_straight && bent) return slip_of(*candidate);
  if (!may_be_straight && (is_noise || turns)) return std::nullopt;
  const LawFit softening = fit_law(record, {.law = law_of("viscous+cubic")}, watch);
  if (!softening.is_usable() || watch.interrupted()) return std::nullopt;
  // A phase that bends, as a nonlinear spring makes it, is half explained by one that jumps.
  if (may_be_straight && is_clear(*candidate, softening)) return slip_of(*candidate);
  if (is_noise || turns) return std::nullopt;
  // Both: a phase that bends, and jumps.
  candidate = candidate_of(record, softening);
  if (!is_likely(candidate) || !is_clear(*candidate, fit) || !is_clear(*candidate, softening))
    return std::nullopt;
  return slip_of(*candidate);
}

}  // namespace cromer::core
