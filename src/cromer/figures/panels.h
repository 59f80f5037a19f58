// The panels of a figure of motions, as --panels asks for them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/report/figure.h"
#include "cromer/result.h"

namespace cromer::core {

/// Displacement, velocity, or kinetic plus potential energy against time; velocity against displacement, the
/// phase portrait.
enum class MotionPanel { position, velocity, energy, phase };

/// Their names, separated by commas, as --help has them.
inline constexpr std::string_view panels_help =
    "panels of the plot, one under the other, in this order: position, velocity, energy (kinetic plus "
    "potential), each against time, and phase (the phase portrait: velocity against position)";

/// "position,velocity" in that order; empty: position alone. An Error names a panel that does not exist, with
/// the nearest that does, or one that stands twice.
Result<std::vector<MotionPanel>> parse_panels(std::string_view names);

/// "Position, velocity and energy against time and the phase portrait".
std::string panels_in_words(std::span<const MotionPanel> panels);

/// The symbol that suits an energy, and what it is in the SI unit: J, mJ or µJ.
struct EnergyUnit {
  std::string_view symbol;
  double joules;
};
EnergyUnit energy_unit(double largest);

/// The symbol that suits times, and what it is in seconds: s, ms or µs.
struct TimeUnit {
  std::string_view symbol;
  double seconds;
};
TimeUnit time_unit(double duration);

/// The name of a file without its folders; a long one is cut in the middle.
std::string short_name(std::string_view file);

/// "1 sample", "12 samples".
std::string samples_in_words(std::size_t samples);

/// Two periods after the first value beyond `height`, where the line of a motion that leaves the frame is to
/// end, as an index; their number if none is beyond. `t` and `values` of the same length.
std::size_t end_of_line(const std::vector<double>& t, const std::vector<double>& values, double height,
                        double period);

/// What is said of a motion that grows without end.
inline constexpr const char* grows = "grows without end";

/// Takes the names off the curves of a grid of small panels; its key has each once.
void move_names_to_key(Figure& figure);

/// Which stretches of a motion from `begin` to `end` [s] a phase portrait shows: of many periods the first
/// and the last ones, because rings upon rings would fill it.
struct PortraitPart {
  double first_until, last_from;  // [s]
  std::string title;              ///< "Phase portrait of the first 5 and the last 3 periods"

  bool has(double t) const { return t <= first_until || t >= last_from; }
};
PortraitPart portrait_part(double begin, double end, double period);

/// Gives a figure that is one portrait the size of one, with the names inside.
void set_portrait_size(Figure& figure);

}  // namespace cromer::core
