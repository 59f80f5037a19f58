// A server on this computer that answers as it is told.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace cromer::core::test {

/// Bytes to send, and whether to close the connection behind them.
struct Reply {
  std::string bytes;
  bool close = false;
};

inline std::string http(const std::string& body, const std::string& fields = "") {
  return "HTTP/1.1 200 OK\r\n" + fields + "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" +
         body;
}

/// One connection at a time.
class Server {
 public:
  using Answer = std::function<Reply(const std::string& target)>;

  explicit Server(Answer answer) : answer_(std::move(answer)), listening_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ::bind(listening_, reinterpret_cast<sockaddr*>(&address), sizeof address);
    ::listen(listening_, 8);
    socklen_t size = sizeof address;
    ::getsockname(listening_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { serve(); });
  }
  ~Server() {
    over_ = true;
    thread_.join();
    ::close(listening_);
  }
  Server(const Server&) = delete;

  int port() const { return port_; }
  int connections() const { return connections_; }
  std::vector<std::string> requests() const {
    const std::lock_guard lock(mutex_);
    return requests_;
  }

 private:
  bool waits(int descriptor) const {
    pollfd waiting{descriptor, POLLIN, 0};
    while (!over_)
      if (::poll(&waiting, 1, 2) > 0) return true;
    return false;
  }
  void serve() {
    while (waits(listening_)) {
      const int connection = ::accept(listening_, nullptr, nullptr);
      ++connections_;
      while (waits(connection) && answer(connection)) continue;
      ::close(connection);
    }
  }
  bool answer(int connection) {
    char bytes[4096];
    const ssize_t count = ::recv(connection, bytes, sizeof bytes, 0);
    if (count <= 0) return false;
    const std::string request(bytes, static_cast<std::size_t>(count));
    {
      const std::lock_guard lock(mutex_);
      requests_.push_back(request);
    }
    const std::size_t from = request.find(' ') + 1;
    const Reply reply = answer_(request.substr(from, request.find(' ', from) - from));
    ::send(connection, reply.bytes.data(), reply.bytes.size(), MSG_NOSIGNAL);
    return !reply.close;
  }

  Answer answer_;
  int listening_, port_ = 0;
  std::atomic<bool> over_{false};
  std::atomic<int> connections_{0};
  mutable std::mutex mutex_;
  std::vector<std::string> requests_;
  std::thread thread_;
};

}  // namespace cromer::core::test
