#include "cromer/read/dialect_name.h"

#include <algorithm>
#include <array>

#include "cromer/read/column_kind.h"
#include "cromer/read/formats/tracker.h"

namespace cromer::core::dialects {
namespace {

bool is_datastudio(const Header& header) {
  return std::any_of(header.titles.begin(), header.titles.end(), [](const std::string& title) {
    return title.find(", Run #") != std::string::npos || title.find(", Ch") != std::string::npos;
  });
}

bool is_capstone(const Header& header) {
  return std::any_of(header.headings.begin(), header.headings.end(),
                     [](const Heading& heading) { return heading.run.starts_with("Run #"); });
}

bool has_prefix(const Header& header, std::string_view beginning) {
  return std::any_of(header.headings.begin(), header.headings.end(),
                     [&](const Heading& heading) { return heading.prefix.starts_with(beginning); });
}

bool is_phyphox(const Header& header) {
  constexpr std::array<std::string_view, 6> sensors{"gyroscope",    "rotation",      "linearacceleration",
                                                    "acceleration", "magneticfield", "absolute"};
  if (header.headings.size() < 2 || header.headings[0].name != "Time" || header.headings[0].unit != "s")
    return false;
  return std::any_of(header.headings.begin() + 1, header.headings.end(), [&](const Heading& heading) {
    const std::string name = plain_name(heading.name);
    return std::any_of(sensors.begin(), sensors.end(), [&](std::string_view sensor) {
      const bool component =
          name.size() == sensor.size() + 1 && name.find_first_of("xyz", sensor.size()) == sensor.size();
      return name.starts_with(sensor) && (component || (header.quoted && sensor == "absolute"));
    });
  });
}

}  // namespace

std::string_view dialect_name(const Header& header) {
  if (is_datastudio(header)) return "DataStudio";
  if (has_prefix(header, "Data Set")) return "Graphical Analysis";
  if (has_prefix(header, "Latest") || has_prefix(header, "Run ") || has_prefix(header, "Remote Data"))
    return "Logger Pro";
  if (is_capstone(header)) return "PASCO Capstone";
  if (is_tracker(header)) return "Tracker";
  if (is_phyphox(header)) return "phyphox";
  return "plain";
}

}  // namespace cromer::core::dialects
