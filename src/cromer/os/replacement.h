// A file that takes the place of another once it is whole.
#pragma once

#include <string>

#include "cromer/os/descriptor.h"
#include "cromer/result.h"

namespace cromer::core {

/// The file that a path stands for: symbolic links are followed to their end, whether anything is there or
/// not, so that a link stays one.
std::string target_of(const std::string& path);

/// "cannot_write" with path and reason, by the number of the system's error; of a full disk with the cure.
Error cannot_write(const std::string& path, int number);

/// The folder that a file of this path lies in.
std::string folder_of(const std::string& path);

/// Until it takes its place it has no name, if the file system allows that (Linux, open(2), O_TMPFILE): a
/// program that is killed then leaves nothing behind. Elsewhere its name begins with .cromer-, in the same
/// folder; files that killed programs left there more than an hour ago are removed when the next one is
/// made.
class Replacement {
 public:
  /// An Error names `path` and the reason. The folder must be there.
  static Result<Replacement> beside(const std::string& path);
  /// The same, but with a name, for code that opens it by its name.
  static Result<Replacement> named_beside(const std::string& path);

  Replacement(Replacement&& other) noexcept;
  Replacement& operator=(Replacement&&) = delete;
  /// Removes the file, unless it has taken its place.
  ~Replacement();

  int descriptor() const { return file_.number(); }
  /// "" where it has none.
  const std::string& name() const { return temporary_; }

  /// Replaces the file at the path. Keeps that file's permissions; without one they are those of a new file.
  Result<void> take_place();

 private:
  Replacement(std::string path, std::string target) : path_(std::move(path)), target_(std::move(target)) {}
  bool make_named();
  bool give_name();

  std::string path_, target_;
  std::string temporary_{};  ///< "" while it has no name
  Descriptor file_{};
};

}  // namespace cromer::core
