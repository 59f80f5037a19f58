// An HDF5 file into which chunks of rows are written as they come. However the program ends, the file stays
// usable.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "cromer/base/grid.h"
#include "cromer/base/interrupt.h"
#include "cromer/cluster/disk.h"
#include "cromer/cluster/journal.h"
#include "cromer/ensemble/chunks.h"

namespace cromer::core {

/// A column that the rows run over in order.
struct RowsAxis {
  std::string name;  ///< "drive_frequency (rad/s)"
  Grid values;
};

struct RowsFileOptions {
  std::string path{};            ///< FILE.h5
  bool resume = false;           ///< go on with what the file lacks
  std::vector<RowsAxis> axes{};  ///< outermost first; their sizes multiply to the rows. Empty: just rows
  std::string program{};         ///< "cromer 0.1.0", kept in the file
  std::string command{};         ///< the command line, kept in the file
  std::chrono::milliseconds note_every{1000};  ///< a crash may cost this much work
};

/// One dataset for each column: of the axes' shape, or of as many numbers as there are rows; a column that is
/// an axis is one dataset of that axis' values. NaN where nothing is finished. Attributes: unit and, of the
/// file, description, program and command. All is laid out at the beginning and numbers are written in their
/// places, so that the bytes do not depend on who made which chunk when; after that nothing of HDF5's own is
/// touched. FILE.h5.journal says which chunks are finished: they are noted there after they are on the disk.
class RowsFile {
 public:
  /// Makes the file, or with `resume` opens it where it is there. Errors: no room; the file is of other work
  /// (says what differs) or unfinished and `resume` was not said; the module is missing; interrupted.
  static Result<RowsFile> open(const ChunkedRows& work, const RowsFileOptions& options, const Watch& watch);

  /// Chunks still to be made, in order.
  const std::vector<std::uint64_t>& unfinished() const { return unfinished_; }

  /// Writes a chunk's rows. They count as finished after the first call a second (note_every) later, or
  /// after close().
  Result<void> write(std::uint64_t chunk, const double* rows);

  /// Notes all that was written as finished. Call it however the work ends.
  Result<void> close();

  bool complete() const { return left_ == 0; }

  /// Reads the rows of a chunk as they were written, axes included; NaN where none were.
  void read(std::uint64_t chunk, double* rows) const;

 private:
  struct Column {
    std::size_t index;     // in the row
    std::uint64_t offset;  // in the file [bytes]
  };
  Result<void> note_finished();

  std::uint64_t rows_per_chunk_ = 1, rows_ = 0, left_ = 0;
  std::size_t width_ = 0;
  std::uint64_t rows_of(std::uint64_t chunk) const {
    return std::min(rows_per_chunk_, rows_ - chunk * rows_per_chunk_);
  }

  std::vector<RowsAxis> axes_{};
  std::vector<std::size_t> axis_columns_{};  // in the row, of each axis
  std::vector<Column> columns_{};            // the others
  DiskFile file_{};
  Journal journal_{};
  bool journaled_ = false;
  std::vector<std::uint64_t> unfinished_{}, written_{};  // written_: not yet noted
  std::vector<double> column_rows_{};
  std::chrono::milliseconds note_every_{};
  std::chrono::steady_clock::time_point noted_{};
};

}  // namespace cromer::core
