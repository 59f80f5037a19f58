// The panels that --panels asks for.
#include "cromer/figures/panels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

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

TEST(Time, HasTheUnitThatSuits) {
  EXPECT_EQ(time_unit(0).symbol, "s");
  EXPECT_EQ(time_unit(0.5).symbol, "s");
  EXPECT_EQ(time_unit(0.4).symbol, "ms");
  EXPECT_EQ(time_unit(4e-4).symbol, "µs");
  EXPECT_EQ(time_unit(4e-4).seconds, 1e-6);
}

TEST(Samples, AreCounted) {
  EXPECT_EQ(samples_in_words(1), "1 sample");
  EXPECT_EQ(samples_in_words(0), "0 samples");
  EXPECT_EQ(samples_in_words(12), "12 samples");
}

TEST(EndOfLine, IsTwoPeriodsAfterTheFrameIsLeft) {
  const std::vector<double> t{0, 1, 2, 3, 4, 5, 6}, x{0, 1, -3, 1, 1, 1, 1};
  EXPECT_EQ(end_of_line(t, x, 2, 1), 5u);
  EXPECT_EQ(end_of_line(t, x, 3, 1), 7u);
  EXPECT_EQ(end_of_line(t, x, 2, 10), 7u);
}

TEST(Energy, HasTheUnitThatSuits) {
  EXPECT_EQ(energy_unit(2).symbol, "J");
  EXPECT_EQ(energy_unit(0.02).symbol, "mJ");
  EXPECT_EQ(energy_unit(2e-5).symbol, "µJ");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
