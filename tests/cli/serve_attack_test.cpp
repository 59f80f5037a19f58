// What a hostile page, a hostile program and a broken one try on cromer serve.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "http_peer.h"
#include "live_devices.h"
#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::HasSubstr;
using ::testing::Not;

/// Others are to be answered within 0.1 s; a machine that runs other tests meanwhile gets more.
constexpr double soon = 1;  // [s]

/// What the server may take for all of them. The address sanitizer keeps what was freed for a while.
#ifdef CROMER_SANITIZED
constexpr double little = 40;  // [MB]
#else
constexpr double little = 10;
#endif

/// The median time of an answer to others, while whatever goes on goes on.
double time_of_an_answer(int port) {
  std::vector<double> times;
  for (int i = 0; i < 15; ++i) {
    const double begin = now();
    EXPECT_EQ(status_of(ask(port, request(port, "GET /"))), 200);
    times.push_back(now() - begin);
  }
  std::sort(times.begin(), times.end());
  return times[7];
}

TEST(ServeAttack, NoPathLeadsOut) {
  const Folder folder;
  folder.write("secret.csv", "the secret\n");
  const Served served(folder);
  for (const char* path : {"/secret.csv",
                           "/../secret.csv",
                           "/..%2fsecret.csv",
                           "/%2e%2e/secret.csv",
                           "/api/recordings/secret.csv",
                           "/api/recordings/../secret.csv",
                           "/api/recordings/..%2f..%2fetc%2fpasswd",
                           "/api/recordings/../../../../etc/passwd",
                           "/api/recordings//etc/passwd",
                           "/api/recordings/%00",
                           "/api/recordings/%2e%2e%2fsecret.csv",
                           "/api/recordings/%",
                           "/api/recordings/.",
                           "//etc/passwd",
                           "/./",
                           "/%2f",
                           "/..\\..\\secret.csv",
                           "/api/recordings/....//secret.csv",
                           "/cgi-bin/",
                           "/.git/config"}) {
    const std::string answer = ask(served.port(), request(served.port(), std::string("GET ") + path));
    EXPECT_EQ(status_of(answer), 404) << path;
    EXPECT_THAT(answer, Not(HasSubstr("secret"))) << path;
    EXPECT_THAT(answer, Not(HasSubstr("root:"))) << path;
  }
  for (const char* target : {"http://evil.example/", "*", "secret.csv"})
    EXPECT_EQ(status_of(ask(served.port(), request(served.port(), std::string("GET ") + target))), 400)
        << target;
  EXPECT_TRUE(served.is_up());
}

TEST(ServeAttack, PagesOfElsewhereAreRefused) {
  const Folder folder;
  const Served served(folder, {"--from", "tcp:127.0.0.1:1", "-o", "swing.csv"});
  const int port = served.port();
  const std::string here = std::to_string(port);
  const auto status = [&](const std::string& line, const std::string& headers) {
    return status_of(ask(port, request(port, line, headers)));
  };
  for (const std::string& host :
       {"evil.example:" + here, std::string("evil.example"), std::string("127.0.0.1"),
        "127.0.0.1.evil.example:" + here, "localhost.evil.example:" + here, "192.168.1.7:" + here,
        std::string("127.0.0.1:1"), std::string(""), "::1:" + here})
    EXPECT_EQ(status("GET /", "Host: " + host + "\r\n"), 403) << host;
  for (const std::string& host : {"localhost:" + here, "127.0.0.1:" + here, "[::1]:" + here})
    EXPECT_EQ(status("GET /", "Host: " + host + "\r\n"), 200) << host;
  EXPECT_EQ(status("GET /", "Host: 127.0.0.1:" + here + "\r\nHost: evil.example\r\n"), 400);
  EXPECT_EQ(status_of(ask(port, "GET / HTTP/1.1\r\nConnection: close\r\n\r\n")), 400);
  for (const char* origin :
       {"http://evil.example", "null", "https://127.0.0.1", "file://", "http://127.0.0.1:1"})
    for (const char* line : {"POST /api/record", "POST /api/stop", "GET /api/events", "GET /"})
      EXPECT_EQ(status(line, "Origin: " + std::string(origin) + "\r\n"), 403) << origin << " " << line;
  EXPECT_EQ(status("GET /api/status", "Origin: http://127.0.0.1:" + here + "\r\n"), 200);
  EXPECT_EQ(status("GET /api/status", "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: no-cors\r\n"), 403);
}

TEST(ServeAttack, BeyondThisComputerEverythingNeedsTheToken) {
  const Folder folder;
  const Served served(folder, {"--address", "0.0.0.0"});
  const int port = served.port();
  const auto at = served.address().find("?token=");
  ASSERT_NE(at, std::string::npos) << served.address();
  const std::string token = served.address().substr(at + 7);
  EXPECT_EQ(token.size(), 32u);
  const std::string cookie = "cromer_token_" + std::to_string(port) + "=";
  for (const char* line : {"GET /", "GET /api/status", "GET /api/events", "POST /api/record",
                           "GET /api/recordings/x", "GET /?token=", "GET /nothing"})
    EXPECT_EQ(status_of(ask(port, request(port, line))), 401) << line;
  EXPECT_EQ(status_of(ask(port, request(port, "GET /?token=" + std::string(32, '0')))), 401);
  EXPECT_EQ(status_of(ask(port, request(port, "GET /?token=" + token.substr(1)))), 401);
  // Who opens the page without it is told in words, others as programs are.
  EXPECT_THAT(ask(port, request(port, "GET /")), HasSubstr("<h1>The address is not complete</h1>"));
  EXPECT_THAT(ask(port, request(port, "GET /api/status")), HasSubstr("{\"message\":"));
  // The printed address is one that others can open, not the one that stands for all.
  EXPECT_THAT(served.address(), Not(HasSubstr("0.0.0.0")));
  const std::string page = ask(port, request(port, "GET /?token=" + token));
  EXPECT_EQ(status_of(page), 200);
  EXPECT_THAT(page, HasSubstr("Set-Cookie: " + cookie + token + "; HttpOnly; SameSite=Strict; Path=/\r\n"));
  EXPECT_EQ(status_of(ask(port, request(port, "GET /api/status", "Cookie: a=b; " + cookie + token + "\r\n"))),
            200);
  EXPECT_EQ(status_of(ask(port, request(port, "GET /",
                                        "Cookie: " + cookie + token +
                                            "\r\nHost: evil.example:" + std::to_string(port) + "\r\n"))),
            403);
  // Another server has another one.
  const Folder other_folder;
  EXPECT_THAT(Served(other_folder, {"--address", "0.0.0.0"}).address(), Not(HasSubstr(token)));
}

TEST(ServeAttack, BombsAreRefusedBeforeTheyAreRead) {
  const Folder folder;
  const Served served(folder);
  const int port = served.port();
  const std::string megabyte(1 << 20, 'x');
  EXPECT_EQ(status_of(ask(port, request(port, "GET /", "X-Bomb: " + megabyte + "\r\n"))), 431);
  EXPECT_EQ(status_of(ask(port, request(port, "GET /" + megabyte))), 431);
  std::string many;
  for (int i = 0; i < 10000; ++i) many += "X-" + std::to_string(i) + ": 1\r\n";
  EXPECT_EQ(status_of(ask(port, request(port, "GET /", many))), 431);
  EXPECT_EQ(status_of(ask(port, request(port, "POST /api/record", "", megabyte))), 413);
  const Peer announced(port);  // ten gigabytes to come
  announced.send(request(port, "POST /api/record", "Content-Length: 10000000000\r\n"));
  EXPECT_EQ(status_of(announced.receive(3)), 413);
  const Peer endless(port);
  endless.send("POST /api/record HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
               "\r\nTransfer-Encoding: chunked\r\n\r\n");
  for (int i = 0; i < 100 && endless.send("400\r\n" + megabyte.substr(0, 1024) + "\r\n"); ++i) {
  }
  EXPECT_EQ(status_of(endless.receive(3)), 413);
  EXPECT_TRUE(served.is_up());
}

TEST(ServeAttack, TheHeadOfAStreamIsNoStream) {
  const Folder folder;
  const Served served(folder);
  const std::string answer = ask(served.port(), request(served.port(), "HEAD /api/events"), 3);
  EXPECT_EQ(status_of(answer), 405);
  EXPECT_EQ(body_of(answer), "");
}

TEST(ServeAttack, WhatIsNoHttpIsRefused) {
  const Folder folder;
  const Served served(folder);
  const int port = served.port();
  std::string noise;
  unsigned state = 1;
  for (int i = 0; i < 4000; ++i) noise += static_cast<char>((state = state * 1664525 + 1013904223) >> 24);
  for (const std::string& bytes :
       {noise, std::string("\r\n\r\n"), std::string("GET\r\n\r\n"), std::string("GET / HTTP/9.9\r\n\r\n"),
        std::string("\x16\x03\x01\x02", 4) + "\r\n\r\n", std::string(1000, '\0') + "\r\n\r\n",
        request(port, "POST /api/record", "Content-Length: -1\r\n"),
        request(port, "POST /api/stop", "Content-Length: 1\r\nTransfer-Encoding: chunked\r\n")}) {
    const int status = status_of(ask(port, bytes, 7));
    EXPECT_TRUE(status == 400 || status == 413 || status == 0) << status << " " << bytes.substr(0, 40);
  }
  EXPECT_TRUE(served.is_up());
}

TEST(ServeAttack, AThousandIdleConnectionsAndSlowClientsHoldNobodyUp) {
  rlimit files{};
  getrlimit(RLIMIT_NOFILE, &files);
  files.rlim_cur = std::min<rlim_t>(files.rlim_max, 4096);
  setrlimit(RLIMIT_NOFILE, &files);
  if (files.rlim_cur < 2000) GTEST_SKIP() << "this system lets a program open " << files.rlim_cur << " files";
  const Folder folder;
  const Served served(folder);
  const int port = served.port();
  std::vector<Peer> idle;
  for (int i = 0; i < 1000; ++i) idle.emplace_back(port);
  EXPECT_TRUE(std::all_of(idle.begin(), idle.end(), [](const Peer& each) { return each.connected(); }));
  EXPECT_LT(time_of_an_answer(port), soon);

  std::vector<Peer> slow;  // a byte now and then, and never an end
  const std::string request_text = request(port, "GET /", "X-Slow: " + std::string(1000, 'x') + "\r\n");
  for (int i = 0; i < 50; ++i) slow.emplace_back(port);
  std::vector<Peer> deaf;  // ask and never read
  for (int i = 0; i < 50; ++i) {
    deaf.emplace_back(port);
    std::string questions;
    for (int j = 0; j < 200; ++j)
      questions += "GET / HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n\r\n";
    deaf.back().send(questions);
  }
  const double begin = now();
  for (std::size_t n = 0; now() - begin < 2; ++n) {
    for (const Peer& each : slow) each.send(request_text.substr(n % request_text.size(), 1));
    sleep_until(now() + 0.05);
  }
  EXPECT_LT(time_of_an_answer(port), soon);
  // Dribbling gains no time: the whole request has one deadline.
  for (std::size_t n = 40; now() - begin < 6; ++n) {
    for (const Peer& each : slow) each.send(request_text.substr(n % request_text.size(), 1));
    sleep_until(now() + 0.05);
  }
  EXPECT_TRUE(slow.front().is_closed_within(3));
  EXPECT_TRUE(idle.front().is_closed_within(3));
  EXPECT_LT(time_of_an_answer(port), soon);
  EXPECT_TRUE(served.is_up());
}

TEST(ServeAttack, ListenersThatReadNothingHoldNobodyUp) {
  const Folder folder;
  const Phone phone(1000, true);
  const Served served(folder,
                      {"--from", "phyphox:127.0.0.1:" + std::to_string(phone.port()), "-o", "swing.csv"});
  const int port = served.port();
  std::vector<Peer> listeners;
  for (int i = 0; i < 80; ++i) {
    listeners.emplace_back(port);
    listeners.back().send(request(port, "GET /api/events"));
  }
  ASSERT_EQ(status_of(ask(port, request(port, "POST /api/record"))), 200);
  sleep_until(now() + 2);
  EXPECT_LT(time_of_an_answer(port), soon);
  // Only so many are let in.
  EXPECT_EQ(status_of(listeners.front().receive(0.5)), 200);
  EXPECT_EQ(status_of(listeners.back().receive(0.5)), 503);
}

/// What a phone sends in a second, in a file that then grows to many megabytes.
void record_much(const Folder& folder, int port, std::size_t megabytes) {
  ASSERT_EQ(status_of(ask(port, request(port, "POST /api/record"))), 200);
  sleep_until(now() + 1);
  ASSERT_EQ(status_of(ask(port, request(port, "POST /api/stop"))), 200);
  std::string row = "0.5,1.25\n", megabyte;
  while (megabyte.size() < 1 << 20) megabyte += row;
  std::ofstream file(folder.path("swing.csv"), std::ios::app);
  for (std::size_t i = 0; i < megabytes; ++i) file << megabyte;
}

TEST(ServeAttack, DownloadsThatNobodyReadsTakeLittleMemory) {
  const Folder folder;
  const Phone phone(100, true);
  const Served served(folder,
                      {"--from", "phyphox:127.0.0.1:" + std::to_string(phone.port()), "-o", "swing.csv"});
  const int port = served.port();
  record_much(folder, port, 40);
  const double before = served.memory();
  std::vector<Peer> deaf;
  for (int i = 0; i < 60; ++i) {
    deaf.emplace_back(port);
    deaf.back().send(request(port, "GET /api/recordings/swing.csv"));
  }
  EXPECT_LT(time_of_an_answer(port), soon);
  EXPECT_LT(served.memory() - before, little);
  // Whoever reads gets all of it.
  const std::string answer = ask(port, request(port, "GET /api/recordings/swing.csv"), 30);
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_EQ(body_of(answer), folder.read("swing.csv"));
  EXPECT_LT(served.memory() - before, little);
}

TEST(ServeAttack, PagesThatNobodyReadsTakeLittleMemory) {
  const Folder folder;
  const Served served(folder);
  const int port = served.port();
  folder.write("page.html", "<html><!-- " + std::string(2 << 20, 'x') + " --></html>\n");
  EXPECT_EQ(body_of(ask(port, request(port, "GET /"))), folder.read("page.html"));
  const double before = served.memory();
  std::vector<Peer> deaf;
  for (int i = 0; i < 200; ++i) {
    deaf.emplace_back(port);
    deaf.back().send(request(port, "GET /"));
  }
  EXPECT_LT(time_of_an_answer(port), soon);
  EXPECT_LT(served.memory() - before, little);
}

TEST(ServeAttack, FewDescriptorsLeaveRoomForOthersAndForARecording) {
  Folder folder;
  folder.descriptors = 64;
  const Phone phone(100, true);
  const Served served(folder,
                      {"--from", "phyphox:127.0.0.1:" + std::to_string(phone.port()), "-o", "swing.csv"});
  const int port = served.port();
  std::vector<Peer> listeners, idle;
  for (int i = 0; i < 100; ++i) {
    listeners.emplace_back(port);
    listeners.back().send(request(port, "GET /api/events"));
  }
  EXPECT_EQ(status_of(ask(port, request(port, "GET /api/status"))), 200);
  for (int i = 0; i < 300; ++i) idle.emplace_back(port);
  EXPECT_EQ(status_of(ask(port, request(port, "GET /api/status"))), 200);
  EXPECT_EQ(status_of(ask(port, request(port, "POST /api/record"))), 200);
  sleep_until(now() + 1);
  EXPECT_EQ(status_of(ask(port, request(port, "POST /api/stop"))), 200);
  EXPECT_EQ(status_of(ask(port, request(port, "GET /api/recordings/swing.csv"))), 200);
}

TEST(ServeAttack, AStopDoesNotWaitForADeviceThatDoesNotAnswer) {
  const Folder folder;
  // A port that takes a connection and says nothing: the phone is waited for.
  const SilentPort silent;
  const Served served(folder,
                      {"--from", "phyphox:127.0.0.1:" + std::to_string(silent.port()), "-o", "swing.csv"});
  const int port = served.port();
  const Peer recorder(port);
  recorder.send(request(port, "POST /api/record"));
  sleep_until(now() + 0.3);
  const double begin = now();
  EXPECT_EQ(status_of(ask(port, request(port, "POST /api/stop"))), 200);
  EXPECT_LT(now() - begin, soon);
  EXPECT_EQ(status_of(recorder.receive(20)), 409);
  EXPECT_THAT(ask(port, request(port, "GET /api/status")), HasSubstr("\"running\":false"));
  EXPECT_FALSE(folder.has("swing.csv"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
