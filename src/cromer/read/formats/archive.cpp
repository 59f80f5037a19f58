#include "cromer/read/formats/archive.h"

#define ZLIB_CONST  // inflate reads from const bytes
#include <zlib.h>
#include <algorithm>
#include <array>

#include "cromer/base/ascii.h"
#include "cromer/base/concat.h"
#include "cromer/read/cells.h"
#include "cromer/read/in_file.h"
#include "cromer/read/sets.h"
#include "cromer/read/text_file.h"

namespace cromer::core::dialects {
namespace {

constexpr std::string_view local_mark = "PK\x03\x04", central_mark = "PK\x01\x02", end_mark = "PK\x05\x06";

/// Little-endian, `count` bytes; 0 beyond the end.
std::size_t number_at(std::string_view bytes, std::size_t at, std::size_t count) {
  std::size_t value = 0;
  for (std::size_t k = count; k-- > 0;)
    value = value << 8 | (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0u);
  return value;
}

Error damaged() { return Error{"archive_damaged"}; }

}  // namespace

bool is_zip(std::string_view bytes) { return bytes.starts_with(local_mark) || bytes.starts_with(end_mark); }

Result<std::vector<ZipEntry>> zip_directory(std::string_view bytes) {
  constexpr std::size_t end_size = 22, longest_comment = 65535, central_size = 46, most_entries = 1000;
  const std::size_t end = bytes.rfind(end_mark);
  if (end == std::string_view::npos || end + end_size > bytes.size() ||
      bytes.size() - end > end_size + longest_comment)
    return damaged();
  const std::size_t count = number_at(bytes, end + 10, 2);
  if (count > most_entries) return Error{"archive_of_many_files", {{"most", most_entries}}};
  std::vector<ZipEntry> entries;
  std::size_t at = number_at(bytes, end + 16, 4), packed = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (at + central_size > end || bytes.substr(at, 4) != central_mark) return damaged();
    const std::size_t name = number_at(bytes, at + 28, 2);
    if (at + central_size + name > end) return damaged();
    ZipEntry entry;
    entry.name = bytes.substr(at + central_size, name);
    entry.encrypted = (number_at(bytes, at + 8, 2) & 1u) != 0;
    entry.method = static_cast<unsigned>(number_at(bytes, at + 10, 2));
    entry.checksum = static_cast<unsigned>(number_at(bytes, at + 16, 4));
    entry.packed = number_at(bytes, at + 20, 4);
    entry.size = number_at(bytes, at + 24, 4);
    entry.offset = number_at(bytes, at + 42, 4);
    packed += entry.packed;
    if (packed > bytes.size()) return damaged();  // entries that share their bytes
    entries.push_back(std::move(entry));
    at += central_size + name + number_at(bytes, at + 30, 2) + number_at(bytes, at + 32, 2);
  }
  return entries;
}

Result<std::string> unzip(std::string_view bytes, const ZipEntry& entry) {
  constexpr std::size_t local_size = 30, most_times = 50, allowance = 10'000;
  if (entry.encrypted) return Error{"archive_locked"};
  if (entry.method != 0 && entry.method != 8) return Error{"archive_method"};
  if (entry.offset + local_size > bytes.size() || bytes.substr(entry.offset, 4) != local_mark)
    return damaged();
  const std::size_t from = entry.offset + local_size + number_at(bytes, entry.offset + 26, 2) +
                           number_at(bytes, entry.offset + 28, 2);
  if (from > bytes.size() || entry.packed > bytes.size() - from) return damaged();
  if (entry.size > most_times * entry.packed + allowance) return Error{"archive_too_large"};
  const std::string_view packed = bytes.substr(from, entry.packed);
  std::string content(entry.size, '\0');
  if (entry.method == 0) {
    if (packed.size() != entry.size) return damaged();
    content = packed;
  } else {
    z_stream stream{};
    stream.next_in = reinterpret_cast<const Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(content.data());
    stream.avail_out = static_cast<uInt>(content.size());
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return damaged();  // raw deflate, no zlib header
    const int end = inflate(&stream, Z_FINISH);
    inflateEnd(&stream);
    if (end != Z_STREAM_END || stream.total_out != content.size()) return damaged();
  }
  const auto* data = reinterpret_cast<const Bytef*>(content.data());
  if (crc32(0, data, static_cast<uInt>(content.size())) != entry.checksum) return damaged();
  return content;
}

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
