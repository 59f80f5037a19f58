// The file of a network: what is read, and what is refused, with its place and its cure.
#include "cromer/tasks/network/network_file.h"

#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr std::string_view pendulums = R"([[mass]]
name = "left"
inertia = "0.05 kg m²"
position = "5 deg"

[[mass]]
name = "right"
inertia = 0.05
velocity = "0.1 rad/s"
drive_amplitude = "2 N m"
drive_frequency = "0.5 Hz"
drive_phase = 0.3

[[link]]
to = "left"
stiffness = "0.981 N m"
damping = "0.0006 N m s"

[[link]]
to = "right"
pendulum = "0.992 N m"
damping = "0.0008 N m s/rad"
cubic = 0.2

[[link]]
from = "left"
to = "right"
stiffness = "0.031 N m/rad"
)";

TEST(NetworkFile, IsRead) {
  const auto network = read_network(pendulums, "p.toml");
  ASSERT_TRUE(network) << in_words(network.error().notice);
  EXPECT_TRUE(network->angles);
  ASSERT_EQ(network->masses.size(), 2u);
  EXPECT_EQ(network->masses[0].name, "left");
  EXPECT_EQ(network->masses[0].mass, 0.05);
  EXPECT_NEAR(network->masses[0].start.x, 5 * 3.14159265358979 / 180, 1e-12);
  EXPECT_EQ(network->masses[1].start.v, 0.1);
  EXPECT_EQ(network->masses[1].drive.amplitude, 2);
  EXPECT_NEAR(network->masses[1].drive.frequency, 3.14159265358979, 1e-12);
  EXPECT_EQ(network->masses[1].drive.phase, 0.3);
  ASSERT_EQ(network->links.size(), 3u);
  EXPECT_EQ(network->links[0].from, ground);
  EXPECT_EQ(network->links[0].to, 0u);
  EXPECT_EQ(network->links[0].law.stiffness, 0.981);
  EXPECT_EQ(network->links[0].law.damping, 0.0006);
  EXPECT_EQ(network->links[1].law.stiffness, 0);
  EXPECT_EQ(network->links[1].law.pendulum, 0.992);
  EXPECT_EQ(network->links[1].law.damping, 0.0008);
  EXPECT_EQ(network->links[1].law.cubic, 0.2);
  EXPECT_EQ(network->links[2].from, 0u);
  EXPECT_EQ(network->links[2].law.stiffness, 0.031);
}

std::string refusal(const std::string& file) {
  const auto network = read_network(file, "n.toml");
  return network ? "" : in_words(network.error().notice);
}

/// A mass and a link, and more tables.
std::string with(const std::string& more, const std::string& mass = "mass = 1",
                 const std::string& link = "") {
  return "[[mass]]\nname = \"cart\"\n" + mass + "\n\n[[link]]\nto = \"cart\"\nstiffness = 9\n" + link + more;
}

TEST(NetworkFile, IsNoRecording) {
  const auto recording = read_network_file("t (s),x (m)\n0,1\n0.1,0.9\n", "carts.csv");
  ASSERT_FALSE(recording);
  EXPECT_EQ(in_words(recording.error()),
            "carts.csv is no network: --network takes a file that ends in .toml, with [[mass]] and [[link]]");
}

TEST(NetworkFile, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(refusal(with("")), "");
  EXPECT_EQ(refusal(""), "n.toml: a network has at least one [[mass]]");
  EXPECT_EQ(refusal("[[mass]]\nname = \"a\"\nmass = 1\n"),
            "n.toml:1:1: nothing holds \"a\": give it a [[link]] to another mass or to \"ground\"");
  EXPECT_EQ(refusal(with("", "mass = \"-2 kg\"")), "n.toml:3:8: mass: it must be positive, not -2 kg");
  EXPECT_EQ(refusal(with("", "mass = \"2 N\"")).substr(0, 44),
            "n.toml:3:8: mass: \"2 N\" is a force; expected");
  EXPECT_EQ(
      refusal(with("", "")),
      "n.toml:1:1: \"cart\" has no mass: give mass = \"1200 kg\", or of an angle inertia = \"0.05 kg m^2\"");
  EXPECT_EQ(refusal(with("", "mas = 1")), "n.toml:3:7: \"mas\" is not known here; did you mean \"mass\"?");
  EXPECT_EQ(refusal(with("[[link]]\nto = \"cart\"\nstifness = 1\n")),
            "n.toml:10:12: \"stifness\" is not known here; did you mean \"stiffness\"?");
  EXPECT_EQ(refusal(with("", "mass = 1\ninertia = 2")),
            "n.toml:1:1: \"cart\" has a mass and an inertia: give one of them");
  EXPECT_EQ(refusal(with("", "mass = 1\npositon = 2")),
            "n.toml:4:11: \"positon\" is not known here; did you mean \"position\"?");
  EXPECT_EQ(refusal(with("", "mass = [1, 2]")), "n.toml:3:8: \"mass\" takes one value, not a list");
  EXPECT_EQ(refusal(with("", "mass = 1", "stifness = 3\n")),
            "n.toml:8:12: \"stifness\" is not known here; did you mean \"stiffness\"?");
  EXPECT_EQ(refusal(with("", "mass = 1", "damping = -0.1\n")),
            "n.toml:8:11: damping: it must not be negative, not -0.1 kg/s");
  EXPECT_EQ(refusal(with("", "mass = 1", "damping = -0.1\nvan_der_pol = 2\n")), "");
  EXPECT_EQ(refusal(with("", "mass = 1", "friction = 0.3\nstatic_friction = 0.2\n")),
            "n.toml:9:19: static_friction: it must be at least friction (0.3 N), not 0.2 N");
  EXPECT_EQ(refusal(with("", "mass = 1", "friction = 0.3\nstatic_friction = 0.3\n")), "");
  EXPECT_EQ(refusal(with("", "mass = 1\ndrive_amplitude = 2")),
            "n.toml:4:19: drive_amplitude needs a drive_frequency; of a constant force it is 0");
  EXPECT_EQ(refusal(with("", "mass = 1\ndrive_amplitude = 2\ndrive_frequency = 0")), "");
  EXPECT_EQ(refusal(with("", "mass = 1\ndrive_amplitude = 2\ndrive_frequncy = 3")),
            "n.toml:5:18: \"drive_frequncy\" is not known here; did you mean \"drive_frequency\"?");
  EXPECT_EQ(refusal(with("[[link]]\nto = \"card\"\nstiffness = 1\n")),
            "n.toml:8:1: there is no mass \"card\"; did you mean \"cart\"?");
  EXPECT_EQ(refusal(with("[[link]]\nto = \"house\"\nstiffness = 1\n")),
            "n.toml:8:1: there is no mass \"house\"; the network has cart");
  EXPECT_EQ(refusal(with("", "mass = \"?\"")),
            "n.toml:3:8: mass: it must be given, \"?\" is for values of a link");
  const auto cannot_be_open = [](const std::string& key) {
    return key +
           ": \"?\" is only for stiffness, damping, drag, cubic, quadratic, odd_quadratic, quintic, "
           "van_der_pol "
           "or pendulum of a link; give a value, or leave " +
           key + " out";
  };
  EXPECT_EQ(refusal(with("", "mass = 1\nposition = \"?\"")), "n.toml:4:12: " + cannot_be_open("position"));
  EXPECT_EQ(refusal(with("", "mass = 1\ndrive_phase = \"?\"")),
            "n.toml:4:15: " + cannot_be_open("drive_phase"));
  for (const std::string key : {"friction", "static_friction", "hysteresis_stiffness", "hysteresis_exponent"})
    EXPECT_EQ(refusal(with("", "mass = 1", key + " = \"?\"\n")),
              "n.toml:8:" + std::to_string(key.size() + 4) + ": " + cannot_be_open(key));
  EXPECT_EQ(refusal(with("[[link]]\nfrom = \"cart\"\nto = \"cart\"\nstiffness = 1\n")),
            "n.toml:8:1: the link joins \"cart\" to itself: give it two ends");
  EXPECT_EQ(refusal(with("[[link]]\nto = \"cart\"\n")),
            "n.toml:8:1: the link has no force: give it a term, such as stiffness = \"20 N/m\"");
  EXPECT_EQ(refusal(with("[[mass]]\nname = \"cart\"\nmass = 1\n")),
            "n.toml:8:1: there are two masses \"cart\": each needs a name of its own");
  EXPECT_EQ(refusal(with("[[mass]]\nname = \"wheel\"\ninertia = 1\n")),
            "n.toml:8:1: a network has masses or moments of inertia, not both: positions are all lengths or "
            "all angles");
  EXPECT_EQ(refusal(with("[[mass]]\nmass = 1\n")), "n.toml:8:1: a [[mass]] needs a name: name = \"floor 1\"");
  EXPECT_EQ(
      refusal(with("[[mass]]\nname = \"ground\"\nmass = 1\n")),
      "n.toml:9:8: \"ground\" is no name for a mass: it must not be empty, and \"ground\" is the ground");
  EXPECT_EQ(refusal(with("[[spring]]\n")), "n.toml:8:1: \"spring\" is not known here");
  EXPECT_EQ(refusal("[[mass]\n").substr(0, 9), "n.toml:1:");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
