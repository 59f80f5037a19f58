// A disk that is full: what is in the file is whole, and no more is counted than is in it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "cromer/documents/words/words.h"
#include "cromer/live/recorder.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// No file may grow beyond so many bytes, as long as the object lives, for the whole process.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

class FullDisk : public ::testing::Test {
 protected:
  FullDisk() : path_(fs::temp_directory_path() / ("cromer-full-" + std::to_string(::getpid()) + ".csv")) {
    fs::remove(path_);
  }
  ~FullDisk() override { fs::remove(path_); }
  std::string content() const { return bytes_of(path_); }
  fs::path path_;
};

/// Numbers of which a part reads as another number.
SampleRows rows(std::size_t count) {
  SampleRows rows;
  rows.width = 1;
  for (std::size_t n = 0; n < count; ++n)
    rows.add(static_cast<double>(n) / 8, std::vector{0.1234567891 + static_cast<double>(n)});
  return rows;
}

/// Sends them all at once and waits.
class Logger final : public Source {
 public:
  explicit Logger(std::size_t count) : count_(count) {}
  Result<void> open() override { return {}; }
  bool receive(double, SampleRows& to, std::vector<Remark>&) override {
    to = rows(sent_ ? 0 : count_);
    sent_ = true;
    return true;
  }
  const Headings& headings() const override { return headings_; }

 private:
  Headings headings_{"Time (s)", "Value"};
  std::size_t count_;
  bool sent_ = false;
};

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

// Some limit falls on each place of a line: within the time, within the value, at its end.
TEST_F(FullDisk, EndsWithAWholeLineWhereverItIsFull) {
  RecordingFile whole;
  ASSERT_TRUE(whole.open(path_));
  ASSERT_TRUE(whole.begin({"test"}, {"Time (s)", "Value"}));
  ASSERT_TRUE(whole.append(rows(1000)));

  EXPECT_EQ(whole.rows(), 1000u);
  const std::string all = content();
  for (rlim_t bytes = 5000; bytes < 5040; ++bytes) {
    fs::remove(path_);
    RecordingFile file;
    ASSERT_TRUE(file.open(path_));
    {
      const SmallDisk disk(bytes);
      ASSERT_TRUE(file.begin({"test"}, {"Time (s)", "Value"}));
      ASSERT_TRUE(file.append(rows(100)));
      SampleRows more = rows(1000);
      more.t.erase(more.t.begin(), more.t.begin() + 100);
      more.values.erase(more.values.begin(), more.values.begin() + 100);
      const auto written = file.append(more);
      ASSERT_FALSE(written);
      EXPECT_THAT(in_words(written.error()), HasSubstr(path_.string() + ": File too large"));
    }
    EXPECT_EQ(content(), all.substr(0, all.rfind('\n', bytes - 1) + 1)) << bytes;
    EXPECT_EQ(file.rows(), lines_in(content()) - 2) << bytes;
  }
}

TEST_F(FullDisk, WithoutRoomForOneLineNoFileIsLeft) {
  const SmallDisk disk(3);
  RecordingFile file;
  ASSERT_TRUE(file.open(path_));
  EXPECT_FALSE(file.begin({"test"}, {"Time (s)", "Value"}));
  file.drop_if_empty();
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(FullDisk, OnlyWhatIsInTheFileIsCounted) {
  const SmallDisk disk(1024);
  Recorder recorder(std::make_unique<Logger>(1000), {path_, {}});
  ASSERT_TRUE(recorder.start());
  for (int i = 0; i < 5000 && recorder.status().running; ++i) ::usleep(1000);
  const RecorderStatus status = recorder.status();
  recorder.stop();
  EXPECT_FALSE(status.running);
  EXPECT_THAT(in_words(status.failure), HasSubstr("File too large"));
  const std::size_t kept = lines_in(content()) - 1;
  ASSERT_GT(kept, 10u);
  EXPECT_EQ(status.samples, kept);
  EXPECT_EQ(status.end, static_cast<double>(kept - 1) / 8);
  EXPECT_NEAR(status.rate, 8, 1e-9);
  EXPECT_EQ(status.last, std::vector{0.1234567891 + static_cast<double>(kept - 1)});
  EXPECT_EQ(recorder.rows_since(0).size(), kept);
  EXPECT_EQ(recorder.rows_since(kept + 5).size(), 0u);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
