#include "cromer/tasks/fit/fit_static.h"

#include <algorithm>
#include <cmath>

#include "cromer/tasks/fit/forced_options.h"
#include "cromer/tasks/fit/masses.h"
#include "cromer/tasks/fit/used_samples.h"

namespace cromer::core {
namespace {

Result<std::vector<Series>> runs_of(const NamedBytes& file, const FitOptions& options) {
  const auto recording = read_recording(file.second, file.first, options.read);
  if (!recording) return recording.error();
  // How fast the samples came does not matter to a mass at rest.
  ReadOptions read = options.read;
  const auto& columns = recording->table.columns;
  const bool timed =
      std::any_of(columns.begin(), columns.end(), [](const Column& c) { return c.quantity == "time"; });
  if (!timed && read.rate == 0) read.rate = 1;
  std::vector<Series> found;
  for (const int run : options.run ? std::vector<int>{*options.run} : runs(*recording)) {
    const auto series = take_series(*recording, options.column, run, read);
    if (!series) return series.error();
    auto part = used_part(*series, options);
    if (!part) return part.error();
    found.push_back(*std::move(part));
  }
  return found;
}

/// The first option given that says or asks something of a motion; empty where none does.
std::string_view of_a_motion(const FitOptions& o) {
  if (o.mass || o.spring_mass) return o.mass ? "mass" : "spring-mass";
  if (law_is_chosen(o)) return "law";
  if (o.disc_diameter || o.temperature) return o.disc_diameter ? "disc-diameter" : "temperature";
  if (o.segment || o.segments) return o.segment ? "segment" : "segments";
  if (!o.force_column.empty() || o.hold_out) return o.hold_out ? "hold-out" : "force-column";
  if (!o.drive_frequency.empty()) return "drive-frequency";
  if (o.no_spring || o.hysteresis_exponent != 1) return o.no_spring ? "no-spring" : "hysteresis-exponent";
  if (!o.goal.empty() || o.textbook) return o.textbook ? "textbook" : "goal";
  if (o.seed_given) return "seed";
  return o.monte_carlo ? "monte-carlo" : "";
}

}  // namespace

Result<StaticStiffness> fit_static(const std::vector<NamedBytes>& files, const StaticOptions& options) {
  const auto masses = parse_masses(options.masses);
  if (!masses) return masses.error();
  if (const std::string_view unused = of_a_motion(options.fit); !unused.empty())
    return Error{"no_meaning_with_static", {{"option", unused}}};
  std::vector<Hold> holds;
  std::size_t next = 0;
  for (const NamedBytes& file : files) {
    const auto series = runs_of(file, options.fit);
    if (!series) return series.error();
    const bool plateaus = files.size() == 1 && series->size() == 1;
    const std::size_t count = plateaus ? masses->size() : series->size();
    if (next + count > masses->size())
      return Error{"more_holds_than_masses",
                   {{"masses", masses->size()}, {"file", file.first}, {"runs", series->size()}}};
    const auto first = masses->begin() + static_cast<std::ptrdiff_t>(next);
    const auto found = find_holds(*series, file.first, {first, first + static_cast<std::ptrdiff_t>(count)});
    if (!found) return found.error();
    holds.insert(holds.end(), found->begin(), found->end());
    next += count;
  }
  if (next < masses->size())
    return Error{"more_masses_than_holds", {{"masses", masses->size()}, {"holds", next}}};
  return static_stiffness(std::move(holds), options.gravity);
}

}  // namespace cromer::core
