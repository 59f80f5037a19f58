#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <thread>

#include "command_line.h"
#include "commands.h"
#include "cromer/report/read_file.h"
#include "cromer/study/json/live.h"
#include "exit_status.h"
#include "guard.h"
#include "http_server.h"
#include "lab_page.h"
#include "live_session.h"
#include "message.h"
#include "output.h"
#include "own_addresses.h"
#include "syntax.h"
#include "task_queue.h"
#include "watching.h"

namespace cromer::cli {
namespace {

using Respond = HttpServer::Respond;

HttpAnswer said(int status, const std::string& message) {
  return {status, "application/json", message_json(message)};
}

HttpAnswer page(const std::string& path) {
  if (path.empty()) return {503, "text/html; charset=utf-8", page_is_missing()};
  auto bytes = read_file(path);
  return bytes ? HttpAnswer{200, "text/html; charset=utf-8", *std::move(bytes)}
               : HttpAnswer{503, "text/html; charset=utf-8", page_is_missing()};
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

/// The page and the interface; whoever gets here has passed the guard.
class Lab {
 public:
  Lab(LiveSession& session, Guard guard, std::string page)
      : session_(session), guard_(std::move(guard)), page_(std::move(page)) {}

  void handle(const HttpRequest& request, const Respond& respond) {
    if (auto refused = refusal(guard_, request)) return respond(*std::move(refused));
    const bool get = request.method == "GET" || request.method == "HEAD", post = request.method == "POST";
    const std::string& path = request.path;
    constexpr std::string_view recordings = "/api/recordings/";
    if (path == "/api/record" || path == "/api/stop") {
      if (!post) return respond(said(405, "that is asked for with POST"));
      return path == "/api/stop" ? stop(respond) : record(request, respond);
    }
    if (path == "/" || path == "/api/status" || path == "/api/events" || path.starts_with(recordings)) {
      // A stream has no end, and its head alone says nothing.
      if (!get || (request.method == "HEAD" && path == "/api/events"))
        return respond(said(405, "that is asked for with GET"));
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
    respond(said(404, "there is nothing of that name"));
  }

 private:
  void record(const HttpRequest& request, const Respond& respond) {
    if (!request.body.empty() && !request.content_type.starts_with("application/json"))
      return respond(said(415, "the body must be application/json"));
    auto duration = duration_in(request.body);
    if (!duration) return respond(said(400, duration.error().message));
    slow_.add([this, duration = *duration, respond] {
      const auto name = session_.start(duration);
      respond(name ? HttpAnswer{200, "application/json", session_.status()}
                   : said(409, name.error().message));
    });
  }

  void stop(const Respond& respond) {
    slow_.add([this, respond] {
      session_.stop();
      respond({200, "application/json", session_.status()});
    });
  }

  /// Only names of recordings made here are known: nothing else can be reached.
  void recording(const std::string& name, const Respond& respond) {
    const auto path = session_.path_of(name);
    if (!path) return respond(said(404, "there is no such recording"));
    slow_.add([path = *path, respond] {
      auto bytes = read_file(path);
      respond(bytes ? HttpAnswer{200, "text/csv; charset=utf-8", *std::move(bytes)}
                    : said(404, "the recording is gone"));
    });
  }

  LiveSession& session_;
  Guard guard_;
  std::string page_;
  TaskQueue slow_;  ///< what waits for devices and disks, one after the other
};

}  // namespace

int run_serve(const Arguments& arguments) {
  RecordOptions options;
  std::optional<int> port;
  std::string address = "127.0.0.1", page;
  bool quiet = false;
  Syntax syntax{
      .command = "serve",
      .description =
          "The lab in the browser at http://127.0.0.1:8000/, and with --from live recording in it. At "
          "another address everybody needs the token in the address that is printed. Ctrl-C ends it.",
      .files = "",
      .options = {{"port", &port, "", Range::any, "0 takes a free one", "8000", "Where"},
                  {"address", &address, "", Range::any,
                   "of this computer to serve at; 0.0.0.0 stands for all", "127.0.0.1: nobody else", "Where"},
                  {"page", &page, "", Range::any, "the page to serve, .html", "the one that ./dev page built",
                   "Where"}},
      .example =
          "  cromer serve --from serial:/dev/ttyACM0 -o swing.csv\n"
          "  cromer serve --address 0.0.0.0 --port 8080"};
  const auto recording = options_of(options);
  syntax.options.insert(syntax.options.end(), recording.begin(), recording.end());
  syntax.options.push_back(
      {"quiet", &quiet, "", Range::any, "no warnings", "warnings on standard error", "Output"});
  std::vector<std::string> none;
  if (const auto status = parse(syntax, arguments, none)) return *status;
  if (port && (*port < 0 || *port > 65535))
    return refuse(fmt::format("--port {}: it must be 0 to 65535", *port));
  std::optional<RecordSetup> setup;
  if (!options.from.empty()) {
    auto good = check(options);
    if (!good) return refuse(good.error().message);
    setup = *std::move(good);
  } else if (!options.output.empty()) {
    return refuse("-o names the recording, but there is no --from SOURCE to record");
  }
  if (page.empty()) {
    page = find_lab_page();
    if (page.empty()) warn({"the page is not built; ./dev page builds it"}, quiet);
  } else if (const auto bytes = read_file(page); !bytes) {
    return refuse("--page: " + bytes.error().message);
  }

  const Watch watch = watching(true);
  LiveSession session(std::move(setup), options, command_line("serve", arguments));
  std::unique_ptr<Lab> lab;
  HttpServer server(
      [&](const HttpRequest& request, const Respond& respond) { lab->handle(request, respond); },
      [&](EventCursor& cursor) { return session.events(cursor); });
  if (auto good = server.listen(address, port.value_or(8000)); !good) return refuse(good.error().message);
  Guard guard{server.port(), !is_loopback(address), ""};
  if (guard.beyond_this_computer) guard.token = random_token();
  lab = std::make_unique<Lab>(session, guard, page);
  const std::string query = guard.token.empty() ? "" : "?token=" + guard.token;
  std::string addresses;
  for (const auto& host : reached_at(address))
    addresses += fmt::format("http://{}:{}/{}\n", host, guard.port, query);
  if (!print(addresses)) return refuse("standard output cannot be written");
  server.run([&] { return watch.interrupted(); });
  session.stop();
  lab.reset();  // before the server, whose connections its answers go to
  return done;
}

}  // namespace cromer::cli
