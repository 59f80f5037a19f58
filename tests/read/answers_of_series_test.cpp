// What is seen in many short series that were made by chance: rounding, spikes, drop-outs, tops cut off.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cromer/base/pi.h"
#include "cromer/read/series_shape.h"
#include "tests/support/answers.h"

namespace cromer::core::dialects {
namespace CROMER_FILE {

struct Series {
  std::vector<double> t, y;
};

/// A swing of size 1 or so, mostly with noise, in even steps of which a few may be longer.
Series some_series(Chance& chance, std::size_t n) {
  Series series;
  const double h = std::pow(10, chance.between(-2.5, -0.5)), w = two_pi * chance.between(0.01, 0.12),
               falls = chance.between(-0.005, 0.02), phase = chance.between(0, 7),
               noise = chance.is(0.3) ? 0 : std::pow(10, chance.between(-5, -0.5)),
               begins = chance.is(0.3) ? chance.between(0, 0.7) * static_cast<double>(n) : 0;
  double time = chance.is(0.5) ? 0 : chance.between(-5, 50);
  for (std::size_t i = 0; i < n; ++i) {
    const double since = static_cast<double>(i) - begins,
                 motion = since < 0 ? 0 : std::exp(-falls * since) * std::cos(w * since + phase);
    series.t.push_back(time);
    series.y.push_back(motion + noise * chance.normal());
    time += h * (chance.is(0.01) ? chance.between(0.3, 6) : 1);
  }
  return series;
}

std::size_t some_place(Chance& chance, std::size_t n, std::size_t near_an_end) {
  if (chance.is(0.6)) return static_cast<std::size_t>(chance.between(0, static_cast<double>(n)));
  const auto from_end = static_cast<std::size_t>(chance.between(0, static_cast<double>(near_an_end)));
  return chance.is(0.5) ? from_end : n - 1 - from_end;
}

double rounded(double value, double step) { return step > 0 ? step * std::nearbyint(value / step) : value; }

TEST(AnswersOfSeries, TheRoundingOfFewValues) {
  Answers said("read/rounding");
  Chance chance(4711);
  for (int i = 0; i < 300; ++i) {
    const double step = std::pow(10, chance.between(-4, 0)),
                 decimal = chance.is(0.5) ? std::pow(10, std::floor(chance.between(-6, 0))) : 0,
                 offset = chance.is(0.5) ? 0 : chance.between(-1e3, 1e3),
                 levels = std::pow(10, chance.between(0, 3));
    std::vector<double> values(static_cast<std::size_t>(chance.between(1, 60)));
    for (double& value : values)
      value = rounded(offset + rounded(step * levels * chance.between(-0.5, 0.5), step), decimal);
    if (chance.is(0.1)) values.front() = std::pow(10, chance.between(3, 30));
    said << rounding_step(values);
    said.end_line();
  }
  said.expect_as_before();
}

TEST(AnswersOfSeries, SpikesOfAnySizeAnywhere) {
  Answers said("read/spikes");
  Chance chance(4712);
  for (int i = 0; i < 300; ++i) {
    const auto n = static_cast<std::size_t>(chance.between(35, 110));
    Series series = some_series(chance, n);
    for (int each = 0; each < 3; ++each)
      series.y[some_place(chance, n, 6)] += (chance.is(0.5) ? 1 : -1) * std::pow(10, chance.between(-4, 0.5));
    const double step = chance.is(0.5) ? 0 : std::pow(10, chance.between(-4, -1));
    for (double& value : series.y) value = rounded(value, step);
    said << spikes(series.t, series.y, series.t[1] - series.t[0], step);
    said.end_line();
  }
  said.expect_as_before();
}

TEST(AnswersOfSeries, StretchesThatTheSensorDidNotSee) {
  Answers said("read/drop_outs");
  Chance chance(4713);
  for (int i = 0; i < 300; ++i) {
    const auto n = static_cast<std::size_t>(chance.between(35, 140));
    Series series = some_series(chance, n);
    for (int each = 0; each < 2; ++each) {
      const std::size_t first = some_place(chance, n, 9),
                        end = std::min(n, first + static_cast<std::size_t>(chance.between(1, 13)));
      const bool flat = chance.is(0.4);
      const double away = (chance.is(0.5) ? 1 : -1) * std::pow(10, chance.between(-1, 1));
      for (std::size_t k = first; k < end; ++k) series.y[k] = away + (flat ? 0 : series.y[k]);
    }
    const double step = chance.is(0.7) ? 0 : std::pow(10, chance.between(-4, -1));
    for (double& value : series.y) value = rounded(value, step);
    for (const DropOut& each : drop_outs(series.t, series.y, series.t[1] - series.t[0], step))
      said << each.first << each.end;
    said.end_line();
  }
  said.expect_as_before();
}

TEST(AnswersOfSeries, TopsThatMayBeCutOff) {
  Answers said("read/tops");
  Chance chance(4714);
  for (int i = 0; i < 300; ++i) {
    const auto n = static_cast<std::size_t>(chance.between(28, 200));
    Series series = some_series(chance, n);
    const double low = chance.is(0.5) ? -9 : -chance.between(0.2, 1.1), high = chance.between(0.2, 1.1),
                 step = chance.is(0.5) ? 0 : std::pow(10, chance.between(-3, 0));
    for (double& value : series.y) value = rounded(std::clamp(value, low, high), step);
    said << !tops_cut_off(series.y, series.t[1] - series.t[0], step).empty();
    said.end_line();
  }
  said.expect_as_before();
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::dialects
