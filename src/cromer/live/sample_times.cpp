#include "cromer/live/sample_times.h"

#include <fmt/format.h>

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

std::string sentence(const SampleTimes& times) {
  switch (times.by) {
    case TimesBy::count:
      return "times: counted, at the rate of --rate";
    case TimesBy::rate: {
      std::string text =
          fmt::format("times: by the steady rate that was found, {:.7g}/s; delays up to {:.2g} s", times.rate,
                      times.longest_delay);
      if (times.by_arrival > 0)
        text += fmt::format("; {} of {} by arrival", times.by_arrival, times.by_rate + times.by_arrival);
      return text;
    }
    case TimesBy::arrival: {
      std::string text = "times: those of arrival; no steady rate was found";
      if (times.by_rate > 0)
        text += fmt::format(" for long; {} of {} by one", times.by_rate, times.by_rate + times.by_arrival);
      return text;
    }
    case TimesBy::device:
    case TimesBy::nothing:
      break;
  }
  return "";
}

}  // namespace cromer::core
