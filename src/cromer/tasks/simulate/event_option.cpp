#include "cromer/tasks/simulate/event_option.h"

#include <fmt/format.h>

#include <algorithm>

#include "cromer/base/quantity.h"

namespace cromer::core {
namespace {

Error wrong(std::string_view text, std::string_view why) {
  return Error{
      fmt::format("--event \"{}\": {}; expected position=VALUE, velocity=VALUE or turning-point, then "
                  "any of :rising, :falling and :stop, for instance \"position=1 cm:falling:stop\"",
                  text, why)};
}

/// Cuts the part up to the next separator off the text.
std::string_view take(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

}  // namespace

Result<Event> parse_event(std::string_view text) {
  Event event;
  std::string_view words = text;
  std::string_view threshold = take(words, ':');
  const bool has_value = threshold.find('=') != std::string_view::npos;
  const std::string_view quantity = take(threshold, '=');
  if (quantity == "position")
    event.quantity = Event::Quantity::position;
  else if (quantity != "velocity" && quantity != "turning-point")
    return wrong(text, fmt::format("\"{}\" is no event that can be watched", quantity));
  if (has_value == (quantity == "turning-point"))
    return wrong(text, has_value ? "a turning point has no value" : "the value is missing");
  if (has_value) {
    const auto value = parse_quantity(threshold, event.quantity == Event::Quantity::position ? "m" : "m/s");
    if (!value) return wrong(text, value.error().message);
    event.value = value->value;
  }
  while (!words.empty()) {
    const std::string_view word = take(words, ':');
    const bool rising = word == "rising", falling = word == "falling";
    if (word == "stop")
      event.stop = true;
    else if ((rising || falling) && event.crossing == Crossing::any)
      event.crossing = rising ? Crossing::rising : Crossing::falling;
    else
      return wrong(text, rising || falling ? "only one of rising and falling; without them both count"
                                           : fmt::format("\"{}\" is not known", word));
  }
  return event;
}

}  // namespace cromer::core
