// The labs and studies of all kinds of badness, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "program.h"
#include "tests/support/bytes_of.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* source = CROMER_SOURCE_DIR;

/// One lab's report and its numbers.
struct Lab {
  explicit Lab(const std::string& study)
      : end(folder.run({"report", std::string(source) + "/studies/" + study, "-o", "out"})) {
    if (folder.has("out/results.json"))
      results = nlohmann::json::parse(folder.read("out/results.json"), nullptr, false);
  }
  double value(const std::string& name) const { return results.at(name).at("value"); }

  Folder folder;
  Finished end;
  nlohmann::json results;
};

/// index.html holds each figure, and each is there as a file.
void expect_figures(const Lab& lab, int count) {
  const std::string page = lab.folder.read("out/index.html");
  for (int i = 1; i <= count; ++i) {
    const std::string name = "figure-" + std::to_string(i);
    EXPECT_TRUE(lab.folder.has("out/" + name + ".svg")) << name;
    EXPECT_THAT(page, HasSubstr("Figure " + std::to_string(i))) << name;
  }
  EXPECT_THAT(page, HasSubstr("<svg"));
  EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
  EXPECT_THAT(page, Not(HasSubstr("href=\"http")));
  EXPECT_THAT(page, HasSubstr("cromer 0.1.0"));
}

TEST(Report, OfTheResonanceLabHasItsFiguresAndTheTheorysNumbers) {
  const Lab lab("resonance.toml");
  ASSERT_EQ(lab.end.status, 0) << lab.end.err;
  expect_figures(lab, 5);
  // Undamped at resonance: F t/(2 m w), with its turning points at most a quarter period before 80 s.
  EXPECT_NEAR(lab.value("undamped.2.peak"), 80.0 / 6, 0.2);
  // F/(c w) at resonance; implicit Euler by its difference equation: 1/|s^2 + 0.2 s + 9|, s = (1 - e^{-0.03
  // i})/0.01.
  EXPECT_NEAR(lab.value("ec_settled.1.steady.amplitude"), 1 / 0.6, 1e-4);
  const double re = (1 - std::cos(0.03)) / 0.01, im = std::sin(0.03) / 0.01;
  EXPECT_NEAR(lab.value("ie_settled.1.steady.amplitude"),
              1 / std::hypot(re * re - im * im + 0.2 * re + 9, 2 * re * im + 0.2 * im), 1e-6);
  EXPECT_EQ(lab.value("ie.1.newton_iterations"), 2 * lab.value("ie.1.steps"));
}

TEST(Report, OfCoupledPendulumsHasBeatsAndModes) {
  const Lab lab("coupled_pendulums.toml");
  ASSERT_EQ(lab.end.status, 0) << lab.end.err;
  expect_figures(lab, 4);
  EXPECT_NEAR(lab.value("modes.coupling"), 0.05 / 1.62, 1e-9);
  // The energy has moved over after half a beat, to a period, but for what damping took.
  EXPECT_NEAR(lab.value("beats.1.right.energy_peak_t"), lab.value("modes.beat_period") / 2,
              lab.value("modes.1.period"));
  EXPECT_GT(lab.value("beats.1.right.energy_peak"), 0.8 * lab.value("beats.1.energy.start"));
  EXPECT_LT(lab.value("beats.1.links.3.energy_peak"), 0.1 * lab.value("beats.1.energy.start"));
  EXPECT_NEAR(lab.value("in_phase.1.links.3.energy_peak"), 0, 1e-15);
  // What the texts say of methods: only implicit Euler damps the modes much.
  EXPECT_GT(lab.value("by_methods.1.methods.3.damping_ratio"), 20 * lab.value("modes.1.damping_ratio"));
  EXPECT_LT(lab.value("by_methods.1.methods.2.damping_ratio"), 1.1 * lab.value("modes.1.damping_ratio"));
  EXPECT_LT(lab.value("coarse.3.right.peak"), 0.5 * lab.value("coarse.1.right.peak"));
}

TEST(Report, OfTheSpringLabAnswersItsQuestions) {
  const Lab lab("spring_lab.toml");
  ASSERT_EQ(lab.end.status, 0) << lab.end.err;
  expect_figures(lab, 15);
  EXPECT_THAT(lab.folder.read("out/index.html"), HasSubstr("synthetic"));
  EXPECT_NEAR(lab.value("one.stiffness"), 16.6, 0.02);
  EXPECT_NEAR(lab.value("two.stiffness"), 17.04, 0.02);
  EXPECT_NEAR(lab.value("two.segment.1.rate"), 0.0124, 0.0001);
  EXPECT_NEAR(lab.value("two.segment.2.rate"), 0.0094, 0.0001);
  EXPECT_NEAR(lab.value("two.segment.3.rate"), 0.0077, 0.0001);
  EXPECT_NEAR(lab.value("two.decay_rate_mean"), 0.00984, 0.00004);
  EXPECT_NEAR(lab.value("two.reynolds.max"), 2525, 10);
  EXPECT_NEAR(lab.value("compared.1.amplitude_error_end"), -0.1, 0.015);
  // (1 + w^2 h^2) to the steps of a cycle; doubling in ln 2/ln(1 + w^2 h^2) steps.
  const double wh = std::sqrt(16.6 / 0.2008) * 0.01;
  EXPECT_NEAR(lab.value("perfect.1.energy_factor_per_cycle"), std::pow(1 + wh * wh, 2 * M_PI / wh), 0.01);
  EXPECT_NEAR(lab.value("perfect.1.energy_doubling_time"), 0.01 * std::log(2) / std::log1p(wh * wh), 0.005);
  EXPECT_NEAR(lab.value("taylor.1.x_slope"), 2, 0.05);
  EXPECT_NEAR(lab.value("taylor.1.v_slope"), 2, 0.05);
}

TEST(Report, OfTheMethodsLabHasEveryMethodAndTheTheorysNumbers) {
  const Lab lab("methods.toml");
  ASSERT_EQ(lab.end.status, 0) << lab.end.err;
  EXPECT_THAT(lab.end.err, Not(HasSubstr("warning")));
  expect_figures(lab, 9);
  const auto shown = [&](const std::string& task, const std::string& method) {
    for (int i = 1; i < 20; ++i) {
      const std::string label = task + "." + std::to_string(i) + ".label";
      if (lab.results.contains(label) && lab.results.at(label) == method) return true;
    }
    return false;
  };
  const auto document = lab.folder.run({"methods", "--json"}).json();
  for (const auto& method : document["methods"]) {
    const std::string name = method["name"];
    EXPECT_TRUE(shown("map", name)) << name;
    if (name != "exact") {
      EXPECT_TRUE(shown("linear", name) && shown("duffing", name) && shown("drag", name)) << name;
    }
    if (name != "forward-euler") {
      EXPECT_TRUE(shown("curve", name)) << name << ", which would settle";
    }
  }
  EXPECT_NEAR(lab.value("map.1.at_a_tenth.decay_rate"), -std::log(1 - 0.004 + 0.01) / 0.2, 1e-12);
  EXPECT_NEAR(lab.value("map.2.at_a_tenth.decay_rate"), -std::log(1 - 0.004) / 0.2, 1e-12);
  EXPECT_NEAR(lab.value("map.3.at_a_tenth.decay_rate"), std::log(1 + 0.004 + 0.01) / 0.2, 1e-12);
  const auto through = [](double r, double ratio) {
    return std::hypot(1, 2 * ratio * r) / std::hypot(1 - r * r, 2 * ratio * r);
  };
  EXPECT_NEAR(lab.value("mount.1.last_transmissibility"), through(3, 0.1), 1e-12);
  EXPECT_NEAR(lab.value("mount.5.last_transmissibility"), through(3, 1), 1e-12);
  const double w = 18 * M_PI;
  EXPECT_NEAR(lab.value("machine.5.last_transmitted"), 0.5 * 0.2 * w * w * through(3, 1), 1e-9);
  // Implicit Euler's relative motion on a base at 4 w0: backward differences in place of derivatives.
  const std::complex<double> s = (1.0 - std::exp(std::complex<double>(0, -0.8))) / 0.2;
  EXPECT_NEAR(lab.value("shaken.3.last_transmissibility"), std::abs(1.0 + 16.0 / (s * s + 0.2 * s + 1.0)),
              1e-5);
}

TEST(Report, PrintsOneJsonDocument) {
  Folder folder;
  folder.write("s.toml", "title = \"S\"\n[[task]]\nsimulate = \"a\"\n");
  const Finished end = folder.run({"report", "s.toml", "-o", "out", "--json"});
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_EQ(end.json().value("index", ""), "out/index.html");
}

struct BadStudy {
  const char* name;
  const char* toml;
  int status;
  const char* says;
};

class BadStudies : public ::testing::TestWithParam<BadStudy> {};

TEST_P(BadStudies, NameTheirPlaceAndLeaveNothing) {
  Folder folder;
  folder.write("s.toml", GetParam().toml);
  const Finished end = folder.run({"report", "s.toml", "-o", "out", "--json"});
  EXPECT_EQ(end.status, GetParam().status) << end.err;
  EXPECT_THAT(end.err, HasSubstr(GetParam().says));
  EXPECT_FALSE(folder.has("out/index.html"));
  if (GetParam().status == 1) {
    EXPECT_THAT(end.json().value("message", ""), HasSubstr(GetParam().says));
  }
}

constexpr BadStudy bad_studies[] = {
    {"no_toml", "title = \n", 2, "s.toml:1:"},
    {"unknown_key", "titel = \"x\"\n", 2, "s.toml:1:9: \"titel\" is not known here; did you mean \"title\"?"},
    {"unknown_option", "[[task]]\nsimulate = \"a\"\nstifness = 3\n", 2,
     "s.toml:3:12: \"stifness\" is no option of simulate; did you mean \"stiffness\"?"},
    {"wrong_unit", "[[task]]\nsimulate = \"a\"\nmass = \"3 N\"\n", 2, "s.toml:3:8: --mass"},
    {"bad_value", "[[task]]\nsimulate = \"a\"\nmass = -1\n", 2, "mass"},
    {"missing_recording", "[[task]]\nfit = \"a\"\nfile = \"absent.csv\"\n", 2, "absent.csv"},
    {"unknown_result", "summary = \"{a.1.pek}\"\n[[task]]\nsimulate = \"a\"\n", 2,
     "did you mean \"a.1.peak\"?"},
    {"unknown_column",
     "[[task]]\nsimulate = \"a\"\n[[figure]]\nid = \"f\"\nx = \"t\"\ny = \"z\"\n[[figure.curve]]\nof = "
     "\"a.1\"\n",
     2, "\"a.1.z\" is no column"},
    {"id_out_of_the_folder", "[[task]]\nsimulate = \"a\"\n[[figure]]\nid = \"../../x\"\n", 2,
     "s.toml:3:1: the id \"../../x\" becomes a file's name"},
    {"figure_without_curves", "[[task]]\nsimulate = \"a\"\n[[figure]]\nid = \"f\"\n", 2, "needs curves"},
    {"nothing_to_do", "title = \"S\"\n", 2, "there is nothing to do"},
    {"diverging", "[[task]]\nsimulate = \"a\"\nmethod = \"forward-euler\"\nstep = 5\nuntil = 10000\n", 1,
     "s.toml:1:1: simulate a: forward-euler: diverged"},
};

INSTANTIATE_TEST_SUITE_P(Report, BadStudies, ::testing::ValuesIn(bad_studies),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(ReportOfRecordings, IsWrittenWithItsStudyReadyToEdit) {
  const Folder folder;
  const std::string lab = std::string(source) + "/data/recording1.csv";
  const Finished first =
      folder.run({"report", lab, "--mass", "200.8 ± 0.4 g", "--author", "A. Student", "-o", "out"});
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(first.out, "out/index.html\n");
  const std::string page = folder.read("out/index.html");
  EXPECT_THAT(page, HasSubstr("A. Student"));
  EXPECT_THAT(page, HasSubstr("How stiff the spring is"));
  // Again, over what was made: and by its study, which gives the same page.
  EXPECT_EQ(folder.run({"report", lab, "--mass", "200.8 ± 0.4 g", "-o", "out"}).status, 0);
  ASSERT_EQ(folder.run({"report", "out/study.toml", "-o", "again"}).status, 0);
  EXPECT_EQ(folder.read("again/index.html"), folder.read("out/index.html"));
  const auto results = [&](const std::string& from) {
    auto read = nlohmann::json::parse(folder.read(from + "/results.json"));
    for (const char* path : {"lab.file", "lab.simulate"}) read.erase(path);  // seen from another folder
    return read;
  };
  EXPECT_EQ(results("again"), results("out"));
  // Changed by hand it is kept.
  folder.write("out/study.toml", "# mine\n" + folder.read("out/study.toml"));
  const Finished kept = folder.run({"report", lab, "-o", "out"});
  EXPECT_EQ(kept.status, 2);
  EXPECT_THAT(kept.err, HasSubstr("out/study.toml was changed by hand and is kept"));
}

TEST(ReportOfRecordings, EachHasItsOwnMass) {
  const Folder folder;
  const std::string data = std::string(source) + "/data/";
  ASSERT_EQ(folder
                .run({"report", data + "recording1.csv", data + "recording2.csv", "--mass", "100 ± 1, 200 g",
                      "-o", "out"})
                .status,
            0);
  const std::string study = folder.read("out/study.toml");
  EXPECT_THAT(study, HasSubstr("mass = \"0.1 ± 0.001 kg\"\n"));
  EXPECT_THAT(study, HasSubstr("mass = \"0.2 kg\"\n"));
  EXPECT_EQ(folder.run({"report", "out/study.toml", "-o", "again"}).status, 0);
  EXPECT_EQ(folder.read("again/index.html"), folder.read("out/index.html"));
}

TEST(ReportOfRecordings, OfWhatCannotBeFittedHasTheReason) {
  const Folder folder;
  std::string bytes = "t (s),x (m)\n";
  for (int i = 0; i < 200; ++i) bytes += std::to_string(0.01 * i) + "," + std::to_string(0.02 * i) + "\n";
  folder.write("line.csv", bytes);
  const Finished end = folder.run({"report", "line.csv", "-o", "out"});
  EXPECT_EQ(end.status, 1);
  EXPECT_EQ(end.out, "out/index.html\n");
  EXPECT_THAT(end.err, HasSubstr("line.csv: run 1: "));
  EXPECT_THAT(folder.read("out/index.html"), HasSubstr("no law of motion is given"));
  EXPECT_EQ(folder.run({"report", "out/study.toml", "-o", "again"}).status, 0);
  EXPECT_EQ(folder.read("again/index.html"), folder.read("out/index.html"));
}

// Where nothing could be read there is nothing to report, and nothing is written.
TEST(ReportOfRecordings, OfFilesThatAreNotThereIsNone) {
  const Folder folder;
  const Finished end = folder.run({"report", "one.csv", "two.csv", "-o", "lab"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, AllOf(HasSubstr("one.csv"), HasSubstr("two.csv"), HasSubstr("cannot be")));
  EXPECT_FALSE(folder.has("lab"));
}

TEST(ReportOfRecordings, RefusesWhatDoesNotGoTogether) {
  const Folder folder;
  const std::string lab = std::string(source) + "/data/recording1.csv",
                    study = std::string(source) + "/studies/methods.toml";
  const auto refusal = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "report");
    const Finished end = folder.run(words);
    EXPECT_EQ(end.status, 2) << end.err;
    EXPECT_FALSE(folder.has("out"));
    return end.err;
  };
  EXPECT_THAT(refusal({lab}), HasSubstr("needs -o FOLDER"));
  EXPECT_THAT(refusal({study, "--mass", "1 kg", "-o", "out"}), HasSubstr("--mass: a study says this itself"));
  EXPECT_THAT(refusal({study, "--title", "T", "-o", "out"}), HasSubstr("--title: a study says this itself"));
  EXPECT_THAT(refusal({study, lab, "-o", "out"}), HasSubstr("one study, or recordings"));
  EXPECT_THAT(refusal({lab, "--language", "fr", "-o", "out"}),
              HasSubstr("--language fr: it must be en or de"));
  EXPECT_THAT(refusal({lab, "--front", "none.toml", "-o", "out"}), HasSubstr("none.toml"));
  EXPECT_THAT(refusal({lab, "--law", "nonsense", "-o", "out"}), HasSubstr("nonsense"));
  EXPECT_THAT(refusal({"none.csv", "-o", "out"}), HasSubstr("none.csv"));
}

/// As the transcripts have it.
void put_file(const Folder& folder, const std::string& name) {
  folder.write(name, bytes_of(std::string(source) + "/tests/cli/transcripts/files/" + name));
}

TEST(ReportOfRecordings, OptionsGoOverTheFrontsFile) {
  const Folder folder;
  put_file(folder, "swing.csv");
  folder.write("front.toml",
               "title = \"Vorn\"\nauthor = \"A. Student\"\ntext = \"Aus der Datei.\"\nlanguage = \"de\"\n");
  const Finished of_file =
      folder.run({"report", "swing.csv", "--front", "front.toml", "-o", "one", "--quiet"});
  ASSERT_EQ(of_file.status, 0);
  EXPECT_EQ(of_file.err, "");
  const std::string german = folder.read("one/study.toml");
  EXPECT_THAT(german,
              HasSubstr("\ntitle = \"Vorn\"\nbyline = \"A. Student\"\nsummary = \"swing.csv: eine freie "));
  EXPECT_THAT(german, HasSubstr("\nlanguage = \"de\"\n"));
  EXPECT_THAT(german, HasSubstr("\ntext = \"Aus der Datei.\"\n"));
  EXPECT_THAT(folder.read("one/index.html"), HasSubstr("<html lang=\"de\">"));
  const Finished of_both = folder.run({"report", "swing.csv", "--front", "front.toml", "--title", "Over it",
                                       "--author", "B. Student", "--course", "Mechanics", "--text",
                                       "By hand.", "--language", "en", "-o", "two.PDF"});
  ASSERT_EQ(of_both.status, 0) << of_both.err;
  EXPECT_EQ(of_both.out, "two.PDF\n");
  EXPECT_TRUE(folder.read("two.PDF").starts_with("%PDF-"));
  const std::string english = folder.read("two/study.toml");
  EXPECT_THAT(english,
              HasSubstr("\ntitle = \"Over it\"\nbyline = \"B. Student · Mechanics\"\nsummary = \"swing.csv: "
                        "a free swing at "));
  EXPECT_THAT(english, HasSubstr("\ntext = \"By hand.\"\n"));
  EXPECT_THAT(english, Not(HasSubstr("Aus der Datei.")));
  EXPECT_THAT(folder.read("two/index.html"), HasSubstr("<html lang=\"en\">"));
  ASSERT_EQ(folder.run({"report", "swing.csv", "--language", "de", "-o", "three"}).status, 0);
  EXPECT_THAT(folder.read("three/study.toml"), HasSubstr("\nlanguage = \"de\"\n"));
}

TEST(ReportOfRecordings, DrivenMotionsAreNotLaidBesideFreeOnes) {
  const Folder folder;
  put_file(folder, "driven.csv");
  const Finished end = folder.run({"report", "driven.csv", "-o", "out", "--json"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto figures = end.json()["figures"].get<std::vector<std::string>>();
  EXPECT_THAT(figures, ::testing::Contains("out/resonance.svg"));
  EXPECT_THAT(figures, Not(::testing::Contains("out/compared.svg")));
}

TEST(Report, OfWhatAStudyIsMeantToShowIsToldUnlessQuiet) {
  const Folder folder;
  folder.write("study.toml", R"(title = "It grows"

[[task]]
simulate = "grows"
shows = "forward-euler is unstable"
natural_frequency = "1 Hz"
method = "forward-euler"
step = "0.01 s"
until = "1 s"
)");
  const Finished told = folder.run({"report", "study.toml", "-o", "out"});
  EXPECT_EQ(told.status, 0);
  EXPECT_EQ(
      told.err,
      "cromer: as this study is meant to show, grows: forward-euler is unstable for this law whatever the "
      "step: the motion will grow\n");
  const Finished quiet = folder.run({"report", "study.toml", "-o", "out", "--quiet"});
  EXPECT_EQ(quiet.out, "out/index.html\n");
  EXPECT_EQ(quiet.err, "");
}

TEST(Report, IsAFolderOrAPdf) {
  Folder folder;
  folder.write("lab.toml", "title = \"Falls\"\n[[task]]\nsimulate = \"a\"\nuntil = 1\nmethod = \"exact\"\n");
  for (const std::string ending : {"docx", "html", "svg"}) {
    const Finished end = folder.run({"report", "lab.toml", "-o", "lab." + ending});
    EXPECT_EQ(end.status, 2);
    EXPECT_EQ(end.err,
              "cromer: -o lab." + ending + ": a report is a folder or a PDF; write -o lab or -o lab.pdf\n");
    EXPECT_FALSE(folder.has("lab." + ending));
  }
  EXPECT_EQ(folder.run({"report", "lab.toml", "-o", "lab.v2"}).status, 0);
}

TEST(Report, NeedsAStudyAndAFolder) {
  Folder folder;
  EXPECT_THAT(folder.run({"report", "absent.toml", "-o", "out"}).err, HasSubstr("absent.toml"));
  folder.write("s.toml", "[[task]]\nsimulate = \"a\"\n");
  const Finished no_folder = folder.run({"report", "s.toml"});
  EXPECT_EQ(no_folder.status, 2);
  EXPECT_THAT(no_folder.err, HasSubstr("-o"));
  folder.write("file", "");
  const Finished in_the_way = folder.run({"report", "s.toml", "-o", "file"});
  EXPECT_EQ(in_the_way.status, 2);
  EXPECT_THAT(in_the_way.err, HasSubstr("file"));
}

// Of 100 g, 150 g and 200 g on a spring of 12 N/m, as a sensor below sees them, 0.05 mm rounded.
std::string held_masses() {
  std::string bytes =
      "Time (s) Run #1,Position (m) Run #1,Time (s) Run #2,Position (m) Run #2,"
      "Time (s) Run #3,Position (m) Run #3\n";
  for (int i = 0; i < 200; ++i)
    for (int run = 0; run < 3; ++run) {
      const double x = 0.5 - (0.1 + 0.05 * run) * 9.80665 / 12 + 2e-4 * std::sin(1.7 * i * i + run);
      bytes += std::to_string(0.05 * i) + "," + std::to_string(5e-5 * std::round(x / 5e-5)) +
               (run == 2 ? "\n" : ",");
    }
  return bytes;
}

TEST(Report, OfMassesAtRestHasTheSpringConstantAndItsLine) {
  const Folder folder;
  folder.write("held.csv", held_masses());
  const Finished made = folder.run({"report", "held.csv", "--static", "--masses", "100 g, 150 g, 200 g", "-o",
                                    "out", "--author", "A. Student"});
  ASSERT_EQ(made.status, 0) << made.err;
  const auto results = nlohmann::json::parse(folder.read("out/results.json"));
  const double k = results.at("lab.stiffness").at("value"),
               error = results.at("lab.stiffness").at("standard_error");
  EXPECT_NEAR(k, 12, 4 * error);
  EXPECT_LT(error, 0.03);
  EXPECT_NEAR(results.at("lab.2.mass").at("value"), 0.15, 1e-12);
  const std::string page = folder.read("out/index.html");
  for (const char* part :
       {"A. Student", "held.csv, run 3", "150\u00a0g", "Figure 2", "their part is not in the uncertainty",
        "between pole and equator", "whatever the spring"})
    EXPECT_THAT(page, HasSubstr(part));
  // The study makes the same report again.
  const Finished again = folder.run({"report", "out/study.toml", "-o", "again"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(folder.read("again/index.html"), page);
  const Finished german = folder.run({"report", "held.csv", "--static", "--masses", "100 g, 150 g, 200 g",
                                      "--gravity", "9.81 m/s^2", "-o", "de", "--language", "de"});
  ASSERT_EQ(german.status, 0) << german.err;
  EXPECT_THAT(folder.read("de/index.html"), testing::AllOf(HasSubstr("Federkonstante aus ruhenden Massen"),
                                                           HasSubstr("9,81"), Not(HasSubstr("Normwert"))));
}

TEST(Report, OfMassesAtRestRefusesWhatDoesNotFit) {
  const Folder folder;
  folder.write("held.csv", held_masses());
  const auto refused = [&](const std::vector<std::string>& more, const char* what) {
    std::vector<std::string> all{"report", "held.csv", "-o", "out"};
    all.insert(all.end(), more.begin(), more.end());
    const Finished end = folder.run(all);
    EXPECT_EQ(end.status, 2) << what;
    EXPECT_THAT(end.err, HasSubstr(what));
    EXPECT_FALSE(folder.has("out/index.html")) << what;
    EXPECT_FALSE(folder.has("out/study.toml")) << what;
  };
  refused({"--static"}, "--masses");
  refused({"--static", "--masses", "100 g, 150 g"}, "2 masses");
  refused({"--static", "--masses", "100 g, 150 g, 200 g, 250 g"}, "4 masses");
  refused({"--masses", "100 g, 150 g, 200 g"}, "--masses");
  refused({"--gravity", "9.81 m/s^2"}, "--gravity");
  refused({"--static", "--masses", "100 g, 150 g, 200 g", "--law", "viscous"}, "--law has no meaning");
  refused({"--static", "--masses", "100 g, 150 g, -200 g"}, "must not be negative");
}

// Without --static the runs are fitted as swings: that they look like masses at rest is said first.
TEST(Report, SaysThatRunsLookLikeMassesAtRest) {
  const Folder folder;
  folder.write("held.csv", held_masses());
  const Finished end = folder.run({"fit", "held.csv"});
  EXPECT_THAT(end.err, testing::AllOf(HasSubstr("lie apart by much more than they move"),
                                      HasSubstr("--static --masses")));
}

TEST(Report, SaysThatOneRunLooksLikeMassesAtRest) {
  const Folder folder;
  std::string levels = "Time (s),Position (m)\n";
  for (int i = 0; i < 900; ++i)
    levels +=
        std::to_string(0.02 * i) + "," + std::to_string(0.1 + 0.045 * (i / 300) + 2e-4 * (i % 3)) + "\n";
  folder.write("levels.csv", levels);
  const auto says_it = testing::AllOf(HasSubstr("it rests at 3 levels"), HasSubstr("--static --masses"));
  EXPECT_THAT(folder.run({"fit", "levels.csv"}).err, says_it);
  EXPECT_THAT(folder.run({"report", "levels.csv", "-o", "out"}).err, says_it);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
