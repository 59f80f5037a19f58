// What is found in many small recordings of several channels that were made by chance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cromer/base/pi.h"
#include "cromer/identify/modal/free_decay.h"
#include "cromer/identify/modal/modal_analysis.h"
#include "cromer/identify/modal/mode_search.h"
#include "cromer/identify/modal/steady_lines.h"
#include "cromer/identify/modal/still_beginning.h"
#include "tests/identify/modal_records.h"
#include "tests/support/answers.h"

namespace cromer::core {
namespace CROMER_FILE {

Answers& operator<<(Answers& said, const std::complex<double>& z) { return said << z.real() << z.imag(); }

Answers& operator<<(Answers& said, const Estimate& estimate) {
  return said << estimate.value << estimate.standard_error << estimate.high;
}

void say(Answers& said, const std::vector<MeasuredMode>& modes) {
  said << "modes" << modes.size();
  for (const MeasuredMode& mode : modes) {
    said << mode.frequency << mode.damping_ratio << mode.order << mode.lifetimes << mode.eigenvalue;
    for (std::size_t c = 0; c < mode.shape.size(); ++c) said << mode.shape[c] << mode.shape_error[c];
  }
}

void say(Answers& said, const SpectralMatrix& spectrum) {
  double first = 0, last = 0, weighted = 0;
  for (std::size_t k = 0; k < spectrum.singular.size(); ++k) {
    first += spectrum.singular[k].front();
    last += spectrum.singular[k].back();
    weighted += spectrum.frequency(k) * spectrum.singular[k].front();
  }
  said << "spectrum" << spectrum.singular.size() << spectrum.step << spectrum.averages << first << last
       << weighted;
}

void say(Answers& said, const std::vector<SpectralPeak>& peaks) {
  said << "peaks" << peaks.size();
  for (const SpectralPeak& peak : peaks) said << peak.frequency << peak.prominence;
}

void say(Answers& said, const std::vector<StabilityPole>& poles) {
  int stable = 0, first = 0, in_modes = 0, indices = 0;
  double frequencies = 0, damping_ratios = 0;
  for (const StabilityPole& pole : poles) {
    stable += pole.stable;
    first += pole.first;
    in_modes += pole.mode;
    indices += static_cast<int>(pole.index);
    frequencies += pole.frequency;
    damping_ratios += pole.damping_ratio;
  }
  said << "poles" << poles.size() << stable << first << in_modes << indices << frequencies << damping_ratios;
}

/// A structure of some masses in one of several states.
struct Recorded {
  MadeChannels channels;
  std::vector<double> t;
  bool is_late = false;

  ModalRecord record() const {
    ModalRecord result = channels.record();
    if (!t.empty()) set_times(result, t);
    return result;
  }
};

std::vector<TrueMode> some_modes(Chance& chance, std::size_t channels) {
  std::vector<TrueMode> modes;
  double frequency = chance.between(0.4, 1.6);
  for (std::size_t j = 0; j < 1 + channels; ++j) {
    TrueMode mode{frequency, chance.is(0.5) ? chance.between(0.001, 0.006) : chance.between(0.005, 0.05), {}};
    for (std::size_t c = 0; c < channels; ++c) mode.shape.emplace_back(chance.between(-1, 1), 0);
    modes.push_back(mode);
    frequency *= chance.is(0.2) ? chance.between(1.01, 1.1) : chance.between(1.5, 3);
  }
  return modes;
}

Recorded some_recording(Chance& chance, unsigned seed) {
  const auto channels = static_cast<std::size_t>(chance.between(1, 3.5)),
             samples = static_cast<std::size_t>(chance.between(120, 450));
  const double step = chance.between(0.02, 0.12);
  const std::vector<TrueMode> modes = some_modes(chance, channels);
  std::vector<double> amplitudes;
  for (std::size_t j = 0; j < modes.size(); ++j) amplitudes.push_back(chance.between(0.01, 1));
  const double noise = chance.is(0.5) ? chance.between(0, 0.05) : chance.between(0, 1);
  Recorded made;
  if (chance.is(0.4))
    made.channels = under_white_forces(modes, samples, step, seed);
  else
    made.channels = let_go(modes, amplitudes, samples, step, noise, seed);
  auto& values = made.channels.values;
  if (chance.is(0.3)) {  // at rest first
    const auto still = static_cast<std::size_t>(chance.between(2, 80));
    const double level = chance.is(0.5) ? 0 : values[0][0], quiet = chance.is(0.3) ? 0 : 0.02;
    for (auto& channel : values) {
      channel.insert(channel.begin(), still, level);
      for (std::size_t i = 0; i < still; ++i) channel[i] += quiet * chance.normal();
    }
  }
  if (chance.is(0.3)) {  // a machine
    const double w = two_pi * chance.between(0.5, 4), size = chance.between(0.01, 1);
    for (auto& channel : values)
      for (std::size_t i = 0; i < channel.size(); ++i)
        channel[i] += size * std::cos(w * step * static_cast<double>(i));
  }
  if (chance.is(0.2)) {  // a gap
    const auto at = static_cast<std::size_t>(chance.between(20, 100));
    for (std::size_t i = 0; i < values[0].size(); ++i)
      made.t.push_back(2 + step * static_cast<double>(i < at ? i : i + 40));
  }
  return made;
}

void expect_analyses_as_before(const char* name, unsigned from, unsigned to) {
  Answers said(name);
  for (unsigned seed = from; seed < to; ++seed) {
    Chance chance(seed);
    const Recorded made = some_recording(chance, seed);
    ModalSettings settings;
    if (chance.is(0.1)) settings.from = chance.between(0.5, 2);
    if (chance.is(0.1)) settings.to = chance.between(2, 4);
    if (chance.is(0.2)) settings.modes = 1;
    if (chance.is(0.2)) settings.from_first_sample = true;
    const ModalAnalysis found = find_modes(made.record(), settings);
    said << static_cast<int>(seed) << (found.motion == ModalMotion::ambient ? "ambient" : "free")
         << found.still << found.decaying_share << found.highest_order << found.lags << found.lag_step
         << "lines" << found.lines;
    say(said, found.modes);
    say(said, found.spectrum);
    say(said, found.peaks);
    say(said, found.poles);
    said.end_line();
  }
  said.expect_as_before();
}

TEST(FoundModes, OfOneTwoOrThreeChannels) { expect_analyses_as_before("identify/found_modes", 1, 16); }
TEST(FoundModes, OfMoreRecords) { expect_analyses_as_before("identify/more_found_modes", 16, 31); }
TEST(FoundModes, OfOtherRecords) { expect_analyses_as_before("identify/other_found_modes", 42, 51); }

TEST(FoundModes, StillBeginnings) {
  Answers said("identify/still_beginnings");
  for (unsigned seed = 1; seed <= 250; ++seed) {
    Chance chance(seed);
    const auto channels = static_cast<std::size_t>(chance.between(1, 3.5)),
               samples = static_cast<std::size_t>(chance.between(40, 260)),
               still = static_cast<std::size_t>(chance.between(4, 60));
    const double noise = chance.between(0.01, 0.7), falls = chance.between(0, 0.02),
                 rises = chance.is(0.6) ? 0 : chance.between(0, 0.03), moves = chance.between(0.2, 3);
    MadeChannels made{std::vector<std::vector<double>>(channels), chance.between(0.01, 0.1)};
    for (std::size_t c = 0; c < channels; ++c) {
      const double size = c == 0 ? 1 : chance.between(0, 1), own = chance.is(0.8) ? noise : 2 * noise;
      for (std::size_t i = 0; i < samples; ++i) {
        const double after = static_cast<double>(i) - static_cast<double>(still);
        const double motion = after < 0 ? 0.01 * rises * after
                                        : size * std::exp(-falls * after) * std::sin(moves * after / 3) *
                                              (rises > 0 ? std::min(1.0, rises * after) : 1);
        made.values[c].push_back(3 + motion + own * chance.normal());
      }
    }
    ModalRecord record = made.record();
    if (seed % 2 == 0)
      for (std::size_t i = 0; i < samples; ++i)
        record.times.push_back(7 + made.step * static_cast<double>(i));
    const std::size_t found = still_samples(record);
    MeasuredMode mode;
    mode.eigenvalue = {-falls / made.step, moves / 3 / made.step};
    const std::size_t first = found > 0 ? found : still;
    if (first + 10 > samples) continue;
    said << static_cast<int>(seed) << found << is_still_before(record, first, {mode})
         << still_before_motion(record, first, 0);
    said.end_line();
  }
  said.expect_as_before();
}

TEST(FoundModes, SteadyLines) {
  Answers said("identify/steady_lines");
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Chance chance(seed);
    const auto samples = static_cast<std::size_t>(chance.between(60, 200));
    const double w = chance.between(0.3, 2), rate = chance.between(-0.5, 0.5) / static_cast<double>(samples),
                 other = w + chance.between(-0.1, 0.1), beside = chance.is(0.5) ? 0 : chance.between(0, 0.5),
                 noise = chance.between(0, 1.2);
    MadeChannels made{std::vector<std::vector<double>>(1 + seed % 2), 1};
    for (auto& channel : made.values)
      for (std::size_t i = 0; i < samples; ++i) {
        const auto at = static_cast<double>(i);
        channel.push_back(std::exp(rate * at) * std::cos(w * at) + beside * std::cos(other * at) +
                          noise * chance.normal());
      }
    const ModalRecord record = made.record();
    said << static_cast<int>(seed);
    for (const auto& line : steady_lines(record, {w + chance.between(-0.06, 0.06), other, 3.1}, 0.05))
      said << line;
    said.end_line();
  }
  said.expect_as_before();
}

TEST(FoundModes, FreeDecays) {
  Answers said("identify/free_decays");
  for (unsigned seed = 1; seed <= 50; ++seed) {
    Chance chance(seed);
    const auto channels = static_cast<std::size_t>(chance.between(1, 3.5)),
               samples = static_cast<std::size_t>(chance.between(60, 260));
    std::vector<TrueMode> modes = some_modes(chance, channels);
    std::vector<double> amplitudes;
    for (std::size_t j = 0; j < modes.size(); ++j)
      amplitudes.push_back(chance.is(0.5) ? 1 : chance.between(0, 0.1));
    const MadeChannels made = let_go(modes, amplitudes, samples, 0.06, chance.between(0.001, 0.3), seed);
    Eigenvalues start;
    for (std::size_t j = 0; j < modes.size(); ++j)
      if (chance.is(0.7)) start.push_back(modes[j].eigenvalue() * chance.between(0.98, 1.02));
    const ModalRecord record = made.record();
    const FreeDecay decay = fit_free_decay(record, start);
    said << static_cast<int>(seed) << decay.converged << decay.share << decay.unexplained;
    say(said, decay.modes);
    const Eigen::MatrixXd values = values_of(record);
    const DecayBasis basis(record, values, start);
    said << static_cast<int>(basis.columns()) << static_cast<int>(basis.weakest_mode())
         << power_about(basis, values, record, start).share()
         << power_about(basis, values, record, start).unexplained();
    const auto left = without_oscillations(record, start);
    said << left.front().front() << left.back().back();
    said.end_line();
  }
  said.expect_as_before();
}

TEST(FoundModes, Spectra) {
  Answers said("identify/spectra");
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Chance chance(seed);
    const auto channels = static_cast<std::size_t>(chance.between(1, 3.5)),
               samples = static_cast<std::size_t>(seed == 1 ? 17000 : chance.between(20, 900));
    MadeChannels made{std::vector<std::vector<double>>(channels), chance.between(0.01, 0.1)};
    const double w = chance.between(0.1, 3), size = chance.between(0, 1);
    for (auto& channel : made.values)
      for (std::size_t i = 0; i < samples; ++i)
        channel.push_back(2 + size * std::cos(w * static_cast<double>(i)) + chance.normal());
    ModalRecord record = made.record();
    if (chance.is(0.4)) record.starts.push_back(samples / 3);
    if (chance.is(0.2)) record.starts.push_back(samples / 2);
    said << static_cast<int>(seed);
    for (const std::size_t segments : {1u, 2u, 3u, 16u}) {
      const SpectralMatrix spectrum = spectral_matrix(record, segments);
      say(said, spectrum);
      say(said, spectral_peaks(spectrum));
    }
    const Periodogram powers = periodogram(values_of(record), record, 1 + seed % 4);
    said << powers.step << powers.power.size() << powers.power.front() << powers.power.back();
    said.end_line();
  }
  said.expect_as_before();
}

TEST(FoundModes, AtMostSoManyLags) {
  for (const std::size_t channels : {1u, 3u}) {
    Chance chance(1);
    MadeChannels made{std::vector<std::vector<double>>(channels, std::vector<double>(1000)), 0.01};
    for (auto& channel : made.values)
      for (double& y : channel) y = chance.normal();
    const auto search = search_modes(made.record(), {{0.2, 9}, {40, 9}}, {});
    ASSERT_TRUE(search);
    EXPECT_EQ(search->correlations.lags, static_cast<int>(2 * (240 / channels) - 1));
    EXPECT_EQ(search->correlations.stride, 1);
    EXPECT_EQ(search->highest_order, 40);
  }
}

TEST(FoundModes, Lags) {
  Answers said("identify/lags");
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Chance chance(seed);
    const auto channels = static_cast<std::size_t>(chance.between(1, 4.5)),
               samples = static_cast<std::size_t>(chance.between(60, 500));
    MadeChannels made{std::vector<std::vector<double>>(channels, std::vector<double>(samples)),
                      chance.between(0.01, 0.1)};
    for (auto& channel : made.values)
      for (double& y : channel) y = chance.normal();
    std::vector<SpectralPeak> peaks;
    while (chance.is(0.7)) peaks.push_back({chance.between(0.2, 5), 9});
    const auto search = search_modes(made.record(), peaks,
                                     {.from = chance.is(0.5) ? 0.0 : 1, .to = chance.is(0.5) ? 10.0 : 4});
    if (!search) continue;
    said << static_cast<int>(seed) << search->highest_order << search->correlations.lags
         << search->correlations.stride << search->correlations.block_length
         << search->correlations.sums.size() << search->stable.groups.size();
    say(said, search->stable.poles);
    said.end_line();
  }
  said.expect_as_before();
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
