// Each verb of the C interface with all that it can be given, and each result in every form.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "cromer/cromer.h"
#include "tests/door/c_answer.h"

namespace CROMER_FILE {

using cromer::tests::Answer;
using cromer::tests::array;
using cromer::tests::document;
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string source = CROMER_SOURCE_DIR, files = source + "/tests/cli/transcripts/files/";

using Arrays = std::vector<std::pair<const char*, std::vector<double>>>;

Answer call(const char* verb, const json& request, const Arrays& arrays = {},
            cromer_progress progress = nullptr) {
  std::vector<cromer_array> given;
  for (const auto& [name, values] : arrays) given.push_back({name, values.data(), values.size()});
  return Answer(cromer_call(verb, request.dump().c_str(), given.data(), given.size(), progress, nullptr));
}

std::string written(const Answer& answer, const char* form) {
  const Answer text(cromer_written_as(answer.get(), form));
  return cromer_status(text.get()) == CROMER_DONE ? cromer_document(text.get())
                                                  : document(text)["code"].get<std::string>();
}

/// How the result begins as text and as CSV, and whether a figure is drawn of it.
void expect_forms(const Answer& answer, const std::string& text, const std::string& csv, bool drawn) {
  EXPECT_THAT(written(answer, "text"), StartsWith(text));
  EXPECT_THAT(written(answer, "csv"), StartsWith(csv));
  if (drawn)
    EXPECT_THAT(written(answer, "svg"), testing::EndsWith("</svg>\n"));
  else
    EXPECT_EQ(written(answer, "svg"), "no_such_form");
}

int status(const Answer& answer) { return cromer_status(answer.get()); }

Arrays swing(double frequency = 3) {
  Arrays made{{"t", {}}, {"y", {}}};
  for (int i = 0; i < 800; ++i) {
    const double t = 0.02 * i;
    made[0].second.push_back(t);
    made[1].second.push_back(0.05 * std::exp(-0.05 * t) * std::cos(frequency * t));
  }
  return made;
}

TEST(Written, WhatWasReadIsATextAndATable) {
  const Answer read = call("read", {{"file", files + "mass1.csv"}});
  ASSERT_EQ(status(read), CROMER_DONE) << cromer_document(read.get());
  expect_forms(read, files + "mass1.csv\ndialect ", "t (s),x (m)\n0,", false);
  EXPECT_EQ(status(call("read", {{"file", files + "mass1.csv"}, {"column", "x"}})), CROMER_DONE);
  const Answer absent = call("read", {{"file", files + "mass1.csv"}, {"column", "z"}});
  EXPECT_EQ(document(absent)["notices"][0]["code"], "no_such_column_but");
  EXPECT_TRUE(document(absent)["rate"].is_null());
  EXPECT_EQ(document(call("read", {{"file", files + "mass1.csv"}, {"column", 7}}))["argument"], "column");
  EXPECT_EQ(document(call("read", {{"file", files + "none.csv"}}))["code"], "in_file");
}

TEST(Written, OneFitIsInWordsAndSeveralAreATable) {
  expect_forms(call("fit", {{"law", "viscous"}}, swing()),
               "the record, y (m), run 1: converged, 800 of 800 samples, ", "file,run,column,law,status,",
               true);
  const Answer two = call("fit", {{"law", "viscous"}, {"file", files + "two_runs.csv"}});
  ASSERT_EQ(status(two), CROMER_DONE) << cromer_document(two.get());
  expect_forms(two, "file ", "file,run,column,law,status,", true);
  EXPECT_EQ(array(two, "2.measured").size(), array(two, "1.t").size());
}

TEST(Written, SimulationsComparisonsAndSpectraHaveEveryForm) {
  expect_forms(call("simulate", {{"stiffness", 9}, {"until", 2}}), "run  t (s)",
               "run,t (s),x (m),v (m/s),energy (J)\n", true);
  expect_forms(call("compare", {{"method", "rk4"}}, swing()),
               "the record, y (m), run 1\n  rms (m)  R squared", "run,curve,t (s),", true);
  expect_forms(call("spectrum", {{"spacing", 0.01}, {"periods", json::array({0.5, 1})}},
                    {{"acceleration", {0, 1, 2, 1, 0}}}),
               "recording     samples   step (s)",
               "period (s),damping_ratio,SD (m),PSV (m/s),PSA (m/s²)\n0.5,", true);
  const json resonance{{"damping", 0.2}, {"drive_amplitude", 1}, {"drive_frequency", "0.5,1,2"}};
  expect_forms(call("sweep", resonance), "3 points by euler-cromer",
               "drive_frequency (rad/s),amplitude (m),phase (rad)\n0.5,", true);
  expect_forms(call("methods", json::object()), "method             order  implicit", "no_such_form", false);
}

TEST(Written, ModesAndNetworkFitsHaveEveryForm) {
  const std::string networks = source + "/data/networks/";
  const Answer modes = call("modes", {{"file", networks + "frame.toml"}});
  ASSERT_EQ(status(modes), CROMER_DONE) << cromer_document(modes.get());
  expect_forms(modes, "mode  frequency (Hz)  damping ratio  participation\n1 ", "mode,frequency (Hz),", true);
  const json carts = json::parse(R"({"mass": [{"name": "cart", "mass": 2, "position": 0.1}],
                                     "link": [{"to": "cart", "stiffness": "?"}]})");
  Arrays motion = swing(2);
  const Answer fitted = call("fit", {{"network", carts}}, motion);
  ASSERT_NE(status(fitted), CROMER_BAD_INPUT) << cromer_document(fitted.get());
  expect_forms(fitted, "the record: converged, 800 times, 0 to 15.98 s\n",
               "from,to,parameter,value,standard error,95 % low,95 % high,unit\nground,cart,stiffness,",
               true);
}

TEST(Verb, MethodsRecogniseTheRunOfAFile) {
  const auto run = cromer::simulate({.mass = 0.2, .stiffness = 16},
                                    {.method = "implicit-midpoint", .step = 0.01, .until = 5});
  ASSERT_TRUE(run);
  const std::string file = testing::TempDir() + "cromer_recognise.csv";
  std::ofstream(file) << cromer::csv(*run);
  json request{{"recognise", file}, {"mass", 0.2}, {"stiffness", 16}};
  const Answer made = call("methods", request);
  ASSERT_EQ(status(made), CROMER_DONE) << cromer_document(made.get());
  EXPECT_EQ(document(made)["recognised"][0]["method"], "newmark");
  expect_forms(made, "newmark with a step of 0.01 s (the same map: implicit-midpoint) made these rows.",
               "no_such_form", false);
  request["stiffness"] = 16.5;
  EXPECT_EQ(status(call("methods", request)), CROMER_NO_SUCCESS);
  request["column"] = "z";
  EXPECT_EQ(status(call("methods", request)), CROMER_BAD_INPUT);
  EXPECT_EQ(document(call("methods", {{"recognise", file + "x"}}))["code"], "in_file");
  EXPECT_EQ(document(call("methods", {{"stiffness", 16}}))["code"], "options_need_recognise");
  EXPECT_EQ(document(call("methods", {{"step", 0.1}, {"natural_frequency", -1}}))["argument"],
            "natural_frequency");
  std::remove(file.c_str());
}

TEST(Verb, ListsAreTextsWithCommas) {
  const Answer of_list = call("sweep", {{"position", {0.5, 1, 2}}, {"until", 1}, {"method", "exact"}}),
               of_text = call("sweep", {{"position", "0.5,1,2"}, {"until", 1}, {"method", "exact"}});
  ASSERT_EQ(status(of_list), CROMER_DONE) << cromer_document(of_list.get());
  EXPECT_THAT(array(of_list, "position (m)"), ElementsAre(0.5, 1, 2));
  EXPECT_EQ(array(of_list, "x (m)"), array(of_text, "x (m)"));
  EXPECT_EQ(document(call("sweep", {{"position", {0.5, {1}}}}))["code"], "must_be_value");
  EXPECT_EQ(document(call("fit", {{"zzqqxx", 1}}, swing()))["code"], "unknown_argument");
}

TEST(Verb, NothingIsSaidByNull) {
  EXPECT_EQ(status(call("simulate",
                        {{"spacing", nullptr}, {"network", nullptr}, {"stiffness", nullptr}, {"until", 1}})),
            CROMER_DONE);
  EXPECT_EQ(status(call("fit", {{"network", nullptr}, {"file", nullptr}, {"mass", nullptr}}, swing())),
            CROMER_DONE);
  EXPECT_EQ(document(call("simulate", {{"spacing", true}}))["code"], "must_be_number");
}

TEST(Verb, FitsReadFiles) {
  const Answer fit = call("fit", {{"file", files + "mass1.csv"}, {"law", "viscous"}, {"to", 4}});
  ASSERT_EQ(status(fit), CROMER_DONE) << cromer_document(fit.get());
  EXPECT_EQ(document(fit)["recording"]["column"], "x (m)");
  EXPECT_EQ(document(call("fit", {{"file", files + "none.csv"}}))["code"], "in_file");
  EXPECT_EQ(document(call("fit", {{"file", files + "mass1.csv"}, {"observed", "velocity"}}))["code"],
            "observed_of_file");
  EXPECT_EQ(document(call("fit", {{"observed", 7}}, swing()))["argument"], "observed");
  EXPECT_EQ(status(call("fit", {{"file", files + "noise.csv"}})), CROMER_NO_SUCCESS);
  EXPECT_EQ(status(call("compare", {{"file", files + "noise.csv"}})), CROMER_NO_SUCCESS);
  EXPECT_EQ(document(call("compare", {{"file", files + "none.csv"}}))["code"], "in_file");
  EXPECT_EQ(document(call("fit", json::object(), {{"y", {1, 2, 3}}}))["argument"], "t");
  EXPECT_EQ(document(call("fit", json::object(), {{"y", {1, 2, 3}}}))["code"], "array_is_missing");
  EXPECT_EQ(document(call("fit", json::object(), {{"t", {0, 1, 1}}, {"y", {1, 2, 3}}}))["argument"], "t");
}

TEST(Verb, ARecordDrivesAsForceOrGround) {
  const std::vector<double> ones(400, 1.0);
  const json request{{"mass", 2},     {"stiffness", 18},    {"method", "exact"},
                     {"position", 0}, {"spacing", "10 ms"}, {"until", 3}};
  EXPECT_NEAR(array(call("simulate", request, {{"force", ones}}), "1.x").back(), (1 - std::cos(9.0)) / 18,
              1e-12);
  EXPECT_NEAR(array(call("simulate", request, {{"acceleration", ones}}), "1.x").back(),
              -(1 - std::cos(9.0)) / 9, 1e-12);
  const json both = document(call("simulate", request, {{"force", ones}, {"acceleration", ones}}));
  EXPECT_EQ(both["code"], "force_and_acceleration");
  EXPECT_EQ(both["argument"], "force");
  json without = request;
  without.erase("spacing");
  const json missing = document(call("simulate", without, {{"acceleration", ones}}));
  EXPECT_EQ(missing["code"], "spacing_is_missing");
  EXPECT_EQ(missing["values"]["array"], "acceleration");
}

TEST(Verb, ModesAreOfFilesArraysOrNetworks) {
  const auto code = [](const Answer& answer) { return document(answer)["code"].get<std::string>(); };
  const Answer alone = call("modes", json::object(), swing());
  ASSERT_EQ(status(alone), CROMER_DONE) << cromer_document(alone.get());
  EXPECT_NEAR(document(alone)["modes"][0]["frequency"]["value"].get<double>(),
              std::hypot(3, 0.05) / (2 * std::numbers::pi), 1e-6);
  EXPECT_EQ(code(call("modes", json::object())), "no_file");
  EXPECT_EQ(code(call("modes", {{"file", 7}})), "must_be_text");
  EXPECT_EQ(code(call("modes", {{"observed", 7}})), "must_be_text");
  EXPECT_EQ(code(call("modes", {{"observed", "velocity"}})), "observed_of_file");
  EXPECT_EQ(code(call("modes", {{"rate", 7}}, swing())), "said_of_a_file");
  EXPECT_EQ(document(call("modes", {{"modes", -1}}, swing()))["argument"], "modes");
  EXPECT_EQ(document(call("modes", {{"observed", "colour"}}, swing()))["argument"], "observed");
  EXPECT_EQ(code(call("modes", {{"file", files + "mass1.csv"}}, swing())), "file_and_arrays");
  EXPECT_EQ(code(call("modes", {{"network", 7}})), "network_is_object");
  EXPECT_EQ(status(call("modes", {{"file", files + "noise.csv"}})), CROMER_NO_SUCCESS);
  const Answer beside = call("modes", {{"file", source + "/data/networks/floors_in_wind.csv"},
                                       {"network", source + "/data/networks/frame.toml"}});
  ASSERT_EQ(status(beside), CROMER_DONE) << cromer_document(beside.get());
  EXPECT_EQ(document(beside)["modes"][2]["of_network"]["mode"], 3);
}

TEST(Verb, SpectraAreOfFilesOrArrays) {
  const std::string ground = source + "/data/ground/shaking.csv";
  const json request{{"file", ground}, {"column", "east"}, {"periods", "0.2,1"}, {"damping_ratio", "2%,5%"}};
  const Answer two = call("spectrum", request);
  ASSERT_EQ(status(two), CROMER_DONE) << cromer_document(two.get());
  EXPECT_EQ(array(two, "1.displacement").size(), 2u);
  EXPECT_GT(array(two, "1.displacement")[0], array(two, "2.displacement")[0]);
  json spaced = request;
  spaced["spacing"] = 0.01;
  EXPECT_EQ(document(call("spectrum", spaced))["code"], "spacing_of_a_file");
  EXPECT_EQ(document(call("spectrum", {{"file", 7}}))["argument"], "file");
  EXPECT_EQ(document(call("spectrum", {{"file", files + "none.csv"}}))["code"], "in_file");
  EXPECT_EQ(document(call("spectrum", json::object(), {{"acceleration", {1, 2, 3}}}))["code"],
            "spacing_is_missing");
  EXPECT_EQ(document(call("spectrum", {{"spacing", 0.01}},
                          {{"acceleration", {1, 2, 3}}, {"second", {1, 2}}}))["argument"],
            "second");
  EXPECT_EQ(document(call("spectrum", {{"spacing", 0.01}},
                          {{"acceleration", {1, 2, 3}}, {"periods", {1, std::nan("")}}}))["argument"],
            "periods");
  EXPECT_EQ(document(call("spectrum", {{"spacing", 0.01}, {"peaks", "loud"}},
                          {{"acceleration", {1, 2, 3}}}))["argument"],
            "peaks");
  EXPECT_EQ(
      document(call("spectrum", {{"spacing", 0.01}}, {{"acceleration", {1, 2, 3}}, {"force", {1}}}))["code"],
      "not_an_array_here");
  const Answer shock = call("spectrum", {{"spacing", 0.001}, {"shock", true}, {"frequencies", "20,50 Hz"}},
                            {{"acceleration", {0, 1, 2, 3, 2, 1, 0}}});
  ASSERT_EQ(status(shock), CROMER_DONE) << cromer_document(shock.get());
  EXPECT_EQ(array(shock, "period").size(), 2u);
  std::size_t count = 0;
  const cromer_array* given = cromer_arrays(shock.get(), &count);
  EXPECT_TRUE(std::none_of(given, given + count, [](const cromer_array& each) {
    return std::string_view(each.name).find("displacement") == 0 ||
           std::string_view(each.name).starts_with("pseudo");
  }));
}

TEST(Verb, WhatFailsIsNoSuccess) {
  const json grows{{"stiffness", 1e6}, {"method", "forward-euler"}, {"step", 0.1}, {"until", 900}};
  EXPECT_EQ(status(call("simulate", grows)), CROMER_NO_SUCCESS);
  json several = grows;
  several["stiffness"] = {1e6, 2e6};
  EXPECT_EQ(status(call("sweep", several)), CROMER_NO_SUCCESS);
  EXPECT_EQ(document(call("sweep", {{"stiffness", "1:2"}}))["code"],
            document(call("sweep", {{"mass", "1:2"}}))["code"]);
  const json frame{{"network", source + "/data/networks/frame.toml"},
                   {"method", "forward-euler"},
                   {"step", 0.5},
                   {"until", 200}};
  const Answer run = call("simulate", frame);
  EXPECT_EQ(status(run), CROMER_NO_SUCCESS);
  EXPECT_THAT(document(run)["message"].get<std::string>(),
              StartsWith("diverged: not finite after t = 54 s"));
}

TEST(Verb, WhatIsInterruptedIsNoSuccess) {
  const auto stop = [](double, void*) { return 0; };
  const Answer spectrum = call("spectrum", {{"spacing", 0.01}, {"periods", "0.01:10:20000:log"}},
                               {{"acceleration", std::vector<double>(2000, 1.0)}}, stop);
  EXPECT_EQ(status(spectrum), CROMER_NO_SUCCESS) << cromer_document(spectrum.get());
  EXPECT_EQ(document(spectrum)["message"], "interrupted");
  EXPECT_THAT(written(spectrum, "text"), Not(HasSubstr("no_result")));
  EXPECT_EQ(written(spectrum, "csv"), "no_result");
  EXPECT_EQ(written(spectrum, "svg"), "no_result");
  const Answer sweep = call(
      "sweep",
      {{"position", "0:1:400"}, {"velocity", "0:1:400"}, {"cubic", 0.1}, {"until", 1000}, {"threads", 1}}, {},
      stop);
  EXPECT_EQ(status(sweep), CROMER_NO_SUCCESS);
}

TEST(Verb, ArraysHaveNamesAndValues) {
  const double one = 1;
  const auto code = [](const cromer_array& array) {
    return document(Answer(cromer_call("simulate", "{}", &array, 1, nullptr, nullptr)))["code"]
        .get<std::string>();
  };
  EXPECT_EQ(code({"", &one, 1}), "array_without_name_or_values");
  EXPECT_EQ(code({nullptr, &one, 1}), "array_without_name_or_values");
  EXPECT_EQ(code({"force", nullptr, 1}), "array_without_name_or_values");
  EXPECT_EQ(code({"colour", nullptr, 0}), "not_an_array_here");
  const Answer run = call("simulate", {{"until", 1}});
  EXPECT_NE(cromer_arrays(run.get(), nullptr), nullptr);
}

}  // namespace CROMER_FILE
