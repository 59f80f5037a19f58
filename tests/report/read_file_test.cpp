#include "cromer/report/read_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

namespace cromer {
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
    EXPECT_THAT(bytes.error().message, HasSubstr("is a device"));
  }
}

TEST_F(ReadFile, ZerosStopEarly) {
  std::ofstream(path("zeros"), std::ios::binary) << std::string(100000, '\0');
  const auto bytes = read_file(path("zeros"));
  ASSERT_FALSE(bytes.ok());
  EXPECT_THAT(bytes.error().message, HasSubstr("zero bytes"));
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

}  // namespace
}  // namespace cromer
