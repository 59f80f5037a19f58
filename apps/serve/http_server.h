// A small HTTP/1.1 server on one thread: nobody waits for a connection that is idle, slow or hostile.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cromer/result.h"

namespace cromer::core::serve {

struct HttpRequest {
  std::string method;        ///< "GET", ...
  std::string path;          ///< up to the question mark, as sent; begins with /
  std::string query;         ///< behind it
  std::string host, origin;  ///< "" where missing; more than one of either is refused before
  std::string cookie, content_type, fetch_site, fetch_mode;
  std::string body;
};

struct HttpAnswer {
  int status = 200;
  std::string type = "application/json";
  std::string body{};
  std::vector<std::pair<std::string, std::string>> headers{};
  bool events = false;                          ///< the connection stays open for server-sent events
  std::shared_ptr<const std::string> shared{};  ///< in place of the body: one for all who ask
  std::string policy{};                         ///< of its content; "": nothing runs and nothing is fetched
  std::string file{};  ///< in place of the body: the file of this path as it is now, sent piece by piece
};

/// A status other than 200, and why in a sentence.
HttpAnswer refused(int status, const std::string& why);

/// What one listener has been sent already.
struct EventCursor {
  std::size_t recording = 0, rows = 0, notices = 0, fits = 0;
  double status_at = 0;  // [s]
};

struct HttpLimits {
  std::size_t header = 8 << 10, body = 4 << 10;  // bytes
  double request = 5;                            // [s] for a whole request, idleness before it included
  double answer = 30;                            // [s] for the client to take a piece of an answer
  std::size_t listeners = 64;                    ///< of events at the same time
};

/// The addresses at which a server at `address` is reached: for 0.0.0.0 all IPv4 addresses of this computer
/// except the loopback's (or that one, if there are no others); else the address itself, [in brackets] if it
/// has colons.
std::vector<std::string> reached_at(const std::string& address);

class HttpServer {
 public:
  using Respond = std::function<void(HttpAnswer)>;
  /// Called in the server's thread and never blocking; `respond` may be called later and from any thread.
  using Handler = std::function<void(const HttpRequest&, Respond respond)>;
  /// What is new for a listener, as text of an event stream; asked ten times a second.
  using Events = std::function<std::string(EventCursor&)>;

  HttpServer(Handler handler, Events events, HttpLimits limits = {});
  ~HttpServer();

  /// Port 0 takes a free one. An Error names address and cause.
  Result<void> listen(const std::string& address, int port);
  int port() const;

  /// Serves until `stop` is true.
  void run(const std::function<bool()>& stop);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cromer::core::serve
