#include "cromer/tasks/methods/methods.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "cromer/documents/words/words.h"
#include "cromer/methods/all.h"
#include "cromer/tasks/methods/method_effect.h"
#include "tests/support/bytes_of.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(ListMethods, HasTheRegistryInItsOrder) {
  const auto rows = *list_methods();
  ASSERT_EQ(rows.size(), method_names.size());
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].name, method_names[i]);
}

TEST(ListMethods, SaysWhatTheTheorySays) {
  const auto rows = *list_methods();
  for (const auto& row : rows) {
    if (row.name == "exact") {
      EXPECT_FALSE(row.order);
    }
    if (row.name == "rk4") {
      EXPECT_EQ(row.order, 4);
    }
    if (row.name == "verlet") {
      EXPECT_EQ(row.order, 2);
    }
    if (row.name == "implicit-euler") {
      EXPECT_TRUE(row.implicit && !row.symplectic);
    }
    if (row.name == "euler-cromer") {
      EXPECT_TRUE(row.symplectic && !row.implicit && row.order == 1);
    }
    EXPECT_FALSE(row.source.empty()) << row.name;
  }
}

MethodRow row_of(std::string_view name, const MethodsOptions& options) {
  const auto rows = list_methods(options);
  EXPECT_TRUE(rows.ok());
  for (const auto& row : *rows)
    if (row.name == name) return row;
  ADD_FAILURE() << name;
  return {};
}

const MethodsOptions theory{.natural_frequency = 6, .damping_ratio = 0.15 / 6, .step = 0.01};

TEST(ListMethods, SayWhatTheyReallySimulate) {
  const MethodRow growing = row_of("forward-euler", theory);
  EXPECT_NEAR(*growing.effect->effective.decay_rate, -0.030, 5e-4);
  EXPECT_FALSE(growing.effect->stable);
  EXPECT_NEAR(*growing.effect->stability_limit, 2 * 0.15 / 36, 1e-12);
  EXPECT_GT(*growing.effect->effective.energy_factor(), 1);
  EXPECT_THAT(in_words(growing.words),
              testing::HasSubstr("turns your damping of 0.15 1/s into growth of 0.02999 1/s"));
  EXPECT_THAT(in_words(row_of("euler-cromer", theory).words),
              testing::HasSubstr("nearly keeps your damping of 0.15 1/s (0.1502)"));
  EXPECT_THAT(in_words(row_of("rk4", theory).words), "keeps your damping of 0.15 1/s and your 5.998 rad/s");
  EXPECT_FALSE(row_of("implicit-euler", theory).effect->stability_limit);
  EXPECT_FALSE(row_of("dormand-prince", theory).effect);
}

// Negative damping: the law grows by itself, which no method adds and no step causes.
TEST(ListMethods, ALawThatGrowsIsNoFaultOfTheMethod) {
  const LinearLaw<double> grows{.decay_rate = -0.05, .stiffness = 36};
  const auto words_of = [&](std::string_view method) {
    const auto effect = effect_at_step(method, {}, grows, 0.02, true);
    EXPECT_TRUE(instability_notice(method, *effect, 0.02).empty()) << method;
    EXPECT_FALSE(effect->stability_limit) << method;
    return in_words(effect_notice(*effect, grows));
  };
  EXPECT_THAT(words_of("exact"), testing::StartsWith("grows at the 0.05 1/s of your law and "));
  EXPECT_THAT(words_of("newmark"),
              testing::StartsWith("grows at 0.04982 1/s, nearly the 0.05 1/s of your law"));
  EXPECT_THAT(words_of("forward-euler"),
              testing::StartsWith("turns your law's growth of 0.05 1/s into 0.4067 1/s"));
  EXPECT_THAT(words_of("implicit-euler"),
              testing::StartsWith("turns your law's growth of 0.05 1/s into damping of 0.3081 1/s"));
}

TEST(ListMethods, ExactIsItsOwnOscillatorAtAnyStep) {
  auto options = theory;
  options.step = 2;  // more than half a period
  const MethodRow row = row_of("exact", options);
  ASSERT_TRUE(row.effect && row.effect->effective.decay_rate && row.effect->effective.angular_frequency);
  EXPECT_EQ(row.effect->effective.decay_rate.value_or(0), 0.15);
  EXPECT_DOUBLE_EQ(row.effect->effective.angular_frequency.value_or(0), std::sqrt(36 - 0.15 * 0.15));
  EXPECT_TRUE(row.effect->stable);
}

TEST(ListMethods, WhatDoesNotSwingHasNoRates) {
  auto options = theory;
  options.damping_ratio = 2;
  const auto rows = *list_methods(options);
  for (const auto& row : rows) {
    if (row.name != "exact" && row.name != "verlet") continue;
    EXPECT_FALSE(row.effect->effective.decay_rate || row.effect->effective.energy_factor()) << row.name;
    EXPECT_EQ(in_words(row.words), "creeps back without swinging, as your law does") << row.name;
  }
}

TEST(ListMethods, SayWhatAStepTooLongDoesToAStiffLaw) {
  // Overdamped: of the trapezoidal rule the fast part changes its sign each step.
  const MethodsOptions stiff{.natural_frequency = 6, .damping_ratio = 1.5, .step = 1};
  EXPECT_EQ(in_words(row_of("newmark", stiff).words),
            "dies down and changes sign at each step, which your law does not do");
  // Yoshida's long step back grows at 0.0626 s already, and no more at 0.1 s.
  const MethodsOptions between{.natural_frequency = 6, .damping_ratio = 1.5, .step = 0.1};
  const MethodRow yoshida = row_of("yoshida4", between);
  EXPECT_TRUE(yoshida.effect->stable);
  EXPECT_LT(*yoshida.effect->stability_limit, 0.1);
  EXPECT_THAT(in_words(yoshida.words), testing::HasSubstr("at some shorter steps it grows"));
  const MethodsOptions undamped{.natural_frequency = 6, .step = 0.01};
  EXPECT_THAT(in_words(row_of("implicit-euler", undamped).words),
              testing::HasSubstr("adds damping of 0.1797 1/s"));
  EXPECT_THAT(in_words(row_of("implicit-euler", undamped).words), testing::HasSubstr("0.12 % too slow"));
}

// Without damping: what keeps the energy says so, what feeds it or takes it says how fast. By the closed
// forms ln(1 + (w h)^2)/(2 h), atan(w h)/h, 2 asin(w h/2)/h, 2 atan(w h/2)/h; beyond w h = 2 verlet grows.
TEST(ListMethods, SayWhatTheyDoToAnUndampedLaw) {
  struct Said {
    double step;
    const char *method, *words;
  };
  const Said all[] = {
      {0.01, "forward-euler", "adds growth of 0.1797 1/s and swings at 5.99282 rad/s, 0.12 % too slow"},
      {0.01, "euler-cromer", "adds no damping and swings at 6.0009 rad/s, 0.015 % too fast"},
      {0.01, "implicit-euler", "adds damping of 0.1797 1/s and swings at 5.99282 rad/s, 0.12 % too slow"},
      {0.01, "verlet", "adds no damping and swings at 6.0009 rad/s, 0.015 % too fast"},
      {0.01, "newmark", "adds no damping and swings at 5.9982 rad/s, 0.03 % too slow"},
      {0.01, "implicit-midpoint", "adds no damping and swings at 5.9982 rad/s, 0.03 % too slow"},
      {0.01, "generalized-alpha",
       "adds damping of 8.879e-07 1/s and swings at 5.9981 rad/s, 0.032 % too slow"},
      {0.01, "heun", "adds growth of 0.000162 1/s and swings at 6.0036 rad/s, 0.06 % too fast"},
      {0.01, "rk4", "adds no damping and keeps your 6 rad/s"},
      {0.01, "yoshida4", "adds no damping and keeps your 6 rad/s"},
      {0.01, "gauss-legendre4", "adds no damping and keeps your 6 rad/s"},
      {0.01, "exact", "adds no damping and keeps your 6 rad/s"},
      {0.4, "forward-euler", "adds growth of 2.389 1/s and swings at 2.94001 rad/s, 51 % too slow"},
      {0.4, "euler-cromer", "grows and changes sign at each step"},
      {0.4, "implicit-euler", "adds damping of 2.389 1/s and swings at 2.94001 rad/s, 51 % too slow"},
      {0.4, "verlet", "grows and changes sign at each step"},
      {0.4, "newmark", "adds no damping and swings at 4.38029 rad/s, 27 % too slow"},
      {0.4, "implicit-midpoint", "adds no damping and swings at 4.38029 rad/s, 27 % too slow"},
      {0.4, "generalized-alpha", "adds damping of 0.01905 1/s and swings at 4.32341 rad/s, 28 % too slow"},
      {0.4, "heun", "adds growth of 2.787 1/s and swings at 5.58823 rad/s, 6.9 % too slow"},
      {0.4, "rk4", "adds damping of 1.699 1/s and swings at 7.37752 rad/s, 23 % too fast"},
      {0.4, "yoshida4", "grows without swinging"},
      {0.4, "gauss-legendre4", "adds no damping and swings at 5.80944 rad/s, 3.2 % too slow"},
      {0.4, "exact", "adds no damping and keeps your 6 rad/s"},
  };
  for (const auto& [step, method, words] : all)
    EXPECT_EQ(in_words(row_of(method, {.natural_frequency = 6, .step = step}).words), words)
        << method << ' ' << step;
}

TEST(ListMethods, OptionsReachTheMethods) {
  auto options = theory;
  options.beta = 0;
  EXPECT_NEAR(*row_of("newmark", options).effect->stability_limit, 2.0 / 6, 1e-6);
  options.rho_inf = 0;
  options.step = 1000;
  EXPECT_LT(row_of("generalized-alpha", options).effect->effective.spectral_radius, 0.02);
}

TEST(ListMethods, RefusesWhatItCannotUse) {
  const auto message = [](const MethodsOptions& options) {
    const auto rows = list_methods(options);
    return rows ? "" : in_words(rows.error());
  };
  EXPECT_THAT(message({.natural_frequency = 6}),
              testing::StartsWith("--natural-frequency: it needs a --step"));
  EXPECT_THAT(message({.step = 0.1}), testing::StartsWith("--step: it needs a --natural-frequency"));
  const std::string needs = ": it needs a --natural-frequency and a --step";
  EXPECT_EQ(message({.damping_ratio = 0.1}), "--damping-ratio" + needs);
  EXPECT_EQ(message({.beta = 0.3}), "--beta" + needs);
  EXPECT_EQ(message({.gamma = 0.6}), "--gamma" + needs);
  EXPECT_EQ(message({.rho_inf = 0.6}), "--rho-inf" + needs);
  EXPECT_EQ(message({.beta = 0.3, .gamma = 0.6, .rho_inf = 0.6}), "--rho-inf" + needs);
  EXPECT_THAT(message({.natural_frequency = -6, .step = 0.1}), testing::HasSubstr("be positive"));
  EXPECT_THAT(message({.natural_frequency = 6, .step = 0.1, .rho_inf = 1.5}),
              testing::HasSubstr("lie between 0 and 1"));
}

TEST(MethodsPage, HasTheTableOfTheRegistry) {
  EXPECT_THAT(bytes_of(CROMER_SOURCE_DIR "/docs/methods.md"), testing::HasSubstr(methods_in_markdown()))
      << "put the output of `cromer methods --markdown` into docs/methods.md";
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
