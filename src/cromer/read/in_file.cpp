#include "cromer/read/in_file.h"

#include <algorithm>
#include <optional>
#include <string>
#include <variant>

namespace cromer::core {
namespace {

struct InLine {
  long long line;
  Notice what;
};

/// A notice of in_line taken apart.
std::optional<InLine> taken_apart(const Notice& notice) {
  if (notice.code != "in_line") return std::nullopt;
  return InLine{std::get<long long>(notice.values.at(0).value),
                std::get<std::vector<Notice>>(notice.values.at(1).value).front()};
}

}  // namespace

Error in_line(long line, const Error& error) { return in_line(line, error.notice); }

Error in_line(long line, Notice what) {
  return Error{"in_line", {{"line", line}, {"what", std::move(what)}}};
}

Error in_file(std::string_view file, const Error& error) {
  return {in_file(file, error.notice), error.argument};
}

Notice in_file(std::string_view file, Notice what) {
  if (auto of = taken_apart(what))
    return Notice{"in_file_line", {{"file", file}, {"line", of->line}, {"what", std::move(of->what)}}};
  return Notice{"in_file", {{"file", file}, {"what", std::move(what)}}};
}

Notice in_member(std::string_view member, Notice what) {
  if (auto of = taken_apart(what))
    return Notice{"in_member_line", {{"member", member}, {"line", of->line}, {"what", std::move(of->what)}}};
  return Notice{"in_member", {{"member", member}, {"what", std::move(what)}}};
}

Notice without_file(const Notice& notice, std::string_view file) {
  const bool in_file = notice.code == "in_file", of_line = notice.code == "in_file_line";
  if (!(in_file || of_line) || std::get<std::string>(notice.values.at(0).value) != file) return notice;
  const Notice& what = std::get<std::vector<Notice>>(notice.values.back().value).front();
  return of_line ? in_line(std::get<long long>(notice.values.at(1).value), what).notice : what;
}

Notice in_run(int run, Notice what) { return Notice{"in_run", {{"run", run}, {"what", std::move(what)}}}; }

void OfRuns::say(int run, const Notice& what) {
  const auto before =
      std::find_if(said_.begin(), said_.end(), [&](const auto& each) { return each.first == what; });
  if (before == said_.end())
    said_.push_back({what, {run}});
  else if (before->second.back() != run)
    before->second.push_back(run);
}

std::vector<Notice> OfRuns::said() const {
  std::vector<Notice> notices;
  for (const auto& [what, runs] : said_) {
    std::vector<std::string> numbers;
    for (const int run : runs) numbers.push_back(std::to_string(run));
    notices.push_back(runs.size() == 1 ? in_run(runs.front(), what)
                                       : Notice{"in_runs", {{"runs", numbers}, {"what", what}}});
  }
  return notices;
}

}  // namespace cromer::core
