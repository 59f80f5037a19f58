#include "cromer/identify/modal/mode_search.h"

#include <algorithm>
#include <cmath>

namespace cromer::core {
namespace {

// How the lags are laid out.
struct Lags {
  int stride = 1, rows = 0, highest_order = 0;
};

Lags choose_lags(const ModalRecord& record, const std::vector<SpectralPeak>& peaks,
                 const ModalSettings& settings) {
  const auto channels = static_cast<int>(record.channels.size()),
             samples = static_cast<int>(record.samples());
  double low = 0, highest = 0;
  for (const SpectralPeak& peak : peaks) {
    highest = std::max(highest, peak.frequency);  // wherever modes are looked for: it must not be mirrored
    if (peak.frequency < settings.from || peak.frequency > settings.to) continue;
    low = low > 0 ? std::min(low, peak.frequency) : peak.frequency;
  }
  Lags lags;
  if (highest > 0)
    lags.stride =
        std::clamp(static_cast<int>(1 / (2.5 * highest * record.step)), 1, std::max(1, samples / 80));
  const double periods = low > 0 ? 2 / (low * record.step * lags.stride) : 20;
  const int fewest = std::max(10, (40 + channels - 1) / channels), most = std::max(fewest, 240 / channels);
  lags.rows =
      std::min(std::clamp(static_cast<int>(std::ceil(periods)), fewest, most), samples / (4 * lags.stride));
  lags.highest_order = std::min(40, (lags.rows - 1) * channels / 2 * 2);
  return lags;
}

}  // namespace

std::optional<ModeSearch> search_modes(const ModalRecord& record, const std::vector<SpectralPeak>& peaks,
                                       const ModalSettings& settings) {
  const Lags lags = choose_lags(record, peaks, settings);
  constexpr int fewest_rows = 9;
  if (lags.rows < fewest_rows || lags.highest_order < 8) return std::nullopt;
  const ScaledChannels channels = scale_channels(record);
  constexpr int blocks = 120;
  BlockCorrelations correlations =
      block_correlations(channels, record, 2 * lags.rows - 1, lags.stride, blocks);
  Subspace subspace(correlations, lags.rows, channels.scale);
  subspace.prepare(lags.highest_order);
  // What grows by less over the record is not told from a mode without damping.
  const double growth = 3 / (static_cast<double>(record.samples()) * record.step);
  Stabilisation stable = stabilise(subspace, lags.highest_order, correlations.step, settings.from,
                                   std::min(settings.to, 0.48 / correlations.step), growth);
  return ModeSearch{std::move(correlations), std::move(subspace), std::move(stable), lags.highest_order};
}

}  // namespace cromer::core
