// The report of one's own recordings: what it says and draws, and what it leaves out, of motions of all
// kinds.
#include "cromer/study/lab_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "cromer/documents/text/words.h"
#include "cromer/documents/words/words.h"
#include "cromer/study/write_report.h"
#include "tests/study/collected.h"
#include "tests/support/bytes_of.h"
#include "tests/support/shared_data.h"
#include "tests/support/written_down.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

using Motion = std::function<double(double)>;

/// Samples 50 times a second, with noise of 0.1 mm.
std::string recorded(const Motion& x, double until) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 1e-4);
  std::string bytes = "Time (s),Position (m)\n";
  for (int i = 0; i < 50 * until; ++i)
    bytes += shortest(0.02 * i) + ',' + shortest(0.3 + x(0.02 * i) + noise(random)) + '\n';
  return bytes;
}

Motion decaying(double rate, double w = 6) {
  return [=](double t) { return 0.05 * std::exp(-rate * t) * std::cos(w * t); };
}

struct Made {
  std::vector<ReportedRecording> recordings;
  std::string toml;
  Study study{};
  Results results{};
  Page page{};

  /// Every text of the page.
  std::string text() const {
    std::string all = page.title + "\n" + page.summary + "\n";
    for (const KeyFigure& each : page.key_figures) all += each.name + ": " + each.value + "\n";
    for (const Block& block : page.blocks) {
      if (const auto* heading = std::get_if<Heading>(&block)) all += "# " + heading->text + "\n";
      if (const auto* paragraph = std::get_if<Paragraph>(&block)) all += paragraph->text + "\n";
      if (const auto* figure = std::get_if<FigureBlock>(&block))
        all += figure->label + ". " + figure->caption + "\n";
      if (const auto* table = std::get_if<TableBlock>(&block))
        for (const auto& row : table->rows)
          for (const auto& cell : row) all += cell + "|";
    }
    return all;
  }
  std::vector<std::string> figures() const {
    std::vector<std::string> ids;
    for (const FigureSpec& each : study.figures) ids.push_back(each.look.id);
    return ids;
  }
};

Made report(const std::vector<std::pair<std::string, std::string>>& files,
            const std::vector<TypedOption>& typed = {}, const ReportFront& front = {}) {
  Made made;
  FitOptions options;
  EXPECT_TRUE(assign(typed, options_of(options), "fit"));
  for (const auto& [name, bytes] : files) {
    const auto recording = read_recording(bytes, name, options.read);
    EXPECT_TRUE(recording) << (recording ? "" : in_words(recording.error()));
    auto fits = fit(*recording, options);
    EXPECT_TRUE(fits);
    for (FittedRecording& fitted : *fits) {
      ReportedRecording& each = made.recordings.emplace_back();
      each.path = name;
      each.fitted = std::move(fitted);
      CompareOptions compare;
      compare.fit = options;
      compare.method = {report_method};
      if (each.fitted.succeeded() && !each.fitted.driven)
        if (auto compared = compare_fitted(each.fitted, compare)) each.compared = *std::move(compared);
    }
  }
  made.toml = lab_report(made.recordings, typed, front);
  const auto study = read_study(made.toml, "study.toml");
  EXPECT_TRUE(study) << (study ? "" : in_words(study.error())) << "\n" << made.toml;
  if (!study) return made;
  made.study = *study;
  const auto run = run_study(*study, {}, {}, known_results(made.recordings));
  EXPECT_TRUE(run) << (run ? "" : in_words(run.error()));
  if (!run) return made;
  EXPECT_EQ(in_words(run->failure), "");
  made.results = run->results;
  std::map<std::string, DrawnFigure> drawn;
  for (const FigureSpec& spec : study->figures) {
    const auto figure = make_figure(spec, run->results);
    EXPECT_TRUE(figure) << (figure ? "" : in_words(figure.error()));
    if (figure) drawn[spec.look.id] = {"", figure->title, figure->caption, spec.width};
  }
  const auto page = make_page(*study, run->results, drawn, "");
  EXPECT_TRUE(page) << (page ? "" : in_words(page.error()));
  if (page) made.page = *page;
  return made;
}

constexpr const char* lab_two = CROMER_SOURCE_DIR "/data/recording2.csv";

TEST(LabReport, IsTheWholeSecondLab) {
  const Made lab = report({{"lab.csv", bytes_of(lab_two)}},
                          {{"mass", "217.6 ± 0.3 g"}, {"disc-diameter", "12 cm"}, {"segment", "30 s"}});
  EXPECT_THAT(lab.figures(),
              testing::ElementsAre("record", "swings", "residuals", "decay", "compared", "reynolds",
                                   "position", "velocity", "portrait", "energy", "phase"));
  const std::string text = lab.text();
  EXPECT_THAT(text, HasSubstr("The decay rate falls from"));
  EXPECT_THAT(text, HasSubstr("One decay rate is not enough."));
  EXPECT_THAT(text, HasSubstr("100 % of its variance comes from the mass."));
  EXPECT_THAT(text, HasSubstr("A drag in proportion to the velocity (Stokes) needs Re well below 1"));
  EXPECT_THAT(text, HasSubstr("The spring's own mass, a third of which moves along, is not counted"));
  EXPECT_THAT(text, HasSubstr("its kinematic viscosity *ν* is then 1.51"));
  EXPECT_THAT(text, HasSubstr("Your disc's diameter has no ±"));
  EXPECT_THAT(text, Not(HasSubstr("could not be told")));
}

/// The study file but for its sum, which changes with the last digit of any number, and the texts of its
/// page, as they are written down in the tree.
void expect_report_as_written_down(const Made& lab, const std::string& name) {
  test::expect_as_written_down(lab.toml.substr(lab.toml.find('\n') + 1) + "\n====\n" + lab.text(),
                               CROMER_SOURCE_DIR "/tests/study/lab_reports/" + name + ".txt");
}

TEST(LabReportWrittenDown, OfASwingWithMassAndDisc) {
  expect_report_as_written_down(
      report({{"lab.csv", bytes_of(lab_two)}},
             {{"mass", "217.6 ± 0.3 g"}, {"disc-diameter", "12 cm"}, {"segment", "30 s"}}),
      "mass_and_disc");
}

TEST(LabReportWrittenDown, OfASwingOfWhichNothingElseIsKnown) {
  expect_report_as_written_down(report({{"lab.csv", recorded(decaying(0.1), 30)}}), "nothing_else");
}

TEST(LabReportWrittenDown, OfASwingThatGrows) {
  expect_report_as_written_down(
      report({{"lab.csv", recorded(decaying(-0.05), 25)}}, {{"mass", "0.2 kg"}, {"law", "viscous"}}),
      "grows");
}

TEST(LabReportWrittenDown, OfAnAngle) {
  std::string bytes = recorded(decaying(0.08), 25);
  bytes.replace(bytes.find("Position (m)"), 12, "Angle (rad)");
  expect_report_as_written_down(report({{"lab.csv", bytes}}, {{"law", "viscous+drag"}}), "angle");
}

TEST(LabReportWrittenDown, OfAVelocity) {
  std::string bytes = recorded(decaying(0.08), 25);
  bytes.replace(bytes.find("Position (m)"), 12, "Velocity (m/s)");
  expect_report_as_written_down(report({{"lab.csv", bytes}}, {{"mass", "0.2 ± 0.01 kg"}}), "velocity");
}

TEST(LabReportWrittenDown, OfAnAcceleration) {
  std::string bytes = recorded(decaying(0.08), 25);
  bytes.replace(bytes.find("Position (m)"), 12, "Acceleration (m/s^2)");
  expect_report_as_written_down(report({{"lab.csv", bytes}}), "acceleration");
}

TEST(LabReportWrittenDown, OfAMotionDrivenAtAKnownFrequency) {
  const auto x = [](double t) {
    return 0.02 * std::cos(7 * t - 1) + 0.04 * std::exp(-0.15 * t) * std::cos(6 * t);
  };
  expect_report_as_written_down(
      report({{"lab.csv", recorded(x, 60)}}, {{"drive-frequency", "7 rad/s"}, {"mass", "0.2 kg"}}), "driven");
}

TEST(LabReportWrittenDown, OfSeveralOfWhichOneFails) {
  ReportFront front;
  front.language = Language::german;
  front.title = "Zwei Federn";
  front.author = "A. Muster";
  front.course = "Praktikum";
  front.text = "Mein *eigener* Text.";
  front.aim = "Die Federkonstante.";
  front.apparatus = "Eine Feder.";
  front.conclusion = "Sie passt.";
  expect_report_as_written_down(report({{"one.csv", recorded(decaying(0.1), 30)},
                                        {"two.csv", recorded([](double t) { return 0.01 * t; }, 10)},
                                        {"three.csv", recorded(decaying(0.3, 9), 15)}},
                                       {{"mass", "200 g"}}, front),
                                "several");
}

// The sums that the authors of FNV-1a publish for these texts.
TEST(LabReport, ItsMarkIsAKnownSum) {
  EXPECT_TRUE(is_as_made("# cromer report cbf29ce484222325\n"));
  EXPECT_TRUE(is_as_made("# cromer report af63dc4c8601ec8c\na"));
  EXPECT_TRUE(is_as_made("# cromer report 85944171f73967e8\nfoobar"));
  EXPECT_FALSE(is_as_made("# cromer report 85944171f73967e8\nfoobas"));
  EXPECT_FALSE(is_as_made("# cromer report cbf29ce484222325"));
  EXPECT_FALSE(is_as_made("# another report cbf29ce484222325\n"));
}

TEST(LabReport, FollowsAnOptionThatIsChanged) {
  const Made lab = report({{"recording2.csv", bytes_of(lab_two)}}, {{"mass", "217.6 g"}});
  std::string heavier = lab.toml;
  heavier.replace(heavier.find("217.6 g"), 7, "435.2 g");
  EXPECT_TRUE(is_as_made(lab.toml));
  EXPECT_FALSE(is_as_made(heavier));
  const auto study = read_study(heavier, std::string(CROMER_SOURCE_DIR) + "/data/study.toml");
  ASSERT_TRUE(study);
  const auto run = run_study(*study);
  ASSERT_TRUE(run) << in_words(run.error());
  EXPECT_NEAR(value(run->results, "lab.stiffness"), 2 * value(lab.results, "lab.stiffness"), 1e-9);
  EXPECT_NEAR(value(run->results, "lab_methods.1.energy_start"),
              2 * value(lab.results, "lab_methods.1.energy_start"), 1e-9);
}

TEST(LabReport, WithoutMassAndDiscSaysNothingOfThem) {
  const Made lab = report({{"lab.csv", recorded(decaying(0.1), 30)}});
  const std::string text = lab.text();
  EXPECT_GE(lab.figures().size(), 8u);
  EXPECT_THAT(text, HasSubstr("No spring constant: it follows with the mass (--mass)."));
  EXPECT_THAT(text, HasSubstr("No Reynolds number"));
  EXPECT_THAT(text, Not(HasSubstr("Your mass")));
  EXPECT_THAT(text, Not(HasSubstr(" J")));
  EXPECT_THAT(text, Not(HasSubstr("N/m")));
  EXPECT_THAT(text, HasSubstr("One decay rate is enough"));
  EXPECT_THAT(text, HasSubstr("The decay rate is"));
  // A step of forward Euler multiplies the energy by 1 + w² h² beside the law's own decay.
  const double w = 6, h = value(lab.results, "lab_methods.1.step"),
               steps = value(lab.results, "lab_methods.1.steps");
  EXPECT_NEAR(
      value(lab.results, "lab_methods.1.energy_ratio") / value(lab.results, "lab_exact.1.energy_ratio"),
      std::pow(1 + w * w * h * h, steps), 0.1);
}

TEST(LabReport, OfThreeCyclesHasNoRatesByAmplitude) {
  const Made lab = report({{"lab.csv", recorded(decaying(0.2), 3.2)}}, {{"mass", "0.2 kg"}});
  EXPECT_THAT(lab.figures(), Not(testing::Contains("decay")));
  EXPECT_THAT(lab.text(), HasSubstr("Your mass has no ±, so its part is not in the uncertainty."));
  EXPECT_THAT(lab.text(), Not(HasSubstr("of its variance")));
}

TEST(LabReport, OfAStronglyDampedSwing) {
  const Made lab = report({{"lab.csv", recorded(decaying(1.5), 6)}}, {{"mass", "0.2 ± 0.01 kg"}});
  EXPECT_THAT(lab.text(), HasSubstr("How stiff the spring is"));
  EXPECT_THAT(lab.figures(), testing::Contains("energy"));
}

TEST(LabReport, OfASwingThatFrictionStopsTellsNothingOfWhatFollows) {
  // Half waves about both balance points, 1.9 mm to either side, until the next would stop within them.
  const auto x = [](double t) {
    const double w = 6, stuck = 1.9e-3, half = M_PI / w;
    double top = 0.05;
    int n = 0;
    while (t > half && std::abs(top) > stuck) {
      top = -(top - std::copysign(2 * stuck, top));
      t -= half;
      ++n;
    }
    if (std::abs(top) <= stuck) return top;
    const double middle = std::copysign(stuck, top);
    return middle + (top - middle) * std::cos(w * t);
  };
  const Made lab = report({{"lab.csv", recorded(x, 20)}}, {{"mass", "0.2 kg"}});
  const FittedRecording& fitted = lab.recordings.front().fitted;
  ASSERT_TRUE(fitted.succeeded());
  for (const AmplitudeRate& each : fitted.decay_by_amplitude) EXPECT_GT(each.amplitude, 1e-3) << each.from;
}

TEST(LabReport, OfADrivenMotionHasItsResonance) {
  const auto x = [](double t) {
    return 0.02 * std::cos(7 * t - 1) + 0.04 * std::exp(-0.15 * t) * std::cos(6 * t);
  };
  Made lab = report({{"lab.csv", recorded(x, 60)}}, {{"drive-frequency", "7 rad/s"}});
  ASSERT_TRUE(lab.recordings.front().fitted.driven);
  EXPECT_THAT(lab.text(), HasSubstr("a motion driven at 1.114084"));
  EXPECT_THAT(lab.text(), Not(HasSubstr("# How the swing dies down")));
  EXPECT_THAT(lab.page.summary, HasSubstr("The motion beats at first, every 6.28 s: "));
  EXPECT_THAT(lab.text(), HasSubstr("angular frequency of the drive|"));
  EXPECT_THAT(lab.figures(), testing::IsSupersetOf({"swings", "position", "resonance", "lag"}));
  EXPECT_THAT(lab.figures(), Not(testing::Contains("energy")));
  const auto of_rivals = HasSubstr("may give the peak another height");
  std::vector<Notice>& notices = lab.recordings.front().fitted.notices;
  std::erase_if(notices, [](const Notice& each) { return each.code == "rival_laws_of_a_fed_swing"; });
  EXPECT_THAT(lab_report(lab.recordings, {}, {}), Not(of_rivals));
  notices.push_back(Notice{"rival_laws_of_a_fed_swing", {{"law", "viscous"}, {"rivals", "drag"}}});
  EXPECT_THAT(lab_report(lab.recordings, {}, {}), of_rivals);
}

TEST(LabReport, ShowsForwardEulerUntilItLeavesTheSpring) {
  // x'' = -36 x + 1500 x^3 - 0.05 x' has an end at 15.5 cm.
  const auto slope = [](double x, double v) { return -36 * x + 1500 * x * x * x - 0.05 * v; };
  const double h = 1e-3;
  std::vector<double> path{0.12};
  for (double x = path[0], v = 0; path.size() < 30000; path.push_back(x)) {
    v += 0.5 * h * slope(x, v);
    x += h * v;
    v = (v + 0.5 * h * (-36 * x + 1500 * x * x * x)) / (1 + 0.025 * h);
  }
  const auto x = [&](double t) {
    return path[std::min(path.size() - 1, static_cast<std::size_t>(std::llround(t / h)))];
  };
  const Made lab = report({{"lab.csv", recorded(x, 25)}});
  EXPECT_THAT(lab.text(), HasSubstr("before forward Euler goes to where the spring gives way"));
  EXPECT_THAT(lab.figures(), testing::IsSupersetOf({"decay", "frequencies", "position", "energy", "phase"}));
  EXPECT_THAT(lab.text(), HasSubstr("The frequency of the same"));
}

TEST(LabReport, OfAnUnknownLengthNamesNoJoulesAndNoMetres) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.02);
  std::string bytes = "Time (s),Position (au)\n";
  double x = 30, v = 0;
  for (int i = 0; i < 40 * 1500; ++i) {
    if (i % 40 == 0) bytes += shortest(0.02 * (i / 40)) + ',' + shortest(471 + x + noise(random)) + '\n';
    v -= 5e-4 * (36 * x + 0.02 * x * x * x + 0.1 * v);
    x += 5e-4 * v;
  }
  const Made lab = report({{"lab.csv", bytes}}, {{"mass", "0.1 kg"}, {"law", "viscous+cubic"}});
  const FittedRecording& fitted = lab.recordings.front().fitted;
  ASSERT_TRUE(fitted.succeeded());
  EXPECT_THAT(lab.text(), Not(HasSubstr("of several laws")));
  EXPECT_EQ(named(fitted.parameters, "stiffness")->unit, "N/m");
  EXPECT_EQ(named(fitted.parameters, "cubic_stiffness")->unit, "kg/(au² s²)");
  EXPECT_THAT(lab.text(), Not(testing::ContainsRegex("J|[0-9](\u00a0| )m[ ,.;]|N/m³")));
}

TEST(LabReport, SaysOfHowManySamplesAPartIs) {
  const Made lab = report({{"lab.csv", recorded(decaying(0.05), 30)}}, {{"from", "10 s"}});
  EXPECT_THAT(lab.text(), HasSubstr("lab.csv, column \"Position (m)\": 1000 of 1500 samples, those from "
                                    "10.00\u00a0s to 29.98\u00a0s, in 19.98"));
  EXPECT_THAT(lab.text(), HasSubstr("The recording, 1000 of 1500 samples, and the rest position"));
}

// A phone that is swung by hand at first: the law's numbers are those of no swing.
TEST(LabReport, OfAMotionThatNoLawDescribesHasNoHeadline) {
  const std::string path = data("pendulum-phyphox/RawData_converted_from_xls.csv");
  SKIP_WITHOUT(path);
  const Made lab = report({{"raw.csv", bytes_of(path)}}, {{"from", "0 s"}});
  ASSERT_TRUE(lab.recordings.front().fitted.succeeded());
  EXPECT_THAT(lab.text(), HasSubstr("raw.csv: no law that was tried describes this motion."));
  EXPECT_THAT(lab.text(), Not(HasSubstr("a free swing at")));
  EXPECT_EQ(lab.study.key_figures.size(), 0u);
}

TEST(LabReport, WithoutALawPrintsNoUncertaintyThatIsTheLaws) {
  const std::string path = data("spring-disc-pasco/molla_durissima_discopieno_14.91945_0.2016_1.csv");
  SKIP_WITHOUT(path);
  const Made lab =
      report({{"hard.csv", bytes_of(path)}}, {{"mass", "201.6 ± 0.1 g"}, {"disc-diameter", "12 cm"}});
  ASSERT_THAT(lab.text(), HasSubstr("No law tried describes this recording"));
  EXPECT_THAT(lab.text(), HasSubstr("the rest position by the law"));
  EXPECT_THAT(lab.text(), HasSubstr("the rest position by the law, 41.68\u00a0cm"));
  EXPECT_THAT(lab.text(), HasSubstr("is 4780 at its largest"));
  EXPECT_THAT(lab.text(), HasSubstr("the frequency of 1.34\u00a0Hz is that of swings"));
  EXPECT_THAT(lab.text(), Not(HasSubstr("is not in the uncertainty")));
}

TEST(LabReport, SaysWhatRoundingLeavesAndWhichSwingsAFrequencyIsOf) {
  const std::string path = data("spring-disc-pasco/molla_dura_discopieno_0.1223kg.csv");
  SKIP_WITHOUT(path);
  const Made lab = report({{"dura.csv", bytes_of(path)}}, {{"mass", "122.3 g"}});
  // 3.34 mm where rounding to a centimetre makes 2.89.
  EXPECT_THAT(lab.text(), HasSubstr("most of it from rounding them to steps of 1"));
  EXPECT_THAT(lab.text(), HasSubstr("Hz is that of swings of 9.22"));
}

TEST(LabReport, WhereNoMotionIsFoundNothingLiesFarFromIt) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.01);
  std::string bytes = "Time (s),Position (m)\n";
  for (int i = 0; i < 300; ++i)
    bytes += shortest(0.02 * i) + ',' + shortest(noise(random) + (i == 150)) + '\n';
  const Made lab = report({{"lab.csv", bytes}});
  ASSERT_FALSE(lab.recordings.front().fitted.succeeded());
  ASSERT_FALSE(lab.recordings.front().fitted.series.outliers.empty());
  EXPECT_THAT(lab.text(), Not(HasSubstr("far from the motion")));
}

/// A mass of 2 kg under a force of two tones, with what else acts on it, recorded at 50 Hz.
std::string pushed(const std::function<double(double v, double x, double& z, double dt)>& resistance) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 1e-4);
  std::string bytes = "Time (s),Position (m),Force (N)\n";
  constexpr double dt = 5e-4;
  double x = 0, v = 0, z = 0;
  for (int i = 0; i < 40 * 600; ++i) {
    const double t = dt * i, force = 4 * std::sin(1.9 * t) + 3 * std::sin(5.3 * t);
    if (i % 40 == 0)
      bytes += shortest(0.02 * (i / 40)) + ',' + shortest(x + noise(random)) + ',' + shortest(force) + '\n';
    v += dt / 2 * (force - resistance(v, x, z, dt));
    x += dt * v;
  }
  return bytes;
}

TEST(LabReport, OfAMotionWithoutASpringNamesNoRestPosition) {
  const auto damper = [](double v, double, double&, double) { return 3 * v; };
  const Made lab = report({{"lab.csv", pushed(damper)}}, {{"force-column", "Force"}, {"no-spring", "true"}});
  ASSERT_TRUE(lab.recordings.front().fitted.succeeded());
  EXPECT_THAT(lab.page.summary, HasSubstr("lab.csv: a driven motion."));
  EXPECT_THAT(lab.figures(), testing::IsSupersetOf({"record", "swings", "residuals"}));
  EXPECT_THAT(lab.text(), Not(HasSubstr("rest position")));
  EXPECT_THAT(lab.text(), Not(HasSubstr("spring constant")));
}

TEST(LabReport, OfHysteresisNamesNoFrequencyOfItsOwn) {
  const auto link = [](double v, double x, double& z, double dt) {
    z += dt * (20 * v - 400 * std::abs(v) * z - 200 * v * std::abs(z));
    return 2 * v + 20 * x + z;
  };
  const Made lab =
      report({{"lab.csv", pushed(link)}}, {{"force-column", "Force"}, {"law", "viscous+hysteresis"}});
  ASSERT_TRUE(lab.recordings.front().fitted.succeeded());
  EXPECT_THAT(lab.page.summary, HasSubstr("lab.csv: a driven motion."));
}

TEST(LabReport, OfAFailedFitSaysWhyAndDrawsTheRecording) {
  const Made lab = report({{"lab.csv", recorded([](double t) { return 0.01 * t; }, 10)}});
  EXPECT_THAT(lab.figures(), testing::ElementsAre("record"));
  EXPECT_THAT(lab.text(), HasSubstr("no law of motion is given. The reason: "));
  EXPECT_TRUE(lab.page.key_figures.empty());
}

// Who reads the summary alone learns there that one mass stands for two.
/// Two runs of one file, with noise of 0.1 mm.
std::string two_runs(const Motion& one, const Motion& other) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 1e-4);
  std::string bytes = "Time (s) Run #1,Position (m) Run #1,Time (s) Run #2,Position (m) Run #2\n";
  for (int i = 0; i < 1000; ++i) {
    const double t = 0.02 * i;
    bytes += shortest(t) + ',' + shortest(one(t) + noise(random)) + ',' + shortest(t) + ',' +
             shortest(other(t) + noise(random)) + '\n';
  }
  return bytes;
}

TEST(LabReport, SaysWhetherItMayHaveBeenOneSpring) {
  const std::vector<TypedOption> masses{{"mass", "200 g, 300 g"}};
  const double slower = 6 / std::sqrt(1.5);
  EXPECT_THAT(report({{"two.csv", two_runs(decaying(0.1, 6), decaying(0.07, slower))}}, masses).text(),
              HasSubstr("The spring constants agree within their uncertainties"));
  EXPECT_THAT(report({{"two.csv", two_runs(decaying(0.1, 6), decaying(0.07, 1.01 * slower))}}, masses).text(),
              HasSubstr("The spring constants differ by more than their uncertainties"));
  EXPECT_THAT(report({{"two.csv", two_runs(decaying(0.1, 6), decaying(0.07, slower))}}).text(),
              Not(HasSubstr("The spring constants")));
}

TEST(LabReport, OneMassForUnlikeRunsIsSaidInTheSummary) {
  const Made lab = report({{"two.csv", two_runs(decaying(0.1, 6), decaying(0.1, 7))}}, {{"mass", "0.2 kg"}});
  ASSERT_EQ(lab.recordings.size(), 2u);
  EXPECT_THAT(lab.page.summary, HasSubstr("and one mass is used for all"));
}

// Rounding is no law's fault.
TEST(LabReport, OfCoarseValuesNamesTheRounding) {
  std::string bytes = "Time (s),Position (m)\n";
  for (int i = 0; i < 3000; ++i)
    bytes += shortest(0.005 * i) + ',' + shortest(std::round(decaying(0.02)(0.005 * i) * 100) / 100) + '\n';
  const std::string text = report({{"lab.csv", bytes}}).text();
  EXPECT_THAT(text, HasSubstr("no more than rounding them to steps of 1 cm makes"));
  EXPECT_THAT(text, Not(HasSubstr("there is a pattern in it")));
}

TEST(LabReport, OfATurningBodyHasAMomentOfInertia) {
  std::string bytes = "Time (s),Angular velocity (rad/s)\n";
  for (int i = 0; i < 1500; ++i)
    bytes += shortest(0.02 * i) + ',' + shortest(decaying(0.05)(0.02 * i)) + '\n';
  EXPECT_THAT(report({{"gyro.csv", bytes}}).text(), HasSubstr("I x''"));
}

TEST(LabReport, OfSeveralHasATableAndEachByItself) {
  const Made lab = report({{"one.csv", recorded(decaying(0.1), 30)},
                           {"two.csv", recorded([](double t) { return 0.01 * t; }, 10)}});
  EXPECT_EQ(lab.page.title, "The laws of motion of 2 recordings");
  EXPECT_THAT(lab.text(), HasSubstr("# one.csv: What was measured"));
  EXPECT_THAT(lab.text(), HasSubstr("two.csv|–|–|"));  // frequency and decay rate: no mass, no disc, one rate
  EXPECT_THAT(lab.figures(), testing::IsSupersetOf({"lab_1-record", "lab_1-energy", "lab_2-record"}));
}

// A force that drives something else: the law is refused, and nothing of it is drawn.
TEST(LabReport, OfAForceThatDoesNotDriveTheMotion) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  std::string bytes = "Time (s),Position (m),Force (N)\n";
  for (int i = 0; i < 300; ++i) {
    const double x = normal(random), force = std::sin(0.31 * i) + std::sin(0.05 * i);
    bytes += shortest(0.05 * i) + ',' + shortest(x) + ',' + shortest(force) + '\n';
  }
  const Made lab = report({{"lab.csv", bytes}}, {{"force-column", "Force (N)"}, {"law", "viscous"}});
  ASSERT_FALSE(lab.recordings[0].fitted.fit.message.empty());
  EXPECT_EQ(lab.recordings[0].fitted.fit.message.code, "force_explains_too_little");
  EXPECT_THAT(lab.figures(), testing::ElementsAre("record"));
}

TEST(LabReport, SpeaksGermanWithDecimalCommas) {
  ReportFront front;
  front.language = Language::german;
  front.author = "A. {Muster}";
  front.text = "Mein *eigener* Text.";
  front.aim = "Die Federkonstante.";
  front.conclusion = "Sie passt.";
  const Made lab = report({{"a_{1}.csv", recorded(decaying(0.1), 30)}}, {{"mass", "217.6 ± 0.3 g"}}, front);
  EXPECT_EQ(lab.page.language, "de");
  EXPECT_THAT(lab.page.byline, HasSubstr("A. {Muster}"));
  const std::string text = lab.text();
  EXPECT_THAT(
      text,
      HasSubstr(
          "Mit einer Masse von 217,6\u00a0±\u00a00,3\u00a0g ohne die der Feder ist die Federkonstante"));
  EXPECT_THAT(text, HasSubstr("Abbildung 1."));
  EXPECT_THAT(text, HasSubstr("Mein *eigener* Text.\n# Ziel\nDie Federkonstante.\n# Was gemessen wurde"));
  EXPECT_THAT(text, HasSubstr("# Schluss\nSie passt.\n"));
  EXPECT_THAT(text, HasSubstr("ist viscous (viskose Dämpfung) gewählt"));
  for (const char* english : {" the ", "Figure", " rate", "swing "})
    EXPECT_THAT(text, Not(HasSubstr(english)));
  EXPECT_THAT(text, Not(testing::ContainsRegex("[0-9]\\.[0-9]")));
}

TEST(LabReport, KeepsAUnitThatIsNotKnown) {
  std::string bytes = recorded(decaying(0.1), 30);
  bytes.replace(bytes.find("Position (m)"), 12, "Signal (au)");
  const Made lab = report({{"lab.csv", bytes}});
  EXPECT_THAT(lab.text(), HasSubstr("\u00a0au (root mean square)"));
  EXPECT_THAT(in_words(*lab.recordings.front().fitted.find("velocity"),
                       named(lab.recordings.front().fitted.parameters, "velocity")->unit),
              HasSubstr("au/s"));
}

TEST(LabReport, NamesAndValuesStandForThemselves) {
  std::string bytes = recorded(decaying(0.1), 30);
  bytes.replace(bytes.find("Position (m)"), 12, "\"a \"\"{x}\"\" \\ (m)\"");
  const Made lab = report({{"a {b} \"c\" \\d.csv", bytes}}, {{"column", "a \"{x}\" \\ (m)"}});
  EXPECT_EQ(lab.page.title, "The law of motion in a {b} \"c\" \\d.csv");
}

/// A pendulum whose bob meets still air: one rate, at swings that are slower where they are wide.
double wide_pendulum(double t) {
  static const std::vector<double> angles = [] {
    std::vector<double> all;
    double x = 1.2, v = 0;
    for (int i = 0; i < 41000; ++i) {
      all.push_back(x);
      v -= 0.0005 * (24 * std::sin(x) + 0.1 * v);
      x += 0.001 * v;
      v -= 0.0005 * (24 * std::sin(x) + 0.1 * v);
    }
    return all;
  }();
  return angles[static_cast<std::size_t>(std::lround(1000 * t))];
}

TEST(LabReport, TheOneRateHasTheLawsFrequency) {
  std::string bytes = recorded(wide_pendulum, 40);
  bytes.replace(bytes.find("Position (m)"), 12, "Angle (rad)");
  const Made lab = report({{"wide.csv", bytes}});
  ASSERT_TRUE(lab.recordings[0].compared);
  const auto& curves = lab.recordings[0].compared->curves;
  EXPECT_LT(curves[0].rms, 2 * curves[1].rms);
  EXPECT_THAT(lab.text(), HasSubstr("Viscous damping alone is enough"));
}

// A spring that softens too far holds no swing of the amplitude: then there is no frequency to tell.
TEST(LabReport, WithoutAFrequencySaysNothingOfIt) {
  Made lab = report({{"lab.csv", recorded(decaying(0.05), 20)}});
  FittedRecording& fitted = lab.recordings.front().fitted;
  for (auto* list : {&fitted.headline, &fitted.parameters, &fitted.derived})
    for (Parameter& each : *list)
      if (each.name == "frequency" || each.name == "period" || each.name == "quality_factor")
        each.estimate.value = NAN;
  lab.recordings.front().compared.reset();
  const std::string toml = lab_report(lab.recordings, {}, {});
  EXPECT_THAT(toml, HasSubstr("lab.csv: a free motion."));
  for (const char* gone :
       {"a free swing at", "name = \"frequency\"", ".period", ".quality_factor", ".at_amplitude"})
    EXPECT_THAT(toml, Not(HasSubstr(gone)));
}

TEST(LabReport, WhatIsInDoubtHasNoVerdictInTheSummary) {
  // A second swing that no law has.
  const Made lab = report(
      {{"two.csv",
        recorded([](double t) { return decaying(0.05)(t) + 0.01 * std::exp(-0.02 * t) * std::cos(7.3 * t); },
                 40)}},
      {{"law", "viscous+drag"}});
  EXPECT_THAT(lab.page.summary,
              HasSubstr("The decay rate of parts of the recording, each fitted by itself, is"));
  EXPECT_THAT(lab.page.summary, HasSubstr("a free swing, at first at 0.9"));
  EXPECT_THAT(lab_report(lab.recordings, {}, {}),
              HasSubstr("What the chosen law gives, without uncertainties"));
  EXPECT_THAT(lab.page.summary, Not(HasSubstr("falls")));
  EXPECT_THAT(lab.text(), AllOf(HasSubstr("decay rate of the first part"), Not(HasSubstr("assumed")),
                                Not(HasSubstr("quality factor: ")), Not(HasSubstr("are widened"))));
}

// Where the rate is lowest between the ends, the ends alone would tell of a constant one.
TEST(LabReport, GivesTheExtremesOfRatesThatAreNotThoseOfTheEnds) {
  Made lab = report({{"lab.csv", recorded(decaying(0.05), 30)}}, {});
  FittedRecording& fitted = lab.recordings.front().fitted;
  fitted.notices.push_back(Notice{"no_law_describes", {{"times", 5.0}}});
  lab.recordings.front().compared.reset();
  const auto of = [&](const std::vector<double>& rates) {
    fitted.decay_by_amplitude.clear();
    for (const double rate : rates)
      fitted.decay_by_amplitude.push_back({0, 0, 0.05, make_estimate(rate, 0.001, 2), {}, 0.05, 0});
    return lab_report(lab.recordings, {}, {});
  };
  EXPECT_THAT(of({0.05, 0.045, 0.039, 0.049}),
              HasSubstr("is between {lab.lowest_stretch}, at an amplitude of "
                        "{lab.lowest_stretch.amplitude, cm, 3}, and {lab.highest_stretch}, at "));
  for (const auto& rates : {std::vector{0.05, 0.045, 0.04}, std::vector{0.04, 0.045, 0.05}})
    EXPECT_THAT(of(rates), HasSubstr("is {lab.first_stretch} at an amplitude of "));
}

TEST(LabReport, SaysWhichTermMakesTheRateChange) {
  const double w = 6;
  const Motion by_friction = [=](double t) { return 0.05 * std::max(0.0, 1 - t / 60) * std::cos(w * t); },
               by_drag = [=](double t) { return 0.05 / (1 + t / 15) * std::cos(w * t); };
  EXPECT_THAT(report({{"lab.csv", recorded(by_friction, 40)}}).text(),
              HasSubstr("it rises because dry friction"));
  EXPECT_THAT(report({{"lab.csv", recorded(by_drag, 40)}}).text(), HasSubstr("it falls because drag"));
  EXPECT_THAT(report({{"lab.csv", recorded(decaying(0.05), 40)}}).text(), Not(HasSubstr("because d")));
}

TEST(LabReport, GivesTheRateThatLawsOfOtherTrendsHaveInCommon) {
  Made lab = report({{"lab.csv", recorded(decaying(0.05), 30)}}, {});
  lab.recordings.front().fitted.common_decay = MeanDecay{0.02, {0.05, 0.004, 0.042, 0.058}};
  lab.recordings.front().fitted.decay_by_amplitude.clear();
  lab.recordings.front().compared.reset();
  const std::string toml = lab_report(lab.recordings, {}, {});
  EXPECT_THAT(toml,
              AllOf(HasSubstr("The decay rate is {lab.common_decay} at the swing's rms amplitude, "
                              "{lab.common_decay.amplitude, cm, 3};"),
                    HasSubstr("value = \"{lab.common_decay, concise}\""), Not(HasSubstr("One decay rate"))));
}

TEST(ReportFront, IsReadFromToml) {
  const auto front = read_report_front("title = \"T\"\nauthor = \"A\"\nlanguage = \"de\"\n", "front.toml");
  ASSERT_TRUE(front);
  EXPECT_EQ(front->title, "T");
  EXPECT_EQ(front->author, "A");
  EXPECT_EQ(front->language, Language::german);
  const auto wrong = read_report_front("titel = \"T\"\n", "front.toml");
  ASSERT_FALSE(wrong);
  EXPECT_THAT(in_words(wrong.error()),
              HasSubstr("front.toml:1:9: \"titel\" is not known here; did you mean \"title\"?"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
