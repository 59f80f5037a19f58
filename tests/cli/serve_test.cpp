// cromer serve: its page and its interface, and live recording through it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "http_peer.h"
#include "live_devices.h"
#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

nlohmann::json json_of(const std::string& answer) {
  return nlohmann::json::parse(body_of(answer), nullptr, false);
}

TEST(Serve, ServesThePageWithHeadersThatKeepItSafe) {
  const Folder folder;
  const Served served(folder);
  ASSERT_EQ(served.address(), "http://127.0.0.1:" + std::to_string(served.port()) + "/");
  const std::string answer = ask(served.port(), request(served.port(), "GET /"));
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_THAT(answer, HasSubstr("Content-Type: text/html; charset=utf-8\r\n"));
  EXPECT_THAT(answer, HasSubstr("Content-Security-Policy: default-src 'none';"));
  EXPECT_THAT(answer, HasSubstr("frame-ancestors 'none'"));
  EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff\r\n"));
  EXPECT_THAT(answer, Not(HasSubstr("script-src")));
  EXPECT_THAT(body_of(answer), HasSubstr("stand-in for the lab"));
  // A page that states what it needs gets that, and no more.
  folder.write("page.html",
               "<html><head><meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
               "script-src 'sha256-abc='\" /></head></html>\n");
  EXPECT_THAT(ask(served.port(), request(served.port(), "GET /")),
              HasSubstr("Content-Security-Policy: default-src 'none'; script-src 'sha256-abc='; "
                        "frame-ancestors 'none'\r\n"));
  EXPECT_EQ(body_of(ask(served.port(), request(served.port(), "HEAD /"))), "");
}

TEST(Serve, AnswersOnlyWhatItKnows) {
  const Folder folder;
  const Served served(folder);
  const auto status = [&](const std::string& line) {
    return status_of(ask(served.port(), request(served.port(), line)));
  };
  EXPECT_EQ(status("GET /page.html"), 404);
  EXPECT_EQ(status("GET /api"), 404);
  EXPECT_EQ(status("GET /api/recordings"), 404);
  EXPECT_EQ(status("GET /api/recordings/"), 404);
  EXPECT_EQ(status("POST /"), 405);
  EXPECT_EQ(status("DELETE /api/status"), 405);
  EXPECT_EQ(status("GET /api/record"), 405);
  EXPECT_EQ(status("GET /api/status"), 200);
  EXPECT_TRUE(json_of(ask(served.port(), request(served.port(), "GET /api/status")))["source"].is_null());
  // Nothing was named to record from: the page cannot name it.
  const std::string answer = ask(served.port(), request(served.port(), "POST /api/record"));
  EXPECT_EQ(status_of(answer), 409);
  EXPECT_THAT(json_of(answer)["message"].get<std::string>(), HasSubstr("without --from"));
}

TEST(Serve, SaysHowToBuildThePage) {
  const Folder folder;
  const Served served(folder);
  std::filesystem::remove(folder.path("page.html"));
  const std::string answer = ask(served.port(), request(served.port(), "GET /"));
  EXPECT_EQ(status_of(answer), 503);
  EXPECT_THAT(answer, HasSubstr("./dev page"));
}

TEST(Serve, RefusesWhatIsWrongOnItsCommandLine) {
  const Folder folder;
  const auto refused = [&](std::vector<std::string> arguments, const std::string& why) {
    arguments.insert(arguments.begin(), "serve");
    const Finished end = folder.run(arguments);
    EXPECT_EQ(end.status, 2) << why;
    EXPECT_THAT(end.err, HasSubstr(why));
  };
  refused({"--port", "70000"}, "--port 70000");
  refused({"--port", "0", "--address", "example.org"}, "is no IP address");
  refused({"--port", "0", "-o", "swing.csv"}, "no --from SOURCE");
  refused({"--port", "0", "--from", "tcp:127.0.0.1:5"}, "-o FILE.csv is needed");
  refused({"--page", "missing.html"}, "missing.html");
  const Served served(folder);
  refused({"--port", std::to_string(served.port()), "--page", "page.html"}, "Address already in use");
}

/// All values of the events of one kind.
std::vector<nlohmann::json> events_in(const std::string& stream, const std::string& kind) {
  std::vector<nlohmann::json> found;
  const std::string begin = "event: " + kind + "\ndata: ";
  for (auto at = stream.find(begin); at != std::string::npos; at = stream.find(begin, at + 1)) {
    const auto from = at + begin.size(), to = stream.find('\n', from);
    if (to != std::string::npos)
      found.push_back(nlohmann::json::parse(stream.substr(from, to - from), nullptr, false));
  }
  return found;
}

TEST(Serve, RecordsAndSendsEverySampleAndTheFitLive) {
  const Folder folder;
  const Phone phone(100, false);
  const Served served(folder,
                      {"--from", "phyphox:127.0.0.1:" + std::to_string(phone.port()), "-o", "swing.csv"});
  const int port = served.port();
  const Peer listener(port);
  listener.send("GET /api/events HTTP/1.1\r\nHost: localhost:" + std::to_string(port) + "\r\n\r\n");
  const std::string begun = ask(
      port, request(port, "POST /api/record", "Content-Type: application/json\r\n", "{\"for\": \"8 s\"}"));
  ASSERT_EQ(status_of(begun), 200) << begun;
  EXPECT_EQ(json_of(begun)["recording"], "swing.csv");
  EXPECT_EQ(json_of(begun)["source"], "phyphox:127.0.0.1:" + std::to_string(phone.port()));
  EXPECT_EQ(status_of(ask(port, request(port, "POST /api/record"))), 409);
  const std::string stream = listener.receive(30, "\"running\":false,\"samples\":801");
  EXPECT_THAT(stream, StartsWith("HTTP/1.1 200 OK\r\n"));
  EXPECT_THAT(stream, HasSubstr("Content-Type: text/event-stream\r\n"));
  std::vector<double> t, x;
  for (const auto& batch : events_in(stream, "samples")) {
    EXPECT_EQ(batch["first"], t.size());
    for (const double each : batch["t"]) t.push_back(each);
    for (const double each : batch["values"][0]) x.push_back(each);
  }
  ASSERT_EQ(t.size(), 801u);
  for (std::size_t n = 0; n < t.size(); ++n) {
    ASSERT_NEAR(t[n], static_cast<double>(n) / 100, 1e-8);
    ASSERT_NEAR(x[n], swing(t[n]), 1e-8);
  }
  const auto fits = events_in(stream, "fit");
  ASSERT_GE(fits.size(), 3u);
  EXPECT_EQ(fits.back()["status"], "converged");
  EXPECT_EQ(fits.back()["column"], "Position (m)");
  const auto& frequency = fits.back()["derived"]["frequency"];
  EXPECT_NEAR(frequency["value"].get<double>(), swing_frequency, 1e-3 * swing_frequency);
  EXPECT_GT(frequency["standard_error"].get<double>(), 0);
  EXPECT_THAT(events_in(stream, "notices").at(0).dump(), HasSubstr("the phone was not measuring"));

  const std::string file = ask(port, request(port, "GET /api/recordings/swing.csv"));
  EXPECT_EQ(status_of(file), 200);
  EXPECT_EQ(body_of(file), folder.read("swing.csv"));
  // The next one takes the next name.
  const std::string again = ask(port, request(port, "POST /api/record"));
  EXPECT_EQ(json_of(again)["recording"], "swing-2.csv");
  const std::string ended = ask(port, request(port, "POST /api/stop"));
  EXPECT_EQ(json_of(ended)["running"], false);
}

TEST(Serve, WhoComesLateIsToldTheLastTenSeconds) {
  const Folder folder;
  const SerialLine serial;
  const Served served(folder, {"--from", "serial:" + serial.path(), "-o", "swing.csv"});
  const std::string listen =
      "GET /api/events HTTP/1.1\r\nHost: localhost:" + std::to_string(served.port()) + "\r\n\r\n";
  const Peer early(served.port());
  early.send(listen);
  early.receive(5, "event: status");
  ASSERT_EQ(status_of(ask(served.port(), request(served.port(), "POST /api/record"))), 200);
  // Half a minute of the device's time at once.
  serial.write("\n");
  for (int n = 0; n < 3000; ++n) serial.write(std::to_string(0.01 * n) + " " + std::to_string(n) + "\n");
  const auto told_from = [](const std::string& stream) {
    std::vector<std::size_t> firsts;
    for (const auto& batch : events_in(stream, "samples")) firsts.push_back(batch["first"]);
    return firsts;
  };
  const auto all = told_from(early.receive(20, ",2999.0]]"));
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all.front(), 0u);
  const Peer late(served.port());
  late.send(listen);
  const std::string stream = late.receive(20, ",2999.0]]");
  EXPECT_EQ(told_from(stream), std::vector<std::size_t>{1999});
  EXPECT_EQ(events_in(stream, "samples").at(0)["t"].size(), 1001u);
  EXPECT_EQ(events_in(stream, "status").at(0)["samples"], 3000);
}

TEST(Serve, GivesRecordingsWithBlanksAndUmlautsInTheirNames) {
  const Folder folder;
  const Phone phone(100, true);
  const std::string name = "my swing \xc3\xbc 50%.csv";
  const Served served(folder, {"--from", "phyphox:127.0.0.1:" + std::to_string(phone.port()), "-o", name});
  const auto get = [&](const std::string& path) {
    return ask(served.port(), request(served.port(), "GET /api/recordings/" + path));
  };
  const std::string begun = ask(served.port(), request(served.port(), "POST /api/record"));
  ASSERT_EQ(json_of(begun)["recording"], name) << begun;
  sleep_until(now() + 0.5);
  ask(served.port(), request(served.port(), "POST /api/stop"));
  const std::string file = get("my%20swing%20%C3%bc%2050%25.csv");
  EXPECT_EQ(status_of(file), 200);
  EXPECT_THAT(body_of(file), HasSubstr("Time (s),"));
  EXPECT_EQ(body_of(file), folder.read(name));
  // What is no escape stands for itself.
  EXPECT_EQ(status_of(get("my%20swing%20%C3%BC%2050%.csv")), 200);
  EXPECT_EQ(status_of(get("my%20swing%20%C3%BC%2050%2.csv")), 404);
  EXPECT_EQ(status_of(get("my%2520swing%20%C3%BC%2050%25.csv")), 404);
  std::filesystem::remove(folder.path(name));
  const std::string gone = get("my%20swing%20%C3%bc%2050%25.csv");
  EXPECT_EQ(status_of(gone), 404);
  EXPECT_THAT(body_of(gone), HasSubstr("the recording is gone"));
}

TEST(Serve, WhatCannotBeReachedIsSaidAndTheServerGoesOn) {
  const Folder folder;
  const Served served(folder, {"--from", "tcp:127.0.0.1:1", "-o", "swing.csv"});
  const std::string answer = ask(served.port(), request(served.port(), "POST /api/record"));
  EXPECT_EQ(status_of(answer), 409);
  EXPECT_THAT(answer, HasSubstr("refused"));
  for (const char* body : {"[", "[]", "{\"for\": \"3 kg\"}", "{\"for\": -1}", "{\"for\": {}}"})
    EXPECT_EQ(status_of(ask(served.port(), request(served.port(), "POST /api/record",
                                                   "Content-Type: application/json\r\n", body))),
              400)
        << body;
  EXPECT_EQ(status_of(ask(served.port(),
                          request(served.port(), "POST /api/record", "Content-Type: text/plain\r\n", "{}"))),
            415);
  EXPECT_FALSE(folder.has("swing.csv"));
  EXPECT_TRUE(served.is_up());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
