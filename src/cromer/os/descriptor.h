// What owns an open file, line or connection.
#pragma once

#include <utility>

namespace cromer::core {

/// Owns a file descriptor; -1 is none.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { (void)end(); }

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void close() { *this = Descriptor(); }
  /// Closes it and says whether that succeeded: on a network drive it may be what shows that a file was not
  /// written. False with the reason in errno.
  bool end();

 private:
  int number_ = -1;
};

}  // namespace cromer::core
