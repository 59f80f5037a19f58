// generated_series COUNT [SEED [show]]: fits of series that no oscillator made, or hardly; which took
// longest.
//
// Every fit must end: the exit status is 1 where one takes more than ten seconds of processor time, and those
// of more than two are listed; or where a sentence has a number that is none. Ten thousand take about a
// quarter of an hour.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <regex>
#include <string>
#include <vector>

#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/fit/fit.h"

namespace {

using Engine = std::mt19937_64;

double uniform(Engine& engine, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(engine);
}
double log_uniform(Engine& engine, double low, double high) {
  return std::exp(uniform(engine, std::log(low), std::log(high)));
}
double normal(Engine& engine) { return std::normal_distribution<double>()(engine); }
bool chance(Engine& engine, double share) { return uniform(engine, 0, 1) < share; }

std::vector<double> times_of(Engine& engine, std::size_t n) {
  std::vector<double> t(n);
  const double step = log_uniform(engine, 1e-4, 10);
  const bool uneven = chance(engine, 0.2), gaps = chance(engine, 0.1);
  double now = 0;
  for (double& each : t) {
    each = now;
    now += step * (uneven ? uniform(engine, 0.1, 2) : 1) * (gaps && chance(engine, 0.02) ? 50 : 1);
  }
  return t;
}

std::vector<double> values_of(Engine& engine, const std::vector<double>& t) {
  const std::size_t n = t.size();
  std::vector<double> y(n, 0.0);
  const double step = t[1] - t[0], duration = t.back() - t.front();
  // Some of several ingredients.
  if (chance(engine, 0.6)) {
    const double w = log_uniform(engine, 1 / duration, 4 / step),
                 g = chance(engine, 0.5) ? 0 : log_uniform(engine, 0.1, 20) / duration;
    const double bend = chance(engine, 0.3) ? uniform(engine, -0.5, 0.5) : 0;
    for (std::size_t i = 0; i < n; ++i)
      y[i] += std::exp(-g * t[i]) * std::cos(w * t[i] * (1 + bend * t[i] / duration));
  }
  if (chance(engine, 0.2)) {
    const double w = log_uniform(engine, 1 / duration, 4 / step), size = log_uniform(engine, 0.01, 10);
    for (std::size_t i = 0; i < n; ++i) y[i] += size * std::sin(w * t[i]);
  }
  if (chance(engine, 0.7)) {
    const double size = log_uniform(engine, 1e-4, 3),
                 memory = chance(engine, 0.5) ? 0 : uniform(engine, 0.5, 1);
    double noise = 0;
    for (double& each : y) each += noise = memory * noise + size * normal(engine);
  }
  if (chance(engine, 0.15))
    for (std::size_t i = 0; i < n; ++i) y[i] += std::pow(t[i] / duration, uniform(engine, 1, 1.001)) * 5;
  if (chance(engine, 0.1))
    for (std::size_t i = n / 2; i < n; ++i) y[i] += 3;
  if (chance(engine, 0.1)) y[n / 3] = chance(engine, 0.5) ? 1e6 : 1e30;
  if (chance(engine, 0.1))
    for (double& each : y) each = each > 0 ? 1 : -1;
  if (chance(engine, 0.1))
    for (std::size_t i = 0; i < n; ++i) y[i] *= std::exp(uniform(engine, 0, 3) * t[i] / duration);
  const double scale = chance(engine, 0.15) ? log_uniform(engine, 1e-15, 1e15) : 1;
  const double rounding = chance(engine, 0.2) ? log_uniform(engine, 1e-3, 1) : 0;
  for (double& each : y) {
    if (rounding > 0) each = rounding * std::round(each / rounding);
    each *= scale;
  }
  return y;
}

std::string file_of(unsigned long seed) {
  Engine engine(seed);
  const auto n = static_cast<std::size_t>(log_uniform(engine, 9, 800));
  const std::vector<double> t = times_of(engine, n), y = values_of(engine, t);
  std::string text = "t (s),x (m)\n";
  for (std::size_t i = 0; i < n; ++i)
    text += cromer::core::shortest(t[i]) + "," + cromer::core::shortest(y[i]) + "\n";
  return text;
}

/// The first sentence with a number that is none.
std::string nonsense_in(const std::vector<cromer::core::FittedRecording>& fits) {
  static const std::regex number("(^|[^a-zA-Z])(inf|nan)([^a-zA-Z]|$)");
  for (const cromer::core::FittedRecording& fit : fits) {
    std::vector<std::string> said = cromer::core::in_words(fit.notices);
    said.push_back(cromer::core::in_words(fit.fit.message));
    for (const std::string& sentence : said)
      if (std::regex_search(sentence, number)) return sentence;
  }
  return {};
}

}  // namespace

int main(int count, char** words) {
  const unsigned long many = count > 1 ? std::strtoul(words[1], nullptr, 10) : 100;
  const unsigned long first = count > 2 ? std::strtoul(words[2], nullptr, 10) : 1;
  constexpr double listed = 2, most = 10;  // [s]
  double total = 0, slowest = 0;
  int too_long = 0, nonsense = 0;
  for (unsigned long seed = first; seed < first + many; ++seed) {
    const std::string file = file_of(seed);
    if (count > 3) {  // only shown
      fmt::print("{}", file);
      continue;
    }
    cromer::core::FitOptions options;
    if (seed % 4 == 0) options.law = "viscous";
    if (seed % 10 == 1) options.drive_frequency = "auto";
    const std::clock_t begin = std::clock();
    const auto fits =
        cromer::core::fit(*cromer::core::read_recording(file, "generated.csv", options.read), options);
    const double took = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    total += took;
    if (const std::string sentence = fits ? nonsense_in(*fits) : ""; !sentence.empty()) {
      ++nonsense;
      fmt::print("series {}: {}\n", seed, sentence);
    }
    slowest = std::max(slowest, took);
    too_long += took > listed;
    if (took <= listed) continue;
    fmt::print("series {} took {:.1f} s{}{}\n", seed, took, options.law == "viscous" ? ", --law viscous" : "",
               options.drive_frequency.empty() ? "" : ", --drive-frequency auto");
    std::fflush(stdout);
  }
  fmt::print("{} series in {:.0f} s, the slowest in {:.2f} s, {} over {} s\n", many, total, slowest, too_long,
             listed);
  return slowest > most || nonsense > 0 ? 1 : 0;
}
