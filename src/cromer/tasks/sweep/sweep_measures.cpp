#include "cromer/tasks/sweep/sweep_measures.h"

#include <algorithm>

#include "cromer/base/ascii.h"
#include "cromer/base/nearest.h"

namespace cromer::core {

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all{
      {"amplitude",
       true,
       true,
       {"amplitude (m)"},
       [](const PointResult& r, double* to) { to[0] = r.amplitude; }},
      {"phase", true, true, {"phase (rad)"}, [](const PointResult& r, double* to) { to[0] = r.phase_lag; }},
      {"peak", false, true, {"peak (m)"}, [](const PointResult& r, double* to) { to[0] = r.peak; }},
      {"final",
       false,
       false,
       {"x (m)", "v (m/s)"},
       [](const PointResult& r, double* to) { to[0] = r.end.x, to[1] = r.end.v; }},
      {"mean", true, true, {"mean (m)"}, [](const PointResult& r, double* to) { to[0] = r.mean; }},
      {"rms", true, true, {"rms (m)"}, [](const PointResult& r, double* to) { to[0] = r.rms; }},
      {"energy", false, true, {"energy (J)"}, [](const PointResult& r, double* to) { to[0] = r.energy; }},
  };
  return all;
}

Result<std::vector<const Measure*>> find_measures(const std::vector<std::string>& names, bool driven) {
  std::vector<std::string> words;
  for (const std::string& name : names)
    for (std::size_t from = 0; from <= name.size();) {
      const std::size_t comma = std::min(name.find(',', from), name.size());
      words.emplace_back(trimmed(std::string_view(name).substr(from, comma - from)));
      from = comma + 1;
    }
  if (words.empty())
    words = driven ? std::vector<std::string>{"amplitude", "phase"}
                   : std::vector<std::string>{"peak", "final", "energy"};

  std::vector<std::string_view> known;
  for (const Measure& measure : measures()) known.push_back(measure.name);
  std::vector<const Measure*> found;
  for (const std::string& word : words) {
    const auto at = std::find(known.begin(), known.end(), word);
    if (at == known.end()) {
      const std::string near = nearest(word, known);
      return Error{"no_such_measure",
                   {{"typed", word},
                    {"near", near.empty() ? Notice{} : Notice{"perhaps_measure", {{"near", near}}}},
                    {"measures", std::vector<std::string>(known.begin(), known.end())}}};
    }
    const Measure* measure = &measures()[static_cast<std::size_t>(at - known.begin())];
    if (std::find(found.begin(), found.end(), measure) != found.end())
      return Error{"measure_twice", {{"measure", word}}};
    if (measure->of_settled_motion && !driven) return Error{"measure_undriven", {{"measure", word}}};
    found.push_back(measure);
  }
  return found;
}

}  // namespace cromer::core
