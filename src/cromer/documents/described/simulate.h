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

/// A run with the options it was asked for by; with or without the kept states.
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

/// Each coefficient of the law, by the name of its option.
inline std::vector<Named> coefficients_of_law(const Oscillator<double>& law) {
  std::vector<Named> all;
  for_each_term([&]<class T>() {
    for (std::size_t i = 0; i < coefficients_of<T>; ++i)
      all.push_back({with_underscores(T::coefficients[i].option), law.*T::template members<double>[i],
                     unit_of(T::coefficients[i]), T::coefficients[i].meaning});
  });
  return all;
}

/// What each resistance has taken, by the name of its coefficient.
inline std::vector<Named> energies_taken(const EnergyBalance& balance) {
  std::vector<Named> all;
  for_each_resistance([&]<class T>() {
    all.push_back({with_underscores(T::coefficients[0].option), balance.template taken_by<T>(), "J",
                   "taken by this resistance"});
  });
  return all;
}

/// What a run was made with.
struct RunParameters {
  DescribedRun of;
};

template <>
struct Described<RunParameters> {
  using P = RunParameters;
  static constexpr std::string_view name = "Parameters";
  static constexpr auto entries = members(
      field(
          "mass", [](const P& p) { return p.of.run.oscillator.mass; }, "kg", "that swings")
          .known(),
      by_name([](const P& p) { return coefficients_of_law(p.of.run.oscillator); },
              [] { return coefficients_of_law({}); }),
      field(
          "hysteresis_exponent", [](const P& p) { return p.of.run.oscillator.hysteresis_exponent; }, "",
          "of the hysteretic force")
          .known(),
      field(
          "static_friction",
          [](const P& p) {
            return std::max(p.of.run.oscillator.friction, p.of.run.oscillator.static_friction);
          },
          "N", "that holds it at rest")
          .known(),
      field(
          "drive", [](const P& p) { return drive_name(p.of.options); }, "", "its kind"),
      field(
          "drive_amplitude",
          [](const P& p) {
            if (const auto* pulse = p.of.pulse()) return pulse->amplitude;
            if (const auto* chirp = p.of.chirp()) return chirp->amplitude;
            return p.of.run.drive.amplitude;
          },
          "N", "of the drive")
          .known(),
      field(
          "drive_frequency",
          [](const P& p) {
            const auto* chirp = p.of.chirp();
            return chirp ? chirp->from : p.of.run.drive.frequency;
          },
          "rad/s", "of the drive; where a chirp begins")
          .known(),
      field(
          "drive_phase",
          [](const P& p) {
            const auto* chirp = p.of.chirp();
            return chirp ? chirp->phase : p.of.run.drive.phase;
          },
          "rad", "of the drive")
          .known(),
      field(
          "drive_to",
          [](const P& p) { return p.of.chirp() ? std::optional(p.of.chirp()->to) : std::nullopt; }, "rad/s",
          "where a chirp ends")
          .left_out(),
      field(
          "drive_start",
          [](const P& p) -> std::optional<double> {
            if (const auto* pulse = p.of.pulse()) return pulse->start;
            if (const auto* chirp = p.of.chirp()) return chirp->start;
            return std::nullopt;
          },
          "s", "of pulses and chirps")
          .left_out(),
      field(
          "drive_duration",
          [](const P& p) -> std::optional<double> {
            const auto* pulse = p.of.pulse();
            if (pulse && pulse->shape != PulseShape::step) return pulse->duration;
            return p.of.chirp() ? std::optional(p.of.chirp()->duration) : std::nullopt;
          },
          "s", "of pulses and chirps; a step has none")
          .left_out(),
      field(
          "unbalance_mass", [](const P& p) { return p.of.options.unbalance_mass; }, "kg", "of an unbalance")
          .left_out(),
      field(
          "eccentricity",
          [](const P& p) { return p.of.options.unbalance_mass ? p.of.options.eccentricity : std::nullopt; },
          "m", "of an unbalance")
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
          "", "of a recorded drive")
          .left_out(),
      field(
          "between_samples",
          [](const P& p) -> std::optional<std::string> {
            if (!p.of.options.drive_record) return std::nullopt;
            return p.of.options.between_samples.empty() ? "linear" : p.of.options.between_samples;
          },
          "", "how a recorded drive is read")
          .left_out(),
      field(
          "position", [](const P& p) { return p.of.run.start.x; }, "m", "at the start")
          .known(),
      field(
          "velocity", [](const P& p) { return p.of.run.start.v; }, "m/s", "at the start")
          .known());
};

template <>
struct Described<Counts> {
  static constexpr std::string_view name = "Counts";
  static constexpr auto entries =
      members(field("accepted", &Counts::accepted, "", "steps taken").called("steps"),
              field("rejected", &Counts::rejected, "", "steps tried and thrown away, of adaptive methods"),
              field("evaluations", &Counts::evaluations, "", "of the acceleration"),
              field("newton_iterations", &Counts::newton_iterations, "", "over all steps"));
};

template <>
struct Described<Accuracy> {
  static constexpr std::string_view name = "Accuracy";
  static constexpr auto entries =
      members(field("asked", &Accuracy::asked, "", "largest relative error").known(),
              field("step", &Accuracy::step, "s", "that keeps to it").known(),
              field("frequency_error", &Accuracy::frequency_error, "", "null where the motion is driven"),
              field("decay_error", &Accuracy::decay_error, "", "likewise, and where nothing is damped"),
              field("amplitude_error", &Accuracy::amplitude_error, "",
                    "of the steady amplitude, or of the whole motion")
                  .known());
};

template <>
struct Described<EnergyBalance> {
  static constexpr std::string_view name = "EnergyBalance";
  static constexpr auto entries =
      members(field("start", &EnergyBalance::start, "J", "stored at the start"),
              field("end", &EnergyBalance::end, "J", "stored at the end"),
              field("drive", &EnergyBalance::drive, "J", "work done by the drive, either sign"),
              by_name(energies_taken, [] { return energies_taken({}); }),
              field("method", &EnergyBalance::method, "J", "made (+) or lost (-) by the method itself"));
};

template <>
struct Described<ModifiedEnergy> {
  static constexpr std::string_view name = "ModifiedEnergy";
  static constexpr auto entries =
      members(field("start", &ModifiedEnergy::start, "J", "that the method conserves"),
              field("end", &ModifiedEnergy::end, "J", "the same at the end"),
              field("drift", &ModifiedEnergy::drift, "", "the largest change over the start"),
              field("states", &ModifiedEnergy::states, "", "looked at"),
              field("energy_swing", &ModifiedEnergy::energy_swing, "",
                    "of the energy itself: half of what lies between its extremes, over their mean"));
};

template <>
struct Described<MeasuredOscillator> {
  using M = MeasuredOscillator;
  static constexpr std::string_view name = "Measured";
  static constexpr auto entries = members(
      field("angular_frequency", &M::angular_frequency, "rad/s", "half turns over the time they took")
          .known(),
      field("decay_rate", &M::decay_rate, "1/s", "fitted to the logarithm of the amplitudes").known(),
      field("first_amplitude", &M::first_amplitude, "m", "from the first turning point to the second, half")
          .known(),
      field("last_amplitude", &M::last_amplitude, "m", "likewise at the end").known(),
      field("half_cycles", &M::half_cycles, "", "turning points less one"));
};

/// Where the method's own motion settles, and how far that is from the exact one.
struct SimulatedTransmission {
  Transmission simulated;
  std::optional<double> error;
};

template <>
struct Described<SimulatedTransmission> {
  using Sent = SimulatedTransmission;
  static constexpr std::string_view name = "SimulatedTransmission";
  static constexpr auto entries =
      members(field(
                  "ratio", [](const Sent& s) { return s.simulated.amplitude; }, "", "of the method's motion"),
              field(
                  "phase_lag", [](const Sent& s) { return s.simulated.phase_lag; }, "rad", "its lag"),
              field("error", &Sent::error, "", "of the ratio, relative"));
};

/// [m] or [N], as the run has it.
inline constexpr std::string_view unit_sent = "m or N";

template <>
struct Described<RunTransmission> {
  using T = RunTransmission;
  static constexpr std::string_view name = "Transmissibility";
  static constexpr auto entries = members(
      field(
          "of", [](const T& t) { return std::string_view(t.of_motion ? "displacement" : "force"); }, "",
          "what is transmitted: force or displacement"),
      field("frequency_ratio", &T::frequency_ratio, "", "drive over undamped natural frequency").known(),
      field(
          "ratio", [](const T& t) { return t.exact.amplitude; }, "",
          "what comes out over what goes in; null at undamped resonance"),
      field(
          "phase_lag",
          [](const T& t) { return t.bounded() ? std::optional(t.exact.phase_lag) : std::nullopt; }, "rad",
          "of what comes out"),
      field("sent", &T::sent, unit_sent, "amplitude of what goes in").known(),
      field(
          "transmitted", [](const T& t) { return t.sent * t.exact.amplitude; }, unit_sent,
          "amplitude of what comes out"),
      field(
          "simulated",
          [](const T& t) {
            return t.simulated ? std::optional(SimulatedTransmission{*t.simulated, t.error()}) : std::nullopt;
          },
          "", "by the method; null where its motion does not settle, and of adaptive methods"));
};

template <>
struct Described<SensorOptions> {
  static constexpr std::string_view name = "Sensor";
  static constexpr auto entries =
      members(field("noise", &SensorOptions::noise, "m", "standard deviation").known(),
              field("resolution", &SensorOptions::resolution, "m", "0: not rounded").known(),
              field("offset", &SensorOptions::offset, "m", "added to the position").known(),
              field("seed", &SensorOptions::seed, "", "of the noise"));
};

/// An event with the words it was asked for by.
struct DescribedEvent {
  std::string event;
  double t, x, v;
};

template <>
struct Described<DescribedEvent> {
  static constexpr std::string_view name = "FoundEvent";
  static constexpr auto entries = members(field("event", &DescribedEvent::event, "", "as it was asked for"),
                                          field("t", &DescribedEvent::t, "s", "when").known(),
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
          "energy", [](const KeptStates& s) { return energies(s.run); }, "J", "kinetic and potential"),
      field(
          "sensor",
          [](const KeptStates& s) {
            return s.run.sensor.empty() ? std::nullopt : std::optional(s.run.sensor);
          },
          "m", "what a simulated sensor says; only with one")
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
          "method", [](const R& r) { return r.run.method; }, "", "its name"),
      field(
          "label", [](const R& r) { return r.run.label; }, "", "what tells this run from the others"),
      field(
          "parameters", [](const R& r) { return RunParameters{r}; }, "", "what it was made with")
          .unnamed(),
      field(
          "step", [](const R& r) { return r.run.step; }, "s", "of the method")
          .known(),
      field(
          "until", [](const R& r) { return r.run.until; }, "s", "end of the run")
          .known(),
      field(
          "tolerance", [](const R& r) { return r.run.tolerance; }, "", "relative to the motion's scale")
          .known(),
      field(
          "every", [](const R& r) { return r.options.every; }, "", "each of so many states is kept"),
      field(
          "compensated", [](const R& r) { return r.run.compensated; }, "", "states in compensated sums"),
      field(
          "status", [](const R& r) { return cromer::name(r.run.outcome.status); }, "", "how it ended"),
      field(
          "message",
          [](const R& r) { return r.run.message.empty() ? std::nullopt : std::optional(r.run.message); }, "",
          "why it ended early")
          .left_out(),
      field(
          "interrupted", [](const R& r) { return r.run.outcome.interrupted; }, "", "by its user"),
      field(
          "last_step",
          [](const R& r) { return r.run.outcome.last_step == 0 ? r.run.step : r.run.outcome.last_step; }, "s",
          "shorter where the steps do not fill the run")
          .known(),
      field(
          "counts", [](const R& r) { return r.run.outcome.counts; }, "", "what it took")
          .unnamed(),
      group("final", "the last state",
            members(field(
                        "t", [](const R& r) { return r.run.outcome.t; }, "s", "when")
                        .known(),
                    field(
                        "x", [](const R& r) { return r.run.outcome.y.x; }, "m", "position"),
                    field(
                        "v", [](const R& r) { return r.run.outcome.y.v; }, "m/s", "velocity"),
                    field(
                        "energy", [](const R& r) { return energy(r.run.oscillator, r.run.outcome.y); }, "J",
                        "kinetic and potential"))),
      field("events", events_of, "", "that were watched for, in order of time"),
      field(
          "accuracy", [](const R& r) { return r.run.accuracy; }, "", "only where it was asked for")
          .left_out(),
      field(
          "energy_balance", [](const R& r) { return r.run.energy_balance; }, "",
          "end - start = drive - resistances + method; null where the states are too few"),
      field(
          "modified_energy", [](const R& r) { return r.run.modified_energy; }, "",
          "only where the method conserves one")
          .left_out(),
      field(
          "measured", [](const R& r) { return r.run.measured; }, "",
          "only of a free motion under a law that is not linear")
          .left_out(),
      field(
          "beta", [](const R& r) { return of_newmark(r, &MethodSettings::beta); }, "", "only of newmark")
          .left_out(),
      field(
          "gamma", [](const R& r) { return of_newmark(r, &MethodSettings::gamma); }, "", "only of newmark")
          .left_out(),
      field(
          "rho_inf",
          [](const R& r) {
            return r.run.method == "generalized-alpha" ? std::optional(r.run.settings.rho_inf) : std::nullopt;
          },
          "", "only of generalized-alpha")
          .left_out(),
      field(
          "in_words",
          [](const R& r) {
            const Notice words = run_notice(r.run);
            return words.empty() ? std::nullopt : std::optional(words);
          },
          "", "what the method makes of the law")
          .left_out(),
      effect_entries(effect),
      field(
          "transmissibility", [](const R& r) { return r.run.transmission; }, "",
          "only of a driven linear law with a spring")
          .left_out(),
      field(
          "sensor",
          [](const R& r) { return r.options.sensor.used ? std::optional(r.options.sensor) : std::nullopt; },
          "", "the simulated sensor; null without"),
      field(
          "states",
          [](const R& r) { return r.with_states ? std::optional(KeptStates{r.run}) : std::nullopt; }, "",
          "only in a file written as JSON")
          .left_out());
};

}  // namespace cromer::core
