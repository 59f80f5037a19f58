#include "apps/serve/guard.h"

#include <fmt/format.h>

#include <utility>  // which Boost.Asio 1.74 needs and does not include
//
#include <boost/asio/ip/address.hpp>

#include "apps/serve/lab_page.h"
#include "cromer/base/ascii.h"
#include "cromer/os/process.h"

namespace cromer::core::serve {
namespace {

bool is_number(std::string_view host) {
  boost::system::error_code failed;
  boost::asio::ip::make_address(std::string(host), failed);
  return !failed && host.find('%') == std::string_view::npos;
}

/// Host or Origin without its scheme: "127.0.0.1:8000", "localhost:8000", "[::1]:8000".
bool is_ours(const Guard& guard, std::string_view place) {
  std::string_view host = place, port = "80";
  const std::size_t colon = place.rfind(':'), bracket = place.rfind(']');
  if (colon != std::string_view::npos && (bracket == std::string_view::npos || colon > bracket)) {
    host = place.substr(0, colon);
    port = place.substr(colon + 1);
  }
  if (port != std::to_string(guard.port)) return false;
  if (host.starts_with('[') && host.ends_with(']'))
    host = host.substr(1, host.size() - 2);
  else if (host.find(':') != std::string_view::npos)
    return false;  // an address with colons stands in brackets
  if (lower(host) == "localhost" || is_loopback(host)) return true;
  return guard.beyond_this_computer && is_number(host);
}

/// Takes the same time for every difference.
bool same(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned char>(a[i] ^ b[i]);
  return difference == 0;
}

/// Whether one of "a=1; b=2" is the token.
bool holds_token(std::string_view list, char separator, std::string_view name, const std::string& token) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(separator), list.size());
    const std::string_view each = trimmed(list.substr(0, end));
    if (each.starts_with(name) && same(each.substr(name.size()), token)) return true;
    list.remove_prefix(std::min(list.size(), end + 1));
  }
  return false;
}

/// Cookies know no ports: another server at this address has another name for its own.
std::string cookie_name(const Guard& guard) { return fmt::format("cromer_token_{}", guard.port); }

}  // namespace

bool is_loopback(std::string_view address) {
  return (address.starts_with("127.") && is_number(address)) || address == "::1";
}

std::optional<HttpAnswer> refusal(const Guard& guard, const HttpRequest& request) {
  if (!is_ours(guard, request.host)) return refused(403, "this server does not go by that Host");
  if (!request.origin.empty() &&
      !(request.origin.starts_with("http://") && is_ours(guard, std::string_view(request.origin).substr(7))))
    return refused(403, "pages of another Origin may not ask this server");
  if (request.fetch_site == "cross-site" && request.fetch_mode != "navigate")
    return refused(403, "pages of another site may not ask this server");
  if (!guard.token.empty() && !holds_token(request.query, '&', "token=", guard.token) &&
      !holds_token(request.cookie, ';', cookie_name(guard) + "=", guard.token))
    return request.path == "/" ? HttpAnswer{401, "text/html; charset=utf-8", token_is_missing()}
                               : refused(401, "open the address that cromer serve printed, with its token");
  return std::nullopt;
}

void keep_token(const Guard& guard, HttpAnswer& answer) {
  if (!guard.token.empty())
    answer.headers.emplace_back("Set-Cookie", fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/",
                                                          cookie_name(guard), guard.token));
}

std::string random_token() {
  unsigned char bytes[16];
  os::fill_randomly(bytes);
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

}  // namespace cromer::core::serve
