#include "cromer/study/results.h"

#include <gtest/gtest.h>

#include <cmath>

#include <nlohmann/json.hpp>

#include "cromer/documents/words/words.h"
#include "cromer/study/write_report.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(Results, KeepNumbersTextsAndColumnsByName) {
  Results results;
  results.set("a.x", 2, "m");
  results.set("a.plain", 3);
  results.set("a.label", std::string("rk4"));
  results.set("a.k", Quantity{4, 0.5}, "N/m");
  results.set_column("a.t", {1, 2}, "s", "time");
  EXPECT_EQ(std::get<Number>(*results.fact("a.x")).unit, "m");
  EXPECT_EQ(std::get<Number>(*results.fact("a.plain")).unit, "");
  EXPECT_EQ(std::get<Number>(*results.fact("a.plain")).quantity.value, 3);
  EXPECT_EQ(std::get<Number>(*results.fact("a.plain")).quantity.uncertainty, 0);
  EXPECT_EQ(std::get<Number>(*results.fact("a.k")).quantity.uncertainty, 0.5);
  EXPECT_EQ(std::get<std::string>(*results.fact("a.label")), "rk4");
  EXPECT_EQ((*results.column("a.t"))->values, (std::vector<double>{1, 2}));
  EXPECT_EQ((*results.column("a.t"))->unit, "s");
  EXPECT_EQ((*results.column("a.t"))->name, "time");
  EXPECT_EQ(results.facts().size(), 4u);
}

TEST(Results, SuggestTheNearestOfTheirKind) {
  Results results;
  results.set("lab.stiffness", 2, "N/m");
  results.set_column("lab.t", {1}, "s", "time");
  EXPECT_EQ(in_words(results.fact("lab.stifness").error()),
            "\"lab.stifness\" is no result of this study; did you mean \"lab.stiffness\"?");
  EXPECT_EQ(in_words(results.fact("entirely different").error()),
            "\"entirely different\" is no result of this study");
  EXPECT_EQ(in_words(results.column("lab.x").error()),
            "\"lab.x\" is no column of this study; did you mean \"lab.t\"?");
  EXPECT_EQ(in_words(results.column("lab.stiffness").error()),
            "\"lab.stiffness\" is no column of this study");
}

TEST(Results, AreADocument) {
  Results results;
  results.set("a.label", std::string("rk4"));
  results.set("a.k", Quantity{4, 0.5}, "N/m");
  results.set("a.x", 2, "m");
  const auto document = nlohmann::json::parse(to_json(results));
  EXPECT_EQ(document, nlohmann::json::parse(
                          R"({"a.label": "rk4", "a.k": {"value": 4.0, "standard_error": 0.5, "unit": "N/m"},
                              "a.x": {"value": 2.0, "unit": "m"}})"));
  const Notice careful{"points_ran_away", {{"points", 1}, {"all", 4}}};
  const Notice interrupted{"task_interrupted"};
  WrittenReport report{"", {"f.svg"}, {careful}, {interrupted}, {}};
  EXPECT_EQ(nlohmann::json::parse(to_json(report)),
            nlohmann::json::parse(
                R"({"index": null, "figures": ["f.svg"], "warnings": ["1 of 4 points ran away"],
              "notices": [{"code": "points_ran_away", "severity": "worth_knowing",
                           "text": "1 of 4 points ran away", "values": {"points": 1, "all": 4}}],
              "shown": ["interrupted"]})"));
  report.index = "index.html";
  report.failure = interrupted;
  const auto failed = nlohmann::json::parse(to_json(report));
  EXPECT_EQ(failed["index"], "index.html");
  EXPECT_EQ(failed["message"], "interrupted");
}

class Text : public testing::Test {
 protected:
  Text() {
    results_.set("two.stiffness", Quantity{17.0423, 0.0235}, "N/m");
    results_.set("two.position", 0.036012, "m");
    results_.set("compared.1.amplitude_error_end", -0.0968);
    results_.set("runs.1.label", std::string("rk4"));
    results_.set("runs.1.peak", 0.25, "m");
    results_.set("phase", 1.5707963267948966, "rad");
    results_.set("missing_value", std::numeric_limits<double>::quiet_NaN(), "m");
  }

  std::string filled(std::string_view text, std::string_view scope = "") {
    const auto result = fill(text, results_, scope);
    return result ? *result : "error: " + in_words(result.error());
  }

  Results results_;
};

TEST_F(Text, writes_quantities_with_their_uncertainty) {
  EXPECT_EQ(filled("k = {two.stiffness}."), "k = 17.042\u00a0±\u00a00.024\u00a0N/m.");
  EXPECT_EQ(filled("{two.stiffness, bare}"), "17.042\u00a0±\u00a00.024");
  EXPECT_EQ(filled("{two.stiffness, concise}"), "17.042(24)\u00a0N/m");
  EXPECT_EQ(filled("{two.stiffness, no ±}"), "17.0423\u00a0N/m");
}

TEST_F(Text, converts_and_rounds) {
  EXPECT_EQ(filled("{two.position, cm, 2}"), "3.6\u00a0cm");
  EXPECT_EQ(filled("{compared.1.amplitude_error_end, %, 2, abs}"), "9.7\u00a0%");
  EXPECT_EQ(filled("{compared.1.amplitude_error_end, %, 2, signed}"), "−9.7\u00a0%");
  EXPECT_EQ(filled("{phase, °, 4, bare}"), "90.00");
  EXPECT_EQ(filled("{missing_value}"), "–");
}

TEST_F(Text, gives_options_every_digit) { EXPECT_EQ(filled("{two.position, si}"), "0.036012"); }

TEST_F(Text, takes_names_relative_to_a_run) {
  EXPECT_EQ(filled("{.label}: {.peak, cm}", "runs.1"), "rk4: 25\u00a0cm");
}

TEST_F(Text, leaves_markup_alone) { EXPECT_EQ(filled("*ω*_{d}^{2} {{x}"), "*ω*_{d}^{2} {x}"); }

TEST_F(Text, leaves_blanks_between_what_is_said_of_a_number) {
  EXPECT_EQ(filled("{  two.position  ,   cm ,2}"), "3.6\u00a0cm");
  EXPECT_EQ(filled("{two.position,cm,2}"), "3.6\u00a0cm");
}

TEST_F(Text, signs_only_what_is_above_zero) {
  results_.set("zero", 0.0, "m");
  EXPECT_EQ(filled("{zero, 2, signed, bare}"), "0");
  EXPECT_EQ(filled("{two.position, cm, 2, signed}"), "+3.6\u00a0cm");
  EXPECT_EQ(filled("{two.stiffness, signed, concise, bare}"), "+17.042(24)");
  EXPECT_EQ(filled("{compared.1.amplitude_error_end, %, 2}"), "−9.7\u00a0%");
}

TEST_F(Text, writes_units_unless_there_is_none) {
  results_.set("plain", 2.5, "1");
  results_.set("endless", HUGE_VAL, "m");
  EXPECT_EQ(filled("{plain, 3}"), "2.50");
  EXPECT_EQ(filled("{plain}"), "2.5");
  EXPECT_EQ(filled("{endless, 3}"), "–");
  EXPECT_EQ(filled("{two.stiffness, mN/m, 4}"), "17040\u00a0mN/m");
  EXPECT_EQ(filled("{runs.1.label, whatever}"), "rk4");
  EXPECT_EQ(filled("{two.position, 1}"), "0.04\u00a0m");
}

TEST_F(Text, a_brace_after_markup_or_twice_is_one) {
  EXPECT_EQ(filled("{{"), "{");
  EXPECT_EQ(filled("{{{{two}"), "{{two}");
  EXPECT_EQ(filled("a{two.position, 1, bare}b{two.position, 1, bare}"), "a0.04b0.04");
  EXPECT_EQ(filled("x_{two}^{two}"), "x_{two}^{two}");
  EXPECT_EQ(filled(""), "");
  EXPECT_EQ(filled("{.peak, 1}", "runs.2"),
            "error: \"runs.2.peak\" is no result of this study; did you mean \"runs.1.peak\"?");
}

TEST_F(Text, says_word_for_word_what_is_wrong) {
  EXPECT_EQ(filled("{two.position, kg}"),
            "error: {two.position, kg}: a value in \"m\" cannot be written in \"kg\"");
  EXPECT_EQ(filled("{two.position, 0}"),
            "error: {two.position, 0}: \"0\" is neither a unit nor a way to write a number");
  EXPECT_EQ(filled("{two.position, 2x}"),
            "error: {two.position, 2x}: \"2x\" is neither a unit nor a way to write a number");
  EXPECT_EQ(filled("k = {two.position, of which the brace is not"),
            "error: \"{two.position, of which the br\": the brace is not closed");
}

TEST_F(Text, says_what_is_wrong) {
  EXPECT_EQ(filled("{two.stifness}"),
            "error: \"two.stifness\" is no result of this study; did you mean \"two.stiffness\"?");
  EXPECT_NE(filled("{two.position, kg}").find("cannot be written in \"kg\""), std::string::npos);
  EXPECT_NE(filled("{two.position, sideways}").find("neither a unit nor"), std::string::npos);
  EXPECT_NE(filled("k = {two.position").find("not closed"), std::string::npos);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
