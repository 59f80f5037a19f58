#include "cromer/live/recorder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <new>
#include <thread>

#include "cromer/documents/words/words.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace CROMER_FILE {

namespace fs = std::filesystem;

/// Sends nothing and takes its time.
class Silent final : public Source {
 public:
  Result<void> open() override { return {}; }
  bool receive(double, SampleRows&, std::vector<Remark>&) override {
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
  bool receive(double, SampleRows& rows, std::vector<Remark>&) override {
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
  bool receive(double, SampleRows& rows, std::vector<Remark>&) override {
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
  EXPECT_NE(in_words(fast[0].what).find("--time-unit ms"), std::string::npos) << in_words(fast[0].what);
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
    EXPECT_EQ(notices[0].kind, RemarkKind::option);
    EXPECT_EQ(in_words(notices[0].what),
              "--column \"" + std::string(bad) +
                  "\": there is no such column to be fitted live, only \"Position (mm)\", "
                  "\"Velocity (mm/s)\"");
  }
}

/// Sends what it is given, a portion at a time, and ends.
class Portions final : public Source {
 public:
  Portions(std::vector<SampleRows> portions, std::vector<Remark> notices = {})
      : portions_(std::move(portions)), notices_(std::move(notices)) {}
  Result<void> open() override { return {}; }
  bool receive(double, SampleRows& rows, std::vector<Remark>& notices) override {
    rows = portions_[n_++];
    notices = std::exchange(notices_, {});
    return n_ < portions_.size();
  }
  const Headings& headings() const override { return headings_; }
  SampleTimes times() const override { return {TimesBy::count}; }

 private:
  std::vector<SampleRows> portions_;
  std::vector<Remark> notices_;
  std::size_t n_ = 0;
  Headings headings_{"Time (s)", "Value"};
};

SampleRows rows_at(const std::vector<double>& times) {
  SampleRows rows;
  rows.width = 1;
  for (const double t : times) rows.add(t, std::vector{10 * t});
  return rows;
}

/// A recording that has ended, and its file.
struct Recorded {
  explicit Recorded(std::unique_ptr<Source> source, std::optional<double> duration = {},
                    std::vector<std::string> comments = {})
      : path(fs::temp_directory_path() / ("cromer-portions-" + std::to_string(::getpid()) + ".csv")),
        recorder(std::move(source), {path, duration, std::move(comments), "",
                                     [](const Notice& notice) { return in_words(notice); }}) {
    fs::remove(path);
    started = recorder.start();
    while (recorder.status().running) ::usleep(500);
    recorder.stop();
    content = bytes_of(path);
  }
  ~Recorded() { fs::remove(path); }

  std::string path, content;
  Recorder recorder;
  Result<void> started;
};

TEST(Recorder, WritesHeadRowsAndWhatWasNoticed) {
  const Recorded recorded(
      std::make_unique<Portions>(std::vector{rows_at({0.5, 1}), rows_at({}), rows_at({1.5})},
                                 std::vector<Remark>{{RemarkKind::garbage, Notice{"a"}},
                                                     {RemarkKind::clock, Notice{"b"}},
                                                     {RemarkKind::garbage, Notice{"c"}}}),
      {}, {"head"});
  EXPECT_EQ(recorded.content,
            "# head\nTime (s),Value\n0.5,5\n1,10\n1.5,15\n# a\n# b\n# c\n# times: counted, at the rate of "
            "--rate\n# 2 lines were no samples\n");
  const RecorderStatus status = recorded.recorder.status();
  EXPECT_EQ(status.samples, 3u);
  EXPECT_EQ(status.begin, 0.5);
  EXPECT_EQ(status.end, 1.5);
  EXPECT_EQ(status.rate, 2);
  EXPECT_EQ(status.last, std::vector{15.0});
  EXPECT_EQ(status.garbage, 2u);
  EXPECT_EQ(status.notices, 3u);
  EXPECT_EQ(status.times.by, TimesBy::count);
  EXPECT_TRUE(status.failure.empty());
  EXPECT_EQ(recorded.recorder.headings(), (Headings{"Time (s)", "Value"}));
}

TEST(Recorder, ShowsPartsOfWhatItHas) {
  const Recorded recorded(std::make_unique<Portions>(
      std::vector{rows_at({1, 2, 3, 4, 5})},
      std::vector<Remark>{{RemarkKind::gap, Notice{"a"}}, {RemarkKind::gap, Notice{"b"}}}));
  const Recorder& recorder = recorded.recorder;
  EXPECT_EQ(recorder.rows_since(0, 2).t, (std::vector<double>{1, 2}));
  EXPECT_EQ(recorder.rows_since(3).t, (std::vector<double>{4, 5}));
  EXPECT_EQ(recorder.rows_since(3, 1).values, (std::vector<double>{40}));
  EXPECT_EQ(recorder.rows_since(5).size(), 0u);
  EXPECT_EQ(recorder.rows_since(9, 2).size(), 0u);
  EXPECT_EQ(recorder.first_within(2), 2u);
  EXPECT_EQ(recorder.first_within(1.5), 3u);
  EXPECT_EQ(recorder.first_within(100), 0u);
  EXPECT_EQ(recorder.notices_since(1).size(), 1u);
  EXPECT_EQ(in_words(recorder.notices_since(1)[0].what), "b");
  EXPECT_EQ(recorder.notices_since(7).size(), 0u);
}

TEST(Recorder, ARecordingOfNothingLeavesNoFile) {
  const Recorded recorded(std::make_unique<Portions>(
      std::vector{rows_at({})}, std::vector<Remark>{{RemarkKind::garbage, Notice{"a"}}}));
  EXPECT_FALSE(fs::exists(recorded.path));
  EXPECT_EQ(recorded.recorder.first_within(1), 0u);
  EXPECT_EQ(recorded.recorder.status().samples, 0u);
  EXPECT_EQ(recorded.recorder.status().rate, 0);
  EXPECT_EQ(Recorded(std::make_unique<Portions>(std::vector{rows_at({3})})).recorder.status().rate, 0);
}

TEST(Recorder, TheDurationIsCountedFromTheFirstSample) {
  const auto times = [](std::vector<SampleRows> portions, double duration) {
    return Recorded(std::make_unique<Portions>(std::move(portions)), duration).recorder.rows_since(0).t;
  };
  EXPECT_EQ(times({rows_at({5, 5.5, 6, 6.5}), rows_at({7})}, 1), (std::vector<double>{5, 5.5, 6}));
  EXPECT_EQ(times({rows_at({5, 5.5}), rows_at({6, 6.5}), rows_at({7})}, 1), (std::vector<double>{5, 5.5, 6}));
  EXPECT_EQ(times({rows_at({5}), rows_at({6}), rows_at({6})}, 1), (std::vector<double>{5, 6, 6}));
  EXPECT_EQ(times({rows_at({5}), rows_at({6.5}), rows_at({7})}, 2), (std::vector<double>{5, 6.5, 7}));
  const Recorded cut(std::make_unique<Portions>(std::vector{rows_at({0, 1, 2})}), 1);
  EXPECT_EQ(cut.content.substr(0, 24), "Time (s),Value\n0,0\n1,10\n");
}

TEST(Recorder, ADurationWithoutSamplesEndsTwoSecondsLater) {
  const auto begun = std::chrono::steady_clock::now();
  const Recorded silent(std::make_unique<Silent>(), 0.2);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
  EXPECT_GE(took.count(), 2.2);
  EXPECT_LT(took.count(), 3.1);
}

TEST(Recorder, ManyRowsAndNoticesAreBroughtToTheDisk) {
  for (const std::size_t count : {9999u, 10000u, 25000u}) {
    std::vector<double> times;
    for (std::size_t i = 0; i < count; ++i) times.push_back(static_cast<double>(i));
    const Recorded recorded(std::make_unique<Portions>(std::vector{rows_at(times)}));
    EXPECT_EQ(std::count(recorded.content.begin(), recorded.content.end(), '\n'),
              static_cast<std::ptrdiff_t>(count) + 2);
  }
  const Recorded garbled(std::make_unique<Portions>(
      std::vector{rows_at({1})}, std::vector<Remark>(250, {RemarkKind::garbage, Notice{"a"}})));
  EXPECT_EQ(garbled.recorder.notices_since(0).size(), 200u);
  EXPECT_EQ(garbled.recorder.status().garbage, 250u);
  EXPECT_NE(garbled.content.find("# 250 lines were no samples\n"), std::string::npos);
}

TEST(Recorder, OutOfMemoryItGoesOnAndSaysSo) {
  class Starving final : public Source {
   public:
    Result<void> open() override { return {}; }
    bool receive(double, SampleRows& rows, std::vector<Remark>&) override {
      if (n_++ == 1) throw std::bad_alloc();
      rows = rows_at({static_cast<double>(n_)});
      return n_ < 3;
    }
    const Headings& headings() const override { return headings_; }
    Headings headings_{"Time (s)", "Value"};
    int n_ = 0;
  };
  const Recorded recorded(std::make_unique<Starving>());
  EXPECT_EQ(recorded.content,
            "Time (s),Value\n1,10\n3,30\n# this computer ran out of memory: samples may be missing\n");
}

TEST(Recorder, OutOfMemoryAtItsEndItKeepsWhatWasRead) {
  /// Of a row, with another one held back; memory runs out where it is finished, or where that is published.
  class Starving final : public Source {
   public:
    explicit Starving(bool finishes) : finishes_(finishes) {}
    Result<void> open() override { return {}; }
    bool receive(double, SampleRows& rows, std::vector<Remark>&) override {
      rows = rows_at({1});
      return false;
    }
    void finish(SampleRows& rows, std::vector<Remark>&) override {
      if (!finishes_) throw std::bad_alloc();
      rows = rows_at({2});
    }
    const Headings& headings() const override { return headings_; }
    SampleTimes times() const override {
      if (finishes_ && ++published_ == 2) throw std::bad_alloc();
      return {TimesBy::count};
    }

   private:
    bool finishes_;
    mutable int published_ = 0;
    Headings headings_{"Time (s)", "Value"};
  };
  const std::string times = "# times: counted, at the rate of --rate\n";
  EXPECT_EQ(Recorded(std::make_unique<Starving>(false)).content,
            "Time (s),Value\n1,10\n# this computer ran out of memory: samples may be missing\n" + times);
  EXPECT_EQ(Recorded(std::make_unique<Starving>(true)).content, "Time (s),Value\n1,10\n2,20\n" + times);
}

TEST(Recorder, WhereTheSourceCannotBeOpenedNoFileIsLeft) {
  class Closed final : public Source {
   public:
    Result<void> open() override { return Error{"not there"}; }
    bool receive(double, SampleRows&, std::vector<Remark>&) override { return false; }
    const Headings& headings() const override { return headings_; }
    Headings headings_{};
  };
  const Recorded recorded(std::make_unique<Closed>());
  ASSERT_FALSE(recorded.started);
  EXPECT_EQ(in_words(recorded.started.error()), "not there");
  EXPECT_FALSE(fs::exists(recorded.path));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
