#include "cromer/live/sample_times.h"

namespace cromer::core {

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
