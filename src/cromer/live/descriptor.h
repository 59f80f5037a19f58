// Open descriptors: a raw serial line, a TCP connection, and waiting for either.
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

/// Raw: eight bits, no echo, no flow control. A device without a speed (a pseudo-terminal) takes any.
Result<Descriptor> open_serial(const std::string& device, int baud);

/// Tries each address of the host for at most `seconds`.
Result<Descriptor> open_tcp(const std::string& host, int port, double seconds);

/// Waits at most `seconds` for something to read or for the end of the input; whether either came.
bool readable(const Descriptor& descriptor, double seconds);

}  // namespace cromer::core
