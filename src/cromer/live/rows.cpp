#include "cromer/live/rows.h"

#include <cmath>

#include "cromer/base/ascii.h"
#include "cromer/base/number.h"

namespace cromer::core {

std::string plain_heading(std::string text) {
  for (char& c : text)
    if (c == ',' || c == '"' || (c >= 0 && c < ' ')) c = ' ';
  return std::string(trimmed(text));
}

bool is_named(std::string_view heading, std::string_view name) {
  return heading == name || heading.substr(0, heading.find(" (")) == name;
}

double to_microseconds(double t) { return std::round(t * 1e6) / 1e6; }

namespace {

void append_number(std::string& text, double value) {
  char digits[32];
  if (std::isfinite(value))
    text.append(digits, static_cast<std::size_t>(write_shortest(digits, value) - digits));
}

}  // namespace

void append_row(std::string& text, double t, std::span<const double> values) {
  append_number(text, t);
  for (const double value : values) {
    text += ',';
    append_number(text, value);
  }
  text += '\n';
}

std::string_view name(TimesBy by) {
  switch (by) {
    case TimesBy::device:
      return "device";
    case TimesBy::count:
      return "count";
    case TimesBy::rate:
      return "rate";
    case TimesBy::arrival:
      return "arrival";
    case TimesBy::nothing:
      break;
  }
  return "";
}

Notice sentence(const SampleTimes& times) {
  const std::size_t samples = times.by_rate + times.by_arrival;
  switch (times.by) {
    case TimesBy::count:
      return Notice{"times_counted"};
    case TimesBy::rate:
      return Notice{times.by_arrival > 0 ? "times_by_rate_and_arrival" : "times_by_rate",
                    {{"rate", times.rate},
                     {"delay", times.longest_delay},
                     {"by_arrival", times.by_arrival},
                     {"samples", samples}}};
    case TimesBy::arrival:
      return Notice{times.by_rate > 0 ? "times_by_arrival_and_rate" : "times_by_arrival",
                    {{"by_rate", times.by_rate}, {"samples", samples}}};
    case TimesBy::device:
    case TimesBy::nothing:
      break;
  }
  return {};
}

}  // namespace cromer::core
