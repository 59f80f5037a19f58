// What the door makes of Errors and Notices from within.
#include "cromer/door/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "cromer/documents/words/catalogue.h"
#include "cromer/door/options.h"

namespace cromer::core {
namespace CROMER_FILE {

/// The code of an entry whose sentence begins with that option.
std::string begins_with_option(std::string_view option) {
  const std::string place = "{--" + std::string(option) + "}";
  for (const std::span<const Entry>& each : catalogue())
    for (const Entry& entry : each)
      if (entry.english.starts_with(place)) return std::string(entry.code);
  ADD_FAILURE() << "no sentence begins with " << place;
  return {};
}

TEST(InArguments, TheOptionThatTheSentenceBeginsWithIsTheArgument) {
  const std::string code = begins_with_option("drive-frequency");
  const Error error = in_arguments(Error{code});
  EXPECT_EQ(error.argument, "drive_frequency");
  EXPECT_FALSE(error.notice.of_arrays);
  EXPECT_THAT(error.message(), testing::StartsWith("drive_frequency"));
}

TEST(InArguments, AnOptionThatIsAValueIsTheArgument) {
  const Error error =
      in_arguments(Error{"option_is_wrong", {{"option", "spring-mass"}, {"what", Notice{"value_is_empty"}}}});
  EXPECT_EQ(error.argument, "spring_mass");
  EXPECT_EQ(error.message(), "spring_mass: the value is empty");
  EXPECT_EQ(error.message(Language::german), "spring_mass: der Wert fehlt");
}

TEST(InArguments, AnArgumentThatIsKnownStays) {
  const std::string code = begins_with_option("step");
  EXPECT_EQ(in_arguments(Error{Notice{code}, "t"}).argument, "t");
  EXPECT_EQ(in_arguments(Error{Notice{code}, "t"}, true).argument, "t");
}

TEST(InArguments, OfArraysAForceIsNoColumn) {
  const std::string code = begins_with_option("force-column");
  EXPECT_EQ(in_arguments(Error{code}).argument, "force_column");
  EXPECT_EQ(in_arguments(Error{code}, true).argument, "force");
  // It is said of arrays once and for all.
  EXPECT_EQ(in_arguments(in_arguments(Error{Notice{"no such code"}}, true)).notice.of_arrays, true);
}

TEST(InArguments, OfArraysAColumnIsAnArgument) {
  const auto argument = [](const Notice& notice, bool of_arrays) {
    return in_arguments(Error{notice}, of_arrays).argument;
  };
  const Notice plain{"column_has_no_values", {{"column", "y"}}};
  const Notice with_unit{"column_has_no_values", {{"column", "force (N)"}}};
  const Notice nested{"fit_without_law", {{"what", plain}}};
  const Notice both{"force_ends", {{"force", "force"}, {"column", "y"}}};
  EXPECT_EQ(argument(plain, true), "y");
  EXPECT_EQ(argument(with_unit, true), "force");
  EXPECT_EQ(argument(nested, true), "y");
  EXPECT_EQ(argument(both, true), "force");
  EXPECT_EQ(argument(plain, false), "");
  EXPECT_EQ(argument(Notice{"fit_is_empty"}, true), "");
}

TEST(InArguments, NoticesAreSaidOfArrays) {
  const std::vector<Notice> notices =
      in_arguments(std::vector<Notice>{Notice{"missing_values"}, Notice{"unit_assumed"}}, true);
  ASSERT_EQ(notices.size(), 2u);
  EXPECT_TRUE(notices[0].of_arrays && notices[1].of_arrays);
  EXPECT_FALSE(in_arguments(Notice{"missing_values"}).of_arrays);
  EXPECT_EQ(message_of(Notice{}), "");
}

TEST(Observed, TheErrorNamesTheWord) {
  const auto wrong = observed_of("colour");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().notice.code, "word_not_known");
  EXPECT_EQ(wrong.error().message(),
            "observed \"colour\" is not known; it takes position, angle, velocity, angular_velocity or "
            "acceleration");
  EXPECT_EQ(wrong.error().message(Language::german),
            "observed „colour“ ist nicht bekannt; es nimmt position, angle, velocity, angular_velocity oder "
            "acceleration");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
