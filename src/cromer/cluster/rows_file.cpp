#include "cromer/cluster/rows_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "cromer/cluster/differences.h"
#include "cromer/cluster/module.h"

namespace cromer::core {
namespace {

/// A dataset of the file.
struct LaidOut {
  std::string name, unit;
  std::vector<std::uint64_t> shape;
  std::size_t column = 0;      ///< of the rows, where it is no axis
  const Grid* axis = nullptr;  ///< its values, where it is one
  std::uint64_t offset = 0;    ///< of its first number in the file [bytes]

  std::uint64_t numbers() const {
    std::uint64_t product = 1;
    for (const std::uint64_t size : shape) product *= size;
    return product;
  }
};

/// The datasets of such work, axes first; offsets are not set.
std::vector<LaidOut> layout_of(const ChunkedRows& work, const std::vector<RowsAxis>& axes) {
  std::vector<LaidOut> datasets;
  std::vector<std::uint64_t> shape;
  for (const RowsAxis& axis : axes) {
    const auto [name, unit] = name_and_unit(axis.name);
    datasets.push_back({.name = name, .unit = unit, .shape = {axis.values.size()}, .axis = &axis.values});
    shape.push_back(axis.values.size());
  }
  if (shape.empty()) shape = {work.rows};
  for (std::size_t i = 0; i < work.columns.size(); ++i) {
    const std::string& column = work.columns[i];
    if (std::any_of(axes.begin(), axes.end(), [&](const RowsAxis& axis) { return axis.name == column; }))
      continue;
    const auto [name, unit] = name_and_unit(column);
    datasets.push_back({.name = name, .unit = unit, .shape = shape, .column = i});
  }
  return datasets;
}

/// Writes `count` numbers, value(i), from `offset` on.
template <class Value>
Result<void> write_numbers(const DiskFile& file, std::uint64_t offset, std::uint64_t count,
                           const Watch& watch, const Value& value) {
  constexpr std::uint64_t piece = 1 << 17;  // 1 MiB
  std::vector<double> numbers(std::min(piece, count));
  for (std::uint64_t begin = 0; begin < count; begin += piece) {
    if (watch.interrupted()) return Error{"interrupted_at_first"};
    const std::uint64_t n = std::min(piece, count - begin);
    for (std::uint64_t i = 0; i < n; ++i) numbers[i] = value(begin + i);
    if (auto good = file.write(numbers.data(), n * sizeof(double), offset + begin * sizeof(double)); !good)
      return good;
  }
  return {};
}

/// Makes the file, at `path` until it is finished, with all its numbers, NaN but for the axes; sets the
/// offsets.
Result<void> make_file(const std::string& path, const ChunkedRows& work, const RowsFileOptions& options,
                       std::vector<LaidOut>& datasets, const Watch& watch) {
  auto module = load_hdf5();
  if (!module) return module.error();
  std::string axes;
  for (const LaidOut& dataset : datasets)
    if (dataset.axis) axes += (axes.empty() ? "" : " ") + dataset.name;
  std::vector<std::vector<CromerHdf5Text>> texts;
  std::vector<CromerHdf5Dataset> made;
  for (const LaidOut& dataset : datasets) {
    texts.push_back({{"unit", dataset.unit.c_str()}});
    if (!dataset.axis && !axes.empty()) texts.back().push_back({"axes", axes.c_str()});
  }
  for (std::size_t i = 0; i < datasets.size(); ++i)
    made.push_back({datasets[i].name.c_str(), texts[i].data(), texts[i].size(), datasets[i].shape.data(),
                    datasets[i].shape.size(), 0});
  const CromerHdf5Text of_file[] = {{"description", work.description.c_str()},
                                    {"program", options.program.c_str()},
                                    {"command", options.command.c_str()}};
  if (auto good = create_hdf5(**module, path, options.path, of_file, {}, made); !good) return good;

  auto file = DiskFile::open_unfinished(path, options.path);
  if (!file) return file.error();
  if (auto good = file->sync(); !good) return good;
  for (std::size_t i = 0; i < datasets.size(); ++i) {
    LaidOut& dataset = datasets[i];
    dataset.offset = made[i].offset;
    const Grid* axis = dataset.axis;
    const auto value = [axis](std::uint64_t n) { return axis ? (*axis)[n] : std::nan(""); };
    if (auto good = write_numbers(*file, dataset.offset, dataset.numbers(), watch, value); !good) return good;
  }
  return {};
}

/// What a file was found to hold.
struct Found {
  std::map<std::string, std::string> texts{};
  std::map<std::string, std::pair<std::uint64_t, std::uint64_t>> datasets{};  // numbers, offset
};

/// Finds the datasets in a file made before; an Error where it is of other work.
Result<void> find_in_file(const ChunkedRows& work, const RowsFileOptions& options,
                          std::vector<LaidOut>& datasets) {
  auto module = load_hdf5();
  if (!module) return module.error();
  Found found;
  const CromerHdf5Reader reader{
      &found,
      [](void* self, const char* name, const char* text) { static_cast<Found*>(self)->texts[name] = text; },
      [](void* self, const char* name, std::uint64_t numbers, std::uint64_t offset) {
        static_cast<Found*>(self)->datasets[name] = {numbers, offset};
      }};
  if (const Notice trouble = read_hdf5(**module, options.path, reader); !trouble.empty())
    return Error{"cannot_resume_file", {{"path", options.path}, {"what", trouble}}};
  const auto described = found.texts.find("description");
  if (described == found.texts.end()) return Error{"resume_without_description", {{"path", options.path}}};
  const std::vector<Notice> other = differences(described->second, work.description);
  if (!other.empty()) return Error{"resume_other_sweep", {{"path", options.path}, {"differences", other}}};
  for (LaidOut& dataset : datasets) {
    const auto there = found.datasets.find(dataset.name);
    if (there == found.datasets.end() || there->second.first != dataset.numbers())
      return Error{"resume_changed_file",
                   {{"path", options.path}, {"dataset", dataset.name}, {"numbers", dataset.numbers()}}};
    dataset.offset = there->second.second;
  }
  return {};
}

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

/// The size of the file of this work [bytes].
double rows_file_bytes(const ChunkedRows& work, const RowsFileOptions& options) {
  double numbers = 0;
  for (const LaidOut& dataset : layout_of(work, options.axes))
    numbers += static_cast<double>(dataset.numbers());
  return 8 * numbers + static_cast<double>(work.chunks()) + 1e5;
}

}  // namespace

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
  // Noting more often costs time; less often costs more work after a crash.
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
