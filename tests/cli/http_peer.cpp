#include "http_peer.h"

#include <arpa/inet.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <utility>

#include "live_devices.h"

namespace cromer::test {

Peer::Peer(int port) {
  socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<in_port_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) return;
  ::close(socket_);
  socket_ = -1;
}

Peer::~Peer() {
  if (socket_ >= 0) ::close(socket_);
}

Peer::Peer(Peer&& other) noexcept : socket_(std::exchange(other.socket_, -1)) {}

bool Peer::send(const std::string& bytes) const {
  for (std::size_t sent = 0; sent < bytes.size();) {
    pollfd waiting{socket_, POLLOUT, 0};
    if (::poll(&waiting, 1, 2000) <= 0) return false;
    const ssize_t count =
        ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count <= 0) return false;
    sent += static_cast<std::size_t>(count);
  }
  return true;
}

std::string Peer::receive(double seconds, const std::string& until) const {
  std::string text;
  const double end = now() + seconds;
  while (until.empty() || text.find(until) == std::string::npos) {
    pollfd waiting{socket_, POLLIN, 0};
    const double left = end - now();
    if (left <= 0 || ::poll(&waiting, 1, static_cast<int>(left * 1000) + 1) <= 0) break;
    char bytes[65536];
    const ssize_t count = ::recv(socket_, bytes, sizeof bytes, 0);
    if (count <= 0) break;
    text.append(bytes, static_cast<std::size_t>(count));
  }
  return text;
}

bool Peer::is_closed_within(double seconds) const {
  const double end = now() + seconds;
  while (now() < end) {
    pollfd waiting{socket_, POLLIN, 0};
    if (::poll(&waiting, 1, 50) <= 0) continue;
    char bytes[4096];
    if (::recv(socket_, bytes, sizeof bytes, 0) <= 0) return true;
  }
  return false;
}

std::string request(int port, const std::string& first_line, const std::string& headers,
                    const std::string& body) {
  const bool has_host = headers.find("Host:") != std::string::npos;
  return first_line + " HTTP/1.1\r\n" + (has_host ? "" : "Host: 127.0.0.1:" + std::to_string(port) + "\r\n") +
         headers + (body.empty() ? "" : "Content-Length: " + std::to_string(body.size()) + "\r\n") +
         "Connection: close\r\n\r\n" + body;
}

std::string ask(int port, const std::string& bytes, double seconds) {
  const Peer peer(port);
  peer.send(bytes);
  return peer.receive(seconds);
}

int status_of(const std::string& answer) {
  return answer.starts_with("HTTP/1.1 ") ? std::atoi(answer.c_str() + 9) : 0;
}

std::string body_of(const std::string& answer) {
  const auto end = answer.find("\r\n\r\n");
  return end == std::string::npos ? "" : answer.substr(end + 4);
}

Served::Served(const Folder& folder, std::vector<std::string> more) : folder_(folder) {
  folder.write("page.html", "<!DOCTYPE html><html><head><title>stand-in for the lab</title></head></html>\n");
  more.insert(more.begin(), {"serve", "--port", "0", "--page", "page.html"});
  process_ = folder.start(more);
  for (int i = 0; i < 1000 && address_.find('\n') == std::string::npos; ++i) {
    sleep_until(now() + 0.01);
    if (folder.has(".standard-output")) address_ = folder.read(".standard-output");
  }
  address_ = address_.substr(0, address_.find('\n'));
  const auto colon = address_.rfind(':');
  if (colon != std::string::npos) port_ = std::atoi(address_.c_str() + colon + 1);
}

Served::~Served() {
  ::kill(process_, SIGTERM);
  folder_.wait(process_);
}

double Served::memory() const {
  std::ifstream status("/proc/" + std::to_string(process_) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
  return HUGE_VAL;
}

bool Served::is_up() const {
  return ::kill(process_, 0) == 0 && ::waitpid(process_, nullptr, WNOHANG) == 0 &&
         status_of(ask(port_, request(port_, "GET /"))) == 200;
}

}  // namespace cromer::test
