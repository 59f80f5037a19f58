#include "apps/serve/http_server.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <utility>  // which Boost.Asio 1.74 needs and does not include
//
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <new>
#include <thread>

#include "apps/serve/http_connection.h"
#include "cromer/documents/json/live.h"

namespace cromer::core::serve {
namespace {

namespace asio = boost::asio;
using Failure = boost::system::error_code;

constexpr auto tick = std::chrono::milliseconds(100);

/// As many connections as the system allows, less some descriptors for files and devices; at most 1024, whose
/// requests and pieces of answers take a few tens of megabytes.
std::size_t most_connections() {
  constexpr rlim_t most = 1024, kept = 32, fewest = 8;
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) != 0) return 256;
  files.rlim_cur = std::max(files.rlim_cur, std::min<rlim_t>(files.rlim_max, 2 * most));
  ::setrlimit(RLIMIT_NOFILE, &files);
  ::getrlimit(RLIMIT_NOFILE, &files);
  return static_cast<std::size_t>(files.rlim_cur > kept + fewest ? std::min(most, files.rlim_cur - kept)
                                                                 : fewest);
}

}  // namespace

struct HttpServer::State {
  asio::io_context context{1};
  asio::ip::tcp::acceptor acceptor{context};
  asio::steady_timer timer{context}, pause{context};
  HttpConnections connections;
  std::size_t most = most_connections();
  // Whether a handler is waiting: none is after an allocation failed.
  bool accepting = false, ticking = false;

  void accept() {
    acceptor.async_accept([this](Failure failed, asio::ip::tcp::socket socket) {
      accepting = false;
      if (!acceptor.is_open()) return;
      if (failed || connections.count() >= most) connections.make_room();
      if (failed) {
        pause.expires_after(std::chrono::milliseconds(20));
        pause.async_wait([this](Failure stopped) {
          accepting = false;
          if (!stopped) accept();
        });
        accepting = true;
        return;
      }
      try {
        connections.begin(std::move(socket));
      } catch (const std::bad_alloc&) {
        connections.end_all();
      }
      accept();
    });
    accepting = true;
  }

  void send_events(const std::function<bool()>& stop) {
    ticking = false;
    if (stop()) return context.stop();
    try {
      connections.send_events();
    } catch (const std::bad_alloc&) {
      connections.end_all();
    }
    timer.expires_after(tick);
    timer.async_wait([this, &stop](Failure failed) {
      if (!failed) send_events(stop);
    });
    ticking = true;
  }
};

HttpAnswer refused(int status, const std::string& why) {
  return {status, "application/json", message_json(why)};
}

HttpServer::HttpServer(Handler handler, Events events, HttpLimits limits)
    : state_(std::make_unique<State>()) {
  state_->connections.handler = std::move(handler);
  state_->connections.events = std::move(events);
  state_->connections.limits = limits;
}

HttpServer::~HttpServer() = default;

Result<void> HttpServer::listen(const std::string& address, int port) {
  Failure failed;
  const auto place = asio::ip::make_address(address, failed);
  if (failed)
    return Error{"no_ip_address", {{"address", address}}};
  const asio::ip::tcp::endpoint end(place, static_cast<unsigned short>(port));
  auto& acceptor = state_->acceptor;
  acceptor.open(end.protocol(), failed);
  if (!failed) acceptor.set_option(asio::socket_base::reuse_address(true), failed);
  if (!failed) acceptor.bind(end, failed);
  if (!failed) acceptor.listen(asio::socket_base::max_listen_connections, failed);
  if (failed) return Error{"cannot_serve", {{"address", address}, {"port", port}, {"reason", failed.message()}}};
  return {};
}

int HttpServer::port() const {
  Failure failed;
  return state_->acceptor.local_endpoint(failed).port();
}

void HttpServer::run(const std::function<bool()>& stop) {
  // When memory runs out, nobody is served for a while; the recording goes on.
  for (;;) {
    try {
      if (!state_->accepting) state_->accept();
      if (!state_->ticking) state_->send_events(stop);
      state_->context.run();
      return;
    } catch (const std::bad_alloc&) {
      state_->connections.end_all();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
}

}  // namespace cromer::core::serve
