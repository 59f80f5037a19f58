// The modes of networks, against closed forms and against truth that others computed.
#include "cromer/tasks/modes/modes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cromer/analysis/complex_modes.h"
#include "cromer/documents/words/words.h"
#include "cromer/methods/all.h"
#include "cromer/tasks/modes/modes_options.h"
#include "cromer/tasks/network/network_file.h"
#include "tests/support/expect_in.h"
#include "tests/support/shared_data.h"

namespace cromer::core {
namespace CROMER_FILE {

using Json = nlohmann::json;

constexpr std::string_view shear_frame = R"(
[[mass]]
name = "floor 1"
mass = "1200 kg"
[[mass]]
name = "floor 2"
mass = "1000 kg"
[[mass]]
name = "floor 3"
mass = "1000 kg"
[[mass]]
name = "floor 4"
mass = "800 kg"
[[link]]
from = "ground"
to = "floor 1"
stiffness = "1.1e6 N/m"
damping = "900 kg/s"
[[link]]
from = "floor 1"
to = "floor 2"
stiffness = "9e5 N/m"
damping = "400 kg/s"
[[link]]
from = "floor 2"
to = "floor 3"
stiffness = "8e5 N/m"
damping = "2600 kg/s"
[[link]]
from = "floor 3"
to = "floor 4"
stiffness = "5e5 N/m"
damping = "300 kg/s"
)";

constexpr std::string_view coupled_pendulums = R"(
[[mass]]
name = "left"
inertia = "0.05 kg m^2"
[[mass]]
name = "right"
inertia = "0.05 kg m^2"
[[link]]
to = "left"
stiffness = "0.981 N m"
damping = "0.0006 N m s"
[[link]]
to = "right"
stiffness = "0.992 N m"
damping = "0.0008 N m s"
[[link]]
from = "left"
to = "right"
stiffness = "0.031 N m"
)";

ModesResult modes_of(const Network& network, const ModesOptions& options = {}) {
  const auto result = network_modes(network, "n.toml", options);
  if (!result) ADD_FAILURE() << in_words(result.error().notice);
  return result ? *result : ModesResult{};
}

ModesResult modes_of(std::string_view file, const ModesOptions& options = {}) {
  const auto network = read_network(file, "n.toml");
  if (!network) ADD_FAILURE() << in_words(network.error().notice);
  return network ? modes_of(*network, options) : ModesResult{};
}

void expect_modes(const ModesResult& found, const Json& truth) {
  ASSERT_EQ(found.modes.size(), truth.size());
  for (std::size_t j = 0; j < truth.size(); ++j) {
    const NaturalMode& mode = found.modes[j];
    const double frequency = truth[j]["frequency_hz"], damping = truth[j]["damping_ratio"];
    EXPECT_NEAR(mode.frequency.value, frequency, 1e-11 * frequency);
    EXPECT_NEAR(mode.damping_ratio.value, damping, 1e-11);
    for (std::size_t i = 0; i < mode.shape.size(); ++i) {
      EXPECT_NEAR(mode.shape[i].real(), truth[j]["shape_re"][i], 1e-10) << j;
      EXPECT_NEAR(mode.shape[i].imag(), truth[j]["shape_im"][i], 1e-10) << j;
    }
  }
}

TEST(Modes, AreThoseOfTheSharedNetworks) {
  const std::string path = data("networks/truth.json");
  SKIP_WITHOUT(path);
  const Json truth = Json::parse(bytes_of(path));
  expect_modes(modes_of(shear_frame), truth["shear_frame"]["modes"]);
  expect_modes(modes_of(coupled_pendulums), truth["coupled_pendulums"]["modes"]);
  for (const auto& [step, by_newmark] : truth["shear_frame"]["newmark_average_acceleration"].items()) {
    const ModesResult found = modes_of(shear_frame, {.method = {"newmark"}, .step = std::stod(step)});
    ASSERT_EQ(found.modes.size(), by_newmark.size());
    for (std::size_t j = 0; j < by_newmark.size(); ++j) {
      ASSERT_EQ(found.modes[j].methods.size(), 1u);
      const ModeByMethod& by = found.modes[j].methods[0];
      const double frequency = by_newmark[j]["frequency_hz"];
      EXPECT_NEAR(*by.frequency(), frequency, 1e-9 * frequency) << step;
      EXPECT_NEAR(*by.damping_ratio(), by_newmark[j]["damping_ratio"], 1e-9) << step;
    }
  }
}

Network chain(std::size_t masses, double damping, bool to_the_right_wall = true) {
  Network network;
  for (std::size_t i = 0; i < masses; ++i)
    network.masses.push_back({.name = "m" + std::to_string(i + 1), .mass = 0.5});
  for (std::size_t i = 0; i < masses + to_the_right_wall; ++i)
    network.links.push_back(
        {i == 0 ? ground : i - 1, i == masses ? ground : i, {.stiffness = 8, .damping = damping}});
  return network;
}

// Two pendulums of 9 and 16 rad²/s²: (16 - 9)/(16 + 9).
TEST(Modes, OfTwoBeatAndAreCoupled) {
  ModesResult result;
  result.modes.resize(2);
  result.modes[0].frequency = {3, 0.03, 2.94, 3.06};
  result.modes[1].frequency = {4, 0.04, 3.92, 4.08};
  const auto beat = beat_of(result);
  ASSERT_TRUE(beat);
  EXPECT_NEAR(beat->frequency.value, 1, 1e-12);
  EXPECT_NEAR(beat->frequency.standard_error, 0.05, 1e-12);
  EXPECT_NEAR(beat->frequency.high, 1.1, 1e-12);
  EXPECT_NEAR(beat->period.value, 1, 1e-12);
  EXPECT_NEAR(beat->period.standard_error, 0.05, 1e-12);
  EXPECT_NEAR(beat->coupling.value, 7.0 / 25, 1e-12);
  // By differences.
  const auto coupling = [](double s, double f) { return (f * f - s * s) / (f * f + s * s); };
  EXPECT_NEAR(beat->coupling.standard_error,
              std::hypot(coupling(3.0003, 4) - coupling(3, 4), coupling(3, 4.0004) - coupling(3, 4)) * 100,
              1e-5);
  // What creeps back, or has nothing that pulls it back, does not beat.
  result.modes[1].damping_ratio = {1.2, 0, 1.2, 1.2};
  EXPECT_FALSE(beat_of(result));
  result.modes[1].damping_ratio = {0.2, 0, 0.2, 0.2};
  EXPECT_TRUE(beat_of(result));
  result.modes[0].frequency = {};
  result.modes[0].frequency.value = 0;
  EXPECT_FALSE(beat_of(result));
  result.modes.resize(1);
  EXPECT_FALSE(beat_of(result));
}

TEST(Modes, OfAChainHaveTheirClosedForm) {
  for (const std::size_t n : {1u, 2u, 3u, 10u, 100u}) {
    const ModesResult found = modes_of(chain(n, 0.02));
    ASSERT_EQ(found.modes.size(), n);
    double shares = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const double angle = static_cast<double>(j + 1) * std::numbers::pi / static_cast<double>(n + 1);
      const double w = 2 * std::sqrt(8 / 0.5) * std::sin(angle / 2);
      const NaturalMode& mode = found.modes[j];
      EXPECT_NEAR(2 * std::numbers::pi * mode.frequency.value, w, 1e-11 * w);
      EXPECT_NEAR(mode.damping_ratio.value, w * 0.02 / 8 / 2, 1e-12);
      EXPECT_EQ(mode.frequency.standard_error, 0);
      std::vector<std::complex<double>> shape(n);
      for (std::size_t i = 0; i < n; ++i) shape[i] = std::sin(static_cast<double>(i + 1) * angle);
      EXPECT_NEAR(modal_assurance(shape, mode.shape), 1, 1e-10);
      shares += *mode.participation;
    }
    EXPECT_NEAR(shares, 1, 1e-12);
  }
}

TEST(Modes, WhatAMethodMakesOfThemIsWhatItMakesOfEachOscillator) {
  // The map of the whole network, of a chain whose dampers tie its modes together a little, goes over into
  // those of single oscillators as they vanish.
  for (const MethodInfo& info : method_infos) {
    if (info.is_adaptive()) continue;
    const ModesOptions options{.method = {std::string(info.name)}, .step = 0.05};
    const ModesResult apart = modes_of(chain(3, 0.1), options);
    Network tied = chain(3, 0.1);
    tied.links[1].law.damping *= 1 + 1e-9;
    const ModesResult together = modes_of(tied, options);
    for (std::size_t j = 0; j < 3; ++j) {
      const ModeByMethod &one = apart.modes[j].methods[0], &other = together.modes[j].methods[0];
      ASSERT_TRUE(one.frequency() && other.frequency()) << info.name;
      EXPECT_NEAR(*one.frequency(), *other.frequency(), 1e-9) << info.name;
      EXPECT_NEAR(*one.damping_ratio(), *other.damping_ratio(), 1e-9) << info.name;
      EXPECT_EQ(one.effect.stable, other.effect.stable) << info.name;
      EXPECT_EQ(in_words(one.words), in_words(other.words)) << info.name;
    }
  }
}

TEST(Modes, SayWhereAMethodIsUnstable) {
  const ModesResult found = modes_of(chain(3, 0), {.method = {"euler-cromer"}, .step = 0.3});
  EXPECT_TRUE(found.modes[0].methods[0].effect.stable);
  EXPECT_FALSE(found.modes[2].methods[0].effect.stable);
  EXPECT_FALSE(found.modes[2].methods[0].frequency());
  ASSERT_EQ(found.notices.size(), 1u);
  EXPECT_EQ(in_words(found.notices[0]), "euler-cromer with a step of 0.3 s is unstable on this network");
}

// Average acceleration keeps the energy, to rounding.
TEST(Modes, AreStableWhereAMethodKeepsTheirEnergy) {
  Network network = chain(4, 0);
  network.links[0].law.damping = 0.1;
  network.links[3].from = ground;  // the last mass swings by itself
  network.links[4] = network.links[3];
  for (const double step : {0.01, 0.1, 0.3, 1.0}) {
    const ModesResult found = modes_of(network, {.method = {"newmark"}, .step = step});
    EXPECT_THAT(in_words(found.notices), testing::IsEmpty()) << step;
  }
}

TEST(Modes, OfANetworkThatGrowsByItselfAreNoFaultOfTheMethod) {
  Network network = chain(2, 0);
  network.links[1].law.damping = -0.1;
  network.links[1].law.van_der_pol = 3;
  const ModesResult found = modes_of(network, {.method = {"rk4"}, .step = 0.01});
  EXPECT_LT(found.modes[1].damping_ratio.value, -0.01);
  EXPECT_NEAR(*found.modes[1].methods[0].damping_ratio(), found.modes[1].damping_ratio.value, 1e-6);
  EXPECT_FALSE(found.modes[1].methods[0].effect.stable);
  ASSERT_EQ(found.notices.size(), 1u);
  EXPECT_EQ(found.notices[0].code, "modes_of_small_motions");
}

TEST(Modes, AreLinearisedAboutRestAndThatIsSaid) {
  Network network = chain(2, 0);
  const ModesResult linear = modes_of(network);
  network.links[0].law.cubic = 5;
  network.links[1].law.drag = 2;
  network.links[2].law.stiffness = 0;
  network.links[2].law.pendulum = 8;
  const ModesResult found = modes_of(network);
  for (std::size_t j = 0; j < 2; ++j)
    EXPECT_NEAR(found.modes[j].frequency.value, linear.modes[j].frequency.value, 1e-14);
  ASSERT_EQ(found.notices.size(), 1u);
  EXPECT_EQ(
      in_words(found.notices[0]),
      "the modes are those of small motions about rest: the law is not linear (drag, cubic and pendulum)");
  EXPECT_TRUE(linear.notices.empty());
}

TEST(Modes, OfMassesThatNothingPullsBack) {
  // A damper and a bent spring alone: they do not come back, so no method creeps back.
  Network network;
  network.masses.push_back({"a", 2});
  network.links.push_back({ground, 0, {.stiffness = 0, .damping = 1, .cubic = 3}});
  const auto found = network_modes(network, "n.toml", {.method = {"rk4"}, .step = 0.1});
  ASSERT_TRUE(found);
  EXPECT_FALSE(std::signbit(found->modes[0].frequency.value));
  EXPECT_EQ(in_words(found->modes[0].methods[0].words), "does not swing, as your law does not");
}

TEST(Modes, ExactKeepsWhatDoesNotSwing) {
  // Tied by their damper, and one falls away: modes without a frequency.
  Network network;
  network.masses = {{"a", 1}, {"b", 1}};
  network.links = {{ground, 0, {.stiffness = -3}}, {0, 1, {.stiffness = 0, .damping = 1}}};
  const auto found = network_modes(network, "n.toml", {.method = {"exact"}, .step = 0.1});
  ASSERT_TRUE(found);
  for (const NaturalMode& mode : found->modes) {
    ASSERT_EQ(mode.methods.size(), 1u);
    EXPECT_FALSE(mode.methods[0].frequency());
    EXPECT_FALSE(mode.methods[0].words.empty());
  }
}

TEST(Modes, SaysThatASlowOneIsLostInRounding) {
  Network network;
  network.masses = {{"a", 1}, {"b", 1}};
  network.links = {{ground, 0, {.stiffness = 1e15}}, {0, 1, {.stiffness = 1}}};
  const ModesResult found = modes_of(network);
  ASSERT_EQ(found.notices.size(), 1u);
  EXPECT_EQ(found.notices[0].code, "slow_modes_lost");
  network.links[0].law.stiffness = 1e6;
  EXPECT_TRUE(modes_of(network).notices.empty());
}

TEST(Modes, OfFreeBodiesAndOfStronglyDampedOnes) {
  Network network = chain(3, 0);
  network.links.erase(network.links.begin());
  network.links.pop_back();
  for (const double damper : {0.0, 0.01}) {  // natural modes, and tied ones
    network.links[0].law.damping = damper;
    const ModesResult free = modes_of(network);
    EXPECT_EQ(free.modes[0].frequency.value, 0);
    EXPECT_TRUE(std::isnan(free.modes[0].damping_ratio.value));
    EXPECT_NEAR(free.modes[1].frequency.value, 4 / (2 * std::numbers::pi), 1e-4);
    EXPECT_NEAR(*free.modes[0].participation, 1, 1e-6);
    ASSERT_EQ(free.notices.size(), 1u);
    EXPECT_EQ(in_words(free.notices[0]),
              "1 mode has the frequency 0: in small motions nothing pulls all masses back to the ground");
  }
  // One mass creeps back: its ratio is that of an oscillator.
  for (const double other : {0.0, 0.3}) {
    Network strong = chain(2, 0);
    strong.links[1].law.stiffness = 1e-9;
    strong.links[0].law.damping = 10;
    strong.links[2].law.damping = other;
    const ModesResult damped = modes_of(strong);
    ASSERT_EQ(damped.modes.size(), 2u);
    const std::size_t creeping = damped.modes[0].damping_ratio.value > 1 ? 0 : 1;
    EXPECT_NEAR(damped.modes[creeping].damping_ratio.value, 10 / (2 * std::sqrt(8 * 0.5)), 1e-6);
    EXPECT_NEAR(damped.modes[creeping].frequency.value, 4 / (2 * std::numbers::pi), 1e-6);
    EXPECT_NEAR(damped.modes[1 - creeping].damping_ratio.value, other / (2 * std::sqrt(8 * 0.5)), 1e-6);
  }
}

TEST(Modes, SayWhichOptionAMethodHasNoUseFor) {
  const auto said = [](const ModesOptions& options) {
    return in_words(network_modes(chain(2, 0), "n.toml", options)->notices);
  };
  EXPECT_THAT(said({.method = {"newmark"}, .step = 0.1, .rho_inf = 0.5}),
              testing::ElementsAre("--rho-inf has no effect on newmark"));
  EXPECT_THAT(said({.method = {"generalized-alpha"}, .step = 0.1, .beta = 0.3, .gamma = 0.6}),
              testing::ElementsAre("--beta has no effect on generalized-alpha",
                                   "--gamma has no effect on generalized-alpha"));
  EXPECT_THAT(said({.method = {"generalized-alpha"}, .step = 0.1, .rho_inf = 0.5}), testing::IsEmpty());
  EXPECT_THAT(said({.method = {"newmark"}, .step = 0.1, .beta = 0.3, .gamma = 0.6}), testing::IsEmpty());
}

TEST(Modes, RefuseWhatTheyCannotTake) {
  const auto refusal = [](const ModesOptions& options) {
    const auto result = network_modes(chain(2, 0), "n.toml", options);
    return result ? "" : in_words(result.error().notice);
  };
  EXPECT_EQ(refusal({.step = 0.1}), "--step needs a --method");
  EXPECT_EQ(refusal({.method = {"rk4"}}), "--method needs a --step");
  EXPECT_EQ(refusal({.beta = 0.2}), "--beta needs --method and --step");
  EXPECT_EQ(refusal({.gamma = 0.6}), "--gamma needs --method and --step");
  EXPECT_EQ(refusal({.rho_inf = 0.6}), "--rho-inf needs --method and --step");
  EXPECT_EQ(refusal({.gamma = 0.6, .rho_inf = 0.6}), "--rho-inf needs --method and --step");
  EXPECT_EQ(refusal({.method = {"dormand-prince"}, .step = 0.1}),
            "--method: dormand-prince chooses its own steps");
  EXPECT_NE(refusal({.method = {"rk5"}, .step = 0.1}).find("rk4"), std::string::npos);
  EXPECT_NE(refusal({.method = {"rk4"}, .step = -0.1}).find("positive"), std::string::npos);
  const auto many = network_modes(chain(501, 0), "n.toml");
  ASSERT_FALSE(many);
  EXPECT_EQ(in_words(many.error().notice), "n.toml: 501 masses; modes are found for at most 500");
}

TEST(Modes, OptionsOfRecordingsAreKnown) {
  EXPECT_EQ(option_of_recordings({}), "");
  EXPECT_EQ(option_of_recordings({.method = {"rk4"}, .step = 0.1, .beta = 0.2}), "");
  EXPECT_EQ(option_of_recordings({.from = 0.0}), "from");
  EXPECT_EQ(option_of_recordings({.to = 0.0}), "to");
  EXPECT_EQ(option_of_recordings({.modes = 2}), "modes");
  EXPECT_EQ(option_of_recordings({.from_frequency = 1.0}), "from-frequency");
  EXPECT_EQ(option_of_recordings({.to_frequency = 1.0}), "to-frequency");
  EXPECT_EQ(option_of_recordings({.of_method = "newmark"}), "of-method");
  EXPECT_EQ(option_of_recordings({.read = {.rate = 100}}), "rate");
  EXPECT_EQ(option_of_recordings({.read = {.time_column = "t"}}), "time-column");
  EXPECT_EQ(option_of_recordings({.read = {.delimiter = ";"}}), "delimiter");
  EXPECT_EQ(option_of_recordings({.read = {.decimal = ","}}), "decimal");
  EXPECT_EQ(option_of_recordings({.read = {.skip_bad_rows = true}}), "skip-bad-rows");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
