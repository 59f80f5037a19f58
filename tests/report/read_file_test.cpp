#include "cromer/report/read_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace {

using testing::HasSubstr;

class ReadFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "cromer-read-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const char* name) const { return (folder_ / name).string(); }
  std::filesystem::path folder_;
};

TEST_F(ReadFile, DevicesAreRefused) {
  for (const char* device : {"/dev/zero", "/dev/urandom", "/dev/null"}) {
    const auto bytes = read_file(device);
    ASSERT_FALSE(bytes.ok()) << device;
    EXPECT_THAT(in_words(bytes.error()), HasSubstr("is a device"));
  }
}

TEST_F(ReadFile, ZerosStopEarly) {
  std::ofstream(path("zeros"), std::ios::binary) << std::string(100000, '\0');
  const auto bytes = read_file(path("zeros"));
  ASSERT_FALSE(bytes.ok());
  EXPECT_THAT(in_words(bytes.error()), HasSubstr("zero bytes"));
}

TEST_F(ReadFile, APipeIsReadToItsEnd) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  const std::string sent(200000, 'x');
  std::thread writer([&] { std::ofstream(path("pipe"), std::ios::binary) << sent; });
  const auto bytes = read_file(path("pipe"));
  writer.join();
  ASSERT_TRUE(bytes.ok());
  EXPECT_TRUE(*bytes == sent);
}

TEST_F(ReadFile, OfAnySizeIsReadWhole) {
  for (const std::size_t size : {0u, 1u, 65535u, 65536u, 65537u, 300000u}) {
    std::string sent(size, 'x');
    if (size > 0) sent[0] = '\0';
    if (size > 1) sent.back() = 'z';
    std::ofstream(path("file"), std::ios::binary) << sent;
    const auto bytes = read_file(path("file"));
    if (size == 1) {
      EXPECT_FALSE(bytes.ok());  // nothing but a zero
      continue;
    }
    ASSERT_TRUE(bytes.ok()) << size;
    EXPECT_TRUE(*bytes == sent) << size;
  }
}

TEST_F(ReadFile, WhatIsNoFileIsNamed) {
  EXPECT_EQ(in_words(read_file(path("none")).error()),
            path("none") + ": cannot be read: No such file or directory");
  EXPECT_EQ(in_words(read_file(folder_.string()).error()),
            folder_.string() + ": is a folder; name a file in it");
}

TEST_F(ReadFile, ZerosAfterABeginningAreData) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  std::string sent(70000, 'x');
  sent.append(200000, '\0');
  std::thread writer([&] { std::ofstream(path("pipe"), std::ios::binary) << sent; });
  const auto bytes = read_file(path("pipe"));
  writer.join();
  ASSERT_TRUE(bytes.ok());
  EXPECT_TRUE(*bytes == sent);
}

}  // namespace
}  // namespace cromer::core
