#include "fit_spring.h"

#include "answer.h"
#include "cromer/documents/csv.h"
#include "cromer/documents/json.h"
#include "cromer/documents/text.h"
#include "cromer/figures/figures.h"
#include "cromer/tasks/open_recording.h"
#include "message.h"

namespace cromer::core::cli {

std::vector<Option> options_of(SpringOptions& o) {
  constexpr std::string_view group = "The spring constant from several masses";
  return {
      {"static", &o.held, "", Range::any,
       "from held extensions: a run, file or plateau for each of --masses, at rest", "the law of a swing",
       group},
      {"mass-line", &o.mass_line, "", Range::any,
       "from the periods: T² against --masses, one for each recording and run; also the spring's own mass",
       "each by itself", group},
      {"masses", &o.masses, "", Range::any, "\"48.4 g, 67.95 g, 87.96 g\", in the order of the recordings",
       "none", group},
      {"gravity", &o.gravity, "m/s^2", Range::positive, "local acceleration of free fall, for --static",
       "9.80665 m/s²", group},
  };
}

Result<void> check(const SpringOptions& options) {
  if (options.held && options.mass_line) return Error{"static_or_mass_line"};
  const char* way = options.held ? "static" : "mass-line";
  if (!options.held && options.gravity) return Error{"gravity_without_static"};
  if (!options.held && !options.mass_line)
    return options.masses.empty() ? Result<void>{} : Error{"masses_without_line"};
  if (options.masses.empty()) return Error{"masses_needed", {{"way", way}}};
  const auto masses = parse_masses(options.masses);
  if (!masses) return masses.error();
  if (masses->size() < 2) return Error{"two_masses_needed", {{"way", way}}};
  return {};
}

int run_static(const std::vector<std::string>& files, const FitOptions& fit, const SpringOptions& options,
               const OutputOptions& output) {
  std::vector<Recording> recordings;
  for (const auto& file : files) {
    auto recording = open_recording(file, fit.read);
    if (!recording) return refuse(recording.error());
    recordings.push_back(*std::move(recording));
  }
  StaticOptions task{fit, options.masses, options.gravity.value_or(Quantity{9.80665, 0})};
  const auto found = fit_static(recordings, task);
  if (!found) return refuse(found.error());
  return give({.text = [&] { return static_text(*found); },
               .json = [&] { return to_json(*found); },
               .csv = [&] { return static_csv(*found); },
               .figure = [&] { return static_figure(*found); },
               .notices = found->notices},
              output);
}

}  // namespace cromer::core::cli
