#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "cromer/documents/text.h"
#include "cromer/documents/text/words.h"
#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace {

std::string added_or_dash(const std::optional<double>& value) {
  return value ? fmt::format("{:.4g}", *value) : "-";
}

std::string names_of(const RecognisedMethod& found) {
  std::string names(found.method);
  for (const std::string_view other : found.same_map) names += fmt::format(", {}", other);
  if (found.velocity_ahead) names += " (velocity ahead)";
  return names;
}

}  // namespace

std::string recognise_text(const RecogniseResult& result) {
  std::vector<std::vector<std::string>> rows{
      {"method", "step (s)", "steps a row", "distance", "decay rate added (1/s)", "frequency shift (rad/s)"}};
  for (const RecognisedMethod& found : result.recognised)
    rows.push_back({names_of(found), found.step ? fmt::format("{:.6g}", *found.step) : "any",
                    found.step ? fmt::format("{}", found.steps_per_row) : "-",
                    fmt::format("{:.2g}", found.distance), added_or_dash(found.decay_rate_added),
                    added_or_dash(found.frequency_shift)});
  return in_words(Notice{"answer_as_sentence", {{"what", result.words}}}) + "\n\n" + text_table(rows, 1, 6) +
         in_words(Notice{"what_distances_are", {{"rows", result.rows}, {"rounding", result.rounding}}}) +
         "\n";
}

}  // namespace cromer::core
