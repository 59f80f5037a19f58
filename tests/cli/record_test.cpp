// cromer record from pipes, a serial line and a phone: nothing is lost, whatever happens.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <sstream>

#include "live_devices.h"
#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::HasSubstr;

struct Sample {
  double t, x;
};

/// The rows of a recording, as another program would read them; a row that is not whole fails.
std::vector<Sample> samples_in(const std::string& text) {
  std::vector<Sample> samples;
  EXPECT_TRUE(text.empty() || text.back() == '\n');
  std::istringstream lines(text);
  bool headed = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    if (!headed) {
      EXPECT_THAT(line, HasSubstr("Time (s),"));
      headed = true;
      continue;
    }
    Sample sample{};
    char more = 0;
    EXPECT_EQ(std::sscanf(line.c_str(), "%lf,%lf%c", &sample.t, &sample.x, &more), 2) << line;
    samples.push_back(sample);
  }
  return samples;
}

std::string timed_line(int, double t) {
  char line[64];
  std::snprintf(line, sizeof line, "%.6f %.9f\n", t, swing(t));
  return line;
}

std::string value_line(int, double t) { return std::to_string(swing(t)) + "\n"; }

/// Waits until the file holds at least so many bytes.
bool wait_for(const Folder& folder, const std::string& name, std::size_t bytes) {
  for (int i = 0; i < 500; ++i) {
    if (folder.has(name) && folder.read(name).size() >= bytes) return true;
    sleep_until(now() + 0.01);
  }
  return false;
}

/// Started, and its line open: what is written from then on arrives.
pid_t start_recording(const Folder& folder, const std::vector<std::string>& arguments) {
  const pid_t process = folder.start(arguments);
  wait_for_handler(process, SIGINT);
  for (int i = 0; i < 500 && !folder.has("out.csv"); ++i) sleep_until(now() + 0.01);
  sleep_until(now() + 0.2);
  return process;
}

class Serial : public ::testing::TestWithParam<double> {};

TEST_P(Serial, LosesNoSampleAndKeepsTheDevicesTimes) {
  const double rate = GetParam();
  const Folder folder;
  const SerialLine serial;
  const pid_t process = start_recording(folder, {"record", "--from", "serial:" + serial.path(), "--heading",
                                                 "Position (m)", "-o", "out.csv", "--json"});
  write_by_the_clock(serial, rate, 3, timed_line);
  sleep_until(now() + 0.3);
  kill(process, SIGINT);
  const Finished end = folder.wait(process);
  ASSERT_EQ(end.status, 0) << end.err;
  const auto samples = samples_in(folder.read("out.csv"));
  ASSERT_EQ(samples.size(), static_cast<std::size_t>(3 * rate));
  for (std::size_t n = 0; n < samples.size(); ++n) {
    ASSERT_NEAR(samples[n].t, static_cast<double>(n) / rate, 1e-6);
    ASSERT_NEAR(samples[n].x, swing(samples[n].t), 1e-6);
  }
  EXPECT_EQ(end.json()["samples"], samples.size());
  EXPECT_NEAR(end.json()["rate"].get<double>(), rate, 1e-3 * rate);
  EXPECT_TRUE(end.json()["notices"].empty()) << end.out;

  const Finished fit = folder.run({"fit", "out.csv", "--law", "viscous", "--json"});
  ASSERT_EQ(fit.status, 0) << fit.err;
  const double frequency = fit.json()["derived"]["frequency"]["value"];
  EXPECT_NEAR(frequency, swing_frequency, 1e-3 * swing_frequency);
}

INSTANTIATE_TEST_SUITE_P(Rates, Serial, ::testing::Values(100.0, 1000.0));

class SerialValues : public ::testing::TestWithParam<double> {};

TEST_P(SerialValues, AreStampedByTheRateThatIsFound) {
  const double rate = GetParam();
  const Folder folder;
  const SerialLine serial;
  const pid_t process = start_recording(
      folder, {"record", "--from", "serial:" + serial.path() + ":9600", "-o", "out.csv", "--json"});
  write_by_the_clock(serial, rate, 4, value_line);
  sleep_until(now() + 0.1);  // what is still held back is written at the end
  kill(process, SIGINT);
  const Finished end = folder.wait(process);
  ASSERT_EQ(end.status, 0) << end.err;
  const auto samples = samples_in(folder.read("out.csv"));
  ASSERT_EQ(samples.size(), static_cast<std::size_t>(4 * rate));
  // Whatever the machine is busy with; the offset of the first is unknown.
  std::vector<double> off;
  for (std::size_t n = 0; n < samples.size(); ++n)
    off.push_back(samples[n].t - static_cast<double>(n) / rate);
  std::sort(off.begin(), off.end());
  const double middle = off[off.size() / 2];
  EXPECT_LT(off[off.size() * 98 / 100] - middle, 1e-3);
  EXPECT_LT(middle - off[off.size() * 2 / 100], 1e-3);
  EXPECT_EQ(end.json()["times"]["by"], "rate") << end.out;
  EXPECT_NEAR(end.json()["times"]["rate"].get<double>(), rate, 1e-3 * rate);
  EXPECT_THAT(folder.read("out.csv"), HasSubstr("# times: by the steady rate that was found, "));
}

INSTANTIATE_TEST_SUITE_P(Rates, SerialValues, ::testing::Values(100.0, 1000.0));

TEST(RecordSerial, AKnownRateCounts) {
  const Folder folder;
  const SerialLine serial;
  const pid_t process = start_recording(folder, {"record", "--from", "serial:" + serial.path(), "--rate",
                                                 "100", "--for", "1 s", "-o", "out.csv"});
  serial.write("\n");
  write_by_the_clock(serial, 100, 2, value_line);
  ASSERT_EQ(folder.wait(process).status, 0);
  const auto samples = samples_in(folder.read("out.csv"));
  ASSERT_EQ(samples.size(), 101u);
  for (std::size_t n = 0; n < samples.size(); ++n) EXPECT_EQ(samples[n].t, static_cast<double>(n) / 100);
}

TEST(RecordSerial, ADeviceThatWasUnpluggedIsFoundAgain) {
  const Folder folder;
  SerialLine serial;
  const pid_t process =
      start_recording(folder, {"record", "--from", "serial:" + serial.path(), "-o", "out.csv"});
  serial.write("\n");
  write_by_the_clock(serial, 100, 0.5, timed_line);
  sleep_until(now() + 0.2);
  serial.write("0.5");  // the line breaks off within a number
  sleep_until(now() + 0.1);
  serial.unplug();
  sleep_until(now() + 0.5);
  serial.plug_in_again();
  sleep_until(now() + 0.5);
  // It was reset meanwhile: its clock begins at 0.
  serial.write("00 7\n");
  write_by_the_clock(serial, 100, 0.5, timed_line);
  sleep_until(now() + 0.3);
  kill(process, SIGINT);
  const Finished end = folder.wait(process);
  ASSERT_EQ(end.status, 0) << end.err;
  const auto samples = samples_in(folder.read("out.csv"));
  EXPECT_EQ(samples.size(), 100u);
  for (std::size_t n = 1; n < samples.size(); ++n) EXPECT_GT(samples[n].t, samples[n - 1].t);
  EXPECT_GT(samples.back().t, 1.5);  // with the time that it was away
  EXPECT_THAT(end.err, HasSubstr("is gone"));
  EXPECT_THAT(end.err, HasSubstr("is back after"));
  EXPECT_THAT(end.err, HasSubstr("clock jumped back"));
  EXPECT_THAT(folder.read("out.csv"), HasSubstr("# " + serial.path() + " is gone"));
  EXPECT_EQ(folder.run({"inspect", "out.csv"}).status, 0);
}

TEST(RecordSerial, KilledItLeavesAValidFileWithAllThatCame) {
  const Folder folder;
  const SerialLine serial;
  const pid_t process =
      start_recording(folder, {"record", "--from", "serial:" + serial.path(), "-o", "out.csv"});
  serial.write("\n");
  write_by_the_clock(serial, 1000, 2, timed_line);
  sleep_until(now() + 1);
  kill(process, SIGKILL);
  EXPECT_EQ(folder.wait(process).status, -SIGKILL);
  EXPECT_EQ(samples_in(folder.read("out.csv")).size(), 2000u);
  const Finished fit = folder.run({"fit", "out.csv", "--law", "viscous", "--json"});
  EXPECT_EQ(fit.status, 0) << fit.err;
  EXPECT_EQ(fit.json()["recording"]["samples"], 2000);
}

// What is held back to be stamped is little: all that came up to a second before is there.
TEST(RecordSerial, KilledItHasTheValuesThatCameUpToASecondBefore) {
  const Folder folder;
  const SerialLine serial;
  const pid_t process =
      start_recording(folder, {"record", "--from", "serial:" + serial.path(), "-o", "out.csv"});
  serial.write("\n");
  write_by_the_clock(serial, 100, 2, value_line);
  sleep_until(now() + 1);
  kill(process, SIGKILL);
  EXPECT_EQ(folder.wait(process).status, -SIGKILL);
  EXPECT_EQ(samples_in(folder.read("out.csv")).size(), 200u);
}

TEST(RecordPhone, LosesNoSampleAndStartsThePhonePolitely) {
  for (const double rate : {100.0, 1000.0}) {
    const Folder folder;
    Phone phone(rate, false);
    const Finished end = folder.run({"record", "--from", "phyphox:127.0.0.1:" + std::to_string(phone.port()),
                                     "--for", "3 s", "-o", "out.csv", "--json"});
    ASSERT_EQ(end.status, 0) << end.err;
    EXPECT_TRUE(phone.started_by_us());
    EXPECT_THAT(end.err, HasSubstr("the phone was not measuring; its experiment \"Swing\" was started"));
    EXPECT_EQ(end.json()["columns"][1], "Position (m)");
    const auto samples = samples_in(folder.read("out.csv"));
    ASSERT_EQ(samples.size(), static_cast<std::size_t>(3 * rate) + 1);
    for (std::size_t n = 0; n < samples.size(); ++n) {
      ASSERT_NEAR(samples[n].t, static_cast<double>(n) / rate, 1e-8);
      ASSERT_NEAR(samples[n].x, swing(samples[n].t), 1e-8);
    }
    EXPECT_EQ(folder.run({"fit", "out.csv", "--law", "viscous"}).status, 0);
  }
}

TEST(RecordPhone, OneThatMeasuresIsLeftAloneAndOneThatGoesAwayLosesNothing) {
  const Folder folder;
  Phone phone(100, true);
  sleep_until(now() + 0.5);
  const pid_t process = folder.start({"record", "--from", "phyphox:127.0.0.1:" + std::to_string(phone.port()),
                                      "--for", "4 s", "-o", "out.csv"});
  ASSERT_TRUE(wait_for(folder, "out.csv", 200));
  phone.go_away(1);
  const Finished end = folder.wait(process);
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_FALSE(phone.started_by_us());
  EXPECT_THAT(end.err, HasSubstr("is back after"));
  const auto samples = samples_in(folder.read("out.csv"));
  ASSERT_EQ(samples.size(), 401u);
  EXPECT_GT(samples.front().t, 0.45);  // not what it had measured before
  for (std::size_t n = 1; n < samples.size(); ++n) EXPECT_NEAR(samples[n].t - samples[n - 1].t, 0.01, 1e-8);
}

TEST(RecordPhone, OneThatIsClearedGoesOn) {
  const Folder folder;
  Phone phone(100, true);
  const pid_t process = folder.start(
      {"record", "--from", "phyphox:127.0.0.1:" + std::to_string(phone.port()), "-o", "out.csv"});
  ASSERT_TRUE(wait_for(folder, "out.csv", 200));
  sleep_until(now() + 2);
  phone.clear();
  sleep_until(now() + 2);
  kill(process, SIGINT);
  const Finished end = folder.wait(process);
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_THAT(end.err, HasSubstr("the phone's data were cleared"));
  const auto samples = samples_in(folder.read("out.csv"));
  ASSERT_GT(samples.size(), 300u);
  for (std::size_t n = 1; n < samples.size(); ++n) EXPECT_GT(samples[n].t, samples[n - 1].t);
}

TEST(Record, OverwritesNothingAndNamesWhatIsWrong) {
  const Folder folder;
  folder.write("full.csv", "Time (s),x\n");
  const auto refused = [&](std::vector<std::string> arguments, const std::string& why) {
    arguments.insert(arguments.begin(), "record");
    const Finished end = folder.run(arguments);
    EXPECT_EQ(end.status, 2) << why;
    EXPECT_THAT(end.err, HasSubstr(why));
  };
  refused({"--from", "-", "-o", "full.csv"}, "full.csv exists and is not empty");
  refused({"-o", "new.csv"}, "needs --from");
  refused({"--from", "-"}, "-o FILE.csv is needed");
  refused({"--from", "-", "-o", "new.txt"}, "a recording is written as .csv");
  refused({"--from", "usb:3", "-o", "new.csv"}, "\"usb\" is no kind of source");
  refused({"--from", "serial:/dev/none", "-o", "new.csv"}, "No such file");
  refused({"--from", "serial:/dev/null", "-o", "new.csv"}, "that is no serial line");
  refused({"--from", "tcp:127.0.0.1:1", "-o", "new.csv"}, "refused");
  refused({"--from", "-", "--time-unit", "kg", "-o", "new.csv"}, "--time-unit \"kg\" is no unit of time");
  EXPECT_EQ(folder.read("full.csv"), "Time (s),x\n");
  EXPECT_FALSE(folder.has("new.csv"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
