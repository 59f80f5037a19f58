#include "cromer/identify/modal/modal_analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "cromer/base/pi.h"
#include "cromer/base/quantile.h"
#include "cromer/identify/modal/ambient_modes.h"
#include "cromer/identify/modal/free_decay.h"
#include "cromer/identify/modal/mode_search.h"
#include "cromer/identify/modal/steady_lines.h"
#include "cromer/identify/modal/still_beginning.h"

namespace cromer::core {
namespace {

// Start values of a free decay: each group's pole at the lowest order at which all have appeared.
Eigenvalues eigenvalues_of_groups(const ModeSearch& search, const ModalSettings& settings) {
  const Stabilisation& all = search.stable;
  auto groups = all.groups;
  std::stable_sort(groups.begin(), groups.end(),
                   [&](const auto& a, const auto& b) { return all.orders(a) > all.orders(b); });
  const std::size_t most = settings.modes > 0
                               ? std::min(most_decaying_modes, static_cast<std::size_t>(settings.modes))
                               : most_decaying_modes;
  groups.resize(std::min(groups.size(), most));
  const int together = all.first_common_order(groups);
  Eigenvalues result;
  for (const auto& group : groups) {
    std::size_t chosen = group.back();
    for (const std::size_t i : group)
      if (all.poles[i].order >= together) {
        chosen = i;
        break;
      }
    const StabilityPole& pole = all.poles[chosen];
    result.push_back(std::log(all.model(pole.order).values(pole.index)) / search.correlations.step);
  }
  return result;
}

// Of motion that grows the correlations show a decay as fast: each eigenvalue gets the sign that accounts for
// more of the motion.
void choose_signs(const ModalRecord& record, Eigenvalues& eigenvalues) {
  const Eigen::MatrixXd values = values_of(record);
  const auto left = [&](const std::complex<double>& value) {
    return DecayBasis(record, values, {value}).residuals().squaredNorm();
  };
  for (std::complex<double>& each : eigenvalues)
    if (left(-std::conj(each)) < left(each)) each = -std::conj(each);
}

double decaying_share(const ModalRecord& record, const Eigenvalues& eigenvalues) {
  const Eigen::MatrixXd values = values_of(record);
  return power_about(DecayBasis(record, values, eigenvalues), values, record, eigenvalues).share();
}

// Where steady oscillations may be [rad/s]: poles that hardly decay over the record, and peaks that stand out
// without a pole.
std::vector<double> candidates_for_lines(const ModalRecord& record, const ModeSearch& search,
                                         const std::vector<SpectralPeak>& peaks,
                                         const ModalSettings& settings) {
  constexpr double lifetimes = 3, stands_out = 20, near = 0.02;
  const double duration = static_cast<double>(record.samples()) * record.step;
  std::vector<double> result;
  for (const auto& group : search.stable.groups)
    for (const std::size_t i : group) {
      const StabilityPole& pole = search.stable.poles[i];
      if (std::abs(pole.damping_ratio) * two_pi * pole.frequency * duration > lifetimes) continue;
      result.push_back(two_pi * pole.frequency);
      break;
    }
  for (const SpectralPeak& peak : peaks) {
    if (peak.prominence < stands_out || peak.frequency < settings.from || peak.frequency > settings.to)
      continue;
    const bool has_pole =
        std::any_of(search.stable.groups.begin(), search.stable.groups.end(), [&](const auto& group) {
          return std::abs(search.stable.poles[group.front()].frequency - peak.frequency) <
                 near * peak.frequency;
        });
    if (!has_pole) result.push_back(two_pi * peak.frequency);
  }
  return result;
}

// The record's times with other values.
ModalRecord with_channels(const ModalRecord& record, const std::vector<std::vector<double>>& channels) {
  ModalRecord result = record;
  result.channels.assign(channels.begin(), channels.end());
  return result;
}

// Forces that act at random make a motion within a few lifetimes that a free one follows nearly.
bool follows(const FreeDecay& decay) {
  constexpr double most = 0.9, few_lifetimes = 3, hardly_anything = 0.015;
  if (decay.modes.empty() || decay.share < most) return false;
  const bool dies_away = std::all_of(decay.modes.begin(), decay.modes.end(), [](const MeasuredMode& mode) {
    return std::abs(mode.lifetimes) > few_lifetimes;
  });
  return dies_away || decay.unexplained < hardly_anything;
}

ModalAnalysis modes_of_motion(const ModalRecord& record, const ModalSettings& settings) {
  ModalAnalysis result;
  const auto straightened = without_oscillations(record, {});
  const BridgedRecord bridged(with_channels(record, straightened));
  const ModalRecord& straight = bridged.record();
  result.spectrum = spectral_matrix(straight);
  result.peaks = spectral_peaks(result.spectrum);
  auto search = search_modes(straight, result.peaks, settings);
  if (!search) return result;
  result.highest_order = search->highest_order;
  result.lags = search->correlations.lags;
  result.lag_step = search->correlations.step;
  result.poles = search->stable.poles;

  const Eigenvalues lines =
      steady_lines(straight, candidates_for_lines(straight, *search, result.peaks, settings),
                   two_pi * result.spectrum.step);
  std::vector<std::vector<double>> without_lines;
  ModalRecord rest = with_channels(record, straightened);
  if (!lines.empty()) {
    without_lines = without_oscillations(record, lines);
    rest = with_channels(record, without_lines);
    const BridgedRecord even(rest);
    search = search_modes(even.record(), spectral_peaks(spectral_matrix(even.record())), settings);
  }

  Eigenvalues start = search ? eigenvalues_of_groups(*search, settings) : Eigenvalues{};
  choose_signs(rest, start);
  const auto is_free = [&](Eigenvalues eigenvalues) {
    eigenvalues.resize(std::min(eigenvalues.size(), most_decaying_modes));
    FreeDecay decay = fit_free_decay(record, eigenvalues);
    result.decaying_share = decay.share;
    if (!decay.converged || !follows(decay)) return false;
    result.motion = ModalMotion::free_decay;
    result.modes = std::move(decay.modes);
    // Averages are for random forces: one long segment tells more modes apart.
    result.spectrum = spectral_matrix(straight, 1);
    result.peaks = spectral_peaks(result.spectrum);
    return true;
  };
  constexpr double worth_fitting = 0.5;
  if (!start.empty() && decaying_share(rest, start) > worth_fitting) {
    Eigenvalues all = lines;
    all.insert(all.end(), start.begin(), start.end());
    if (is_free(std::move(all))) return result;
  }
  if (search)
    result.modes = ambient_modes(*search, settings, static_cast<double>(record.samples()) * record.step);
  // Nothing but steady oscillations is a motion without damping.
  if (result.modes.empty() && !lines.empty() && is_free(lines)) return result;
  for (const std::complex<double>& line : lines) result.lines.push_back(line.imag() / two_pi);
  std::sort(result.lines.begin(), result.lines.end());
  return result;
}

// Where a motion dies down to rest within the record: the samples up to there, else all. A long rest after
// it looks like the work of random forces.
std::size_t lively_samples(const ModalRecord& record) {
  constexpr std::size_t windows = 60, quarter = windows / 4;
  constexpr double rest = 0.02, above_rest = 3, steady = 2, nothing = 1e-4;  // of the liveliest window
  const std::size_t n = record.samples(), length = n / windows;
  if (length < 4) return n;
  std::vector<double> level(windows, 0);
  for (const std::span<const double> channel : record.channels) {
    double mean = 0, largest = 0;
    const std::span<const double> end = channel.last(quarter * length);
    for (const double y : end) mean += y / static_cast<double>(end.size());
    std::vector<double> norms;
    for (std::size_t w = 0; w < windows; ++w) {
      double squares = 0;
      for (const double y : channel.subspan(w * length, length)) squares += (y - mean) * (y - mean);
      norms.push_back(std::sqrt(squares));
      largest = std::max(largest, norms.back());
    }
    for (std::size_t w = 0; largest > 0 && w < windows; ++w)
      level[w] = std::max(level[w], norms[w] / largest);
  }
  std::vector<double> last(level.end() - quarter, level.end());
  const double tail = upper_median(last);
  const double most = *std::max_element(last.begin(), last.end());
  if (tail > rest || most > std::max(steady * tail, nothing)) return n;
  std::size_t end = windows - quarter;
  while (end > 0 && level[end - 1] < std::max(above_rest * tail, nothing)) --end;
  const std::size_t lively = end * length;
  return end == windows - quarter || lively < fewest_modal_samples ? n : lively;
}

ModalRecord until_sample(const ModalRecord& record, std::size_t end) {
  ModalRecord part = record;
  for (std::span<const double>& channel : part.channels) channel = channel.first(end);
  std::erase_if(part.starts, [&](std::size_t start) { return start >= end; });
  for (std::vector<double>* each : {&part.times, &part.measured})
    if (!each->empty()) each->resize(end);
  return part;
}

ModalAnalysis modes_of_lively_part(const ModalRecord& record, const ModalSettings& settings) {
  if (const std::size_t lively = lively_samples(record); lively < record.samples()) {
    ModalAnalysis result = modes_of_motion(until_sample(record, lively), settings);
    result.resting = record.samples() - lively;
    if (result.motion == ModalMotion::free_decay) return result;
  }
  return modes_of_motion(record, settings);
}

// A free motion of which nothing grows, as nothing does of what is let go; under random forces something may
// for a while.
bool is_let_go(const ModalAnalysis& found) {
  return found.motion == ModalMotion::free_decay &&
         std::none_of(found.modes.begin(), found.modes.end(),
                      [](const MeasuredMode& mode) { return mode.damping_ratio.high < 0; });
}

ModalAnalysis after_still_beginning(const ModalRecord& record, const ModalSettings& settings) {
  if (const std::size_t still = settings.from_first_sample ? 0 : still_samples(record); still > 0) {
    ModalAnalysis result = modes_of_lively_part(from_sample(record, still), settings);
    if (is_let_go(result) && is_still_before(record, still, result.modes)) {
      result.still = still;
      if (const std::size_t released = samples_of_release(from_sample(record, still), result.modes)) {
        ModalAnalysis after = modes_of_lively_part(from_sample(record, still + released), settings);
        if (is_let_go(after)) {
          after.still = still + released;
          after.released = released;
          return after;
        }
      }
      return result;
    }
  }
  return modes_of_lively_part(record, settings);
}

// Whether the last quarter of some channel moves less than the half before: forces that last do not let it.
bool dies_down(const ModalRecord& record) {
  constexpr double less = 0.85;
  const std::size_t quarter = record.samples() / 4;
  const auto deviation = [](std::span<const double> values) {
    const Eigen::Map<const Eigen::ArrayXd> all(values.data(), static_cast<Eigen::Index>(values.size()));
    return std::sqrt((all - all.mean()).square().mean());
  };
  return std::any_of(record.channels.begin(), record.channels.end(), [&](std::span<const double> channel) {
    return deviation(channel.last(quarter)) < less * deviation(channel.subspan(quarter, 2 * quarter));
  });
}

// Where a hand moves it at first, the modes are those of the free motion after it.
ModalAnalysis after_hold(const ModalRecord& record, const ModalSettings& settings) {
  ModalAnalysis whole = after_still_beginning(record, settings);
  const std::size_t half = record.samples() / 2;
  if (settings.from_first_sample || whole.still > 0 || half < fewest_modal_samples || !dies_down(record))
    return whole;
  const ModalAnalysis later = modes_of_lively_part(from_sample(record, half), settings);
  if (!is_let_go(later)) return whole;
  const std::size_t held = samples_of_hold(record, half, later.modes);
  if (held == 0) return whole;
  ModalAnalysis after = modes_of_lively_part(from_sample(record, held), settings);
  if (!is_let_go(after)) return whole;
  // What the later half no longer shows may have died down since, as a part of the whole.
  if (whole.motion == ModalMotion::free_decay && !is_spoilt_by(record, held, whole.modes, after.modes))
    return whole;
  after.still = after.released = held;
  return after;
}

// Of a free motion all modes are fitted together, and these are told: those in the band, and of them so many
// of most power.
void keep_asked_for(ModalAnalysis& found, const ModalRecord& record, const ModalSettings& settings) {
  std::erase_if(found.modes, [&](const MeasuredMode& mode) {
    return mode.frequency.value < settings.from || mode.frequency.value > settings.to;
  });
  const auto most = settings.modes > 0 ? static_cast<std::size_t>(settings.modes) : found.modes.size();
  const ModalRecord part =
      until_sample(from_sample(record, found.still), record.samples() - found.still - found.resting);
  if (found.modes.size() <= most) return;
  const Eigen::MatrixXd values = values_of(part);
  const Eigen::VectorXd sizes = DecayBasis(part, values, {}).residuals().colwise().norm();
  const Eigen::MatrixXd scaled = values * sizes.cwiseInverse().asDiagonal();
  while (found.modes.size() > most) {
    Eigenvalues eigenvalues;
    for (const MeasuredMode& mode : found.modes) eigenvalues.push_back(mode.eigenvalue);
    found.modes.erase(found.modes.begin() + DecayBasis(part, scaled, eigenvalues).weakest_mode());
  }
}

}  // namespace

ModalAnalysis find_modes(const ModalRecord& record, const ModalSettings& settings) {
  ModalSettings all = settings;
  all.from = 0, all.to = std::numeric_limits<double>::infinity(), all.modes = 0;
  ModalAnalysis found = after_hold(record, all);
  const bool limited = settings.from > 0 || std::isfinite(settings.to) || settings.modes > 0;
  if (limited && found.motion != ModalMotion::free_decay) return after_hold(record, settings);
  if (limited) keep_asked_for(found, record, settings);
  return found;
}

}  // namespace cromer::core
