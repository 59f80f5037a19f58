#include "cromer/base/nearest.h"

#include <gtest/gtest.h>

#include <array>

namespace cromer {
namespace {

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

TEST(Nearest, GivesUpOnWhatIsTooFar) {
  EXPECT_EQ(nearest("leapfrog-kick", methods), "");
  EXPECT_EQ(nearest("anything", {}), "");
}

TEST(Nearest, TakesTheFirstOfEquals) {
  constexpr std::array<std::string_view, 2> names{"mass", "mess"};
  EXPECT_EQ(nearest("miss", names), "mass");
}

}  // namespace
}  // namespace cromer
