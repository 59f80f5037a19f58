#include "lab.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "cromer/base/quantity.h"
#include "cromer/report/read_file.h"
#include "lab_page.h"

namespace cromer::cli {
namespace {

HttpAnswer page(const std::string& path) {
  if (path.empty()) return {503, "text/html; charset=utf-8", page_is_missing()};
  auto bytes = read_file(path);
  return bytes ? HttpAnswer{200, "text/html; charset=utf-8", *std::move(bytes)}
               : HttpAnswer{503, "text/html; charset=utf-8", page_is_missing()};
}

/// Of two digits.
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

/// {"for": 20} or {"for": "20 s"}; no body at all, or none of it.
Result<std::optional<double>> duration_in(const std::string& body) {
  using Json = nlohmann::json;
  if (body.empty()) return std::optional<double>{};
  const Json document = Json::parse(
      body, [](int depth, Json::parse_event_t, Json&) { return depth < 4; }, false);
  if (!document.is_object()) return Error{"the body is no JSON object such as {\"for\": \"20 s\"}"};
  const auto wanted = document.find("for");
  if (wanted == document.end() || wanted->is_null()) return std::optional<double>{};
  const auto length = parse_quantity(wanted->is_string() ? wanted->get<std::string>() : wanted->dump(), "s");
  if (!length) return Error{"\"for\": " + length.error().message};
  if (!(length->value > 0)) return Error{"\"for\": it must be positive"};
  return std::optional(length->value);
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
      HttpAnswer answer = page(page_);
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
  if (!duration) return respond(refused(400, duration.error().message));
  slow_.add([this, duration = *duration, respond] {
    const auto name = session_.start(duration);
    respond(name ? HttpAnswer{200, "application/json", session_.status()}
                 : refused(409, name.error().message));
  });
}

void Lab::stop(const Respond& respond) {
  slow_.add([this, respond] {
    session_.stop();
    respond({200, "application/json", session_.status()});
  });
}

/// Only names of recordings made here are known: nothing else can be reached.
void Lab::recording(const std::string& name, const Respond& respond) {
  const auto path = session_.path_of(percent_decoded(name));
  if (!path) return respond(refused(404, "there is no such recording"));
  slow_.add([path = *path, respond] {
    auto bytes = read_file(path);
    respond(bytes ? HttpAnswer{200, "text/csv; charset=utf-8", *std::move(bytes)}
                  : refused(404, "the recording is gone"));
  });
}

}  // namespace cromer::cli
