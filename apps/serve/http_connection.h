// The connections of the HTTP server; included by its sources only.
#pragma once

#include <utility>  // which Boost.Asio 1.74 needs and does not include
//
#include <boost/asio/ip/tcp.hpp>
#include <map>
#include <memory>

#include "apps/serve/http_server.h"

namespace cromer::core::serve {

class HttpConnection;

/// All that are open, the oldest first.
class HttpConnections {
 public:
  HttpServer::Handler handler;
  HttpServer::Events events;
  HttpLimits limits;

  void begin(boost::asio::ip::tcp::socket socket);
  void end(std::size_t number) { open_.erase(number); }
  std::size_t count() const { return open_.size(); }
  std::size_t listeners() const;

  /// Closes the oldest that waits for a request; else the oldest that listens; else the oldest that an answer
  /// is being sent to.
  void make_room();
  void end_all();
  /// To each listener, unless it is still busy with what it was sent before.
  void send_events();

 private:
  std::size_t next_ = 0;
  std::map<std::size_t, std::shared_ptr<HttpConnection>> open_;
};

}  // namespace cromer::core::serve
