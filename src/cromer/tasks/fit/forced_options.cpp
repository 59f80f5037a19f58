#include "cromer/tasks/fit/forced_options.h"

#include <fmt/format.h>

#include <cmath>

namespace cromer::core {

std::optional<BetweenSamples> reading_of(const FitOptions& options) {
  return between_samples_of(options.between_samples);
}

bool law_is_chosen(const FitOptions& options) { return !options.law.empty() && options.law != "auto"; }

Result<std::optional<Law>> law_of(const FitOptions& options) {
  if (!law_is_chosen(options)) return std::optional<Law>{};
  const Result<Law> law = parse_law(options.law);
  if (!law) return law.error();
  if (!options.no_spring) return std::optional<Law>{*law};
  if (law->has<Pendulum>())
    return Error{"--no-spring and --law pendulum exclude each other: a pendulum's weight is its spring"};
  return std::optional<Law>{law->without(law_with<Spring>)};
}

Result<std::optional<double>> drive_of(const FitOptions& options) {
  if (options.drive_frequency == "auto") return std::optional<double>{};
  const Result<Quantity> frequency = parse_quantity(options.drive_frequency, "rad/s");
  if (!frequency)
    return Error{"--drive-frequency: " + frequency.error().message + "; or auto, to find it in the record"};
  if (!(frequency->value > 0) || !std::isfinite(frequency->value))
    return Error{fmt::format("--drive-frequency {}: it must be positive", options.drive_frequency)};
  return std::optional<double>{frequency->value};
}

std::vector<std::string_view> unused_if_driven(const FitOptions& options) {
  std::vector<std::string_view> unused;
  if (options.segment) unused.emplace_back("--segment");
  if (options.segments) unused.emplace_back("--segments");
  if (!options.goal.empty()) unused.emplace_back("--goal");
  if (options.textbook) unused.emplace_back("--textbook");
  return unused;
}

bool is_driven(const FitOptions& options) {
  return !options.force_column.empty() || !options.drive_frequency.empty();
}

Result<void> check_forced_options(const FitOptions& options) {
  if (!options.force_column.empty() && !options.drive_frequency.empty())
    return Error{
        "--force-column and --drive-frequency exclude each other: the drive is recorded, or it is "
        "harmonic"};
  if (!options.between_samples.empty()) {
    if (options.force_column.empty())
      return Error{
          "--between-samples needs --force-column: only a recorded force has anything between its "
          "samples"};
    if (!reading_of(options) && options.between_samples != "auto")
      return Error{fmt::format("--between-samples: \"{}\" is none of linear, hold, band-limited and auto",
                               options.between_samples)};
  }
  if (options.hold_out) {
    if (options.force_column.empty())
      return Error{"--hold-out needs --force-column: only a motion whose force is known can be foretold"};
    if (!(*options.hold_out > 0 && *options.hold_out <= 0.9))
      return Error{fmt::format("--hold-out {}: it must lie above 0 and at most at 90 %", *options.hold_out)};
  }
  if (!is_driven(options)) return {};
  for (const std::string_view unused : unused_if_driven(options))
    return Error{fmt::format(
        "{} cannot be had of a driven motion, whose amplitude the drive keeps up; fit a free decay, for "
        "instance a part of the record after the drive has stopped, by --from and --to",
        unused)};
  if (const auto law = law_of(options); !law) return law.error();
  if (!options.drive_frequency.empty())
    if (const auto drive = drive_of(options); !drive) return drive.error();
  return {};
}

}  // namespace cromer::core
