#include "cromer/tasks/fit/perhaps_held.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "cromer/base/extent.h"
#include "cromer/tasks/fit/spring_constant.h"

namespace cromer::core {

namespace {

Notice perhaps_held_as(Notice how, std::size_t masses) {
  std::string example;
  for (std::size_t i = 1; i <= masses; ++i) example += (i == 1 ? "" : ", ") + std::to_string(100 * i) + " g";
  return Notice{"perhaps_held", {{"how", std::move(how)}, {"example", std::move(example)}}};
}

}  // namespace

Notice perhaps_held(const std::vector<FittedRecording>& runs) {
  if (runs.size() == 1 && !runs.front().succeeded()) {
    const std::size_t levels = levels_at_rest(runs.front().series);
    return levels < 2 ? Notice{} : perhaps_held_as({"rests_at_levels", {{"levels", levels}}}, levels);
  }
  constexpr double much_more = 20;
  double least = HUGE_VAL, most = 0;
  std::vector<double> levels;
  for (const FittedRecording& run : runs) {
    if (run.series.quantity != "position" || run.series.y.empty()) return {};
    const auto [low, high] = extent_of(run.series.y);
    least = std::min(least, (high - low) / 2);
    most = std::max(most, (high - low) / 2);
    levels.push_back((low + high) / 2);
  }
  std::sort(levels.begin(), levels.end());
  if (levels.size() < 2) return {};
  for (std::size_t i = 1; i < levels.size(); ++i)
    if (!(levels[i] - levels[i - 1] > much_more * most)) return {};
  return perhaps_held_as({"runs_lie_apart", {{"least", least}, {"most", most}}}, runs.size());
}

}  // namespace cromer::core
