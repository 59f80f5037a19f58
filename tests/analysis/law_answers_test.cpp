// What is computed of many laws that were made by chance: swings, energies, responses, and what methods make
// of them.
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/analysis/effective_oscillator.h"
#include "cromer/analysis/energy.h"
#include "cromer/analysis/energy_balance.h"
#include "cromer/analysis/exact_energy_balance.h"
#include "cromer/analysis/forces.h"
#include "cromer/analysis/frequency_response.h"
#include "cromer/analysis/local_error.h"
#include "cromer/analysis/phase.h"
#include "cromer/analysis/response_filter.h"
#include "cromer/analysis/swing.h"
#include "cromer/base/pi.h"
#include "cromer/methods/all.h"
#include "tests/support/answers.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr unsigned laws = 60;

Oscillator<double> some_law(Chance& chance) {
  Oscillator<double> law{.mass = 1, .stiffness = chance.between(5, 40), .damping = chance.between(0, 2)};
  if (chance.is(0.4)) law.drag = chance.between(0, 1);
  if (chance.is(0.4)) law.friction = chance.between(0, 1);
  if (chance.is(0.4)) law.cubic = chance.between(-8, 20);
  if (chance.is(0.3)) law.quadratic = chance.between(-8, 8);
  if (chance.is(0.3)) law.odd_quadratic = chance.between(-4, 9);
  if (chance.is(0.3)) law.quintic = chance.between(0, 10);
  if (chance.is(0.3)) law.van_der_pol = chance.between(0, 2);
  if (chance.is(0.2)) {
    law.stiffness = 0;
    law.pendulum = chance.between(5, 40);
  }
  return law;
}

TEST(LawAnswers, OfSwings) {
  Answers said("analysis/law_swings");
  for (unsigned seed = 1; seed <= laws; ++seed) {
    Chance chance(seed);
    const Oscillator<double> law = some_law(chance);
    const Swing<double> swing{law};
    const double a = chance.between(0.05, 1.4), x = chance.between(-1, 1), v = chance.between(-9, 9);
    said << static_cast<int>(seed) << swing.potential(x) << swing.pull(x) << swing.stiffness()
         << swing.amplitude(x, v) << swing.amplitude(x, 0.1 * v) << swing.angular_frequency(a)
         << swing.middle(a) << swing.is_bent();
    const double w = std::sqrt(swing.stiffness());
    const CycleDecay<double> decay{w, law};
    said << decay.rate(a) << decay.equivalent_rate(a);
    for_each_term([&]<class T>() {
      if constexpr (!HasInnerState<T>) {
        const CycleAverage<double> average = cycle_average<T>(a, w);
        said << average.fall << average.shift;
      }
    });
    const State<double> y{x, v};
    said << energy(law, y) << modified_energy(law, 0.1, y);
    for (const State<double>& at : {y, State<double>{x, 0}}) {
      const Forces forces = forces_on(law, law_of(law), chance.between(-3, 3), at);
      said << forces.spring << forces.drive << forces.sum() << forces.resistance.sum();
    }
    said.end_line();
  }
  said.expect_as_before();
}

TEST(LawAnswers, OfEnergies) {
  Answers said("analysis/law_energies");
  for (unsigned seed = 1; seed <= laws; ++seed) {
    Chance chance(seed);
    const Oscillator<double> law = some_law(chance);
    const double w = chance.between(2, 6), h = chance.between(0.02, 0.2), amplitude = chance.between(0, 3),
                 falls = chance.between(-0.1, 0.5);
    const auto states = static_cast<int>(chance.between(1, 30));
    const auto force = [&](double t) { return amplitude * std::cos(2 * t); };
    const auto motion = [&](double t) {
      const double size = std::exp(-falls * t);
      return State<double>{size * std::cos(w * t), -size * (falls * std::cos(w * t) + w * std::sin(w * t))};
    };
    EnergyLedger ledger(force, law, h);
    for (int i = 0; i < states; ++i) ledger(h * i, motion(h * i));
    if (chance.is(0.4)) ledger(h * (states - 0.4), motion(h * (states - 0.4)));
    for (const EnergyBalance& balance :
         {ledger.balance(), exact_energy_balance(force, law, motion, h * states, 0.7)}) {
      said << balance.start << balance.end << balance.drive << balance.taken.sum() << balance.method();
      said << balance.taken_by<Viscous>() << balance.taken_by<Friction>();
    }
    Drift drift;
    std::vector<double> x, v;
    for (int i = 0; i < states; ++i) {
      drift(energy(law, motion(h * i)));
      x.push_back(motion(h * i).x);
      v.push_back(motion(h * i).v);
    }
    said << drift.largest() << followed_phase(x, v, w).back();
    said.end_line();
  }
  said.expect_as_before();
}

TEST(LawAnswers, OfResponses) {
  Answers said("analysis/law_responses");
  for (unsigned seed = 1; seed <= laws; ++seed) {
    Chance chance(seed);
    const Oscillator<double> law{.mass = chance.between(0.5, 2),
                                 .stiffness = chance.between(1, 40),
                                 .damping = chance.is(0.7) ? chance.between(0, 2) : chance.between(0, 30)};
    const double w = chance.between(0.2, 12), loss = chance.between(0, 1), f = chance.between(0.1, 3);
    const SteadyState steady = frequency_response(law, f, w),
                      hysteretic = hysteretic_response(law, loss, f, w);
    said << static_cast<int>(seed) << steady.amplitude << steady.phase_lag << hysteretic.amplitude
         << hysteretic.phase_lag << resonance_frequency(law);
    const SteadyState velocity{w * steady.amplitude, steady.phase_lag - pi / 2};
    for (const Transmission& each : {transmissibility(law, w), transmitted_motion(f, steady),
                                     transmitted_force(law, f, steady, velocity)})
      said << each.amplitude << each.phase_lag;
    const LinearLaw<double> linear = linear_law(law);
    const ResponseQuantity<double> quantity{1, chance.between(-1, 1)};
    for (const bool hold : {false, true}) {
      const IntervalMap<double> map = interval_map(linear, chance.between(0.02, 0.5), hold);
      const ResponseFilter<double> filter = response_filter(map, quantity);
      FilterState<double> y = at_rest(map, f);
      said << y.u << y.d;
      for (int i = 0; i < 4; ++i) said << filter.gain * filter.step(y, chance.between(-1, 1));
      const State<double> next = filter_to_motion(map).next(y, map, 0.3);
      said << next.x << next.v;
    }
    said.end_line();
  }
  said.expect_as_before();
}

TEST(LawAnswers, OfMethods) {
  Answers said("analysis/law_methods");
  for (const MethodInfo& info : method_infos) {
    if (info.is_adaptive() || info.is_exact()) continue;
    for (unsigned seed = 1; seed <= 6; ++seed) {
      Chance chance(seed);
      const double w = chance.between(1, 6), h = chance.between(0.01, 1.2) / w;
      const LinearLaw<double> law{.decay_rate = chance.between(0, seed % 3 == 0 ? 2 : 0.3) * w,
                                  .stiffness = w * w,
                                  .drive_amplitude = 1,
                                  .drive_frequency = chance.between(0.3, 2) * w};
      said << std::string(info.name) << static_cast<int>(seed);
      visit_method(info.name, {}, [&](const auto& method) {
        const EffectiveOscillator found = effective_oscillator(method, law, h);
        said << found.spectral_radius << found.decay_rate.value_or(0) << found.angular_frequency.value_or(0)
             << found.energy_factor().value_or(0) << found.stable();
        for (const auto& z : found.eigenvalues) said << z.re << std::abs(z.im);
        if (found.steady_state) said << found.steady_state->amplitude << found.steady_state->phase_lag;
        if (found.steady_velocity)
          said << found.steady_velocity->amplitude << found.steady_velocity->phase_lag;
        if (const auto steady = method_steady_state(method, law, h))
          said << steady->position.amplitude << steady->position.phase_lag << steady->velocity;
        if (seed == 1) said << stability_limit(method, law).value_or(-1);
        return true;
      });
      said.end_line();
    }
  }
  said.expect_as_before();
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
