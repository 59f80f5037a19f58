// W3: response spectra of one recording of 4000 samples in 1000 periods, one core.
//
//   bench_w3                       prints "row, who, seconds"
//   bench_w3 --recording FILE.csv  writes the recording that it and its peers take
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "bench/stopwatch.h"
#include "cromer/ensemble/dispatch.h"
#include "cromer/ensemble/response_peaks.h"
#include "cromer/ensemble/rotated_peaks.h"
#include "cromer/report/csv.h"

namespace {

using namespace cromer::core;
using cromer::BetweenSamples;
using cromer::Peaks;

constexpr std::size_t samples = 4000, periods = 1000;
constexpr double spacing = 0.01;

/// Noise under an envelope that rises and falls, as an earthquake's [m/s^2].
std::vector<double> shaking(unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> a(samples);
  double smooth = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = spacing * static_cast<double>(i);
    smooth = 0.8 * smooth + normal(random);
    a[i] = smooth * t * std::exp(-t / 6);
  }
  return a;
}

int write(const char* path) {
  std::vector<double> t(samples);
  for (std::size_t i = 0; i < samples; ++i) t[i] = static_cast<double>(i) / 100;
  const std::vector<double> a = shaking(1);
  const std::vector<CsvColumn> columns{{"Time (s)", std::span<const double>(t)},
                                       {"acceleration (m/s²)", std::span<const double>(a)}};
  std::string text;
  append_csv(text, columns, {}, true);
  std::FILE* file = std::fopen(path, "wb");
  const bool written = file && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (!file || std::fclose(file) != 0 || !written) {
    std::fprintf(stderr, "bench_w3: cannot write %s\n", path);
    return 1;
  }
  return 0;
}

/// From 0.1 to 10 s: at least ten samples a period, as the peers walk them.
std::vector<LinearLaw<double>> laws() {
  std::vector<LinearLaw<double>> all;
  for (std::size_t i = 0; i < periods; ++i) {
    const double w = 2 * std::numbers::pi / (0.1 * std::pow(100.0, static_cast<double>(i) / (periods - 1)));
    all.push_back({.decay_rate = 0.05 * w, .stiffness = w * w});
  }
  return all;
}

/// The walk alone: as many filters as lanes, over and over.
struct Kernel {
  cromer_walk::Filters filters{};
  std::vector<cromer_walk::Block> blocks;
  cromer_walk::Walk walk;

  Kernel(const std::vector<double>& force, const std::vector<LinearLaw<double>>& all)
      : walk{.force = force.data(), .samples = force.size()} {
    blocks.resize(walk.blocks());
    for (std::size_t i = 0; i < cromer_walk::lanes; ++i) {
      const auto filter =
          response_filter(interval_map(all[i * (periods / cromer_walk::lanes)], spacing, false),
                          ResponseQuantity<double>{1, 0});
      filters.decay.of[i] = filter.decay;
      filters.kappa.of[i] = filter.kappa;
      filters.e0.of[i] = filter.e0;
      filters.e2.of[i] = filter.e2;
    }
  }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::string(argv[1]) == "--recording") return write(argv[2]);

  const std::vector<double> a = shaking(1), b = shaking(2);
  const std::vector<LinearLaw<double>> all = laws();
  const GroundMotion ground{a, spacing, BetweenSamples::linear}, across{b, spacing, BetweenSamples::linear};
  Kernel kernel(a, all);
  double sum = 0;
  std::vector<std::function<void()>> works;
  std::vector<std::string> rows;
  std::vector<double> per;
  for (const KernelUnit& unit : units_here()) {
    works.emplace_back([&kernel, &sum, walk = unit.walk.walk] {
      walk(kernel.filters, kernel.walk, kernel.blocks.data());
      sum += kernel.blocks.back().high.of[0];
    });
    rows.push_back("a sample of an oscillator, " + std::string(unit.name));
    per.push_back(static_cast<double>((samples - 1) * cromer_walk::lanes));
  }
  const auto fastest = choose_unit()->walk;
  for (const auto& [name, peaks] : {std::pair{"peaks at the samples", Peaks::samples},
                                    std::pair{"continuous peaks", Peaks::continuous}}) {
    works.emplace_back([&, peaks = peaks] {
      for (const auto& found : response_peaks(
               ground, all, {.peaks = peaks, .after_the_end = peaks == Peaks::continuous, .unit = fastest}))
        sum += found.overall();
    });
    rows.push_back(std::string("1000 periods, 4000 samples, ") + name);
    per.push_back(1);
  }
  works.emplace_back([&] {
    for (const auto& found : rotated_peaks(ground, across, std::span(all).first(100), Peaks::samples))
      sum += found.median;
  });
  rows.emplace_back("RotD50 and RotD100 of 100 periods");
  per.push_back(1);

  const std::vector<double> seconds = bench::medians(works, 51);
  for (std::size_t i = 0; i < works.size(); ++i)
    std::printf("%s\tcromer\t%.9g\n", rows[i].c_str(), seconds[i] / per[i]);
  return std::isfinite(sum) ? 0 : 1;
}
