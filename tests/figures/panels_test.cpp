// The panels that --panels asks for.
#include "cromer/figures/panels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace {

using ::testing::ElementsAre;

TEST(Panels, AreTakenInTheOrderAsked) {
  EXPECT_THAT(*parse_panels(""), ElementsAre(MotionPanel::position));
  EXPECT_THAT(*parse_panels("phase, energy,velocity"),
              ElementsAre(MotionPanel::phase, MotionPanel::energy, MotionPanel::velocity));
}

TEST(Panels, ThatDoNotExistAreNamedWithTheNearest) {
  const auto said = [](const char* names) {
    const auto panels = parse_panels(names);
    return panels ? std::string() : in_words(panels.error().notice);
  };
  EXPECT_EQ(said("position,velocty"),
            "--panels: there is no panel \"velocty\"; did you mean velocity? There are position, velocity, "
            "energy and phase");
  EXPECT_EQ(said("zz"), "--panels: there is no panel \"zz\"; there are position, velocity, energy and phase");
  EXPECT_EQ(said("energy,"),
            "--panels: there is no panel \"\"; there are position, velocity, energy and phase");
  EXPECT_EQ(said("energy,phase,energy"), "--panels: energy stands there twice; name it once");
}

TEST(Panels, AreATitle) {
  const auto title = [](const char* names) { return panels_in_words(*parse_panels(names)); };
  EXPECT_EQ(title("energy"), "Energy against time");
  EXPECT_EQ(title("position,velocity,phase"), "Position and velocity against time and the phase portrait");
  EXPECT_EQ(title("velocity,position,energy"), "Velocity, position and energy against time");
  EXPECT_EQ(title("phase"), "Phase portrait");
}

TEST(Portrait, OfManyPeriodsIsTheirFirstAndLast) {
  const PortraitPart whole = portrait_part(1, 21, 1), ends = portrait_part(1, 22, 1),
                     no_period = portrait_part(0, 1e9, 0);
  EXPECT_TRUE(whole.has(10) && no_period.has(5e8));
  EXPECT_EQ(whole.title, "Phase portrait");
  EXPECT_EQ(ends.title, "Phase portrait of the first 5 and the last 3 periods");
  EXPECT_TRUE(ends.has(6) && ends.has(19));
  EXPECT_FALSE(ends.has(6.01) || ends.has(18.99));
}

TEST(Energy, HasTheUnitThatSuits) {
  EXPECT_EQ(energy_unit(2).symbol, "J");
  EXPECT_EQ(energy_unit(0.02).symbol, "mJ");
  EXPECT_EQ(energy_unit(2e-5).symbol, "µJ");
}

}  // namespace
}  // namespace cromer::core
