// A motion that several sensors recorded at once, and the modes of the structure that made it.
#pragma once

#include <complex>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "cromer/notice.h"
#include "cromer/quantity.h"

namespace cromer::core {

/// With fewer samples no modes are sought.
inline constexpr std::size_t fewest_modal_samples = 40;

/// Channels of one kind (accelerations, say) at even times.
struct ModalRecord {
  std::vector<std::span<const double>> channels;  ///< at least one; all of one length, no NaN
  double step = 1;                                // [s] > 0 from sample to sample
  std::vector<std::size_t> starts{0};  ///< the first sample of each stretch without a gap, from 0 on
  std::vector<double> times{};         // [s] of the samples; empty: one step apart from 0 on
  std::vector<double> measured{};      ///< 1 where a sample was measured, 0 where filled in; empty: all 1

  std::size_t samples() const { return channels.front().size(); }
  /// One past the last sample of a stretch.
  std::size_t end(std::size_t stretch) const {
    return stretch + 1 < starts.size() ? starts[stretch + 1] : samples();
  }
  double time(std::size_t i) const { return times.empty() ? static_cast<double>(i) * step : times[i]; }
};

struct MeasuredMode {
  Estimate frequency;  // [Hz] size of the eigenvalue over 2 pi
  Estimate damping_ratio;
  std::vector<std::complex<double>> shape{};        ///< by channel; the largest component is 1
  std::vector<std::complex<double>> shape_error{};  ///< standard errors of its real and imaginary parts
  std::complex<double> eigenvalue{};                // [1/s]
  int order = 0;                                    ///< of the model that it is taken from; 0 of a free decay
  double lifetimes = 0;    ///< decay times 1/(damping ratio times angular frequency) that the record holds;
                           ///< negative of a mode that grows
  double times_noise = 1;  ///< what the fit of a free decay leaves about it, over the noise, in amplitude
};

/// From so many times the noise on, what is left about a mode is more than chance leaves.
inline constexpr double times_noise_told = 2;

struct ModalSettings {
  double from = 0;                                      // [Hz] only modes between
  double to = std::numeric_limits<double>::infinity();  // [Hz]
  int modes = 0;                   ///< at most this many, those at the most orders; 0: all
  bool from_first_sample = false;  ///< no still beginning is left out
};

/// A pole of one order, as the stabilisation diagram shows it.
struct StabilityPole {
  int order = 0;
  double frequency = 0;  // [Hz]
  double damping_ratio = 0;
  bool stable =
      false;  ///< frequency within 1 %, damping within a half, shape within MAC 0.95 of the order before
  bool first = false;        ///< not stable itself, but the next order has it still
  int mode = -1;             ///< which group of poles it belongs to; -1: none
  std::ptrdiff_t index = 0;  ///< among its order's eigenvalues
  std::vector<std::complex<double>> shape;
};

/// Gives the record the times [s] of its samples, which rise strictly, at least two: the step is the mean of
/// those that are no gaps, and a gap is longer than 1.75 medians.
void set_times(ModalRecord& record, const std::vector<double>& t);

/// Where each sample stands when short gaps, of up to twenty samples, are as long as they are, and longer
/// ones are not there: from 0 on. Where samples some steps apart would hardly
/// ever both be there, as in bursts, no gap counts as short.
std::vector<std::size_t> places_with_short_gaps(const ModalRecord& record);

/// A record whose short gaps are filled in: up to three samples by the cubic through the two to each side,
/// where there are two, longer ones by a straight line. For spectra and start values: what is filled in was
/// not measured.
class BridgedRecord {
 public:
  explicit BridgedRecord(const ModalRecord& record);
  BridgedRecord(const BridgedRecord&) = delete;  // record() looks into values_
  BridgedRecord& operator=(const BridgedRecord&) = delete;

  const ModalRecord& record() const { return record_; }

 private:
  std::vector<std::vector<double>> values_;  // of the channels; empty where nothing is filled in
  ModalRecord record_;
};

/// Says by what share the steps between samples are longer in the last third than in the first, gaps left
/// out; empty unless the difference is significant, and more than a twentieth of a percent.
Notice drifting_clock(const ModalRecord& record);

}  // namespace cromer::core
