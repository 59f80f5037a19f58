#include "apps/serve/lab.h"

#include <charconv>
#include <functional>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/serve/lab_page.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"
#include "cromer/report/file.h"

namespace cromer::core::serve {
namespace {

/// The character of two hexadecimal digits.
std::optional<char> hexadecimal(std::string_view digits) {
  unsigned byte = 0;
  const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
  if (failed != std::errc() || end != digits.data() + 2) return std::nullopt;
  return static_cast<char>(byte);
}

/// "my%20swing.csv" is "my swing.csv"; a % that begins no two hexadecimal digits stands for itself.
std::string percent_decoded(std::string_view text) {
  std::string plain;
  for (; !text.empty(); text.remove_prefix(1)) {
    const auto byte = text.front() == '%' ? hexadecimal(text.substr(1, 2)) : std::nullopt;
    plain += byte.value_or(text.front());
    if (byte) text.remove_prefix(2);
  }
  return plain;
}

/// {"for": 20} or {"for": "20 s"}; nothing if there is no body or no "for".
Result<std::optional<double>> duration_in(const std::string& body) {
  using Json = nlohmann::json;
  if (body.empty()) return std::optional<double>{};
  const Json document = Json::parse(
      body, [](int depth, Json::parse_event_t, Json&) { return depth < 4; }, false);
  if (!document.is_object()) return Error{"body_is_no_object"};
  const auto wanted = document.find("for");
  if (wanted == document.end() || wanted->is_null()) return std::optional<double>{};
  const auto length = parse_quantity(wanted->is_string() ? wanted->get<std::string>() : wanted->dump(), "s");
  if (!length) return Error{"duration_asked", {{"what", length.error().notice}}};
  if (!(length->value > 0)) return Error{"duration_asked", {{"what", Notice{"must_be_positive_plain"}}}};
  return std::optional(length->value);
}

/// The policy that a page states for itself; "" if it has none.
std::string policy_of(std::string_view page) {
  constexpr std::string_view tag = "http-equiv=\"Content-Security-Policy\" content=\"";
  const std::size_t begin = page.find(tag);
  if (begin == std::string_view::npos) return "";
  const std::string_view rest = page.substr(begin + tag.size());
  const std::string_view policy = rest.substr(0, rest.find('"'));
  return policy.find_first_of("\r\n") == std::string_view::npos ? std::string(policy) : "";
}

void answer_later(TaskQueue& queue, const HttpServer::Respond& respond, std::function<HttpAnswer()> work) {
  queue.add([respond, work = std::move(work)] {
    try {
      respond(work());
    } catch (const std::bad_alloc&) {
      try {
        respond({.status = 503});
      } catch (const std::bad_alloc&) {  // nobody is told; the recording goes on
      }
    }
  });
}

}  // namespace

void Lab::handle(const HttpRequest& request, const Respond& respond) {
  if (auto answer = refusal(guard_, request)) return respond(*std::move(answer));
  const bool get = request.method == "GET" || request.method == "HEAD", post = request.method == "POST";
  const std::string& path = request.path;
  constexpr std::string_view recordings = "/api/recordings/";
  if (path == "/api/record" || path == "/api/stop") {
    if (!post) return respond(refused(405, "that is asked for with POST"));
    return path == "/api/stop" ? stop(respond) : record(request, respond);
  }
  if (path == "/" || path == "/api/status" || path == "/api/events" || path.starts_with(recordings)) {
    // A stream has no end, and its head alone says nothing.
    if (!get || (request.method == "HEAD" && path == "/api/events"))
      return respond(refused(405, "that is asked for with GET"));
    if (path == "/") {
      HttpAnswer answer = page();
      keep_token(guard_, answer);
      // Browsers heed it from this computer alone, and complain elsewhere.
      if (!guard_.beyond_this_computer)
        answer.headers.emplace_back("Cross-Origin-Opener-Policy", "same-origin");
      return respond(std::move(answer));
    }
    if (path == "/api/status") return respond({200, "application/json", session_.status()});
    if (path == "/api/events") return respond({.events = true});
    return recording(path.substr(recordings.size()), respond);
  }
  respond(refused(404, "there is nothing of that name"));
}

void Lab::record(const HttpRequest& request, const Respond& respond) {
  if (!request.body.empty() && !request.content_type.starts_with("application/json"))
    return respond(refused(415, "the body must be application/json"));
  auto duration = duration_in(request.body);
  if (!duration) return respond(refused(400, in_words(duration.error())));
  answer_later(starts_, respond, [this, duration = *duration] {
    const auto name = session_.start(duration);
    return name ? HttpAnswer{200, "application/json", session_.status()}
                : refused(409, in_words(name.error()));
  });
}

void Lab::stop(const Respond& respond) {
  answer_later(stops_, respond, [this] {
    session_.stop();
    return HttpAnswer{200, "application/json", session_.status()};
  });
}

/// Only names of recordings made here are known: nothing else can be reached.
void Lab::recording(const std::string& name, const Respond& respond) {
  const auto path = session_.path_of(percent_decoded(name));
  if (!path) return respond(refused(404, "there is no such recording"));
  respond({.type = "text/csv; charset=utf-8", .file = *path});
}

/// Read again if the file has changed.
HttpAnswer Lab::page() {
  std::error_code failed;
  const auto time = page_.empty() ? page_time_ : std::filesystem::last_write_time(page_, failed);
  if (!page_.empty() && (!page_bytes_ || failed || time != page_time_)) {
    auto bytes = read_file(page_);
    page_bytes_ = bytes ? std::make_shared<const std::string>(*std::move(bytes)) : nullptr;
    page_policy_ = page_bytes_ ? policy_of(*page_bytes_) : "";
    page_time_ = time;
  }
  if (page_.empty() && !page_bytes_ && !built_in_page().empty()) {
    page_bytes_ = std::make_shared<const std::string>(built_in_page());
    page_policy_ = policy_of(*page_bytes_);
  }
  HttpAnswer answer{.type = "text/html; charset=utf-8", .shared = page_bytes_, .policy = page_policy_};
  if (!page_bytes_) answer.status = 503, answer.body = page_is_missing();
  return answer;
}

}  // namespace cromer::core::serve
