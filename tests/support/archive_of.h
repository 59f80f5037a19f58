// ZIP archives made by the specification. Link zlib.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <string>
#include <vector>

#include "cromer/base/concat.h"

namespace cromer::core {

/// The lowest bytes, the least first.
inline std::string little(std::size_t value, int bytes) {
  std::string text;
  for (int k = 0; k < bytes; ++k) text += static_cast<char>(value >> (8 * k) & 0xFFu);
  return text;
}

inline std::string deflated(std::string text) {
  std::string packed(compressBound(text.size()), '\0');
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(text.data());
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

struct ArchivedFile {
  std::string name, text;
};

/// Local headers with their data, the directory, its end.
inline std::string archive_of(const std::vector<ArchivedFile>& files, bool pack = true,
                              std::size_t flags = 0) {
  std::string data, directory;
  for (const ArchivedFile& file : files) {
    const std::string packed = pack ? deflated(file.text) : file.text;
    const auto* bytes = reinterpret_cast<const Bytef*>(file.text.data());
    const std::string about =
        concat({little(20, 2), little(flags, 2), little(pack ? 8 : 0, 2), little(0, 4),
                little(crc32(0, bytes, static_cast<uInt>(file.text.size())), 4), little(packed.size(), 4),
                little(file.text.size(), 4), little(file.name.size(), 2), little(0, 2)});
    directory += concat({"PK\x01\x02", little(20, 2), about, little(0, 2), little(0, 2), little(0, 2),
                         little(0, 4), little(data.size(), 4), file.name});
    data += concat({"PK\x03\x04", about, file.name, packed});
  }
  const std::string end =
      concat({"PK\x05\x06", little(0, 4), little(files.size(), 2), little(files.size(), 2),
              little(directory.size(), 4), little(data.size(), 4), little(0, 2)});
  return data + directory + end;
}

}  // namespace cromer::core
