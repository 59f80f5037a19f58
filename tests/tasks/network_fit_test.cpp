// Fits of networks: which columns, which values, and what is refused. The estimator's own tests are in
// tests/identify.
#include "cromer/tasks/network_fit/network_fit.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <random>
#include <string>
#include <tuple>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/open_recording.h"
#include "tests/identify/network_truth.h"
#include "tests/support/shared_data.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::HasSubstr;

/// Two pendulums without a value between them.
std::string pendulums(const std::string& coupling = "\"?\"") {
  return R"(
[[mass]]
name = "left"
inertia = "0.05 kg m²"
[[mass]]
name = "right"
inertia = "0.05 kg m²"
[[link]]
to = "left"
stiffness = "?"
damping = "?"
[[link]]
to = "right"
stiffness = "?"
damping = "?"
[[link]]
from = "left"
to = "right"
stiffness = )" +
         coupling + "\n";
}

NetworkFile file_of(const std::string& text) {
  auto file = read_network_file(text, "n.toml");
  EXPECT_TRUE(file.ok()) << in_words(file.error());
  return file ? *file : NetworkFile{};
}

/// A recording of two columns that beat.
std::string beats(const std::string& first = "Angle 1 (rad)", const std::string& second = "Angle 2 (rad)",
                  double drift = 0) {
  std::string text = "Time (s)," + first + "," + second + "\n";
  for (int n = 0; n < 1500; ++n) {
    const double t = 0.02 * n, one = std::cos(4.43 * t), other = std::cos(4.6 * t);
    text += std::to_string(t * (1 + drift * t)) + "," + std::to_string(0.1 * (one + other)) + "," +
            std::to_string(0.1 * (one - other)) + "\n";
  }
  return text;
}

Result<FittedNetwork> fitted(const std::string& recording, const NetworkFile& file,
                             const FitOptions& options = {}) {
  const auto read = read_recording(recording, "swing.csv", options.read);
  if (!read) return read.error();
  return fit_network(*read, file, "n.toml", options);
}

/// A column of positions for each mass.
std::string positions_csv(const NetworkSwings& swings) {
  std::string text = "Time (s)";
  for (std::size_t i = 1; i <= swings.y.size(); ++i) text += fmt::format(",Position {} (m)", i);
  for (std::size_t n = 0; n < swings.t.size(); ++n) {
    text += fmt::format("\n{:.2f}", swings.t[n]);
    for (const std::vector<double>& column : swings.y) text += fmt::format(",{}", column[n]);
  }
  return text + "\n";
}

std::string refusal(const std::string& recording, const NetworkFile& file, const FitOptions& options = {}) {
  const auto result = fitted(recording, file, options);
  return result ? in_words(result->message) : in_words(result.error());
}

// Two equal pendulums: their sum swings with k/I, their difference with (k + 2 kappa)/I.
TEST(NetworkFit, FindsTheValuesThatAreOpen) {
  const auto result = fitted(beats(), file_of(pendulums()));
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  EXPECT_TRUE(result->succeeded()) << in_words(result->message);
  const double k = 0.05 * 4.43 * 4.43, kappa = 0.05 * (4.6 * 4.6 - 4.43 * 4.43) / 2;
  const std::vector<Parameter> left = result->found_of(0), between = result->found_of(2);
  ASSERT_EQ(left.size(), 2u);
  ASSERT_EQ(between.size(), 1u);
  EXPECT_EQ(left[0].name, "stiffness");
  EXPECT_EQ(left[0].unit, "N m");
  EXPECT_EQ(left[1].unit, "N m s");
  EXPECT_NEAR(left[0].estimate.value, k, 1e-5 * k);
  EXPECT_NEAR(between[0].estimate.value, kappa, 1e-3 * kappa);
}

TEST(NetworkFit, ABeginningWithoutMotionIsLeftOut) {
  std::string late = "Time (s),Angle 1 (rad),Angle 2 (rad)\n";
  for (int n = 0; n < 1500; ++n) {
    const double t = 0.02 * (n < 100 ? 0 : n - 100), one = std::cos(4.43 * t), other = std::cos(4.6 * t);
    late += fmt::format("{},{},{}\n", 0.02 * n, 0.1 * (one + other), 0.1 * (one - other));
  }
  const auto result = fitted(late, file_of(pendulums()));
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->succeeded()) << in_words(result->message);
  EXPECT_GE(result->channels.t.front(), 2);
  EXPECT_LE(result->channels.t.front(), 2.2);
  EXPECT_NEAR(result->found_of(0)[0].estimate.value, 0.05 * 4.43 * 4.43, 1e-6);
  EXPECT_THAT(in_words(result->notices),
              testing::Contains(HasSubstr("held: the result is for the motion from 2")));
  const auto chosen = fitted(late, file_of(pendulums()), {.from = 5});
  EXPECT_EQ(chosen->channels.t.front(), 5);
  EXPECT_THAT(in_words(chosen->notices), testing::Not(testing::Contains(HasSubstr("nothing moves"))));
}

TEST(NetworkFit, SaysOfASlowReleaseThatItIsHeldAndNotThatNothingMoves) {
  std::string slow = "Time (s),Angle 1 (rad),Angle 2 (rad)\n";
  State<double> sum{0.2, 0}, difference{0.1, 0};  // held there for 2 s, and let go within 0.5 s
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 3e-4);
  for (int n = 0; n < 1500; ++n) {
    slow += fmt::format("{},{},{}\n", 0.02 * n, (sum.x + difference.x) / 2 + noise(random),
                        (sum.x - difference.x) / 2 + noise(random));
    for (int part = 0; part < 100; ++part) {
      constexpr double h = 0.0002;
      const double held = std::clamp(1 - (0.02 * n + h * part - 2) / 0.5, 0.0, 1.0);
      for (auto& [mode, w, place] : {std::tuple{&sum, 4.43, 0.2}, std::tuple{&difference, 4.6, 0.1}}) {
        mode->v -= h * w * w * (mode->x - held * place);
        mode->x += h * mode->v;
      }
    }
  }
  const auto result = fitted(slow, file_of(pendulums()));
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->succeeded()) << in_words(result->message);
  EXPECT_GE(result->channels.t.front(), 2.1);
  EXPECT_THAT(
      in_words(result->notices),
      testing::Contains(HasSubstr("s are no part of the free motion after them (held, let go slowly")));
  EXPECT_THAT(in_words(result->notices), testing::Not(testing::Contains(HasSubstr("nothing moves"))));
}

// Its beginning is quieter than what follows, as that of one at rest.
TEST(NetworkFit, AMotionThatGrowsUnderItsDriveIsTakenFromItsFirstSample) {
  const std::string network = R"([[mass]]
name = "a"
mass = "1 kg"
velocity = "0.4 m/s"
drive_amplitude = "0.5 N"
drive_frequency = "1.1 rad/s"
drive_phase = "0.4 rad"
[[mass]]
name = "b"
mass = "2 kg"
position = "-0.1 m"
[[mass]]
name = "c"
mass = "1.5 kg"
velocity = "-0.2 m/s"
[[link]]
to = "a"
stiffness = "9 N/m"
damping = "0.05 kg/s"
[[link]]
from = "a"
to = "b"
stiffness = "5 N/m"
drag = "0.3 kg/m"
[[link]]
from = "b"
to = "c"
stiffness = "7 N/m"
cubic = "20 N/m³"
)";
  std::string open = network;
  open.replace(open.find("9 N/m"), 5, "?");
  const NetworkSwings swings = swings_of(file_of(network).network, 500, 0.06, 2e-4, 4);
  std::string bytes = "Time (s),Position 1 (m),Position 2 (m),Position 3 (m)\n";
  for (std::size_t n = 0; n < swings.t.size(); ++n)
    bytes += fmt::format("{:.2f},{:.5f},{:.5f},{:.5f}\n", swings.t[n], swings.y[0][n], swings.y[1][n],
                         swings.y[2][n]);
  const auto recording = read_recording(bytes, "swing.csv", {});
  ASSERT_TRUE(recording.ok());
  const std::atomic<bool> stop{true};  // before the fit itself
  const auto result = fit_network(*recording, file_of(open), "n.toml", {}, {&stop});
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  EXPECT_EQ(result->channels.t.front(), 0);
  EXPECT_TRUE(result->notices.empty());
}

TEST(NetworkFit, OfTheSharedPendulumsIsWithinItsIntervals) {
  const std::string path = data("networks/coupled_pendulums.csv");
  SKIP_WITHOUT(path);
  const auto recording = open_recording(path, {});
  ASSERT_TRUE(recording.ok());
  const auto result = fit_network(*recording, file_of(pendulums()), "n.toml", {});
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  const double truth[] = {0.981, 0.992, 0.031};
  for (std::size_t l = 0; l < 3; ++l) {
    const Estimate k = result->found_of(l)[0].estimate;
    EXPECT_NEAR(k.value, truth[l], 3 * k.standard_error) << l;
    EXPECT_LT(k.standard_error, 1e-4 * truth[l]) << l;
  }
}

/// How often the noise what is left of the worst column is, by the notice; 0 without one.
std::vector<Notice> said_of(const NetworkSwings& swings) {
  std::string bytes = "Time (s),Angle 1 (rad),Angle 2 (rad)\n";
  for (std::size_t n = 0; n < swings.t.size(); ++n)
    bytes += fmt::format("{:.2f},{},{}\n", swings.t[n], swings.y[0][n], swings.y[1][n]);
  const auto result = fitted(bytes, file_of(pendulums()));
  EXPECT_TRUE(result && result->succeeded());
  return result ? result->notices : std::vector<Notice>{};
}

double times_left(const NetworkSwings& swings) {
  for (const Notice& notice : said_of(swings))
    if (notice.code == "network_leaves_a_motion") return std::get<double>(notice.values[1].value);
  return 0;
}

bool leaves_a_line(const NetworkSwings& swings) {
  const std::vector<Notice> said = said_of(swings);
  return std::any_of(said.begin(), said.end(),
                     [](const Notice& notice) { return notice.code == "network_leaves_a_line"; });
}

TEST(NetworkFit, NamesAMotionThatALawLeaves) {
  const auto truth = [](double cubic, double drag) {
    Network network{.angles = true};
    network.masses = {{.name = "left", .mass = 0.05, .start = {0.12, 0}}, {.name = "right", .mass = 0.05}};
    network.links = {{ground, 0, {.stiffness = 0.981, .damping = 6e-4, .drag = drag, .cubic = cubic}},
                     {ground, 1, {.stiffness = 0.992, .damping = 8e-4}},
                     {0, 1, {.stiffness = 0.031}}};
    return network;
  };
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_GT(times_left(swings_of(truth(-9, 0), 2000, 0.02, 5e-4, seed)), 4) << seed;
    EXPECT_GT(times_left(swings_of(truth(0, 5e-3), 2000, 0.02, 1e-4, seed)), 2) << seed;
    EXPECT_EQ(times_left(swings_of(truth(0, 0), 2000, 0.02, 5e-4, seed)), 0) << seed;
    // Below the noise it is a line.
    EXPECT_TRUE(leaves_a_line(swings_of(truth(-2, 0), 2000, 0.02, 2e-3, seed))) << seed;
    EXPECT_FALSE(leaves_a_line(swings_of(truth(0, 0), 2000, 0.02, 2e-3, seed))) << seed;
  }
  // Noise that hangs together is no motion; nor is rounding.
  const NetworkSwings noiseless = swings_of(truth(0, 0), 2000, 0.02, 0, 1);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    NetworkSwings swings = noiseless;
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, 3e-4);
    for (auto& column : swings.y) {
      double noise = 0;
      for (double& each : column) each += noise = 0.95 * noise + normal(random);
    }
    EXPECT_EQ(times_left(swings), 0) << seed;
    EXPECT_FALSE(leaves_a_line(swings)) << seed;
  }
  NetworkSwings coarse = noiseless;
  EXPECT_EQ(times_left(coarse), 0);
  for (auto& column : coarse.y)
    for (double& each : column) each = std::round(each * 100) / 100;
  EXPECT_EQ(times_left(coarse), 0);
  EXPECT_FALSE(leaves_a_line(coarse));
}

TEST(NetworkFit, ColumnsThatAreNamedAsOtherMassesAreRefused) {
  EXPECT_THAT(
      refusal(beats("right (rad)", "left (rad)"), file_of(pendulums())),
      HasSubstr("the column \"right (rad)\" has the name of the mass \"right\" and the place of \"left\""));
  EXPECT_THAT(refusal(beats("right x (rad)", "left x (rad)"), file_of(pendulums())),
              HasSubstr("put the [[mass]] tables in the order of the columns"));
  EXPECT_EQ(refusal(beats("left (rad)", "right (rad)"), file_of(pendulums())), "");
}

TEST(NetworkFit, OfAReversedColumnTheLinkPushesApart) {
  std::string reversed = "Time (s),Angle 1 (rad),Angle 2 (rad)\n";
  for (int n = 0; n < 1500; ++n) {
    const double t = 0.02 * n, one = std::cos(4.43 * t), other = std::cos(4.6 * t);
    reversed += fmt::format("{},{},{}\n", t, 0.1 * (one + other), -0.1 * (one - other));
  }
  const auto result = fitted(reversed, file_of(pendulums()));
  ASSERT_TRUE(result && result->succeeded());
  EXPECT_THAT(in_words(result->notices),
              testing::Contains(
                  "stiffness of left–right is negative: the link pushes its masses apart, or one of the "
                  "columns is reversed"));
}

TEST(NetworkFit, NamesAModeThatTheNetworkLacks) {
  Network network;
  network.masses = {{.name = "a", .mass = 1, .start = {0.1, 0}},
                    {.name = "b", .mass = 1, .start = {-0.05, 0}}};
  network.links = {{ground, 0, {.stiffness = 50, .damping = 0.06}},
                   {0, 1, {.stiffness = 20, .damping = 0.05}}};
  const auto lacks = [&](double given, std::uint64_t seed) {
    const NetworkSwings swings = swings_of(network, 500, 0.02, 0.01, seed);
    const auto result =
        fitted(positions_csv(swings),
               file_of(fmt::format("[[mass]]\nname = \"a\"\nmass = 1\n[[mass]]\nname = \"b\"\nmass = 1\n"
                                   "[[link]]\nto = \"a\"\nstiffness = {}\ndamping = \"?\"\n"
                                   "[[link]]\nfrom = \"a\"\nto = \"b\"\nstiffness = \"?\"\n",
                                   given)));
    EXPECT_TRUE(result && result->succeeded()) << given;
    return result && std::any_of(result->notices.begin(), result->notices.end(), [](const Notice& each) {
             return each.code == "network_lacks_a_mode" || each.code == "network_leaves_a_line";
           });
  };
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_TRUE(lacks(58, seed)) << seed;
    EXPECT_FALSE(lacks(50, seed)) << seed;
  }
}

// From sample to sample a fast mode varies as noise does.
TEST(NetworkFit, AFastModeThatDiesDownIsNoStillness) {
  Network network;
  network.masses = {
      {.name = "a", .mass = 1}, {.name = "b", .mass = 1}, {.name = "c", .mass = 1, .start = {0.01, 0}}};
  network.links = {{ground, 0, {.stiffness = 50, .damping = 0.2}},
                   {0, 1, {.stiffness = 40, .damping = 0.2}},
                   {1, 2, {.stiffness = 4000, .damping = 8}}};
  const NetworkFile open = file_of(R"(
[[mass]]
name = "a"
mass = 1
[[mass]]
name = "b"
mass = 1
[[mass]]
name = "c"
mass = 1
[[link]]
to = "a"
stiffness = "?"
[[link]]
from = "a"
to = "b"
stiffness = "?"
[[link]]
from = "b"
to = "c"
stiffness = "?"
damping = "?"
)");
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const NetworkSwings swings = swings_of(network, 1200, 0.01, 0.0005, seed);
    const auto result = fitted(positions_csv(swings), open);
    ASSERT_TRUE(result.ok()) << seed;
    EXPECT_EQ(result->channels.t.front(), 0) << seed;
  }
}

// 2.5 samples in a period of the fast mode: a fit may end at its mirror image at half the rate.
TEST(NetworkFit, AModeAboveHalfTheRateIsSaid) {
  Network network;
  network.masses = {{.name = "a", .mass = 0.25, .start = {0.1, 0}},
                    {.name = "b", .mass = 0.4, .start = {-0.04, 0}}};
  network.links = {{ground, 0, {.stiffness = 5, .damping = 0.02}},
                   {ground, 1, {.stiffness = 9, .damping = 0.03}},
                   {0, 1, {.stiffness = 150, .damping = 0.2}}};
  const NetworkFile open = file_of(R"(
[[mass]]
name = "a"
mass = 0.25
[[mass]]
name = "b"
mass = 0.4
[[link]]
to = "a"
stiffness = "?"
damping = "?"
[[link]]
to = "b"
stiffness = "?"
damping = "?"
[[link]]
from = "a"
to = "b"
stiffness = "?"
damping = "?"
)");
  int mirrored = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const NetworkSwings swings = swings_of(network, 312, 0.08, 0.001, seed);
    const auto result = fitted(positions_csv(swings), open);
    ASSERT_TRUE(result && result->succeeded()) << seed;
    const double found = result->found_of(2)[0].estimate.value;
    const bool is_mirrored = std::abs(found - 150) > 15;
    mirrored += is_mirrored;
    EXPECT_EQ(std::any_of(result->notices.begin(), result->notices.end(),
                          [](const Notice& each) { return each.code == "network_above_half_rate"; }),
              is_mirrored)
        << seed << ": " << found;
  }
  EXPECT_LT(mirrored, 20);
}

TEST(NetworkFit, AColumnOfItsOwnMassIsNotThatOfAShorterName) {
  Network network;
  network.masses = {{.name = "a"}, {.name = "a x"}};
  EXPECT_TRUE(check_a_column_for_each_mass({"a (m)", "a x (m)"}, network, "r.csv").ok());
  EXPECT_FALSE(check_a_column_for_each_mass({"a x (m)", "a (m)"}, network, "r.csv").ok());
}

TEST(NetworkFit, ColumnsInAnotherOrderAreNoQuestionOfValues) {
  Network network;
  network.masses = {{.name = "m1", .mass = 1.2, .start = {0.1, 0}},
                    {.name = "m2", .mass = 0.8, .start = {-0.06, 0}},
                    {.name = "m3", .mass = 1, .start = {0.15, 0}}};
  network.links = {{ground, 0, {.stiffness = 50, .damping = 0.06}},
                   {0, 1, {.stiffness = 40, .damping = 0.05}},
                   {1, 2, {.stiffness = 30, .damping = 0.04}}};
  const std::string link = "stiffness = \"?\"\ndamping = \"?\"\n";
  const NetworkFile file = file_of(
      "[[mass]]\nname = \"m1\"\nmass = 1.2\n[[mass]]\nname = \"m2\"\nmass = 0.8\n[[mass]]\nname = "
      "\"m3\"\nmass = 1\n[[link]]\nto = \"m1\"\n" +
      link + "[[link]]\nfrom = \"m1\"\nto = \"m2\"\n" + link + "[[link]]\nfrom = \"m2\"\nto = \"m3\"\n" +
      link);
  const NetworkSwings swings = swings_of(network, 2000, 0.02, 1e-3, 3);
  const auto said = [&](std::array<std::size_t, 3> order, double sign) {
    std::string bytes = "Time (s),Position 1 (m),Position 2 (m),Position 3 (m)\n";
    for (std::size_t n = 0; n < swings.t.size(); ++n)
      bytes += fmt::format("{:.2f},{},{},{}\n", swings.t[n], swings.y[order[0]][n],
                           sign * swings.y[order[1]][n], swings.y[order[2]][n]);
    const auto result = fitted(bytes, file);
    return result ? in_words(result->message) : in_words(result.error());
  };
  EXPECT_EQ(said({0, 1, 2}, 1), "");
  for (const auto& wrong : {said({1, 0, 2}, 1), said({0, 2, 1}, 1), said({0, 1, 2}, -1)})
    EXPECT_THAT(wrong, HasSubstr("cromer modes --network names columns that look swapped or reversed"));
}

TEST(NetworkFit, SaysThatTheClockDrifts) {
  const auto says_so = [](double drift) {
    const auto result = fitted(beats("Angle 1 (rad)", "Angle 2 (rad)", drift), file_of(pendulums()));
    EXPECT_TRUE(result.ok());
    return result && std::any_of(result->notices.begin(), result->notices.end(),
                                 [](const Notice& each) { return each.code == "clock_drifts"; });
  };
  EXPECT_TRUE(says_so(2e-4));  // 0.8 % from the first third to the last
  EXPECT_FALSE(says_so(0));
}

TEST(NetworkFit, SaysWhatIsWrong) {
  const NetworkFile file = file_of(pendulums());
  EXPECT_THAT(refusal("Time (s),Angle 1 (rad)\n0,1\n1,2\n", file), HasSubstr("1 column of the motion"));
  EXPECT_THAT(refusal(beats("Position 1 (m)", "Position 2 (m)"), file), HasSubstr("of another quantity"));
  NetworkFile nothing_open = file;
  nothing_open.open.clear();
  EXPECT_THAT(refusal(beats(), nothing_open), HasSubstr("no value is open"));
  FitOptions late;
  late.from = 100;
  EXPECT_THAT(refusal(beats(), file, late), HasSubstr("no sample is left"));
  FitOptions shortly;
  shortly.to = 1;
  EXPECT_THAT(refusal(beats(), file, shortly), HasSubstr("one and a half swings of each mass"));
  EXPECT_THAT(refusal(beats(), file_of(pendulums("\"?\"\n[[link]]\nfrom = \"right\"\nto = \"left\"\n"
                                                 "stiffness = \"?\""))),
              HasSubstr("in combination only"));
  // Links between the same two masses are counted.
  const std::string another = "\n[[link]]\nfrom = \"left\"\nto = \"right\"\nstiffness = \"?\"";
  EXPECT_THAT(refusal(beats(), file_of(pendulums("\"?\"" + another))),
              HasSubstr("by itself: stiffness of left–right; stiffness of left–right 2; give"));
}

TEST(NetworkFit, OpenValuesAreNotRunAsTheyStand) {
  const auto network = read_network(pendulums(), "n.toml");
  ASSERT_FALSE(network.ok());
  EXPECT_THAT(in_words(network.error()), HasSubstr("n.toml:10:13: stiffness is \"?\""));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
