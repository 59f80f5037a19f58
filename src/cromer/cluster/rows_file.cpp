#include "cromer/cluster/rows_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "cromer/cluster/rows_file_layout.h"

namespace cromer::core {
namespace {

namespace fs = std::filesystem;

bool there(const std::string& path) {
  std::error_code failed;
  return fs::exists(path, failed);
}

/// Tells work from other work: FNV-1a of all that the file's bytes depend on.
std::string fingerprint(const ChunkedRows& work) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&](std::string_view text) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  };
  add(work.description);
  for (const std::string& column : work.columns) add(column + "\n");
  return fmt::format("{} of {} rows, {:016x}", work.rows_per_chunk, work.rows, hash);
}

}  // namespace

double rows_file_bytes(const ChunkedRows& work, const RowsFileOptions& options) {
  double numbers = 0;
  for (const LaidOut& dataset : layout_of(work, options.axes))
    numbers += static_cast<double>(dataset.numbers());
  return 8 * numbers + static_cast<double>(work.chunks()) + 1e5;
}

Result<RowsFile> RowsFile::open(const ChunkedRows& work, const RowsFileOptions& options, const Watch& watch) {
  const std::string& path = options.path;
  RowsFile file;
  std::vector<LaidOut> datasets = layout_of(work, options.axes);
  const bool journal_there = there(Journal::path_of(path)), file_there = there(path);
  if (file_there && options.resume) {
    if (auto good = find_in_file(work, options, datasets); !good) return good.error();
    if (journal_there) {
      auto journal = Journal::open(path, work.chunks(), fingerprint(work));
      if (!journal) return Error{"cannot_resume", {{"what", journal.error().notice}}};
      file.journal_ = std::move(*journal);
      file.journaled_ = true;
      file.unfinished_ = file.journal_.unfinished();
    }
  } else {
    if (file_there && journal_there) return Error{"file_is_unfinished", {{"path", path}}};
    if (auto good = fits_on_disk(path, rows_file_bytes(work, options)); !good) return good.error();
    // Laid out under another name: a file of this name is whole whenever one looks. The journal is there
    // before it, for a file without one is finished.
    const std::string fresh = path + ".new";
    if (auto good = make_file(fresh, work, options, datasets, watch); !good) {
      (void)remove_file(fresh);
      return good.error();
    }
    if (auto good = remove_file(path); !good) return good.error();
    auto journal = Journal::create(path, work.chunks(), fingerprint(work));
    if (!journal) return journal.error();
    if (auto good = rename_file(fresh, path); !good) return good.error();
    file.journal_ = std::move(*journal);
    file.journaled_ = true;
    file.unfinished_.resize(work.chunks());
    std::iota(file.unfinished_.begin(), file.unfinished_.end(), 0);
  }
  auto opened = DiskFile::open(path, 0);
  if (!opened) return opened.error();
  file.file_ = std::move(*opened);
  for (const LaidOut& dataset : datasets)
    if (!dataset.axis) file.columns_.push_back({dataset.column, dataset.offset});
  file.axes_ = options.axes;
  for (const RowsAxis& axis : options.axes)
    file.axis_columns_.push_back(static_cast<std::size_t>(
        std::find(work.columns.begin(), work.columns.end(), axis.name) - work.columns.begin()));
  file.rows_ = work.rows;
  file.rows_per_chunk_ = work.rows_per_chunk;
  file.width_ = work.columns.size();
  file.left_ = file.unfinished_.size();
  file.note_every_ = options.note_every;
  file.noted_ = std::chrono::steady_clock::now();
  return file;
}

Result<void> RowsFile::write(std::uint64_t chunk, const double* rows) {
  const std::uint64_t first = chunk * rows_per_chunk_;
  const std::size_t count = rows_of(chunk);
  column_rows_.resize(count);
  for (const Column& column : columns_) {
    for (std::size_t r = 0; r < count; ++r) column_rows_[r] = rows[r * width_ + column.index];
    if (auto good =
            file_.write(column_rows_.data(), count * sizeof(double), column.offset + first * sizeof(double));
        !good)
      return good;
  }
  written_.push_back(chunk);
  // More often costs time, less often more work after a crash.
  if (std::chrono::steady_clock::now() - noted_ < note_every_) return {};
  return note_finished();
}

Result<void> RowsFile::note_finished() {
  if (!written_.empty()) {
    if (auto good = file_.sync(); !good) return good;
    if (auto good = journal_.mark(written_); !good) return good;
    left_ -= written_.size();
    written_.clear();
  }
  noted_ = std::chrono::steady_clock::now();
  return {};
}

void RowsFile::read(std::uint64_t chunk, double* rows) const {
  const std::uint64_t first = chunk * rows_per_chunk_;
  const std::size_t count = rows_of(chunk);
  std::vector<double> numbers(count);
  for (const Column& column : columns_) {
    std::fill(numbers.begin(), numbers.end(), std::nan(""));
    file_.read(numbers.data(), count * sizeof(double), column.offset + first * sizeof(double));
    for (std::size_t r = 0; r < count; ++r) rows[r * width_ + column.index] = numbers[r];
  }
  for (std::size_t r = 0; r < count; ++r) {
    std::uint64_t rest = first + r;
    for (std::size_t i = axes_.size(); i-- > 0; rest /= axes_[i].values.size())
      if (axis_columns_[i] < width_)
        rows[r * width_ + axis_columns_[i]] = axes_[i].values[rest % axes_[i].values.size()];
  }
}

Result<void> RowsFile::close() {
  if (auto good = note_finished(); !good) return good;
  if (!journaled_ || left_ > 0) return {};
  journaled_ = false;
  return journal_.remove();
}

}  // namespace cromer::core
