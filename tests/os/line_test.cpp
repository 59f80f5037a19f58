#include "cromer/os/line.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/tcp.h>
#include <stdlib.h>
#include <termios.h>

#include "cromer/documents/words/words.h"
#include "cromer/live/source.h"
#include "tests/live/server.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::StartsWith;

/// A pseudo-terminal; the other side is its device.
struct Terminal {
  Terminal() : master(::posix_openpt(O_RDWR | O_NOCTTY)) {
    ::grantpt(master.number());
    ::unlockpt(master.number());
    device = ::ptsname(master.number());
  }
  Descriptor master;
  std::string device;
};

TEST(Serial, LinesAreSetToTheirSpeed) {
  const Terminal terminal;
  const std::pair<int, speed_t> speeds[] = {
      {1200, B1200},     {2400, B2400},     {4800, B4800},       {9600, B9600},      {19200, B19200},
      {38400, B38400},   {57600, B57600},   {115200, B115200},   {230400, B230400},  {460800, B460800},
      {500000, B500000}, {921600, B921600}, {1000000, B1000000}, {2000000, B2000000}};
  for (const auto& [baud, code] : speeds) {
    const auto line = open_serial(terminal.device, baud);
    ASSERT_TRUE(line) << baud << ' ' << in_words(line.error());
    termios settings{};
    ASSERT_EQ(::tcgetattr(line->number(), &settings), 0);
    EXPECT_EQ(::cfgetispeed(&settings), code) << baud;
    EXPECT_EQ(::cfgetospeed(&settings), code) << baud;
    EXPECT_EQ(settings.c_lflag & (ICANON | ECHO), 0u);
    EXPECT_EQ(settings.c_cflag & CSIZE, static_cast<tcflag_t>(CS8));
    EXPECT_EQ(settings.c_cflag & CRTSCTS, 0u);
  }
}

TEST(Serial, WhatIsNoLineIsRefused) {
  const auto refusal = [](const std::string& device, int baud) {
    const auto line = open_serial(device, baud);
    return line ? "opened" : in_words(line.error());
  };
  EXPECT_EQ(refusal("/dev/null", 9601),
            "serial:/dev/null: 9601 baud is not a speed of serial lines; 9600 and 115200 are usual");
  EXPECT_EQ(refusal("/dev/nothing there", 9600), "serial:/dev/nothing there: No such file or directory");
  EXPECT_THAT(refusal("/dev/null", 9600), StartsWith("serial:/dev/null: that is no serial line ("));
}

TEST(Tcp, APulledCableIsSeenWithinHalfAMinute) {
  Server server([](const std::string&) { return Reply{}; });
  const auto connection = open_tcp("127.0.0.1", server.port(), 1);
  ASSERT_TRUE(connection);
  const auto option = [&](int level, int name) {
    int value = 0;
    socklen_t size = sizeof value;
    EXPECT_EQ(::getsockopt(connection->number(), level, name, &value, &size), 0);
    return value;
  };
  EXPECT_EQ(option(SOL_SOCKET, SO_KEEPALIVE), 1);
  EXPECT_EQ(option(IPPROTO_TCP, TCP_NODELAY), 1);
  EXPECT_EQ(option(IPPROTO_TCP, TCP_KEEPIDLE), 10);
  EXPECT_EQ(option(IPPROTO_TCP, TCP_KEEPINTVL), 5);
  EXPECT_EQ(option(IPPROTO_TCP, TCP_KEEPCNT), 3);
}

TEST(Tcp, WhatCannotBeReachedIsNamed) {
  const auto refused = open_tcp("127.0.0.1", 1, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(in_words(refused.error()), "127.0.0.1:1: Connection refused");
  const auto unknown = open_tcp("no host", 5000, 1);
  ASSERT_FALSE(unknown);
  EXPECT_THAT(in_words(unknown.error()), StartsWith("no host: "));
}

TEST(Line, IsReadableWhereSomethingCame) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const Descriptor from(ends[0]);
  Descriptor to(ends[1]);
  const double begun = steady_seconds();
  EXPECT_FALSE(readable(from, 0.05));
  EXPECT_GE(steady_seconds() - begun, 0.045);
  EXPECT_LT(steady_seconds() - begun, 0.5);
  ASSERT_EQ(::write(to.number(), "a", 1), 1);
  EXPECT_TRUE(readable(from, 0));
  char byte;
  ASSERT_EQ(::read(from.number(), &byte, 1), 1);
  to.close();
  EXPECT_FALSE(to.is_open());
  EXPECT_TRUE(readable(from, 0));
}

TEST(Line, OwnsItsNumber) {
  EXPECT_FALSE(Descriptor().is_open());
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  Descriptor first(ends[0]), last(ends[1]);
  Descriptor moved(std::move(first));
  EXPECT_EQ(moved.number(), ends[0]);
  moved.close();
  EXPECT_EQ(::close(ends[0]), -1);
  EXPECT_TRUE(Descriptor(::dup(0)).is_open());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
