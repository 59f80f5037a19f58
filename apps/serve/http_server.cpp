#include "apps/serve/http_server.h"

#include <fmt/format.h>

#include <utility>  // which Boost.Asio 1.74 needs and does not include
//
#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <thread>

#include "cromer/documents/json/live.h"
#include "cromer/os/descriptor.h"
#include "cromer/os/file.h"
#include "cromer/os/process.h"

namespace cromer::core::serve {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using Failure = boost::system::error_code;

namespace {

std::chrono::milliseconds in_ms(double seconds) {
  return std::chrono::milliseconds(static_cast<long>(1000 * seconds));
}

std::string text(boost::string_view view) { return {view.data(), view.size()}; }

/// The headers of every answer: nothing is guessed, framed, cached or leaked to others, and only what
/// `policy` allows runs.
template <class Message>
void add_safety(Message& message, const std::string& policy) {
  const std::string_view none =
      "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'";
  message.set("Content-Security-Policy",
              (policy.empty() ? std::string(none) : policy) + "; frame-ancestors 'none'");
  message.set("X-Content-Type-Options", "nosniff");
  message.set("Referrer-Policy", "no-referrer");
  message.set("Cross-Origin-Resource-Policy", "same-origin");
  message.set(http::field::cache_control, "no-store");
}

constexpr auto tick = std::chrono::milliseconds(100);

/// As many connections as the system allows, less some descriptors for files and devices; at most 1024, whose
/// requests and pieces of answers take a few tens of megabytes.
std::size_t most_connections() {
  constexpr std::size_t most = 1024, kept = 32, fewest = 8;
  const std::size_t files = os::files_at_most(2 * most);
  return files > kept + fewest ? std::min(most, files - kept) : fewest;
}

}  // namespace

class HttpConnection;

/// All open connections, the oldest first.
class HttpConnections {
 public:
  HttpServer::Handler handler;
  HttpServer::Events events;
  HttpLimits limits;

  void begin(boost::asio::ip::tcp::socket socket);
  void end(std::size_t number) { open_.erase(number); }
  std::size_t count() const { return open_.size(); }
  std::size_t listeners() const;

  /// Closes the oldest connection that waits for a request; else the oldest listener; else the oldest that is
  /// being answered.
  void make_room();
  void end_all();
  /// Sends to each listener that has taken what it was sent before.
  void send_events();

 private:
  std::size_t next_ = 0;
  std::map<std::size_t, std::shared_ptr<HttpConnection>> open_;
};

class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(HttpConnections& all, std::size_t number, asio::ip::tcp::socket socket)
      : all_(all), number_(number), stream_(std::move(socket)) {}

  void read();
  /// Lets go of it; what still waits for the socket ends with an error.
  void close() {
    Failure ignored;
    stream_.socket().close(ignored);
    all_.end(number_);
  }
  bool idle() const { return idle_; }
  bool listens() const { return listens_; }
  bool answers() const { return answers_; }
  void send_events();

 private:
  void take(Failure failed);
  void handle();
  void answer(HttpAnswer what, bool keep);
  void send_next();
  void begin_events(const HttpAnswer& what);
  void linger();

  HttpConnections& all_;
  std::size_t number_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_{64 << 10};
  std::optional<http::request_parser<http::string_body>> parser_;
  bool idle_ = true, listens_ = false, busy_ = false;
  // The answer being sent: its head and, read a piece at a time, its body.
  bool answers_ = false, keep_ = false;
  std::shared_ptr<const std::string> body_;
  Descriptor file_;
  std::size_t sent_bytes_ = 0, left_ = 0;  ///< of the body
  std::string piece_;
  EventCursor cursor_;
  std::string events_;
  std::chrono::steady_clock::time_point sent_{};
  std::size_t thrown_away_ = 0;
};

void HttpConnection::read() {
  parser_.emplace();
  parser_->header_limit(static_cast<std::uint32_t>(all_.limits.header));
  parser_->body_limit(all_.limits.body);
  idle_ = true;
  // One deadline for the whole request: sending it a byte at a time gains nothing.
  stream_.expires_after(in_ms(all_.limits.request));
  http::async_read(stream_, buffer_, *parser_,
                   [self = shared_from_this()](Failure failed, std::size_t) { self->take(failed); });
}

void HttpConnection::take(Failure failed) {
  idle_ = false;
  if (!failed) return handle();
  const auto refuse = [this](int status, const char* why) { answer(refused(status, why), false); };
  if (failed == http::error::header_limit || failed == http::error::buffer_overflow)
    return refuse(431, "the header of the request is too long");
  if (failed == http::error::body_limit) return refuse(413, "the body of the request is too long");
  if (failed == http::error::end_of_stream || failed == http::error::partial_message) return close();
  if (failed.category() == make_error_code(http::error::bad_method).category())
    return refuse(400, "that is no HTTP request");
  close();
}

void HttpConnection::handle() {
  const auto& message = parser_->get();
  const bool keep = message.keep_alive();
  const auto header = [&](auto name) { return text(message[name]); };
  const std::string target = text(message.target());
  if (target.empty() || target.front() != '/' || message.count(http::field::host) != 1 ||
      message.count(http::field::origin) > 1)
    return answer(refused(400, "the request needs a path and one Host"), false);
  HttpRequest request;
  request.method = text(message.method_string());
  const std::size_t mark = std::min(target.find('?'), target.size());
  request.path = target.substr(0, mark);
  if (mark < target.size()) request.query = target.substr(mark + 1);
  request.host = header(http::field::host);
  request.origin = header(http::field::origin);
  request.cookie = header(http::field::cookie);
  request.content_type = header(http::field::content_type);
  request.fetch_site = header("Sec-Fetch-Site");
  request.fetch_mode = header("Sec-Fetch-Mode");
  request.body = message.body();
  stream_.expires_never();  // the answer may take its time
  // Meanwhile the list of all holds the connection: another thread must not be the last to release it.
  all_.handler(request, [weak = weak_from_this(), executor = stream_.get_executor(), keep](HttpAnswer what) {
    asio::post(executor, [weak, keep, what = std::move(what)]() mutable {
      const auto self = weak.lock();
      if (!self) return;
      what.events ? self->begin_events(what) : self->answer(std::move(what), keep);
    });
  });
}

void HttpConnection::answer(HttpAnswer what, bool keep) {
  const bool head_alone = parser_ && parser_->get().method() == http::verb::head;
  file_.close();
  body_ = what.shared ? what.shared : std::make_shared<const std::string>(std::move(what.body));
  std::size_t length = body_->size();
  if (!what.file.empty()) {
    file_ = Descriptor(os::open(what.file, O_RDONLY));
    os::FileStatus found;
    if (!file_.is_open() || (found = os::status(file_.number())).kind == os::FileKind::none)
      return answer(errno == ENOENT ? refused(404, "the recording is gone")
                                    : refused(503, "the recording cannot be read now"),
                    keep);
    length = found.size;
  }
  http::response<http::empty_body> head;
  head.version(11);
  head.result(static_cast<unsigned>(what.status));
  head.set(http::field::content_type, what.type);
  add_safety(head, what.policy);
  for (const auto& [name, value] : what.headers) head.insert(name, value);
  head.keep_alive(keep);
  head.content_length(length);
  std::ostringstream text;
  text << head.base();
  piece_ = text.str();
  answers_ = true;
  keep_ = keep;
  sent_bytes_ = 0;
  left_ = head_alone ? 0 : length;
  send_next();
}

// A client that does not read holds one piece in memory, not a whole recording.
void HttpConnection::send_next() {
  constexpr std::size_t of_file = 16 << 10, of_memory = 256 << 10;  // bytes
  asio::const_buffer body;
  if (file_.is_open() && left_ > 0) {
    const std::size_t before = piece_.size();
    piece_.resize(before + std::min(left_, of_file));
    const auto got = os::read_at(file_.number(), piece_.data() + before, piece_.size() - before, sent_bytes_);
    if (got <= 0) return close();  // shorter than promised, or unreadable
    piece_.resize(before + static_cast<std::size_t>(got));
    sent_bytes_ += static_cast<std::size_t>(got);
    left_ -= static_cast<std::size_t>(got);
  } else if (left_ > 0) {
    const std::size_t count = std::min(left_, of_memory);
    body = asio::buffer(body_->data() + sent_bytes_, count);
    sent_bytes_ += count;
    left_ -= count;
  }
  stream_.expires_after(in_ms(all_.limits.answer));
  const std::array<asio::const_buffer, 2> buffers{asio::buffer(piece_), body};
  asio::async_write(stream_, buffers, [self = shared_from_this()](Failure failed, std::size_t) {
    if (failed) return self->close();
    self->piece_.clear();
    if (self->left_ > 0) return self->send_next();
    self->answers_ = false;
    self->body_.reset();
    self->file_.close();
    self->keep_ ? self->read() : self->linger();
  });
}

// Closed with bytes unread the connection would be reset, and the answer might be lost with it.
void HttpConnection::linger() {
  Failure ignored;
  if (thrown_away_ == 0) stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
  if (thrown_away_ > (1 << 20)) return close();
  if (thrown_away_ == 0) stream_.expires_after(in_ms(2));
  buffer_.clear();
  stream_.async_read_some(buffer_.prepare(16 << 10),
                          [self = shared_from_this()](Failure failed, std::size_t count) {
                            self->thrown_away_ += count + 1;
                            failed ? self->close() : self->linger();
                          });
}

void HttpConnection::begin_events(const HttpAnswer& what) {
  if (all_.listeners() >= all_.limits.listeners) return answer(refused(503, "too many listeners"), false);
  http::fields head;
  head.set(http::field::content_type, "text/event-stream");
  head.set(http::field::connection, "close");
  add_safety(head, what.policy);
  for (const auto& [name, value] : what.headers) head.insert(name, value);
  events_ = "HTTP/1.1 200 OK\r\n";
  for (const auto& field : head) events_ += text(field.name_string()) + ": " + text(field.value()) + "\r\n";
  events_ += "\r\nretry: 1000\n\n";
  listens_ = true;
  // A listener has nothing more to say: whatever comes, its end above all, closes the connection.
  stream_.socket().async_wait(asio::ip::tcp::socket::wait_read, [self = shared_from_this()](Failure) {
    self->listens_ = false;
    self->close();
  });
  send_events();
}

void HttpConnection::send_events() {
  if (busy_) return;
  events_ += all_.events(cursor_);
  const auto now = std::chrono::steady_clock::now();
  if (events_.empty() && now - sent_ > std::chrono::seconds(5)) events_ = ": still here\n\n";
  if (events_.empty()) return;
  sent_ = now;
  busy_ = true;
  stream_.expires_after(in_ms(all_.limits.answer));
  asio::async_write(stream_, asio::buffer(events_), [self = shared_from_this()](Failure failed, std::size_t) {
    self->busy_ = false;
    self->events_.clear();
    self->stream_.expires_never();
    if (failed) self->close();
  });
}

void HttpConnections::begin(asio::ip::tcp::socket socket) {
  const auto connection = std::make_shared<HttpConnection>(*this, next_, std::move(socket));
  open_[next_++] = connection;
  connection->read();
}

std::size_t HttpConnections::listeners() const {
  return static_cast<std::size_t>(
      std::count_if(open_.begin(), open_.end(), [](const auto& each) { return each.second->listens(); }));
}

void HttpConnections::make_room() {
  for (const auto may_go : {&HttpConnection::idle, &HttpConnection::listens, &HttpConnection::answers}) {
    const auto oldest = std::find_if(open_.begin(), open_.end(),
                                     [&](const auto& each) { return (each.second.get()->*may_go)(); });
    if (oldest == open_.end()) continue;
    const auto connection = oldest->second;
    return connection->close();
  }
}

void HttpConnections::end_all() {
  while (!open_.empty()) {
    const auto connection = open_.begin()->second;
    connection->close();
  }
}

void HttpConnections::send_events() {
  std::vector<std::shared_ptr<HttpConnection>> listening;
  for (const auto& [number, connection] : open_)
    if (connection->listens()) listening.push_back(connection);
  for (const auto& connection : listening) connection->send_events();
}

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
  if (failed) return Error{"no_ip_address", {{"address", address}}};
  const asio::ip::tcp::endpoint end(place, static_cast<unsigned short>(port));
  auto& acceptor = state_->acceptor;
  acceptor.open(end.protocol(), failed);
  if (!failed) acceptor.set_option(asio::socket_base::reuse_address(true), failed);
  if (!failed) acceptor.bind(end, failed);
  if (!failed) acceptor.listen(asio::socket_base::max_listen_connections, failed);
  if (failed)
    return Error{"cannot_serve", {{"address", address}, {"port", port}, {"reason", failed.message()}}};
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

std::vector<std::string> reached_at(const std::string& address) {
  if (address != "0.0.0.0") return {address.find(':') == std::string::npos ? address : "[" + address + "]"};
  std::vector<std::string> all = os::addresses();
  if (all.empty()) all.emplace_back("127.0.0.1");
  return all;
}

}  // namespace cromer::core::serve
