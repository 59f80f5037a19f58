#include "cromer/identify/diagnose/slip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/identify/least_squares/sampling.h"
#include "cromer/model/law_force.h"

namespace cromer::core {
namespace {

// What is left of a viscous swing may be its own parameters, which the fit has where no time slips, or the
// slip.
class SlipSearch {
 public:
  SlipSearch(const Record& record, const LawFit& straight, std::vector<double> residuals)
      : record_(record), residuals_(std::move(residuals)) {
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
    double slip = 0, rest = HUGE_VAL;
  };

  // Of a slip before one of at most so many samples, spread evenly.
  Found best(std::size_t from, std::size_t to, std::size_t most) const {
    Found found;
    const std::size_t stride = std::max<std::size_t>(1, (to - from) / most);
    for (std::size_t at = from; at < to; at += stride) {
      NormalEquations sums{.size = 6};
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        std::array<double, 6> row = rows_[i];
        if (i < at) row[5] = 0;
        sums.add_row(row, residuals_[i]);
      }
      if (const LinearFit fit = solve(sums); fit.ok && fit.rest < found.rest)
        found = {at, fit.x[5], fit.rest};
    }
    return found;
  }

 private:
  const Record& record_;
  std::vector<double> residuals_;
  std::vector<std::array<double, 6>> rows_;
};

}  // namespace

Notice slipped_times(const Record& record, const LawFit& fit, const Watch& watch) {
  constexpr std::size_t most = 20'000, few = 48;  // samples that are worth the search; places
  const std::size_t n = record.t.size();
  const bool bent = !is_linear(fit.law.without(dissipative_terms));
  constexpr double smooth = 0.2,
                   clearly_less = 0.9;  // correlation from sample to sample; of the rms residual
  if (!bent && !(fit.residual.autocorrelation > smooth)) return {};
  if (fit.drive.kind != DriveKind::none || n < 64 || n > most) return {};
  const LawFit straight = fit_law(record, {}, watch);
  std::vector<double> residuals = residuals_of(straight, record);
  if (!straight.is_usable() || residuals.size() != n || watch.interrupted()) return {};
  const SlipSearch search(record, straight, std::move(residuals));
  const std::size_t edge = n / 10;  // what is odd there may be a beginning
  SlipSearch::Found found = search.best(edge, n - edge, few);
  const std::size_t around = std::max<std::size_t>(1, n / few);
  found = search.best(std::max(edge, found.at - std::min(around, found.at)),
                      std::min(n - edge, found.at + around), few);
  const double rest = std::sqrt(found.rest / static_cast<double>(n));
  const double steps = std::abs(found.slip) / median_step(record.t);
  constexpr double least = 0.5, most_steps = 10;  // between samples
  if (steps < least || steps > most_steps || rest > (bent ? 1 : clearly_less) * fit.residual.rms) return {};
  return Notice{"times_slip",
                {{"t", record.t[found.at]},
                 {"slip", std::abs(found.slip)},
                 {"what", Notice{bent ? "motion_without_a_bent_spring" : "part_of_what_is_left"}}}};
}

}  // namespace cromer::core
