#include "cromer/study/task/methods.h"

#include <gtest/gtest.h>

#include "cromer/methods/all.h"

namespace cromer {
namespace {

TEST(ListMethods, HasTheRegistryInItsOrder) {
  const auto rows = list_methods();
  ASSERT_EQ(rows.size(), method_names.size());
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].name, method_names[i]);
}

TEST(ListMethods, SaysWhatTheTheorySays) {
  for (const auto& row : list_methods()) {
    if (row.name == "exact") {
      EXPECT_FALSE(row.order);
    }
    if (row.name == "rk4") {
      EXPECT_EQ(row.order, 4);
    }
    if (row.name == "verlet") {
      EXPECT_EQ(row.order, 2);
    }
    if (row.name == "implicit-euler") {
      EXPECT_TRUE(row.implicit && !row.symplectic);
    }
    if (row.name == "euler-cromer") {
      EXPECT_TRUE(row.symplectic && !row.implicit && row.order == 1);
    }
    EXPECT_FALSE(row.source.empty()) << row.name;
  }
}

}  // namespace
}  // namespace cromer
