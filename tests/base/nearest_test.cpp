#include "cromer/base/nearest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;

constexpr std::array<std::string_view, 5> methods{"forward-euler", "euler-cromer", "implicit-euler", "verlet",
                                                  "rk4"};

TEST(Nearest, FindsOneSlipOfTheFinger) {
  EXPECT_EQ(nearest("euler-cromr", methods), "euler-cromer");   // one missing
  EXPECT_EQ(nearest("veerlet", methods), "verlet");             // one too many
  EXPECT_EQ(nearest("rk5", methods), "rk4");                    // one wrong
  EXPECT_EQ(nearest("velret", methods), "verlet");              // two far apart
  EXPECT_EQ(nearest("eulre-cromer", methods), "euler-cromer");  // neighbours swapped
}

TEST(Nearest, IgnoresCase) { EXPECT_EQ(nearest("VERLET", methods), "verlet"); }

TEST(Nearest, CountsASwapAsOneEdit) {
  // "ab" to "ba" costs 1 as a swap and 2 as substitutions; a third of 2, plus 1, allows 1.
  constexpr std::array<std::string_view, 1> names{"ba"};
  EXPECT_EQ(nearest("ab", names), "ba");
}

TEST(Nearest, PrefersNamesThatContainWhatWasTyped) {
  EXPECT_THAT(nearest_names("euler", methods),
              ElementsAre("forward-euler", "euler-cromer", "implicit-euler"));
  EXPECT_THAT(nearest_names("Cromer", methods), ElementsAre("euler-cromer"));
  constexpr std::array<std::string_view, 3> options{"velocity", "natural-frequency", "drive-frequency"};
  EXPECT_EQ(nearest("frequency", options), "drive-frequency");  // the shorter of two
  // One slip of the finger says more than a word within a word, two letters say nothing.
  constexpr std::array<std::string_view, 2> slip{"drive-phase", "phade"};
  EXPECT_EQ(nearest("phase", slip), "phade");
  EXPECT_THAT(nearest_names("rk", methods), ElementsAre("rk4"));
  EXPECT_THAT(nearest_names("er", methods), ElementsAre());
}

TEST(Nearest, GivesUpOnWhatIsTooFar) {
  EXPECT_EQ(nearest("leapfrog-kick", methods), "");
  EXPECT_EQ(nearest("anything", {}), "");
}

TEST(Nearest, TakesTheFirstOfEquals) {
  constexpr std::array<std::string_view, 2> names{"mass", "mess"};
  EXPECT_EQ(nearest("miss", names), "mass");
}

TEST(Nearest, ThreeLettersSayEnoughAndTwoDoNot) {
  constexpr std::array<std::string_view, 2> names{"abcdefghijkl", "mnopqrstuvwx"};
  EXPECT_EQ(nearest("def", names), "abcdefghijkl");
  EXPECT_EQ(nearest("DEF", names), "abcdefghijkl");
  EXPECT_EQ(nearest("de", names), "");
}

TEST(Nearest, AThirdOfTheLongerLengthAndOneAreForgiven) {
  constexpr std::array<std::string_view, 1> six{"abcdef"};
  EXPECT_EQ(nearest("abcxyz", six), "abcdef");  // 3 of 6
  EXPECT_EQ(nearest("abwxyz", six), "");        // 4
  EXPECT_EQ(nearest("abxyz", six), "");         // 4, one of them for the length
  // Nearest by letters is one that is too far for its own length.
  constexpr std::array<std::string_view, 2> two{"zz", "abcdefghi"};
  EXPECT_EQ(nearest("abcdexxxx", two), "abcdefghi");
}

TEST(Nearest, ASwapCountsOnlyBetweenNeighbours) {
  constexpr std::array<std::string_view, 1> names{"abc"};
  EXPECT_EQ(nearest("cba", names), "abc");  // two of three
  EXPECT_EQ(nearest("bca", names), "abc");
  EXPECT_EQ(nearest("cab", names), "abc");
  constexpr std::array<std::string_view, 2> slips{"xbaz", "abxy"};
  EXPECT_EQ(nearest("xabz", slips), "xbaz");
}

TEST(Nearest, NobodyMeansANameOfMoreThanTwoHundredLetters) {
  const std::string long_name(200, 'a'), longer(201, 'a');
  const std::array<std::string_view, 1> names{long_name};
  EXPECT_EQ(nearest(long_name, names), long_name);
  EXPECT_EQ(nearest(longer, names), "");
}

TEST(Nearest, NamesAllThatContainIt) {
  constexpr std::array<std::string_view, 2> two{"one-euler", "other-euler"};
  EXPECT_THAT(nearest_names("euler", two), ElementsAre("one-euler", "other-euler"));
  EXPECT_THAT(nearest_names("zzzzzzzz", two), ElementsAre());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
