// From the bytes of a logger's file to columns of numbers.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cromer/export.h>
#include <cromer/notice.h>
#include <cromer/result.h>

namespace cromer {

namespace core {
struct Recording;
}

/// What the caller knows better than the file; empty means: find out.
struct ReadOptions {
  std::string delimiter{};    ///< "," ";" "tab" "blank"
  std::string decimal{};      ///< "." or ","
  std::string time_column{};  ///< its name
  double rate = 0;            // [Hz] samples per second, of files without times, 1e-6 to 1e12; 0: not given
  bool skip_bad_rows = false;
};

/// One column as the file has it, to look at (fits read the file's own values): `values` in its own unit, NaN
/// where a value is missing.
struct Column {
  std::string name;      ///< without unit and run: "Position"
  std::string quantity;  ///< time, position, angle, velocity, acceleration, force, ...; "" where not known
  std::string unit;      ///< as spelled: "mm"; "" where the file says none
  int run = 1;           ///< runs side by side are numbered from 1
  std::span<const double> values;  ///< alive as long as the Recording or a copy of it
};

/// A file read.
struct Recording {
  std::string file;
  std::string dialect;  ///< who wrote it: "PASCO Capstone", "Tracker", "plain", ...
  std::vector<Column> columns;
  std::vector<Notice> notices;  ///< what was repaired, assumed or left out
  ReadOptions options;
  std::shared_ptr<const core::Recording> detail{};

  /// By its name, exactly, or without case, decoration and unit where that is unambiguous; nullptr else.
  CROMER_API const Column* find(std::string_view name, int run = 1) const;
};

/// Reads a whole file: any table of numbers with or without names, units, decimal commas, in UTF-8, UTF-16 or
/// cp1252, also zipped (docs/dialects.md). `file` is its name in messages. An Error names line, column and
/// cure.
CROMER_API Result<Recording> read(std::span<const std::byte> bytes, std::string_view file = "recording",
                                  const ReadOptions& options = {});
CROMER_API Result<Recording> read_file(const std::string& path, const ReadOptions& options = {});

}  // namespace cromer
