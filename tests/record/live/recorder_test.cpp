#include "cromer/record/live/recorder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <thread>

namespace cromer {
namespace {

namespace fs = std::filesystem;

/// Sends nothing and takes its time.
class Silent final : public Source {
 public:
  Result<void> open() override { return {}; }
  bool receive(double, Rows&, std::vector<Notice>&) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return true;
  }
  const Headings& headings() const override { return headings_; }

 private:
  Headings headings_;
};

/// Sends one row of a position and a velocity, and ends.
class Short final : public Source {
 public:
  Result<void> open() override { return {}; }
  bool receive(double, Rows& rows, std::vector<Notice>&) override {
    rows.width = 2;
    rows.add(0, std::vector{1.0, 2.0});
    return false;
  }
  const Headings& headings() const override { return headings_; }

 private:
  Headings headings_{"Time (s)", "Position (mm)", "Velocity (mm/s)"};
};

/// A device whose milliseconds are taken for seconds, or one that is true to time: a row each 20 ms.
class Device final : public Source {
 public:
  explicit Device(double step) : step_(step) {}
  Result<void> open() override { return {}; }
  bool receive(double, Rows& rows, std::vector<Notice>&) override {
    ::usleep(20000);
    rows.width = 1;
    rows.add(step_ * n_++, std::vector{1.0});
    return true;
  }
  const Headings& headings() const override { return headings_; }

 private:
  double step_;
  int n_ = 0;
  Headings headings_{"Time (s)", "Value"};
};

TEST(Recorder, TimesThatPassFarTooFastAreNoticed) {
  const auto notices = [](double step, double duration) {
    const std::string path =
        fs::temp_directory_path() / ("cromer-fast-" + std::to_string(::getpid()) + ".csv");
    Recorder recorder(std::make_unique<Device>(step), {.path = path, .duration = duration});
    EXPECT_TRUE(recorder.start());
    while (recorder.status().running) ::usleep(1000);
    fs::remove(path);
    return recorder.notices_since(0);
  };
  const auto fast = notices(20, 4);
  ASSERT_EQ(fast.size(), 1u);
  EXPECT_NE(fast[0].text.find("--time-unit ms"), std::string::npos) << fast[0].text;
  EXPECT_TRUE(notices(0.02, 0.1).empty());
}

// As where Ctrl-C ends the server while the page asks for the end.
TEST(Recorder, IsStoppedByManyAtTheSameTime) {
  const fs::path path = fs::temp_directory_path() / ("cromer-many-" + std::to_string(::getpid()) + ".csv");
  for (int i = 0; i < 10; ++i) {
    Recorder recorder(std::make_unique<Silent>(), {path, {}});
    ASSERT_TRUE(recorder.start());
    std::vector<std::thread> many;
    for (int n = 0; n < 4; ++n)
      many.emplace_back([&] {
        recorder.stop();
        EXPECT_FALSE(recorder.status().running);
      });
    for (auto& each : many) each.join();
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(Recorder, AColumnThatIsNotThereIsNoticedWithThoseThatAre) {
  const auto noticed = [](const std::string& column) {
    const std::string path =
        fs::temp_directory_path() / ("cromer-column-" + std::to_string(::getpid()) + ".csv");
    Recorder recorder(std::make_unique<Short>(), {path, {}, {}, column});
    EXPECT_TRUE(recorder.start());
    while (recorder.status().running) ::usleep(1000);
    fs::remove(path);
    return recorder.notices_since(0);
  };
  for (const char* good : {"", "Position", "Velocity (mm/s)"}) EXPECT_TRUE(noticed(good).empty()) << good;
  for (const char* bad : {"Postion", "Time (s)"}) {
    const auto notices = noticed(bad);
    ASSERT_EQ(notices.size(), 1u) << bad;
    EXPECT_EQ(notices[0].kind, NoticeKind::option);
    EXPECT_EQ(notices[0].text, "--column \"" + std::string(bad) +
                                   "\": there is no such column to be fitted live, only \"Position (mm)\", "
                                   "\"Velocity (mm/s)\"");
  }
}

}  // namespace
}  // namespace cromer
