#include "cromer/os/replacement.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "cromer/documents/words/words.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace CROMER_FILE {

namespace fs = std::filesystem;

class ReplacementOf : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "cromer-base-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  mode_t mode(const std::string& name) const {
    struct stat found {};
    return ::stat(path(name).c_str(), &found) == 0 ? found.st_mode & 07777 : 0;
  }
  fs::path folder_;
};

using Maker = Result<Replacement> (*)(const std::string&);

TEST_F(ReplacementOf, AFileTakesItsPlaceOnceItIsWhole) {
  for (const Maker make : {&Replacement::beside, &Replacement::named_beside}) {
    const std::string file = path("file");
    std::ofstream(file) << "old";
    ASSERT_EQ(::chmod(file.c_str(), 0604), 0);
    auto fresh = make(file);
    ASSERT_TRUE(fresh.ok());
    ASSERT_EQ(::write(fresh->descriptor(), "new", 3), 3);
    EXPECT_EQ(bytes_of(path("file")), "old");
    ASSERT_TRUE(fresh->take_place().ok());
    EXPECT_EQ(bytes_of(path("file")), "new");
    EXPECT_EQ(mode("file"), 0604u);
    EXPECT_EQ(entries(), 1u);
    fs::remove(file);
  }
}

TEST_F(ReplacementOf, ANewFileHasThePermissionsOfNewFiles) {
  const mode_t mask = ::umask(027);
  for (const Maker make : {&Replacement::beside, &Replacement::named_beside}) {
    auto fresh = make(path("new"));
    EXPECT_TRUE(fresh.ok() && fresh->take_place().ok());
    EXPECT_EQ(mode("new"), 0640u);
    EXPECT_EQ(::umask(027), 027u);  // as it was
    fs::remove(path("new"));
  }
  ::umask(mask);
}

TEST_F(ReplacementOf, NothingIsLeftOfOneThatTookNoPlace) {
  {
    auto fresh = Replacement::named_beside(path("new"));
    ASSERT_TRUE(fresh.ok());
    const std::string name = fs::path(fresh->name()).filename().string();
    EXPECT_EQ(name.size(), 14u);
    EXPECT_TRUE(name.starts_with(".cromer-")) << name;
    EXPECT_EQ(entries(), 1u);
    const Replacement moved = std::move(*fresh);
    EXPECT_EQ(entries(), 1u);
  }
  EXPECT_EQ(entries(), 0u);
}

TEST_F(ReplacementOf, OldLeftoversOfItsOwnGo) {
  const auto leave = [&](const std::string& name, std::chrono::seconds age) {
    std::ofstream(path(name)) << "x";
    fs::last_write_time(path(name), fs::file_time_type::clock::now() - age);
  };
  leave(".cromer-aaaaaa", std::chrono::seconds(3700));
  leave(".cromer-bbbbbb", std::chrono::seconds(3500));
  leave(".cromer-aaaaaaa", std::chrono::seconds(9000));
  leave(".cromer-aaaaa", std::chrono::seconds(9000));
  leave(".croner-aaaaaa", std::chrono::seconds(9000));
  fs::create_directory(path(".cromer-cccccc"));
  fs::last_write_time(path(".cromer-cccccc"), fs::file_time_type::clock::now() - std::chrono::hours(3));
  ASSERT_TRUE(Replacement::beside(path("new")).ok());
  EXPECT_FALSE(fs::exists(path(".cromer-aaaaaa")));
  for (const char* kept :
       {".cromer-bbbbbb", ".cromer-aaaaaaa", ".cromer-aaaaa", ".croner-aaaaaa", ".cromer-cccccc"})
    EXPECT_TRUE(fs::exists(path(kept))) << kept;
  // Once for each folder.
  leave(".cromer-dddddd", std::chrono::seconds(9000));
  ASSERT_TRUE(Replacement::beside(path("new")).ok());
  EXPECT_TRUE(fs::exists(path(".cromer-dddddd")));
}

TEST_F(ReplacementOf, ALinkIsFollowedToItsEnd) {
  fs::create_directory(path("sub"));
  fs::create_symlink("sub/file", path("near"));
  fs::create_symlink(path("near"), path("far"));
  EXPECT_EQ(target_of(path("far")), path("sub/file"));
  EXPECT_EQ(target_of(path("near")), path("sub/file"));
  EXPECT_EQ(target_of(path("sub")), path("sub"));
  fs::create_symlink("b", path("a"));
  fs::create_symlink("a", path("b"));
  EXPECT_FALSE(target_of(path("a")).empty());  // a ring ends, too
}

TEST_F(ReplacementOf, WhatCannotBeIsNamed) {
  EXPECT_EQ(folder_of("file"), ".");
  EXPECT_EQ(folder_of("a/b/file"), "a/b");
  EXPECT_EQ(in_words(cannot_write("x", ENOENT)), "cannot write x: No such file or directory");
  for (const Maker make : {&Replacement::beside, &Replacement::named_beside}) {
    const auto missing = make(path("no/file"));
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(in_words(missing.error()), "cannot write " + path("no/file") + ": No such file or directory");
    auto fresh = make(path("folder/file"));
    EXPECT_FALSE(fresh.ok());
  }
  fs::create_directory(path("folder"));
  auto fresh = Replacement::beside(path("folder"));
  ASSERT_TRUE(fresh.ok());
  EXPECT_FALSE(fresh->take_place().ok());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
