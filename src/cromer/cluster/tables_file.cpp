#include "cromer/cluster/tables_file.h"

#include <filesystem>
#include <system_error>

#include "cromer/cluster/disk.h"
#include "cromer/cluster/module.h"
#include "cromer/os/replacement.h"

namespace cromer::core {
namespace {

/// What the module is told, and the strings that it points to.
struct Told {
  std::vector<std::string> names{}, units{};
  std::vector<std::vector<std::uint64_t>> shapes{};
  std::vector<std::vector<CromerHdf5Text>> texts{};
  std::vector<CromerHdf5Dataset> datasets{};
  std::vector<const Hdf5Column*> columns{};
  std::vector<std::vector<CromerHdf5Text>> group_texts{};
  std::vector<CromerHdf5Group> groups{};
};

std::vector<CromerHdf5Text> texts_of(const Hdf5Table& table) {
  std::vector<CromerHdf5Text> texts;
  for (const auto& [name, text] : table.texts) texts.push_back({name.c_str(), text.c_str()});
  return texts;
}

Told tell(const std::vector<Hdf5Table>& tables) {
  Told told;
  for (const Hdf5Table& table : tables) {
    if (!table.name.empty()) told.group_texts.push_back(texts_of(table));
    for (const Hdf5Column& column : table.columns) {
      if (column.values.empty()) continue;
      auto [name, unit] = name_and_unit(column.name);
      told.names.push_back(table.name.empty() ? name : table.name + "/" + name);
      told.units.push_back(std::move(unit));
      told.shapes.push_back(column.shape.empty() ? std::vector<std::uint64_t>{column.values.size()}
                                                 : column.shape);
      told.columns.push_back(&column);
    }
  }
  // Pointers only now that nothing moves any more.
  std::size_t group = 0;
  for (const Hdf5Table& table : tables) {
    if (table.name.empty()) continue;
    const auto& texts = told.group_texts[group++];
    told.groups.push_back({table.name.c_str(), texts.data(), texts.size()});
  }
  for (std::size_t i = 0; i < told.columns.size(); ++i) {
    told.texts.push_back({{"unit", told.units[i].c_str()}});
    if (!told.columns[i]->axes.empty()) told.texts.back().push_back({"axes", told.columns[i]->axes.c_str()});
  }
  for (std::size_t i = 0; i < told.columns.size(); ++i)
    told.datasets.push_back({told.names[i].c_str(), told.texts[i].data(), told.texts[i].size(),
                             told.shapes[i].data(), told.shapes[i].size(), 0});
  return told;
}

Result<void> fill(const std::string& path, const std::string& name, const std::vector<Hdf5Table>& tables) {
  auto module = load_hdf5();
  if (!module) return module.error();
  Told told = tell(tables);
  std::vector<CromerHdf5Text> of_file;
  for (const Hdf5Table& table : tables)
    if (table.name.empty()) of_file = texts_of(table);
  if (auto good = create_hdf5(**module, path, name, of_file, told.groups, told.datasets); !good) return good;
  auto file = DiskFile::open_unfinished(path, name);
  if (!file) return file.error();
  for (std::size_t i = 0; i < told.columns.size(); ++i) {
    const auto& values = told.columns[i]->values;
    if (auto good = file->write(values.data(), values.size() * sizeof(double), told.datasets[i].offset);
        !good)
      return good;
  }
  return file->sync();
}

}  // namespace

Result<void> can_write_tables(const std::string& path) {
  auto module = load_hdf5();
  if (!module) return module.error();
  std::error_code failed;
  const auto there = std::filesystem::status(path, failed);
  if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
    return Error{"hdf5_needs_a_file", {{"path", path}}};
  return {};
}

Result<void> write_tables(const std::string& path, const std::vector<Hdf5Table>& tables) {
  if (auto good = can_write_tables(path); !good) return good;
  auto fresh = Replacement::named_beside(path);
  if (!fresh) return fresh.error();
  if (auto good = fill(fresh->name(), path, tables); !good) return good;
  return fresh->take_place();
}

}  // namespace cromer::core
