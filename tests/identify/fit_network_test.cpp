// Values of links from records whose truth is known.
#include "cromer/identify/network/fit_network.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cromer/methods/rk4.h"
#include "cromer/model/linear_network.h"
#include "cromer/model/network_system.h"
#include "cromer/model/sensor.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace {

using Columns = std::vector<std::vector<double>>;

struct Made {
  std::vector<double> t;
  Columns y;

  NetworkRecord record() const {
    NetworkRecord record{t, {}};
    for (const auto& column : y) record.y.emplace_back(column);
    return record;
  }
};

/// Free swings of the network by a fine Runge-Kutta, seen by sensors with an offset and noise.
Made made(const Network& network, std::size_t samples, double step, double noise, std::uint64_t seed) {
  Made record;
  record.y.resize(network.masses.size());
  const NetworkSystem<> system(network);
  const Rk4 method;
  NoMemory none;
  NormalDeviates normal(seed);
  State<MassVector> y = start_of(network);
  constexpr int parts = 40;
  for (std::size_t n = 0; n < samples; ++n) {
    const double t = static_cast<double>(n) * step;
    record.t.push_back(t);
    for (std::size_t i = 0; i < record.y.size(); ++i)
      record.y[i].push_back(y.x.first[i] + 0.01 * static_cast<double>(i + 1) + noise * normal.next());
    for (int k = 0; k < parts; ++k) y = method.step(system, t + k * step / parts, step / parts, y, none).y;
  }
  return record;
}

Network pendulums(double cubic = 0) {
  Network network{.angles = true};
  network.masses = {{.name = "left", .mass = 0.05, .start = {0.12, 0}}, {.name = "right", .mass = 0.05}};
  network.links = {{ground, 0, {.stiffness = 0.981, .damping = 6e-4, .cubic = cubic}},
                   {ground, 1, {.stiffness = 0.992, .damping = 8e-4}},
                   {0, 1, {.stiffness = 0.031}}};
  return network;
}

const std::vector<SoughtValue> springs_and_dampers{{0, &Oscillator<double>::stiffness, false},
                                                   {1, &Oscillator<double>::stiffness, false},
                                                   {2, &Oscillator<double>::stiffness, false},
                                                   {0, &Oscillator<double>::damping, true},
                                                   {1, &Oscillator<double>::damping, true}};

double value(const Network& network, const SoughtValue& sought) {
  return network.links[sought.link].law.*sought.member;
}

Network without(Network network, const std::vector<SoughtValue>& sought) {
  for (const SoughtValue& each : sought) network.links[each.link].law.*each.member = 0;
  return network;
}

TEST(FitNetwork, FindsSpringsAndDampersOfCoupledPendulums) {
  const Network truth = pendulums();
  const Made data = made(truth, 3000, 0.02, 5e-4, 4);
  const NetworkFit fit = fit_network(without(truth, springs_and_dampers), springs_and_dampers, data.record());
  EXPECT_EQ(fit.status, FitStatus::converged);
  ASSERT_EQ(fit.values.size(), springs_and_dampers.size());
  for (std::size_t j = 0; j < fit.values.size(); ++j) {
    const double true_value = value(truth, springs_and_dampers[j]);
    EXPECT_NEAR(fit.values[j].value, true_value, 4 * fit.values[j].standard_error) << j;
    EXPECT_LT(fit.values[j].standard_error, (j < 3 ? 1e-3 : 3e-2) * true_value) << j;
  }
  EXPECT_NEAR(fit.columns[0].offset.value, 0.01, 1e-4);
  EXPECT_NEAR(fit.columns[1].offset.value, 0.02, 1e-4);
  EXPECT_NEAR(fit.columns[0].rms, 5e-4, 5e-5);
}

TEST(FitNetwork, IntervalsHoldTheTruthAsOftenAsTheySay) {
  const Network truth = pendulums();
  int inside = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Made data = made(truth, 800, 0.05, 2e-3, seed);
    const NetworkFit fit =
        fit_network(without(truth, springs_and_dampers), springs_and_dampers, data.record());
    ASSERT_EQ(fit.status, FitStatus::converged) << seed;
    for (std::size_t j = 0; j < fit.values.size(); ++j, ++all)
      inside += fit.values[j].low <= value(truth, springs_and_dampers[j]) &&
                value(truth, springs_and_dampers[j]) <= fit.values[j].high;
  }
  EXPECT_NEAR(inside / static_cast<double>(all), 0.95, 0.04);
}

TEST(FitNetwork, SamplesMayBeMissing) {
  const Network truth = pendulums();
  Made data = made(truth, 2000, 0.02, 5e-4, 6);
  for (std::size_t n = 0; n < 2000; n += 41) data.y[1][n] = std::nan("");
  for (auto* values : {&data.t, &data.y[0], &data.y[1]})
    values->erase(values->begin() + 700, values->begin() + 760);
  const NetworkFit fit = fit_network(without(truth, springs_and_dampers), springs_and_dampers, data.record());
  EXPECT_EQ(fit.status, FitStatus::converged);
  for (std::size_t j = 0; j < fit.values.size(); ++j)
    EXPECT_NEAR(fit.values[j].value, value(truth, springs_and_dampers[j]), 4 * fit.values[j].standard_error);
}

TEST(FitNetwork, FindsABentSpring) {
  const Network truth = pendulums(-9);
  std::vector<SoughtValue> sought = springs_and_dampers;
  sought.push_back({0, &Oscillator<double>::cubic, false});
  const Made data = made(truth, 2000, 0.02, 5e-4, 9);
  const NetworkFit fit = fit_network(without(truth, sought), sought, data.record());
  EXPECT_EQ(fit.status, FitStatus::converged);
  for (std::size_t j = 0; j < fit.values.size(); ++j)
    EXPECT_NEAR(fit.values[j].value, value(truth, sought[j]), 4 * fit.values[j].standard_error) << j;
  EXPECT_LT(fit.values.back().standard_error, 0.2);
}

TEST(FitNetwork, SaysWhatTheRecordDoesNotTell) {
  // Two links side by side: their sum alone is known.
  Network truth = pendulums();
  truth.links.push_back({0, 1, {.stiffness = 0.01}});
  const std::vector<SoughtValue> sought{{0, &Oscillator<double>::stiffness, false},
                                        {2, &Oscillator<double>::stiffness, false},
                                        {3, &Oscillator<double>::stiffness, false}};
  const Made data = made(truth, 1500, 0.02, 5e-4, 2);
  const NetworkFit fit = fit_network(without(truth, sought), sought, data.record());
  EXPECT_EQ(fit.status, FitStatus::undetermined);
  EXPECT_EQ(fit.undetermined, (std::vector<std::size_t>{1, 2}));
  EXPECT_NEAR(fit.values[0].value, 0.981, 4 * fit.values[0].standard_error);
  EXPECT_TRUE(std::isnan(fit.values[1].standard_error));
}

TEST(FitNetwork, RefusesAShortAndADeadRecord) {
  const Network truth = pendulums();
  const Made data = made(truth, 60, 0.02, 5e-4, 2);
  EXPECT_EQ(fit_network(truth, springs_and_dampers, data.record()).status, FitStatus::too_short);
  Made dead = made(truth, 1000, 0.02, 5e-4, 2);
  dead.y[1].assign(1000, 0.5);
  EXPECT_EQ(fit_network(truth, springs_and_dampers, dead.record()).status, FitStatus::no_oscillation);
}

}  // namespace
}  // namespace cromer::core
