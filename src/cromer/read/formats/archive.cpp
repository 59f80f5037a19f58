#include "cromer/read/formats/archive.h"

#include <algorithm>
#include <array>

#include "cromer/base/ascii.h"
#include "cromer/base/concat.h"
#include "cromer/read/cells.h"
#include "cromer/read/formats/zip.h"
#include "cromer/read/in_file.h"
#include "cromer/read/set.h"
#include "cromer/read/sets_below.h"
#include "cromer/read/text_file.h"

namespace cromer::core::dialects {
namespace {

bool ends_as_text(std::string_view name) {
  constexpr std::array<std::string_view, 4> endings{".csv", ".txt", ".tsv", ".dat"};
  const std::string ending = lower(name.substr(name.size() - std::min<std::size_t>(4, name.size())));
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// "Raw Data" of "export/Raw Data.csv".
std::string stem(std::string_view name) {
  name = name.substr(name.find_last_of('/') + 1);  // npos + 1 is 0
  return shown(name.substr(0, name.find_last_of('.')));
}

bool has_time(const Recording& recording) {
  const auto& columns = recording.table.columns;
  return std::any_of(columns.begin(), columns.end(),
                     [](const Column& column) { return column.quantity == "time"; });
}

struct Member {
  std::string name;
  Recording recording;
};

}  // namespace

Result<Recording> read_archive(std::string_view bytes, const ReadOptions& options) {
  const auto entries = zip_directory(bytes);
  if (!entries) return entries.error();
  Recording whole;
  std::vector<Member> members;
  Notice first_error;
  bool phyphox = false;
  for (const ZipEntry& entry : *entries) {
    if (entry.name == "[Content_Types].xml" || entry.name == "content.xml") return Error{"spreadsheet"};
    phyphox = phyphox || entry.name.find("meta/") != std::string::npos;
    const bool passed_over = entry.name.starts_with("meta/") ||
                             entry.name.find("/meta/") != std::string::npos ||
                             entry.name.starts_with("__MACOSX/");
    if (passed_over || !ends_as_text(entry.name)) continue;
    const auto content = unzip(bytes, entry);
    auto read = content ? read_text_file(*content, entry.name, options) : Result<Recording>(content.error());
    if (read) {
      members.push_back({stem(entry.name), std::move(*read)});
      continue;
    }
    const Notice reason = in_member(stem(entry.name), read.error().notice);
    if (first_error.empty()) first_error = reason;
    whole.notices.push_back(Notice{"left_out_of_archive", {{"what", reason}}});
  }
  if (members.empty()) return first_error.empty() ? Error{"archive_without_csv"} : Error{first_error};

  if (std::any_of(members.begin(), members.end(),
                  [](const Member& member) { return has_time(member.recording); }))
    members.erase(std::remove_if(members.begin(), members.end(),
                                 [&](const Member& member) {
                                   if (has_time(member.recording)) return false;
                                   whole.notices.push_back(
                                       Notice{"left_out_of_archive",
                                              {{"what", in_member(member.name, Notice{"has_no_times"})}}});
                                   return true;
                                 }),
                  members.end());
  whole.dialect = members.front().recording.dialect;
  phyphox = phyphox || whole.dialect.name == "phyphox";
  whole.dialect.name = phyphox ? "phyphox ZIP" : concat({whole.dialect.name, " in ZIP"});
  whole.named = true;
  std::vector<Set> sets;
  for (Member& member : members) {
    for (Notice& notice : member.recording.notices)
      whole.notices.push_back(members.size() > 1 ? in_member(member.name, std::move(notice))
                                                 : std::move(notice));
    const std::string label = members.size() > 1 ? member.name : "";
    for (Set& set : as_sets(std::move(member.recording), label)) sets.push_back(std::move(set));
  }
  if (const auto laid = lay_side_by_side(std::move(sets), whole); !laid) return laid.error();
  return whole;
}

}  // namespace cromer::core::dialects
