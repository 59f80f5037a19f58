// Who may ask the server: its own pages, on this computer or with the token. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/serve/http_server.h"

namespace cromer::core::serve {

struct Guard {
  int port = 0;
  bool beyond_this_computer = false;  ///< served at an address that others can reach
  std::string token;                  ///< "" where none is needed
};

/// The answer to a request that is refused; nothing for one that may pass. A foreign page whose name was made
/// to point here (DNS rebinding) still sends its own name as Host: only localhost and numbers pass, with our
/// port. A foreign Origin is always refused.
std::optional<HttpAnswer> refusal(const Guard& guard, const HttpRequest& request);

/// Sets the token as a cookie that only this server sees, for the page that was opened with it.
void keep_token(const Guard& guard, HttpAnswer& answer);

/// 128 bits from the system, as 32 hexadecimal digits.
std::string random_token();

/// 127.0.0.0/8 and ::1.
bool is_loopback(std::string_view address);

}  // namespace cromer::core::serve
