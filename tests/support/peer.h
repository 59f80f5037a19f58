// The other end of a server's connections, well behaved or not: bytes in, bytes out.
#pragma once

#include <string>

namespace cromer::core::test {

/// A connection to a port of this computer; closed with the object.
class Peer {
 public:
  explicit Peer(int port);
  ~Peer();
  Peer(Peer&& other) noexcept;
  Peer(const Peer&) = delete;

  bool connected() const { return socket_ >= 0; }
  /// False where the other side has closed or takes nothing within two seconds.
  bool send(const std::string& bytes) const;
  /// Says that no more will be sent.
  void finish() const;
  /// What comes until the other side closes, or `until` has come, or `seconds` are over.
  std::string receive(double seconds, const std::string& until = "") const;
  /// Whether the other side closes within `seconds`.
  bool is_closed_within(double seconds) const;

 private:
  int socket_ = -1;
};

}  // namespace cromer::core::test
