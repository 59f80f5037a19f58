#include "cromer/tasks/spectrum/correction.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "cromer/analysis/baseline.h"
#include "cromer/base/ascii.h"
#include "cromer/base/grid.h"
#include "cromer/tasks/option/choice.h"
#include "cromer/tasks/spectrum/response_spectrum.h"

namespace cromer::core {
namespace {

constexpr int most_order = 12;
constexpr double most_padding = 1000;  // times the recording

Error wrong_band(const std::string& typed, Notice what) {
  return Error{"no_band", {{"typed", typed}, {"what", std::move(what)}}};
}

/// "0.1:25 Hz"; one of the corners may be left out. A unit at the end holds for both.
Result<PassBand> parse_band(const std::string& typed) {
  const auto corners = split(typed, ':');
  if (corners.size() != 2) return wrong_band(typed, Notice{"band_has_two_corners"});
  const bool has_low = !corners[0].empty(), has_high = !corners[1].empty();
  if (!has_low && !has_high) return wrong_band(typed, Notice{"band_has_two_corners"});
  std::string list(corners[0]);
  if (has_low && has_high) list += ',';
  list += corners[1];
  const auto values = parse_grid(list, "Hz");
  if (!values) return wrong_band(typed, values.error().notice);
  if (values->size() != std::size_t{has_low} + std::size_t{has_high})
    return wrong_band(typed, Notice{"band_has_two_corners"});
  PassBand band;
  if (has_low) band.low = (*values)[0];
  if (has_high) band.high = (*values)[values->size() - 1];
  if (!(band.low > 0 || !has_low) || !(band.high > band.low)) return wrong_band(typed, Notice{"band_rises"});
  return band;
}

/// Zeros of so many samples before and behind.
std::vector<double> with_zeros(const std::vector<double>& samples, std::size_t before, std::size_t behind) {
  std::vector<double> longer(before + samples.size() + behind, 0.0);
  std::copy(samples.begin(), samples.end(), longer.begin() + static_cast<std::ptrdiff_t>(before));
  return longer;
}

}  // namespace

Result<Correction> correction_of(const SpectrumOptions& options) {
  Correction correction;
  if (!options.baseline.empty()) {
    const auto degree = choice("baseline", options.baseline, baselines);
    if (!degree) return degree.error();
    correction.baseline = static_cast<int>(*degree);
  }
  if (options.band_pass.empty()) {
    if (options.band_pass_order) return Error{"without_band_pass", {{"option", "band-pass-order"}}};
    if (options.causal) return Error{"without_band_pass", {{"option", "causal"}}};
    return correction;
  }
  const auto band = parse_band(options.band_pass);
  if (!band) return band.error();
  correction.band = *band;
  correction.order = options.band_pass_order.value_or(correction.order);
  correction.causal = options.causal;
  if (correction.order < 1 || correction.order > most_order)
    return Error{"order_out_of_range", {{"order", correction.order}, {"most", most_order}}};
  return correction;
}

Result<void> correct(Component& component, const Correction& correction) {
  std::vector<double>& a = component.acceleration;
  const double h = component.spacing;
  if (correction.baseline) {
    if (a.size() <= static_cast<std::size_t>(*correction.baseline) + 1)
      return Error{"too_few_for_baseline", {{"file", component.file}, {"samples", a.size()}}};
    const std::vector<double> line = least_squares_polynomial(a, *correction.baseline);
    for (std::size_t i = 0; i < a.size(); ++i) {
      a[i] -= line[i];
      component.baseline = std::max(component.baseline, std::abs(line[i]));
    }
  }
  if (!correction.band) return {};
  const PassBand& band = *correction.band;
  const double highest = band.has_high() ? band.high : band.low;
  if (!(highest < 0.5 / h))
    return Error{"band_above_half_rate", {{"file", component.file}, {"corner", highest}, {"most", 0.5 / h}}};
  const auto sections = butterworth(correction.order, band, h);
  const double zeros = std::ceil(memory_of(sections, h) / h), length = static_cast<double>(a.size());
  if (!(zeros <= most_padding * length))
    return Error{"band_too_slow", {{"file", component.file}, {"corner", band.low}, {"duration", h * length}}};
  const auto behind = static_cast<std::size_t>(zeros), before = correction.causal ? 0 : behind;
  a = with_zeros(a, before, behind);
  if (correction.causal)
    filter(sections, a);
  else
    filter_both_ways(sections, a);
  component.begins -= h * static_cast<double>(before);
  return {};
}

}  // namespace cromer::core
