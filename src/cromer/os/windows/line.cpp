#include "cromer/os/line.h"

#include <winsock2.h>
//
#include <fcntl.h>
#include <io.h>
#include <mstcpip.h>
#include <windows.h>
#include <ws2tcpip.h>

#include <chrono>
#include <system_error>
#include <thread>

#include "cromer/os/windows/native.h"

namespace cromer::core {
namespace {

std::string last_error() { return std::system_category().message(static_cast<int>(::GetLastError())); }

SOCKET socket_of(const Descriptor& descriptor) {
  return reinterpret_cast<SOCKET>(os::handle_of(descriptor.number()));
}

bool is_socket(const Descriptor& descriptor) {
  int type = 0, size = sizeof type;
  return ::getsockopt(socket_of(descriptor), SOL_SOCKET, SO_TYPE, reinterpret_cast<char*>(&type), &size) == 0;
}

Descriptor owned(HANDLE handle) {
  return Descriptor(::_open_osfhandle(reinterpret_cast<std::intptr_t>(handle), _O_BINARY));
}

/// Sockets work once this was called.
void start_sockets() {
  static const int started = [] {
    WSADATA about{};
    return ::WSAStartup(MAKEWORD(2, 2), &about);
  }();
  (void)started;
}

bool poll_for(SOCKET socket, short events, double seconds) {
  WSAPOLLFD waiting{socket, events, 0};
  return ::WSAPoll(&waiting, 1, static_cast<int>(seconds * 1000)) > 0;
}

/// 0, or the number of the error.
int connect_within(SOCKET socket, const addrinfo& address, double seconds) {
  u_long waits_not = 1, waits = 0;
  ::ioctlsocket(socket, static_cast<long>(FIONBIO), &waits_not);
  int failed = 0, size = sizeof failed;
  if (::connect(socket, address.ai_addr, static_cast<int>(address.ai_addrlen)) != 0) {
    failed = ::WSAGetLastError();
    if (failed == WSAEWOULDBLOCK) {
      if (!poll_for(socket, POLLWRNORM, seconds)) return WSAETIMEDOUT;
      ::getsockopt(socket, SOL_SOCKET, SO_ERROR, reinterpret_cast<char*>(&failed), &size);
    }
  }
  ::ioctlsocket(socket, static_cast<long>(FIONBIO), &waits);
  return failed;
}

/// How many bytes a serial line or a pipe has; nothing where its other end is gone.
bool has_something(HANDLE handle, bool is_pipe) {
  DWORD count = 0;
  if (is_pipe) return !::PeekNamedPipe(handle, nullptr, 0, nullptr, &count, nullptr) || count > 0;
  COMSTAT status{};
  return !::ClearCommError(handle, &count, &status) || status.cbInQue > 0;
}

}  // namespace

Result<Descriptor> open_serial(const std::string& device, int baud) {
  // COM10 and later are known by this name alone.
  const std::string path = device.starts_with("\\\\") ? device : "\\\\.\\" + device;
  const HANDLE handle =
      ::CreateFileW(os::native(path).c_str(), GENERIC_READ, 0, nullptr, OPEN_EXISTING, 0, nullptr);
  if (handle == INVALID_HANDLE_VALUE)
    return Error{"serial_not_opened", {{"device", device}, {"why", last_error()}}};
  Descriptor line = owned(handle);
  DCB settings{};
  settings.DCBlength = sizeof settings;
  if (!::GetCommState(handle, &settings))
    return Error{"no_serial_line", {{"device", device}, {"why", last_error()}}};
  const DWORD length = settings.DCBlength;
  settings = {};
  settings.DCBlength = length;
  settings.BaudRate = static_cast<DWORD>(baud);
  settings.ByteSize = 8;
  settings.fBinary = TRUE;
  settings.fDtrControl = DTR_CONTROL_ENABLE;
  settings.fRtsControl = RTS_CONTROL_ENABLE;
  if (!::SetCommState(handle, &settings))
    return Error{"serial_speed_not_set", {{"device", device}, {"baud", baud}, {"why", last_error()}}};
  // Reading gives what is there.
  COMMTIMEOUTS at_once{};
  at_once.ReadIntervalTimeout = MAXDWORD;
  ::SetCommTimeouts(handle, &at_once);
  return line;
}

Result<Descriptor> open_tcp(const std::string& host, int port, double seconds) {
  start_sockets();
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const std::string service = std::to_string(port);
  if (const int failed = ::getaddrinfo(host.c_str(), service.c_str(), &wanted, &found); failed != 0)
    return Error{"host_not_found", {{"host", host}, {"why", std::system_category().message(failed)}}};
  int failed = WSAEHOSTUNREACH;
  SOCKET socket = INVALID_SOCKET;
  for (const addrinfo* each = found; each && failed != 0; each = each->ai_next) {
    // Not overlapped: read(2) and write(2) work on it.
    socket = ::WSASocketW(each->ai_family, SOCK_STREAM, 0, nullptr, 0, WSA_FLAG_NO_HANDLE_INHERIT);
    if (socket == INVALID_SOCKET) continue;
    failed = connect_within(socket, *each, seconds);
    if (failed != 0) ::closesocket(socket);
  }
  ::freeaddrinfo(found);
  if (failed != 0)
    return Error{"host_not_reached",
                 {{"host", host}, {"port", port}, {"why", std::system_category().message(failed)}}};
  // A pulled cable is noticed within half a minute.
  tcp_keepalive alive{1, 10000, 5000};
  DWORD none = 0;
  ::WSAIoctl(socket, SIO_KEEPALIVE_VALS, &alive, sizeof alive, nullptr, 0, &none, nullptr, nullptr);
  const int on = 1;
  ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, reinterpret_cast<const char*>(&on), sizeof on);
  return owned(reinterpret_cast<HANDLE>(socket));
}

bool readable(const Descriptor& descriptor, double seconds) {
  const HANDLE handle = os::handle_of(descriptor.number());
  const DWORD type = ::GetFileType(handle);
  if (type == FILE_TYPE_DISK) return true;
  if (is_socket(descriptor)) return poll_for(socket_of(descriptor), POLLRDNORM, seconds);
  DWORD mode = 0;
  if (::GetConsoleMode(handle, &mode))
    return ::WaitForSingleObject(handle, static_cast<DWORD>(seconds * 1000)) == WAIT_OBJECT_0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!has_something(handle, type == FILE_TYPE_PIPE)) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

bool send_all(const Descriptor& connection, std::string_view bytes) {
  while (!bytes.empty()) {
    const int count = ::send(socket_of(connection), bytes.data(), static_cast<int>(bytes.size()), 0);
    if (count <= 0) return false;  // so little always fits
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

Descriptor standard_input_again() { return Descriptor(::_dup(0)); }

}  // namespace cromer::core
