// A lab without a device, in a thread of this program; each input is what one connection sends.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>

#include "apps/serve/http_server.h"
#include "apps/serve/lab.h"
#include "apps/serve/live_session.h"
#include "targets.h"
#include "tests/support/peer.h"

namespace cromer::core::fuzz {
namespace {

class Served {
 public:
  Served()
      : server_([this](const serve::HttpRequest& request,
                       const serve::HttpServer::Respond& respond) { lab_.handle(request, respond); },
                [this](serve::EventCursor& cursor) { return session_.events(cursor); }, {.request = 0.2}) {
    if (!server_.listen("127.0.0.1", 0)) std::abort();
    thread_ = std::thread([this] { server_.run([this] { return stop_.load(); }); });
  }
  ~Served() {
    stop_ = true;
    thread_.join();
  }
  int port() const { return server_.port(); }

 private:
  std::atomic<bool> stop_ = false;
  serve::LiveSession session_{{}, {}};
  serve::Lab lab_{session_, {.port = 8000, .beyond_this_computer = false, .token = ""}, ""};
  serve::HttpServer server_;
  std::thread thread_;
};

}  // namespace

int http(const std::uint8_t* data, std::size_t size) {
  static Served served;
  std::optional<test::Peer> peer(std::in_place, served.port());
  // So many connections use up the ports, which are free again after a minute.
  for (int tries = 0; !peer->connected() && tries < 700; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    peer.emplace(served.port());
  }
  if (!peer->connected()) std::abort();
  peer->send(std::string(reinterpret_cast<const char*>(data), size));
  peer->finish();
  const std::string answer = peer->receive(1, "event: status");
  if (answer.empty()) return 0;
  const bool whole = answer.starts_with("HTTP/1.1 ") && answer.find("\r\n\r\n") != std::string::npos;
  const int status = whole ? std::atoi(answer.c_str() + 9) : 0;
  // 503: no page is there.
  if (!(status >= 200 && status < 500) && status != 501 && status != 503 && status != 505) {
    std::fprintf(stderr, "answered: \"%s\"\n", answer.c_str());
    std::abort();
  }
  return 0;
}

}  // namespace cromer::core::fuzz
