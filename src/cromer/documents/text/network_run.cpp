#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/documents/text.h"
#include "cromer/documents/text/words.h"

namespace cromer::core {

namespace {

std::string text_of_run(const NetworkRun& run) {
  const bool angles = run.network.angles;
  std::string text = fmt::format("{}: {} to {:.6g} s {} {:.6g} s\n\n", run.file, run.method, run.outcome.t,
                                 run.takes_steps() ? "in steps of" : "with a state every", run.step);
  std::vector<std::vector<std::string>> rows{
      {angles ? "inertia" : "mass", angles ? "x (rad)" : "x (m)", angles ? "v (rad/s)" : "v (m/s)"}};
  const std::size_t shown = std::min(run.last.size(), most_rows);
  for (std::size_t i = 0; i < shown; ++i)
    // Of -0 this is 0.
    rows.push_back({run.network.masses[i].name, fmt::format("{:.6g}", run.last[i].x + 0.0),
                    fmt::format("{:.6g}", run.last[i].v + 0.0)});
  text += text_table(rows, 1, 3);
  if (shown < run.last.size()) text += fmt::format("and {} more\n", run.last.size() - shown);
  if (!run.energy) return text;
  const NetworkEnergy& energy = *run.energy;
  return text + fmt::format(
                    "\nenergy {:.6g} J at the start, {:.6g} J at the end: drives {:+.6g} J, taken by "
                    "links {:.6g} J, by the method {:+.3g} J\n",
                    energy.start, energy.end, energy.drive, energy.taken, energy.method());
}

}  // namespace

std::string network_text(std::span<const NetworkRun> runs) {
  std::string text;
  for (const NetworkRun& run : runs) text += (text.empty() ? "" : "\n") + text_of_run(run);
  return text;
}

}  // namespace cromer::core
