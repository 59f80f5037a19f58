"""What the verbs take: written by tests/documents/python_options_test.cpp from the tables of options, with
CROMER_WRITE_DESCRIPTIONS=1."""

from __future__ import annotations

from typing import Dict, Sequence, Tuple, TypedDict, Union

from ._types import Grid, Uncertain, Value


class ReadOptions(TypedDict, total=False):
    rate: Value
    time_column: str
    delimiter: str
    decimal: str
    skip_bad_rows: bool


class FitOptions(TypedDict, total=False):
    column: str
    run: int
    from_: Value
    to: Value
    law: str
    no_spring: bool
    hysteresis_exponent: Value
    mass: Uncertain
    spring_mass: Uncertain
    disc_diameter: Uncertain
    temperature: Uncertain
    segment: Value
    segments: int
    force_column: str
    between_samples: str
    drive_frequency: Grid
    hold_out: Value
    goal: str
    monte_carlo: int
    seed: int
    textbook: bool
    rate: Value
    time_column: str
    delimiter: str
    decimal: str
    skip_bad_rows: bool


class SimulateOptions(TypedDict, total=False):
    mass: Value
    stiffness: Value
    damping: Value
    drag: Value
    friction: Value
    static_friction: Value
    cubic: Value
    quadratic: Value
    odd_quadratic: Value
    quintic: Value
    van_der_pol: Value
    hysteresis_stiffness: Value
    hysteresis_beta: Value
    hysteresis_gamma: Value
    hysteresis_exponent: Value
    pendulum: Value
    natural_frequency: Value
    damping_ratio: Value
    quality_factor: Value
    position: Value
    velocity: Value
    drive: str
    drive_amplitude: Value
    drive_frequency: Union[Value, Sequence[Value]]
    drive_phase: Value
    drive_to: Value
    drive_start: Value
    drive_duration: Value
    unbalance_mass: Value
    eccentricity: Value
    base_displacement: Value
    drive_file: str
    base_motion: str
    drive_column: str
    between_samples: str
    rate: Value
    time_column: str
    delimiter: str
    decimal: str
    skip_bad_rows: bool
    step: Value
    until: Value
    tolerance: Value
    accuracy: Value
    event: Union[str, Sequence[str]]
    beta: Value
    gamma: Value
    rho_inf: Value
    every: int
    compensated: bool
    sensor_noise: Value
    sensor_resolution: Value
    sensor_offset: Value
    seed: int


class CompareOptions(TypedDict, total=False):
    column: str
    run: int
    from_: Value
    to: Value
    law: str
    hysteresis_exponent: Value
    mass: Uncertain
    spring_mass: Uncertain
    disc_diameter: Uncertain
    temperature: Uncertain
    segment: Value
    segments: int
    goal: str
    monte_carlo: int
    seed: int
    textbook: bool
    rate: Value
    time_column: str
    delimiter: str
    decimal: str
    skip_bad_rows: bool
    step: Value


class MethodsOptions(TypedDict, total=False):
    natural_frequency: Value
    damping_ratio: Value
    step: Value
    beta: Value
    gamma: Value
    rho_inf: Value
    column: str
    velocity_column: str
    run: int
    mass: Value
    stiffness: Value
    damping: Value
    drag: Value
    friction: Value
    static_friction: Value
    cubic: Value
    quadratic: Value
    odd_quadratic: Value
    quintic: Value
    van_der_pol: Value
    hysteresis_stiffness: Value
    hysteresis_beta: Value
    hysteresis_gamma: Value
    hysteresis_exponent: Value
    pendulum: Value
    quality_factor: Value
    rate: Value
    time_column: str
    delimiter: str
    decimal: str
    skip_bad_rows: bool
    markdown: bool


class ModesOptions(TypedDict, total=False):
    method: Union[str, Sequence[str]]
    step: Value
    beta: Value
    gamma: Value
    rho_inf: Value
    run: int
    from_: Value
    to: Value
    modes: int
    from_frequency: Value
    to_frequency: Value
    of_method: str
    rate: Value
    time_column: str
    delimiter: str
    decimal: str
    skip_bad_rows: bool


class SweepOptions(TypedDict, total=False):
    mass: Grid
    stiffness: Grid
    damping: Grid
    drag: Grid
    friction: Grid
    static_friction: Grid
    cubic: Grid
    quadratic: Grid
    odd_quadratic: Grid
    quintic: Grid
    van_der_pol: Grid
    pendulum: Grid
    natural_frequency: Grid
    damping_ratio: Grid
    quality_factor: Grid
    loss_factor: Grid
    position: Grid
    velocity: Grid
    drive: str
    drive_amplitude: Grid
    drive_frequency: Grid
    drive_phase: Grid
    unbalance_mass: Grid
    eccentricity: Grid
    base_displacement: Grid
    method: Union[str, Sequence[str]]
    step: Grid
    until: Grid
    tolerance: Grid
    beta: str
    gamma: str
    rho_inf: str
    measure: Union[str, Sequence[str]]
    settle: Value
    direction: str
    threads: int
    check: bool


class SpectrumOptions(TypedDict, total=False):
    frequencies: Grid
    damping_ratio: Union[Grid, Sequence[Value]]
    loss_factor: Union[Grid, Sequence[Value]]
    ductility: Union[Grid, Sequence[Value]]
    peaks: str
    between_samples: str
    shock: bool
    shock_response: str
    baseline: str
    band_pass: str
    band_pass_order: int
    causal: bool
    in_g: bool
    column: Union[str, Sequence[str]]
    run: int
    unit: str
    rate: Value
    time_column: str
    delimiter: str
    decimal: str
    skip_bad_rows: bool


#: Of each verb's arguments the type, and in brackets the unit, what it is, and in brackets the default.
ARGUMENTS: Dict[str, Dict[str, Tuple[str, str]]] = {
    "read": {
        "rate": ("Value", "[Hz] samples per second, 1e-6 to 1e12, for files without time [from the time column]"),
        "time_column": ("str", "name of the time column [found]"),
        "delimiter": ("str", "\",\", \";\", tab or blank [found]"),
        "decimal": ("str", "decimal mark, \".\" or \",\" [found]"),
        "skip_bad_rows": ("bool", "leave out rows with a word in a number column [such a row is an error]"),
    },
    "fit": {
        "column": ("str", "column to fit [a position, else angle, angular velocity, velocity, acceleration]"),
        "run": ("int", "which run of the file, from 1; must be positive [all runs]"),
        "from_": ("Value", "[s] first time used [the first sample]"),
        "to": ("Value", "[s] last time used [the last sample]"),
        "law": ("str", "auto, or a sum of viscous, drag, friction, cubic, quadratic, odd-quadratic, quintic, van-der-pol, hysteresis and pendulum (of an angle) [auto]"),
        "no_spring": ("bool", "a body without a spring, under a recorded force [a linear spring]"),
        "hysteresis_exponent": ("Value", "n of a hysteretic law: beta |x'| |z|^(n-1) z, gamma x' |z|^n; must be at least 1 [1]"),
        "mass": ("Uncertain", "[kg] oscillating mass, for the spring constant; \"94.72 g, 55.19 g\": one for each run or recording; must be positive [none]"),
        "spring_mass": ("Uncertain", "[kg] mass of the spring; a third of it is added; must not be negative [0]"),
        "disc_diameter": ("Uncertain", "[m] diameter of a disc, for the Reynolds number; must be positive [none]"),
        "temperature": ("Uncertain", "[K] temperature of the air, for its density and viscosity; must lie between 100 K and 1900 K (for instance \"20 °C\") [20 °C]"),
        "segment": ("Value", "[s] decay rate per segment of this length; must be positive [none]"),
        "segments": ("int", "at most this many segments; without segment, this many equal parts; must be positive [all whole ones]"),
        "force_column": ("str", "column of a recorded force that drives it [the motion is free]"),
        "between_samples": ("str", "what the force did between its samples: linear, hold, band-limited, or auto for what the data prefer [auto]"),
        "drive_frequency": ("Grid", "[rad/s] rough frequency of a harmonic drive, \"1.2 Hz\" (the fit refines it), or auto to find it [the motion is free]"),
        "hold_out": ("Value", "share of the samples, the last ones, to test the law on instead of fitting it to them; must lie between 0 and 1 [none]"),
        "goal": ("str", "how long to record to know a quantity this well, \"decay_rate 0.5 %\" [none]"),
        "monte_carlo": ("int", "check the spring constant's uncertainty by this many trials (1000 to 10000000) [none]"),
        "seed": ("int", "seed of the trials [1]"),
        "textbook": ("bool", "logarithmic decrement from peaks and half-power bandwidth beside the fit [not shown]"),
        "rate": ("Value", "[Hz] samples per second, 1e-6 to 1e12, for files without time [from the time column]"),
        "time_column": ("str", "name of the time column [found]"),
        "delimiter": ("str", "\",\", \";\", tab or blank [found]"),
        "decimal": ("str", "decimal mark, \".\" or \",\" [found]"),
        "skip_bad_rows": ("bool", "leave out rows with a word in a number column [such a row is an error]"),
    },
    "simulate": {
        "mass": ("Value", "[kg] mass m; must be positive [1 kg]"),
        "stiffness": ("Value", "[N/m] spring constant k; negative with a cubic is a double well [1 N/m]"),
        "damping": ("Value", "[kg/s] viscous damping c [0]"),
        "drag": ("Value", "[kg/m] quadratic drag d; must not be negative [0]"),
        "friction": ("Value", "[N] dry friction f while it slides; must not be negative [0]"),
        "static_friction": ("Value", "[N] largest force that dry friction holds at rest, at least friction; must not be negative [as friction]"),
        "cubic": ("Value", "[N/m^3] cubic stiffness k3 [0]"),
        "quadratic": ("Value", "[N/m^2] quadratic stiffness k2 [0]"),
        "odd_quadratic": ("Value", "[N/m^2] odd quadratic stiffness ka, of x|x| [0]"),
        "quintic": ("Value", "[N/m^5] quintic stiffness k5 [0]"),
        "van_der_pol": ("Value", "[kg/(m^2 s)] damping e of x^2 x' [0]"),
        "hysteresis_stiffness": ("Value", "[N/m] stiffness A of the hysteretic force where it begins [0]"),
        "hysteresis_beta": ("Value", "[1/m] how soon the hysteretic force gives way, beta (N^(1-n)/m with an exponent n) [0]"),
        "hysteresis_gamma": ("Value", "[1/m] what sets the shape of its loops, gamma (N^(1-n)/m) [0]"),
        "hysteresis_exponent": ("Value", "how sharply it gives way, n of beta |x'| |z|^(n-1) z + gamma x' |z|^n; must be at least 1 [1]"),
        "pendulum": ("Value", "[N] force p of p sin x, x an angle [0]"),
        "natural_frequency": ("Value", "[rad/s] in place of stiffness: k = m w0^2; must be positive"),
        "damping_ratio": ("Value", "in place of damping: c = 2 zeta sqrt(k m); must not be negative"),
        "quality_factor": ("Value", "in place of damping: c = sqrt(k m) / Q; must be positive"),
        "position": ("Value", "[m] displacement at the start [1 m when nothing else sets the motion going, else 0]"),
        "velocity": ("Value", "[m/s] velocity at the start [0]"),
        "drive": ("str", "harmonic, step, rectangular, half-sine, triangular (pulses), chirp (linear sweep), logarithmic-chirp, unbalance (rotating, m_u e w^2), base (shaking: Y cos(w t + phi), x relative to it) [harmonic]"),
        "drive_amplitude": ("Value", "[N] amplitude F of the driving force, or height of a pulse; must not be negative [0: none]"),
        "drive_frequency": ("Union[Value, Sequence[Value]]", "[rad/s] its angular frequency w, of a chirp at its start; may be given several times; must not be negative [none]"),
        "drive_phase": ("Value", "[rad] its phase phi at t = 0, of a chirp at its start [0]"),
        "drive_to": ("Value", "[rad/s] angular frequency where a chirp ends; must not be negative"),
        "drive_start": ("Value", "[s] when a pulse or chirp begins; must not be negative [0]"),
        "drive_duration": ("Value", "[s] how long a pulse or chirp lasts; must be positive [a chirp: to the end of the run]"),
        "unbalance_mass": ("Value", "[kg] rotating mass m_u, part of mass; must be positive"),
        "eccentricity": ("Value", "[m] its distance e from the axis; must be positive"),
        "base_displacement": ("Value", "[m] amplitude Y of a shaking base; must be positive"),
        "drive_file": ("str", "file with a recorded force: time and force [none]"),
        "base_motion": ("str", "file with the ground's recorded acceleration; x is then relative to the ground [none]"),
        "drive_column": ("str", "column of that file [the force or acceleration]"),
        "between_samples": ("str", "linear, hold, or band-limited (windowed sinc, 16 points for each, then linear) [linear]"),
        "rate": ("Value", "[Hz] samples per second, 1e-6 to 1e12, for files without time [from the time column]"),
        "time_column": ("str", "name of the time column [found]"),
        "delimiter": ("str", "\",\", \";\", tab or blank [found]"),
        "decimal": ("str", "decimal mark, \".\" or \",\" [found]"),
        "skip_bad_rows": ("bool", "leave out rows with a word in a number column [such a row is an error]"),
        "step": ("Value", "[s] time step; of an adaptive method the spacing of its states; must be positive [1/200 of the shorter of natural and drive period (or pulse); of a recorded drive a whole part of its spacing]"),
        "until": ("Value", "[s] end of the run; must be positive [20 natural periods (of the drive where the law has none), at least to the end of a pulse or chirp; the length of a recorded drive]"),
        "tolerance": ("Value", "bound on Newton's last update or on the error of an adaptive method's step, relative to the motion's scale; 1e-15 to 1e-2 [1e-12; adaptive 1e-9]"),
        "accuracy": ("Value", "in place of step: the largest step that keeps frequency, decay and amplitude right to this relative error; 1e-9 to 0.5 (\"0.1 %\")"),
        "event": ("Union[str, Sequence[str]]", "report when it happens: position=VALUE, velocity=VALUE or turning-point, then any of :rising, :falling, :stop; may be given several times [none]"),
        "beta": ("Value", "of newmark: 1/4 average acceleration, 1/6 linear acceleration, 0 central difference; must lie between 0 and 1 [0.25]"),
        "gamma": ("Value", "of newmark: above 1/2 it damps, below it grows; must lie between 0 and 1 [0.5]"),
        "rho_inf": ("Value", "of generalized-alpha: the share of motions far faster than the step that is left after each step; must lie between 0 and 1 [0.8]"),
        "every": ("int", "keep every Nth state; must be positive [1]"),
        "compensated": ("bool", "carry along what the sums of a fixed-step method round off, for runs of millions of steps"),
        "sensor_noise": ("Value", "[m] standard deviation of the noise; must not be negative [0]"),
        "sensor_resolution": ("Value", "[m] rounding step; must not be negative [0: not rounded]"),
        "sensor_offset": ("Value", "[m] reading at x = 0 [0]"),
        "seed": ("int", "seed of the noise; the same seed gives the same samples everywhere [1]"),
    },
    "compare": {
        "column": ("str", "column to compare [a position, else an angle]"),
        "run": ("int", "which run of the file, from 1; must be positive [all runs]"),
        "from_": ("Value", "[s] first time used [the first sample]"),
        "to": ("Value", "[s] last time used [the last sample]"),
        "law": ("str", "auto, or a sum of viscous, drag, friction, cubic, quadratic, odd-quadratic, quintic, van-der-pol, hysteresis and pendulum (of an angle) [auto]"),
        "hysteresis_exponent": ("Value", "n of a hysteretic law: beta |x'| |z|^(n-1) z, gamma x' |z|^n; must be at least 1 [1]"),
        "mass": ("Uncertain", "[kg] oscillating mass, for the spring constant; \"94.72 g, 55.19 g\": one for each run or recording; must be positive [none]"),
        "spring_mass": ("Uncertain", "[kg] mass of the spring; a third of it is added; must not be negative [0]"),
        "disc_diameter": ("Uncertain", "[m] diameter of a disc, for the Reynolds number; must be positive [none]"),
        "temperature": ("Uncertain", "[K] temperature of the air, for its density and viscosity; must lie between 100 K and 1900 K (for instance \"20 °C\") [20 °C]"),
        "segment": ("Value", "[s] decay rate per segment of this length; must be positive [none]"),
        "segments": ("int", "at most this many segments; without segment, this many equal parts; must be positive [all whole ones]"),
        "goal": ("str", "how long to record to know a quantity this well, \"decay_rate 0.5 %\" [none]"),
        "monte_carlo": ("int", "check the spring constant's uncertainty by this many trials (1000 to 10000000) [none]"),
        "seed": ("int", "seed of the trials [1]"),
        "textbook": ("bool", "logarithmic decrement from peaks and half-power bandwidth beside the fit [not shown]"),
        "rate": ("Value", "[Hz] samples per second, 1e-6 to 1e12, for files without time [from the time column]"),
        "time_column": ("str", "name of the time column [found]"),
        "delimiter": ("str", "\",\", \";\", tab or blank [found]"),
        "decimal": ("str", "decimal mark, \".\" or \",\" [found]"),
        "skip_bad_rows": ("bool", "leave out rows with a word in a number column [such a row is an error]"),
        "step": ("Value", "[s] time step; must be positive [the sample spacing, divided to have 200 steps in a period]"),
    },
    "methods": {
        "natural_frequency": ("Value", "[rad/s] natural frequency of the oscillator; must be positive"),
        "damping_ratio": ("Value", "damping ratio of the oscillator; must not be negative [0]"),
        "step": ("Value", "[s] time step; must be positive"),
        "beta": ("Value", "of newmark: 1/4 average acceleration, 1/6 linear acceleration, 0 central difference; must lie between 0 and 1 [0.25]"),
        "gamma": ("Value", "of newmark: above 1/2 it damps, below it grows; must lie between 0 and 1 [0.5]"),
        "rho_inf": ("Value", "of generalized-alpha: the share of motions far faster than the step that is left after each step; must lie between 0 and 1 [0.8]"),
        "column": ("str", "its column of the position [found]"),
        "velocity_column": ("str", "its column of the velocity [found]"),
        "run": ("int", "which of several runs in the file; must be positive [the only one]"),
        "mass": ("Value", "[kg] mass m; must be positive [1 kg]"),
        "stiffness": ("Value", "[N/m] spring constant k; negative with a cubic is a double well [fitted, with the damping, where no law is given]"),
        "damping": ("Value", "[kg/s] viscous damping c [0]"),
        "drag": ("Value", "[kg/m] quadratic drag d; must not be negative [0]"),
        "friction": ("Value", "[N] dry friction f while it slides; must not be negative [0]"),
        "static_friction": ("Value", "[N] largest force that dry friction holds at rest, at least friction; must not be negative [as friction]"),
        "cubic": ("Value", "[N/m^3] cubic stiffness k3 [0]"),
        "quadratic": ("Value", "[N/m^2] quadratic stiffness k2 [0]"),
        "odd_quadratic": ("Value", "[N/m^2] odd quadratic stiffness ka, of x|x| [0]"),
        "quintic": ("Value", "[N/m^5] quintic stiffness k5 [0]"),
        "van_der_pol": ("Value", "[kg/(m^2 s)] damping e of x^2 x' [0]"),
        "hysteresis_stiffness": ("Value", "[N/m] stiffness A of the hysteretic force where it begins [0]"),
        "hysteresis_beta": ("Value", "[1/m] how soon the hysteretic force gives way, beta (N^(1-n)/m with an exponent n) [0]"),
        "hysteresis_gamma": ("Value", "[1/m] what sets the shape of its loops, gamma (N^(1-n)/m) [0]"),
        "hysteresis_exponent": ("Value", "how sharply it gives way, n of beta |x'| |z|^(n-1) z + gamma x' |z|^n; must be at least 1 [1]"),
        "pendulum": ("Value", "[N] force p of p sin x, x an angle [0]"),
        "quality_factor": ("Value", "in place of damping: c = sqrt(k m) / Q; must be positive"),
        "rate": ("Value", "[Hz] samples per second, 1e-6 to 1e12, for files without time [from the time column]"),
        "time_column": ("str", "name of the time column [found]"),
        "delimiter": ("str", "\",\", \";\", tab or blank [found]"),
        "decimal": ("str", "decimal mark, \".\" or \",\" [found]"),
        "skip_bad_rows": ("bool", "leave out rows with a word in a number column [such a row is an error]"),
        "markdown": ("bool", "print the table as docs/methods.md has it"),
    },
    "modes": {
        "method": ("Union[str, Sequence[str]]", "a name from `cromer methods`; may be given several times [none]"),
        "step": ("Value", "[s] time step of the methods; must be positive"),
        "beta": ("Value", "of newmark: 1/4 average acceleration, 1/6 linear acceleration, 0 central difference; must lie between 0 and 1 [0.25]"),
        "gamma": ("Value", "of newmark: above 1/2 it damps, below it grows; must lie between 0 and 1 [0.5]"),
        "rho_inf": ("Value", "of generalized-alpha: the share of motions far faster than the step that is left after each step; must lie between 0 and 1 [0.8]"),
        "run": ("int", "which of several runs in the file; must be positive [the only one]"),
        "from_": ("Value", "[s] first time used [the first sample]"),
        "to": ("Value", "[s] last time used [the last sample]"),
        "modes": ("int", "how many at most: those found at most orders of the model; must be at least 1 [all that are found]"),
        "from_frequency": ("Value", "[rad/s] only modes from this frequency on; must not be negative [0]"),
        "to_frequency": ("Value", "[rad/s] only modes up to this frequency; must be positive [half the rate]"),
        "of_method": ("str", "the recording was simulated by this method with this step: its share is taken out [none]"),
        "rate": ("Value", "[Hz] samples per second, 1e-6 to 1e12, for files without time [from the time column]"),
        "time_column": ("str", "name of the time column [found]"),
        "delimiter": ("str", "\",\", \";\", tab or blank [found]"),
        "decimal": ("str", "decimal mark, \".\" or \",\" [found]"),
        "skip_bad_rows": ("bool", "leave out rows with a word in a number column [such a row is an error]"),
    },
    "sweep": {
        "mass": ("Grid", "[kg] mass m; must be positive [1 kg]"),
        "stiffness": ("Grid", "[N/m] spring constant k; negative with a cubic is a double well [1 N/m]"),
        "damping": ("Grid", "[kg/s] viscous damping c [0]"),
        "drag": ("Grid", "[kg/m] quadratic drag d; must not be negative [0]"),
        "friction": ("Grid", "[N] dry friction f while it slides; must not be negative [0]"),
        "static_friction": ("Grid", "[N] largest force that dry friction holds at rest, at least friction; must not be negative [as friction]"),
        "cubic": ("Grid", "[N/m^3] cubic stiffness k3 [0]"),
        "quadratic": ("Grid", "[N/m^2] quadratic stiffness k2 [0]"),
        "odd_quadratic": ("Grid", "[N/m^2] odd quadratic stiffness ka, of x|x| [0]"),
        "quintic": ("Grid", "[N/m^5] quintic stiffness k5 [0]"),
        "van_der_pol": ("Grid", "[kg/(m^2 s)] damping e of x^2 x' [0]"),
        "pendulum": ("Grid", "[N] force p of p sin x, x an angle [0]"),
        "natural_frequency": ("Grid", "[rad/s] in place of stiffness: k = m w0^2; must be positive"),
        "damping_ratio": ("Grid", "in place of damping: c = 2 zeta sqrt(k m); must not be negative"),
        "quality_factor": ("Grid", "in place of damping: c = sqrt(k m) / Q; must be positive"),
        "loss_factor": ("Grid", "hysteretic damping, a spring k (1 + i eta), instead of a damper; for settled motions only; must not be negative"),
        "position": ("Grid", "[m] displacement at the start [1 m when nothing else sets the motion going, else 0]"),
        "velocity": ("Grid", "[m/s] velocity at the start [0]"),
        "drive": ("str", "harmonic, unbalance (rotating, m_u e w^2) or base (shaking) [harmonic]"),
        "drive_amplitude": ("Grid", "[N] amplitude F of the driving force; must not be negative [0: none]"),
        "drive_frequency": ("Grid", "[rad/s] its angular frequency w; must not be negative [none]"),
        "drive_phase": ("Grid", "[rad] its phase phi at t = 0 [0]"),
        "unbalance_mass": ("Grid", "[kg] rotating mass m_u, part of mass; must be positive"),
        "eccentricity": ("Grid", "[m] its distance e from the axis; must be positive"),
        "base_displacement": ("Grid", "[m] amplitude Y of a shaking base; must be positive"),
        "method": ("Union[str, Sequence[str]]", "a name from `cromer methods` [euler-cromer]"),
        "step": ("Grid", "[s] time step; must be positive [1/200 of the shorter of natural and drive period]"),
        "until": ("Grid", "[s] end of each run; must be positive [20 natural periods, of the drive where the law has none]"),
        "tolerance": ("Grid", "bound on Newton's last update or on the error of an adaptive method's step, relative to the motion's scale; 1e-15 to 1e-2 [1e-12; adaptive 1e-9]"),
        "beta": ("str", "of newmark: 1/4 average acceleration, 1/6 linear acceleration, 0 central difference; must lie between 0 and 1 [0.25]"),
        "gamma": ("str", "of newmark: above 1/2 it damps, below it grows; must lie between 0 and 1 [0.5]"),
        "rho_inf": ("str", "of generalized-alpha: the share of motions far faster than the step that is left after each step; must lie between 0 and 1 [0.8]"),
        "measure": ("Union[str, Sequence[str]]", "amplitude, phase (lag behind the force), peak (largest |x|), mean and rms (of x over whole cycles), energy (likewise, or at the end), final (x and v), transmissibility (the mass's own amplitude over that of the shaking base); several with commas [amplitude,phase of the settled motion; without a drive peak,final,energy]"),
        "settle": ("Value", "cycles of the drive that are dropped; must not be negative [as many as it takes until the changes still to come are below 1e-6]"),
        "direction": ("str", "up, down or both: each point starts where the one before ended, so that jumps show [each point by itself]"),
        "threads": ("int", "how many work at once; must be positive [one for each processor]"),
        "check": ("bool", "where the answer is a closed form, step eight points as well and say how far they differ"),
    },
    "spectrum": {
        "frequencies": ("Grid", "[rad/s] natural frequencies instead of periods, \"1:1000:200:log Hz\""),
        "damping_ratio": ("Union[Grid, Sequence[Value]]", "damping ratios; may be given several times [0.05]"),
        "loss_factor": ("Union[Grid, Sequence[Value]]", "hysteretic damping k (1 + i eta) instead of viscous damping, as a sum of steady states"),
        "ductility": ("Union[Grid, Sequence[Value]]", "inelastic spectrum of springs that yield, of this ductility: SD, PSV and PSA of yielding; may be given several times [elastic springs]"),
        "peaks": ("str", "where the largest values are looked for: continuous (everywhere, after the recording's end too), samples (at the samples alone) or peer (at ten points a period at least, straight lines between samples) [continuous]"),
        "between_samples": ("str", "linear, hold, or band-limited (windowed sinc, 16 points for each, then linear) [linear]"),
        "shock": ("bool", "shock response spectrum (ISO 18431-4): primary, residual, maximax, positive, negative [relative displacement]"),
        "shock_response": ("str", "of which response: absolute-acceleration, relative-velocity, relative-displacement, pseudo-velocity or equivalent-static-acceleration [absolute-acceleration]"),
        "baseline": ("str", "take off the polynomial of least squares: constant, linear, quadratic or cubic [none]"),
        "band_pass": ("str", "Butterworth filter, after the baseline: \"0.1:25 Hz\", or one corner, \"0.1 Hz:\", \":25 Hz\" [none]"),
        "band_pass_order": ("int", "its order, to 12; must be positive [4]"),
        "causal": ("bool", "filter forwards alone [forwards and backwards: no phase shift]"),
        "in_g": ("bool", "write accelerations in g (9.80665 m/s^2) [m/s^2]"),
        "column": ("Union[str, Sequence[str]]", "the acceleration; twice for two components in one file [the only one]"),
        "run": ("int", "which run of the file, from 1; must be positive [the first]"),
        "unit": ("str", "unit of the acceleration where the file gives none: g, m/s^2, cm/s^2 [m/s^2]"),
        "rate": ("Value", "[Hz] samples per second, 1e-6 to 1e12, for files without time [from the time column]"),
        "time_column": ("str", "name of the time column [found]"),
        "delimiter": ("str", "\",\", \";\", tab or blank [found]"),
        "decimal": ("str", "decimal mark, \".\" or \",\" [found]"),
        "skip_bad_rows": ("bool", "leave out rows with a word in a number column [such a row is an error]"),
    },
}
