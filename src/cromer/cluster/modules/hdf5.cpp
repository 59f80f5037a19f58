#include <hdf5.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/cluster/hdf5_module.h"

namespace {

/// One of HDF5's identifiers, closed at the end.
class Id {
 public:
  Id(hid_t id, herr_t (*close_it)(hid_t)) : id_(id), close_(close_it) {}
  Id(const Id&) = delete;
  Id& operator=(const Id&) = delete;
  ~Id() { close(); }
  operator hid_t() const { return id_; }  // NOLINT: it is one
  bool good() const { return id_ >= 0; }
  bool close() {
    const bool closed = id_ < 0 || close_(id_) >= 0;
    id_ = -1;
    return closed;
  }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// The innermost of HDF5's messages of the first call that failed: what really went wrong. The calls that
/// then close everything clear HDF5's own record of it.
std::string trouble;

herr_t keep_trouble(hid_t stack, void*) {
  if (!trouble.empty()) return 0;
  return H5Ewalk2(
      stack, H5E_WALK_UPWARD,
      [](unsigned n, const H5E_error2_t* error, void*) {
        if (n == 0 && error->desc) trouble = error->desc;
        return 0;
      },
      nullptr);
}

/// HDF5 says nothing by itself.
void keep_trouble() {
  trouble.clear();
  H5Eset_auto2(H5E_DEFAULT, keep_trouble, nullptr);
}

/// `part`: the name of what was being made.
CromerHdf5End fail(CromerHdf5End end, char* message, std::size_t room, const char* part = nullptr) {
  // "file write failed: time = ..., errno = 28, error message = ...": the number says all.
  constexpr std::string_view mark = "errno = ";
  const std::size_t at = trouble.find(mark);
  const int number = at == std::string::npos ? 0 : std::atoi(trouble.c_str() + at + mark.size());
  if (number > 0) {
    std::snprintf(message, room, "%d", number);
    return cromer_hdf5_system;
  }
  std::snprintf(message, room, "%s%s%s", part ? part : "", part ? ": " : "", trouble.c_str());
  return end;
}

hid_t text_type(std::size_t size) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, size + 1);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

constexpr std::size_t longest_attribute = 60000;  // HDF5 takes 64 KiB together with its own

/// As an attribute, or where it is too long for one, as a dataset of the same name.
bool write_text(hid_t where, const CromerHdf5Text& text) {
  const std::size_t size = std::strlen(text.text);
  const Id type(text_type(size), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  if (size <= longest_attribute) {
    const Id attribute(H5Acreate2(where, text.name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    return attribute.good() && H5Awrite(attribute, type, text.text) >= 0;
  }
  const Id options(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(options, false);
  const Id dataset(H5Dcreate2(where, text.name, type, space, H5P_DEFAULT, options, H5P_DEFAULT), H5Dclose);
  return dataset.good() && H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.text) >= 0;
}

bool make_dataset(hid_t file, CromerHdf5Dataset& made) {
  const std::vector<hsize_t> shape(made.shape, made.shape + made.dimensions);
  const Id space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  const Id options(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  const double nan = std::nan("");
  H5Pset_obj_track_times(options, false);
  H5Pset_layout(options, H5D_CONTIGUOUS);
  H5Pset_alloc_time(options, H5D_ALLOC_TIME_EARLY);
  H5Pset_fill_value(options, H5T_NATIVE_DOUBLE, &nan);
  H5Pset_fill_time(options, H5D_FILL_TIME_NEVER);  // whoever writes the numbers does, and can be interrupted
  const Id dataset(H5Dcreate2(file, made.name, H5T_IEEE_F64LE, space, H5P_DEFAULT, options, H5P_DEFAULT),
                   H5Dclose);
  if (!dataset.good()) return false;
  for (std::size_t i = 0; i < made.text_count; ++i)
    if (!write_text(dataset, made.texts[i])) return false;
  const haddr_t offset = H5Dget_offset(dataset);
  made.offset = offset;
  return offset != HADDR_UNDEF;
}

bool make_group(hid_t file, const CromerHdf5Group& made) {
  const Id options(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_obj_track_times(options, false);
  const Id group(H5Gcreate2(file, made.name, H5P_DEFAULT, options, H5P_DEFAULT), H5Gclose);
  if (!group.good()) return false;
  for (std::size_t i = 0; i < made.text_count; ++i)
    if (!write_text(group, made.texts[i])) return false;
  return true;
}

CromerHdf5End create(const char* path, const CromerHdf5Text* texts, std::size_t text_count,
                     const CromerHdf5Group* groups, std::size_t group_count, CromerHdf5Dataset* datasets,
                     std::size_t dataset_count, char* message, std::size_t room) {
  keep_trouble();
  const Id creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose), access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_obj_track_times(creation, false);
  H5Pset_alignment(access, 65536, 4096);  // columns begin with a page
  Id file(H5Fcreate(path, H5F_ACC_TRUNC, creation, access), H5Fclose);
  if (!file.good()) return fail(cromer_hdf5_not_made, message, room);
  for (std::size_t i = 0; i < text_count; ++i)
    if (!write_text(file, texts[i])) return fail(cromer_hdf5_part, message, room, texts[i].name);
  for (std::size_t i = 0; i < group_count; ++i)
    if (!make_group(file, groups[i])) return fail(cromer_hdf5_part, message, room, groups[i].name);
  for (std::size_t i = 0; i < dataset_count; ++i)
    if (!make_dataset(file, datasets[i])) return fail(cromer_hdf5_part, message, room, datasets[i].name);
  if (H5Fflush(file, H5F_SCOPE_LOCAL) < 0 || !file.close())
    return fail(cromer_hdf5_not_written, message, room);
  return cromer_hdf5_good;
}

/// Calls the reader with a text that an attribute or dataset of one string holds.
template <class Read>
void tell_text(const CromerHdf5Reader& reader, const char* name, hid_t stored, const Read& read) {
  if (H5Tget_class(stored) != H5T_STRING || H5Tis_variable_str(stored) > 0) return;
  std::string text(H5Tget_size(stored) + 1, '\0');
  if (read(text.data())) reader.text(reader.self, name, text.c_str());
}

herr_t tell_attribute(hid_t where, const char* name, const H5A_info_t*, void* to) {
  const Id attribute(H5Aopen(where, name, H5P_DEFAULT), H5Aclose);
  const Id type(H5Aget_type(attribute), H5Tclose);
  tell_text(*static_cast<const CromerHdf5Reader*>(to), name, type,
            [&](char* text) { return H5Aread(attribute, type, text) >= 0; });
  return 0;
}

herr_t tell_dataset(hid_t where, const char* name, const H5L_info_t*, void* to) {
  const auto& reader = *static_cast<const CromerHdf5Reader*>(to);
  const Id dataset(H5Dopen2(where, name, H5P_DEFAULT), H5Dclose);
  if (!dataset.good()) {  // a group: not ours
    trouble.clear();
    return 0;
  }
  const Id type(H5Dget_type(dataset), H5Tclose), space(H5Dget_space(dataset), H5Sclose);
  const haddr_t offset = H5Dget_offset(dataset);
  if (H5Tequal(type, H5T_IEEE_F64LE) > 0 && offset != HADDR_UNDEF)
    reader.dataset(reader.self, name, static_cast<std::uint64_t>(H5Sget_simple_extent_npoints(space)),
                   offset);
  else
    tell_text(reader, name, type,
              [&](char* text) { return H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text) >= 0; });
  return 0;
}

CromerHdf5End read(const char* path, const CromerHdf5Reader* reader, char* message, std::size_t room) {
  keep_trouble();
  const Id file(H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.good()) return fail(cromer_hdf5_not_opened, message, room);
  auto* to = const_cast<CromerHdf5Reader*>(reader);
  hsize_t first = 0;
  H5Aiterate2(file, H5_INDEX_NAME, H5_ITER_INC, &first, tell_attribute, to);
  if (H5Literate(file, H5_INDEX_NAME, H5_ITER_INC, nullptr, tell_dataset, to) < 0)
    return fail(cromer_hdf5_not_read, message, room);
  return cromer_hdf5_good;
}

}  // namespace

extern "C" const CromerHdf5* cromer_hdf5() {
  H5dont_atexit();  // all is closed here; after a full disk HDF5's own tidying up crashes
  static const CromerHdf5 interface { cromer::core::hdf5_module_version, create, read };
  return &interface;
}
