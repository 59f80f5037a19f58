#include "cromer/documents/text.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "cromer/documents/text/words.h"
#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace {

std::string number_or_dash(double value) { return std::isnan(value) ? "-" : fmt::format("{:.7g}", value); }

std::string every_row(const SweepResult& result) {
  const std::size_t width = result.plan.rows.columns.size() - 1;
  const std::vector<SweptOption>& swept = result.plan.swept;
  std::vector<std::vector<std::string>> rows{
      {result.plan.rows.columns.begin(), result.plan.rows.columns.end() - 1}};
  for (std::size_t i = 0; i < swept.size(); ++i) rows[0][i] = swept[i].shown;
  for (std::size_t at = 0; at < result.rows.size(); at += width) {
    std::vector<std::string> row;
    for (std::size_t i = 0; i < width; ++i)
      row.push_back(number_or_dash(result.rows[at + i] / (i < swept.size() ? swept[i].shown_unit : 1)));
    rows.push_back(std::move(row));
  }
  return text_table(rows, 0, width);
}

std::string extremes(const SweepResult& result) {
  const std::size_t width = result.plan.rows.columns.size() - 1, swept = result.plan.swept.size();
  std::vector<std::vector<std::string>> rows{{"measure", "smallest", "at", "largest", "at"}};
  for (std::size_t column = swept; column < width; ++column) {
    std::size_t low = result.rows.size(), high = low;
    for (std::size_t at = 0; at < result.rows.size(); at += width) {
      const double value = result.rows[at + column];
      if (std::isnan(value)) continue;
      if (low == result.rows.size() || value < result.rows[low + column]) low = at;
      if (high == result.rows.size() || value > result.rows[high + column]) high = at;
    }
    if (low == result.rows.size()) {
      rows.push_back({result.plan.rows.columns[column], "-", "", "-", ""});
      continue;
    }
    const auto where = [&](std::size_t at) {
      std::string text;
      for (std::size_t i = 0; i < swept; ++i)
        text += (i ? ", " : "") + number_or_dash(result.rows[at + i] / result.plan.swept[i].shown_unit);
      return text;
    };
    rows.push_back({result.plan.rows.columns[column], number_or_dash(result.rows[low + column]), where(low),
                    number_or_dash(result.rows[high + column]), where(high)});
  }
  return text_table(rows, 1, 4);
}

}  // namespace

std::string sweep_method_text(const SweepPlan& plan) {
  return fmt::format("{}, {}{}{}", plan.method, in_words(plan.way), plan.steps.empty() ? "" : ", ",
                     in_words(plan.steps));
}

std::string sweep_text(const SweepResult& result) {
  const SweepPlan& plan = result.plan;
  std::string text = fmt::format("{} point{} by {}\n", plan.rows.rows, plan.rows.rows == 1 ? "" : "s",
                                 sweep_method_text(plan));
  for (const SweptOption& option : plan.swept)
    text += fmt::format("  {}: {} value{}\n", option.shown, option.points, option.points == 1 ? "" : "s");
  if (result.interrupted) text += fmt::format("interrupted: {} of {} points\n", result.done, plan.rows.rows);
  if (result.check && result.check->points > 0)
    text += fmt::format("stepping {} of them until they settle gives the same amplitude to {:.1g}\n",
                        result.check->points, result.check->difference);
  if (result.check && result.check->left_out > 0)
    text +=
        fmt::format("{} of the points looked at could not be checked; the first is row {}: {}\n",
                    result.check->left_out, result.check->first_left_out + 1, in_words(result.check->why));
  if (result.rows.empty()) return text + "they are in the file; too many to look through here\n";
  return text + "\n" + (plan.rows.rows <= most_rows ? every_row(result) : extremes(result));
}

}  // namespace cromer::core
