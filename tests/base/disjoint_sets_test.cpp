#include "cromer/base/disjoint_sets.h"

#include <gtest/gtest.h>

namespace cromer::core {
namespace CROMER_FILE {

TEST(DisjointSets, AreJoinedPairByPair) {
  DisjointSets sets(6);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(sets.leader(i), i);
  sets.join(0, 1);
  sets.join(2, 3);
  EXPECT_EQ(sets.leader(0), 1u);
  EXPECT_NE(sets.leader(0), sets.leader(2));
  sets.join(0, 2);
  for (const std::size_t i : {0, 1, 2, 3}) EXPECT_EQ(sets.leader(i), 3u);
  sets.join(3, 0);
  EXPECT_EQ(sets.leader(1), 3u);
  EXPECT_EQ(sets.leader(4), 4u);
  EXPECT_EQ(sets.leader(5), 5u);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
