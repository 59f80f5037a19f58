// Values of TOML by their types, and the place of the first that is not what it should be.
#include "cromer/read/toml_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::IsEmpty;

/// What is read of a text of TOML, and why it is refused: empty where it is not.
template <class Read>
std::string why(std::string_view text, Read read) {
  const auto table = toml::parse(text);
  if (!table) return in_words(not_toml(table, "lab.toml"));
  TomlReader reader(table.table(), "lab.toml");
  read(reader);
  const auto finished = reader.finish();
  return finished ? "" : in_words(finished.error());
}

TEST(TomlReader, TakesValuesOfTheirTypes) {
  const char* text = R"(
text = "so"
choice = "b"
number = 2.5
whole_number = 3
low = -1000000
high = 1000000
yes = true
no = false
one = 0.2
several = [1, "217.6 g", 0.1, true, false]
counts = [0, 7, 1000]
rows = [["a", 1], [], [2.5, true]]
[[parts]]
[[parts]]
)";
  const auto all = [](TomlReader& toml) {
    EXPECT_EQ(toml.text("text"), "so");
    EXPECT_EQ(toml.text("none", "otherwise"), "otherwise");
    EXPECT_EQ(toml.choice("choice", {"a", "b"}), "b");
    EXPECT_EQ(toml.choice("none", {"a", "b"}), "a");
    EXPECT_EQ(toml.number("number", 1), 2.5);
    EXPECT_EQ(toml.number("whole_number", 1), 3);
    EXPECT_EQ(toml.number("none", 1), 1);
    EXPECT_EQ(toml.maybe_number("none"), std::nullopt);
    EXPECT_EQ(toml.whole("low", 1), -1000000);
    EXPECT_EQ(toml.whole("high", 1), 1000000);
    EXPECT_EQ(toml.whole("none", 1), 1);
    EXPECT_TRUE(toml.yes("yes"));
    EXPECT_FALSE(toml.yes("no"));
    EXPECT_FALSE(toml.yes("none"));
    EXPECT_THAT(toml.values("one"), ElementsAre("0.2"));
    EXPECT_THAT(toml.values("several"), ElementsAre("1", "217.6 g", "0.1", "true", "false"));
    EXPECT_THAT(toml.values("none"), IsEmpty());
    EXPECT_THAT(toml.wholes("counts"), ElementsAre(0, 7, 1000));
    EXPECT_THAT(toml.wholes("none"), IsEmpty());
    EXPECT_THAT(toml.rows("rows"), ElementsAre(ElementsAre("a", "1"), IsEmpty(), ElementsAre("2.5", "true")));
    EXPECT_THAT(toml.rows("none"), IsEmpty());
    EXPECT_FALSE(toml.knows_all());
    EXPECT_EQ(toml.tables("parts").size(), 2u);
    EXPECT_EQ(toml.tables("none").size(), 0u);
    EXPECT_TRUE(toml.knows_all());
    EXPECT_TRUE(toml.has("no"));
    EXPECT_FALSE(toml.has("none"));
    EXPECT_EQ(toml.keys().size(), 13u);
  };
  EXPECT_EQ(why(text, all), "");
}

TEST(TomlReader, TheFirstErrorHasItsPlaceAndWhatIsSoundIsTaken) {
  EXPECT_EQ(why("a = 1", [](TomlReader& toml) { EXPECT_EQ(toml.text("a", "b"), "b"); }),
            "lab.toml:1:5: \"a\" takes a text in quotes");
  EXPECT_EQ(why("\na = \"c\"",
                [](TomlReader& toml) {
                  EXPECT_EQ(toml.choice("a", {"x", "y"}), "x");
                }),
            "lab.toml:2:5: \"a\" is one of x, y");
  EXPECT_EQ(why("a = \"1\"", [](TomlReader& toml) { EXPECT_EQ(toml.number("a", 7), 7); }),
            "lab.toml:1:5: \"a\" takes a number");
  for (const char* value : {"-1000001", "1000001", "1.0", "true"})
    EXPECT_EQ(why(std::string("a = ") + value, [](TomlReader& toml) { EXPECT_EQ(toml.whole("a", 7), 7); }),
              "lab.toml:1:5: \"a\" takes a whole number")
        << value;
  EXPECT_EQ(why("a = 1", [](TomlReader& toml) { EXPECT_FALSE(toml.yes("a")); }),
            "lab.toml:1:5: \"a\" takes true or false");
  EXPECT_EQ(why("a = [1, [], 2, {}]",
                [](TomlReader& toml) { EXPECT_THAT(toml.values("a"), ElementsAre("1", "2")); }),
            "lab.toml:1:9: \"a\" takes numbers or texts");
  EXPECT_EQ(why("a = {}", [](TomlReader& toml) { EXPECT_THAT(toml.values("a"), IsEmpty()); }),
            "lab.toml:1:5: \"a\" takes a number, a text or a list of them");
  for (const char* value : {"-1", "1001", "1.0"})
    EXPECT_EQ(why(std::string("a = [2, ") + value + ", 3]",
                  [](TomlReader& toml) { EXPECT_THAT(toml.wholes("a"), ElementsAre(2, 3)); }),
              "lab.toml:1:9: \"a\" takes a list of whole numbers from 0 to 1000")
        << value;
  EXPECT_EQ(why("a = 1", [](TomlReader& toml) { EXPECT_THAT(toml.wholes("a"), IsEmpty()); }),
            "lab.toml:1:5: \"a\" takes a list of whole numbers");
  EXPECT_EQ(why("a = [1, {}, 2, {}]", [](TomlReader& toml) { EXPECT_EQ(toml.tables("a").size(), 2u); }),
            "lab.toml:1:6: \"a\" is a list of tables");
  EXPECT_EQ(why("a = 1", [](TomlReader& toml) { EXPECT_EQ(toml.tables("a").size(), 0u); }),
            "lab.toml:1:5: \"a\" is a list of tables: write [[a]]");
  EXPECT_EQ(why("a = [1, [2], [{}, 3]]",
                [](TomlReader& toml) {
                  EXPECT_THAT(toml.rows("a"), ElementsAre(ElementsAre("2"), ElementsAre("3")));
                }),
            "lab.toml:1:6: a row is a list of texts");
  EXPECT_EQ(why("a = [[{}, 3]]",
                [](TomlReader& toml) { EXPECT_THAT(toml.rows("a"), ElementsAre(ElementsAre("3"))); }),
            "lab.toml:1:7: a cell is a text or a number");
  EXPECT_EQ(why("a = 1", [](TomlReader& toml) { EXPECT_THAT(toml.rows("a"), IsEmpty()); }),
            "lab.toml:1:5: \"a\" takes a list of rows");
  EXPECT_EQ(why("a = 1\nb = true", [](TomlReader& toml) { toml.number("b", 1), toml.text("a"); }),
            "lab.toml:2:5: \"b\" takes a number");
}

TEST(TomlReader, KeysThatNobodyAskedForAreErrors) {
  const auto asked = [](TomlReader& toml) { toml.number("mass", 1), toml.number("a", 1); };
  EXPECT_EQ(why("a = 1\nmass = 2", asked), "");
  EXPECT_EQ(why("a = 1\nmas = 2", asked), "lab.toml:2:7: \"mas\" is not known here; did you mean \"mass\"?");
  EXPECT_EQ(why("a = 1\nmass = 1\nwidth = 2", asked), "lab.toml:3:9: \"width\" is not known here");
  EXPECT_EQ(why("a = ", asked).substr(0, 12), "lab.toml:1:5");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
