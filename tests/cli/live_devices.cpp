#include "live_devices.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <utility>

namespace cromer::core::test {
namespace {

/// A socket that listens at a port of this computer; at a free one where that is 0, which is then told.
int listen_at(int& port) {
  const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int on = 1;
  setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<in_port_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  bind(listener, reinterpret_cast<sockaddr*>(&address), sizeof address);
  listen(listener, 8);
  socklen_t size = sizeof address;
  getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size);
  port = ntohs(address.sin_port);
  return listener;
}

}  // namespace

double swing(double t) {
  return 0.2 + 0.05 * std::exp(-swing_decay_rate * t) * std::cos(2 * M_PI * swing_frequency * t);
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void sleep_until(double time) {
  const double left = time - now();
  if (left > 0) std::this_thread::sleep_for(std::chrono::duration<double>(left));
}

SerialLine::SerialLine() {
  char folder[] = "/tmp/cromer-serial-XXXXXX";
  if (!mkdtemp(folder)) return;
  path_ = std::string(folder) + "/tty";
  open();
}

void SerialLine::open() {
  device_ = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  grantpt(device_);
  unlockpt(device_);
  const std::string name = ptsname(device_);
  // Kept open and raw, so that what is written before the program comes is neither echoed nor lost.
  other_ = ::open(name.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios settings{};
  tcgetattr(other_, &settings);
  cfmakeraw(&settings);
  tcsetattr(other_, TCSANOW, &settings);
  std::filesystem::create_symlink(name, path_);
}

void SerialLine::write(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::write(device_, bytes.data(), bytes.size());
    if (count <= 0) return;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void SerialLine::unplug() {
  if (other_ >= 0) ::close(other_);
  if (device_ >= 0) ::close(device_);
  device_ = other_ = -1;
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void SerialLine::plug_in_again() { open(); }

Phone::Phone(double rate, bool measuring) : rate_(rate) {
  if (measuring) begun_ = now();
  open();
  thread_ = std::thread([this] { serve(); });
}

void Phone::open() { listener_ = listen_at(port_); }

SilentPort::SilentPort() { listener_ = listen_at(port_); }

SilentPort::~SilentPort() { close(listener_); }

Phone::~Phone() {
  stop_ = true;
  thread_.join();
  if (listener_ >= 0) close(listener_);
}

void Phone::clear() {
  const std::lock_guard lock(mutex_);
  begun_ = now();
}

void Phone::go_away(double seconds) { away_until_ = now() + seconds; }

std::size_t Phone::measured() const {
  return begun_ < 0 ? 0 : static_cast<std::size_t>((now() - begun_) * rate_) + 1;
}

std::size_t Phone::samples() const {
  const std::lock_guard lock(mutex_);
  return measured();
}

void Phone::serve() {
  while (!stop_) {
    const bool away = now() < away_until_;
    if (away && listener_ >= 0) close(std::exchange(listener_, -1));
    if (!away && listener_ < 0) open();
    pollfd waiting{listener_, POLLIN, 0};
    if (poll(&waiting, 1, 20) <= 0) continue;
    const int connection = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (connection < 0) continue;
    serve_one(connection);
    close(connection);
  }
}

void Phone::serve_one(int connection) {
  std::string text;
  while (!stop_ && now() >= away_until_) {
    pollfd waiting{connection, POLLIN, 0};
    if (poll(&waiting, 1, 20) <= 0) continue;
    char bytes[4096];
    const ssize_t count = recv(connection, bytes, sizeof bytes, 0);
    if (count <= 0) return;
    text.append(bytes, static_cast<std::size_t>(count));
    const auto end = text.find("\r\n\r\n");
    if (end == std::string::npos) continue;
    const auto from = text.find(' ') + 1;
    const std::string body = answer(text.substr(from, text.find(' ', from) - from));
    text.erase(0, end + 4);
    // In chunks, as some phones do.
    char head[160];
    std::snprintf(
        head, sizeof head,
        "HTTP/1.1 200 OK\r\nContent-Type: application/json\r\nTransfer-Encoding: chunked\r\n\r\n%zx\r\n",
        body.size());
    const std::string whole = head + body + "\r\n0\r\n\r\n";
    send(connection, whole.data(), whole.size(), MSG_NOSIGNAL);
  }
}

std::string Phone::answer(const std::string& target) {
  const std::lock_guard lock(mutex_);
  if (target == "/config")
    return R"json({"title": "Swing", "buffers": [{"name": "t", "size": 0}, {"name": "x", "size": 0}],
      "export": [{"set": "Raw Data", "sources": [{"label": "Time (s)", "buffer": "t"},
                 {"label": "Position (m)", "buffer": "x"}]}]})json";
  if (target == "/control?cmd=start") {
    started_ = true;
    begun_ = now();
    return R"json({"result": true})json";
  }
  // "t=full&x=full" or "t=1.5&x=1.5|t": what is later than 1.5; buffers may differ in length by a sample.
  const auto at = target.find("?t=");
  const std::string after =
      at == std::string::npos ? "full" : target.substr(at + 3, target.find('&') - at - 3);
  const double threshold = after == "full" ? -1 : std::strtod(after.c_str(), nullptr);
  const std::size_t count = measured();
  std::string t, x;
  for (std::size_t n = 0; n < count; ++n) {
    const double time = static_cast<double>(n) / rate_;
    if (!(time > threshold)) continue;
    char number[32];
    std::snprintf(number, sizeof number, "%s%.9e", t.empty() ? "" : ",", time);
    t += number;
    if (n + 1 == count && n % 3 == 0) continue;
    std::snprintf(number, sizeof number, "%s%.9e", x.empty() ? "" : ",", swing(time));
    x += number;
  }
  return R"({"buffer":{"t":{"size":0,"updateMode":"partial","buffer":[)" + t +
         R"(]},"x":{"size":0,"updateMode":"partial","buffer":[)" + x +
         R"(]}},"status":{"session":"1","measuring":)" + (begun_ < 0 ? "false" : "true") +
         R"(,"timedRun":false,"countDown":0}})";
}

}  // namespace cromer::core::test
