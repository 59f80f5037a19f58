// GET over one kept connection, as phyphox needs it.
#pragma once

#include <string>

#include "cromer/os/descriptor.h"
#include "cromer/result.h"

namespace cromer::core {

class HttpClient {
 public:
  HttpClient(std::string host, int port) : host_(std::move(host)), port_(port) {}

  /// The body of a 200 answer, at most 64 MB, within `seconds`. Connects if necessary; an Error closes the
  /// connection.
  Result<std::string> get(const std::string& target, double seconds);

 private:
  Result<std::string> ask(const std::string& target, double deadline, bool& stale);

  std::string host_;
  int port_;
  Descriptor connection_;
};

}  // namespace cromer::core
