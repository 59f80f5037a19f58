#include "cromer/live/http_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>  // which Boost.Asio 1.74 needs and does not include
//
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <cerrno>

#include "cromer/live/source.h"
#include "cromer/os/file.h"
#include "cromer/os/line.h"

namespace cromer::core {
namespace {

namespace http = boost::beast::http;

constexpr std::size_t largest_body = 64 << 20;

}  // namespace

Result<std::string> HttpClient::ask(const std::string& target, double deadline, bool& stale) {
  stale = true;
  const std::string request = fmt::format(
      "GET {} HTTP/1.1\r\nHost: {}:{}\r\nAccept: application/json\r\nConnection: keep-alive\r\n\r\n", target,
      host_.find(':') == std::string::npos ? host_ : "[" + host_ + "]", port_);
  if (!send_all(connection_, request)) return Error{"connection_closed"};
  http::response_parser<http::string_body> parser;
  parser.body_limit(largest_body);
  parser.header_limit(64 << 10);
  parser.eager(true);
  std::string unread;
  char bytes[16384];
  while (!parser.is_done()) {
    const double left = deadline - steady_seconds();
    if (left <= 0 || !readable(connection_, left)) return stale = false, Error{"no_answer_in_time"};
    const auto count = os::read(connection_.number(), bytes, sizeof bytes);
    if (count < 0 && errno == EAGAIN) continue;
    boost::system::error_code failed;
    if (count <= 0) {
      if (!parser.got_some()) return Error{"connection_closed"};
      parser.put_eof(failed);
      if (failed) return Error{"answer_broke_off"};
      break;
    }
    stale = false;
    unread.append(bytes, static_cast<std::size_t>(count));
    const std::size_t used = parser.put(boost::asio::buffer(unread), failed);
    unread.erase(0, used);
    // Boost.Beast 1.74 forgets its limit where a part of the body comes with the header.
    if (parser.is_header_done() && parser.content_length().value_or(0) > largest_body)
      failed = http::error::body_limit;
    if (failed && failed != http::error::need_more)
      return Error{"answer_is_no_http", {{"why", failed.message()}}};
  }
  const auto& answer = parser.get();
  if (answer.result() != http::status::ok)
    return Error{"answer_of_status",
                 {{"target", target.substr(0, target.find('?'))}, {"status", answer.result_int()}}};
  if (!answer.keep_alive()) connection_.close();
  return answer.body();
}

Result<std::string> HttpClient::get(const std::string& target, double seconds) {
  const double deadline = steady_seconds() + seconds;
  const bool kept = connection_.is_open();
  for (const bool again : {false, true}) {
    if (!connection_.is_open()) {
      auto opened = open_tcp(host_, port_, std::max(0.1, deadline - steady_seconds()));
      if (!opened) return opened.error();
      connection_ = *std::move(opened);
    }
    bool stale = false;
    auto answer = ask(target, deadline, stale);
    if (answer) return answer;
    connection_.close();
    // A kept connection may have been closed by the other side meanwhile.
    if (again || !kept || !stale) return answer;
  }
  return Error{"no_answer"};
}

}  // namespace cromer::core
