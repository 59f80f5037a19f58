#include "cromer/study/results.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cromer/documents/words/words.h"
#include "cromer/study/write_report.h"

namespace cromer::core {
namespace {

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
  const Notice careful{"points_not_settled", {{"points", 1}, {"all", 4}}};
  const Notice interrupted{"task_interrupted"};
  WrittenReport report{"", {"f.svg"}, {careful}, {interrupted}, {}};
  EXPECT_EQ(nlohmann::json::parse(to_json(report)),
            nlohmann::json::parse(
                R"({"index": null, "figures": ["f.svg"], "warnings": ["1 of 4 points never settled"],
              "notices": [{"code": "points_not_settled", "severity": "worth_knowing",
                           "text": "1 of 4 points never settled", "values": {"points": 1, "all": 4}}],
              "shown": ["interrupted"]})"));
  report.index = "index.html";
  report.failure = interrupted;
  const auto failed = nlohmann::json::parse(to_json(report));
  EXPECT_EQ(failed["index"], "index.html");
  EXPECT_EQ(failed["message"], "interrupted");
}

}  // namespace
}  // namespace cromer::core
