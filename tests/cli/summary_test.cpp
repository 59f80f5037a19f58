// What the program says to a reader without --json.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::HasSubstr;

std::string said(const std::vector<std::string>& arguments) {
  const Folder folder;
  const Finished end = folder.run(arguments);
  EXPECT_EQ(end.status, 0) << end.err;
  return end.out;
}

TEST(Summary, OfMethodsSaysWhatWasAskedForAndWhatBecomesOfIt) {
  const std::string text =
      said({"methods", "--natural-frequency", "6", "--damping-ratio", "0.025", "--step", "0.01"});
  EXPECT_THAT(text, HasSubstr("asked for: decay rate 0.15 1/s, frequency 5.99812 rad/s, energy x 0.730331 a "
                              "cycle; step 0.01 s: w0 h = 0.06, 105 steps a cycle"));
  EXPECT_THAT(text, HasSubstr("\nWith this step\nforward-euler turns your damping of 0.15 1/s into growth of "
                              "0.02999 1/s and swings at 5.99993 rad/s, 0.03 % too fast\n"));
  EXPECT_THAT(text, HasSubstr("\neuler-cromer nearly keeps your damping of 0.15 1/s (0.1502)"));
  EXPECT_THAT(text, HasSubstr("-120 %"));
  EXPECT_THAT(said({"methods", "--natural-frequency", "6", "--damping-ratio", "2", "--step", "0.01"}),
              HasSubstr("too damped to swing"));
}

TEST(Summary, OfSeveralDriveFrequenciesSaysEachMethodsEffectOnce) {
  const std::string text = said({"simulate", "--stiffness", "36", "--damping", "0.3", "--drive-amplitude",
                                 "1", "--drive-frequency", "3", "--drive-frequency", "5", "--method",
                                 "implicit-euler", "--step", "0.01"});
  const auto first = text.find("implicit-euler turns your damping");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(text.find("turns your damping", first + 20), std::string::npos);
  EXPECT_THAT(text, HasSubstr("steady motion: amplitude and lag behind the drive"));
  EXPECT_THAT(text, HasSubstr("transmissibility: force on the ground over force on the mass"));
}

TEST(Summary, OfAnAccuracySaysTheStepThatKeepsToIt) {
  const std::string text = said({"simulate", "--stiffness", "36", "--damping", "0.3", "--method", "rk4",
                                 "--accuracy", "0.1 %", "--until", "10"});
  EXPECT_THAT(text, HasSubstr("longest steps that keep to 0.1 %, as measured"));
}

TEST(Summary, OfALawWithDragSaysWhereTheEnergyWent) {
  const std::string text = said({"simulate", "--drag", "0.2", "--method", "implicit-euler"});
  EXPECT_THAT(text, HasSubstr("implicit-euler swung at "));
  EXPECT_THAT(text, HasSubstr("had 0.5 J, of which drag took 75.6 %, the method itself 24.3 %"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
