// cromer spectrum as a user meets it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <string>
#include <thread>

#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string shaking(int samples, double step, double size = 0.1, const std::string& heading = "acc (g)") {
  std::string bytes = "Time (s)," + heading + "\n";
  for (int i = 0; i < samples; ++i)
    bytes += std::to_string(i * step) + "," + std::to_string(size * std::sin(0.2 * i)) + "\n";
  return bytes;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(Spectrum, CsvHasTheColumnsPromised) {
  const Folder folder;
  folder.write("quake.csv", shaking(300, 0.01));
  const Finished end = folder.run({"spectrum", "quake.csv", "--periods", "1,0.1", "--damping-ratio", "0.02",
                                   "--damping-ratio", "5 %", "-o", "-"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto lines = lines_of(end.out);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0], "period (s),damping_ratio,SD (m),PSV (m/s),PSA (m/s²)");
  EXPECT_THAT(lines[1], StartsWith("1,0.02,"));
  EXPECT_THAT(lines[2], StartsWith("0.1,0.02,"));
  EXPECT_THAT(lines[3], StartsWith("1,0.05,"));
}

TEST(Spectrum, JsonHasTheFieldsPromised) {
  const Folder folder;
  folder.write("quake.csv", shaking(300, 0.01));
  const Finished end = folder.run({"spectrum", "quake.csv", "--periods", "0.1:1:4:log", "--json", "--in-g"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto document = end.json();
  const auto spectrum = document["spectra"][0];
  EXPECT_EQ(spectrum["damping_ratio"], 0.05);
  ASSERT_EQ(spectrum["period"].size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const double w = 2 * M_PI / spectrum["period"][i].get<double>(), sd = spectrum["SD"][i].get<double>();
    EXPECT_NEAR(spectrum["PSV"][i].get<double>(), w * sd, 1e-12 * w * sd);
    EXPECT_NEAR(spectrum["PSA"][i].get<double>() * 9.80665, w * w * sd, 1e-12 * w * w * sd);
  }
  EXPECT_GT(document["arias_intensity"].get<double>(), 0);
  EXPECT_GT(document["duration_5_95"].get<double>(), 2);
  EXPECT_EQ(document["peaks"], "continuous");
}

TEST(Spectrum, OfTwoComponents) {
  const Folder folder;
  folder.write("h1.csv", shaking(300, 0.01));
  folder.write("h2.csv", shaking(300, 0.01, 0.2));
  const Finished end =
      folder.run({"spectrum", "h1.csv", "h2.csv", "--periods", "0.5", "--json", "-o", "s.csv"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto spectrum = end.json()["spectra"][0];
  const double first = spectrum["components"][0]["PSA"][0], second = spectrum["components"][1]["PSA"][0];
  EXPECT_NEAR(second / first, 2, 1e-4);
  EXPECT_NEAR(spectrum["geometric_mean"]["PSA"][0].get<double>(), std::sqrt(first * second), 1e-9);
  EXPECT_NEAR(spectrum["rotd100"]["PSA"][0].get<double>(), std::hypot(first, second), 5e-5 * second);
  EXPECT_LT(spectrum["rotd50"]["PSA"][0], spectrum["rotd100"]["PSA"][0]);
  EXPECT_EQ(end.json()["arias_intensity"].size(), 2u);
  EXPECT_EQ(lines_of(folder.read("s.csv"))[0],
            "period (s),damping_ratio,SD 1 (m),PSV 1 (m/s),PSA 1 (m/s²),SD 2 (m),PSV 2 (m/s),PSA 2 (m/s²),"
            "SD geometric mean (m),PSV geometric mean (m/s),PSA geometric mean (m/s²),"
            "SD RotD50 (m),PSV RotD50 (m/s),PSA RotD50 (m/s²),"
            "SD RotD100 (m),PSV RotD100 (m/s),PSA RotD100 (m/s²)");
  // Two columns of one file are the same two components.
  std::string both = "Time (s),ax (g),ay (g)\n";
  for (int i = 0; i < 300; ++i) {
    const double a = std::stod(std::to_string(0.1 * std::sin(0.2 * i)));
    both += std::to_string(i * 0.01) + "," + std::to_string(a) + "," +
            std::to_string(std::stod(std::to_string(0.2 * std::sin(0.2 * i)))) + "\n";
  }
  folder.write("both.csv", both);
  const Finished one =
      folder.run({"spectrum", "both.csv", "--column", "ax", "--column", "ay", "--periods", "0.5", "--json"});
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(one.json()["spectra"], end.json()["spectra"]);
}

TEST(Spectrum, OfAFolderIsThatOfEachOfItsFiles) {
  const Folder folder;
  std::filesystem::create_directory(folder.path("records"));
  folder.write("records/a_1.csv", shaking(300, 0.01));
  folder.write("records/b.csv", shaking(200, 0.02, 0.2));
  folder.write("records/c.csv", "no numbers\n");
  folder.write("records/notes.md", "not a recording");
  const std::vector<std::string> what{"--periods", "0.1:2:5:log", "--damping-ratio", "2%,5%", "--in-g"};
  const auto run = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "spectrum");
    arguments.insert(arguments.end(), what.begin(), what.end());
    return folder.run(arguments);
  };
  const Finished all = run({"records", "-o", "all.csv", "--plot", "all.svg"});
  EXPECT_EQ(all.status, 1);
  EXPECT_THAT(all.err, HasSubstr("records/c.csv: no rows of numbers"));
  EXPECT_THAT(all.err, HasSubstr("records: 1 of 4 entries"));
  EXPECT_THAT(all.out, HasSubstr("2 of 3 motions"));
  std::vector<std::string> rows{"file,period (s),damping_ratio,SD (m),PSV (m/s),PSA (g)"};
  for (const std::string name : {"records/a_1.csv", "records/b.csv"}) {
    const auto alone = lines_of(run({name, "-o", "-"}).out);
    ASSERT_EQ(alone.size(), 11u);
    for (std::size_t i = 1; i < alone.size(); ++i) rows.push_back(name + "," + alone[i]);
  }
  EXPECT_EQ(lines_of(folder.read("all.csv")), rows);
  // The figure has the files' names, one panel for each damping ratio.
  const std::string figure = folder.read("all.svg");
  EXPECT_THAT(figure, HasSubstr(">a_1.csv<"));
  EXPECT_THAT(figure, HasSubstr(">b.csv<"));
  EXPECT_THAT(figure, HasSubstr("2 % damping"));
  EXPECT_THAT(figure, HasSubstr("5 % damping"));

  const auto document = run({"records", "--json"}).json();
  ASSERT_EQ(document["motions"].size(), 3u);
  EXPECT_EQ(document["message"], "1 of 3 motions did not succeed");
  auto alone = run({"records/a_1.csv", "--json"}).json();
  alone["files"] = {"records/a_1.csv"};
  EXPECT_EQ(document["motions"][0], alone);
  EXPECT_EQ(document["motions"][2]["files"][0], "records/c.csv");
  EXPECT_THAT(document["motions"][2]["message"].get<std::string>(), HasSubstr("no rows of numbers"));
  EXPECT_FALSE(document["motions"][2].contains("spectra"));
  std::filesystem::remove(folder.path("records/c.csv"));
  const auto good = run({"records", "--json"}).json();
  EXPECT_EQ(good["motions"].size(), 2u);
  EXPECT_FALSE(good.contains("message"));
}

TEST(Spectrum, OfPairsIsThatOfEachPair) {
  const Folder folder;
  folder.write("x_1.csv", shaking(300, 0.01));
  folder.write("x_2.csv", shaking(300, 0.01, 0.2));
  folder.write("y_1.csv", shaking(250, 0.02));
  folder.write("y_2.csv", shaking(250, 0.02, 0.3));
  const std::vector<std::string> four{"spectrum", "x_1.csv", "x_2.csv",   "y_1.csv",
                                      "y_2.csv",  "--json",  "--periods", "0.3,1"};
  auto in_pairs = four;
  in_pairs.insert(in_pairs.end(), {"--files", "pairs"});
  const auto pairs = folder.run(in_pairs).json()["motions"];
  ASSERT_EQ(pairs.size(), 2u);
  const auto second = folder.run({"spectrum", "y_1.csv", "y_2.csv", "--json", "--periods", "0.3,1"}).json();
  EXPECT_EQ(pairs[1]["spectra"], second["spectra"]);
  EXPECT_TRUE(pairs[1]["spectra"][0].contains("rotd50"));
  EXPECT_EQ(pairs[1]["files"], nlohmann::json({"y_1.csv", "y_2.csv"}));
  EXPECT_EQ(folder.run(four).json()["motions"].size(), 4u);
  in_pairs.erase(std::find(in_pairs.begin(), in_pairs.end(), "--json"));
  EXPECT_THAT(folder.run(in_pairs).out, HasSubstr("y_1.csv + y_2.csv "));
  // Exactly two files are one motion unless they are told apart.
  const auto apart =
      folder.run({"spectrum", "x_1.csv", "x_2.csv", "--files", "each", "--json", "--periods", "0.3"}).json();
  ASSERT_EQ(apart["motions"].size(), 2u);
  EXPECT_EQ(apart["motions"][1]["spectra"],
            folder.run({"spectrum", "x_2.csv", "--json", "--periods", "0.3"}).json()["spectra"]);
}

TEST(Spectrum, WhatIsSaidOfManyMotionsIsSaidOnce) {
  const Folder folder;
  std::vector<std::string> arguments{"spectrum", "--periods", "0.015,1"};
  for (const std::string name : {"a.csv", "b.csv", "c.csv"}) {
    folder.write(name, shaking(300, 0.01, 0.1, "shaking"));
    arguments.push_back(name);
  }
  const std::string said = folder.run(arguments).err;
  EXPECT_THAT(
      said,
      HasSubstr(
          "a.csv: column \"shaking\" has no unit of acceleration and is taken as m/s^2; --unit names another "
          "(the like of 2 more of 3 motions)"));
  EXPECT_THAT(said, HasSubstr("a.csv: --periods: one period is below 0.02 s"));
  EXPECT_THAT(said, testing::Not(HasSubstr("b.csv")));
}

TEST(Spectrum, AnInterruptLeavesTheMotionsThatAreDone) {
  const Folder folder;
  std::vector<std::string> arguments{"spectrum", "--periods", "0.01:10:2000:log", "-o", "done.csv", "--json"};
  for (int i = 0; i < 400; ++i) {
    const std::string name = "r" + std::to_string(i) + ".csv";
    folder.write(name, shaking(2000, 0.01));
    arguments.push_back(name);
  }
  const pid_t process = folder.start(arguments);
  ASSERT_TRUE(wait_for_handler(process, SIGINT));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  kill(process, SIGINT);
  const Finished end = folder.wait(process);
  ASSERT_EQ(end.status, 1);
  EXPECT_THAT(
      end.err,
      ::testing::ContainsRegex(
          "interrupted; what follows are the spectra of [0-9]+ of 400 motions; missing: .*and [0-9]+ more"));
  const auto document = end.json();
  const auto motions = document["motions"];
  EXPECT_LT(motions.size(), 400u);
  EXPECT_EQ(document["missing"].size(), 400 - motions.size());
  EXPECT_EQ(document["missing"].back(), "r399.csv");
  // Where none was done there is no table.
  const std::size_t rows = lines_of(folder.read("done.csv")).size();
  EXPECT_EQ(rows, motions.empty() ? 0 : 1 + 2000 * motions.size());
}

TEST(Spectrum, OfAShock) {
  const Folder folder;
  std::string pulse = "Time (s),acc (g)\n";
  for (int i = 0; i <= 1000; ++i)
    pulse +=
        std::to_string(i * 1e-5) + "," + std::to_string(i < 500 ? 100 * std::sin(M_PI * i / 500) : 0) + "\n";
  folder.write("drop.csv", pulse);
  const Finished end = folder.run(
      {"spectrum", "drop.csv", "--shock", "--in-g", "--frequencies", "100,5000 Hz", "-o", "-", "--quiet"});
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_EQ(lines_of(end.out)[0],
            "period (s),damping_ratio,frequency (Hz),primary (g),residual (g),maximax (g),positive "
            "(g),negative (g)");
  // A stiff mass follows the base.
  const Finished stiff =
      folder.run({"spectrum", "drop.csv", "--shock", "--in-g", "--frequencies", "5000 Hz", "--json"});
  EXPECT_NEAR(stiff.json()["spectra"][0]["maximax"][0].get<double>(), 100, 0.5);
  const Finished by_itself = folder.run({"spectrum", "drop.csv", "--shock"});
  EXPECT_EQ(by_itself.status, 0) << by_itself.err;
}

TEST(Spectrum, SaysOnceWhatItTakesAColumnFor) {
  const Folder folder;
  folder.write("plain.csv", "time (s),shaking\n0,0\n0.01,1\n0.02,-1\n0.03,0\n");
  const Finished one = folder.run({"spectrum", "plain.csv", "--periods", "0.1"});
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_THAT(
      one.err,
      HasSubstr(
          "column \"shaking\" has no unit of acceleration and is taken as m/s^2; --unit names another"));
  EXPECT_THAT(one.err, testing::Not(HasSubstr("taken as they are")));
  EXPECT_EQ(
      folder.run({"spectrum", "plain.csv", "--periods", "0.025", "--unit", "g", "--peaks", "samples"}).err,
      "");
  const Finished twice = folder.run({"spectrum", "plain.csv", "plain.csv", "--periods", "0.1"});
  ASSERT_EQ(twice.status, 0) << twice.err;
  EXPECT_THAT(twice.err, HasSubstr("one component given twice"));
  EXPECT_EQ(twice.err.find("has no unit"), twice.err.rfind("has no unit"));
}

TEST(Spectrum, SaysTheIntensityOfAnySize) {
  const auto shaken = [](const std::string& size) {
    const Folder folder;
    folder.write("a.csv", "time (s),acc (m/s^2)\n0,0\n0.01,1e" + size + "\n0.02,-1e" + size + "\n0.03,0\n");
    return folder.run({"spectrum", "a.csv", "--periods", "0.1", "--peaks", "samples"});
  };
  // pi/(2 g) h 1e2n: of the three intervals two have 1/3, the crossing one 1/3 as well.
  EXPECT_THAT(shaken("0").out, HasSubstr("0.001602"));
  EXPECT_THAT(shaken("-100").out, HasSubstr("10⁻²⁰³"));
  EXPECT_THAT(shaken("-200").out, HasSubstr("about 10^-403"));
  EXPECT_THAT(shaken("-200").err, HasSubstr("about 10^-403 m/s, is below any number"));
  EXPECT_THAT(shaken("300").err, HasSubstr("1e+300 m/s^2 at sample 2: nothing shakes like that"));
}

TEST(Spectrum, ShowsFrequenciesToWhomeverAskedForThem) {
  const Folder folder;
  folder.write("quake.csv", shaking(300, 0.01));
  const std::vector<std::string> base{"spectrum", "quake.csv", "--plot", "figure.svg", "--quiet"};
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = base;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return folder.run(arguments);
  };
  const Finished by_frequency = run({"--frequencies", "0.5,2,4 Hz"});
  EXPECT_THAT(by_frequency.out, HasSubstr("frequency (Hz)  "));
  EXPECT_THAT(by_frequency.out, HasSubstr("\n         4.000  "));
  EXPECT_THAT(by_frequency.out, HasSubstr(" Hz\n"));
  EXPECT_THAT(folder.read("figure.svg"), HasSubstr("natural frequency (Hz)"));
  const Finished by_period = run({"--periods", "2,0.5,0.25"});
  EXPECT_THAT(by_period.out, HasSubstr("period (s)  "));
  EXPECT_THAT(folder.read("figure.svg"), testing::Not(HasSubstr("Hz")));
  const Finished shock = run({"--shock", "--periods", "2,0.5,0.25"});
  EXPECT_THAT(shock.out, HasSubstr("period (s)  "));
  EXPECT_THAT(folder.read("figure.svg"), testing::Not(HasSubstr("Hz")));
}

// Two components of a ground that goes to and fro in closed form: a = A sin w t, v = A/w (1 - cos w t).
TEST(Spectrum, SaysTheMeasuresOfTheGround) {
  const Folder folder;
  const auto swing = [](double size) {
    std::string bytes = "Time (s),acc (m/s^2)\n";
    for (int i = 0; i <= 4000; ++i) {
      char line[60];
      std::snprintf(line, sizeof line, "%.4f,%.12f\n", i * 5e-4, size * std::sin(M_PI * i * 5e-4));
      bytes += line;
    }
    return bytes;
  };
  folder.write("h1.csv", swing(2));
  folder.write("h2.csv", swing(0.5));
  const std::vector<std::string> two{"spectrum", "h1.csv", "h2.csv", "--periods", "1", "--json"};
  auto with_motion = two;
  with_motion.insert(with_motion.end(), {"--motion", "ground.csv", "--in-g"});
  const auto document = folder.run(two).json();
  for (std::size_t c = 0; c < 2; ++c) {
    const auto found = document["components"][c];
    const double size = c == 0 ? 2 : 0.5, w = M_PI;
    EXPECT_NEAR(found["peak_acceleration"].get<double>(), size, 1e-6);
    EXPECT_NEAR(found["peak_velocity"].get<double>(), 2 * size / w, 1e-6);
    EXPECT_NEAR(found["peak_displacement"].get<double>(), size * 2 / w, 1e-6);
    EXPECT_NEAR(found["cumulative_absolute_velocity"].get<double>(), 4 * size / w, 1e-6);
    const double edge = std::asin(0.05 * 9.80665 / size) / w;
    EXPECT_NEAR(found["duration_bracketed"].get<double>(), 2 - 2 * edge, c == 0 ? 1e-6 : 1e-5);
    // sin^2 summed from 0 to t is t/2 - sin(2 w t)/(4 w), 1 in all: 75 % where that is 0.75.
    const double from = found["from_5"], to = from + found["duration_5_75"].get<double>();
    EXPECT_NEAR(from / 2 - std::sin(2 * w * from) / (4 * w), 0.05, 1e-6);
    EXPECT_NEAR(to / 2 - std::sin(2 * w * to) / (4 * w), 0.75, 1e-6);
  }
  ASSERT_EQ(folder.run(with_motion).status, 0);
  const auto lines = lines_of(folder.read("ground.csv"));
  ASSERT_EQ(lines.size(), 4002u);
  EXPECT_EQ(lines[0],
            "t (s),acceleration 1 (g),velocity 1 (m/s),displacement 1 (m),acceleration 2 (g),"
            "velocity 2 (m/s),displacement 2 (m)");
  double t = 0, a = 0, v = 0, x = 0;
  ASSERT_EQ(std::sscanf(lines[2001].c_str(), "%lf,%lf,%lf,%lf", &t, &a, &v, &x), 4);
  EXPECT_EQ(t, 1);
  EXPECT_NEAR(v, 4 / M_PI, 1e-6);
  EXPECT_NEAR(x, 2 / M_PI, 1e-6);
  with_motion[with_motion.size() - 2] = "ground.txt";
  EXPECT_THAT(folder.run(with_motion).err, HasSubstr("--motion: ground.txt"));
  with_motion[with_motion.size() - 2] = "h1.csv";
  EXPECT_EQ(folder.run(with_motion).status, 2);
}

TEST(Spectrum, CorrectsARecordingAndSaysSo) {
  const Folder folder;
  std::string drifting = "Time (s),acc (m/s^2)\n";
  for (int i = 0; i <= 2000; ++i) {
    char line[60];
    std::snprintf(line, sizeof line, "%.2f,%.12f\n", i * 0.01, 0.02 + 0.003 * i * 0.01);
    drifting += line;
  }
  folder.write("line.csv", drifting);
  const std::vector<std::string> base{"spectrum", "line.csv", "--periods", "1"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), base.begin(), base.end());
    return folder.run(more);
  };
  EXPECT_THAT(with({}).err,
              HasSubstr("line.csv: the integrated velocity ends at 1 m/s, 100 % of its largest"));
  // A line is its own baseline: nothing is left of it.
  const Finished straight = with({"--baseline", "linear", "--json"});
  EXPECT_EQ(straight.err, "");
  EXPECT_EQ(straight.json()["correction"]["baseline"], "linear");
  EXPECT_TRUE(straight.json()["correction"]["band_pass"].is_null());
  EXPECT_NEAR(straight.json()["components"][0]["baseline"].get<double>(), 0.08, 1e-9);
  EXPECT_LT(straight.json()["components"][0]["peak_acceleration"].get<double>(), 1e-10);
  EXPECT_THAT(with({"--baseline", "constant"}).out, HasSubstr("corrected: constant baseline taken off\n"));
  const Finished filtered = with({"--baseline", "constant", "--band-pass", "0.2:20 Hz", "--band-pass-order",
                                  "2", "--plot", "s.svg", "--motion", "m.csv"});
  EXPECT_THAT(filtered.out, HasSubstr("corrected: constant baseline taken off; band-pass from 0.2 to 20 Hz, "
                                      "Butterworth of order 2, zero phase (forwards and backwards, -6 dB"));
  EXPECT_THAT(folder.read("s.svg"), HasSubstr("band-pass from 0.2 to 20 Hz"));
  EXPECT_THAT(lines_of(folder.read("m.csv"))[1], StartsWith("-"));  // the zeros before the recording
  const auto causal = with({"--band-pass", "0.2:", "--causal", "--json"}).json();
  EXPECT_EQ(causal["correction"]["band_pass"]["low"], 0.2);
  EXPECT_TRUE(causal["correction"]["band_pass"]["high"].is_null());
  EXPECT_EQ(causal["correction"]["band_pass"]["causal"], true);
  EXPECT_EQ(causal["components"][0]["begins"], 0);
  EXPECT_GT(causal["components"][0]["samples"], 2001);
  const auto refused = [&](std::vector<std::string> more, const char* why) {
    const Finished end = with(more);
    EXPECT_EQ(end.status, 2) << why;
    EXPECT_THAT(end.err, HasSubstr(why));
  };
  refused({"--baseline", "linar"}, "did you mean linear?");
  refused({"--band-pass", "25"}, "two corners with a colon");
  refused({"--band-pass", ":"}, "two corners with a colon");
  refused({"--band-pass", "25:0.1 Hz"}, "the second one the higher");
  refused({"--band-pass", "0:25 Hz"}, "must be positive");
  refused({"--band-pass", "1:50 Hz"}, "not below half the sampling rate, 50 Hz");
  refused({"--band-pass", "1e-7:20 Hz"}, "far slower than the recording");
  refused({"--band-pass", "1 s:2 s"}, "--band-pass");
  refused({"--band-pass-order", "3"}, "--band-pass-order says how --band-pass filters");
  refused({"--causal"}, "--causal says how --band-pass filters");
  refused({"--band-pass", "1:20 Hz", "--band-pass-order", "13"}, "between 1 and 12, not 13");
}

TEST(Spectrum, FourierAmplitudesGoToTheirFile) {
  const Folder folder;
  folder.write("quake.csv", shaking(300, 0.01));
  const Finished end = folder.run({"spectrum", "quake.csv", "--fourier", "fas.csv", "--quiet"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto lines = lines_of(folder.read("fas.csv"));
  EXPECT_EQ(lines[0], "frequency (Hz),amplitude (m/s)");
  EXPECT_EQ(lines.size(), 1u + 257);  // 512 padded
  EXPECT_EQ(folder.run({"spectrum", "quake.csv", "--fourier", "fas.txt"}).status, 2);
  EXPECT_EQ(folder.run({"spectrum", "quake.csv", "--fourier", "quake.csv"}).status, 2);
}

TEST(Spectrum, FiguresAreDrawn) {
  const Folder folder;
  folder.write("h1.csv", shaking(300, 0.01));
  folder.write("h2.csv", shaking(300, 0.01, 0.2));
  for (const std::vector<std::string>& more : {std::vector<std::string>{"h1.csv"},
                                               {"h1.csv", "h2.csv"},
                                               {"h1.csv", "--tripartite"},
                                               {"h1.csv", "h2.csv", "--tripartite", "--in-g"},
                                               {"h1.csv", "--shock"},
                                               {"h1.csv", "--periods", "1"},
                                               {"h1.csv", "--periods", "1", "--tripartite"}}) {
    std::vector<std::string> arguments{"spectrum", "--plot", "figure.svg", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished end = folder.run(arguments);
    ASSERT_EQ(end.status, 0) << end.err;
    EXPECT_THAT(folder.read("figure.svg"), HasSubstr("<svg"));
  }
}

TEST(Spectrum, FiguresSayEveryDampingRatio) {
  Folder folder;
  folder.write("h1.csv", shaking(400, 0.01));
  folder.write("h2.csv", shaking(400, 0.01, 0.05));
  const auto figure = [&](std::vector<std::string> more) {
    more.insert(more.begin(),
                {"spectrum", "h1.csv", "--plot", "figure.svg", "--quiet", "--periods", "0.05:2:20:log"});
    const Finished end = folder.run(more);
    EXPECT_EQ(end.status, 0) << end.err;
    return folder.read("figure.svg");
  };
  EXPECT_THAT(figure({"h2.csv"}), HasSubstr("pseudo-acceleration at 5 % damping (m/s²)"));
  EXPECT_THAT(figure({"h2.csv", "--tripartite"}), HasSubstr("pseudo-velocity at 5 % damping (m/s)"));
  EXPECT_THAT(figure({"--shock"}), HasSubstr("largest absolute acceleration at 5 % damping (m/s²)"));
  const std::vector<std::string> paper{"--shock", "--shock-response", "pseudo-velocity", "--tripartite"};
  const std::string shock = figure(paper);
  EXPECT_THAT(shock, HasSubstr("largest pseudo-velocity (m/s)"));
  EXPECT_THAT(shock, HasSubstr("Tripartite shock response spectrum"));
  for (const char* way : {"--in-g", "--tripartite"}) {
    const std::string both = figure({"h2.csv", "--damping-ratio", "2%,10%", way});
    EXPECT_THAT(both, HasSubstr("RotD50, 2 % damping")) << way;
    EXPECT_THAT(both, HasSubstr("RotD50, 10 % damping")) << way;
  }
}

TEST(Spectrum, IsATaskOfAStudy) {
  const Folder folder;
  folder.write("h1.csv", shaking(300, 0.01));
  folder.write("h2.csv", shaking(300, 0.01, 0.2));
  folder.write("s.toml",
               "[[task]]\nspectrum = \"one\"\nfile = \"h1.csv\"\nperiods = \"0.1:2:40:log\"\n"
               "damping_ratio = [\"0.02\", \"0.05\"]\n"
               "[[task]]\nspectrum = \"both\"\nfile = [\"h1.csv\", \"h2.csv\"]\nperiods = \"0.1,1\"\n"
               "[[task]]\nspectrum = \"shock\"\nfile = \"h1.csv\"\nshock = true\n"
               "[[figure]]\nid = \"figure-1\"\nx = \"period\"\ny = \"PSA\"\nx_logarithmic = true\n"
               "[[figure.curve]]\nof = \"one.1\"\nrole = \"family:0\"\n"
               "[[figure.curve]]\nof = \"one.2\"\nrole = \"family:2\"\n"
               "[[block]]\nfigure = \"figure-1\"\n[[block]]\ntext = \"{one.2.peak} at {one.2.peak_period}, "
               "{both.1.peak}, "
               "{shock.1.peak}, {one.arias_intensity}\"\n");
  const Finished end = folder.run({"report", "s.toml", "-o", "out"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto results = nlohmann::json::parse(folder.read("out/results.json"), nullptr, false);
  const auto alone = folder.run({"spectrum", "h1.csv", "--periods", "0.1:2:40:log", "--json"}).json();
  const auto psa = alone["spectra"][0]["PSA"].get<std::vector<double>>();
  EXPECT_NEAR(results["one.2.peak"]["value"].get<double>(), *std::max_element(psa.begin(), psa.end()), 1e-9);
  EXPECT_TRUE(folder.has("out/figure-1.svg"));
  folder.write("s.toml", "[[task]]\nspectrum = \"one\"\n");
  EXPECT_THAT(folder.run({"report", "s.toml", "-o", "out"}).err, HasSubstr("\"spectrum\" needs file"));
}

TEST(Spectrum, BadInputWritesNothing) {
  const Folder folder;
  folder.write("quake.csv", shaking(300, 0.01));
  folder.write("one.csv", "Time (s),acc (g)\n0,1\n");
  folder.write("path.csv", shaking(300, 0.01, 0.1, "Position (m)"));
  folder.write("slow.csv", shaking(300, 0.02));
  folder.write("word.csv", "Time (s),acc (g)\n0,1\n0.1,abc\n0.2,2\n");
  const auto refused = [&](std::vector<std::string> arguments, const char* why) {
    arguments.insert(arguments.begin(), {"spectrum", "-o", "out.csv", "--plot", "out.svg"});
    const Finished end = folder.run(arguments);
    EXPECT_EQ(end.status, 2) << why;
    EXPECT_THAT(end.err, HasSubstr(why));
    EXPECT_FALSE(folder.has("out.csv")) << why;
    EXPECT_FALSE(folder.has("out.svg")) << why;
  };
  refused({}, "spectrum needs a file");
  refused({"none.csv"}, "none.csv");
  refused({"one.csv"}, "one.csv");
  refused({"path.csv"}, "holds position, not an acceleration");
  refused({"word.csv"}, "word.csv:3: column \"acc (g)\": \"abc\" is not a number");
  refused({"quake.csv", "slow.csv"}, "the components of one motion must be sampled alike");
  refused({"quake.csv", "--column", "a", "--column", "b", "--column", "c"},
          "two components of one motion; 3 are given");
  refused({"quake.csv", "slow.csv", "--column", "a", "--column", "b"}, "4 are given");
  refused({"quake.csv", "slow.csv", "path.csv", "--files", "pairs"},
          "--files pairs: 3 files do not come in pairs");
  refused({"quake.csv", "slow.csv", "--files", "pair"}, "it takes each or pairs (did you mean pairs?)");
  // What is wrong whatever the files hold is said before any of them is read.
  refused({"quake.csv", "slow.csv", "path.csv", "--periods", "-1,2"},
          "--periods: it must be positive, not -1");
  refused({"quake.csv", "slow.csv", "path.csv", "--peaks", "sampls"}, "did you mean samples?");
  refused({"quake.csv", "slow.csv", "path.csv", "--fourier", "fas.csv"},
          "--fourier writes a file of one motion");
  refused({"quake.csv", "slow.csv", "path.csv", "--motion", "m.csv"}, "--motion writes a file of one motion");
  refused({"quake.csv", "--motion", "m.csv", "--fourier", "m.csv"}, "--fourier and --motion both name m.csv");
  refused({"quake.csv", "--periods", "0:10:50:log"}, "both ends must be positive");
  refused({"quake.csv", "--periods", "0.1:10:0"}, "asks for no points");
  refused({"quake.csv", "--periods", "0.1:10:1000000000000000"}, "1e+15 points need 664 PB of memory");
  refused({"quake.csv", "--periods", "1 kg"}, "is a mass; expected a time");
  refused({"quake.csv", "--damping-ratio", "-0.05"}, "it must lie between 0 and 20");
  refused({"quake.csv", "--peaks", "sampls"}, "did you mean samples?");
  refused({"quake.csv", "--between-samples", "spline"}, "linear, hold or band-limited");
  refused({"quake.csv", "--column", "acx"}, "acx");
  refused({"quake.csv", "--tripartite", "--shock"}, "--shock-response pseudo-velocity");
  refused({"quake.csv", "--dampingratio", "1"}, "did you mean --damping-ratio?");
  EXPECT_EQ(folder.run({"spectrum", "quake.csv", "--tripartite"}).status, 2);
}

TEST(Spectrum, WarnsOfPeriodsThatAreTooShort) {
  const Folder folder;
  folder.write("quake.csv", shaking(300, 0.01));
  const Finished end = folder.run({"spectrum", "quake.csv", "--periods", "0.015,1"});
  EXPECT_EQ(end.status, 0);
  EXPECT_THAT(end.err,
              HasSubstr("one period is below 0.02 s, twice the sampling step of 0.01 s: the recording holds "
                        "nothing that fast"));
  EXPECT_THAT(folder.run({"spectrum", "quake.csv", "--periods", "0.015,1", "--quiet"}).err, "");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
