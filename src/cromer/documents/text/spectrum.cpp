#include "cromer/documents/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/base/ascii.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/csv.h"
#include "cromer/documents/described/spectrum.h"
#include "cromer/documents/text/words.h"

namespace cromer::core {
namespace {

bool is_alphanumeric(char c) { return is_digit(c) || (lower(c) >= 'a' && lower(c) <= 'z'); }

/// The power of ten if the number itself is beyond any double.
std::string arias_intensity(const Intensity& intensity) {
  return std::isfinite(intensity.arias) ? rounded(intensity.arias, 4)
                                        : fmt::format("about 10^{:.0f}", intensity.decades);
}

std::vector<std::string> recording_headings(const SpectrumResult& result) {
  return {"recording",  "samples",    "step (s)",  fmt::format("PGA ({})", written_unit(result)),
          "PGV (m/s)",  "PGD (m)",    "CAV (m/s)", "Arias (m/s)",
          "5-75 % (s)", "5-95 % (s)", "0.05 g (s)"};
}

std::vector<std::string> recording_row(const std::string& name, const Component& c, double unit) {
  return {name,
          fmt::format("{}", c.samples),
          rounded(c.spacing, 6),
          rounded(c.peak / unit, 5),
          rounded(c.path.peak_velocity, 4),
          rounded(c.path.peak_displacement, 4),
          rounded(c.absolute_velocity, 4),
          arias_intensity(c.intensity),
          rounded(c.intensity.duration_75, 4),
          rounded(c.intensity.duration, 4),
          rounded(c.bracketed_duration, 4)};
}

std::string recording_table(const std::vector<std::vector<std::string>>& rows) {
  return text_table(rows, 1, rows[0].size());
}

/// Adds a row for each component; `file_names` are those of their files.
void add_recordings(std::vector<std::vector<std::string>>& rows, const SpectrumResult& result,
                    std::span<const std::string> file_names) {
  const auto& all = result.components;
  const bool of_one_file = all.size() > 1 && all[0].file == all[1].file;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& file = file_names[std::min(i, file_names.size() - 1)];
    rows.push_back(recording_row(of_one_file ? fmt::format("{}, {}", file, all[i].column) : file, all[i],
                                 written_acceleration(result)));
  }
}

/// The rows to show: all, or evenly spaced ones with both ends.
std::vector<std::size_t> shown_rows(std::size_t all) {
  std::vector<std::size_t> rows;
  const std::size_t count = std::min(all, most_rows);
  for (std::size_t i = 0; i < count; ++i) rows.push_back(count == 1 ? 0 : i * (all - 1) / (count - 1));
  return rows;
}

std::string conventions(const SpectrumResult& result) {
  if (result.hysteretic()) return "peaks of a sum of steady states; samples joined band-limited";
  const std::string joined = fmt::format("samples joined {}", result.options.between_samples);
  if (result.inelastic()) return "elastoplastic springs, until the last sample; " + joined;
  switch (result.peaks) {
    case Peaks::continuous:
      return "peaks of the continuous motion, also after the recording's end; " + joined;
    case Peaks::samples:
      return "peaks at the samples; " + joined;
    case Peaks::peer:
      return "peaks as PEER takes them: at steps of at most a tenth of a period; " + joined;
  }
  return "";
}

/// Oscillators are named as they were asked for, by frequency or by period.
const char* oscillator_heading(const SpectrumResult& result) {
  return result.by_frequency() ? "frequency (Hz)" : "period (s)";
}

std::string oscillator(const SpectrumResult& result, std::size_t i) {
  const double period = result.periods[i];
  return rounded(result.by_frequency() ? 1 / period : period, 4);
}

/// The columns of the CSV file; of two components only the pseudo-accelerations.
std::string spectrum_table(const SpectrumResult& result, const ResponseSpectrum& spectrum) {
  const bool two = !spectrum.rotd50.empty();
  std::vector<std::vector<std::string>> rows{{oscillator_heading(result)}};
  const std::vector<std::size_t> oscillators = shown_rows(result.periods.size());
  for (const std::size_t i : oscillators) rows.push_back({oscillator(result, i)});
  const NamedColumns columns = spectrum_columns(result, spectrum);
  for (std::size_t c = spectrum.shock.empty() ? 1 : 2; c < columns.headers.size(); ++c) {
    if (two && !columns.headers[c].starts_with("PSA")) continue;
    rows[0].push_back(columns.headers[c]);
    for (std::size_t i = 0; i < oscillators.size(); ++i)
      rows[i + 1].push_back(rounded(columns.values[c][oscillators[i]], 5));
  }
  if (two)
    rows[0] = {oscillator_heading(result),
               fmt::format("PSA ({}), {}", written_unit(result), component_name(result, 0)),
               component_name(result, 1),
               "geometric mean",
               "RotD50",
               "RotD100"};
  return text_table(rows, 0, 6);
}

/// The largest value, and where it is: PSA, of a shock the maximax, of two components RotD50.
struct Summit {
  double height = 0;  // [m/s^2], of a shock its SI unit
  std::size_t oscillator = 0;
};

Summit summit_of(const SpectrumResult& result, const ResponseSpectrum& spectrum) {
  const bool shock = !spectrum.shock.empty(), two = !spectrum.rotd50.empty();
  Summit summit;
  for (std::size_t i = 0; i < result.periods.size(); ++i) {
    const double value = shock ? spectrum.shock[i].maximax()
                               : pseudo_acceleration(two ? spectrum.rotd50[i] : spectrum.displacement[0][i],
                                                     result.periods[i]);
    if (value > summit.height) summit = {value, i};
  }
  return summit;
}

double written_height(const SpectrumResult& result) {
  return result.options.shock ? written_shock(result) : written_acceleration(result);
}
std::string_view height_unit(const SpectrumResult& result) {
  return result.options.shock ? shock_unit(result) : written_unit(result);
}

std::string summit_text(const SpectrumResult& result, const ResponseSpectrum& spectrum) {
  const Summit summit = summit_of(result, spectrum);
  const std::string at = oscillator(result, summit.oscillator) + (result.by_frequency() ? " Hz" : " s");
  return fmt::format("highest{}: {} {} at {}\n", spectrum.rotd50.empty() ? "" : " RotD50",
                     rounded(summit.height / written_height(result), 4), height_unit(result), at);
}

std::string damping_text(const SpectrumResult& result, const ResponseSpectrum& spectrum) {
  const std::string text = fmt::format("{} {}", result.hysteretic() ? "loss factor" : "damping ratio",
                                       shortest(spectrum.damping_ratio));
  return result.inelastic() ? fmt::format("{}, ductility {}", text, shortest(spectrum.ductility)) : text;
}

}  // namespace

std::string component_name(const SpectrumResult& result, std::size_t c) {
  if (result.components[0].column == result.components[1].column) return fmt::format("component {}", c + 1);
  const std::string& column = result.components[c].column;
  return column.substr(0, column.find(" ("));
}

std::string correction_text(const Correction& correction, bool brief) {
  if (!correction.any()) return "";
  std::string text = "corrected: ";
  if (correction.baseline)
    text += fmt::format("{} baseline taken off", baselines[static_cast<std::size_t>(*correction.baseline)]);
  if (!correction.band) return text;
  const PassBand& band = *correction.band;
  if (correction.baseline) text += "; ";
  text += band.has_low() && band.has_high()
              ? fmt::format("band-pass from {} to {} Hz", shortest(band.low), shortest(band.high))
          : band.has_low() ? fmt::format("high-pass from {} Hz", shortest(band.low))
                           : fmt::format("low-pass to {} Hz", shortest(band.high));
  text += fmt::format(", Butterworth of order {}, {}", correction.order,
                      correction.causal ? "causal" : "zero phase");
  if (brief) return text;
  return text + (correction.causal
                     ? " (forwards alone, -3 dB at a corner, zeros added behind)"
                     : " (forwards and backwards, -6 dB at a corner, zeros added at both ends)");
}

std::string readable_response(ShockResponse of) {
  std::string words(name(of));
  std::replace(words.begin(), words.end(), '-', ' ');
  return words;
}

std::string spectrum_text(const SpectrumResult& result) {
  std::vector<std::string> files;
  for (const Component& component : result.components) files.push_back(component.file);
  std::vector<std::vector<std::string>> recordings{recording_headings(result)};
  add_recordings(recordings, result, files);
  std::string text = recording_table(recordings);
  if (result.correction.any()) text += correction_text(result.correction) + '\n';
  const std::size_t all = result.periods.size();
  for (const auto& spectrum : result.spectra) {
    text += fmt::format("\n{}: {}{}\n", damping_text(result, spectrum),
                        result.options.shock ? readable_response(result.shock_of) + ", " : "",
                        conventions(result));
    text += spectrum_table(result, spectrum);
    if (all > most_rows) text += fmt::format("{} of {} rows; a file (-o) has them all\n", most_rows, all);
    text += summit_text(result, spectrum);
  }
  return text;
}

std::vector<std::string> motion_names(std::span<const MotionSpectra> motions) {
  std::vector<std::string> files;
  for (const MotionSpectra& motion : motions)
    files.insert(files.end(), motion.files.begin(), motion.files.end());
  const std::vector<std::string> short_ones = short_names(files);
  std::vector<std::string> names;
  auto file = short_ones.begin();
  for (const MotionSpectra& motion : motions) {
    names.push_back(*file++);
    if (motion.files.size() < 2) continue;
    const std::string first = names.back(), &second = *file++;
    auto differ = std::mismatch(first.begin(), first.end(), second.begin(), second.end()).second;
    while (differ != second.begin() && is_alphanumeric(differ[-1])) --differ;  // to the end of a word
    names.back() +=
        differ - second.begin() > 3 ? " + ..." + std::string(differ, second.end()) : " + " + second;
  }
  return names;
}

std::string spectra_text(std::span<const MotionSpectra> motions) {
  std::vector<std::string> files;
  for (const MotionSpectra& motion : motions)
    files.insert(files.end(), motion.files.begin(), motion.files.end());
  const std::vector<std::string> short_ones = short_names(files), names = motion_names(motions);
  std::vector<std::vector<std::string>> recordings, summits;
  const SpectrumResult* any = nullptr;
  std::size_t file = 0, done = 0;
  for (std::size_t m = 0; m < motions.size(); file += motions[m++].files.size()) {
    if (!motions[m].succeeded()) continue;
    const SpectrumResult& result = *motions[m].result;
    if (!any) {
      any = &result;
      recordings.push_back(recording_headings(result));
      const bool shock = result.options.shock, two = result.components.size() > 1;
      summits = {{"motion", result.hysteretic() ? "loss factor" : "damping ratio",
                  fmt::format("highest {} ({})",
                              shock ? "acceleration"
                              : two ? "RotD50 PSA"
                                    : "PSA",
                              written_unit(result)),
                  fmt::format("at {}", oscillator_heading(result))}};
    }
    ++done;
    add_recordings(recordings, result, std::span(short_ones).subspan(file, motions[m].files.size()));
    for (const auto& spectrum : result.spectra) {
      const Summit summit = summit_of(result, spectrum);
      summits.push_back({names[m], shortest(spectrum.damping_ratio),
                         rounded(summit.height / written_height(result), 4),
                         oscillator(result, summit.oscillator)});
    }
  }
  std::string text;
  if (any)
    text = fmt::format("{}{}{}\n{}\n{}", recording_table(recordings), correction_text(any->correction),
                       any->correction.any() ? "\n" : "", conventions(*any), text_table(summits, 1, 4));
  return text + fmt::format("{} of {} motions; a file (-o) has their spectra\n", done, motions.size());
}

}  // namespace cromer::core
