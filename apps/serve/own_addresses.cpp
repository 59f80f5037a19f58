#include "apps/serve/own_addresses.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <memory>

namespace cromer::core::serve {

std::vector<std::string> reached_at(const std::string& address) {
  if (address != "0.0.0.0") return {address.find(':') == std::string::npos ? address : "[" + address + "]"};
  std::vector<std::string> all;
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) == 0) {
    const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> owner(first, ::freeifaddrs);
    for (const ifaddrs* each = first; each != nullptr; each = each->ifa_next) {
      if (each->ifa_addr == nullptr || each->ifa_addr->sa_family != AF_INET) continue;
      if (!(each->ifa_flags & IFF_UP) || (each->ifa_flags & IFF_LOOPBACK)) continue;
      char text[INET_ADDRSTRLEN];
      if (::inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(each->ifa_addr)->sin_addr, text,
                      sizeof text))
        all.emplace_back(text);
    }
  }
  if (all.empty()) all.emplace_back("127.0.0.1");
  return all;
}

}  // namespace cromer::core::serve
