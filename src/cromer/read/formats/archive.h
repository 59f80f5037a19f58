// A ZIP archive of text files, as phyphox exports an experiment: one CSV for each data set, and a folder
// meta/.
// Source: PKWARE, "APPNOTE.TXT - .ZIP File Format Specification", 6.3.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core::dialects {

struct ZipEntry {
  std::string name;                              ///< with folders, between slashes
  unsigned method = 0;                           ///< 0 stored, 8 deflated
  unsigned checksum = 0;                         ///< CRC-32
  std::size_t packed = 0, size = 0, offset = 0;  ///< bytes
  bool encrypted = false;
};

bool is_zip(std::string_view bytes);

/// The directory at the end of the archive. Errors are without the file's name.
Result<std::vector<ZipEntry>> zip_directory(std::string_view bytes);

/// The bytes of one entry, checked against its size and checksum. An entry that claims more than 50 times
/// its packed size and ten kilobytes is an Error, and so are other methods, passwords and damage.
Result<std::string> unzip(std::string_view bytes, const ZipEntry& entry);

/// Each data set with times is a run, named after its file. meta/ is skipped. Sets without times are left
/// out, with a notice, if others have times.
Result<Recording> read_archive(std::string_view bytes, const ReadOptions& options);

}  // namespace cromer::core::dialects
