// W4: the viscous law fitted to 12,000 samples, with covariance; and a recording of five million samples.
//
//   bench_w4                       prints "row, who, seconds"
//   bench_w4 --samples N FILE.csv  writes the recording that it and its peers fit, N samples
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/stopwatch.h"
#include "cromer/identify/law_fit.h"
#include "cromer/identify/least_squares/levenberg_marquardt.h"
#include "cromer/identify/motion/damped_phasor.h"
#include "cromer/identify/start/start_values.h"
#include "cromer/model/sensor.h"
#include "cromer/report/csv.h"

namespace {

using namespace cromer::core;

struct Samples {
  std::vector<double> t, y;
};

// A swing of 5 cm at 6 rad/s, 100 samples a second, noise of 0.3 mm; a sensor's digits.
Samples samples(std::size_t n) {
  Samples result;
  SensorReadings sensor({.noise = 3e-4, .resolution = 1e-6, .offset = 0.2, .seed = 1});
  const double decay_rate = 3 / (0.01 * static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    result.t.push_back(to_15_digits(t));
    result.y.push_back(sensor.next(0.05 * std::exp(-decay_rate * t) * std::cos(6 * t + 0.3)));
  }
  return result;
}

int write(std::size_t n, const char* path) {
  const Samples rows = samples(n);
  std::string text;
  const std::vector<CsvColumn> columns{{"Time (s)", std::span<const double>(rows.t)},
                                       {"Position (m)", std::span<const double>(rows.y)}};
  append_csv(text, columns, {}, true);
  std::FILE* file = std::fopen(path, "wb");
  const bool written = file && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (!file || std::fclose(file) != 0 || !written) {
    std::fprintf(stderr, "bench_w4: cannot write %s\n", path);
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 4 && std::string(argv[1]) == "--samples")
    return write(static_cast<std::size_t>(std::atoll(argv[2])), argv[3]);

  const Samples rows = samples(12000);
  const Record record{rows.t, rows.y, 0};
  const std::optional<StartValues> start = find_start_values(record);
  double sum = 0;
  const std::vector<std::function<void()>> works{
      [&] {
        LeastSquaresOptions options;
        options.scale = std::sqrt(12000.0) * 0.02;
        options.residuals = 12000;
        const LeastSquaresSummary minimum = minimise(DampedPhasor(record), start->phasor, options);
        sum += minimum.parameters[0] + inverse(minimum.equations.matrix, 5)[0][0];
      },
      [&] { sum += find_start_values(record)->phasor[0]; },
      [&] { sum += fit_law(record, {}).decay_rate().standard_error; },
  };
  const char* names[] = {"fit of 12000 samples, start values given", "start values of 12000 samples",
                         "fit of 12000 samples, nothing given"};
  const std::vector<double> seconds = bench::medians(works, 201);
  for (std::size_t i = 0; i < works.size(); ++i) std::printf("%s\tcromer\t%.9g\n", names[i], seconds[i]);
  return std::isfinite(sum) ? 0 : 1;
}
