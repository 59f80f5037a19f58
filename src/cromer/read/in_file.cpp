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

}  // namespace cromer::core
