// Which run each column of a table belongs to.
#include <algorithm>
#include <map>
#include <set>

#include "cromer/base/concat.h"
#include "cromer/read/columns.h"
#include "cromer/read/set.h"

namespace cromer::core::dialects {
namespace {

/// The label of each column's run as the header has it; a column without one belongs to its neighbours: a
/// time to what follows, anything else to what stands before it.
std::vector<std::string> column_labels(const std::vector<Column>& columns, const Header& header) {
  const std::size_t count = columns.size();
  std::vector<std::string> own(count), before(count), behind(count);
  for (std::size_t j = 0; j < count; ++j) {
    if (j < header.headings.size()) own[j] = header.headings[j].run;
    before[j] = own[j].empty() && j > 0 ? before[j - 1] : own[j];
  }
  for (std::size_t j = count; j-- > 0;) behind[j] = own[j].empty() && j + 1 < count ? behind[j + 1] : own[j];
  for (std::size_t j = 0; j < count; ++j) {
    const bool to_the_right = before[j].empty() || (columns[j].quantity == "time" && !behind[j].empty());
    if (own[j].empty()) own[j] = to_the_right ? behind[j] : before[j];
  }
  return own;
}

}  // namespace

void number_runs(Recording& recording, const Header& header) {
  auto& columns = recording.table.columns;
  const std::size_t named = std::min(columns.size(), header.headings.size());
  const auto is_time = [&](std::size_t j) { return columns[j].quantity == "time"; };
  const std::vector<std::string> label = column_labels(columns, header);
  std::vector<std::string> labels;                               // of the runs
  std::map<std::string, int> run_of_label;                       // the last of that label
  std::map<std::string, std::set<std::string>> titles_of_label;  // in that run
  for (std::size_t from = 0, to; from < columns.size(); from = to) {
    // A group of columns goes together: a time and what was measured at it.
    const std::string& group = label[from];
    std::set<std::string> titles;
    for (to = from; to < columns.size() && label[to] == group; ++to) {
      if (to > from && is_time(to) && is_time(from)) break;
      if (to < named && !titles.insert(column_title(columns[to])).second) break;
    }
    if (is_time(from)) titles.erase(column_title(columns[from]));
    // A name that repeats begins the next run; a time that repeats, with other names behind it, does not.
    std::set<std::string>& known = titles_of_label[group];
    const bool repeated = std::any_of(titles.begin(), titles.end(),
                                      [&](const std::string& title) { return known.count(title) > 0; });
    if (repeated || run_of_label.count(group) == 0) {
      labels.push_back(group);
      run_of_label[group] = static_cast<int>(labels.size());
      known.clear();
    }
    known.insert(titles.begin(), titles.end());
    for (std::size_t j = from; j < to; ++j) columns[j].run = run_of_label[group];
  }
  say_labels(labels, recording.notices);
}

}  // namespace cromer::core::dialects
