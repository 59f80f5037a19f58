// What fit says beyond the law: the motion, the static way, the line of T² against mass, goals and budgets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>

#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using testing::HasSubstr;

const std::string disc = CROMER_SOURCE_DIR "/data/recording2.csv";
const std::string shared = CROMER_SOURCE_DIR "/../shared/data/";

TEST(FitLab, TellsBudgetTrialsAndPlan) {
  const Finished end =
      Folder().run({"fit", disc, "--mass", "217.6 ± 0.3 g", "--disc-diameter", "12 ± 0.1 cm", "--temperature",
                    "20 ± 2 °C", "--monte-carlo", "20000", "--goal", "decay_rate 1 %", "--json"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto fit = end.json();
  const auto& k = fit["parameters"]["stiffness"];
  ASSERT_EQ(fit["stiffness_budget"].size(), 2u);
  EXPECT_EQ(fit["stiffness_budget"][0]["quantity"], "mass");
  EXPECT_GT(fit["stiffness_budget"][0]["share"], 0.999);
  EXPECT_NEAR(fit["monte_carlo"]["standard_deviation"].get<double>() / k["standard_error"].get<double>(), 1,
              0.03);
  EXPECT_EQ(fit["monte_carlo"]["propagated"]["value"], k["value"]);
  EXPECT_FALSE(fit["plan"]["met"]);
  EXPECT_GT(fit["plan"]["duration"], 150);
  EXPECT_NEAR(fit["keulegan_carpenter"]["max"].get<double>(), 2 * M_PI * 0.036 / 0.12, 0.003);
  ASSERT_GE(fit["decay_by_amplitude"].size(), 10u);
  for (const auto& each : fit["decay_by_amplitude"]) {
    // Student's factor: above the normal distribution's, for stretches have tens to hundreds of degrees.
    const double half = (each["confidence_95"][1].get<double>() - each["confidence_95"][0].get<double>()) / 2;
    EXPECT_NEAR(each["confidence_95"][0].get<double>() + half, each["rate"].get<double>(), 1e-12);
    EXPECT_GT(half, 1.96 * each["standard_error"].get<double>());
    EXPECT_LT(half, 3 * each["standard_error"].get<double>());
  }
  EXPECT_TRUE(fit["textbook"].is_null());
}

/// With plain spaces.
std::string spaced(std::string text) {
  for (std::size_t at = 0; (at = text.find("\u00a0", at)) != text.npos;) text.replace(at, 2, " ");
  return text;
}

TEST(FitLab, SaysFirstWhatIsLookedForFirst) {
  const Finished end = Folder().run({"fit", disc, "--mass", "217.6 g", "--disc-diameter", "12 cm"});
  ASSERT_EQ(end.status, 0) << end.err;
  std::istringstream text(end.out);
  std::string line;
  std::getline(text, line);  // the recording
  for (const char* start : {"  frequency                1.40839", "  spring constant          17.040",
                            "  decay rate               0.0", "  largest Reynolds number  253"}) {
    std::getline(text, line);
    EXPECT_THAT(line, testing::StartsWith(start));
  }
  const std::string said = spaced(end.out);
  EXPECT_THAT(said, HasSubstr("0.01451 ± 0.00003 1/s at the start → 0.006116 ± 0.000016 1/s at the end\n"));
  EXPECT_THAT(said, HasSubstr("  viscous part of the decay rate     0.00179 ± 0.00004 1/s     c x'\n"));
  EXPECT_THAT(said, HasSubstr("  drag                               0.0941 ± 0.0005 1/m       d x'|x'|\n"));
  EXPECT_THAT(said, HasSubstr("your mass has no ±, so its part is not in the uncertainty"));
  const Finished viscous = Folder().run({"fit", disc, "--law", "viscous", "--quiet"});
  EXPECT_THAT(spaced(viscous.out), HasSubstr("\n  decay rate  0.0093 ± 0.0005 1/s\n"));
  EXPECT_THAT(viscous.out, testing::Not(HasSubstr("viscous part")));
}

TEST(FitLab, DrawsTheFirstSwingsOneByOneBesideTheEnvelope) {
  const Folder folder;
  ASSERT_EQ(folder.run({"fit", disc, "--law", "viscous", "--quiet", "--plot", "long.svg"}).status, 0);
  EXPECT_THAT(folder.read("long.svg"), HasSubstr("The first swings"));
  ASSERT_EQ(
      folder.run({"fit", disc, "--law", "viscous", "--to", "5 s", "--quiet", "--plot", "short.svg"}).status,
      0);
  EXPECT_THAT(folder.read("short.svg"), testing::Not(HasSubstr("The first swings")));
}

// What the arithmetic leaves of a computed motion is correlated and has a highest line, but nothing made it:
// no drive is looked for there, nor another term.
TEST(FitLab, ReadsAComputedMotion) {
  const Folder folder;
  const Finished made = folder.run({"simulate", "--mass", "0.2 kg", "--stiffness", "17 N/m", "--damping",
                                    "0.01 kg/s", "--position", "3 cm", "--method", "exact", "--method",
                                    "euler-cromer", "--until", "20 s", "-o", "run.csv"});
  ASSERT_EQ(made.status, 0) << made.err;
  for (const char* run : {"1", "2"}) {
    const Finished end = folder.run({"fit", "run.csv", "--run", run, "--json"});
    ASSERT_EQ(end.status, 0) << end.err;
    EXPECT_EQ(end.json()["law"], "viscous");
    EXPECT_NEAR(end.json()["parameters"]["decay_rate"]["value"].get<double>(), 0.025, 1e-5);
  }
}

// Beta and gamma of a force with an exponent are no numbers per unit mass: the line that fit prints has them
// of the force, and makes the fitted motion again.
TEST(FitLab, GivesAHystereticLawAsSimulateTakesIt) {
  const Folder folder;
  const std::vector<std::string> law{"--mass",
                                     "5",
                                     "--stiffness",
                                     "180",
                                     "--damping",
                                     "1",
                                     "--hysteresis-stiffness",
                                     "60",
                                     "--hysteresis-beta",
                                     "0.06",
                                     "--hysteresis-gamma",
                                     "0.02",
                                     "--hysteresis-exponent",
                                     "2"};
  std::vector<std::string> made{"simulate", "--position", "1",   "--until", "20",      "--step",
                                "0.02",     "--method",   "rk4", "-o",      "made.csv"};
  made.insert(made.end(), law.begin(), law.end());
  ASSERT_EQ(folder.run(made).status, 0);
  const std::vector<std::string> asked{"fit",    "made.csv", "--column",
                                       "x",      "--law",    "viscous+hysteresis",
                                       "--mass", "5",        "--hysteresis-exponent",
                                       "2",      "--json"};
  const Finished end = folder.run(asked);
  ASSERT_EQ(end.status, 0) << end.err;
  const auto fit = end.json();
  EXPECT_NEAR(fit["parameters"]["hysteresis_beta"]["value"].get<double>(), 0.06 * 5, 0.003);
  EXPECT_EQ(fit["parameters"]["hysteresis_beta"]["unit"], "s^2/m^2");
  EXPECT_NEAR(fit["parameters"]["hysteresis_force_stiffness"]["value"].get<double>(), 60, 0.5);
  // The loops depend on how the motion came there: no ratio of an amplitude, and no plan.
  EXPECT_TRUE(fit["derived"].empty());
  EXPECT_TRUE(fit["decay_by_amplitude"].empty());
  std::vector<std::string> planned = asked;
  planned.insert(planned.end(), {"--goal", "decay_rate 1 %"});
  const Finished plan = folder.run(planned);
  EXPECT_EQ(plan.status, 2);
  EXPECT_THAT(plan.err, HasSubstr("how soon a swing with hysteresis dies down is not predicted"));

  std::istringstream line(fit["simulate"].get<std::string>());
  std::vector<std::string> again{std::istream_iterator<std::string>(line), {}};
  again.erase(again.begin());
  again.erase(std::find(again.begin(), again.end(), "--over"), again.end());
  again.insert(again.end(), {"-o", "again.csv"});
  const Finished simulated = folder.run(again);
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  const Finished refitted = folder.run({"fit", "again.csv", "--column", "x", "--law", "viscous+hysteresis",
                                        "--mass", "5", "--hysteresis-exponent", "2", "--json"});
  ASSERT_EQ(refitted.status, 0) << refitted.err;
  for (const char* name : {"hysteresis_beta", "hysteresis_gamma", "stiffness"})
    EXPECT_NEAR(refitted.json()["parameters"][name]["value"].get<double>(),
                fit["parameters"][name]["value"].get<double>(),
                0.02 * std::abs(fit["parameters"][name]["value"].get<double>()))
        << name;
}

TEST(FitLab, RefusesADriveThatTheSamplesDoNotShow) {
  const Finished end = Folder().run({"fit", disc, "--drive-frequency", "1000 Hz"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err,
              HasSubstr("1000 Hz cannot be seen in 100 samples per second, only frequencies up to 50 Hz"));
}

TEST(FitLab, RefusesWhatAMassAtRestDoesNotHave) {
  for (const std::vector<std::string>& asked :
       {std::vector<std::string>{"--hysteresis-exponent", "2"}, std::vector<std::string>{"--law", "viscous"},
        std::vector<std::string>{"--force-column", "F", "--no-spring"},
        std::vector<std::string>{"--force-column", "F", "--between-samples", "hold"}}) {
    std::vector<std::string> all{"fit", disc, "--static", "--masses", "40, 60 g"};
    all.insert(all.end(), asked.begin(), asked.end());
    const Finished end = Folder().run(all);
    EXPECT_EQ(end.status, 2);
    EXPECT_THAT(end.err, HasSubstr(asked.front() + " has no meaning with --static"));
  }
}

TEST(FitLab, IsSaidByCompareAsWell) {
  const std::vector<std::string> asked{
      "compare",        disc,         "--mass",          "217.6 ± 0.3 g", "--monte-carlo", "2000", "--goal",
      "decay_rate 1 %", "--textbook", "--disc-diameter", "12 cm"};
  const Finished words = Folder().run(asked);
  ASSERT_EQ(words.status, 0) << words.err;
  for (const char* each : {"stiffness ", "2000 trials", "to record:", "textbook:", "Reynolds", "R squared"})
    EXPECT_THAT(words.out, HasSubstr(each));
  std::vector<std::string> json = asked;
  json.emplace_back("--json");
  const auto fit = Folder().run(json).json()["fit"];
  for (const char* each : {"monte_carlo", "plan", "textbook", "reynolds"}) EXPECT_FALSE(fit[each].is_null());
  EXPECT_NEAR(fit["parameters"]["stiffness"]["value"].get<double>(), 17.04, 0.05);
}

TEST(FitLab, OfAMassAtRestTellsNothingOfAMotion) {
  for (const auto& [option, value] : {std::pair("--law", "viscous"),
                                      {"--goal", "decay_rate 1 %"},
                                      {"--segments", "2"},
                                      {"--motion", "motion.csv"}}) {
    const Finished end = Folder().run({"fit", "--static", "--masses", "48 g, 68 g", disc, option, value});
    EXPECT_EQ(end.status, 2) << option;
    EXPECT_THAT(end.err, HasSubstr(option));
    EXPECT_THAT(end.err, HasSubstr("a mass at rest has no motion"));
  }
}

TEST(FitLab, SaysThatAMassHeldIsNotAtRest) {
  const std::string other = CROMER_SOURCE_DIR "/data/recording1.csv";
  const Finished end = Folder().run({"fit", "--static", "--masses", "200 g, 210 g", disc, other});
  EXPECT_THAT(end.err, HasSubstr("recording2.csv, run 1, 0 to 120 s is not at rest"));
  EXPECT_THAT(end.err, HasSubstr("recording1.csv, run 1"));
}

TEST(FitLab, TheMotionMarksSamplesSetAsideAndTakesNoVelocityFromThem) {
  Folder folder;
  std::string spoilt = recording(1000);
  std::size_t line = 0;  // of a sample near 2 s
  for (int i = 0; i < 201; ++i) line = spoilt.find('\n', line) + 1;
  const std::size_t comma = spoilt.find(',', line), end = spoilt.find('\n', line);
  const std::string clean = spoilt;
  spoilt.replace(comma + 1, end - comma - 1, "7");
  folder.write("clean.csv", clean);
  folder.write("spoilt.csv", spoilt);
  const auto rows = [&](const std::string& name) {
    EXPECT_EQ(
        folder.run({"fit", name + ".csv", "--law", "viscous", "--motion", name + ".motion.csv", "--quiet"})
            .status,
        0);
    std::istringstream lines(folder.read(name + ".motion.csv"));
    std::vector<std::vector<std::string>> table;
    for (std::string row; std::getline(lines, row);) {
      if (row.empty() || row[0] == '#') continue;
      auto& cells = table.emplace_back();
      std::istringstream in(row);
      for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    }
    return table;
  };
  const auto good = rows("clean"), bad = rows("spoilt");
  ASSERT_EQ(bad.size(), good.size());
  ASSERT_EQ(bad[0].back(), "set aside");
  const std::size_t v = bad[0].size() - 2;
  int marked = 0;
  for (std::size_t i = 1; i < bad.size(); ++i) {
    marked += bad[i].back() == "1";
    if (good[i][v].empty()) continue;
    EXPECT_NEAR(std::stod(bad[i][v]), std::stod(good[i][v]), 1e-3) << i;
  }
  EXPECT_EQ(marked, 1);
}

TEST(FitLab, TheCovarianceHasTheSquaredErrorsOnItsDiagonal) {
  const auto fit = Folder().run({"fit", disc, "--law", "viscous+drag", "--json"}).json();
  const auto& names = fit["covariance"]["parameters"];
  const auto& matrix = fit["covariance"]["matrix"];
  ASSERT_EQ(names.size(), 6u);
  ASSERT_EQ(matrix.size(), 6u);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double error = fit["parameters"][names[i].get<std::string>()]["standard_error"].get<double>();
    EXPECT_NEAR(matrix[i][i].get<double>() / (error * error), 1, 1e-12) << names[i];
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_NEAR(matrix[i][j].get<double>() / matrix[j][i].get<double>(), 1, 1e-9);
  }
  EXPECT_LT(matrix[1][2].get<double>(), 0);  // viscous damping is traded for drag
}

/// The same motion in another unit: a decay of 0.03 1/s with noise of a hundredth, times `scale`.
std::string scaled_recording(double scale) {
  std::string text = "Time (s),Position (m)\n";
  char row[96];
  unsigned seed = 5;
  for (int i = 0; i < 2000; ++i) {
    seed = seed * 1664525u + 1013904223u;
    const double t = i * 0.01, noise = 1e-3 * (seed / 4294967296.0 - 0.5);
    std::snprintf(row, sizeof row, "%.2f,%.17g\n", t,
                  scale * (0.05 * std::exp(-0.03 * t) * std::cos(8 * t) + noise));
    text += row;
  }
  return text;
}

TEST(FitLab, ResultsDoNotDependOnTheUnit) {
  Folder folder;
  folder.write("one.csv", scaled_recording(1));
  const auto one = folder.run({"fit", "one.csv", "--json"}).json();
  ASSERT_EQ(one["status"], "converged");
  for (const double scale : {0x1p60, 0x1p-20, 0x1p-30, 0x1p-60, 0x1p-100}) {
    folder.write("other.csv", scaled_recording(scale));
    const auto other = folder.run({"fit", "other.csv", "--json"}).json();
    ASSERT_EQ(other["status"], "converged") << scale << other["message"];
    EXPECT_EQ(other["law"], one["law"]) << scale;
    for (const char* name : {"angular_frequency", "decay_rate"})
      for (const char* part : {"value", "standard_error"})
        EXPECT_NEAR(
            other["parameters"][name][part].get<double>() / one["parameters"][name][part].get<double>(), 1,
            1e-6)
            << name << " " << scale;
  }
  folder.write("absurd.csv", scaled_recording(1e-300));
  const Finished absurd = folder.run({"fit", "absurd.csv"});
  EXPECT_EQ(absurd.status, 2);
  EXPECT_THAT(absurd.err, HasSubstr("another unit"));
}

TEST(FitLab, WritesTheMotionSampleBySample) {
  Folder folder;
  folder.write("lab.csv", recording(2000));
  const Finished end =
      folder.run({"fit", "lab.csv", "--law", "viscous", "--motion", "motion.csv", "--quiet"});
  ASSERT_EQ(end.status, 0) << end.err;
  const std::string csv = folder.read("motion.csv");
  EXPECT_TRUE(csv.starts_with("file,run,t (s),measured (m),x (m),v (m/s),energy (J/kg),residual (m),"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2001);
  EXPECT_EQ(folder.run({"fit", "lab.csv", "--motion", "lab.csv"}).status, 2);
  EXPECT_EQ(folder.run({"fit", "lab.csv", "--motion", "motion.txt"}).status, 2);
}

TEST(FitLab, FindsTheSpringOfTheCapstoneLabTheStaticWay) {
  const std::string file = shared + "spring-disc-capstone-mm/Misure k statiche non_pretensionata.csv";
  if (!std::ifstream(file)) GTEST_SKIP() << "no " << file;
  const Finished end = Folder().run({"fit", "--static", "--masses", "48.4 g, 67.95 g, 87.96 g", "--gravity",
                                     "9.805 m/s^2", file, "--json"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto k = end.json()["parameters"]["stiffness"];
  EXPECT_NEAR(k["value"].get<double>(), 3.226, 0.0015);
  EXPECT_NEAR(k["standard_error"].get<double>(), 0.021, 0.001);
}

/// A swing of frequency w, 20 s at 100 a second, with a little noise.
std::string swing_record(double w, unsigned seed) {
  std::string text = "Time (s),Position (m)\n";
  char row[64];
  for (int i = 0; i < 2000; ++i) {
    seed = seed * 1664525u + 1013904223u;
    const double t = i / 100.0, noise = 1e-3 * (seed / 4294967296.0 - 0.5);
    std::snprintf(row, sizeof row, "%.2f,%.6f\n", t, 0.05 * std::exp(-0.02 * t) * std::cos(w * t) + noise);
    text += row;
  }
  return text;
}

TEST(FitLab, DrawsTheLineOfPeriodsSquaredAgainstMass) {
  Folder folder;
  const double k = 16, spring = 0.03;
  int number = 0;
  std::vector<std::string> words{"fit",         "--law",    "viscous",        "--quiet",
                                 "--mass-line", "--masses", "100, 150, 200 g"};
  for (const double m : {0.1, 0.15, 0.2}) {
    const std::string name = std::to_string(++number) + ".csv";
    folder.write(name, swing_record(std::sqrt(k / (m + spring / 3)), static_cast<unsigned>(number)));
    words.push_back(name);
  }
  Finished end = folder.run(words);
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_THAT(end.out, HasSubstr("T² against mass, 3 recordings: stiffness 1"));
  // The interval is written with enough digits to be one: its ends differ.
  double low = 0, high = 0;
  const std::size_t between = end.out.find("95 % between ");
  ASSERT_NE(between, std::string::npos);
  ASSERT_EQ(std::sscanf(end.out.c_str() + between, "95 %% between %lf and %lf", &low, &high), 2);
  EXPECT_LT(low, high);
  std::vector<std::string> with_table = words;
  with_table.insert(with_table.end(), {"-o", "line.csv"});
  ASSERT_EQ(folder.run(with_table).status, 0);
  EXPECT_THAT(folder.read("line.csv"),
              testing::StartsWith("file,run,mass (kg),mass standard error (kg),period squared (s²),"));
  EXPECT_THAT(folder.read("line.csv"), HasSubstr("stiffness 95 % low (N/m)"));
  words.push_back("--json");
  const auto line = folder.run(words).json()["mass_line"];
  const auto near = [](const auto& object, double truth, double relative) {
    EXPECT_NEAR(object["value"].template get<double>(), truth,
                4 * object["standard_error"].template get<double>());
    EXPECT_NEAR(object["value"].template get<double>(), truth, relative * truth);
  };
  near(line["stiffness"], k, 1e-3);
  near(line["spring_mass"], spring, 0.02);
}

TEST(FitLab, ItsTableHasBoundsAndTheRatesOfSegments) {
  Folder folder;
  folder.write("lab.csv", swing_record(6, 3));
  ASSERT_EQ(folder.run({"fit", "lab.csv", "--law", "viscous", "--segments", "2", "-o", "lab.csv.csv"}).status,
            0);
  const std::string csv = folder.read("lab.csv.csv");
  for (const char* column : {"decay_rate 95 % low (1/s)", "decay_rate 95 % high (1/s)",
                             "decay_rate_segment_1 (1/s)", "decay_rate_segment_2 standard error (1/s)"})
    EXPECT_THAT(csv, HasSubstr(column));
}

TEST(FitLab, AFailedFitLeavesNoLineAndIsNoWrongInput) {
  Folder folder;
  folder.write("one.csv", swing_record(9, 1));
  folder.write(
      "flat.csv", "Time (s),Position (m)\n" + [] {
        std::string rows;
        for (int i = 0; i < 100; ++i) rows += std::to_string(i * 0.01) + ",0.3\n";
        return rows;
      }());
  const Finished end = folder.run({"fit", "--mass-line", "--masses", "100, 200 g", "one.csv", "flat.csv"});
  EXPECT_EQ(end.status, 1) << end.err;
  EXPECT_THAT(end.err, HasSubstr("no line of T²"));
}

// Its frequency is the drive's: no spring constant follows from it.
TEST(FitLab, ASettledMotionTellsTheDriveAlone) {
  Folder folder;
  std::string rows = "time (s),position (m)\n";
  for (int i = 0; i < 1500; ++i) {
    const double t = 0.02 * i, noise = 5e-4 * std::sin(1e4 * t * t);
    rows += std::to_string(t) + "," + std::to_string(0.5 + 0.09 * std::cos(6.157 * t + 1) + noise) + "\n";
  }
  folder.write("settled.csv", rows);
  const auto named = folder.run({"fit", "settled.csv", "--drive-frequency", "0.98 Hz", "--json"});
  EXPECT_EQ(named.json()["status"], "no_oscillation");
  EXPECT_THAT(named.err + named.out, HasSubstr("the body's own nor its damping"));
  const auto sought = folder.run({"fit", "settled.csv", "--drive-frequency", "auto", "--json"}).json();
  EXPECT_EQ(sought["status"], "converged");
  EXPECT_THAT(sought["warnings"].dump(), HasSubstr("it looks the same, and no drive is told from it"));
  EXPECT_EQ(folder.run({"fit", "settled.csv", "--json"}).json()["status"], "converged");
  EXPECT_EQ(folder.run({"fit", "settled.csv", "--drive-frequency", "0.7 Hz", "--json"}).json()["status"],
            "converged");
}

TEST(FitLab, AFreeSwingHasNoDrive) {
  Folder folder;
  folder.write("lab.csv", swing_record(8, 3));
  const auto searched = folder.run({"fit", "lab.csv", "--drive-frequency", "auto", "--json"}).json();
  EXPECT_EQ(searched["status"], "converged");
  EXPECT_FALSE(searched["parameters"].contains("drive_amplitude"));
  EXPECT_THAT(searched["warnings"].dump(), HasSubstr("no drive is seen at any frequency"));
  const auto named = folder.run({"fit", "lab.csv", "--drive-frequency", "0.5 Hz", "--json"}).json();
  EXPECT_EQ(named["status"], "converged");
  EXPECT_EQ(named["law"], searched["law"]);
  EXPECT_FALSE(named["parameters"].contains("drive_amplitude"));
  EXPECT_THAT(named["warnings"].dump(), HasSubstr("nothing is seen to drive this motion at 0.5 Hz"));
  EXPECT_THAT(named["warnings"].dump(), HasSubstr("--drive-frequency auto looks for"));
}

TEST(FitLab, MassesOutOfOrderAreSaid) {
  Folder folder;
  std::vector<std::string> words{"fit", "--static", "--masses", "200 g, 50 g, 100 g, 150 g"};
  for (const double mass : {0.05, 0.1, 0.15, 0.2}) {
    std::string text = "Time (s),Position (m)\n";
    for (int i = 0; i < 200; ++i)
      text += std::to_string(i * 0.01) + "," + std::to_string(0.2 + mass * 9.8 / 20 + 1e-5 * (i % 3)) + "\n";
    words.push_back("hold" + std::to_string(mass) + ".csv");
    folder.write(words.back(), text);
  }
  EXPECT_THAT(folder.run(words).err, HasSubstr("must be in the order of the holds"));
  words[3] = "50, 100, 150, 200 g";
  EXPECT_EQ(folder.run(words).err.find("must be in the order of the holds"), std::string::npos);
}

TEST(FitLab, RefusesOptionsThatDoNotGoTogether) {
  Folder folder;
  folder.write("lab.csv", recording(2000));
  const auto refused = [&](std::vector<std::string> words, const char* says) {
    words.insert(words.begin(), {"fit", "lab.csv"});
    const Finished end = folder.run(words);
    EXPECT_EQ(end.status, 2) << says;
    EXPECT_THAT(end.err, HasSubstr(says));
  };
  refused({"--static"}, "--static needs --masses");
  refused({"--static", "--mass-line", "--masses", "1 g, 2 g"}, "two ways");
  refused({"--masses", "1 g, 2 g"}, "--masses goes with");
  refused({"--static", "--masses", "1 g"}, "at least two masses");
  refused({"--static", "--masses", "1 g, 2 m"}, "--masses");
  refused({"--static", "--masses", "1 g, 2 g, 3 g"}, "plateau");
  refused({"--gravity", "9.8"}, "--gravity is for --static");
  refused({"--mass-line", "--masses", "1 g, 2 g"}, "2 masses are given for 1");
  refused({"--monte-carlo", "20000"}, "--monte-carlo needs --mass");
  refused({"--monte-carlo", "10", "--mass", "1"}, "between 1000 and");
  refused({"--goal", "decy_rate 1 %"}, "did you mean decay_rate?");
  refused({"--goal", "drag 1 %", "--law", "viscous"}, "its law is viscous; fit one with drag by --law");
  refused({"--goal", "stiffness 1 %"}, "--mass");
  refused({"--static", "--masses", "50, 100, 150 g, 200 g"}, "50 has no unit, but others have");
  refused({"--mass-line", "--masses", "1 g, 2 g", "--mass", "1 g"}, "takes the masses from --masses");
  refused({"--law", "auto+drag"}, "auto chooses the terms itself");
  refused({"--motion", "lab.csv"}, "--motion lab.csv: that is the file to be read");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
