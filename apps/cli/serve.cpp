#include <fmt/format.h>

#include "apps/serve/guard.h"
#include "apps/serve/http_server.h"
#include "apps/serve/lab.h"
#include "apps/serve/lab_page.h"
#include "apps/serve/live_session.h"
#include "commands.h"
#include "cromer/documents/words/words.h"
#include "cromer/report/file.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::core::cli {

using namespace serve;

namespace {

struct ServeOptions {
  RecordOptions recording;
  std::optional<int> port;
  std::string address = "127.0.0.1", page;
  bool quiet = false;
};

Syntax syntax_of(ServeOptions& o) {
  Syntax syntax{
      .command = "serve",
      .description =
          "The lab in the browser at http://127.0.0.1:8000/, and with --from live recording in it. At "
          "another address everybody needs the printed address, which holds a token. Ctrl-C ends it.",
      .files = "",
      .options = {{"port", &o.port, "", Range::any, "0 takes a free one", "8000", "Where"},
                  {"address", &o.address, "", Range::any,
                   "of this computer to serve at; 0.0.0.0 stands for all", "127.0.0.1: nobody else", "Where"},
                  {"page", &o.page, "", Range::any, "the page to serve, .html",
                   "the one that was built or installed with the program", "Where"}},
      .example =
          "  cromer serve --from serial:/dev/ttyACM0 -o swing.csv\n"
          "  cromer serve --address 0.0.0.0 --port 8080"};
  auto recording = options_of(o.recording);
  for (Option& each : recording)
    if (each.target == Option::Target(&o.recording.output)) each.default_text = "required with --from";
  syntax.options.insert(syntax.options.end(), recording.begin(), recording.end());
  syntax.options.push_back(
      {"quiet", &o.quiet, "", Range::any, "no warnings", "warnings on standard error", "Output"});
  return syntax;
}

/// What is to be recorded; nothing without --from.
Result<std::optional<RecordSetup>> setup_of(const RecordOptions& options) {
  if (options.from.empty()) {
    if (options.output.empty()) return std::optional<RecordSetup>{};
    return Error{"output_without_source"};
  }
  auto setup = check(options);
  if (!setup) return setup.error();
  return std::optional(*std::move(setup));
}

/// Until a signal ends it.
int serve_lab(const std::string& address, std::optional<int> port, const std::string& page,
              LiveSession& session) {
  const Watch watch = watching(true);
  std::unique_ptr<Lab> lab;
  HttpServer server(
      [&](const HttpRequest& request, const HttpServer::Respond& respond) { lab->handle(request, respond); },
      [&](EventCursor& cursor) { return session.events(cursor); });
  if (auto good = server.listen(address, port.value_or(8000)); !good) return refuse(good.error());
  Guard guard{server.port(), !is_loopback(address), ""};
  if (guard.beyond_this_computer) guard.token = random_token();
  lab = std::make_unique<Lab>(session, guard, page);
  const std::string query = guard.token.empty() ? "" : "?token=" + guard.token;
  std::string addresses;
  for (const auto& host : reached_at(address))
    addresses += fmt::format("http://{}:{}/{}\n", host, guard.port, query);
  if (!print(addresses)) return output_refused();
  server.run([&] { return watch.interrupted(); });
  lab.reset();  // before the server, whose connections its answers go to, and the end of what it began
  session.stop();
  return done;
}

}  // namespace

int run_serve(const Arguments& arguments) {
  ServeOptions options;
  std::vector<std::string> none;
  if (const auto status = parse(syntax_of(options), arguments, none)) return *status;
  if (options.port && (*options.port < 0 || *options.port > 65535))
    return refuse(fmt::format("--port {}: it must be 0 to 65535", *options.port));
  auto setup = setup_of(options.recording);
  if (!setup) return refuse(setup.error());
  if (options.page.empty()) {
    options.page = find_lab_page();
    if (options.page.empty() && built_in_page().empty() && !options.quiet)
      complain("warning: the page is not built; ./dev page builds it");
  } else if (const auto bytes = read_file(options.page); !bytes) {
    return refuse("--page: " + in_words(bytes.error()));
  }
  LiveSession session(*std::move(setup), options.recording);
  return serve_lab(options.address, options.port, options.page, session);
}

}  // namespace cromer::core::cli
