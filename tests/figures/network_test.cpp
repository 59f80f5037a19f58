// What a figure of a network holds: its drawing, and its motion beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cromer/figures/figures.h"
#include "cromer/figures/panels.h"
#include "cromer/tasks/network/network_file.h"

namespace cromer::core {
namespace CROMER_FILE {

const char* const two_carts = R"(
[[mass]]
name = "left"
mass = "1.5 kg"
position = "1 cm"
[[mass]]
name = "right"
mass = "2.5 kg"
[[link]]
to = "left"
stiffness = "30 N/m"
[[link]]
from = "left"
to = "right"
stiffness = "7 N/m"
)";

std::vector<std::string> texts_of(const Panel& panel) {
  std::vector<std::string> texts;
  for (const Note& note : panel.notes) texts.push_back(note.text);
  return texts;
}

bool names(const Panel& panel, const std::string& what) {
  const std::vector<std::string> texts = texts_of(panel);
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& text) { return text.find(what) != std::string::npos; });
}

TEST(ShortName, HasNoFoldersAndIsCutInTheMiddle) {
  EXPECT_EQ(short_name("carts.toml"), "carts.toml");
  EXPECT_EQ(short_name("/a/folder/carts.toml"), "carts.toml");
  EXPECT_EQ(short_name("abcdefghijklmnopqrstuvwxyz01234567.csv"), "abcdefghijklmnopqrs…yz01234567.csv");
  EXPECT_EQ(short_name("abcdefghijklmnopqrstuvwxyz0123.csv"), "abcdefghijklmnopqrstuvwxyz0123.csv");
}

TEST(NetworkFigure, DrawsTheNetworkBesideItsMotion) {
  const auto network = read_network(two_carts, "/a/folder/carts.toml");
  ASSERT_TRUE(network.ok());
  SimulateOptions options;
  options.method = {"rk4"};
  options.until = 2;
  const auto run = run_network(*network, "/a/folder/carts.toml", options);
  ASSERT_TRUE(run.ok());
  const Figure figure = network_figure({&*run, 1});
  ASSERT_GE(figure.panels.size(), 2u);
  EXPECT_EQ(figure.panels[0].title, "carts.toml");
  for (const char* what : {"left", "right", "1.5 kg", "2.5 kg", "30 N/m", "7 N/m"})
    EXPECT_TRUE(names(figure.panels[0], what))
        << what << " in " << testing::PrintToString(texts_of(figure.panels[0]));
}

TEST(NetworkFigure, DrawsTheShapesOfTheModes) {
  const auto network = read_network(two_carts, "/a/folder/carts.toml");
  ASSERT_TRUE(network.ok());
  const auto modes = network_modes(*network, "/a/folder/carts.toml", {});
  ASSERT_TRUE(modes.ok());
  const Figure figure = modes_figure(*modes);
  ASSERT_EQ(figure.panels.size(), 3u);
  EXPECT_EQ(figure.panels[0].title, "carts.toml");
  EXPECT_TRUE(figure.panels[1].title.starts_with("Mode 1: ")) << figure.panels[1].title;
  EXPECT_TRUE(figure.panels[2].title.starts_with("Mode 2: ")) << figure.panels[2].title;
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
