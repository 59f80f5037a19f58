#include "cromer/spectrum.h"

#include <memory>
#include <utility>

#include "cromer/base/quantity.h"
#include "cromer/door/options.h"
#include "cromer/door/watching.h"
#include "cromer/door/words.h"
#include "cromer/tasks/spectrum/response_spectrum.h"

namespace cromer {
namespace {

ResponseSpectrum spectrum_of(std::shared_ptr<const core::SpectrumResult> result) {
  ResponseSpectrum spectrum;
  const core::Component& ground = result->components.front();
  spectrum.peak_acceleration = ground.peak;
  spectrum.arias_intensity = ground.intensity.arias;
  spectrum.ground_velocity = ground.path.velocity;
  spectrum.ground_displacement = ground.path.displacement;
  spectrum.peak_velocity = ground.path.peak_velocity;
  spectrum.peak_displacement = ground.path.peak_displacement;
  spectrum.cumulative_absolute_velocity = ground.absolute_velocity;
  spectrum.duration_5_75 = ground.intensity.duration_75;
  spectrum.duration_5_95 = ground.intensity.duration;
  spectrum.duration_bracketed = ground.bracketed_duration;
  spectrum.interrupted = result->interrupted;
  spectrum.notices = result->notices;
  if (!result->interrupted) {
    const core::ResponseSpectrum& found = result->spectra.front();
    spectrum.period = result->periods;
    if (!found.displacement.empty()) spectrum.displacement = found.displacement.front();
    spectrum.rotd50 = found.rotd50;
    spectrum.rotd100 = found.rotd100;
    spectrum.shock = found.shock;
    for (std::size_t i = 0; i < spectrum.displacement.size(); ++i) {
      spectrum.pseudo_velocity.push_back(core::pseudo_velocity(spectrum.displacement[i], spectrum.period[i]));
      spectrum.pseudo_acceleration.push_back(
          core::pseudo_acceleration(spectrum.displacement[i], spectrum.period[i]));
    }
  }
  spectrum.detail = std::move(result);
  return spectrum;
}

}  // namespace

Result<ResponseSpectrum> response_spectrum(std::span<const double> acceleration, double spacing,
                                           const SpectrumOptions& options) {
  if (auto good = core::check_enumerator(options.peaks, 3, "peaks"); !good) return good.error();
  if (auto good = core::check_enumerator(options.between, 3, "between"); !good) return good.error();
  if (auto good = core::check_samples(options.periods, "periods", 0); !good) return good.error();
  if (options.shock)
    if (auto good = core::check_enumerator(*options.shock, shock_responses.size(), "shock"); !good)
      return good.error();
  auto components = core::components_of(acceleration, options.second, spacing);
  if (!components) return components.error();
  core::SpectrumOptions asked;
  if (options.loss_factor)
    asked.loss_factor = {core::shortest(*options.loss_factor)};
  else
    asked.damping_ratio = {core::shortest(options.damping_ratio)};
  if (options.ductility) asked.ductility = {core::shortest(*options.ductility)};
  asked.shock = options.shock.has_value();
  if (options.shock) asked.shock_response = name(*options.shock);
  asked.these_periods.assign(options.periods.begin(), options.periods.end());
  if (options.peaks != Peaks::continuous) asked.peaks = name(options.peaks);
  if (options.between != BetweenSamples::linear) asked.between_samples = name(options.between);
  asked.memory = core::memory_for_results;
  const core::Watching watching(options.progress);
  auto result = core::response_spectrum(*std::move(components), asked, watching.watch());
  if (!result) return core::in_arguments(result.error(), true);
  result->notices = core::in_arguments(std::move(result->notices), true);
  return spectrum_of(std::make_shared<const core::SpectrumResult>(*std::move(result)));
}

}  // namespace cromer
