// What libcromer_hdf5.so does: it lays out a file and says where in it the numbers of each dataset are. The
// numbers themselves are written and read without it.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

/// A text attribute.
struct CromerHdf5Text {
  const char* name;
  const char* text;
};

/// A group of the file's root.
struct CromerHdf5Group {
  const char* name;
  const CromerHdf5Text* texts;  ///< its attributes
  std::size_t text_count;
};

/// A dataset of doubles, one piece in the file.
struct CromerHdf5Dataset {
  const char* name;             ///< "group/name" in a group
  const CromerHdf5Text* texts;  ///< its attributes
  std::size_t text_count;
  const std::uint64_t* shape;
  std::size_t dimensions;
  std::uint64_t offset;  ///< of its first number from the file's beginning [bytes]; set by the module
};

/// How it went; `message` then has HDF5's own words, or the number of the system's error.
enum CromerHdf5End : int {
  cromer_hdf5_good,
  cromer_hdf5_not_made,  ///< the file could not be made
  cromer_hdf5_part,      ///< nor one of its parts; the message begins with its name
  cromer_hdf5_not_written,
  cromer_hdf5_system,      ///< the system refused: `message` is the number of its error
  cromer_hdf5_not_opened,  ///< as an HDF5 file
  cromer_hdf5_not_read,
};

/// Receives what a file holds.
struct CromerHdf5Reader {
  void* self;
  void (*text)(void* self, const char* name, const char* text);
  void (*dataset)(void* self, const char* name, std::uint64_t numbers, std::uint64_t offset);
};

struct CromerHdf5 {
  int version;

  /// Makes the file: attributes, groups, and datasets whose fill value is NaN, with room for all numbers,
  /// none written. The bytes are the same whenever and wherever it runs. The file is usable only if the
  /// result is cromer_hdf5_good.
  CromerHdf5End (*create)(const char* path, const CromerHdf5Text* texts, std::size_t text_count,
                          const CromerHdf5Group* groups, std::size_t group_count, CromerHdf5Dataset* datasets,
                          std::size_t dataset_count, char* message, std::size_t room);

  /// Tells text attributes and datasets of the file's root.
  CromerHdf5End (*read)(const char* path, const CromerHdf5Reader* reader, char* message, std::size_t room);
};

const CromerHdf5* cromer_hdf5();

}  // extern "C"

namespace cromer::core {
constexpr int hdf5_module_version = 4;
}
