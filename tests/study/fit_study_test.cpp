#include "cromer/study/fit_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "cromer/documents/words/words.h"
#include "cromer/study/run_study.h"
#include "cromer/study/write_report.h"
#include "cromer/tasks/option/option.h"
#include "tests/study/collected.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace {

using testing::HasSubstr;

const std::string files = std::string(CROMER_SOURCE_DIR) + "/data/";

FittedRecording fitted(const std::string& bytes, const std::string& name,
                       const std::vector<TypedOption>& typed) {
  FitOptions options;
  EXPECT_TRUE(assign(typed, options_of(options), "fit"));
  const auto recording = read_recording(bytes, name, options.read);
  EXPECT_TRUE(recording);
  const auto fits = fit(*recording, options);
  EXPECT_TRUE(fits);
  return fits->front();
}

TEST(FitStudy, FitsTheSame) {
  const std::vector<TypedOption> typed{{"mass", "217.6 ± 0.3 g"},
                                       {"from", "10"},
                                       {"to", "100 s"},
                                       {"law", "viscous+drag"},
                                       {"disc-diameter", "12 cm"}};
  const FittedRecording fit = fitted(bytes_of(files + "recording2.csv"), "recording2.csv", typed);
  const auto study = read_study(fit_study(fit, typed), files + "study.toml");
  ASSERT_TRUE(study) << in_words(study.error());
  const auto run = run_study(*study);
  ASSERT_TRUE(run) << in_words(run.error());
  ASSERT_TRUE(run->failure.empty());
  for (const char* name : {"stiffness", "damping", "drag_constant", "drag_coefficient", "frequency"}) {
    EXPECT_EQ(value(run->results, std::string("recording.") + name), fit.find(name)->value) << name;
    EXPECT_THAT(fit_study(fit, typed), HasSubstr(std::string("{recording.") + name + "}"));
  }
  EXPECT_EQ(fact(run->results, "recording.from"), "10 s");
}

/// Writes recording and study side by side, and the report.
Result<WrittenReport> reported(const std::string& name, const std::string& bytes,
                               const std::vector<TypedOption>& typed) {
  const auto folder = std::filesystem::temp_directory_path() / "cromer_fit_study";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  std::ofstream(folder / name) << bytes;
  std::ofstream(folder / "study.toml") << fit_study(fitted(bytes, name, typed), typed);
  return write_report((folder / "study.toml").string(), (folder / "out").string(), "1 May 2026", "cromer");
}

TEST(FitStudy, NamesAndValuesStandForThemselves) {
  std::string bytes = "Time (s),\"a \"\"{x}\"\" \\ (m)\"\n";
  for (int i = 0; i < 400; ++i) {
    const double t = 0.02 * i;
    bytes += shortest(t) + ',' + shortest(0.1 * std::exp(-0.1 * t) * std::cos(6 * t)) + '\n';
  }
  const auto report = reported("a {b} \"c\" \\d.csv", bytes, {{"column", "a \"{x}\" \\ (m)"}});
  ASSERT_TRUE(report) << in_words(report.error());
  EXPECT_TRUE(report->failure.empty());
  EXPECT_EQ(report->figures.size(), 2u);
}

TEST(FitStudy, IsEmptyWithoutAFit) { EXPECT_EQ(fit_study(not_fitted("a.csv", 1, Notice{"x"}), {}), ""); }

}  // namespace
}  // namespace cromer::core
