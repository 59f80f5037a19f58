// The modes in recordings: from the columns of a file to what is said of them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <fstream>
#include <functional>
#include <numbers>
#include <random>
#include <sstream>

#include "cromer/documents/words/words.h"
#include "cromer/methods/all.h"
#include "cromer/tasks/methods/law_before_method.h"
#include "cromer/tasks/methods/method_effect.h"
#include "cromer/tasks/modes/modes.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double full_turn = 2 * std::numbers::pi;

Recording recording_of(const std::string& bytes) {
  auto recording = read_recording(bytes, "lab.csv", {});
  EXPECT_TRUE(recording) << (recording ? "" : recording.error().message());
  return recording ? *std::move(recording) : Recording{};
}

// Two pendulums: 0.7 and 0.73 Hz. `cells` writes what follows the time in each row.
struct Swing {
  std::complex<double> value;  // [1/s]
  double first, second;        ///< amplitudes
};

std::complex<double> value_of(double frequency, double damping_ratio) {
  const double w = full_turn * frequency;
  return {-damping_ratio * w, w * std::sqrt(1 - damping_ratio * damping_ratio)};
}

std::string decay(const std::vector<Swing>& swings, const std::string& header,
                  const std::function<std::string(std::size_t, double, double)>& cells,
                  std::size_t samples = 2400, double step = 0.05) {
  std::string out = header + "\n";
  for (std::size_t i = 0; i < samples; ++i) {
    double first = 0, second = 0;
    for (const Swing& each : swings) {
      const double x = std::exp(each.value * (static_cast<double>(i) * step)).real();
      first += each.first * x;
      second += each.second * x;
    }
    out += fmt::format("{:.6g},{}\n", static_cast<double>(i) * step, cells(i, first, second));
  }
  return out;
}

const std::vector<Swing> pendulums{{value_of(0.7, 0.002), 0.06, 0.05}, {value_of(0.73, 0.002), 0.05, -0.06}};
const std::string two_angles = "Time (s),Angle 1 (rad),Angle 2 (rad)";
std::string both(std::size_t, double first, double second) {
  return fmt::format("{:.17g},{:.17g}", first, second);
}

std::vector<std::string> codes(const ModesResult& result) {
  std::vector<std::string> all;
  for (const Notice& notice : result.notices) all.push_back(notice.code);
  return all;
}

ModesResult modes_in(const std::string& bytes, const ModesOptions& options = {}) {
  auto result = recording_modes(recording_of(bytes), options);
  EXPECT_TRUE(result) << (result ? "" : result.error().message());
  return result ? *std::move(result) : ModesResult{};
}

std::string refusal(const std::string& bytes, const ModesOptions& options = {}) {
  const auto result = recording_modes(recording_of(bytes), options);
  return result ? "" : result.error().notice.code;
}

TEST(RecordingModes, pendulums_that_were_let_go) {
  const ModesResult result = modes_in(decay(pendulums, two_angles, both));
  ASSERT_TRUE(result.ok());
  EXPECT_THAT(result.names, testing::ElementsAre("Angle 1 (rad)", "Angle 2 (rad)"));
  EXPECT_THAT(codes(result), testing::IsEmpty());
  ASSERT_EQ(result.modes.size(), 2u);
  EXPECT_NEAR(result.modes[0].frequency.value, 0.7, 1e-9);
  EXPECT_NEAR(result.modes[1].frequency.value, 0.73, 1e-9);
  EXPECT_NEAR(result.modes[0].shape[1].real(), 5.0 / 6, 1e-7);
  EXPECT_NEAR(result.modes[1].shape[0].real(), -5.0 / 6, 1e-7);
  ASSERT_TRUE(result.recording);
  EXPECT_EQ(result.recording->words.code, "modes_of_free_decay");
  EXPECT_EQ(result.recording->quantity, "angle");
  EXPECT_EQ(result.recording->samples, 2400u);
  EXPECT_NEAR(result.recording->rate, 20, 1e-9);
}

TEST(RecordingModes, a_channel_that_is_still_or_empty_is_left_out_and_named) {
  const ModesResult still = modes_in(decay(pendulums, two_angles + ",Angle 3 (rad)",
                                           [](auto i, auto a, auto b) { return both(i, a, b) + ",0.25"; }));
  EXPECT_THAT(codes(still), testing::Contains("channel_left_out_still"));
  EXPECT_EQ(still.names.size(), 2u);
  const ModesResult empty =
      modes_in(decay(pendulums, two_angles + ",Angle 3 (rad)",
                     [](auto i, auto a, auto b) { return both(i, a, b) + (i == 7 ? ",0.1" : ",NaN"); }));
  EXPECT_THAT(codes(empty), testing::Contains("channel_left_out_empty"));
  EXPECT_EQ(empty.names.size(), 2u);
  EXPECT_EQ(refusal(decay(pendulums, two_angles, [](auto, auto, auto) { return "0.25,0.5"; })),
            "no_channel_moves");
}

// A long rest after a decay looks like the work of random forces.
TEST(RecordingModes, what_has_died_down_within_the_record_is_a_free_decay) {
  const std::vector<Swing> damped{{value_of(0.68, 0.085), 0.2, 0.15}, {value_of(1.25, 0.16), 0.1, -0.12}};
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 1e-4);
    const auto cells = [&](auto i, auto a, auto b) { return both(i, a + noise(random), b + noise(random)); };
    const ModesResult result = modes_in(decay(damped, two_angles, cells, 1500, 0.04));
    ASSERT_EQ(result.modes.size(), 2u) << seed;
    EXPECT_EQ(result.recording->found.motion, ModalMotion::free_decay) << seed;
    EXPECT_NEAR(result.modes[0].frequency.value, 0.68, 1e-3) << seed;
    EXPECT_NEAR(result.modes[1].damping_ratio.value, 0.16, 3e-3) << seed;
    EXPECT_THAT(codes(result), testing::Contains("rests_at_the_end")) << seed;
    EXPECT_LT(result.recording->duration, 40) << seed;
  }
}

TEST(RecordingModes, of_a_free_decay_those_asked_for_are_told) {
  const std::string bytes =
      decay({{value_of(0.7, 0.004), 0.06, 0.05}, {value_of(1.9, 0.004), 0.02, -0.03}}, two_angles, both);
  const auto frequencies = [&](const ModesOptions& options) {
    std::vector<double> found;
    for (const NaturalMode& mode : modes_in(bytes, options).modes)
      found.push_back(std::round(100 * mode.frequency.value) / 100);
    return found;
  };
  EXPECT_THAT(frequencies({}), testing::ElementsAre(0.7, 1.9));
  EXPECT_THAT(frequencies({.modes = 1}), testing::ElementsAre(0.7));  // of most power
  EXPECT_THAT(frequencies({.from_frequency = full_turn}), testing::ElementsAre(1.9));
  EXPECT_THAT(frequencies({.to_frequency = full_turn}), testing::ElementsAre(0.7));
  const ModesResult none = modes_in(bytes, {.from_frequency = 3 * full_turn});
  EXPECT_EQ(none.message.code, "no_modes_in_band");
  EXPECT_THAT(in_words(none.message), testing::HasSubstr("from 3 to 10 Hz"));
}

TEST(RecordingModes, of_several_runs_one_is_chosen) {
  std::string runs = "Time (s) Run #1,Position (m) Run #1,Time (s) Run #2,Position (m) Run #2\n";
  for (int i = 0; i < 600; ++i) {
    const double t = 0.05 * i, amplitude = std::exp(-0.02 * t);
    runs += fmt::format("{0},{1:.9f},{0},{2:.9f}\n", t, amplitude * std::cos(full_turn * 0.7 * t),
                        amplitude * std::cos(full_turn * 1.3 * t));
  }
  for (const auto& [run, frequency] : {std::pair{1, 0.7}, {2, 1.3}}) {
    const ModesResult result = modes_in(runs, {.run = run});
    ASSERT_EQ(result.modes.size(), 1u) << run;
    EXPECT_NEAR(result.modes[0].frequency.value, frequency, 1e-5) << run;
  }
}

TEST(RecordingModes, a_channel_that_dies_in_full_swing_is_refused_with_its_time) {
  for (const char* stuck : {",0.0123", ",0"}) {
    const auto cells = [&](std::size_t i, double a, double b) {
      return fmt::format("{:.17g}{}", a, i < 1205 ? fmt::format(",{:.17g}", b) : stuck);
    };
    const auto result = recording_modes(recording_of(decay(pendulums, two_angles, cells)), {});
    ASSERT_FALSE(result) << stuck << (result ? testing::PrintToString(in_words(result->notices)) : "");
    EXPECT_THAT(
        result.error().message(),
        testing::HasSubstr("\"Angle 2 (rad)\" stops in full swing and keeps one value from 60.25 s on"));
    EXPECT_EQ(modes_in(decay(pendulums, two_angles, cells), {.to = 60.2}).modes.size(), 2u);
  }
}

TEST(RecordingModes, one_channel_has_modes_without_shapes_and_says_so) {
  const ModesResult result = modes_in(decay(pendulums, "Time (s),Angle (rad)", [](auto, auto first, auto) {
    return fmt::format("{:.17g}", first);
  }));
  EXPECT_THAT(codes(result), testing::Contains("one_channel"));
  ASSERT_EQ(result.modes.size(), 2u);
  EXPECT_NEAR(result.modes[1].frequency.value, 0.73, 1e-9);
}

TEST(RecordingModes, samples_that_a_channel_lacks_are_left_out_of_all) {
  const ModesResult result = modes_in(decay(pendulums, two_angles, [](auto i, double first, double second) {
    return i >= 500 && i < 560 ? fmt::format("{:.17g},", first) : both(i, first, second);
  }));
  EXPECT_THAT(codes(result), testing::Contains("samples_not_in_all_channels"));
  EXPECT_EQ(result.recording->samples, 2340u);
  EXPECT_EQ(result.recording->gaps, 1u);
  ASSERT_EQ(result.modes.size(), 2u);
  EXPECT_NEAR(result.modes[0].frequency.value, 0.7, 1e-9);
}

TEST(RecordingModes, a_clock_that_drifts_is_named) {
  std::string bytes = two_angles + "\n";
  double t = 0;
  for (std::size_t i = 0; i < 2400; ++i) {
    const auto x = [&](std::size_t k) {
      return std::exp(pendulums[k].value * (static_cast<double>(i) * 0.05)).real();
    };
    bytes += fmt::format("{:.9g},{:.9g},{:.9g}\n", t, 0.06 * x(0) + 0.05 * x(1), 0.05 * x(0) - 0.06 * x(1));
    t += 0.05 * (1 + 0.01 * static_cast<double>(i) / 2400);
  }
  EXPECT_THAT(codes(modes_in(bytes)), testing::Contains("clock_drifts"));
  EXPECT_THAT(codes(modes_in(decay(pendulums, two_angles, both))),
              testing::Not(testing::Contains("clock_drifts")));
}

TEST(RecordingModes, motion_without_damping_and_growth_are_said) {
  const std::vector<Swing> steady{{value_of(0.7, 0), 0.06, 0.05}, {value_of(1.3, 0), 0.05, -0.06}};
  const ModesResult undamped = modes_in(decay(steady, two_angles, both));
  EXPECT_EQ(undamped.modes.size(), 2u);
  EXPECT_EQ(undamped.recording->words.code, "modes_of_free_motion");
  EXPECT_THAT(codes(undamped), testing::Each("mode_does_not_decay"));
  const ModesResult growing = modes_in(decay({{value_of(0.7, -0.004), 0.06, 0.05}}, two_angles, both));
  ASSERT_EQ(growing.modes.size(), 1u);
  EXPECT_NEAR(growing.modes[0].damping_ratio.value, -0.004, 1e-9);
  EXPECT_EQ(growing.recording->words.code, "modes_of_free_motion");
  EXPECT_THAT(codes(growing), testing::ElementsAre("mode_grows", "fewer_modes_than_channels"));
}

TEST(RecordingModes, a_machine_among_random_forces_is_said_and_is_no_mode) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const std::complex<double> turn = std::exp(value_of(0.7, 0.02) * 0.05);
  std::complex<double> swing = 0;
  const ModesResult result = modes_in(decay(
      pendulums, two_angles,
      [&](auto i, auto, auto) {
        swing = turn * swing + normal(random);
        const double machine = 10 * std::sin(full_turn * 2.1 * 0.05 * static_cast<double>(i));
        return both(i, swing.imag() + machine + 0.1 * normal(random),
                    0.8 * swing.imag() + machine + 0.1 * normal(random));
      },
      12000));
  EXPECT_THAT(codes(result), testing::Contains("steady_line"));
  ASSERT_EQ(result.modes.size(), 1u);
  EXPECT_NEAR(result.modes[0].frequency.value, 0.7, 0.02);
}

TEST(RecordingModes, noise_has_none_and_says_so) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const ModesResult result = modes_in(decay(
      pendulums, two_angles, [&](auto i, auto, auto) { return both(i, normal(random), normal(random)); }));
  EXPECT_FALSE(result.ok());
  EXPECT_EQ(result.message.code, "no_modes_found");
  EXPECT_TRUE(result.modes.empty());
}

TEST(RecordingModes, a_chosen_stretch_and_a_still_beginning_are_said) {
  const ModesResult part = modes_in(decay(pendulums, two_angles, both), {.from = 10, .to = 60});
  EXPECT_EQ(part.recording->samples, 1001u);
  EXPECT_NEAR(part.recording->duration, 50, 1e-9);
  EXPECT_NEAR(part.modes[1].frequency.value, 0.73, 1e-9);
  const ModesResult late = modes_in(decay(pendulums, two_angles, [](std::size_t i, double a, double b) {
    return i < 200 ? both(i, 0, 0) : both(i, a, b);
  }));
  EXPECT_THAT(in_words(late.notices),
              testing::ElementsAre("for the first 10 s hardly anything moves, or it is held: the result is "
                                   "for the motion from 10 s on; "
                                   "--from takes another beginning"));
  EXPECT_EQ(late.recording->samples, 2200u);
  // A beginning that is asked for is taken.
  const ModesResult asked = modes_in(
      decay(pendulums, two_angles,
            [](std::size_t i, double a, double b) { return i < 200 ? both(i, 0, 0) : both(i, a, b); }),
      {.from = 0});
  EXPECT_EQ(asked.recording->samples, 2400u);
  EXPECT_THAT(codes(asked), testing::Not(testing::Contains("still_before_motion")));
  EXPECT_NEAR(late.recording->duration, 109.95, 1e-9);
  EXPECT_NEAR(late.modes[1].damping_ratio.value, 0.002, 1e-9);
}

TEST(RecordingModes, more_modes_than_channels_are_doubted) {
  std::vector<Swing> three = pendulums;
  three.push_back({value_of(1.9, 0.003), 0.03, 0.04});
  const ModesResult result = modes_in(decay(three, two_angles, both));
  EXPECT_EQ(result.modes.size(), 3u);
  EXPECT_THAT(in_words(result.notices),
              testing::Contains(testing::StartsWith(
                  "there are 3 modes and 2 channels: if each channel is a mass, some of them")));
  const ModesResult one =
      modes_in(decay(pendulums, "Time (s),Angle (rad)",
                     [](std::size_t, double a, double) { return fmt::format("{:.17g}", a); }));
  EXPECT_THAT(codes(one), testing::Not(testing::Contains("more_modes_than_channels")));
}

TEST(RecordingModes, bad_options_are_refused) {
  const std::string bytes = decay(pendulums, two_angles, both);
  EXPECT_EQ(refusal(bytes, {.from = 3, .to = 3}), "from_behind_to");
  EXPECT_EQ(refusal(bytes, {.from = 300}), "nothing_left_from");
  EXPECT_EQ(refusal(bytes, {.method = {"newmark"}, .step = 0.01}), "method_of_networks");
  EXPECT_EQ(refusal(bytes, {.of_method = "newmark"}), "of_method_needs_step");
  EXPECT_EQ(refusal(bytes, {.step = 0.01}), "step_needs_of_method");
  EXPECT_EQ(refusal(bytes, {.step = 0.5, .of_method = "newmark"}), "step_not_of_record");
  const auto adaptive = recording_modes(recording_of(bytes), {.step = 0.01, .of_method = "dormand-prince"});
  EXPECT_EQ(in_words(adaptive.error()), "--of-method: dormand-prince chooses its own steps");
  EXPECT_EQ(in_words(recording_modes(recording_of(bytes), {.beta = 0.3}).error()),
            "--beta needs --of-method and --step");
  EXPECT_EQ(refusal(bytes, {.from_frequency = 3, .to_frequency = 2}), "frequencies_reversed");
  EXPECT_EQ(refusal(decay(pendulums, two_angles, both, 39)), "too_few_samples_for_modes");
  std::string runs = "Time (s) Run #1,Angle (rad) Run #1,Time (s) Run #2,Angle (rad) Run #2\n";
  for (int i = 0; i < 60; ++i) runs += fmt::format("{0},{1},{0},{1}\n", 0.1 * i, std::cos(0.3 * i));
  EXPECT_EQ(refusal(runs), "choose_one_run");
  EXPECT_THAT(in_words(recording_modes(recording_of(runs), {.run = 3}).error()),
              testing::HasSubstr("there is no run 3: the file has 2 runs"));
  Network network;
  network.masses.push_back({.name = "a"});
  EXPECT_EQ(network_modes(network, "n.toml", {.modes = 2}).error().notice.code, "option_of_recordings");
}

// A table that is bumped during the swing: the fit takes most of the push for other frequencies and dampings.
TEST(RecordingModes, what_a_second_push_leaves_widens_the_intervals_and_is_said) {
  int held = 0, said = 0, of_undisturbed = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 1e-4);
    const double at = 30 + 3 * seed, size = 0.002 + 2e-4 * seed;
    const std::vector<Swing> push{{pendulums[0].value, size, size}, {pendulums[1].value, size, -size}};
    const auto pushed = [&](bool is_pushed) {
      return modes_in(decay(pendulums, two_angles, [&](std::size_t i, double a, double b) {
        const double since = 0.05 * static_cast<double>(i) - at;
        for (const Swing& each : push)
          if (const double x = std::exp(each.value * since).imag(); is_pushed && since > 0)
            a += each.first * x, b += each.second * x;
        return both(i, a + noise(random), b + noise(random));
      }));
    };
    const ModesResult result = pushed(true), undisturbed = pushed(false);
    ASSERT_EQ(result.modes.size(), 2u);
    const auto is_said = [](const ModesResult& of) {
      const std::vector<std::string> all = codes(of);
      return std::find(all.begin(), all.end(), "modes_leave_a_motion") != all.end();
    };
    said += is_said(result);
    of_undisturbed += is_said(undisturbed);
    for (std::size_t j = 0; j < 2; ++j) {
      const Estimate& found = result.modes[j].frequency;
      const double truth = std::abs(pendulums[j].value) / full_turn;
      held += found.low <= truth && truth <= found.high;
    }
  }
  EXPECT_GE(said, 18);
  EXPECT_EQ(of_undisturbed, 0);
  EXPECT_GE(held, 32);
}

TEST(RecordingModes, a_mode_that_its_method_feeds_is_not_called_fed) {
  const double h = 0.05;
  const auto simulated = [&](double frequency, double damping_ratio) {
    const double w = full_turn * frequency;
    const EffectiveOscillator seen = effective_oscillator_of(
        "forward-euler", {}, {.decay_rate = damping_ratio * w, .stiffness = w * w}, h);
    return std::complex<double>(-*seen.decay_rate, *seen.angular_frequency);
  };
  const std::vector<Swing> swings{{simulated(0.1, 0.01), 1e-3, 8e-4}, {simulated(0.15, 0.012), 1e-3, -7e-4}};
  const std::string bytes = decay(swings, two_angles, both, 2400, h);
  EXPECT_THAT(codes(modes_in(bytes)), testing::Contains("mode_grows"));
  const ModesResult result = modes_in(bytes, {.step = h, .of_method = "forward-euler"});
  ASSERT_EQ(result.modes.size(), 2u);
  EXPECT_NEAR(result.modes[0].damping_ratio.value, 0.01, 1e-6);
  EXPECT_THAT(codes(result), testing::Not(testing::Contains("mode_grows")));
}

TEST(RecordingModes, an_option_that_the_method_has_no_use_for_is_named) {
  const ModesResult result =
      modes_in(decay(pendulums, two_angles, both), {.step = 0.05, .beta = 0.3, .of_method = "rk4"});
  EXPECT_THAT(in_words(result.notices), testing::Contains("--beta has no effect on rk4"));
}

TEST(RecordingModes, the_law_before_a_method_is_what_the_method_was_given) {
  const double h = 0.05, frequency = 1.5, damping_ratio = 0.03;
  const LinearLaw<double> law{.decay_rate = damping_ratio * full_turn * frequency,
                              .stiffness = std::pow(full_turn * frequency, 2)};
  int methods = 0;
  for (const MethodInfo& info : method_infos) {
    if (!info.takes_fixed_steps()) continue;
    const EffectiveOscillator seen = effective_oscillator_of(info.name, {}, law, h);
    const double w = std::hypot(*seen.decay_rate, *seen.angular_frequency);
    const auto before = law_before_method(info.name, {}, h, w / full_turn, *seen.decay_rate / w);
    ASSERT_TRUE(before) << info.name;
    EXPECT_NEAR(before->frequency, frequency, 1e-9) << info.name;
    EXPECT_NEAR(before->damping_ratio, damping_ratio, 1e-9) << info.name;
    ++methods;
  }
  EXPECT_GT(methods, 8);
  // Average acceleration swings at pi/h at most.
  EXPECT_FALSE(law_before_method("newmark", {}, h, 0.6 / h, 0.01));
}

TEST(RecordingModes, the_share_of_the_method_that_simulated_it_is_taken_out_and_named) {
  const double h = 0.1;
  const auto simulated = [&](double frequency, double damping_ratio) {
    const double w = full_turn * frequency;
    const EffectiveOscillator seen =
        effective_oscillator_of("newmark", {}, {.decay_rate = damping_ratio * w, .stiffness = w * w}, h);
    return std::complex<double>(-*seen.decay_rate, *seen.angular_frequency);
  };
  const std::vector<Swing> swings{{simulated(0.7, 0.002), 0.06, 0.05}, {simulated(1.9, 0.01), 0.05, -0.06}};
  const ModesResult result =
      modes_in(decay(swings, two_angles, both, 2400, h), {.step = h, .of_method = "newmark"});
  ASSERT_EQ(result.modes.size(), 2u);
  EXPECT_NEAR(result.modes[0].frequency.value, 0.7, 1e-8);
  EXPECT_NEAR(result.modes[0].damping_ratio.value, 0.002, 1e-8);
  EXPECT_NEAR(result.modes[1].frequency.value, 1.9, 1e-8);
  EXPECT_NEAR(result.modes[1].damping_ratio.value, 0.01, 1e-8);
  ASSERT_EQ(result.modes[1].methods.size(), 1u);
  EXPECT_NEAR(*result.modes[1].methods[0].frequency(), std::abs(swings[1].value) / full_turn, 1e-9);
  EXPECT_LT(*result.modes[1].methods[0].frequency(), 0.95 * 1.9);
}

// ../shared/data/networks, as a stranger would.
TEST(RecordingModes, shear_frame) {
  std::ifstream file(CROMER_SOURCE_DIR "/../shared/data/networks/shear_frame.csv");
  if (!file) GTEST_SKIP() << "no ../shared/data";
  std::ostringstream bytes;
  bytes << file.rdbuf();
  const ModesResult result = modes_in(bytes.str());
  EXPECT_EQ(result.recording->words.code, "modes_of_random_forces");
  ASSERT_EQ(result.modes.size(), 4u);
  EXPECT_NEAR(result.modes[3].frequency.value, 8.3831, 0.006 * 8.3831);
  EXPECT_EQ(result.recording->quantity, "acceleration");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
