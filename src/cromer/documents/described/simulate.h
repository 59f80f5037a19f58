// What the document of `simulate` consists of.
#pragma once

#include <algorithm>
#include <variant>

#include "cromer/analysis/energy.h"
#include "cromer/base/ascii.h"
#include "cromer/documents/described/methods.h"
#include "cromer/model/law_force.h"
#include "cromer/model/terms/term.h"
#include "cromer/tasks/simulate/drive_setup.h"
#include "cromer/tasks/simulate/run_effect.h"
#include "cromer/tasks/simulate/run_energy.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// A run with its options; with or without the kept states.
struct DescribedRun {
  const SimulatedRun& run;
  const SimulateOptions& options;
  bool with_states = false;

  const PulseDrive<double>* pulse() const { return general<PulseDrive<double>>(); }
  const ChirpDrive<double>* chirp() const { return general<ChirpDrive<double>>(); }

 private:
  template <class Drive>
  const Drive* general() const {
    return run.general ? std::get_if<Drive>(&*run.general) : nullptr;
  }
};

/// The coefficients of the law, named as their options.
inline std::vector<Named> coefficients_of_law(const Oscillator<double>& law) {
  std::vector<Named> all;
  for_each_term([&]<class T>() {
    for (std::size_t i = 0; i < coefficients_of<T>; ++i)
      all.push_back({with_underscores(T::coefficients[i].option), law.*T::template members<double>[i],
                     unit_of(T::coefficients[i]), T::coefficients[i].meaning});
  });
  return all;
}

/// The energy that each resistance took, named as its coefficient.
inline std::vector<Named> energies_taken(const EnergyBalance& balance) {
  std::vector<Named> all;
  for_each_resistance([&]<class T>() {
    all.push_back({with_underscores(T::coefficients[0].option), balance.template taken_by<T>(), "J",
                   "taken by this resistance"});
  });
  return all;
}

/// The law, the drive and the start of a run.
struct RunParameters {
  DescribedRun of;
};

template <>
struct Described<RunParameters> {
  using P = RunParameters;
  static constexpr std::string_view name = "Parameters";
  static constexpr auto entries = members(
      field(
          "mass", [](const P& p) { return p.of.run.oscillator.mass; }, "kg", "mass that swings")
          .known(),
      by_name([](const P& p) { return coefficients_of_law(p.of.run.oscillator); },
              [] { return coefficients_of_law({}); }),
      field(
          "hysteresis_exponent", [](const P& p) { return p.of.run.oscillator.hysteresis_exponent; }, "",
          "exponent of the hysteretic force")
          .known(),
      field(
          "static_friction",
          [](const P& p) {
            return std::max(p.of.run.oscillator.friction, p.of.run.oscillator.static_friction);
          },
          "N", "friction that holds the mass at rest")
          .known(),
      field(
          "drive", [](const P& p) { return drive_name(p.of.options); }, "", "kind of the drive"),
      field(
          "drive_amplitude",
          [](const P& p) {
            if (const auto* pulse = p.of.pulse()) return pulse->amplitude;
            if (const auto* chirp = p.of.chirp()) return chirp->amplitude;
            return p.of.run.drive.amplitude;
          },
          "N", "amplitude of the drive")
          .known(),
      field(
          "drive_frequency",
          [](const P& p) {
            const auto* chirp = p.of.chirp();
            return chirp ? chirp->from : p.of.run.drive.frequency;
          },
          "rad/s", "angular frequency of the drive; at the beginning of a chirp")
          .known(),
      field(
          "drive_phase",
          [](const P& p) {
            const auto* chirp = p.of.chirp();
            return chirp ? chirp->phase : p.of.run.drive.phase;
          },
          "rad", "phase of the drive")
          .known(),
      field(
          "drive_to",
          [](const P& p) { return p.of.chirp() ? std::optional(p.of.chirp()->to) : std::nullopt; }, "rad/s",
          "angular frequency at the end of a chirp")
          .left_out(),
      field(
          "drive_start",
          [](const P& p) -> std::optional<double> {
            if (const auto* pulse = p.of.pulse()) return pulse->start;
            if (const auto* chirp = p.of.chirp()) return chirp->start;
            return std::nullopt;
          },
          "s", "beginning of a pulse or a chirp")
          .left_out(),
      field(
          "drive_duration",
          [](const P& p) -> std::optional<double> {
            const auto* pulse = p.of.pulse();
            if (pulse && pulse->shape != PulseShape::step) return pulse->duration;
            return p.of.chirp() ? std::optional(p.of.chirp()->duration) : std::nullopt;
          },
          "s", "duration of a pulse or a chirp; a step has none")
          .left_out(),
      field(
          "unbalance_mass", [](const P& p) { return p.of.options.unbalance_mass; }, "kg",
          "mass of an unbalance")
          .left_out(),
      field(
          "eccentricity",
          [](const P& p) { return p.of.options.unbalance_mass ? p.of.options.eccentricity : std::nullopt; },
          "m", "eccentricity of an unbalance")
          .left_out(),
      field(
          "base_displacement", [](const P& p) { return p.of.options.base_displacement; }, "m",
          "amplitude of a shaking base")
          .left_out(),
      field(
          "drive_file",
          [](const P& p) -> std::optional<std::string> {
            const SimulateOptions& options = p.of.options;
            if (!options.drive_record) return std::nullopt;
            return options.base_motion.empty() ? options.drive_file : options.base_motion;
          },
          "", "file of a recorded drive")
          .left_out(),
      field(
          "between_samples",
          [](const P& p) -> std::optional<std::string> {
            if (!p.of.options.drive_record) return std::nullopt;
            return p.of.options.between_samples.empty() ? "linear" : p.of.options.between_samples;
          },
          "", "interpolation of a recorded drive")
          .left_out(),
      field(
          "position", [](const P& p) { return p.of.run.start.x; }, "m", "position at the start")
          .known(),
      field(
          "velocity", [](const P& p) { return p.of.run.start.v; }, "m/s", "velocity at the start")
          .known());
};

template <>
struct Described<Counts> {
  static constexpr std::string_view name = "Counts";
  static constexpr auto entries =
      members(field("accepted", &Counts::accepted, "", "number of steps taken").called("steps"),
              field("rejected", &Counts::rejected, "", "number of steps rejected by an adaptive method"),
              field("evaluations", &Counts::evaluations, "", "evaluations of the acceleration"),
              field("newton_iterations", &Counts::newton_iterations, "", "Newton iterations over all steps"));
};

template <>
struct Described<Accuracy> {
  static constexpr std::string_view name = "Accuracy";
  static constexpr auto entries =
      members(field("asked", &Accuracy::asked, "", "largest relative error that was asked for").known(),
              field("step", &Accuracy::step, "s", "longest step that keeps to it").known(),
              field("frequency_error", &Accuracy::frequency_error, "",
                    "relative error of the frequency; null if the motion is driven"),
              field("decay_error", &Accuracy::decay_error, "",
                    "relative error of the decay rate; null if the motion is driven or not damped"),
              field("amplitude_error", &Accuracy::amplitude_error, "",
                    "relative error of the steady amplitude, or of the whole motion")
                  .known());
};

template <>
struct Described<EnergyBalance> {
  static constexpr std::string_view name = "EnergyBalance";
  static constexpr auto entries =
      members(field("start", &EnergyBalance::start, "J", "energy stored at the start"),
              field("end", &EnergyBalance::end, "J", "energy stored at the end"),
              field("drive", &EnergyBalance::drive, "J", "work done by the drive, of either sign"),
              by_name(energies_taken, [] { return energies_taken({}); }),
              field("method", &EnergyBalance::method, "J",
                    "energy gained (+) or lost (-) by the error of the method"));
};

template <>
struct Described<ModifiedEnergy> {
  static constexpr std::string_view name = "ModifiedEnergy";
  static constexpr auto entries =
      members(field("start", &ModifiedEnergy::start, "J",
                    "modified energy, which the method conserves, at the start"),
              field("end", &ModifiedEnergy::end, "J", "modified energy at the end"),
              field("drift", &ModifiedEnergy::drift, "", "its largest change, relative to the start"),
              field("states", &ModifiedEnergy::states, "", "number of states that were compared"),
              field("energy_swing", &ModifiedEnergy::energy_swing, "",
                    "swing of the energy itself: half the difference of its extremes over their mean"));
};

template <>
struct Described<MeasuredOscillator> {
  using M = MeasuredOscillator;
  static constexpr std::string_view name = "Measured";
  static constexpr auto entries = members(
      field("angular_frequency", &M::angular_frequency, "rad/s",
            "angular frequency, from the times of the turning points")
          .known(),
      field("decay_rate", &M::decay_rate, "1/s", "decay rate, fitted to the logarithms of the amplitudes")
          .known(),
      field("first_amplitude", &M::first_amplitude, "m", "half the distance of the first two turning points")
          .known(),
      field("last_amplitude", &M::last_amplitude, "m", "half the distance of the last two").known(),
      field("half_cycles", &M::half_cycles, "", "number of half cycles: turning points less one"));
};

/// The transmissibility of the method's own steady motion, and its error.
struct SimulatedTransmission {
  Transmission simulated;
  std::optional<double> error;
};

template <>
struct Described<SimulatedTransmission> {
  using Sent = SimulatedTransmission;
  static constexpr std::string_view name = "SimulatedTransmission";
  static constexpr auto entries = members(
      field(
          "ratio", [](const Sent& s) { return s.simulated.amplitude; }, "", "ratio in the simulated motion"),
      field(
          "phase_lag", [](const Sent& s) { return s.simulated.phase_lag; }, "rad",
          "phase lag in the simulated motion"),
      field("error", &Sent::error, "", "relative error of the ratio"));
};

/// [m] or [N]: a displacement or a force, as the run has it.
inline constexpr std::string_view unit_sent = "m or N";

template <>
struct Described<RunTransmission> {
  using T = RunTransmission;
  static constexpr std::string_view name = "Transmissibility";
  static constexpr auto entries = members(
      field(
          "of", [](const T& t) { return std::string_view(t.of_motion ? "displacement" : "force"); }, "",
          "the transmitted quantity: force or displacement"),
      field("frequency_ratio", &T::frequency_ratio, "", "drive frequency over undamped natural frequency")
          .known(),
      field(
          "ratio", [](const T& t) { return t.exact.amplitude; }, "",
          "transmitted over applied amplitude; null at undamped resonance"),
      field(
          "phase_lag",
          [](const T& t) { return t.bounded() ? std::optional(t.exact.phase_lag) : std::nullopt; }, "rad",
          "phase lag of the transmitted quantity"),
      field("sent", &T::sent, unit_sent, "applied amplitude").known(),
      field(
          "transmitted", [](const T& t) { return t.sent * t.exact.amplitude; }, unit_sent,
          "transmitted amplitude"),
      field(
          "simulated",
          [](const T& t) {
            return t.simulated ? std::optional(SimulatedTransmission{*t.simulated, t.error()}) : std::nullopt;
          },
          "", "the same by the method; null if its motion does not settle or the method is adaptive"));
};

template <>
struct Described<SensorOptions> {
  static constexpr std::string_view name = "Sensor";
  static constexpr auto entries =
      members(field("noise", &SensorOptions::noise, "m", "standard deviation of the noise").known(),
              field("resolution", &SensorOptions::resolution, "m", "resolution; 0: not rounded").known(),
              field("offset", &SensorOptions::offset, "m", "offset, added to the position").known(),
              field("seed", &SensorOptions::seed, "", "seed of the noise"));
};

/// An event, named as it was asked for.
struct DescribedEvent {
  std::string event;
  double t, x, v;
};

template <>
struct Described<DescribedEvent> {
  static constexpr std::string_view name = "FoundEvent";
  static constexpr auto entries =
      members(field("event", &DescribedEvent::event, "", "the event, as it was asked for"),
              field("t", &DescribedEvent::t, "s", "time of the event").known(),
              field("x", &DescribedEvent::x, "m", "position then").known(),
              field("v", &DescribedEvent::v, "m/s", "velocity then").known());
};

inline std::vector<DescribedEvent> events_of(const DescribedRun& r) {
  std::vector<DescribedEvent> all;
  for (const FoundEvent& found : r.run.events.found)
    all.push_back({r.options.event[found.event], found.t, found.y.x, found.y.v});
  return all;
}

/// The kept states, column by column.
struct KeptStates {
  const SimulatedRun& run;
};

template <>
struct Described<KeptStates> {
  static constexpr std::string_view name = "States";
  static constexpr auto entries = members(
      field(
          "t", [](const KeptStates& s) -> const auto& { return s.run.trajectory.t; }, "s", "time"),
      field(
          "x", [](const KeptStates& s) -> const auto& { return s.run.trajectory.x; }, "m", "position"),
      field(
          "v", [](const KeptStates& s) -> const auto& { return s.run.trajectory.v; }, "m/s", "velocity"),
      field(
          "energy", [](const KeptStates& s) { return energies(s.run); }, "J", "kinetic and potential energy"),
      field(
          "sensor",
          [](const KeptStates& s) {
            return s.run.sensor.empty() ? std::nullopt : std::optional(s.run.sensor);
          },
          "m", "readings of the simulated sensor; only with one")
          .left_out());
};

template <>
struct Described<DescribedRun> {
  using R = DescribedRun;
  static constexpr std::string_view name = "Run";
  static constexpr auto effect = [](const R& r) -> const auto& { return r.run.effect; };
  static constexpr auto of_newmark = [](const R& r, double MethodSettings::*setting) {
    return r.run.method == "newmark" ? std::optional(r.run.settings.*setting) : std::nullopt;
  };
  static constexpr auto entries = members(
      field(
          "method", [](const R& r) { return r.run.method; }, "", "name of the method"),
      field(
          "label", [](const R& r) { return r.run.label; }, "", "label that tells this run from the others"),
      field(
          "parameters", [](const R& r) { return RunParameters{r}; }, "", "law, drive and start")
          .unnamed(),
      field(
          "step", [](const R& r) { return r.run.step; }, "s", "step of the method")
          .known(),
      field(
          "until", [](const R& r) { return r.run.until; }, "s", "end of the run")
          .known(),
      field(
          "tolerance", [](const R& r) { return r.run.tolerance; }, "",
          "tolerance, relative to the scale of the motion")
          .known(),
      field(
          "every", [](const R& r) { return r.options.every; }, "", "every n-th state is kept"),
      field(
          "compensated", [](const R& r) { return r.run.compensated; }, "",
          "whether states are compensated sums"),
      field(
          "status", [](const R& r) { return cromer::name(r.run.outcome.status); }, "", "how the run ended"),
      field(
          "message",
          [](const R& r) { return r.run.message.empty() ? std::nullopt : std::optional(r.run.message); }, "",
          "why the run ended early; only then")
          .left_out(),
      field(
          "interrupted", [](const R& r) { return r.run.outcome.interrupted; }, "",
          "whether its user interrupted it"),
      field(
          "last_step",
          [](const R& r) { return r.run.outcome.last_step == 0 ? r.run.step : r.run.outcome.last_step; }, "s",
          "last step; shorter if the steps do not fill the run")
          .known(),
      field(
          "counts", [](const R& r) { return r.run.outcome.counts; }, "", "numbers of steps and evaluations")
          .unnamed(),
      group("final", "the last state",
            members(field(
                        "t", [](const R& r) { return r.run.outcome.t; }, "s", "time")
                        .known(),
                    field(
                        "x", [](const R& r) { return r.run.outcome.y.x; }, "m", "position"),
                    field(
                        "v", [](const R& r) { return r.run.outcome.y.v; }, "m/s", "velocity"),
                    field(
                        "energy", [](const R& r) { return energy(r.run.oscillator, r.run.outcome.y); }, "J",
                        "kinetic and potential energy"))),
      field("events", events_of, "", "events that were asked for, in order of time"),
      field(
          "accuracy", [](const R& r) { return r.run.accuracy; }, "",
          "the step for the accuracy asked for; only then")
          .left_out(),
      field(
          "energy_balance", [](const R& r) { return r.run.energy_balance; }, "",
          "energies: end - start = drive - resistances + method; null if there are too few states"),
      field(
          "modified_energy", [](const R& r) { return r.run.modified_energy; }, "",
          "energy that the method conserves; only if there is one")
          .left_out(),
      field(
          "measured", [](const R& r) { return r.run.measured; }, "",
          "oscillation of the simulated motion; only of a free motion under a law that is not linear")
          .left_out(),
      field(
          "beta", [](const R& r) { return of_newmark(r, &MethodSettings::beta); }, "",
          "beta of newmark; only of this method")
          .left_out(),
      field(
          "gamma", [](const R& r) { return of_newmark(r, &MethodSettings::gamma); }, "",
          "gamma of newmark; only of this method")
          .left_out(),
      field(
          "rho_inf",
          [](const R& r) {
            return r.run.method == "generalized-alpha" ? std::optional(r.run.settings.rho_inf) : std::nullopt;
          },
          "", "rho_inf of generalized-alpha; only of this method")
          .left_out(),
      field(
          "in_words",
          [](const R& r) {
            const Notice words = run_notice(r.run);
            return words.empty() ? std::nullopt : std::optional(words);
          },
          "", "what the method makes of the law, in words")
          .left_out(),
      effect_entries(effect),
      field(
          "transmissibility", [](const R& r) { return r.run.transmission; }, "",
          "transmissibility; only of a driven linear law with a spring")
          .left_out(),
      field(
          "sensor",
          [](const R& r) { return r.options.sensor.used ? std::optional(r.options.sensor) : std::nullopt; },
          "", "the simulated sensor; null without one"),
      field(
          "states",
          [](const R& r) { return r.with_states ? std::optional(KeptStates{r.run}) : std::nullopt; }, "",
          "kept states; only in a file written as JSON")
          .left_out());
};

}  // namespace cromer::core
