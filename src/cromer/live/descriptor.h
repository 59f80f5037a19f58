// Open descriptors: a serial line made raw, a TCP connection, and the waiting for either.
#pragma once

#include <string>
#include <utility>

#include "cromer/result.h"

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
  ~Descriptor();

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void close() { *this = Descriptor(); }

 private:
  int number_ = -1;
};

/// Raw: eight bits, no echo, no flow control. A device that knows no speed (a pseudo-terminal) takes any.
Result<Descriptor> open_serial(const std::string& device, int baud);

/// At most `seconds` for each address the host has.
Result<Descriptor> open_tcp(const std::string& host, int port, double seconds);

/// Whether there is something to read, or an end to be seen, within `seconds`.
bool readable(const Descriptor& descriptor, double seconds);

}  // namespace cromer::core
