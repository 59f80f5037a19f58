#include "cromer/tasks/simulate/event_option.h"

#include <algorithm>

#include "cromer/base/quantity.h"

namespace cromer::core {
namespace {

Error wrong(std::string_view text, const Notice& why) {
  return Error{"event_is_wrong", {{"event", text}, {"what", why}}};
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
    return wrong(text, Notice{"no_such_event", {{"event", quantity}}});
  if (has_value == (quantity == "turning-point"))
    return wrong(text, Notice{has_value ? "turning_point_has_no_value" : "event_value_missing"});
  if (has_value) {
    const auto value = parse_quantity(threshold, event.quantity == Event::Quantity::position ? "m" : "m/s");
    if (!value) return wrong(text, value.error().notice);
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
      return wrong(text, rising || falling ? Notice{"rising_and_falling"}
                                           : Notice{"event_word_unknown", {{"word", word}}});
  }
  return event;
}

}  // namespace cromer::core
