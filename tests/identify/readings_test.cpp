// What a recorded force did between its samples, where the record does not tell: the law is chosen by hand,
// so that every number that follows is known.
#include "cromer/identify/choose/readings.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/criterion.h"
#include "tests/identify/forced_truth.h"

namespace cromer::core {
namespace CROMER_FILE {

using Change = std::function<void(LawFit&)>;

// Slow enough for its samples, and noisy: all readings account for it.
const ForcedSynthetic& vague_record() {
  static const ForcedSynthetic record = forced_synthetic(
      {.w0 = 6, .g = 0.35, .offset = 0.1, .equilibrium = 1}, multisine(8, 4), 400, 0.02, 0.05, 7);
  return record;
}

// The choice, what it chose from, and in what order the readings came.
struct Reading {
  LawChoice choice;
  LawFit chosen;  // as it was before the readings were compared
  std::vector<BetweenSamples> asked;
  std::vector<double> progress;

  // The fit under that reading.
  const LawFit& other(BetweenSamples between) const {
    return *std::find_if(choice.candidates.begin(), choice.candidates.end(),
                         [&](const LawFit& fit) { return fit.drive.force.between == between; });
  }
};

Reading read(const Change& change, bool law_is_given = true, std::optional<BetweenSamples> between = {}) {
  const ForcedSynthetic& made = vague_record();
  const LawFitOptions options{.drive = Drive::recorded(made.recorded(BetweenSamples::linear))};
  GivenLaw given{.between = between};
  if (law_is_given) given.law = law_of("viscous");
  Reading reading;
  const Watch watch{.progress = [&](double share) { reading.progress.push_back(share); }};
  const auto choose = [&](const LawFitOptions& one) {
    LawFitOptions viscous = one;
    viscous.law = law_of("viscous");
    viscous.start = std::nullopt;
    LawFit fit = fit_law(made.record(), viscous);
    EXPECT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
    reading.asked.push_back(one.drive.force.between);
    change(fit);
    reading.chosen = fit;
    return LawChoice{fit, {}};
  };
  reading.choice = choose_reading(made.record(), options, given, choose, watch);
  return reading;
}

TEST(Readings, AGivenOneIsTheOnlyOne) {
  for (const BetweenSamples between :
       {BetweenSamples::linear, BetweenSamples::hold, BetweenSamples::band_limited}) {
    const Reading reading = read([](LawFit&) {}, true, between);
    EXPECT_EQ(reading.asked, std::vector{between});
    EXPECT_TRUE(reading.progress.empty());
    EXPECT_TRUE(reading.choice.candidates.empty());
  }
}

// Row by row, each term: off-diagonal ones as well.
TEST(Readings, TheirSpreadGoesIntoEveryCovariance) {
  const Reading reading = read([](LawFit&) {});
  EXPECT_EQ(reading.asked.size(), 1u);
  EXPECT_EQ(reading.progress, (std::vector<double>{0.15 * 1, 0.15 * 2, 0.15 * 3}));
  const LawFit& chosen = reading.choice.chosen;
  ASSERT_EQ(chosen.drive.force.between, reading.asked[0]);
  const std::size_t n = chosen.names.size();
  ASSERT_EQ(n, 7u);
  ASSERT_EQ(reading.choice.candidates.size(), 2u);
  double total = 1;
  std::vector<double> weights;
  for (const LawFit& other : reading.choice.candidates) {
    EXPECT_LT(other.bic - chosen.bic, strong_evidence);
    EXPECT_EQ(other.bic, bayesian_criterion(chosen.independent_samples, other.residual.rms, other.fitted, 0));
    weights.push_back(std::exp(-0.5 * (other.bic - chosen.bic)));
    total += weights.back();
  }
  EXPECT_EQ(chosen.bic,
            bayesian_criterion(chosen.independent_samples, chosen.residual.rms, chosen.fitted, 0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      double expected = reading.chosen.covariance[i * n + j];
      for (std::size_t k = 0; k < 2; ++k) {
        const LawFit& other = reading.choice.candidates[k];
        expected += weights[k] / total * (other.estimates[i].value - chosen.estimates[i].value) *
                    (other.estimates[j].value - chosen.estimates[j].value);
      }
      EXPECT_NEAR(chosen.covariance[i * n + j], expected, 1e-12 * std::abs(expected)) << i << ' ' << j;
    }
    const Estimate &before = reading.chosen.estimates[i], &after = chosen.estimates[i];
    EXPECT_EQ(after.value, before.value);
    EXPECT_EQ(after.standard_error, std::sqrt(chosen.covariance[i * n + i])) << i;
    if (chosen.names[i] == "force_offset") continue;  // held
    EXPECT_GT(after.standard_error, before.standard_error) << i;
    const double times = after.standard_error / before.standard_error;
    EXPECT_NEAR(after.value - after.low, times * (before.value - before.low), 1e-12) << i;
    EXPECT_NEAR(after.high - after.value, times * (before.high - before.value), 1e-12) << i;
  }
}

TEST(Readings, ABoundStaysOne) {
  const Reading reading = read([](LawFit& fit) {
    fit.find("decay_rate")->low = 0;
    fit.find("equilibrium")->standard_error = 0;
  });
  const LawFit& chosen = reading.choice.chosen;
  const Estimate before = reading.chosen.decay_rate(), after = chosen.decay_rate();
  EXPECT_EQ(after.low, 0);
  EXPECT_NEAR(after.high - after.value,
              after.standard_error / before.standard_error * (before.high - before.value), 1e-12);
  // What was held keeps its error; those behind it are widened.
  EXPECT_EQ(chosen.equilibrium().standard_error, 0);
  EXPECT_GT(chosen.position().standard_error, reading.chosen.position().standard_error);
  EXPECT_GT(chosen.velocity().standard_error, reading.chosen.velocity().standard_error);
}

std::string open_between(const LawFit& chosen, const LawFit& other, const std::string& differences) {
  return fmt::format(
      "what the force did between its samples is not certain: read as {} the rms residual is {:.4g}, read as "
      "{} it is {:.4g}, too close to decide{}; the uncertainties are widened for it. If it is known, give "
      "--between-samples",
      name(chosen.drive.force.between), chosen.residual.rms, name(other.drive.force.between),
      other.residual.rms, differences);
}

// What the other makes of a number, from one standard error of the chosen one's on, as it is widened.
TEST(Readings, SayWhatTheOtherWouldMakeOfTheNumbers) {
  const Reading reading = read([](LawFit& fit) {
    for (std::size_t i = 0; i < fit.names.size(); ++i) {
      const bool sharp = fit.names[i] == "decay_rate" || fit.names[i] == "force_gain";
      const double error = sharp ? 1e-9 : fit.names[i] == "force_offset" ? 0 : 10;
      fit.estimates[i].standard_error = error;
      fit.covariance[i * fit.names.size() + i] = error * error;
    }
  });
  const LawFit& chosen = reading.choice.chosen;
  ASSERT_EQ(in_words(chosen.notices).size(), in_words(reading.chosen.notices).size() + 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const LawFit& other = reading.choice.candidates[k];
    std::string expected;
    for (const char* each : {"decay_rate", "force_gain"}) {
      const double off = std::abs(other[each].value - chosen[each].value) / chosen[each].standard_error;
      if (off > 1)
        expected += fmt::format("{}{} {:.6g} ({:.1f} of the stated standard errors away)",
                                expected.empty() ? "; the other reading would make the " : ", ",
                                std::string(each) == "decay_rate" ? "decay rate" : "force gain",
                                other[each].value, off);
    }
    EXPECT_EQ(in_words(chosen.notices)[in_words(reading.chosen.notices).size() + k],
              open_between(chosen, other, expected));
  }
  // Of the two others together one is further off than the weighted mean of both.
  EXPECT_NE(in_words(chosen.notices).back().find("the other reading would make the"), std::string::npos);
}

/// How many readings stay open where the chosen fit's criterion is changed to lie so far below another's.
std::size_t open_beside(BetweenSamples between, double evidence) {
  const Reading plain = read([](LawFit&) {});
  const Reading reading = read([&](LawFit& fit) {
    fit.residual.rms =
        plain.other(between).residual.rms * std::exp(-evidence / (2 * fit.independent_samples));
  });
  return in_words(reading.choice.chosen.notices).size() - in_words(reading.chosen.notices).size();
}

TEST(Readings, StayOpenWithinSix) {
  const Reading plain = read([](LawFit&) {});
  ASSERT_EQ(plain.asked[0], BetweenSamples::linear);
  // Of the two others the held one leaves more.
  EXPECT_EQ(open_beside(BetweenSamples::hold, 5.99), 2u);
  EXPECT_EQ(open_beside(BetweenSamples::hold, 6.01), 1u);
  EXPECT_EQ(open_beside(BetweenSamples::band_limited, 5.99), 1u);
  EXPECT_EQ(open_beside(BetweenSamples::band_limited, 6.01), 0u);
  // None: nothing is widened.
  const Reading sure = read([](LawFit& fit) { fit.residual.rms *= 0.5; });
  EXPECT_EQ(sure.choice.chosen.covariance, sure.chosen.covariance);
  EXPECT_EQ(sure.choice.candidates.size(), 2u);
}

// Another reading is taken where it leaves less under the law; one that is clearly better asks for a law of
// its own.
TEST(Readings, ABetterOneIsAskedForItsLaw) {
  const Reading plain = read([](LawFit&) {});
  const auto worse_by = [&](double evidence, bool law_is_given) {
    bool first = true;
    return read(
        [&](LawFit& fit) {
          if (first)
            fit.residual.rms = plain.other(BetweenSamples::band_limited).residual.rms *
                               std::exp(evidence / (2 * fit.independent_samples));
          first = false;
        },
        law_is_given);
  };
  const std::vector<BetweenSamples> once{BetweenSamples::linear},
      twice{BetweenSamples::linear, BetweenSamples::band_limited};
  EXPECT_EQ(worse_by(6.01, true).asked, once);
  EXPECT_EQ(worse_by(6.01, true).choice.chosen.drive.force.between, BetweenSamples::band_limited);
  EXPECT_EQ(worse_by(-0.01, true).choice.chosen.drive.force.between, BetweenSamples::linear);
  EXPECT_EQ(worse_by(0.01, true).choice.chosen.drive.force.between, BetweenSamples::band_limited);
  const Reading again = worse_by(6.01, false);
  EXPECT_EQ(again.asked, twice);
  EXPECT_EQ(worse_by(5.99, false).asked, once);
}

TEST(Readings, AnInterruptionEndsTheChoice) {
  const ForcedSynthetic& made = vague_record();
  const LawFitOptions options{.drive = Drive::recorded(made.recorded(BetweenSamples::linear))};
  std::atomic<bool> stop = false;
  int asked = 0;
  const auto choose = [&](const LawFitOptions& one) {
    LawFitOptions viscous = one;
    viscous.law = law_of("viscous");
    ++asked;
    const LawFit fit = fit_law(made.record(), viscous);
    stop = true;
    return LawChoice{fit, {}};
  };
  const LawChoice choice =
      choose_reading(made.record(), options, {.law = law_of("viscous")}, choose, {.interrupt = &stop});
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(choice.candidates.empty());
  EXPECT_TRUE(in_words(choice.chosen.notices).empty() ||
              in_words(choice.chosen.notices).back().find("is open") == std::string::npos);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
