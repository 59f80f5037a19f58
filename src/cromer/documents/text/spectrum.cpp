#include "cromer/documents/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/base/quantity.h"
#include "cromer/documents/csv.h"
#include "cromer/documents/described/spectrum.h"
#include "cromer/documents/text/words.h"

namespace cromer::core {
namespace {

/// The power of ten if the number itself is beyond any double.
std::string arias_intensity(const Intensity& intensity) {
  return std::isfinite(intensity.arias) ? rounded(intensity.arias, 5)
                                        : fmt::format("about 10^{:.0f}", intensity.decades);
}

std::string recording_table(const SpectrumResult& result) {
  std::vector<std::vector<std::string>> rows{
      {"recording", "samples", "step (s)", "peak (m/s²)", "Arias intensity (m/s)", "5-95 % (s)"}};
  const bool of_one_file =
      result.components.size() > 1 && result.components[0].file == result.components[1].file;
  for (const auto& c : result.components)
    rows.push_back({of_one_file ? fmt::format("{}, {}", c.file, c.column) : c.file,
                    fmt::format("{}", c.acceleration.size()), rounded(c.spacing, 6), rounded(c.peak, 5),
                    arias_intensity(c.intensity), rounded(c.intensity.duration, 5)});
  return text_table(rows, 1, 6);
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

/// The largest acceleration, and where it is.
std::string summit(const SpectrumResult& result, const ResponseSpectrum& spectrum) {
  const bool shock = !spectrum.shock.empty();
  const bool two = !spectrum.rotd50.empty();
  std::size_t best = 0;
  double most = -1;
  for (std::size_t i = 0; i < result.periods.size(); ++i) {
    const double value = shock ? spectrum.shock[i].maximax()
                               : pseudo_acceleration(two ? spectrum.rotd50[i] : spectrum.displacement[0][i],
                                                     result.periods[i]);
    if (value <= most) continue;
    most = value;
    best = i;
  }
  const std::string at = oscillator(result, best) + (result.by_frequency() ? " Hz" : " s");
  return fmt::format("highest{}: {} {} at {}\n", two ? " RotD50" : "",
                     rounded(most / written_acceleration(result), 4), written_unit(result), at);
}

}  // namespace

std::string component_name(const SpectrumResult& result, std::size_t c) {
  if (result.components[0].column == result.components[1].column) return fmt::format("component {}", c + 1);
  const std::string& column = result.components[c].column;
  return column.substr(0, column.find(" ("));
}

std::string spectrum_text(const SpectrumResult& result) {
  std::string text = recording_table(result);
  const std::size_t all = result.periods.size();
  for (const auto& spectrum : result.spectra) {
    text += fmt::format("\n{} {}: {}\n", result.hysteretic() ? "loss factor" : "damping ratio",
                        shortest(spectrum.damping_ratio), conventions(result));
    text += spectrum_table(result, spectrum);
    if (all > most_rows) text += fmt::format("{} of {} rows; a file (-o) has them all\n", most_rows, all);
    text += summit(result, spectrum);
  }
  return text;
}

}  // namespace cromer::core
