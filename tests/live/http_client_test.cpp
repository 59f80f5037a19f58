#include "cromer/live/http_client.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"
#include "cromer/live/source.h"
#include "cromer/os/line.h"
#include "server.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::StartsWith;

std::string got(HttpClient& client, const std::string& target, double seconds = 2) {
  const auto answer = client.get(target, seconds);
  return answer ? *answer : "Error: " + in_words(answer.error());
}

/// What comes of one question that is answered so.
std::string got_of(const Reply& reply) {
  Server server([&](const std::string&) { return reply; });
  HttpClient client("127.0.0.1", server.port());
  return got(client, "/get?a=full");
}

TEST(HttpClient, AsksOverOneConnection) {
  Server server([](const std::string& target) { return Reply{http("of " + target)}; });
  HttpClient client("127.0.0.1", server.port());
  EXPECT_EQ(got(client, "/config"), "of /config");
  EXPECT_EQ(got(client, "/get?t=1"), "of /get?t=1");
  EXPECT_EQ(server.connections(), 1);
  EXPECT_EQ(server.requests().at(1),
            "GET /get?t=1 HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server.port()) +
                "\r\nAccept: application/json\r\nConnection: keep-alive\r\n\r\n");
}

TEST(HttpClient, ConnectsAgainWhereTheConnectionIsClosed) {
  Server closing([](const std::string&) { return Reply{http("a", "Connection: close\r\n"), true}; });
  HttpClient client("127.0.0.1", closing.port());
  EXPECT_EQ(got(client, "/"), "a");
  EXPECT_EQ(got(client, "/"), "a");
  EXPECT_EQ(closing.connections(), 2);
  // A kept one may have been closed meanwhile: asked again, but once.
  int asked = 0;
  Server forgetful([&](const std::string&) { return ++asked == 2 ? Reply{"", true} : Reply{http("a")}; });
  HttpClient again("127.0.0.1", forgetful.port());
  EXPECT_EQ(got(again, "/"), "a");
  EXPECT_EQ(got(again, "/"), "a");
  EXPECT_EQ(forgetful.connections(), 2);
  int left = 1;
  Server broken([&](const std::string&) { return left-- > 0 ? Reply{http("a")} : Reply{"", true}; });
  HttpClient other("127.0.0.1", broken.port());
  EXPECT_EQ(got(other, "/"), "a");
  EXPECT_EQ(got(other, "/"), "Error: the connection was closed");
  EXPECT_EQ(broken.requests().size(), 3u);
  EXPECT_EQ(got(other, "/"), "Error: the connection was closed");
  EXPECT_EQ(broken.requests().size(), 4u);
}

TEST(HttpClient, TakesAnAnswerWithoutALengthUpToItsEnd) {
  EXPECT_EQ(got_of({"HTTP/1.1 200 OK\r\n\r\nabc", true}), "abc");
  EXPECT_EQ(got_of({http(std::string(100000, 'x'))}), std::string(100000, 'x'));
}

TEST(HttpClient, SaysWhatIsWrongWithAnAnswer) {
  EXPECT_EQ(got_of({"HTTP/1.1 404 Not Found\r\nContent-Length: 1\r\n\r\nx"}),
            "Error: /get is answered with status 404");
  EXPECT_THAT(got_of({"phyphox\r\n\r\n"}), StartsWith("Error: the answer is no HTTP ("));
  EXPECT_EQ(got_of({"HTTP/1.1 200 OK\r\nContent-Length: 9\r\n\r\nabc", true}), "Error: the answer broke off");
  EXPECT_EQ(got_of({"HTTP/1.1 200", true}), "Error: the answer broke off");
  EXPECT_EQ(got_of({"", true}), "Error: the connection was closed");
}

TEST(HttpClient, SixtyFourMegabytesAreTaken) {
  const auto announced = [](std::size_t bytes) {
    return got_of({"HTTP/1.1 200 OK\r\nContent-Length: " + std::to_string(bytes) + "\r\n\r\nabc", true});
  };
  EXPECT_EQ(announced(64 << 20), "Error: the answer broke off");
  EXPECT_THAT(announced((64 << 20) + 1), StartsWith("Error: the answer is no HTTP ("));
  EXPECT_EQ(got_of({http("a", "X: " + std::string(65000, 'x') + "\r\n")}), "a");
  EXPECT_THAT(got_of({http("a", "X: " + std::string(66000, 'x') + "\r\n")}),
              StartsWith("Error: the answer is no HTTP ("));
}

TEST(HttpClient, HalfAnAnswerIsWaitedFor) {
  Server server([](const std::string&) { return Reply{http("abcdef").substr(0, 20)}; });
  HttpClient client("127.0.0.1", server.port());
  const double begun = steady_seconds();
  EXPECT_EQ(got(client, "/", 0.15), "Error: no answer in time");
  EXPECT_GE(steady_seconds() - begun, 0.14);
  EXPECT_LT(steady_seconds() - begun, 1);
  EXPECT_EQ(server.requests().size(), 1u);
}

TEST(HttpClient, ASilentOneIsNotAskedAgain) {
  int asked = 0;
  Server server([&](const std::string&) { return Reply{++asked == 1 ? http("a") : ""}; });
  HttpClient client("127.0.0.1", server.port());
  EXPECT_EQ(got(client, "/"), "a");
  EXPECT_EQ(got(client, "/", 0.1), "Error: no answer in time");
  EXPECT_EQ(server.requests().size(), 2u);
}

TEST(HttpClient, IsGivenItsTimeToConnect) {
  // A host that takes no more connections: one waits to be taken, the next ones go unanswered.
  const Descriptor busy(::socket(AF_INET, SOCK_STREAM, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ASSERT_EQ(::bind(busy.number(), reinterpret_cast<sockaddr*>(&address), size), 0);
  ASSERT_EQ(::listen(busy.number(), 0), 0);
  ::getsockname(busy.number(), reinterpret_cast<sockaddr*>(&address), &size);
  const Descriptor first(::socket(AF_INET, SOCK_STREAM, 0));
  ASSERT_EQ(::connect(first.number(), reinterpret_cast<sockaddr*>(&address), size), 0);
  HttpClient client("127.0.0.1", ntohs(address.sin_port));
  const double begun = steady_seconds();
  EXPECT_THAT(got(client, "/", 0.3), testing::EndsWith(": Connection timed out"));
  EXPECT_GE(steady_seconds() - begun, 0.29);
}

TEST(HttpClient, WhereNobodyListensItSaysSo) {
  int port = 0;
  {
    Server server([](const std::string&) { return Reply{}; });
    port = server.port();
  }
  HttpClient client("127.0.0.1", port);
  EXPECT_EQ(got(client, "/"), "Error: 127.0.0.1:" + std::to_string(port) + ": Connection refused");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
