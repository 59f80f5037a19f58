#include "cromer/live/recording_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "cromer/documents/words/words.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace CROMER_FILE {

namespace fs = std::filesystem;

class RecordingFiles : public ::testing::Test {
 protected:
  RecordingFiles()
      : path_(fs::temp_directory_path() / ("cromer-file-" + std::to_string(::getpid()) + ".csv")) {
    fs::remove(path_);
  }
  ~RecordingFiles() override { fs::remove(path_); }
  std::string content() const { return bytes_of(path_); }
  void put(const std::string& text) const { std::ofstream(path_, std::ios::binary) << text; }
  fs::path path_;
};

TEST_F(RecordingFiles, HoldCommentsHeadingsAndRows) {
  RecordingFile file;
  ASSERT_TRUE(file.open(path_));
  ASSERT_TRUE(file.begin({"one", "two"}, {"Time (s)", "x", "y"}));
  EXPECT_EQ(file.rows(), 0u);
  SampleRows rows;
  rows.width = 2;
  rows.add(0, std::vector{1.5, std::nan("")});
  rows.add(0.25, std::vector{HUGE_VAL, -2.0});
  ASSERT_TRUE(file.append(rows));
  EXPECT_EQ(file.rows(), 2u);
  ASSERT_TRUE(file.comment({"the end"}));
  EXPECT_EQ(file.rows(), 2u);
  ASSERT_TRUE(file.sync());
  file.drop_if_empty();
  EXPECT_EQ(content(), "# one\n# two\nTime (s),x,y\n0,1.5,\n0.25,,-2\n# the end\n");
}

TEST_F(RecordingFiles, OverwriteNothing) {
  put("a");
  RecordingFile file;
  const auto opened = file.open(path_);
  ASSERT_FALSE(opened);
  EXPECT_EQ(in_words(opened.error()), path_.string() +
                                          " exists and is not empty; a recording overwrites nothing: "
                                          "name another file, or move that one away");
  file.drop_if_empty();
  EXPECT_EQ(content(), "a");
}

TEST_F(RecordingFiles, APipeThatNobodyReadsFromIsNotWaitedFor) {
  ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
  RecordingFile file;
  const auto opened = file.open(path_);
  ASSERT_FALSE(opened);
  EXPECT_EQ(in_words(opened.error()), "cannot write " + path_.string() + ": nobody reads from this pipe");
}

TEST_F(RecordingFiles, ALinkToWhatIsNotThereYetStaysOne) {
  const fs::path link = path_.string() + ".link";
  fs::create_symlink(path_, link);
  RecordingFile file;
  ASSERT_TRUE(file.open(link));
  ASSERT_TRUE(file.begin({}, {"a"}));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(content(), "a\n");
  fs::remove(link);
}

TEST_F(RecordingFiles, AnEmptyOneIsTakenAndLeft) {
  put("");
  RecordingFile file;
  ASSERT_TRUE(file.open(path_));
  file.drop_if_empty();
  EXPECT_TRUE(fs::exists(path_));
  ASSERT_TRUE(file.begin({}, {"a"}));
  EXPECT_EQ(content(), "a\n");
  RecordingFile none;
  const auto opened = none.open("/no such folder/a.csv");
  ASSERT_FALSE(opened);
  EXPECT_NE(in_words(opened.error()).find("No such file or directory"), std::string::npos);
}

TEST_F(RecordingFiles, ANewOneIsDroppedWhereNothingWasWritten) {
  RecordingFile file;
  ASSERT_TRUE(file.open(path_));
  EXPECT_TRUE(fs::exists(path_));
  file.drop_if_empty();
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(RecordingFiles, LinesOfAnyLengthAreWrittenWhole) {
  const std::string longer(5000, 'a'), piece(4095, 'b');
  RecordingFile file;
  ASSERT_TRUE(file.open(path_));
  ASSERT_TRUE(file.begin({longer, "short", piece.substr(2), longer}, {piece, "x"}));
  EXPECT_EQ(content(),
            "# " + longer + "\n# short\n# " + piece.substr(2) + "\n# " + longer + "\n" + piece + ",x\n");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
