// Requests to a running `cromer serve`, and its answers.
#pragma once

#include <sys/types.h>

#include <string>

#include "program.h"
#include "tests/support/peer.h"

namespace cromer::core::test {

/// "GET /" with a good Host and what else is given, each line with its end; "Connection: close".
std::string request(int port, const std::string& first_line, const std::string& headers = "",
                    const std::string& body = "");

/// The whole answer to one request; "" where there is none within `seconds`.
std::string ask(int port, const std::string& bytes, double seconds = 10);

/// 200, ... of an answer; 0 where it is none.
int status_of(const std::string& answer);
std::string body_of(const std::string& answer);

/// cromer serve, running in a folder with a page of its own until the object ends.
class Served {
 public:
  explicit Served(const Folder& folder, std::vector<std::string> more = {});
  ~Served();
  int port() const { return port_; }
  const std::string& address() const { return address_; }  ///< as it was printed
  bool is_up() const;
  /// The most memory it has held so far [MB].
  double memory() const;

 private:
  const Folder& folder_;
  pid_t process_;
  int port_ = 0;
  std::string address_;
};

}  // namespace cromer::core::test
