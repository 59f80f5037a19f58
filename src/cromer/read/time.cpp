#include "cromer/read/time.h"

#include <cmath>
#include <map>

namespace cromer::core::dialects {
namespace {

/// How many rows were left out for one reason, and where that began.
struct LeftOut {
  std::size_t count = 0;
  long line = 0;

  void add(long at) {
    if (count++ == 0) line = at;
  }
};

/// Whether the times from row i on rise towards `last` for some rows, or to their end: a new start, where a
/// single backward time is a glitch.
bool rises_from(const std::vector<double>& t, std::size_t i, double last) {
  constexpr std::size_t rows = 5;
  double before = t[i];
  std::size_t seen = 0;
  for (std::size_t k = i + 1; k < t.size() && seen < rows; ++k) {
    if (!std::isfinite(t[k])) continue;
    if (t[k] <= before || t[k] >= last) return false;
    before = t[k];
    ++seen;
  }
  return seen > 0;
}

/// Rises from `first` to `last` in `count` rows, and starts again in row i.
bool starts_again(const std::vector<double>& t, std::size_t i, double first, double last, std::size_t count) {
  constexpr std::size_t fewest = 10;
  return count > fewest && t[i] < last && t[i] - first <= 0.1 * (last - first) && rises_from(t, i, last);
}

}  // namespace

std::vector<std::size_t> restarts(const std::vector<double>& t) {
  std::vector<std::size_t> found;
  std::size_t count = 0;
  double first = 0, last = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (!std::isfinite(t[i])) continue;
    const bool again = count > 0 && starts_again(t, i, first, last, count);
    if (again) found.push_back(i);
    if (again || count == 0) {
      first = last = t[i];
      count = 1;
    } else if (t[i] > last) {
      last = t[i];
      ++count;
    }
  }
  return found;
}

std::optional<std::size_t> time_column_of(const Table& table, std::size_t j) {
  const auto& columns = table.columns;
  const auto is_time = [&](std::size_t k) { return k != j && columns[k].quantity == "time"; };
  for (std::size_t k = j; k-- > 0;)
    if (is_time(k) && columns[k].run == columns[j].run) return k;
  for (std::size_t k = j + 1; k < columns.size(); ++k)
    if (is_time(k) && columns[k].run == columns[j].run) return k;
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (is_time(k)) return k;
  return std::nullopt;
}

std::vector<std::optional<std::size_t>> time_columns_of(const Table& table) {
  const auto& columns = table.columns;
  const auto is_time = [&](std::size_t k) { return columns[k].quantity == "time"; };
  std::vector<std::optional<std::size_t>> found(columns.size());
  std::map<int, std::size_t> last_of_run;
  std::size_t times = 0, first = 0, second = 0;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (const auto last = last_of_run.find(columns[j].run); last != last_of_run.end())
      found[j] = last->second;
    if (!is_time(j)) continue;
    last_of_run[columns[j].run] = j;
    if (times++ == 0) first = j;
    if (times == 2) second = j;
  }
  last_of_run.clear();
  for (std::size_t j = columns.size(); j-- > 0;) {
    if (const auto last = last_of_run.find(columns[j].run); !found[j] && last != last_of_run.end())
      found[j] = last->second;
    if (is_time(j)) last_of_run[columns[j].run] = j;
  }
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (found[j] || times == 0) continue;
    if (j != first) found[j] = first;
    if (j == first && times > 1) found[j] = second;
  }
  return found;
}

Result<RisingTimes> keep_rising(const std::vector<double>& t, const std::vector<long>& lines) {
  std::size_t falling = 0, rising = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (t[i] < t[i - 1]) ++falling;
    if (t[i] > t[i - 1]) ++rising;
  }
  if (t.size() > 1 && rising == 0) return Error{falling > 0 ? "time_runs_backward" : "time_stands_still"};
  if (falling > rising) return Error{"time_mostly_backward"};

  RisingTimes result;
  LeftOut repeated, backward;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (result.kept.empty()) {
      result.kept.push_back(i);
      continue;
    }
    const double first = t[result.kept.front()], last = t[result.kept.back()];
    if (t[i] > last) {
      result.kept.push_back(i);
    } else if (t[i] == last) {
      repeated.add(lines[i]);
    } else {
      if (starts_again(t, i, first, last, result.kept.size())) {
        result.notices.push_back(Notice{"time_starts_again", {{"line", lines[i]}, {"rows", t.size() - i}}});
        break;
      }
      backward.add(lines[i]);
    }
  }
  if (repeated.count > 0)
    result.notices.push_back(Notice{"repeated_times", {{"rows", repeated.count}, {"line", repeated.line}}});
  if (backward.count > 0)
    result.notices.push_back(Notice{"backward_times", {{"rows", backward.count}, {"line", backward.line}}});
  return result;
}

}  // namespace cromer::core::dialects
