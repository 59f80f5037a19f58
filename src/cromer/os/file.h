// Files as the operating system has them. One meaning on every system: paths are UTF-8, bytes stay as they
// are, what fails leaves its reason in errno.
#pragma once

#include <fcntl.h>  // O_RDONLY and its like

#include <cstddef>
#include <cstdint>
#include <string>

namespace cromer::core::os {

enum class FileKind { none, regular, folder, device, other };

struct FileStatus {
  FileKind kind = FileKind::none;  ///< none, with the reason in errno, also where it cannot be told
  std::uint64_t size = 0;          ///< [bytes]
};

FileStatus status(const std::string& path);
FileStatus status(int descriptor);

/// Whether a file may be written, or files be made in a folder.
bool may_write(const std::string& path);
bool may_make_files_in(const std::string& folder);

/// As open(2); programs that this one starts do not have it open. A new file's permissions are the usual
/// ones. -1 if that fails.
int open(const std::string& path, int flags);
/// Opens a file that is there, to write from its beginning or, `at_end`, to append to it. Does not wait for
/// somebody to read from a pipe.
int open_to_write(const std::string& path, bool at_end);
/// A new file without a name in a folder; -1 where the file system has none.
int open_unnamed(const std::string& folder);
/// A new file, open to this user alone; the X at the end of its name become other letters.
int open_new(std::string& name);

/// As read(2) and write(2); interrupted by no signal.
std::ptrdiff_t read(int descriptor, void* bytes, std::size_t size);
std::ptrdiff_t write(int descriptor, const void* bytes, std::size_t size);
/// At any place of a file, as pread(2) and pwrite(2).
std::ptrdiff_t read_at(int descriptor, void* bytes, std::size_t size, std::uint64_t offset);
std::ptrdiff_t write_at(int descriptor, const void* bytes, std::size_t size, std::uint64_t offset);

/// Returns when the bytes are on the disk.
bool sync(int descriptor);
/// Returns when the names in a folder are on the disk, where the system can be asked for that.
void sync_folder(const std::string& folder);
bool truncate(int descriptor, std::uint64_t size);
/// Until it is closed no other program can lock it. False where another has; errno says if it cannot be
/// locked at all.
bool lock(int descriptor);

/// Gives the file the permissions of the one at `path`; if there is none, those of a new file.
bool take_permissions(int descriptor, const std::string& path);
/// Gives a name to a file without one. EEXIST where it is taken.
bool give_name(int descriptor, const std::string& path);
/// Renames a file; what has that name is replaced.
bool rename(const std::string& from, const std::string& to);
bool remove(const std::string& path);
/// Whether it is a regular file of this user that was not changed for so long [s].
bool is_own_and_old(const std::string& path, double seconds);
/// Whether the number of an error says that there is no room for a file.
bool is_full(int number);
/// Whether a pipe has nobody who reads from it, by the number of the error.
bool has_no_reader(const std::string& path, int number);

}  // namespace cromer::core::os
