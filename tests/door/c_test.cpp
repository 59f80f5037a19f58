// The C interface: what comes back, and that nothing a caller may hand in breaks it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/door/c_answer.h"

namespace CROMER_FILE {

using cromer::tests::Answer;
using cromer::tests::array;
using cromer::tests::document;
using nlohmann::json;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

Answer call(const char* verb, const char* request, const std::vector<cromer_array>& arrays = {}) {
  return Answer(cromer_call(verb, request, arrays.data(), arrays.size(), nullptr, nullptr));
}

struct Swing {
  std::vector<double> t, y;
  std::vector<cromer_array> arrays() const { return {{"t", t.data(), t.size()}, {"y", y.data(), y.size()}}; }
};

Swing swing() {
  Swing made;
  for (int i = 0; i < 1500; ++i) {
    made.t.push_back(0.01 * i);
    made.y.push_back(0.05 * std::exp(-0.05 * made.t.back()) * std::cos(3 * made.t.back()));
  }
  return made;
}

TEST(CallC, FitsArrays) {
  const Swing made = swing();
  const Answer answer = call("fit", R"({"mass": [0.2176, 0.0003], "law": "viscous"})", made.arrays());
  ASSERT_EQ(cromer_status(answer.get()), CROMER_DONE) << cromer_document(answer.get());
  const json fit = document(answer);
  EXPECT_NEAR(fit["parameters"]["decay_rate"]["value"].get<double>(), 0.05, 1e-8);
  EXPECT_NEAR(fit["parameters"]["stiffness"]["standard_error"].get<double>(), 0.0003 * 9.0025, 1e-6);
  EXPECT_EQ(array(answer, "1.measured"), made.y);
  EXPECT_EQ(array(answer, "1.x").size(), 1500u);
}

Answer written_as(const Answer& answer, const char* form) {
  return Answer(cromer_written_as(answer.get(), form));
}

TEST(CallC, ResultsAreWrittenAsTheProgramWritesThem) {
  const Swing made = swing();
  const Answer fit = call("fit", R"({"mass": 0.2, "law": "viscous"})", made.arrays());
  EXPECT_THAT(cromer_document(written_as(fit, "text").get()), HasSubstr("decay rate"));
  EXPECT_THAT(cromer_document(written_as(fit, "csv").get()), HasSubstr("stiffness (N/m)"));
  EXPECT_THAT(cromer_document(written_as(fit, "svg").get()), HasSubstr("</svg>"));
  const Answer methods = call("methods", R"({"natural_frequency": 3, "step": 0.01})");
  EXPECT_THAT(cromer_document(written_as(methods, "text").get()), HasSubstr("euler-cromer"));
  for (const char* verb : {"simulate", "spectrum", "sweep", "compare"}) {
    const std::vector<double> pulse{0, 1, 2, 1, 0};
    const bool of_ground = std::string(verb) == "spectrum";
    const Answer some =
        of_ground ? call(verb, R"({"spacing": 0.01})", {{"acceleration", pulse.data(), pulse.size()}})
        : std::string(verb) == "compare"
            ? call(verb, "{}", made.arrays())
            : call(verb, R"({"stiffness": 9, "damping": 0.2, "drive_amplitude": 1, "drive_frequency": 3})");
    ASSERT_NE(cromer_status(some.get()), CROMER_BAD_INPUT) << verb << cromer_document(some.get());
    for (const char* form : {"text", "csv"}) {
      const Answer written = written_as(some, form);
      EXPECT_EQ(cromer_status(written.get()), CROMER_DONE) << verb << cromer_document(written.get());
      EXPECT_THAT(cromer_document(written.get()), Not(HasSubstr("\"code\""))) << verb;
    }
  }
}

TEST(CallC, WhatASensorWouldReadIsAnArray) {
  const Answer run = call("simulate", R"({"stiffness": 9, "position": 1, "until": 2, "sensor_offset": 0.5})");
  const std::vector<double> x = array(run, "1.x"), sensor = array(run, "1.sensor");
  ASSERT_EQ(sensor.size(), x.size());
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(sensor[i], x[i] + 0.5, 1e-12);
}

TEST(CallC, AFormThatThereIsNotIsRefused) {
  const Answer methods = call("methods", "{}");
  for (const char* form : {"csv", "svg"})
    EXPECT_EQ(document(written_as(methods, form))["code"], "no_such_form");
  EXPECT_EQ(document(written_as(methods, "pdf"))["code"], "word_not_known");
  EXPECT_EQ(document(written_as(methods, nullptr))["argument"], "form");
  EXPECT_EQ(document(written_as(nullptr, "text"))["code"], "no_result");
  EXPECT_EQ(document(written_as(call("fit", "{}"), "text"))["code"], "no_result");
}

TEST(CallC, TheLawsMotionIsKnownBetweenAndAfterTheSamples) {
  const Swing made = swing();
  const Answer fit = call("fit", R"({"law": "viscous"})", made.arrays());
  const std::vector<double> t{0.005, 7.123, 20};
  const Answer motion(cromer_motion_at(fit.get(), 1, t.data(), t.size()));
  ASSERT_EQ(cromer_status(motion.get()), CROMER_DONE) << cromer_document(motion.get());
  EXPECT_EQ(array(motion, "t"), t);
  const auto x = array(motion, "x");
  for (std::size_t i = 0; i < t.size(); ++i)
    EXPECT_NEAR(x[i], 0.05 * std::exp(-0.05 * t[i]) * std::cos(3 * t[i]), 1e-9) << t[i];
  const double before = -1;
  EXPECT_EQ(document(Answer(cromer_motion_at(fit.get(), 1, &before, 1)))["code"], "times_before_the_first");
  EXPECT_EQ(document(Answer(cromer_motion_at(fit.get(), 2, t.data(), 3)))["code"], "no_fit_of_that_run");
  // What is said of it later is in the language of the call.
  const Answer german = call("fit", R"({"law": "viscous", "language": "de"})", made.arrays());
  EXPECT_THAT(document(Answer(cromer_motion_at(german.get(), 1, &before, 1)))["message"].get<std::string>(),
              HasSubstr("Messwert"));
  EXPECT_THAT(document(written_as(german, "pdf"))["message"].get<std::string>(), HasSubstr("nicht bekannt"));
  EXPECT_EQ(document(Answer(cromer_motion_at(nullptr, 1, t.data(), 3)))["code"], "no_fit_of_that_run");
  EXPECT_EQ(array(Answer(cromer_motion_at(fit.get(), 1, nullptr, 3)), "x"), std::vector<double>{});
}

TEST(CallC, TextsHaveUnits) {
  const Swing made = swing();
  const Answer answer = call("fit", R"({"mass": "217.6 ± 0.3 g", "law": "viscous"})", made.arrays());
  ASSERT_EQ(cromer_status(answer.get()), CROMER_DONE) << cromer_document(answer.get());
  EXPECT_NEAR(document(answer)["parameters"]["stiffness"]["value"].get<double>(), 0.2176 * 9.0025, 1e-6);
}

TEST(CallC, SimulatesSeveralMethods) {
  const Answer answer =
      call("simulate", R"({"stiffness": 9, "method": ["euler-cromer", "exact"], "step": 0.01, "until": 5})");
  ASSERT_EQ(cromer_status(answer.get()), CROMER_DONE) << cromer_document(answer.get());
  const auto t = array(answer, "2.t"), x = array(answer, "2.x");
  ASSERT_EQ(t.size(), 501u);
  EXPECT_NEAR(x.back(), std::cos(15.0), 1e-12);
  EXPECT_EQ(array(answer, "1.energy").size(), 501u);
  EXPECT_FALSE(document(answer)["runs"][0].contains("states"));
}

TEST(CallC, DrivesByAnArray) {
  const std::vector<double> force(400, 1.0);
  const Answer answer =
      call("simulate", R"({"stiffness": 9, "method": "exact", "spacing": 0.01, "until": 3})",
           {{"force", force.data(), force.size()}});
  ASSERT_EQ(cromer_status(answer.get()), CROMER_DONE) << cromer_document(answer.get());
  EXPECT_NEAR(array(answer, "1.x").back(), (1 - std::cos(9.0)) / 9, 1e-12);
}

TEST(CallC, EveryVerbAnswers) {
  const std::string data = CROMER_SOURCE_DIR "/data/";
  const std::vector<double> a(300, 1.0), periods{0.1, 1}, frequencies{1, 2, 3};
  const Swing made = swing();
  const Answer read = call("read", (R"({"file": ")" + data + R"(recording1.csv"})").c_str());
  EXPECT_EQ(cromer_status(read.get()), CROMER_DONE) << cromer_document(read.get());
  std::size_t count = 0;
  cromer_arrays(read.get(), &count);
  EXPECT_GE(count, 2u);
  const Answer compared = call("compare", R"({"method": "rk4"})", made.arrays());
  EXPECT_EQ(cromer_status(compared.get()), CROMER_DONE) << cromer_document(compared.get());
  EXPECT_EQ(array(compared, "1.1.t").size(), 1500u);
  const Answer two = call("compare", R"({"method": "rk4", "law": "viscous+drag"})", made.arrays());
  // one constant rate, and the law beside it
  EXPECT_EQ(array(two, "1.1.x").size(), 1500u);
  EXPECT_EQ(array(two, "1.2.x").size(), 1500u);
  EXPECT_EQ(array(two, "1.2.v").size(), 1500u);
  const Answer methods = call("methods", R"({"natural_frequency": 2, "step": 0.1})");
  EXPECT_EQ(document(methods)["methods"].size(), 13u);
  const Answer spectrum =
      call("spectrum", R"({"spacing": 0.01, "damping_ratio": 0.05})",
           {{"acceleration", a.data(), a.size()}, {"periods", periods.data(), periods.size()}});
  EXPECT_EQ(cromer_status(spectrum.get()), CROMER_DONE) << cromer_document(spectrum.get());
  EXPECT_EQ(array(spectrum, "period"), periods);
  EXPECT_EQ(array(spectrum, "displacement").size(), 2u);
  EXPECT_FALSE(document(spectrum)["spectra"][0].contains("SD"));  // of two components they have no arrays
  const Answer of_two = call("spectrum", R"({"spacing": 0.01})",
                             {{"acceleration", a.data(), a.size()},
                              {"second", a.data(), a.size()},
                              {"periods", periods.data(), periods.size()}});
  EXPECT_EQ(document(of_two)["spectra"][0]["components"][1]["SD"].size(), 2u)
      << cromer_document(of_two.get());
  EXPECT_EQ(document(of_two)["spectra"][0]["period"].size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const double w = 2 * std::numbers::pi / periods[i], peak = array(spectrum, "displacement")[i];
    EXPECT_NEAR(array(spectrum, "pseudo_velocity")[i], w * peak, 1e-14 * w * peak);
    EXPECT_NEAR(array(spectrum, "pseudo_acceleration")[i], w * w * peak, 1e-14 * w * w * peak);
  }
  const Answer swept =
      call("sweep", R"({"stiffness": 4, "damping": 0.1, "drive_amplitude": 1, "method": "exact"})",
           {{"drive_frequency", frequencies.data(), frequencies.size()}});
  EXPECT_EQ(cromer_status(swept.get()), CROMER_DONE) << cromer_document(swept.get());
  EXPECT_NEAR(array(swept, "amplitude (m)")[1], 1 / 0.2, 1e-9);
}

/// {"message", "argument", "code", "values"} of bad input.
void expect_refused(const Answer& answer, const char* argument, const char* words) {
  ASSERT_TRUE(answer);
  EXPECT_EQ(cromer_status(answer.get()), CROMER_BAD_INPUT);
  const json said = document(answer);
  if (argument)
    EXPECT_EQ(said["argument"], argument) << said;
  else
    EXPECT_TRUE(said["argument"].is_null()) << said;
  EXPECT_THAT(said["message"].get<std::string>(), HasSubstr(words));
  EXPECT_THAT(said["message"].get<std::string>(), Not(HasSubstr("--")));
  EXPECT_THAT(said["code"].get<std::string>(), MatchesRegex("[a-z0-9_]+")) << said;
  EXPECT_TRUE(said["values"].is_object()) << said;
  std::size_t count = 7;
  cromer_arrays(answer.get(), &count);
  EXPECT_EQ(count, 0u);
}

TEST(CallC, BadInputIsSaid) {
  const Swing made = swing();
  expect_refused(call("swim", "{}"), "verb", "no verb \"swim\"");
  expect_refused(call(nullptr, nullptr), "verb", "no verb");
  expect_refused(call("fit", "{"), "request", "from byte 2 on");
  expect_refused(call("fit", R"({"mass": 250 g})"), "request", "from byte 14 on");
  expect_refused(call("fit", R"({"mass": 1e999})"), "request", "numbers end at 1.8e308");
  expect_refused(call("fit", "[1, 2]"), "request", "no JSON object");
  expect_refused(call("fit", "{}"), "t", "give the arrays t and y, or a file");
  expect_refused(call("fit", R"({"mas": 1})", made.arrays()), "mas", "did you mean mass?");
  expect_refused(call("fit", R"({"mass": "5 N"})", made.arrays()), "mass", "is a force");
  expect_refused(call("fit", R"({"mass": {"a": 1}})", made.arrays()), "mass", "a number, a text or a list");
  expect_refused(call("fit", R"({"observed": "colour"})", made.arrays()), "observed", "position, angle");
  expect_refused(call("fit", R"({"file": 7})"), "file", "a text");
  expect_refused(call("fit", R"({"file": "/no/such"})"), nullptr, "/no/such");
  expect_refused(call("fit", R"({"file": "a.csv"})", made.arrays()), "file", "leave one of them out");
  expect_refused(call("fit", R"({"column": "x"})", made.arrays()), "column", "is for a file");
  expect_refused(call("fit", R"({"rate": 100})", made.arrays()), "rate", "is for a file");
  expect_refused(call("spectrum", R"({"spacing": 0.01, "unit": "g"})", {{"acceleration", made.y.data(), 99}}),
                 "unit", "is for a file");
  expect_refused(
      call("spectrum", R"({"spacing": 0.01, "file": "a.csv"})", {{"acceleration", made.y.data(), 99}}),
      "file", "leave one of them out");
  expect_refused(call("sweep", R"({"drive_frequency": 2})", {{"drive_frequency", made.t.data() + 1, 9}}),
                 "drive_frequency", "leave one out");
  expect_refused(call("spectrum", R"({"spacing": 0.01, "periods": 1})",
                      {{"acceleration", made.y.data(), 99}, {"periods", made.t.data() + 1, 9}}),
                 "periods", "leave one out");
  expect_refused(call("spectrum", R"({"spacing": "10 ms", "frequencies": "1:2:3 Hz"})",
                      {{"acceleration", made.y.data(), 99}, {"periods", made.t.data() + 1, 9}}),
                 "frequencies", "periods and the argument frequencies");
  expect_refused(call("spectrum", R"({"spacing": "10 m"})", {{"acceleration", made.y.data(), 99}}), "spacing",
                 "expected a time");
  expect_refused(call("simulate", R"({"until": [1, 2]})"), "until", "one value, not a list of 2");
  expect_refused(call("fit", R"({"mass": [1, 2, 3]})", made.arrays()), "mass",
                 "3 masses are given for 1 run");
  expect_refused(call("simulate", R"({"spacing": 0.1})"), "spacing", "neither is given");
  expect_refused(call("simulate", "{}", {{"force", made.y.data(), 9}}), "spacing", "in seconds");
  expect_refused(call("simulate", "{}", {{"speed", made.y.data(), 9}}), "speed",
                 "simulate takes no array speed");
  expect_refused(call("simulate", "{}", {{nullptr, made.y.data(), 9}}), "arrays", "a name");
  expect_refused(call("spectrum", "{}"), "acceleration", "give the array, or a file");
  expect_refused(call("sweep", "{}", {{"colour", made.y.data(), 9}}), "colour",
                 "sweep takes no array colour");
  expect_refused(call("read", "{}"), "file", "nothing to read");
}

TEST(CallC, ARefusalIsData) {
  const Swing made = swing();
  const json said = document(call("fit", R"({"mas": 1})", made.arrays()));
  EXPECT_EQ(said["code"], "unknown_argument_but");
  EXPECT_EQ(said["values"], json({{"argument", "mas"}, {"verb", "fit"}, {"near", "mass"}}));
  const json verbs = document(call("swim", "{}"));
  EXPECT_EQ(verbs["message"],
            "there is no verb \"swim\"; there are read, fit, simulate, compare, methods, modes, spectrum and "
            "sweep");
  EXPECT_EQ(verbs["values"]["verbs"].size(), 8u);
  const json nested = document(call("fit", R"({"mass": ""})", made.arrays()));
  EXPECT_EQ(nested["code"], "option_is_wrong");
  EXPECT_EQ(nested["values"]["what"]["code"], "value_is_empty");
}

TEST(CallC, SpeaksGermanWhereAsked) {
  const char* request =
      R"({"stiffness": 9, "method": "forward-euler", "step": 0.05, "until": 1, "language": )";
  const auto grows = [&](const char* language) {
    const json said = document(call("simulate", (std::string(request) + language + "}").c_str()));
    for (const json& each : said["notices"])
      if (each["code"] == "unstable_at_any_step") return each;
    ADD_FAILURE() << said;
    return json::object();
  };
  const json german = grows(R"("de")"), english = grows(R"("en")");
  EXPECT_EQ(german["severity"], "wrong_if_ignored");
  EXPECT_EQ(english["severity"], "wrong_if_ignored");
  EXPECT_EQ(german["text"],
            "forward-euler ist bei diesem Gesetz mit jedem Schritt instabil: die Bewegung wird wachsen");
  EXPECT_EQ(english["text"],
            "forward-euler is unstable for this law whatever the step: the motion will grow");
  EXPECT_EQ(grows("null"), english);
}

TEST(CallC, RefusesInGermanWhereAsked) {
  const Swing made = swing();
  const auto message = [](const Answer& answer) { return document(answer)["message"].get<std::string>(); };
  EXPECT_EQ(message(call("fit", R"({"language": "de"})")),
            "für fit fehlt eine Aufnahme: bitte die Felder t und y oder eine Datei angeben");
  EXPECT_EQ(message(call("swim", R"({"language": "de"})")),
            "das Verb „swim“ gibt es nicht; es gibt read, fit, simulate, compare, methods, modes, spectrum "
            "und sweep");
  EXPECT_THAT(message(call("fit", R"({"language": "de", "mass": "5 N"})", made.arrays())),
              HasSubstr("„5 N“ ist eine Kraft"));
  expect_refused(call("fit", R"({"language": "fr"})", made.arrays()), "language",
                 "language \"fr\" is not known; it takes en or de");
  expect_refused(call("methods", R"({"language": 7})"), "language", "language must be a text");
}

TEST(CallC, NamesOfNothingAreShownAsTheyWereGiven) {
  const Swing made = swing();
  EXPECT_THAT(document(call("fit", R"({"MASS": 1})", made.arrays()))["message"].get<std::string>(),
              HasSubstr("fit has no argument \"MASS\""));
  expect_refused(call("fit", R"({"spring-mass": 1})", made.arrays()), "spring-mass",
                 "did you mean spring_mass?");
  expect_refused(call("fit", "{}", {{"t", made.t.data(), 9}}), "y", "the array y is missing");
  expect_refused(call("fit", "{}", {{"t", made.t.data(), 9}, {"t", made.t.data(), 9}}), "t", "two arrays t");
  const std::string deep = R"({"law": )" + std::string(200000, '[') + std::string(200000, ']') + "}";
  expect_refused(call("fit", deep.c_str(), made.arrays()), "law", "a number, a text or a list");
  const Answer file = call("read", R"({"file": "/tmp/x --some-thing.csv"})");
  EXPECT_THAT(document(file)["message"].get<std::string>(), HasSubstr("/tmp/x --some-thing.csv"));
}

TEST(CallC, WhatCannotBeComparedIsSaid) {
  const std::vector<double> t{0, 1, 2}, y{1, 2, 1};
  const Answer few = call("compare", "{}", {{"t", t.data(), 3}, {"y", y.data(), 3}});
  EXPECT_EQ(cromer_status(few.get()), CROMER_NO_SUCCESS);
  std::vector<double> chirp;
  for (int i = 0; i < 1500; ++i) chirp.push_back(std::sin(5e-6 * i * i));
  const char* request =
      R"({"stiffness": 9, "damping": 0.4, "method": "exact", "spacing": 0.02, "step": 0.02, "until": 29.98})";
  const Answer driven = call("simulate", request, {{"force", chirp.data(), chirp.size()}});
  ASSERT_EQ(cromer_status(driven.get()), CROMER_DONE) << cromer_document(driven.get());
  const auto times = array(driven, "1.t"), motion = array(driven, "1.x");
  const Answer forced = call("compare", "{}",
                             {{"t", times.data(), times.size()},
                              {"y", motion.data(), times.size()},
                              {"force", chirp.data(), times.size()}});
  EXPECT_EQ(cromer_status(forced.get()), CROMER_BAD_INPUT);
  EXPECT_THAT(document(forced)["message"].get<std::string>(),
              HasSubstr("compare lays free motions side by side"));
}

TEST(CallC, ProgressEndsIt) {
  const auto stop = [](double done, void* user) {
    ++*static_cast<int*>(user);
    return done < 0.2 ? 1 : 0;
  };
  int calls = 0;
  const Answer answer(cromer_call("simulate",
                                  R"({"method": "rk4", "step": 1e-4, "until": 20000, "every": 10000})",
                                  nullptr, 0, stop, &calls));
  EXPECT_EQ(cromer_status(answer.get()), CROMER_NO_SUCCESS);
  EXPECT_GT(calls, 0);
  EXPECT_TRUE(document(answer)["runs"][0]["interrupted"].get<bool>());
  EXPECT_LT(array(answer, "1.t").back(), 20000);
}

TEST(CallC, NothingIsSaidOfNothing) {
  EXPECT_STREQ(cromer_document(nullptr), "");
  EXPECT_EQ(cromer_status(nullptr), CROMER_BAD_INPUT);
  std::size_t count = 3;
  EXPECT_EQ(cromer_arrays(nullptr, &count), nullptr);
  EXPECT_EQ(count, 0u);
  cromer_free(nullptr);
  EXPECT_STREQ(cromer_version(), "0.1.0");
}

}  // namespace CROMER_FILE
