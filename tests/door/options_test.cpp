// Options of the C++ interface: those that are no enumerators or no numbers are refused by name, and each
// does what the same option of the program does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cromer/cromer.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/simulate/simulate.h"

namespace CROMER_FILE {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double infinite = std::numeric_limits<double>::infinity();
const double unknown = std::nan("");

/// The argument and the code of what is refused.
template <class T>
std::pair<std::string, std::string> refusal(const cromer::Result<T>& result) {
  if (result) return {"", "not refused"};
  return {result.error().argument, result.error().notice.code};
}

std::pair<std::string, std::string> of(const char* argument, const char* code) { return {argument, code}; }

template <class Enumeration>
constexpr Enumeration none = static_cast<Enumeration>(77);

std::vector<double> times() {
  std::vector<double> t;
  for (int i = 0; i < 800; ++i) t.push_back(0.02 * i);
  return t;
}

std::vector<double> swing() {
  std::vector<double> y;
  for (const double t : times()) y.push_back(0.05 * std::exp(-0.05 * t) * std::cos(3 * t));
  return y;
}

TEST(DoorOptions, WhatIsNoEnumeratorIsRefused) {
  const std::vector<double> t = times(), y = swing(), w{1, 2};
  EXPECT_EQ(refusal(cromer::response_spectrum(y, 0.01, {.peaks = none<cromer::Peaks>})).first, "peaks");
  EXPECT_EQ(refusal(cromer::response_spectrum(y, 0.01, {.between = none<cromer::BetweenSamples>})).first,
            "between");
  EXPECT_EQ(refusal(cromer::response_spectrum(y, 0.01, {.shock = none<cromer::ShockResponse>})).first,
            "shock");
  EXPECT_EQ(refusal(cromer::fit(t, y, {.between_samples = none<cromer::BetweenSamples>})).first,
            "between_samples");
  EXPECT_EQ(refusal(cromer::fit(t, y, {.observed = none<cromer::Observed>})).first, "observed");
  EXPECT_EQ(refusal(cromer::modes(t, {y}, {.observed = none<cromer::Observed>})).first, "observed");
  EXPECT_EQ(refusal(cromer::sweep({}, w, {.direction = none<cromer::SweepOptions::Direction>})).first,
            "direction");
  EXPECT_EQ(
      refusal(cromer::simulate({}, {.drive = cromer::Pulse{.shape = none<cromer::Pulse::Shape>}})).first,
      "shape");
  EXPECT_EQ(
      refusal(cromer::simulate({}, {.drive = cromer::SampledForce{.force = y,
                                                                  .spacing = 0.1,
                                                                  .between = none<cromer::BetweenSamples>}}))
          .first,
      "between");
  EXPECT_EQ(
      refusal(cromer::simulate({}, {.drive = cromer::GroundMotion{.acceleration = y,
                                                                  .spacing = 0.1,
                                                                  .between = none<cromer::BetweenSamples>}}))
          .first,
      "between");
}

TEST(DoorOptions, WhatIsNoNumberIsRefused) {
  const std::vector<double> t = times(), y = swing();
  std::vector<double> endless = y, missing = y;
  endless[7] = infinite;
  missing[7] = unknown;
  EXPECT_EQ(refusal(cromer::response_spectrum(y, infinite)), of("spacing", "spacing_not_positive"));
  EXPECT_EQ(refusal(cromer::response_spectrum(y, 0)), of("spacing", "spacing_not_positive"));
  EXPECT_EQ(refusal(cromer::response_spectrum(y, 0.01, {.second = missing})),
            of("second", "value_not_finite"));
  EXPECT_EQ(refusal(cromer::response_spectrum(y, 0.01, {.second = t.size() > 3 ? std::span(t).first(3) : t})),
            of("second", "lengths_differ"));
  const double periods[] = {1, unknown};
  EXPECT_EQ(refusal(cromer::response_spectrum(y, 0.01, {.periods = periods})),
            of("periods", "value_not_finite"));
  EXPECT_EQ(refusal(cromer::fit(t, y, {.force = endless})), of("force", "value_is_infinite"));
  EXPECT_EQ(refusal(cromer::fit(t, y, {.force = std::span(y).first(3)})), of("force", "lengths_differ"));
  EXPECT_EQ(refusal(cromer::fit(t, endless)), of("y", "value_is_infinite"));
  const double one[] = {1, 2}, backwards[] = {2, 1}, w[] = {1, 0};
  EXPECT_EQ(refusal(cromer::fit(t, y)->at(backwards)), of("t", "times_do_not_increase"));
  EXPECT_EQ(refusal(cromer::sweep({}, w)), of("drive_frequency", "value_not_positive"));
  EXPECT_EQ(refusal(cromer::sweep({}, one, {.threads = -1})), of("threads", "too_few_threads"));
  EXPECT_EQ(refusal(cromer::sweep({}, one, {.drive_amplitude = 0})),
            of("drive_amplitude", "drive_amplitude_not_positive"));
}

TEST(DoorOptions, TwoSamplesAreAForceAndAComponent) {
  const double two[] = {1, 2}, periods[] = {0.1};
  EXPECT_TRUE(cromer::response_spectrum(two, 0.01, {.periods = periods, .second = two}));
  EXPECT_TRUE(cromer::simulate({.mass = 1, .stiffness = 9}, {.drive = cromer::SampledForce{two, 0.1}}));
  EXPECT_EQ(refusal(cromer::response_spectrum(std::span(two).first(1), 0.01)),
            of("acceleration", "too_few_values"));
  EXPECT_EQ(
      refusal(cromer::simulate({}, {.drive = cromer::GroundMotion{std::span(two).first(1), 0.1}})).second,
      "too_few_values");
}

TEST(DoorOptions, OfDrivesAreThoseOfTheProgram) {
  using Shape = cromer::Pulse::Shape;
  using Typed = std::vector<cromer::core::TypedOption>;
  const std::pair<cromer::Drive, Typed> drives[] = {
      {cromer::Harmonic{1, 2, 0.3},
       {{"drive-amplitude", "1"}, {"drive-frequency", "2"}, {"drive-phase", "0.3"}}},
      {cromer::Unbalance{0.1, 0.05, 2, 0.3},
       {{"drive", "unbalance"},
        {"unbalance-mass", "0.1"},
        {"eccentricity", "0.05"},
        {"drive-frequency", "2"},
        {"drive-phase", "0.3"}}},
      {cromer::ShakingBase{0.01, 2, 0.3},
       {{"drive", "base"}, {"base-displacement", "0.01"}, {"drive-frequency", "2"}, {"drive-phase", "0.3"}}},
      {cromer::Pulse{Shape::step, 2, 0.1, 0},
       {{"drive", "step"}, {"drive-amplitude", "2"}, {"drive-start", "0.1"}}},
      {cromer::Pulse{Shape::rectangular, 2, 0.1, 0.5},
       {{"drive", "rectangular"},
        {"drive-amplitude", "2"},
        {"drive-start", "0.1"},
        {"drive-duration", "0.5"}}},
      {cromer::Pulse{Shape::half_sine, 2, 0.1, 0.5},
       {{"drive", "half-sine"}, {"drive-amplitude", "2"}, {"drive-start", "0.1"}, {"drive-duration", "0.5"}}},
      {cromer::Pulse{Shape::triangular, 2, 0.1, 0.5},
       {{"drive", "triangular"},
        {"drive-amplitude", "2"},
        {"drive-start", "0.1"},
        {"drive-duration", "0.5"}}},
      {cromer::Chirp{.amplitude = 2, .from = 1, .to = 5, .start = 0.1, .duration = 3, .phase = 0.3},
       {{"drive", "chirp"},
        {"drive-amplitude", "2"},
        {"drive-frequency", "1"},
        {"drive-to", "5"},
        {"drive-start", "0.1"},
        {"drive-duration", "3"},
        {"drive-phase", "0.3"}}},
      {cromer::Chirp{.amplitude = 2, .from = 1, .to = 5, .logarithmic = true},
       {{"drive", "logarithmic-chirp"},
        {"drive-amplitude", "2"},
        {"drive-frequency", "1"},
        {"drive-to", "5"}}}};
  for (const auto& [drive, typed] : drives) {
    Typed all = typed;
    for (const auto& [name, value] : {std::pair("stiffness", "9"),
                                      {"damping", "0.5"},
                                      {"method", "rk4"},
                                      {"step", "0.01"},
                                      {"until", "4"}})
      all.emplace_back(name, value);
    cromer::core::SimulateOptions options;
    ASSERT_TRUE(cromer::core::assign(all, options_of(options), "simulate"));
    const auto program = cromer::core::simulate(options);
    const auto door = cromer::simulate({.mass = 1, .stiffness = 9, .damping = 0.5},
                                       {.method = "rk4", .drive = drive, .step = 0.01, .until = 4});
    ASSERT_TRUE(program && door) << drive.index();
    EXPECT_EQ(door->x, program->runs[0].trajectory.x) << drive.index();
    EXPECT_EQ(door->v, program->runs[0].trajectory.v) << drive.index();
  }
}

TEST(DoorOptions, OfSpectraAreThoseOfTheProgram) {
  const std::vector<double> y = swing();
  const double periods[] = {0.5, 1};
  const auto document = [&](cromer::SpectrumOptions options) {
    options.periods = periods;
    const auto spectrum = cromer::response_spectrum(y, 0.02, options);
    return spectrum ? json::parse(cromer::json(*spectrum)) : json(spectrum.error().message());
  };
  const json plain = document({});
  EXPECT_EQ(plain["peaks"], "continuous");
  EXPECT_EQ(plain["between_samples"], "linear");
  EXPECT_EQ(plain["spectra"][0]["damping_ratio"], 0.05);
  EXPECT_EQ(document({.damping_ratio = 0.02})["spectra"][0]["damping_ratio"], 0.02);
  EXPECT_EQ(document({.loss_factor = 0.1})["spectra"][0]["loss_factor"], 0.1);
  EXPECT_EQ(document({.peaks = cromer::Peaks::samples})["peaks"], "samples");
  EXPECT_EQ(document({.peaks = cromer::Peaks::peer})["peaks"], "peer");
  EXPECT_EQ(document({.between = cromer::BetweenSamples::hold})["between_samples"], "hold");
  EXPECT_EQ(document({.ductility = 4})["spectra"][0]["ductility"], 4);
  const auto german = cromer::response_spectrum(y, 0.02, {.periods = periods});
  EXPECT_NE(cromer::json(*german, cromer::Language::german), cromer::json(*german));

  const auto shock = cromer::response_spectrum(
      y, 0.02, {.shock = cromer::ShockResponse::pseudo_velocity, .periods = periods});
  ASSERT_TRUE(shock) << shock.error().message();
  EXPECT_EQ(shock->shock.size(), 2u);
  EXPECT_TRUE(shock->displacement.empty() && shock->pseudo_velocity.empty());
}

TEST(DoorOptions, OfSweepsAreThoseOfTheProgram) {
  const double one[] = {1.5}, two[] = {0.5, 1.5};
  const cromer::Oscillator oscillator{.damping = 0.2};
  const auto alone = cromer::sweep(oscillator, one), both = cromer::sweep(oscillator, two);
  ASSERT_TRUE(alone && both);
  EXPECT_THAT(alone->frequency, ElementsAre(1.5));
  EXPECT_THAT(both->frequency, ElementsAre(0.5, 1.5));
  EXPECT_EQ(alone->amplitude[0], both->amplitude[1]);
  EXPECT_EQ(cromer::sweep(oscillator, two, {.threads = 1})->amplitude, both->amplitude);
  // Euler-Cromer of step h settles where w^2 is replaced by (2 - 2 cos w h)/h^2 or near it: a coarse step
  // shows.
  const auto coarse = cromer::sweep(oscillator, two, {.step = 0.5});
  ASSERT_TRUE(coarse) << coarse.error().message();
  EXPECT_GT(std::abs(coarse->amplitude[1] / both->amplitude[1] - 1), 0.01);
  const json document = json::parse(cromer::json(*both));
  EXPECT_EQ(document["statuses"], json({"settled", "settled"}));
  EXPECT_EQ(both->status, (std::vector<std::string>{"settled", "settled"}));
  EXPECT_THAT(cromer::json(*both), HasSubstr("0.5"));
}

TEST(DoorOptions, StaticFrictionHoldsWhatKineticWouldNot) {
  const auto ends = [](double static_friction) {
    const auto run = cromer::simulate({.stiffness = 36, .friction = 1, .static_friction = static_friction},
                                      {.method = "rk4", .position = 0.04, .step = 0.01, .until = 1});
    return run ? run->x.back() : unknown;
  };
  EXPECT_EQ(ends(2), 0.04);
  EXPECT_LT(ends(0), 0.03);
  EXPECT_LT(ends(1.2), 0.03);
}

TEST(DoorOptions, OfFitsOfFilesAndArrays) {
  const std::vector<double> t = times(), y = swing();
  const auto in_segments = cromer::fit(t, y, {.law = "viscous", .segment = 4.0});
  ASSERT_TRUE(in_segments) << in_segments.error().message();
  ASSERT_EQ(in_segments->segments.size(), 4u);
  EXPECT_NEAR(in_segments->segments[1].rate.value, 0.05, 1e-9);
  EXPECT_LT(in_segments->segments[0].to, in_segments->segments[1].from + 0.03);
  ASSERT_TRUE(in_segments->decay_rate_mean);
  EXPECT_NEAR(in_segments->decay_rate_mean->value, 0.05, 1e-9);
  EXPECT_NEAR(in_segments->oscillator()->mass, 1, 0);
  EXPECT_NEAR(in_segments->oscillator()->stiffness, 9.0025, 1e-9);
  // At the first sample, and from it on.
  const double from_first[] = {0, 1}, later[] = {1};
  EXPECT_NEAR(in_segments->at(from_first)->x[0], 0.05, 1e-12);
  EXPECT_EQ(in_segments->at(from_first)->size(), 2u);
  EXPECT_NEAR(in_segments->at(later)->x[0], 0.05 * std::exp(-0.05) * std::cos(3), 1e-9);
  EXPECT_EQ(refusal(cromer::LawFit{}.at(later)), of("fit", "fit_is_empty"));
  EXPECT_EQ(refusal(cromer::LawFit{}.motion()), of("fit", "fit_is_empty"));

  const auto recording = cromer::read_file(CROMER_SOURCE_DIR "/tests/cli/transcripts/files/mass1.csv");
  ASSERT_TRUE(recording);
  EXPECT_EQ(refusal(cromer::fit(*recording, {.force = y})), of("force", "force_is_a_column"));
  EXPECT_EQ(refusal(cromer::fit(*recording, {.between_samples = none<cromer::BetweenSamples>})).first,
            "between_samples");
  EXPECT_EQ(refusal(cromer::fit(*recording, {.law = "viscus"})).first, "law");
  EXPECT_EQ(refusal(cromer::fit(cromer::Recording{}, cromer::FitOptions{})),
            of("recording", "recording_is_empty"));
  EXPECT_EQ(cromer::Recording{}.find("x"), nullptr);
  EXPECT_EQ(recording->find("x")->values.size(), 300u);
  EXPECT_EQ(recording->find("z"), nullptr);
  EXPECT_EQ(refusal(cromer::read_file(recording->file, {.rate = -1})).first, "rate");
  EXPECT_EQ(refusal(cromer::read(std::as_bytes(std::span("1,2\n")), "a.csv", {.rate = -1})).first, "rate");
}

cromer::Network cart(std::optional<double> stiffness = 8.0) {
  return {{{.name = "cart", .mass = 2.0, .position = 0.1}},
          {{.to = "cart", .terms = {{"stiffness", stiffness}}}}};
}

TEST(DoorOptions, OfNetworks) {
  const std::vector<double> t = times(), y = swing();
  const cromer::Network wrong{{{.name = "cart", .mass = 2.0}},
                              {{.to = "crat", .terms = {{"stiffness", 8.0}}}}};
  EXPECT_EQ(refusal(cromer::modes(t, {y}, {.network = wrong})).first, "network");
  EXPECT_EQ(refusal(cromer::modes(t, {y}, {.network = cart(cromer::sought)})).first, "network");
  EXPECT_EQ(refusal(cromer::modes("none.csv", {.network = wrong})).first, "network");
  EXPECT_EQ(refusal(cromer::modes(cart(), {.network = wrong})).first, "network");
  EXPECT_EQ(refusal(cromer::fit(t, {y}, wrong)).first, "network");
  EXPECT_EQ(refusal(cromer::fit(cromer::Recording{}, cart(cromer::sought))),
            of("recording", "recording_is_empty"));
  const auto recording = cromer::read_file(CROMER_SOURCE_DIR "/tests/cli/transcripts/files/mass1.csv");
  EXPECT_EQ(refusal(cromer::fit(*recording, wrong)).first, "network");
  EXPECT_EQ(refusal(cromer::fit(*recording, cart(cromer::sought), {.run = 7})), of("network", "in_file"));
  EXPECT_EQ(refusal(cromer::modes(t, {y, std::span(y).first(3)})), of("channels[1]", "lengths_differ"));
  EXPECT_EQ(refusal(cromer::NetworkFit{}.network()), of("fit", "fit_is_empty"));

  // A recording of euler-cromer with the step of its samples: the law behind it is another one.
  const auto run = cromer::simulate(cart(), {.method = "euler-cromer", .step = 0.1, .until = 60});
  const auto as_seen = cromer::modes(run->t, {run->x[0]}),
             of_law = cromer::modes(run->t, {run->x[0]}, {.step = 0.1, .of_method = "euler-cromer"});
  ASSERT_TRUE(of_law) << of_law.error().message();
  const double pi = std::acos(-1);
  EXPECT_NEAR(of_law->modes[0].frequency.value, 1 / pi, 1e-9);
  EXPECT_NEAR(as_seen->modes[0].frequency.value, std::asin(0.1) / 0.1 / pi, 1e-9);

  // Angles are columns of angles.
  const cromer::Network wheel{{{.name = "wheel", .inertia = 2.0, .position = 0.1}},
                              {{.to = "wheel", .terms = {{"stiffness", cromer::sought}}}}};
  const cromer::Network turning{{{.name = "wheel", .inertia = 2.0, .position = 0.1}},
                                {{.to = "wheel", .terms = {{"stiffness", 8.0}}}}};
  const auto turned = cromer::simulate(turning, {.method = "exact", .step = 0.05, .until = 20});
  ASSERT_TRUE(turned) << turned.error().message();
  const auto found = cromer::fit(turned->t, turned->x, wheel);
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_NEAR(found->links[0].parameters[0].estimate.value, 8, 1e-8);
  EXPECT_EQ(found->links[0].parameters[0].unit, "N m");
}

TEST(DoorOptions, LinksOfOneNameAreNumbered) {
  const cromer::Network parallel{
      {{.name = "cart", .mass = 2.0, .position = 0.5}},
      {{.to = "cart", .terms = {{"stiffness", 8.0}}}, {.to = "cart", .terms = {{"stiffness", 4.0}}}}};
  const auto run = cromer::simulate(parallel, {.method = "exact", .step = 1.0, .until = 1});
  ASSERT_TRUE(run) << run.error().message();
  EXPECT_THAT(cromer::csv(*run),
              testing::StartsWith("t (s),cart x (m),cart v (m/s),energy (J),ground-cart energy (J),"
                                  "ground-cart 2 energy (J)\n0,0.5,0,1.5,1,0.5\n1,"));
}

TEST(DoorOptions, ALinkWithoutForceStaysOne) {
  const std::string file = testing::TempDir() + "cromer_loose_link.toml";
  std::ofstream(file) << "[[mass]]\nname = \"a\"\nmass = 1\n[[mass]]\nname = \"b\"\nmass = 1\n"
                         "[[link]]\nto = \"a\"\nstiffness = 3\n[[link]]\nto = \"b\"\nstiffness = 3\n"
                         "[[link]]\nfrom = \"a\"\nto = \"b\"\nstiffness = 0\n";
  const auto network = cromer::read_network(file);
  std::remove(file.c_str());
  ASSERT_TRUE(network) << network.error().message();
  ASSERT_EQ(network->links[2].terms.size(), 1u);
  EXPECT_EQ(network->links[2].terms[0].name, "stiffness");
  EXPECT_EQ(network->links[2].terms[0].value, 0.0);
  EXPECT_EQ(network->links[0].terms.size(), 1u);
  EXPECT_EQ(cromer::modes(*network)->modes.size(), 2u);
}

TEST(DoorDocument, OfNothingIsEmptyInEveryForm) {
  EXPECT_EQ(cromer::json(cromer::LawFit{}), "");
  EXPECT_EQ(cromer::json(cromer::Comparison{}), "");
  EXPECT_EQ(cromer::json(cromer::ResponseSpectrum{}), "");
  EXPECT_EQ(cromer::json(cromer::FrequencyResponse{}), "");
  EXPECT_EQ(cromer::json(cromer::Simulation{}), "");
  EXPECT_EQ(cromer::json(cromer::NetworkFit{}), "");
  EXPECT_EQ(cromer::csv(cromer::Comparison{}), "");
  EXPECT_EQ(cromer::csv(cromer::ResponseSpectrum{}), "");
  EXPECT_EQ(cromer::csv(cromer::Modes{}), "");
  EXPECT_EQ(cromer::csv(cromer::NetworkSimulation{}), "");
  EXPECT_EQ(cromer::csv(cromer::NetworkFit{}), "");
  EXPECT_EQ(cromer::svg(cromer::FrequencyResponse{}), "");
  EXPECT_EQ(cromer::svg(cromer::Simulation{}), "");
  EXPECT_EQ(cromer::svg(cromer::Modes{}), "");
  EXPECT_EQ(cromer::svg(cromer::NetworkSimulation{}), "");
  EXPECT_EQ(cromer::svg(cromer::NetworkFit{}), "");
}

TEST(DoorSpectrum, InterruptedItHasNoCurves) {
  std::vector<double> periods;
  for (int i = 1; i <= 5000; ++i) periods.push_back(0.001 * i);
  const auto spectrum = cromer::response_spectrum(
      swing(), 0.02, {.periods = periods, .progress = [](double) { return false; }});
  ASSERT_TRUE(spectrum) << spectrum.error().message();
  EXPECT_TRUE(spectrum->interrupted);
  EXPECT_TRUE(spectrum->period.empty() && spectrum->displacement.empty());
  EXPECT_GT(spectrum->peak_acceleration, 0);
  EXPECT_EQ(json::parse(cromer::json(*spectrum))["message"], "interrupted");
  EXPECT_EQ(cromer::csv(*spectrum), "");
  EXPECT_EQ(cromer::svg(*spectrum), "");
}

}  // namespace CROMER_FILE
