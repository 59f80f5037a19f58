#include "cromer/live/source.h"

#include <algorithm>
#include <optional>

#include "cromer/base/ascii.h"

namespace cromer::core {
namespace {

std::optional<int> whole_number(std::string_view text) {
  if (text.empty() || text.size() > 8 || !std::all_of(text.begin(), text.end(), is_digit))
    return std::nullopt;
  int number = 0;
  for (const char c : text) number = 10 * number + (c - '0');
  return number;
}

Error wrong(std::string_view text, const Notice& why) {
  return Error{"source_not_understood", {{"source", text}, {"why", why}}};
}

/// "HOST", "HOST:PORT", "[::1]:PORT"; an Error if the port is not valid.
Result<SourceName> with_port(std::string_view text, std::string_view rest, SourceName name) {
  std::string_view host = rest, port;
  if (rest.starts_with('[')) {
    const std::size_t close = rest.find(']');
    if (close == std::string_view::npos) return wrong(text, Notice{"address_has_no_closing_bracket"});
    host = rest.substr(1, close - 1);
    port = rest.substr(close + 1);
    if (!port.empty() && port.front() != ':') return wrong(text, Notice{"colon_stands_before_the_port"});
  } else if (const std::size_t colon = rest.rfind(':'); colon != std::string_view::npos) {
    host = rest.substr(0, colon);
    port = rest.substr(colon);
  }
  if (host.empty()) return wrong(text, Notice{"host_is_missing"});
  name.place = host;
  if (port.empty() && name.number == 0) return wrong(text, Notice{"port_is_missing"});
  if (port.empty()) return name;
  const auto number = whole_number(port.substr(1));
  if (!number || *number < 1 || *number > 65535) return wrong(text, Notice{"no_port"});
  name.number = *number;
  return name;
}

}  // namespace

Result<SourceName> parse_source(std::string_view text) {
  if (text == "-") return SourceName{};
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return wrong(text, Notice{"no_kind_of_source_named"});
  const std::string_view kind = text.substr(0, colon), rest = text.substr(colon + 1);
  if (kind == "tcp") return with_port(text, rest, {SourceKind::tcp});
  if (kind == "phyphox") return with_port(text, rest, {SourceKind::phyphox, "", 8080});
  if (kind != "serial") return wrong(text, Notice{"no_kind_of_source", {{"kind", kind}}});
  SourceName name{SourceKind::serial, std::string(rest), 115200};
  // Paths below /dev/serial/by-path hold colons of their own.
  if (const std::size_t last = rest.rfind(':'); last != std::string_view::npos)
    if (const auto baud = whole_number(rest.substr(last + 1))) {
      name.place = rest.substr(0, last);
      name.number = *baud;
    }
  if (name.place.empty()) return wrong(text, Notice{"device_is_missing"});
  return name;
}

}  // namespace cromer::core
