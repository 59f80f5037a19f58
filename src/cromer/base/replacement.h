// A file that takes the place of another once it is whole.
#pragma once

#include <string>

#include "cromer/result.h"

namespace cromer::core {

/// The file that a path stands for: symbolic links are followed to their end, whether anything is there or
/// not, so that a link stays one.
std::string target_of(const std::string& path);

/// "cannot_write" with path and reason, by the number of the system's error.
Error cannot_write(const std::string& path, int number);

/// A file that is there, opened to be written from where it stands, or added to at its end; -1, with the
/// system's reason in errno, where it cannot be. A pipe that nobody reads from is not waited for.
int open_to_write(const std::string& path, bool at_end);

/// The folder that a file of this path lies in.
std::string folder_of(const std::string& path);

/// Until it takes its place it has no name, where the file system has such files (Linux, open(2), O_TMPFILE):
/// whoever kills the program leaves nothing. Elsewhere its name begins with .cromer-, in the same folder;
/// those that killed programs left more than an hour ago go when the next one is made.
class Replacement {
 public:
  /// An Error names `path` and the reason. The folder must be there.
  static Result<Replacement> beside(const std::string& path);
  /// The same for those who open it by its name: it has one.
  static Result<Replacement> named_beside(const std::string& path);

  Replacement(Replacement&& other) noexcept;
  Replacement& operator=(Replacement&&) = delete;
  /// Leaves nothing, unless it has taken its place.
  ~Replacement();

  int descriptor() const { return descriptor_; }
  /// "" where it has none.
  const std::string& name() const { return temporary_; }

  /// With the permissions of the file that it replaces, or those of a new one.
  Result<void> take_place();

 private:
  Replacement(std::string path, std::string target) : path_(std::move(path)), target_(std::move(target)) {}
  bool make_named();
  bool give_name();

  std::string path_, target_;
  std::string temporary_{};  ///< "" while it has no name
  int descriptor_ = -1;
};

}  // namespace cromer::core
