#include "cromer/os/line.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#ifdef __APPLE__
#include <sys/ioctl.h>
#endif
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
#ifdef __APPLE__
#define CROMER_SPEED(baud) \
  { baud, baud }
#else
#define CROMER_SPEED(baud) \
  { baud, B##baud }
#endif
constexpr Speed speeds[] = {CROMER_SPEED(1200),    CROMER_SPEED(2400),   CROMER_SPEED(4800),
                            CROMER_SPEED(9600),    CROMER_SPEED(19200),  CROMER_SPEED(38400),
                            CROMER_SPEED(57600),   CROMER_SPEED(115200), CROMER_SPEED(230400),
                            CROMER_SPEED(460800),  CROMER_SPEED(500000), CROMER_SPEED(921600),
                            CROMER_SPEED(1000000), CROMER_SPEED(2000000)};
#undef CROMER_SPEED

#ifdef __APPLE__
// Speeds are their own codes; those that POSIX does not know are set by the driver (IOKit, IOSSIOSPEED).
bool set_speed(int number, termios& settings, const Speed& speed) {
  constexpr int most = 230400;
  ::cfsetspeed(&settings, speed.baud <= most ? speed.code : B9600);
  speed_t asked = speed.code;
  return ::tcsetattr(number, TCSANOW, &settings) == 0 &&
         (speed.baud <= most || ::ioctl(number, _IOW('T', 2, speed_t), &asked) == 0);
}
#else
bool set_speed(int number, termios& settings, const Speed& speed) {
  ::cfsetspeed(&settings, speed.code);
  return ::tcsetattr(number, TCSANOW, &settings) == 0;
}
#endif

/// A socket that does not wait, for this program alone; writing where nobody reads is an error, not a signal.
int open_socket(int family) {
#ifdef __APPLE__
  const int number = ::socket(family, SOCK_STREAM, 0);
  if (number < 0) return number;
  const int on = 1;
  ::setsockopt(number, SOL_SOCKET, SO_NOSIGPIPE, &on, sizeof on);
  ::fcntl(number, F_SETFL, O_NONBLOCK);
  ::fcntl(number, F_SETFD, FD_CLOEXEC);
  return number;
#else
  return ::socket(family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
#endif
}

#ifdef __APPLE__
constexpr int keepalive_idle = TCP_KEEPALIVE, no_signal = 0;
#else
constexpr int keepalive_idle = TCP_KEEPIDLE, no_signal = MSG_NOSIGNAL;
#endif

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
  if (!set_speed(line.number(), settings, *speed))
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
    connection = Descriptor(open_socket(each->ai_family));
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
  ::setsockopt(connection.number(), IPPROTO_TCP, keepalive_idle, &idle, sizeof idle);
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
    const ssize_t count = ::send(connection.number(), bytes.data(), bytes.size(), no_signal);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;  // so little always fits
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

Descriptor standard_input_again() { return Descriptor(::dup(STDIN_FILENO)); }

}  // namespace cromer::core
