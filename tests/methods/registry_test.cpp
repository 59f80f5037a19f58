#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "cromer/documents/words/words.h"
#include "cromer/methods/all.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(Registry, NamesAreUniqueAndFound) {
  for (const auto name : method_names) {
    EXPECT_EQ(std::count(method_names.begin(), method_names.end(), name), 1);
    ASSERT_NE(find_method(name), nullptr);
    EXPECT_EQ(find_method(name)->name, name);
    EXPECT_EQ(visit_method(name, {}, [](const auto& method) { return method.info.name; }), name);
    EXPECT_FALSE(find_method(name)->source.empty());
  }
  EXPECT_EQ(find_method("leapfrog"), nullptr);
}

TEST(Registry, SuggestsTheNearestName) {
  EXPECT_TRUE(check_method_name("verlet").ok());
  const auto wrong = check_method_name("euler-kromer");
  ASSERT_FALSE(wrong.ok());
  EXPECT_NE(in_words(wrong.error()).find("did you mean euler-cromer"), std::string::npos)
      << in_words(wrong.error());
}

TEST(Registry, SettingsReachTheMethod) {
  const MethodSettings settings{
      .newton = {.tolerance = 1e-5, .iteration_limit = 3}, .beta = 0.2, .gamma = 0.6, .rho_inf = 0.4};
  EXPECT_EQ(make_method<ImplicitEuler>(settings).newton, settings.newton);
  EXPECT_EQ(make_method<Newmark>(settings).beta, 0.2);
  EXPECT_EQ(make_method<Newmark>(settings).gamma, 0.6);
  EXPECT_EQ(make_method<GeneralizedAlpha>(settings).rho_inf, 0.4);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
