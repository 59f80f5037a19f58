#include "cromer/tasks/spectrum/response_spectrum.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/analysis/hysteretic_peaks.h"
#include "cromer/analysis/yielding.h"
#include "cromer/base/function_ref.h"
#include "cromer/base/grid.h"
#include "cromer/base/pi.h"
#include "cromer/ensemble/dispatch.h"
#include "cromer/ensemble/rotated_peaks.h"
#include "cromer/model/between_samples.h"
#include "cromer/tasks/option/choice.h"
#include "cromer/tasks/spectrum/spectrum_setup.h"

namespace cromer::core {
namespace {

constexpr int band_limited_factor = 16;  // values for each interval
constexpr int band_limited_reach = 128;  // samples: faithful up to 31/32 of the Nyquist frequency
// Periods computed between two checks for an interrupt: of one component, of two, of hysteretic damping.
constexpr std::size_t slice = 1024, slice_of_two = 128, slice_of_sums = 8, least_slice = 32,
                      slice_of_yielding = 4;
constexpr double slice_of_work = 3e7;  // samples times periods: a fraction of a second

double angular_frequency(double period) { return two_pi / period; }

/// The motion that shakes the oscillators: the samples, or denser ones of a band-limited motion.
struct Shaking {
  std::vector<double> refined;
  GroundMotion ground;

  Shaking(const Component& component, BetweenSamples between) {
    const bool refine = between == BetweenSamples::band_limited;  // then linear
    if (refine)
      refined = refine_band_limited(component.acceleration, band_limited_factor, band_limited_reach);
    ground = {refine ? refined : component.acceleration,
              refine ? component.spacing / band_limited_factor : component.spacing,
              refine ? BetweenSamples::linear : between, refine ? std::size_t{band_limited_factor} : 1};
  }
};

std::vector<LinearLaw<double>> laws_of(std::span<const double> periods, double damping_ratio) {
  std::vector<LinearLaw<double>> laws;
  for (const double period : periods) {
    const double w = angular_frequency(period);
    laws.push_back({.decay_rate = damping_ratio * w, .stiffness = w * w});
  }
  return laws;
}

ResponseOf searched_for(ShockResponse of) {
  switch (of) {
    case ShockResponse::absolute_acceleration:
      return ResponseOf::absolute_acceleration;
    case ShockResponse::relative_velocity:
      return ResponseOf::velocity;
    default:
      return ResponseOf::displacement;
  }
}

/// The response over what is searched for, whose sign is turned unless it is the acceleration.
double scale_of(ShockResponse of, double w) {
  switch (of) {
    case ShockResponse::absolute_acceleration:
      return 1;
    case ShockResponse::relative_velocity:
    case ShockResponse::relative_displacement:
      return -1;
    case ShockResponse::pseudo_velocity:
      return -w;
    case ShockResponse::equivalent_static_acceleration:
      return w * w;
  }
  return 1;
}

Shock shock_of(const ResponsePeaks& peaks, double scale) {
  const double low = std::min(peaks.during.low, peaks.after.low),
               high = std::max(peaks.during.high, peaks.after.high);
  return {.primary = std::abs(scale) * peaks.during.magnitude(),
          .residual = std::abs(scale) * peaks.after.magnitude(),
          .positive = std::max(scale * low, scale * high),
          .negative = -std::min(scale * low, scale * high)};
}

void extend_hysteretic(ResponseSpectrum& spectrum, const Component& component,
                       std::span<const double> periods) {
  spectrum.displacement.resize(1);
  for (const double peak :
       hysteretic_peaks(component.acceleration, component.spacing, periods, spectrum.damping_ratio))
    spectrum.displacement[0].push_back(peak);
}

void extend_yielding(ResponseSpectrum& spectrum, const GroundMotion& ground,
                     std::span<const LinearLaw<double>> laws, PeakSearch search) {
  search.after_the_end = false;
  search.peaks = Peaks::continuous;
  spectrum.displacement.resize(1);
  const auto elastic = response_peaks(ground, laws, search);
  for (std::size_t i = 0; i < laws.size(); ++i)
    spectrum.displacement[0].push_back(
        YieldingOscillator{ground.acceleration, ground.spacing, std::sqrt(laws[i].stiffness),
                           spectrum.damping_ratio}
            .yield_displacement(spectrum.ductility, elastic[i].during.magnitude()));
}

/// Adds a slice of the periods.
void extend(ResponseSpectrum& spectrum, const std::vector<Shaking>& shaking,
            std::span<const LinearLaw<double>> laws, PeakSearch search, std::optional<ShockResponse> shock) {
  if (shock) {
    search.quantity = searched_for(*shock);
    search.largest_alone = false;
    const auto found = response_peaks(shaking[0].ground, laws, search);
    for (std::size_t i = 0; i < found.size(); ++i)
      spectrum.shock.push_back(shock_of(found[i], scale_of(*shock, std::sqrt(laws[i].stiffness))));
    return;
  }
  spectrum.displacement.resize(shaking.size());
  for (std::size_t c = 0; c < shaking.size(); ++c)
    for (const auto& found : response_peaks(shaking[c].ground, laws, search)) {
      const std::size_t i = spectrum.displacement[c].size();
      const bool continuous = search.peaks == Peaks::continuous;
      spectrum.displacement[c].push_back(continuous ? found.overall() : found.during.magnitude());
      if (continuous && found.after.magnitude() > 1.01 * found.during.magnitude())
        spectrum.after_the_end.push_back(i);
    }
  if (shaking.size() < 2) return;
  for (const auto& found :
       rotated_peaks(shaking[0].ground, shaking[1].ground, laws, search.peaks, search.unit)) {
    const std::size_t i = spectrum.rotd50.size();
    spectrum.geometric_mean.push_back(std::sqrt(spectrum.displacement[0][i] * spectrum.displacement[1][i]));
    spectrum.rotd50.push_back(found.median);
    spectrum.rotd100.push_back(found.largest);
  }
}

void keep_each(std::size_t n, std::vector<double>& values) {
  for (std::size_t i = 0; i * n < values.size(); ++i) values[i] = values[i * n];
  values.resize((values.size() + n - 1) / n);
}

void measure(Component& component, const GroundMotion& ground) {
  for (const double a : component.acceleration) component.peak = std::max(component.peak, std::abs(a));
  const auto& [acceleration, spacing, between, refinement] = ground;
  component.path = ground_path(acceleration, spacing, between);
  keep_each(refinement, component.path.velocity);
  keep_each(refinement, component.path.displacement);
  component.absolute_velocity = cumulative_absolute_velocity(acceleration, spacing, between);
  component.bracketed_duration = bracketed_duration(acceleration, spacing, between);
  component.intensity = intensity(acceleration, spacing, between);
  component.fourier = fourier_amplitude(component.acceleration, component.spacing);
}

/// Steady states are summed as they are: there is nothing to choose, and nothing before or after them.
Result<void> check_hysteretic(const SpectrumOptions& options, std::size_t components) {
  const auto alone = [](std::string_view other) {
    return Error{"loss_factor_sums_steady_states", {{"option", other}}};
  };
  if (!options.peaks.empty()) return alone("peaks");
  if (!options.between_samples.empty()) return alone("between-samples");
  if (options.shock) return alone("shock");
  if (components > 1) return Error{"one_recording", {{"option", "loss-factor"}}};
  return {};
}

Result<void> check_yielding(const SpectrumOptions& options, BetweenSamples between, std::size_t components) {
  const auto without = [](std::string_view other) {
    return Error{"yielding_is_followed", {{"option", other}}};
  };
  if (!options.loss_factor.empty()) return without("loss-factor");
  if (options.shock) return without("shock");
  if (!options.peaks.empty()) return without("peaks");
  if (between == BetweenSamples::hold) return without("between-samples");
  if (components > 1) return Error{"one_recording", {{"option", "ductility"}}};
  return {};
}

Result<void> check_hysteretic_memory(const SpectrumResult& result, std::span<const double> loss_factors) {
  const Component& component = result.components[0];
  const double longest = *std::max_element(result.periods.begin(), result.periods.end());
  const double least = *std::min_element(loss_factors.begin(), loss_factors.end());
  const double samples = hysteretic_samples(component.acceleration.size(), component.spacing, longest, least);
  const auto fits = fits_in_memory(2 * samples, 64, result.options.memory > 0 ? result.options.memory : 16e9);
  if (fits) return {};
  return Error{"loss_factor_takes_long", {{"what", fits.error().notice}}};
}

/// Peaks after the end are those of a ground that stopped accelerating, not of one at rest.
Notice after_the_end_notice(const SpectrumResult& result) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& spectrum : result.spectra)
    for (const std::size_t i : spectrum.after_the_end) least = std::min(least, result.periods[i]);
  return std::isfinite(least) ? Notice{"peaks_after_the_end", {{"period", least}}} : Notice{};
}

Result<void> check_together(const SpectrumOptions& options, Peaks peaks, BetweenSamples between,
                            std::size_t components) {
  if (peaks == Peaks::peer && between != BetweenSamples::linear) return Error{"peer_joins_samples"};
  if (!options.ductility.empty()) return check_yielding(options, between, components);
  if (!options.loss_factor.empty()) return check_hysteretic(options, components);
  if (options.shock && components > 1) return Error{"one_recording", {{"option", "shock"}}};
  return {};
}

}  // namespace

double pseudo_velocity(double displacement, double period) {
  return angular_frequency(period) * displacement;
}

double pseudo_acceleration(double displacement, double period) {
  return angular_frequency(period) * pseudo_velocity(displacement, period);
}

namespace {

/// Says which integrals may drift: that of a ground that does not come to rest.
void add_drifts(SpectrumResult& result) {
  constexpr double at_rest = 0.1;  // of the largest velocity
  if (result.options.shock || result.correction.any()) return;
  for (const Component& component : result.components) {
    const GroundPath& path = component.path;
    const double share = std::abs(path.velocity.back()) / path.peak_velocity;
    if (share > at_rest)
      result.notices.push_back(
          Notice{"ground_ends_moving",
                 {{"file", component.file}, {"velocity", path.velocity.back()}, {"percent", 100 * share}}});
  }
}

/// What the options say by themselves.
struct Asked {
  Peaks peaks;
  BetweenSamples between;
  std::vector<double> ratios, ductilities;
  KernelUnit unit;
  Correction correction;
  ShockResponse shock;
};

Result<Asked> asked_of(const SpectrumOptions& options) {
  const auto peaks = peaks_of(options);
  if (!peaks) return peaks.error();
  const auto between = between_of(options);
  if (!between) return between.error();
  auto ratios = damping_ratios_of(options);
  if (!ratios) return ratios.error();
  auto ductilities = ductilities_of(options);
  if (!ductilities) return ductilities.error();
  const auto unit = choose_unit_by_environment();
  if (!unit) return unit.error();
  const auto correction = correction_of(options);
  if (!correction) return correction.error();
  const auto shock = choice("shock-response", options.shock_response, shock_responses);
  if (!shock) return shock.error();
  if (!options.shock && !options.shock_response.empty()) return Error{"response_without_shock"};
  return Asked{*peaks,
               *between,
               *std::move(ratios),
               *std::move(ductilities),
               *unit,
               *correction,
               static_cast<ShockResponse>(*shock)};
}

/// Makes the components once the options are checked; its notices come first.
using MakeComponents = FunctionRef<Result<std::vector<Component>>(std::vector<Notice>& notices)>;

Result<SpectrumResult> spectrum_of(MakeComponents make_components, const SpectrumOptions& options,
                                   const Watch& watch) {
  const auto asked = asked_of(options);
  if (!asked) return asked.error();
  const auto& [peaks, between, ratios, ductilities, unit, correction, shock] = *asked;
  const PeakSearch search{
      .peaks = peaks, .after_the_end = options.shock || peaks == Peaks::continuous, .unit = unit.walk};
  SpectrumResult result;
  result.options = options;
  result.peaks = peaks;
  result.shock_of = shock;
  result.correction = correction;
  if (options.peaks.empty()) result.options.peaks = name(Peaks::continuous);
  if (options.between_samples.empty())
    result.options.between_samples = result.hysteretic() ? "band-limited" : "linear";

  auto components = make_components(result.notices);
  if (!components) return components.error();
  result.components = *std::move(components);
  for (Component& component : result.components) {
    if (auto good = correct(component, correction); !good) return good.error();
    component.samples = component.acceleration.size();
  }
  if (auto good = check_together(options, peaks, between, result.components.size()); !good)
    return good.error();
  auto periods = periods_of(result.options, result.components[0], ratios.size() * ductilities.size());
  if (!periods) return periods.error();
  result.periods = *std::move(periods);
  if (result.hysteretic())
    if (auto good = check_hysteretic_memory(result, ratios); !good) return good.error();
  for (Notice& notice : period_notices(result.options, result.periods, result.components[0], peaks))
    result.notices.push_back(std::move(notice));

  std::vector<Shaking> shaking;
  for (auto& component : result.components) {
    shaking.emplace_back(component, between);
    measure(component, shaking.back().ground);
  }
  for (const Component& component : result.components)
    if (std::isnan(component.intensity.arias))
      result.notices.push_back(Notice{"intensity_too_small",
                                      {{"file", component.file}, {"decades", component.intensity.decades}}});
  add_drifts(result);
  const std::size_t all = result.periods.size();
  const auto samples = static_cast<double>(shaking[0].ground.acceleration.size());
  const auto of_one = std::clamp(static_cast<std::size_t>(slice_of_work / samples), least_slice, slice);
  const std::size_t at_once = result.hysteretic()  ? slice_of_sums
                              : result.inelastic() ? slice_of_yielding
                              : shaking.size() > 1 ? slice_of_two
                                                   : of_one;
  const std::size_t spectra = ratios.size() * ductilities.size();
  for (std::size_t s = 0; s < spectra; ++s) {
    ResponseSpectrum& spectrum = result.spectra.emplace_back();
    spectrum.damping_ratio = ratios[s / ductilities.size()];
    spectrum.ductility = ductilities[s % ductilities.size()];
    const auto laws = laws_of(result.periods, spectrum.damping_ratio);
    for (std::size_t begin = 0; begin < all;) {
      if (watch.interrupted()) {
        result.interrupted = true;
        result.spectra.clear();
        return result;
      }
      const std::size_t count = std::min(at_once, all - begin);
      if (result.hysteretic())
        extend_hysteretic(spectrum, result.components[0], std::span(result.periods).subspan(begin, count));
      else if (result.inelastic())
        extend_yielding(spectrum, shaking[0].ground, std::span(laws).subspan(begin, count), search);
      else
        extend(spectrum, shaking, std::span(laws).subspan(begin, count), search,
               options.shock ? std::optional(shock) : std::nullopt);
      begin += count;
      if (watch.progress)
        watch.progress((static_cast<double>(s) + static_cast<double>(begin) / static_cast<double>(all)) /
                       static_cast<double>(spectra));
    }
    if (!result.inelastic()) continue;
    const std::vector<double>& yields = spectrum.displacement[0];
    const auto weak =
        std::count_if(yields.begin(), yields.end(), [](double each) { return std::isnan(each); });
    if (weak > 0)
      result.notices.push_back(
          Notice{"ductility_not_reached", {{"ductility", spectrum.ductility}, {"count", weak}}});
  }
  if (result.inelastic()) result.notices.push_back(Notice{"yield_spectrum"});
  if (Notice notice = after_the_end_notice(result); !notice.empty())
    result.notices.push_back(std::move(notice));
  return result;
}

}  // namespace

Result<SpectrumResult> response_spectrum(std::span<const Recording> recordings,
                                         const SpectrumOptions& options, const Watch& watch) {
  const auto read = [&](std::vector<Notice>& notices) {
    return read_components(recordings, options, notices);
  };
  return spectrum_of(read, options, watch);
}

Result<SpectrumResult> response_spectrum(std::vector<Component> components, const SpectrumOptions& options,
                                         const Watch& watch) {
  const auto given = [&](std::vector<Notice>&) -> Result<std::vector<Component>> {
    return std::move(components);
  };
  return spectrum_of(given, options, watch);
}

Result<void> check_spectrum_options(const SpectrumOptions& options, std::size_t files) {
  const auto asked = asked_of(options);
  if (!asked) return asked.error();
  if (auto good = check_components(options, files); !good) return good;
  const std::size_t components = files * std::max<std::size_t>(1, options.column.size());
  if (auto good = check_together(options, asked->peaks, asked->between, components); !good) return good;
  const auto grid = grid_of(options);
  return grid ? Result<void>{} : grid.error();
}

void SpectrumResult::forget() {
  for (Component& component : components) {
    component.acceleration = std::vector<double>();
    component.path.velocity = std::vector<double>();
    component.path.displacement = std::vector<double>();
    component.fourier = {};
  }
}

}  // namespace cromer::core
