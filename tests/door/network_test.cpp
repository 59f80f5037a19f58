// Networks through the door: in C++ as structs, in C as objects.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "cromer/cromer.h"
#include "tests/door/c_answer.h"

namespace CROMER_FILE {

using cromer::sought;
using cromer::tests::Answer;
using cromer::tests::array;
using cromer::tests::document;
using nlohmann::json;
using testing::HasSubstr;

const std::string networks = std::string(CROMER_SOURCE_DIR) + "/data/networks/";

/// Two carts of 2 kg between springs of 8 N/m, joined by one of 3 N/m: they swing together at 2 rad/s and
/// against each other at sqrt(7) rad/s.
cromer::Network carts(std::optional<double> wall = 8.0, std::optional<double> joint = 3.0) {
  return {{{.name = "left", .mass = 2.0, .position = 0.1}, {.name = "right", .mass = 2.0}},
          {{.to = "left", .terms = {{"stiffness", wall}}},
           {.to = "right", .terms = {{"stiffness", 8.0}}},
           {.from = "left", .to = "right", .terms = {{"stiffness", joint}}}}};
}

/// The same between dampers to the walls.
cromer::Network damped_carts() {
  cromer::Network network = carts();
  for (const std::size_t wall : {0, 1}) network.links[wall].terms.push_back({"damping", 0.05});
  return network;
}

TEST(DoorNetwork, MovesAsItsModesDo) {
  const auto run = cromer::simulate(carts(), {.method = "exact", .step = 0.05, .until = 20});
  ASSERT_TRUE(run) << run.error().message();
  EXPECT_TRUE(run->succeeded());
  EXPECT_EQ(run->names, (std::vector<std::string>{"left", "right"}));
  ASSERT_EQ(run->t.size(), 401u);
  for (std::size_t n = 0; n < run->t.size(); ++n) {
    const double together = 0.05 * std::cos(2 * run->t[n]),
                 against = 0.05 * std::cos(std::sqrt(7) * run->t[n]);
    EXPECT_NEAR(run->x[0][n], together + against, 1e-13);
    EXPECT_NEAR(run->x[1][n], together - against, 1e-13);
    EXPECT_NEAR(run->energy[n], 0.055, 1e-14);
  }
  EXPECT_EQ(json::parse(cromer::json(*run, false))["method"], "exact");
  EXPECT_TRUE(cromer::csv(*run).starts_with("t (s),left x (m),left v (m/s),right x (m)"));
  EXPECT_THAT(cromer::svg(*run), HasSubstr("</svg>"));
  EXPECT_EQ(cromer::json(cromer::NetworkSimulation{}), "");
}

TEST(DoorNetwork, OfAFileIsThatOfItsStructs) {
  for (const char* name : {"pendulums.toml", "frame.toml"}) {
    const auto read = cromer::read_network(networks + name);
    ASSERT_TRUE(read) << read.error().message();
    const auto shown = cromer::modes(*read), of_file = cromer::modes(networks + name);
    ASSERT_TRUE(shown) << shown.error().message();
    ASSERT_EQ(shown->modes.size(), of_file->modes.size());
    for (std::size_t i = 0; i < shown->modes.size(); ++i) {
      EXPECT_EQ(shown->modes[i].frequency.value, of_file->modes[i].frequency.value);
      EXPECT_EQ(shown->modes[i].damping_ratio.value, of_file->modes[i].damping_ratio.value);
      EXPECT_EQ(shown->modes[i].shape, of_file->modes[i].shape);
    }
    EXPECT_EQ(shown->names, of_file->names);
  }
  const auto open = cromer::read_network(networks + "pendulums_open.toml");
  ASSERT_TRUE(open);
  EXPECT_EQ(open->masses[0].inertia, 0.08);
  EXPECT_EQ(open->masses[0].mass, std::nullopt);
  const auto& terms = open->links.front().terms;
  EXPECT_TRUE(std::any_of(terms.begin(), terms.end(), [](const auto& each) { return !each.value; }));
  EXPECT_FALSE(cromer::read_network("nowhere.toml"));
}

TEST(DoorNetwork, IsFittedToArrays) {
  const auto run = cromer::simulate(carts(), {.method = "exact", .step = 0.05, .until = 30});
  ASSERT_TRUE(run);
  const auto fit = cromer::fit(run->t, run->x, carts(sought, sought));
  ASSERT_TRUE(fit) << fit.error().message();
  ASSERT_TRUE(fit->succeeded()) << fit->message;
  ASSERT_EQ(fit->links.size(), 3u);
  EXPECT_EQ(fit->links[2].from, "left");
  ASSERT_EQ(fit->links[2].parameters.size(), 1u);
  EXPECT_EQ(fit->links[2].parameters[0].name, "stiffness");
  EXPECT_EQ(fit->links[2].parameters[0].unit, "N/m");
  EXPECT_NEAR(fit->links[0].parameters[0].estimate.value, 8, 1e-8);
  EXPECT_NEAR(fit->links[2].parameters[0].estimate.value, 3, 1e-8);
  EXPECT_TRUE(fit->links[1].parameters.empty());
  EXPECT_NEAR(fit->masses[0].position.value, 0.1, 1e-8);
  EXPECT_EQ(fit->masses[1].residual.size(), fit->t.size());
  const auto again = cromer::simulate(*fit->network(), {.method = "exact", .step = 0.05, .until = 30});
  ASSERT_TRUE(again);
  EXPECT_NEAR(again->x[1].back(), run->x[1].back(), 1e-7);

  const auto same = cromer::fit(run->t, {run->x[0], run->x[1]}, carts(sought, sought));
  ASSERT_TRUE(same);
  EXPECT_EQ(same->links[2].parameters[0].estimate.value, fit->links[2].parameters[0].estimate.value);
  EXPECT_THAT(cromer::csv(*fit), HasSubstr("stiffness"));
  EXPECT_THAT(cromer::svg(*fit), HasSubstr("</svg>"));
  EXPECT_EQ(json::parse(cromer::json(*fit))["status"], "converged");
  EXPECT_FALSE(cromer::NetworkFit{}.network());
}

TEST(DoorNetwork, IsFittedToARecording) {
  const auto run = cromer::simulate(carts(), {.method = "exact", .step = 0.05, .until = 30});
  const std::string csv = cromer::csv(*run);
  const auto recording = cromer::read(std::as_bytes(std::span(csv)), "carts.csv");
  ASSERT_TRUE(recording);
  const auto fit = cromer::fit(*recording, carts(8.0, sought), {.to = 20.0});
  ASSERT_TRUE(fit) << fit.error().message();
  EXPECT_NEAR(fit->links[2].parameters[0].estimate.value, 3, 1e-8);
  EXPECT_LE(fit->t.back(), 20);
}

TEST(DoorNetwork, ModesAreFoundInChannels) {
  const auto run = cromer::simulate(damped_carts(), {.method = "exact", .step = 0.1, .until = 60});
  const auto found = cromer::modes(run->t, {run->x[0], run->x[1]});
  ASSERT_TRUE(found) << found.error().message();
  ASSERT_EQ(found->modes.size(), 2u);
  EXPECT_NEAR(found->modes[0].frequency.value, 2 / (2 * std::numbers::pi), 1e-6);
  EXPECT_NEAR(found->modes[1].frequency.value, std::sqrt(7) / (2 * std::numbers::pi), 1e-6);
  EXPECT_NEAR(std::abs(found->modes[1].shape[0] + found->modes[1].shape[1]), 0, 1e-6);
  EXPECT_THAT(cromer::svg(*found), HasSubstr("</svg>"));
  EXPECT_THAT(cromer::svg(*cromer::modes(carts())), HasSubstr("</svg>"));
}

TEST(DoorNetwork, ModesAreSetBesideANetwork) {
  const auto run = cromer::simulate(damped_carts(), {.method = "exact", .step = 0.1, .until = 60});
  const auto found = cromer::modes(run->t, {run->x[0], run->x[1]}, {.network = carts()});
  ASSERT_TRUE(found) << found.error().message();
  ASSERT_EQ(found->modes.size(), 2u);
  for (std::size_t j = 0; j < 2; ++j) {
    ASSERT_TRUE(found->modes[j].of_network);
    EXPECT_EQ(found->modes[j].of_network->mode, j + 1);
    EXPECT_NEAR(found->modes[j].of_network->mac, 1, 1e-6);
    EXPECT_NEAR(found->modes[j].of_network->frequency, found->modes[j].frequency.value, 1e-3);
  }
  const auto refused = cromer::modes(carts(), {.network = carts()});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(), HasSubstr("network"));
}

TEST(DoorNetwork, ErrorsNameTheArgument) {
  const auto refused = [](const auto& result, const char* argument, const char* said) {
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().argument, argument) << result.error().message();
    EXPECT_THAT(result.error().message(), HasSubstr(said));
  };
  cromer::Network wrong = carts();
  wrong.links[2].to = "rihgt";
  refused(cromer::simulate(wrong), "network", "network.link[2]: there is no mass \"rihgt\"");
  wrong = carts();
  wrong.masses[1].mass = -2;
  refused(cromer::modes(wrong), "network", "network.mass[1]: mass: it must be positive");
  wrong.masses[1].mass = std::numeric_limits<double>::quiet_NaN();
  refused(cromer::modes(wrong), "network", "network.mass[1]: mass:");
  wrong = carts();
  wrong.masses[1].inertia = 3;
  refused(cromer::modes(wrong), "network", "give one of them");
  wrong = carts();
  wrong.links[0].terms.push_back({"stifness", 3.0});
  refused(cromer::simulate(wrong), "network", "did you mean \"stiffness\"?");
  wrong.links[0].terms.back().name = "stiffness";
  refused(cromer::simulate(wrong), "network", "a link has stiffness twice");
  refused(cromer::simulate(carts(sought)), "network", "here it needs a value");
  refused(cromer::simulate(carts(), {.method = "rk5"}), "method", "did you mean");
  refused(cromer::simulate(carts(), {.step = -1.0}), "step", "positive");

  const std::vector<double> t{0, 1, 2}, x{1, 2, 3};
  refused(cromer::fit(t, {x}, carts(sought)), "channels", "each mass needs its column");
  refused(cromer::fit(t, {x, x}, carts()), "network", "no value is open");
  refused(cromer::fit(t, {x, std::span(x).first(2)}, carts(sought)), "channels[1]", "has 2 values");
  refused(cromer::fit(t, std::vector<std::vector<double>>{}, carts(sought)), "channels", "no columns");
  refused(cromer::fit({}, {x, x}, carts(sought)), "channels[0]", "has 3 values");
  refused(cromer::modes(t, {x, x}, {.method = {"rk4"}, .step = 1.0}), "", "is for networks");
}

// What has only braces is an oscillator's, not a network's.
TEST(DoorNetwork, LeavesBracesToOscillators) {
  EXPECT_TRUE(cromer::simulate({}));
  EXPECT_TRUE(cromer::simulate({.stiffness = 9}, {.step = 0.1, .until = 1}));
  EXPECT_FALSE(cromer::fit(cromer::Recording{}, {}));
}

TEST(DoorNetwork, ProgressEndsIt) {
  int calls = 0;
  const auto run = cromer::simulate(
      carts(), {.method = "rk4", .step = 1e-4, .until = 1e4, .every = 1000000, .progress = [&](double) {
                  return ++calls < 2;
                }});
  ASSERT_TRUE(run);
  EXPECT_TRUE(run->interrupted);
  EXPECT_FALSE(run->succeeded());
}

Answer call(const char* verb, const json& request, const std::vector<cromer_array>& arrays = {}) {
  return Answer(cromer_call(verb, request.dump().c_str(), arrays.data(), arrays.size(), nullptr, nullptr));
}

const json carts_in_json = json::parse(R"({
  "mass": [{"name": "left", "mass": "2000 g", "position": "10 cm"}, {"name": "right", "mass": 2}],
  "link": [{"to": "left", "stiffness": 8}, {"to": "right", "stiffness": "8 N/m"},
           {"from": "left", "to": "right", "stiffness": 3.0}]})");

TEST(CallC, RunsANetwork) {
  const Answer answer =
      call("simulate", {{"network", carts_in_json}, {"method", "exact"}, {"step", 0.05}, {"until", "20 s"}});
  ASSERT_EQ(cromer_status(answer.get()), CROMER_DONE) << cromer_document(answer.get());
  const auto run = cromer::simulate(carts(), {.method = "exact", .step = 0.05, .until = 20});
  EXPECT_EQ(array(answer, "1.t"), run->t);
  EXPECT_EQ(array(answer, "1.left.x"), run->x[0]);
  EXPECT_EQ(array(answer, "1.right.v"), run->v[1]);
  EXPECT_EQ(array(answer, "1.energy"), run->energy);
  for (const char* form : {"text", "csv", "svg"})
    EXPECT_EQ(cromer_status(Answer(cromer_written_as(answer.get(), form)).get()), CROMER_DONE) << form;
}

TEST(CallC, RunsANetworkByEachMethod) {
  const Answer answer =
      call("simulate",
           {{"network", carts_in_json}, {"method", {"exact", "verlet"}}, {"step", 0.05}, {"until", "20 s"}});
  ASSERT_EQ(cromer_status(answer.get()), CROMER_DONE) << cromer_document(answer.get());
  int number = 0;
  for (const char* method : {"exact", "verlet"}) {
    const auto run = cromer::simulate(carts(), {.method = method, .step = 0.05, .until = 20});
    const std::string of_run = std::to_string(++number) + ".";
    EXPECT_EQ(array(answer, of_run + "t"), run->t) << method;
    EXPECT_EQ(array(answer, of_run + "left.x"), run->x[0]) << method;
    EXPECT_EQ(array(answer, of_run + "energy"), run->energy) << method;
  }
  EXPECT_EQ(json::parse(cromer_document(answer.get()))["runs"][1]["method"], "verlet");
  for (const char* form : {"text", "csv", "svg"})
    EXPECT_EQ(cromer_status(Answer(cromer_written_as(answer.get(), form)).get()), CROMER_DONE) << form;
}

TEST(CallC, FitsANetwork) {
  const auto run = cromer::simulate(carts(), {.method = "exact", .step = 0.05, .until = 30});
  json open = carts_in_json;
  open["link"][2]["stiffness"] = "?";
  const std::vector<cromer_array> arrays{{"t", run->t.data(), run->t.size()},
                                         {"first", run->x[0].data(), run->t.size()},
                                         {"second", run->x[1].data(), run->t.size()}};
  const Answer answer = call("fit", {{"network", open}}, arrays);
  ASSERT_EQ(cromer_status(answer.get()), CROMER_DONE) << cromer_document(answer.get());
  EXPECT_NEAR(document(answer)["links"][2]["parameters"]["stiffness"]["value"].get<double>(), 3, 1e-8);
  EXPECT_EQ(array(answer, "1.right.measured"), run->x[1]);
  EXPECT_EQ(array(answer, "1.right.residual").size(), run->t.size());
  const Answer words(cromer_written_as(answer.get(), "text"));
  EXPECT_THAT(cromer_document(words.get()),
              testing::StartsWith("the record: converged, 601 times, 0 to 30 s\n\nlink"));
  EXPECT_EQ(document(call("fit", {{"network", open}, {"mass", 2}}, arrays))["argument"], "mass");
  EXPECT_EQ(document(call("fit", {{"network", open}, {"rate", 2}}, arrays))["code"], "said_of_a_file");
}

TEST(CallC, FindsModesInArraysAndNetworks) {
  const Answer of_network = call("modes", {{"network", carts_in_json}, {"method", "newmark"}, {"step", 0.1}});
  ASSERT_EQ(cromer_status(of_network.get()), CROMER_DONE) << cromer_document(of_network.get());
  EXPECT_NEAR(document(of_network)["modes"][0]["frequency"]["value"].get<double>(), 1 / std::numbers::pi,
              1e-12);
  const auto run = cromer::simulate(damped_carts(), {.method = "exact", .step = 0.1, .until = 60});
  const Answer of_arrays = call("modes", {{"observed", "velocity"}},
                                {{"t", run->t.data(), run->t.size()},
                                 {"a", run->v[0].data(), run->t.size()},
                                 {"b", run->v[1].data(), run->t.size()}});
  ASSERT_EQ(cromer_status(of_arrays.get()), CROMER_DONE) << cromer_document(of_arrays.get());
  EXPECT_EQ(document(of_arrays)["names"], json({"a (m/s)", "b (m/s)"}));
  EXPECT_EQ(document(of_arrays)["modes"].size(), 2u);
}

TEST(CallC, RefusesNetworksThatAreNone) {
  const auto code = [](const Answer& answer) { return document(answer)["code"].get<std::string>(); };
  EXPECT_EQ(code(call("simulate", {{"network", 7}})), "network_is_object");
  EXPECT_EQ(code(call("simulate", {{"network", {{"mass", 3}}}})), "in_file");
  EXPECT_EQ(code(call("simulate", {{"network", json::object()}})), "network_without_masses");
  EXPECT_EQ(code(call("simulate", {{"network", "nowhere.toml"}})), "in_file");
  EXPECT_EQ(code(call("simulate", {{"network", carts_in_json}, {"stiffness", 3}})), "option_not_of_networks");
  json deep = carts_in_json, in = 1;
  for (int i = 0; i < 50; ++i) in = json::array({in});
  deep["link"][0]["stiffness"] = in;
  EXPECT_EQ(cromer_status(call("simulate", {{"network", deep}}).get()), CROMER_BAD_INPUT);
  const std::vector<double> t{0, 1};
  EXPECT_EQ(code(call("simulate", {{"network", carts_in_json}}, {{"force", t.data(), 2}})),
            "not_an_array_here");
}

}  // namespace CROMER_FILE
