#include "cromer/documents/text.h"

#include <fmt/format.h>

#include <vector>

#include "cromer/documents/text/words.h"

namespace cromer::core {

std::string static_text(const StaticStiffness& found) {
  std::vector<std::vector<std::string>> rows{
      {"file", "run", "from (s)", "to (s)", "samples", "mass", "position"}};
  for (const Hold& hold : found.holds)
    rows.push_back({hold.file, fmt::format("{}", hold.run), fmt::format("{:.6g}", hold.from),
                    fmt::format("{:.6g}", hold.to), fmt::format("{}", hold.samples),
                    format_quantity(hold.mass, "kg"),
                    format_quantity({hold.position, hold.standard_error}, "m")});
  std::string out = text_table(rows, 1, 5);
  out += fmt::format("stiffness  {}, 95 % {} N/m (with g = {})\n", in_words(found.stiffness, "N/m"),
                     interval_text(found.stiffness.low, found.stiffness.high),
                     format_quantity(found.gravity, "m/s²"));
  return out;
}

std::string mass_line_text(const MassLine& line) {
  return fmt::format(
      "T² against mass, {} recordings: stiffness {}, 95 % {} N/m; moving along {}, so a spring of {}\n",
      line.points.size(), in_words(line.stiffness, "N/m"),
      interval_text(line.stiffness.low, line.stiffness.high), in_words(line.effective_mass, "kg"),
      in_words(line.spring_mass, "kg"));
}

}  // namespace cromer::core
