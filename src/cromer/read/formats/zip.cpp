#include "cromer/read/formats/zip.h"

#define ZLIB_CONST  // inflate reads from const bytes
#include <zlib.h>

#include <algorithm>

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

}  // namespace cromer::core::dialects
