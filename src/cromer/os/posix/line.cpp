#include "cromer/os/line.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace cromer::core {
namespace {

struct Speed {
  int baud;
  speed_t code;
};
constexpr Speed speeds[] = {{1200, B1200},       {2400, B2400},      {4800, B4800},     {9600, B9600},
                            {19200, B19200},     {38400, B38400},    {57600, B57600},   {115200, B115200},
                            {230400, B230400},   {460800, B460800},  {500000, B500000}, {921600, B921600},
                            {1000000, B1000000}, {2000000, B2000000}};

bool poll_for(int number, short events, double seconds) {
  pollfd waiting{number, events, 0};
  return ::poll(&waiting, 1, static_cast<int>(seconds * 1000)) > 0;
}

/// 0, or the number of the error.
int connect_within(int number, const addrinfo& address, double seconds) {
  if (::connect(number, address.ai_addr, address.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  if (!poll_for(number, POLLOUT, seconds)) return ETIMEDOUT;
  int failed = 0;
  socklen_t size = sizeof failed;
  return ::getsockopt(number, SOL_SOCKET, SO_ERROR, &failed, &size) == 0 ? failed : errno;
}

}  // namespace

Result<Descriptor> open_serial(const std::string& device, int baud) {
  const Speed* speed = nullptr;
  for (const Speed& each : speeds)
    if (each.baud == baud) speed = &each;
  if (!speed) return Error{"serial_speed_unknown", {{"device", device}, {"baud", baud}}};
  Descriptor line(::open(device.c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!line.is_open()) return Error{"serial_not_opened", {{"device", device}, {"why", std::strerror(errno)}}};
  termios settings{};
  if (::tcgetattr(line.number(), &settings) != 0)
    return Error{"no_serial_line", {{"device", device}, {"why", std::strerror(errno)}}};
  ::cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS);
  ::cfsetispeed(&settings, speed->code);
  ::cfsetospeed(&settings, speed->code);
  if (::tcsetattr(line.number(), TCSANOW, &settings) != 0)
    return Error{"serial_speed_not_set", {{"device", device}, {"baud", baud}, {"why", std::strerror(errno)}}};
  return line;
}

Result<Descriptor> open_tcp(const std::string& host, int port, double seconds) {
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const std::string service = std::to_string(port);
  if (const int failed = ::getaddrinfo(host.c_str(), service.c_str(), &wanted, &found); failed != 0)
    return Error{"host_not_found", {{"host", host}, {"why", ::gai_strerror(failed)}}};
  int failed = EHOSTUNREACH;
  Descriptor connection;
  for (const addrinfo* each = found; each; each = each->ai_next) {
    connection = Descriptor(::socket(each->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!connection.is_open()) continue;
    failed = connect_within(connection.number(), *each, seconds);
    if (failed == 0) break;
  }
  ::freeaddrinfo(found);
  if (failed != 0)
    return Error{"host_not_reached", {{"host", host}, {"port", port}, {"why", std::strerror(failed)}}};
  // A pulled cable is noticed within half a minute.
  const int on = 1, idle = 10, between = 5, probes = 3;
  ::setsockopt(connection.number(), SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
  ::setsockopt(connection.number(), IPPROTO_TCP, TCP_KEEPIDLE, &idle, sizeof idle);
  ::setsockopt(connection.number(), IPPROTO_TCP, TCP_KEEPINTVL, &between, sizeof between);
  ::setsockopt(connection.number(), IPPROTO_TCP, TCP_KEEPCNT, &probes, sizeof probes);
  ::setsockopt(connection.number(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  return connection;
}

bool readable(const Descriptor& descriptor, double seconds) {
  return poll_for(descriptor.number(), POLLIN, seconds);
}

bool send_all(const Descriptor& connection, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(connection.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;  // so little always fits
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

Descriptor standard_input_again() { return Descriptor(::dup(STDIN_FILENO)); }

}  // namespace cromer::core
