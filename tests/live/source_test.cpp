#include "cromer/live/source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

void expect(std::string_view text, SourceKind kind, std::string_view place, int number) {
  const auto name = parse_source(text);
  ASSERT_TRUE(name) << text;
  EXPECT_EQ(name->kind, kind) << text;
  EXPECT_EQ(name->place, place) << text;
  EXPECT_EQ(name->number, number) << text;
}

TEST(SourceName, IsReadInEveryForm) {
  expect("-", SourceKind::standard_input, "", 0);
  expect("serial:/dev/ttyUSB0", SourceKind::serial, "/dev/ttyUSB0", 115200);
  expect("serial:/dev/ttyUSB0:9600", SourceKind::serial, "/dev/ttyUSB0", 9600);
  expect("serial:/dev/serial/by-path/pci-0000:00:14.0-usb-0:1:1.0-port0", SourceKind::serial,
         "/dev/serial/by-path/pci-0000:00:14.0-usb-0:1:1.0-port0", 115200);
  expect("tcp:sensor.local:5000", SourceKind::tcp, "sensor.local", 5000);
  expect("tcp:[::1]:5000", SourceKind::tcp, "::1", 5000);
  expect("tcp:sensor.local:1", SourceKind::tcp, "sensor.local", 1);
  expect("tcp:sensor.local:65535", SourceKind::tcp, "sensor.local", 65535);
  expect("phyphox:192.168.1.7", SourceKind::phyphox, "192.168.1.7", 8080);
  expect("phyphox:192.168.1.7:80", SourceKind::phyphox, "192.168.1.7", 80);
}

TEST(SourceName, WhatIsNoneNamesTheForms) {
  for (const char* text :
       {"", "/dev/ttyUSB0", "usb:1", "tcp:host", "tcp:host:0", "tcp:host:65536", "tcp::5000", "tcp:[::1:5000",
        "phyphox:", "phyphox:host:x", "serial:", "serial::9600"}) {
    const auto name = parse_source(text);
    ASSERT_FALSE(name) << text;
    EXPECT_THAT(in_words(name.error()), ::testing::HasSubstr("serial:DEVICE[:BAUD]")) << text;
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
