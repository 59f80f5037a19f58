#include "cromer/tasks/fit/fit_options.h"

#include <cmath>

#include "cromer/identify/motion/motion.h"
#include "cromer/read/samples_between.h"
#include "cromer/tasks/fit/force_options.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {
namespace {

/// Checks that each option of a driven fit is given where it has a meaning, with a value that it can have.
Result<void> check_driven_options(const FitOptions& options) {
  if constexpr (fits_recorded_forces)
    if (const Result<void> good = check_force_options(options); !good) return good;
  if (!is_driven(options)) return {};
  for (const std::string_view unused : unused_if_driven(options))
    return Error{"not_of_a_driven_motion", {{"option", unused}}};
  if (const auto law = law_of(options); !law) return law.error();
  if (!options.drive_frequency.empty())
    if (const auto drive = drive_of(options); !drive) return drive.error();
  return {};
}

}  // namespace

std::optional<BetweenSamples> reading_of(const FitOptions& options) {
  return between_samples_of(options.between_samples);
}

bool law_is_chosen(const FitOptions& options) { return !options.law.empty() && options.law != "auto"; }

Result<std::optional<Law>> law_of(const FitOptions& options) {
  if (!law_is_chosen(options)) return std::optional<Law>{};
  const Result<Law> law = parse_law(options.law);
  if (!law) return law.error();
  if (!options.no_spring) return std::optional<Law>{*law};
  if (law->has<Pendulum>()) return Error{"pendulum_without_spring"};
  return std::optional<Law>{law->without(law_with<Spring>)};
}

Result<std::optional<double>> drive_of(const FitOptions& options) {
  if (options.drive_frequency == "auto") return std::optional<double>{};
  const Result<Quantity> frequency = parse_quantity(options.drive_frequency, "rad/s");
  if (!frequency) return Error{"drive_frequency_or_auto", {{"what", frequency.error().notice}}};
  if (!(frequency->value > 0) || !std::isfinite(frequency->value))
    return Error{"drive_frequency_not_positive", {{"frequency", options.drive_frequency}}};
  return std::optional<double>{frequency->value};
}

std::vector<std::string_view> unused_if_driven(const FitOptions& options) {
  std::vector<std::string_view> unused;
  if (options.segment) unused.emplace_back("segment");
  if (options.segments) unused.emplace_back("segments");
  if (!options.goal.empty()) unused.emplace_back("goal");
  if (options.textbook) unused.emplace_back("textbook");
  return unused;
}

bool is_driven(const FitOptions& options) {
  return !options.force_column.empty() || !options.drive_frequency.empty();
}

Result<void> check_fit_options(const FitOptions& given) {
  FitOptions options = given;
  for (const Option& option : options_of(options))
    if (auto good = check(option); !good) return good;
  if (options.spring_mass && options.mass.empty()) return Error{"spring_mass_alone"};
  if (options.monte_carlo && options.mass.empty()) return Error{"monte_carlo_without_mass"};
  if (options.temperature && !options.disc_diameter) return Error{"temperature_without_disc"};
  if (options.seed_given && !options.monte_carlo) return Error{"seed_without_monte_carlo"};
  if (!options.goal.empty())
    if (const Result<Goal> goal = parse_goal(options.goal); !goal) return goal.error();
  if (const Result<void> good = check_driven_options(options); !good) return good;
  if (const Result<void> good = check_from_before_to(options.from, options.to); !good) return good;
  if (const auto law = law_of(options); !law) return law.error();
  return {};
}

Error unlike_runs(std::string_view option, std::string_view file, std::size_t masses, std::size_t runs) {
  return Error{
      Notice{"masses_unlike_runs", {{"option", option}, {"file", file}, {"masses", masses}, {"runs", runs}}},
      std::string(option)};
}

}  // namespace cromer::core
