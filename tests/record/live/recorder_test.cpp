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

}  // namespace
}  // namespace cromer
