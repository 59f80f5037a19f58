#include "cromer/report/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "cromer/documents/words/words.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace CROMER_FILE {

namespace fs = std::filesystem;

class WriteFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "cromer-file-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override {
    fs::permissions(folder_, fs::perms::owner_all);
    fs::remove_all(folder_);
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::size_t entries() const {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_)) ++count;
    return count;
  }
  fs::path folder_;
};

TEST_F(WriteFile, WritesTheBytesAndNothingElse) {
  const std::string bytes("a\0b\n", 4);
  ASSERT_TRUE(check_writable(path("new.csv")).ok());
  EXPECT_EQ(entries(), 0u);
  ASSERT_TRUE(write_file(path("new.csv"), bytes).ok());
  EXPECT_EQ(bytes_of(path("new.csv")), bytes);
  ASSERT_TRUE(write_file(path("new.csv"), "shorter").ok());
  EXPECT_EQ(bytes_of(path("new.csv")), "shorter");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(WriteFile, KeepsPermissionsAndHonoursTheMask) {
  ASSERT_TRUE(write_file(path("a"), "1").ok());
  struct stat found {};
  ASSERT_EQ(::stat(path("a").c_str(), &found), 0);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  EXPECT_EQ(found.st_mode & 0777, 0666 & ~mask);
  ASSERT_EQ(::chmod(path("a").c_str(), 0640), 0);
  ASSERT_TRUE(write_file(path("a"), "2").ok());
  ASSERT_EQ(::stat(path("a").c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 0777, 0640u);
}

TEST_F(WriteFile, AFolderAndAMissingFolderAreNamed) {
  for (const auto& write : {+[](const std::string& p) { return write_file(p, "x"); },
                            +[](const std::string& p) { return check_writable(p); }}) {
    const auto folder = write(folder_.string());
    ASSERT_FALSE(folder.ok());
    EXPECT_NE(in_words(folder.error()).find(folder_.string()), std::string::npos);
    EXPECT_NE(in_words(folder.error()).find("folder"), std::string::npos);
    const auto missing = write(path("no/such/file.csv"));
    ASSERT_FALSE(missing.ok());
    EXPECT_NE(in_words(missing.error()).find("no/such/file.csv"), std::string::npos);
    EXPECT_FALSE(write("").ok());
  }
  EXPECT_EQ(entries(), 0u);
}

TEST_F(WriteFile, AnUnwritableFolderIsNamedAndLeftAlone) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_FALSE(check_writable(path("a.csv")).ok());
  EXPECT_FALSE(write_file(path("a.csv"), "x").ok());
}

TEST_F(WriteFile, AFullDiskLeavesTheOldFileAndNothingElse) {
  ASSERT_TRUE(write_file(path("old.csv"), "old").ok());
  struct rlimit limit {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{4096, limit.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto written = write_file(path("old.csv"), std::string(100000, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(written.ok());
  EXPECT_NE(in_words(written.error()).find("old.csv"), std::string::npos);
  EXPECT_EQ(bytes_of(path("old.csv")), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(WriteFile, ADeviceIsWrittenToDirectly) {
  EXPECT_TRUE(write_file("/dev/null", "x").ok());
  EXPECT_TRUE(check_writable("/dev/null").ok());
  struct stat found {};
  ASSERT_EQ(::stat("/dev/null", &found), 0);
  EXPECT_TRUE(S_ISCHR(found.st_mode));
  if (fs::exists("/dev/full")) {
    EXPECT_FALSE(write_file("/dev/full", "x").ok());
  }
}

TEST_F(WriteFile, ALinkStaysALink) {
  ASSERT_TRUE(write_file(path("target"), "1").ok());
  fs::create_symlink(path("target"), path("link"));
  ASSERT_TRUE(write_file(path("link"), "2").ok());
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(bytes_of(path("target")), "2");
}

TEST_F(WriteFile, ALinkToNothingIsFollowedToo) {
  fs::create_directory(path("sub"));
  fs::create_symlink("sub/target", path("link"));
  fs::create_symlink("link", path("link to the link"));
  ASSERT_TRUE(write_file(path("link to the link"), "1").ok());
  EXPECT_TRUE(fs::is_symlink(path("link to the link")));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(bytes_of(path("sub/target")), "1");
}

TEST_F(WriteFile, AKilledProgramLeavesNothing) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    (void)write_file(path("new.csv"), [&](const PieceSink& write) {
      (void)write("half a li");
      (void)!::write(ready[1], "x", 1);
      ::pause();
      return Result<void>{};
    });
    ::_exit(0);
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ::close(ready[0]), ::close(ready[1]);
  const int unnamed = ::open(folder_.c_str(), O_TMPFILE | O_RDWR, 0600);
  if (unnamed < 0) GTEST_SKIP() << "this file system has no files without a name";
  ::close(unnamed);
  EXPECT_EQ(entries(), 0u);
}

TEST_F(WriteFile, WhatKilledProgramsLeftLongAgoGoes) {
  const auto leave = [&](const std::string& name, int hours) {
    std::ofstream(path(name)) << "x";
    fs::last_write_time(path(name), fs::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  leave(".cromer-a1B2c3", 2);
  leave(".cromer-Z9y8x7", 0);
  leave(".cromer-notes.txt", 2);
  ASSERT_TRUE(write_file(path("new.csv"), "1").ok());
  EXPECT_FALSE(fs::exists(path(".cromer-a1B2c3")));
  EXPECT_TRUE(fs::exists(path(".cromer-Z9y8x7"))) << "somebody may be writing it";
  EXPECT_TRUE(fs::exists(path(".cromer-notes.txt")));
}

TEST_F(WriteFile, AFileIsNoFolder) {
  ASSERT_TRUE(write_file(path("a"), "1").ok());
  for (const std::string& below : {path("a/b"), path("a/b/c")}) {
    EXPECT_EQ(in_words(check_writable(below).error()), "cannot write " + below + ": Not a directory");
    EXPECT_FALSE(write_file(below, "x").ok());
  }
  EXPECT_EQ(in_words(check_writable(path("no/b")).error()),
            "cannot write " + path("no/b") + ": there is no folder " + path("no"));
  EXPECT_TRUE(check_writable("-").ok());
  EXPECT_TRUE(check_writable(path("a")).ok());
  EXPECT_EQ(bytes_of(path("a")), "1");
}

TEST_F(WriteFile, AnErrorOfTheMakersLeavesTheOldFile) {
  ASSERT_TRUE(write_file(path("a"), "old").ok());
  const auto written = write_file(path("a"), [](const PieceSink& write) -> Result<void> {
    if (auto piece = write("half"); !piece) return piece;
    return Error{"no more"};
  });
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(in_words(written.error()), "no more");
  EXPECT_EQ(bytes_of(path("a")), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(WriteFile, APipeThatNobodyReadsFromIsNotWaitedFor) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const auto written = write_file(path("pipe"), "one");
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(in_words(written.error()), "cannot write " + path("pipe") + ": nobody reads from this pipe");
}

TEST_F(WriteFile, ASocketIsNoPipe) {
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = path("socket");
  ASSERT_LT(name.size(), sizeof address.sun_path);
  name.copy(address.sun_path, name.size());
  ASSERT_EQ(::bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  const auto written = write_file(name, "one");
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(in_words(written.error()), "cannot write " + name + ": No such device or address");
  ::close(socket);
}

TEST_F(WriteFile, APipeIsWrittenToDirectlyPieceByPiece) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const int reader = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  const auto written = write_file(path("pipe"), [](const PieceSink& write) {
    const auto first = write("one ");
    return first ? write("two") : first;
  });
  EXPECT_TRUE(written.ok());
  char text[20]{};
  EXPECT_EQ(::read(reader, text, sizeof text), 7);
  EXPECT_STREQ(text, "one two");
  ::close(reader);
  EXPECT_EQ(entries(), 1u);
}

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
  std::ofstream(path("swing.csv")) << "1\n";
  EXPECT_EQ(in_words(read_file(path("swng.csv")).error()),
            path("swng.csv") + ": cannot be read: No such file or directory; did you mean \"" +
                path("swing.csv") + "\"?");
  EXPECT_EQ(in_words(read_file(path("no/swing.csv")).error()),
            path("no/swing.csv") + ": cannot be read: No such file or directory");
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

}  // namespace CROMER_FILE
}  // namespace cromer::core
