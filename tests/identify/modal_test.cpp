// Modes from records of several channels: simulated ones, whose modes are known, and the frame and the
// pendulums of ../shared/data.
#include "cromer/identify/modal/modal_analysis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <complex>
#include <fstream>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <string>

#include "cromer/analysis/complex_modes.h"
#include "cromer/identify/modal/block_correlations.h"
#include "cromer/identify/modal/subspace.h"
#include "tests/identify/modal_records.h"

namespace cromer::core {
namespace CROMER_FILE {

// A recording of ../shared/data/networks: its channels, without the times; empty if it is not there.
MadeChannels shared_recording(const std::string& name) {
  std::ifstream file(CROMER_SOURCE_DIR "/../shared/data/networks/" + name);
  MadeChannels channels;
  std::string line;
  std::getline(file, line);
  std::vector<double> times;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (std::size_t c = 0; std::getline(cells, cell, ','); ++c) {
      if (c == 0) {
        times.push_back(std::stod(cell));
        continue;
      }
      if (channels.values.size() < c) channels.values.emplace_back();
      channels.values[c - 1].push_back(std::stod(cell));
    }
  }
  if (times.size() > 1)
    channels.step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  return channels;
}

TEST(Modal, a_gap_begins_a_stretch_where_it_is) {
  std::vector<double> t;
  for (int i = 0; i < 100; ++i) t.push_back(0.1 * i + (i < 30 ? 0 : 2) + (i < 70 ? 0 : 5));
  ModalRecord record;
  set_times(record, t);
  EXPECT_EQ(record.starts, (std::vector<std::size_t>{0, 30, 70}));
  EXPECT_NEAR(record.step, 0.1, 1e-12);
}

TEST(Modal, modal_assurance_is_one_for_the_same_shape_turned_and_nought_for_an_orthogonal_one) {
  const std::vector<std::complex<double>> a{1.0, {0.5, 0.2}}, b{{0, 2.0}, {-0.4, 1.0}}, c{{-0.5, 0.2}, 1.0};
  EXPECT_NEAR(modal_assurance(a, b), 1, 1e-14);
  EXPECT_NEAR(modal_assurance(a, c), 0, 1e-14);
}

TEST(Modal, correlations_of_blocks_are_those_of_the_whole_and_none_spans_a_gap) {
  const MadeChannels channels = under_white_forces(two_masses(), 500, 0.05, 3);
  ModalRecord record = channels.record();
  record.starts = {0, 200};
  const ScaledChannels scaled = scale_channels(record);
  const BlockCorrelations blocks = block_correlations(scaled, record, 7, 2, 10);
  for (int l = 0; l < 7; ++l) {
    const int shift = 2 * (l + 1);
    double sum = 0;
    int count = 0;
    for (int i = 0; i + shift < 500; ++i) {
      if (i < 200 && i + shift >= 200) continue;
      sum += scaled.values(1, i + shift) * scaled.values(0, i);
      ++count;
    }
    EXPECT_EQ(blocks.count(l), count);
    EXPECT_NEAR(blocks.mean(1, 2 * l), sum / count, 1e-12);
  }
}

// The derivative that the intervals rest on, against a difference.
TEST(Modal, derivatives_of_poles_and_shapes_are_those_of_differences) {
  const MadeChannels channels = under_white_forces(two_masses(), 4000, 0.0625, 5);
  const ModalRecord record = channels.record();
  const ScaledChannels scaled = scale_channels(record);
  const int rows = 12, order = 8;
  BlockCorrelations correlations = block_correlations(scaled, record, 2 * rows - 1, 1, 20);
  const auto pole_near = [&](const BlockCorrelations& of, std::complex<double> where,
                             std::complex<double>& component, Eigen::MatrixXcd* by_value,
                             Eigen::MatrixXcd* by_shape) {
    Subspace subspace(of, rows, scaled.scale);
    subspace.prepare(order);
    const ModelPoles poles = subspace.poles(order);
    Eigen::Index nearest = 0;
    for (Eigen::Index j = 1; j < order; ++j)
      if (std::abs(poles.values(j) - where) < std::abs(poles.values(nearest) - where)) nearest = j;
    const Eigen::VectorXcd shape = subspace.shape(poles, nearest);
    component = shape(1) / shape(0);
    if (by_value) *by_value = subspace.value_gradient(poles, nearest);
    if (by_shape) *by_shape = subspace.shape_gradient(poles, nearest, 0, 1);
    return poles.values(nearest);
  };
  const std::complex<double> where = std::exp(two_masses()[1].eigenvalue() * 0.0625);
  Eigen::MatrixXcd by_value, by_shape;
  std::complex<double> component, plus_component, minus_component;
  pole_near(correlations, where, component, &by_value, &by_shape);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd direction(correlations.mean.rows(), correlations.mean.cols());
  for (double& each : direction.reshaped()) each = normal(random);
  const double h = 1e-7;
  const Eigen::MatrixXd mean = correlations.mean;
  correlations.mean = mean + h * direction;
  const auto plus = pole_near(correlations, where, plus_component, nullptr, nullptr);
  correlations.mean = mean - h * direction;
  const auto minus = pole_near(correlations, where, minus_component, nullptr, nullptr);
  const std::complex<double> expected = by_value.cwiseProduct(direction).sum(),
                             expected_shape = by_shape.cwiseProduct(direction).sum();
  EXPECT_LT(std::abs((plus - minus) / (2 * h) - expected), 1e-5 * std::abs(expected));
  EXPECT_LT(std::abs((plus_component - minus_component) / (2 * h) - expected_shape),
            1e-5 * std::abs(expected_shape));
}

TEST(Modal, two_masses_under_random_forces_have_their_modes_in_the_intervals) {
  const std::vector<TrueMode> truth = two_masses();
  int records = 40, frequencies = 0, dampings = 0, found = 0;
  for (int seed = 0; seed < records; ++seed) {
    const MadeChannels channels = under_white_forces(truth, 6000, 0.0625, static_cast<unsigned>(100 + seed));
    const ModalAnalysis analysis = find_modes(channels.record());
    EXPECT_EQ(analysis.motion, ModalMotion::ambient);
    EXPECT_LE(analysis.modes.size(), truth.size());
    for (const MeasuredMode& mode : analysis.modes)
      for (const TrueMode& each : truth) {
        if (std::abs(mode.frequency.value - each.frequency) > 0.02 * each.frequency) continue;
        ++found;
        frequencies += holds(mode.frequency, each.frequency);
        dampings += holds(mode.damping_ratio, each.damping_ratio);
        EXPECT_GT(modal_assurance(mode.shape, each.shape), 0.999);
      }
  }
  EXPECT_GE(found, 2 * records - 3);
  // 95 % of 80, to three standard deviations.
  EXPECT_GE(frequencies, 70);
  EXPECT_GE(dampings, 70);
}

TEST(Modal, intervals_narrow_as_the_root_of_the_length) {
  const MadeChannels brief = under_white_forces(two_masses(), 8000, 0.0625, 8),
                     longer = under_white_forces(two_masses(), 128000, 0.0625, 8);
  const auto short_modes = find_modes(brief.record()).modes, long_modes = find_modes(longer.record()).modes;
  ASSERT_EQ(short_modes.size(), 2u);
  ASSERT_EQ(long_modes.size(), 2u);
  EXPECT_NEAR(short_modes[1].frequency.standard_error / long_modes[1].frequency.standard_error, 4, 1.5);
}

TEST(Modal, noise_has_no_modes) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (int run = 0; run < 6; ++run) {
    MadeChannels channels{std::vector<std::vector<double>>(3, std::vector<double>(8000)), 0.05};
    for (auto& channel : channels.values) {
      double walk = 0;
      for (double& each : channel) {
        walk += 0.02 * normal(random);
        each = normal(random) + (run % 2) * walk;
      }
    }
    EXPECT_TRUE(find_modes(channels.record()).modes.empty());
  }
}

TEST(Modal, a_gap_costs_its_samples_and_no_more) {
  MadeChannels channels = under_white_forces(two_masses(), 12000, 0.0625, 12);
  for (auto& channel : channels.values) channel.erase(channel.begin() + 5000, channel.begin() + 5777);
  ModalRecord record = channels.record();
  record.starts = {0, 5000};
  const auto modes = find_modes(record).modes;
  ASSERT_EQ(modes.size(), 2u);
  EXPECT_TRUE(holds(modes[0].frequency, 1.6));
  EXPECT_TRUE(holds(modes[1].frequency, 4.5));
}

// Without these samples, at their own times.
struct WithoutSamples {
  MadeChannels channels;
  std::vector<double> times;

  WithoutSamples(MadeChannels all, const std::vector<std::size_t>& lost) : channels(std::move(all)) {
    for (std::size_t i = 0; i < channels.values.front().size(); ++i)
      times.push_back(static_cast<double>(i) * channels.step);
    for (auto i = lost.rbegin(); i != lost.rend(); ++i) {
      const auto place = static_cast<std::ptrdiff_t>(*i);
      times.erase(times.begin() + place);
      for (auto& channel : channels.values) channel.erase(channel.begin() + place);
    }
  }
  ModalRecord record() const {
    ModalRecord record = channels.record();
    set_times(record, times);
    return record;
  }
};

TEST(Modal, gaps_of_up_to_twenty_samples_are_filled_in_by_lines) {
  MadeChannels channels{{{}}, 0.5};
  for (int i = 0; i < 200; ++i) channels.values[0].push_back(3 - 0.1 * i);
  std::vector<std::size_t> lost;
  for (std::size_t i = 10; i < 14; ++i) lost.push_back(i);
  for (std::size_t i = 30; i < 50; ++i) lost.push_back(i);
  for (std::size_t i = 100; i < 121; ++i) lost.push_back(i);
  const WithoutSamples given(channels, lost);
  const BridgedRecord bridged(given.record());
  EXPECT_THAT(bridged.record().starts, testing::ElementsAre(0, 100));
  ASSERT_EQ(bridged.record().samples(), 179u);
  for (std::size_t i = 0; i < 100; ++i)
    EXPECT_NEAR(bridged.record().channels[0][i], 3 - 0.1 * static_cast<double>(i), 1e-12) << i;
}

// So few are left together that some lags would have none.
TEST(Modal, bursts_are_not_joined) {
  MadeChannels channels{{std::vector<double>(500, 1.0)}, 0.5};
  std::vector<std::size_t> lost;
  for (std::size_t i = 0; i < 500; ++i)
    if (i % 25 >= 10) lost.push_back(i);
  const WithoutSamples given(channels, lost);
  const ModalRecord record = given.record();
  EXPECT_EQ(places_with_short_gaps(record).back() + 1, record.samples());
}

TEST(Modal, short_gaps_are_filled_in_by_cubics_and_longer_ones_stay) {
  MadeChannels channels{{{}, {}}, 0.5};
  const auto cubic = [](double x) { return 1 + x * (2 - x * (0.3 - 0.01 * x)); };
  for (int i = 0; i < 60; ++i) {
    channels.values[0].push_back(cubic(i));
    channels.values[1].push_back(-2 * cubic(i));
  }
  std::vector<std::size_t> lost{5, 7, 8, 12, 13, 14};
  for (std::size_t i = 20; i < 44; ++i) lost.push_back(i);
  const WithoutSamples given(channels, lost);
  const ModalRecord record = given.record();
  EXPECT_THAT(record.starts, testing::ElementsAre(0, 5, 6, 9, 14));
  EXPECT_EQ(places_with_short_gaps(record).back(), 35u);
  const BridgedRecord bridged(record);
  EXPECT_THAT(bridged.record().starts, testing::ElementsAre(0, 20));
  ASSERT_EQ(bridged.record().samples(), 36u);
  EXPECT_EQ(std::accumulate(bridged.record().measured.begin(), bridged.record().measured.end(), 0.0), 30);
  for (std::size_t i = 0; i < 36; ++i) {
    const double place = static_cast<double>(i < 20 ? i : i + 24);
    EXPECT_NEAR(bridged.record().time(i), 0.5 * place, 1e-12);
    EXPECT_NEAR(bridged.record().channels[0][i], cubic(place), 1e-9) << i;
    EXPECT_NEAR(bridged.record().channels[1][i], -2 * cubic(place), 1e-9) << i;
  }
}

TEST(Modal, samples_that_are_missing_here_and_there_cost_no_mode) {
  std::mt19937 random(5);
  int held = 0, all = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const bool is_free = seed % 2 == 0;
    const std::size_t samples = is_free ? 3000 : 12000;
    // Single ones, few and many, and up to five together.
    const std::size_t most = seed % 3 == 2 ? 5 : 1, all_lost = samples / (seed % 3 == 0 ? 200 : 8);
    std::set<std::size_t> lost;
    while (lost.size() < all_lost)
      for (std::size_t first = random() % samples, end = first + 1 + random() % most; first < end; ++first)
        lost.insert(std::min(first, samples - 1));
    const WithoutSamples given(is_free ? let_go(two_masses(), {1, 0.5}, samples, 0.02, 0.02, seed)
                                       : under_white_forces(two_masses(), samples, 0.0625, seed),
                               {lost.begin(), lost.end()});
    const ModalAnalysis found = find_modes(given.record());
    EXPECT_EQ(found.motion, is_free ? ModalMotion::free_decay : ModalMotion::ambient);
    ASSERT_EQ(found.modes.size(), 2u) << seed;
    for (std::size_t j = 0; j < 2; ++j) {
      all += 2;
      held += holds(found.modes[j].frequency, two_masses()[j].frequency) +
              holds(found.modes[j].damping_ratio, two_masses()[j].damping_ratio);
    }
  }
  EXPECT_GE(held, 71) << "of " << all;  // 95 % of 80, to two and a half standard deviations
}

TEST(Modal, one_channel_gives_frequencies_and_dampings) {
  const MadeChannels channels = under_white_forces(two_masses(), 12000, 0.0625, 13);
  ModalRecord record = channels.record();
  record.channels.resize(1);
  const auto modes = find_modes(record).modes;
  ASSERT_EQ(modes.size(), 2u);
  EXPECT_TRUE(holds(modes[0].frequency, 1.6));
  EXPECT_TRUE(holds(modes[1].frequency, 4.5));
}

TEST(Modal, a_record_too_short_says_so) {
  const MadeChannels channels = under_white_forces(two_masses(), 30, 0.0625, 14);
  EXPECT_EQ(find_modes(channels.record()).highest_order, 0);
}

TEST(Modal, only_modes_between_the_frequencies_are_given_and_no_more_than_asked) {
  const MadeChannels channels = under_white_forces(two_masses(), 12000, 0.0625, 15);
  const auto above = find_modes(channels.record(), {.from = 3}).modes;
  ASSERT_EQ(above.size(), 1u);
  EXPECT_NEAR(above[0].frequency.value, 4.5, 0.05);
  const auto below = find_modes(channels.record(), {.to = 3}).modes;
  ASSERT_EQ(below.size(), 1u);
  EXPECT_NEAR(below[0].frequency.value, 1.6, 0.02);
  EXPECT_EQ(find_modes(channels.record(), {.modes = 1}).modes.size(), 1u);
}

TEST(Modal, a_free_decay_is_known_as_one_and_its_modes_are_in_the_intervals) {
  const std::vector<TrueMode> truth{{0.70677, 0.0015, {1.0, {0.84, -0.012}}},
                                    {0.72899, 0.0016, {{-0.84, 0.012}, 1.0}}};
  int frequencies = 0, dampings = 0, found = 0;
  const int records = 12;
  for (int seed = 0; seed < records; ++seed) {
    const MadeChannels channels = let_go(truth, {0.07, 0.06}, 2400, 0.05, 0.05, static_cast<unsigned>(seed));
    const ModalAnalysis analysis = find_modes(channels.record());
    EXPECT_EQ(analysis.motion, ModalMotion::free_decay);
    if (analysis.modes.size() != 2) continue;
    ++found;
    for (std::size_t j = 0; j < 2; ++j) {
      frequencies += holds(analysis.modes[j].frequency, truth[j].frequency);
      dampings += holds(analysis.modes[j].damping_ratio, truth[j].damping_ratio);
      EXPECT_GT(modal_assurance(analysis.modes[j].shape, truth[j].shape), 0.999);
    }
  }
  EXPECT_GE(found, records - 1);
  EXPECT_GE(frequencies, 20);
  EXPECT_GE(dampings, 20);
}

// Quadratic drag: the decay rate follows the amplitude, as of two swings of one frequency.
TEST(Modal, one_swing_with_drag_is_one_mode) {
  std::vector<double> y;
  double size = 1;
  for (int i = 0; i < 4000; ++i) {
    y.push_back(size * std::cos(2 * std::numbers::pi * 1.4 * 0.02 * i));
    size -= 0.02 * (0.005 * size + 0.05 * size * size);
  }
  ModalRecord record;
  record.channels.emplace_back(y);
  record.step = 0.02;
  const auto modes = find_modes(record).modes;
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_NEAR(modes[0].frequency.value, 1.4, 0.001);
}

TEST(Modal, an_exact_decay_is_found_to_rounding) {
  const std::vector<TrueMode> truth{{1.0, 0.01, {1.0, {0.5, 0.1}}}, {2.7, 0.02, {-0.6, 1.0}}};
  const MadeChannels channels = let_go(truth, {1, 0.4}, 1000, 0.04, 0, 1);
  const auto modes = find_modes(channels.record()).modes;
  ASSERT_EQ(modes.size(), 2u);
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_NEAR(modes[j].frequency.value, truth[j].frequency, 1e-10);
    EXPECT_NEAR(modes[j].damping_ratio.value, truth[j].damping_ratio, 1e-10);
    EXPECT_LT(std::abs(modes[j].shape[0] - truth[j].shape[0]), 1e-9);
    EXPECT_LT(std::abs(modes[j].shape[1] - truth[j].shape[1]), 1e-9);
  }
}

// truth.json beside the recordings.
TEST(Modal, shear_frame) {
  const MadeChannels channels = shared_recording("shear_frame.csv");
  if (channels.values.empty()) GTEST_SKIP() << "no ../shared/data";
  const std::vector<TrueMode> truth{{1.7475031075332073,
                                     0.006485584416009495,
                                     {{0.2741202367274376, 0.0016648834676163573},
                                      {0.565085117196243, 0.0044504565163196496},
                                      {0.8071072447478315, -0.001231305313546437},
                                      1.0}},
                                    {4.363993868035125,
                                     0.015519538804298287,
                                     {{-0.6237710683459061, 0.02239023609475227},
                                      {-0.7607233672302209, 0.03128747391702877},
                                      {-0.2029674894254713, -0.017549797017540534},
                                      1.0}},
                                    {6.445929067262335,
                                     0.025025465605732038,
                                     {{-0.8924199555270598, -0.09979099231575535},
                                      {-0.036813805530735315, 0.042518024418853544},
                                      1.0,
                                      {-0.6145187511251959, 0.025573577856829986}}},
                                    {8.383104743220116,
                                     0.04117620437350554,
                                     {{-0.6670696995870187, 0.08786159503629987},
                                      1.0,
                                      {-0.6029652144206038, -0.06653461814321233},
                                      {0.1759522480656764, 0.00781717400722312}}}};
  const double within[] = {0.003, 0.003, 0.006, 0.006};
  const ModalAnalysis analysis = find_modes(channels.record());
  EXPECT_EQ(analysis.motion, ModalMotion::ambient);
  ASSERT_EQ(analysis.modes.size(), truth.size());
  for (std::size_t j = 0; j < truth.size(); ++j) {
    const MeasuredMode& mode = analysis.modes[j];
    EXPECT_NEAR(mode.frequency.value, truth[j].frequency, within[j] * truth[j].frequency);
    EXPECT_TRUE(holds(mode.frequency, truth[j].frequency)) << j;
    EXPECT_TRUE(holds(mode.damping_ratio, truth[j].damping_ratio)) << j;
    EXPECT_GT(modal_assurance(mode.shape, truth[j].shape), 0.99);
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_LE(std::abs(mode.shape[c].real() - truth[j].shape[c].real()), 4 * mode.shape_error[c].real());
      EXPECT_LE(std::abs(mode.shape[c].imag() - truth[j].shape[c].imag()), 4 * mode.shape_error[c].imag());
    }
  }
}

TEST(Modal, coupled_pendulums) {
  const MadeChannels channels = shared_recording("coupled_pendulums.csv");
  if (channels.values.empty()) GTEST_SKIP() << "no ../shared/data";
  const ModalAnalysis analysis = find_modes(channels.record());
  EXPECT_EQ(analysis.motion, ModalMotion::free_decay);
  ASSERT_EQ(analysis.modes.size(), 2u);
  EXPECT_TRUE(holds(analysis.modes[0].frequency, 0.7067694227916127));
  EXPECT_TRUE(holds(analysis.modes[1].frequency, 0.7289855474138609));
  EXPECT_TRUE(holds(analysis.modes[0].damping_ratio, 0.0015369684346440654));
  EXPECT_TRUE(holds(analysis.modes[1].damping_ratio, 0.0015664054163147798));
  EXPECT_LT(analysis.modes[1].frequency.standard_error, 1e-5);
}

// Within ten to twenty of its periods a motion under random forces is nearly a free one.
TEST(Modal, a_short_record_of_random_forces_is_no_free_decay) {
  int free = 0;
  for (const std::size_t samples : {200, 300, 400, 800})
    for (unsigned seed = 0; seed < 15; ++seed) {
      const MadeChannels channels = under_white_forces(two_masses(), samples, 0.05, seed);
      free += find_modes(channels.record()).motion == ModalMotion::free_decay;
    }
  EXPECT_LE(free, 4);
  for (const double noise : {0.01, 0.2, 0.5})
    for (unsigned seed = 0; seed < 5; ++seed) {
      const MadeChannels channels = let_go(two_masses(), {0.3, 0.1}, 300, 0.05, noise, seed);
      EXPECT_EQ(find_modes(channels.record()).motion, ModalMotion::free_decay) << noise << ' ' << seed;
    }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
