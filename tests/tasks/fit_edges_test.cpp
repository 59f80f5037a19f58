// What users do to the fit that nobody planned: tiny segments, odd rates, Ctrl-C, drop-outs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
#include "tests/tasks/disc_recording.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const Series& disc() {
  static const Series series = disc_recording(2, 90);
  return series;
}

FittedRecording fitted(const Series& series, FitOptions options) {
  options.law = "viscous";
  const Result<FittedRecording> result = fit_series(series, "f", options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : in_words(result.error()));
  return result.ok() ? *result : FittedRecording{};
}

std::string message(const FitOptions& options) {
  const Result<FittedRecording> result = fit_series(disc(), "f", options);
  return result.ok() ? std::string("fitted") : in_words(result.error());
}

TEST(FitEdges, SegmentsTooShortForAPeriodAreRefusedAtOnce) {
  for (const double segment : {1e-300, 1e-9, 1e-3, 0.7}) {
    const FittedRecording result = fitted(disc(), {.segment = segment});
    EXPECT_THAT(result.segments, IsEmpty());
    EXPECT_THAT(in_words(result.notices), Contains(HasSubstr("must hold 1.5 periods"))) << segment;
  }
  const FittedRecording many = fitted(disc(), {.segments = 1'000'000'000});
  EXPECT_THAT(in_words(many.notices), Contains(HasSubstr("those of --segments 1000000000")));
  EXPECT_EQ(fitted(disc(), {.segment = 2, .segments = 1'000'000'000}).segments.size(), 45u);
}

TEST(FitEdges, SegmentsThatFailShareOneWarning) {
  Series still = disc();
  for (std::size_t i = 3000; i < still.y.size(); ++i) still.y[i] = 0.2;
  const FittedRecording result = fitted(still, {.to = 90, .segment = 15});
  EXPECT_THAT(in_words(result.notices),
              Contains(HasSubstr("4 of the 6 segments are left out; the first, from 30 to 45 s")));
}

TEST(FitEdges, SegmentsDivideWhatIsBetweenFirstAndLastSample) {
  const FittedRecording parts = fitted(disc(), {.to = 60, .segments = 3});
  ASSERT_EQ(parts.segments.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(parts.segments[i].from, 20.0 * static_cast<double>(i));
    EXPECT_EQ(parts.segments[i].to, 20.0 * static_cast<double>(i + 1));
  }
  EXPECT_EQ(fitted(disc(), {.segment = 30, .segments = 3}).segments.size(), 3u);
  Series series = disc();
  series.t.resize(3000);
  series.y.resize(3000);
  series.lines.resize(3000);
  EXPECT_EQ(fitted(series, {.segment = 30}).segments.size(), 1u);
}

TEST(FitEdges, AnEndThatIsInNoSegmentIsSaid) {
  const auto said = [](double to, double segment) {
    const FittedRecording result = fitted(disc(), {.to = to, .segment = segment});
    EXPECT_EQ(result.segments.size(), 2u);
    for (const std::string& warning : in_words(result.notices))
      if (warning.starts_with("the last ")) return warning;
    return std::string();
  };
  EXPECT_EQ(said(89.9, 30), "the last 29.9 s are shorter than a segment of 30 s and belong to none");
  EXPECT_EQ(said(60.9, 30), "");  // under 2 % of the record
  EXPECT_EQ(said(61.5, 30), "the last 1.5 s are shorter than a segment of 30 s and belong to none");
  const FittedRecording first_two = fitted(disc(), {.segment = 30, .segments = 2});
  EXPECT_THAT(in_words(first_two.notices), Not(Contains(HasSubstr("the last "))));
}

TEST(FitEdges, AnInterruptedFitHasNotConverged) {
  const std::atomic<bool> stop{true};
  const Watch watch{&stop, {}};
  for (const char* law : {"auto", "viscous", "viscous+drag"}) {
    const Result<FittedRecording> result = fit_series(disc(), "f", {.law = law, .segment = 30}, watch);
    ASSERT_TRUE(result.ok());
    EXPECT_EQ(result->fit.status, FitStatus::iteration_limit) << law;
    EXPECT_THAT(in_words(result->fit.message), testing::StartsWith("interrupted"));
    EXPECT_THAT(result->parameters, IsEmpty());
    EXPECT_TRUE(result->simulate.empty());
  }
}

TEST(FitEdges, AnInterruptedComparisonIsNotComplete) {
  const Result<FittedRecording> fit = fit_series(disc(), "f", {.law = "viscous"});
  ASSERT_TRUE(fit.ok());
  const std::atomic<bool> stop{true};
  const Result<CompareResult> result = compare_fitted(*fit, {}, Watch{&stop, {}});
  ASSERT_TRUE(result.ok());
  EXPECT_FALSE(result->complete);
  EXPECT_THAT(in_words(result->notices), Contains(HasSubstr("interrupted")));
  EXPECT_THAT(in_words(result->notices), Not(Contains(HasSubstr("smaller --step"))));
}

TEST(FitEdges, AnUnstableStepIsSaid) {
  const Result<FittedRecording> fit = fit_series(disc(), "f", {.law = "viscous"});
  ASSERT_TRUE(fit.ok());
  CompareOptions options;
  options.step = 0.23;  // w h = 2.04
  const Result<CompareResult> result = compare_fitted(*fit, options);
  ASSERT_TRUE(result.ok());
  EXPECT_THAT(in_words(result->notices), Contains(HasSubstr("unstable")));
}

TEST(FitEdges, RunsOfZerosAreDropOutsAndNotClipping) {
  Series series = disc();
  for (const std::size_t first : {900u, 4000u})
    for (std::size_t i = first; i < first + 10; ++i) series.y[i] = 0;
  const FittedRecording result = fitted(series, {});
  EXPECT_EQ(result.fit.status, FitStatus::converged) << in_words(result.fit.message);
  EXPECT_EQ(result.series.outliers.size(), 20u);
  EXPECT_THAT(in_words(result.notices),
              Contains(HasSubstr("20 samples in flat runs far outside the motion")));
  EXPECT_NEAR(result.find("equilibrium")->value, 0.2, 1e-4);
}

TEST(FitEdges, OptionsThatCannotBeMeantAreNamed) {
  for (const double rate : {1e300, 1e-300}) {
    FitOptions options;
    options.read.rate = rate;
    EXPECT_THAT(message(options), HasSubstr("--rate"));
  }
  EXPECT_EQ(message({.from = 500}), "--from 500: no sample is left, the recording goes from 0 to 90 s");
  EXPECT_THAT(message({.from = 500, .to = 600}), HasSubstr("--from 500 --to 600:"));
}

TEST(FitEdges, TheSimulateLineHasRoundNumbers) {
  Series series = disc();
  series.rate = 1 / 0.00999999999999979;  // one over a median of printed times
  for (double& t : series.t) t += 0.3;
  const std::string line = command_of("simulate", fitted(series, {.to = 2.3}).simulate);
  EXPECT_THAT(line, HasSubstr("--step 0.0033333333333333335 "));
  EXPECT_THAT(line, testing::EndsWith("--until 2"));
}

TEST(FitEdges, ErrorsOfAnOptionBeginWithTheOption) {
  const std::string bytes = "t (s),x (m)\n0,1\n1,2\n2,1\n3,2\n4,1\n5,2\n6,1\n7,2\n8,1\n9,2\n";
  const auto result = fit(bytes, "lab.csv", {.law = "pendulum"});
  ASSERT_FALSE(result.ok());
  EXPECT_THAT(in_words(result.error()), testing::StartsWith("--law pendulum"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
