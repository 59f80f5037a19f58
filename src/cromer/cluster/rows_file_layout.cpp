#include "cromer/cluster/rows_file_layout.h"

#include <fcntl.h>

#include <algorithm>
#include <cmath>

#include "cromer/cluster/differences.h"
#include "cromer/cluster/load_hdf5.h"

namespace cromer::core {
namespace {

constexpr std::size_t message_room = 512;

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

/// What a file was found to hold.
struct Found {
  std::map<std::string, std::string> texts{};
  std::map<std::string, std::pair<std::uint64_t, std::uint64_t>> datasets{};  // numbers, offset
};

}  // namespace

std::uint64_t LaidOut::numbers() const {
  std::uint64_t product = 1;
  for (const std::uint64_t size : shape) product *= size;
  return product;
}

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
  char message[message_room];
  const CromerHdf5End end = (*module)->create(path.c_str(), of_file, std::size(of_file), nullptr, 0,
                                              made.data(), made.size(), message, message_room);
  if (const Notice trouble = hdf5_trouble(end, message); !trouble.empty())
    return Error{"cannot_write", {{"path", path}, {"why", trouble}}};

  auto file = DiskFile::open(path, 0);
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
  char message[message_room];
  const CromerHdf5End end = (*module)->read(options.path.c_str(), &reader, message, message_room);
  if (const Notice trouble = hdf5_trouble(end, message); !trouble.empty())
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

}  // namespace cromer::core
