// Times that slip: samples that a recorder lost, or told twice, while its times went on evenly.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "cromer/base/for_page.h"
#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// The page looks for no slips.
inline constexpr bool looks_for_slips = !for_page;

struct TimeSlip {
  double at = 0;  // [s] the first sample that is late
  double by = 0;  // [s] by so much; negative where it is early, for samples that were lost

  /// A notice of when and by how much the times slip.
  Notice notice() const;
  /// The same where the slip was removed; `as_recorded` is the fit of the times with it.
  Notice notice_when_removed(const LawFit& as_recorded) const;
};

/// Whether it tells of a slip that is still in the times.
inline bool is_of_slips(const Notice& notice) { return notice.code == "times_slip"; }

/// A law with a straight spring, the viscous one or that of `fit` without its nonlinear spring where it is
/// among `others`, whose times slip once: it leaves no more than `fit` with its nonlinear spring, or clearly
/// less than `fit` of a pendulum, or without either, and than a cubic spring. Else,
/// where the residuals are no noise and the law is no pendulum, viscous damping and a cubic spring with one
/// slip, which leave clearly less than both `fit` and the same without a slip.
/// Slips from half a step between samples to ten are found, of less than a ninth of a period, not in the
/// first or the last twentieth of the record. A phase that jumps once looks like a frequency that changes as
/// the swing dies down. Empty where nothing slips, and of more than 20,000 samples.
std::optional<TimeSlip> find_slip(const Record& record, const LawFit& fit,
                                  std::span<const LawFit> others = {}, const Watch& watch = {});

/// The same slip where a law shows it, which is fitted to the times without it; `record` still has it.
TimeSlip slip_under(const Law& law, TimeSlip slip, const Record& record, const Watch& watch = {});

/// Whether a fit of the times without the slip is as good beside it, within half a period, as elsewhere: what
/// slides for a while leaves more there. `record` has those times; fewer than eight samples there show
/// nothing.
bool is_sudden(double slips_at, const Record& record, const LawFit& fit);

/// Shifts the times after the slip back, and erases the samples before it whose times the shifted ones
/// repeat, also from `beside`. The number of the first sample after the slip.
template <class... Beside>
std::size_t remove_slip(const TimeSlip& slip, std::vector<double>& t, Beside&... beside) {
  const std::size_t n = t.size();
  const auto first = std::lower_bound(t.begin(), t.end(), slip.at);
  if (first == t.end()) return n;
  const auto repeated = std::lower_bound(t.begin(), first, *first - slip.by);
  std::for_each(first, t.end(), [&](double& each) { each -= slip.by; });
  const std::ptrdiff_t from = repeated - t.begin(), to = first - t.begin();
  const auto erase = [&](auto& values) {
    if (values.size() == n) values.erase(values.begin() + from, values.begin() + to);
  };
  (erase(beside), ...);
  erase(t);
  return static_cast<std::size_t>(from);
}

}  // namespace cromer::core
