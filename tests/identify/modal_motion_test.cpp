// What kind of motion a record of several channels shows: random forces, a machine, a free decay, growth.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/analysis/complex_modes.h"
#include "cromer/identify/modal/decay_fit.h"
#include "cromer/identify/modal/modal_analysis.h"
#include "cromer/identify/modal/still_beginning.h"
#include "tests/identify/modal_records.h"

namespace cromer::core {
namespace CROMER_FILE {

std::vector<TrueMode> three_masses() {
  return {{2.1, 0.010, {0.4, 0.7, 1.0}}, {5.2, 0.012, {-0.9, -0.4, 1.0}}, {7.6, 0.020, {0.7, -1.0, 0.4}}};
}

double rms(const std::vector<double>& values) {
  double square = 0;
  for (const double each : values) square += each * each / static_cast<double>(values.size());
  return std::sqrt(square);
}

// A machine of this strength, as a share of each channel's rms, whose phase wanders by so many radians in a
// second.
void add_machine(MadeChannels& channels, double frequency, double share, double wander, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> phase(channels.values.front().size());
  double angle = 0.3;
  for (double& each : phase) {
    each = angle;
    angle +=
        2 * std::numbers::pi * frequency * channels.step + wander * std::sqrt(channels.step) * normal(random);
  }
  for (auto& channel : channels.values) {
    const double amplitude = std::sqrt(2) * share * rms(channel);
    for (std::size_t i = 0; i < channel.size(); ++i) channel[i] += amplitude * std::sin(phase[i]);
  }
}

TEST(ModalMotion, a_machine_among_random_forces_is_a_line_and_no_mode) {
  const std::vector<TrueMode> truth = three_masses();
  int held = 0, found = 0;
  const int records = 20;
  for (int seed = 0; seed < records; ++seed) {
    MadeChannels channels = under_white_forces(truth, 15000, 0.04, static_cast<unsigned>(seed));
    add_machine(channels, 4.2, seed % 2 ? 1.5 : 0.4, 0, 7);
    const ModalAnalysis analysis = find_modes(channels.record());
    EXPECT_EQ(analysis.motion, ModalMotion::ambient);
    ASSERT_EQ(analysis.lines.size(), 1u);
    EXPECT_NEAR(analysis.lines[0], 4.2, 1e-4);
    ASSERT_LE(analysis.modes.size(), truth.size());
    for (const MeasuredMode& mode : analysis.modes)
      for (const TrueMode& each : truth)
        if (std::abs(mode.frequency.value - each.frequency) < 0.03 * each.frequency)
          ++found, held += holds(mode.frequency, each.frequency);
  }
  EXPECT_GE(found, 3 * records - 2);
  EXPECT_GE(held, 51);  // 95 % of 60, to three standard deviations
}

TEST(ModalMotion, a_machine_on_a_mode_leaves_the_mode) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    MadeChannels channels = under_white_forces(three_masses(), 15000, 0.04, seed);
    add_machine(channels, 5.2, 1, 0, 7);
    const ModalAnalysis analysis = find_modes(channels.record());
    EXPECT_EQ(analysis.motion, ModalMotion::ambient);
    ASSERT_EQ(analysis.lines.size(), 1u);
    ASSERT_EQ(analysis.modes.size(), 3u);
    EXPECT_NEAR(analysis.modes[1].damping_ratio.value, 0.012, 0.005);
  }
}

TEST(ModalMotion, random_forces_alone_show_no_line) {
  int lines = 0;
  for (unsigned seed = 0; seed < 30; ++seed)
    lines += !find_modes(under_white_forces(two_masses(), 6000, 0.0625, seed).record()).lines.empty();
  EXPECT_EQ(lines, 0);
}

TEST(ModalMotion, a_decay_beside_a_machine_is_still_a_decay) {
  MadeChannels channels = let_go(two_masses(), {1, 0.5}, 1200, 0.05, 0.01, 1);
  add_machine(channels, 3, 0.3, 0, 1);
  const ModalAnalysis analysis = find_modes(channels.record());
  EXPECT_EQ(analysis.motion, ModalMotion::free_decay);
  ASSERT_EQ(analysis.modes.size(), 3u);
  const double truth[] = {0.006, 0, 0.012};
  for (std::size_t j = 0; j < 3; ++j) {
    const Estimate& estimate = analysis.modes[j].damping_ratio;
    EXPECT_NEAR(estimate.value, truth[j], 4 * estimate.standard_error);
    EXPECT_LT(estimate.standard_error, 1e-4);
  }
}

TEST(ModalMotion, a_motion_without_damping_has_modes) {
  const std::vector<TrueMode> truth{{1.7, 0, {1.0, 0.8}}, {4.7, 0, {-0.8, 1.0}}};
  for (const double noise : {0.0, 0.02}) {
    const ModalAnalysis analysis = find_modes(let_go(truth, {1, 0.5}, 1200, 0.05, noise, 1).record());
    EXPECT_EQ(analysis.motion, ModalMotion::free_decay);
    ASSERT_EQ(analysis.modes.size(), 2u);
    EXPECT_NEAR(analysis.modes[0].frequency.value, 1.7, 1e-4);
    EXPECT_NEAR(analysis.modes[0].damping_ratio.value, 0, 1e-5);
  }
}

// Its correlations look like those of a decay as fast.
TEST(ModalMotion, growth_is_told_from_decay) {
  for (const double damping_ratio : {-0.004, -0.03}) {
    const std::vector<TrueMode> truth{{1.7, damping_ratio, {1.0, 0.8}}, {4.7, 0.01, {-0.8, 1.0}}};
    for (const double noise : {0.0, 0.05}) {
      const ModalAnalysis analysis = find_modes(let_go(truth, {0.1, 0.1}, 1200, 0.05, noise, 2).record());
      EXPECT_EQ(analysis.motion, ModalMotion::free_decay);
      ASSERT_GE(analysis.modes.size(), 1u);
      EXPECT_NEAR(analysis.modes[0].frequency.value, 1.7, 0.001);
      EXPECT_NEAR(analysis.modes[0].damping_ratio.value, damping_ratio, 0.0003);
    }
  }
}

TEST(ModalMotion, a_free_body_that_drifts_away_hides_no_mode) {
  MadeChannels channels = let_go(two_masses(), {0.1, 0.05}, 800, 0.05, 0.02, 3);
  for (auto& channel : channels.values)
    for (std::size_t i = 0; i < channel.size(); ++i) channel[i] += 3 + 0.01 * static_cast<double>(i);
  const ModalAnalysis analysis = find_modes(channels.record());
  EXPECT_EQ(analysis.motion, ModalMotion::free_decay);
  ASSERT_EQ(analysis.modes.size(), 2u);
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_TRUE(holds(analysis.modes[j].frequency, two_masses()[j].frequency));
    EXPECT_TRUE(holds(analysis.modes[j].damping_ratio, two_masses()[j].damping_ratio));
  }
}

TEST(ModalMotion, a_mode_that_hardly_moves_is_found_in_what_the_others_leave) {
  const ModalAnalysis analysis =
      find_modes(let_go(three_masses(), {0.01, 0.003, 1e-6}, 750, 0.04, 0, 1).record());
  ASSERT_EQ(analysis.modes.size(), 3u);
  for (std::size_t j = 0; j < 3; ++j) {
    EXPECT_NEAR(analysis.modes[j].frequency.value, three_masses()[j].frequency, 1e-6);
    EXPECT_NEAR(analysis.modes[j].damping_ratio.value, three_masses()[j].damping_ratio, 1e-6);
  }
}

// The motion of a mode whose frequency is known to worse than 1 % is no noise to the others.
TEST(ModalMotion, a_mode_that_is_not_reported_does_not_widen_the_others) {
  const std::vector<TrueMode> truth{{1.7, 0.01, {0.7, 1.0}}, {2.3, 0.15, {1.0, -0.8}}};
  double deviation = 0, estimated = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const ModalAnalysis analysis = find_modes(let_go(truth, {1, 1}, 400, 0.05, 0.4, seed).record());
    ASSERT_GE(analysis.modes.size(), 1u);
    const Estimate& frequency = analysis.modes.front().frequency;
    deviation += std::pow(frequency.value - 1.7, 2);
    estimated += std::pow(frequency.standard_error, 2);
  }
  EXPECT_NEAR(std::sqrt(estimated / deviation), 1, 0.25);
}

// At rest until a hit, or held where it is let go.
MadeChannels beginning_late(std::vector<TrueMode> modes, std::size_t still, bool hit, unsigned seed) {
  if (hit)
    for (TrueMode& mode : modes)
      for (std::complex<double>& each : mode.shape) each *= std::complex<double>(0, -1);  // a quarter later
  MadeChannels channels = let_go(modes, {1, 0.5, 0.3}, 1500, 0.02, 0, 0);
  for (auto& channel : channels.values) channel.insert(channel.begin(), still, hit ? 0 : channel.front());
  std::mt19937 random(seed);
  add_noise(channels, 0.01, random);
  return channels;
}

TEST(ModalMotion, a_motion_that_begins_within_the_record_is_told_from_there) {
  const std::vector<TrueMode> truth = three_masses();
  int held = 0, all = 0;
  for (const bool hit : {true, false})
    for (const std::size_t still : {12u, 50u, 400u})
      for (unsigned seed = 0; seed < 5; ++seed) {
        const ModalAnalysis found = find_modes(beginning_late(truth, still, hit, seed).record());
        EXPECT_EQ(found.motion, ModalMotion::free_decay);
        EXPECT_GE(found.still, still);
        EXPECT_LE(found.still, still + 3);
        ASSERT_EQ(found.modes.size(), truth.size()) << still << hit;
        for (std::size_t j = 0; j < truth.size(); ++j) {
          held += holds(found.modes[j].frequency, truth[j].frequency) +
                  holds(found.modes[j].damping_ratio, truth[j].damping_ratio);
          all += 2;
        }
      }
  EXPECT_EQ(all, 180);
  EXPECT_GE(held, 162);  // 95 %, to three standard deviations
}

TEST(ModalMotion, a_late_beginning_is_found_in_noise_and_beside_a_channel_that_hardly_moves) {
  std::vector<TrueMode> truth = three_masses();
  for (TrueMode& mode : truth) mode.shape[0] *= 1e-3;
  int held = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    MadeChannels channels = beginning_late(truth, 400, seed % 2 == 0, seed);
    std::mt19937 random(seed + 100);
    add_noise(channels, 0.1, random);
    const ModalAnalysis found = find_modes(channels.record());
    EXPECT_EQ(found.motion, ModalMotion::free_decay) << seed;
    EXPECT_GE(found.still, 400u);
    EXPECT_LE(found.still, 406u);
    ASSERT_FALSE(found.modes.empty());
    held += holds(found.modes[0].damping_ratio, truth[0].damping_ratio);
  }
  EXPECT_GE(held, 8);
}

// Held for 2 s, then let go over so many seconds, slowly at first and at last.
MadeChannels let_go_over(double seconds, const std::vector<TrueMode>& modes, unsigned seed) {
  constexpr std::size_t samples = 1500, held = 100, parts = 200;
  constexpr double step = 0.02, h = step / parts;
  MadeChannels channels{
      std::vector<std::vector<double>>(modes.front().shape.size(), std::vector<double>(samples)), step};
  for (const TrueMode& mode : modes) {
    const std::complex<double> value = mode.eigenvalue();
    const double w2 = std::norm(value), c = -2 * value.real();
    const auto pull = [&](double t) {
      const double s = std::clamp((t - held * step) / seconds, 0.0, 1.0);
      return w2 * (1 - s * s * (3 - 2 * s));
    };
    double x = 1, v = 0;
    for (std::size_t i = 0; i < samples; ++i) {
      for (std::size_t k = 0; k < channels.values.size(); ++k)
        channels.values[k][i] += mode.shape[k].real() * x;
      for (std::size_t part = 0; part < parts; ++part) {
        const double t = step * static_cast<double>(i) + h * static_cast<double>(part);
        const double middle = v + h / 2 * (pull(t) - c * v - w2 * x);
        x += h * middle;
        v = (middle + h / 2 * (pull(t + h) - w2 * x)) / (1 + h / 2 * c);
      }
    }
  }
  std::mt19937 random(seed);
  add_noise(channels, 0.003, random);
  return channels;
}

TEST(ModalMotion, a_release_that_takes_its_time_is_no_part_of_the_free_motion) {
  for (const double seconds : {0.1, 0.3, 0.5}) {
    int held = 0, all = 0;
    for (unsigned seed = 0; seed < 4; ++seed) {
      const ModalAnalysis found = find_modes(let_go_over(seconds, two_masses(), seed).record());
      ASSERT_EQ(found.motion, ModalMotion::free_decay) << seconds;
      EXPECT_GT(found.released, 0u) << seconds;
      EXPECT_GE(found.still, 100 + found.released) << seconds;
      EXPECT_LE(found.still, 150u) << seconds;
      for (const MeasuredMode& mode : found.modes)
        for (const TrueMode& truth : two_masses())
          if (std::abs(mode.frequency.value - truth.frequency) < 0.1) {
            held += holds(mode.frequency, truth.frequency) + holds(mode.damping_ratio, truth.damping_ratio);
            all += 2;
          }
    }
    EXPECT_EQ(all, 16) << seconds;
    EXPECT_GE(held, 13) << seconds;
  }
  EXPECT_EQ(find_modes(beginning_late(two_masses(), 100, false, 1).record()).released, 0u);
  EXPECT_EQ(find_modes(beginning_late(two_masses(), 100, true, 1).record()).released, 0u);
}

// A hand moves both masses at first, slowly and as far as they swing later.
void move_by_hand_at_first(MadeChannels& channels, std::size_t samples, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(0, 1);
  for (auto& channel : channels.values) {
    std::vector<double> hand(samples + 1, 0);
    const double size = rms(channel);
    for (int k = 0; k < 4; ++k) {
      const double w = 2 * std::numbers::pi * (0.2 + any(random)), phase = 7 * any(random);
      for (std::size_t i = 0; i < hand.size(); ++i)
        hand[i] += size * std::sin(w * static_cast<double>(i) * channels.step + phase);
    }
    for (std::size_t i = 0; i < samples; ++i) hand[i] += channel.front() - hand.back();
    channel.insert(channel.begin(), hand.begin(), hand.end() - 1);
  }
}

TEST(ModalMotion, what_a_hand_moves_at_first_is_no_part_of_the_free_motion) {
  const std::vector<TrueMode> truth{{0.7, 0.01, {1.0, 1.0}}, {0.81, 0.008, {-1.0, 1.0}}};
  int intervals = 0, held = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::size_t moved = 200 + 40 * seed;
    MadeChannels channels = let_go(truth, {1, 0.8}, 2500, 0.02, 0.01, seed);
    move_by_hand_at_first(channels, moved, seed);
    const ModalAnalysis found = find_modes(channels.record());
    ASSERT_EQ(found.motion, ModalMotion::free_decay) << seed;
    EXPECT_GT(found.still + 60, moved) << seed;
    EXPECT_LT(found.still, moved + 100) << seed;
    EXPECT_EQ(found.released, found.still);
    ASSERT_EQ(found.modes.size(), truth.size()) << seed;
    for (std::size_t j = 0; j < truth.size(); ++j)
      ++intervals, held += holds(found.modes[j].frequency, truth[j].frequency);
  }
  EXPECT_GE(held, intervals - 5);  // of 40, to two standard deviations
}

TEST(ModalMotion, few_samples_have_no_still_beginning) {
  MadeChannels channels = beginning_late(two_masses(), 30, true, 1);
  for (auto& channel : channels.values) channel.resize(48);
  EXPECT_EQ(still_samples(channels.record()), 0u);
  for (auto& channel : channels.values) channel.resize(20);
  EXPECT_EQ(still_samples(channels.record()), 0u);
}

TEST(ModalMotion, what_moves_from_the_first_sample_on_keeps_all_samples) {
  // At a turning point it moves little at first; a slow swing beside a fast rate, all the more.
  const std::vector<TrueMode> slow = {{0.31, 0.01, {1.0, 0.8}}};
  for (unsigned seed = 0; seed < 5; ++seed) {
    EXPECT_EQ(find_modes(let_go(three_masses(), {1, 0.5, 0.3}, 1500, 0.02, 0.01, seed).record()).still, 0u);
    EXPECT_EQ(find_modes(let_go(slow, {1}, 3000, 0.01, 1e-3, seed).record()).still, 0u);
    EXPECT_EQ(find_modes(under_white_forces(three_masses(), 3000, 0.04, seed).record()).still, 0u);
  }
}

TEST(ModalMotion, a_swing_that_passes_to_another_mass_is_no_still_beginning) {
  // Of two pendulums one is let go: while it swings, the other hardly moves yet.
  const std::vector<TrueMode> pendulums{{0.7068, 7e-4, {1.0, 1.0}}, {0.729, 7e-4, {1.0, -1.0}}};
  for (const double seconds : {20.0, 30.0, 40.0, 80.0})
    for (const double noise : {1e-3, 0.02}) {
      const auto samples = static_cast<std::size_t>(seconds / 0.05);
      EXPECT_EQ(still_samples(let_go(pendulums, {0.05, -0.05}, samples, 0.05, noise, 4).record()), 0u)
          << seconds << ' ' << noise;
    }
}

TEST(ModalMotion, a_pendulum_that_another_moves_has_no_still_beginning) {
  // The left one is let go at 0.1 rad; the right one, of which alone there is a record, hardly moves at
  // first.
  const double h = 2e-3, w2 = 19.6, tie = 0.62, damping = 0.012;
  double left = 0.1, right = 0, v_left = 0, v_right = 0;
  MadeChannels made{{{}}, 0.02};
  for (int i = 0; i < 30000; ++i) {
    if (i % 10 == 0) made.values[0].push_back(1e-4 * std::round(1e4 * right));
    const double a = -w2 * std::sin(left) - tie * (left - right) - damping * v_left,
                 b = -w2 * std::sin(right) - tie * (right - left) - damping * v_right;
    left += h * (v_left += h * a);
    right += h * (v_right += h * b);
  }
  EXPECT_EQ(find_modes(made.record()).still, 0u);
}

TEST(ModalMotion, no_mode_is_faster_than_half_the_rate) {
  // Begun at an alias, least squares ends there: at even times it is the same motion.
  const std::vector<TrueMode> two = two_masses();
  const MadeChannels made = let_go(two, {0.3, 0.1}, 800, 0.05, 0.001, 3);
  const ModalRecord record = made.record();
  const double rate = 2 * std::numbers::pi / record.step;
  const auto found =
      fit_eigenvalues(record, values_of(record),
                      {two[0].eigenvalue(), two[1].eigenvalue() + std::complex<double>(0, 5 * rate)});
  ASSERT_TRUE(found);
  EXPECT_NEAR((*found)[1].imag(), two[1].eigenvalue().imag(), 1e-3);
}

TEST(ModalMotion, gaps_stay_where_they_are_behind_a_still_beginning) {
  const MadeChannels channels = let_go(two_masses(), {1, 1}, 100, 0.02, 0, 0);
  ModalRecord record = channels.record();
  record.starts = {0, 10, 30, 60};
  for (std::size_t i = 0; i < 100; ++i) record.times.push_back(0.02 * static_cast<double>(i) + 5);
  const ModalRecord part = from_sample(record, 30);
  EXPECT_THAT(part.starts, testing::ElementsAre(0, 30));
  EXPECT_EQ(part.samples(), 70u);
  EXPECT_EQ(part.times.size(), 70u);
  EXPECT_EQ(part.time(0), 0.02 * 30 + 5);
  EXPECT_EQ(part.channels[1][0], channels.values[1][30]);
  EXPECT_EQ(from_sample(channels.record(), 30).samples(), 70u);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
