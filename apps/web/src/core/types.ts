// What the core answers, task by task: the documents of the program's --json, with long lists of numbers as
// Float64Array. SI units throughout. What may be not finite or unknown is null.

export type Task = 'simulate' | 'motion' | 'effective' | 'resonance' | 'inspect' | 'fit' | 'compare' | 'synthetic' | 'quantity'

/// Options of the program's command without dashes, values as typed: ["step", "20 ms"]. One given several
/// times is a list.
export type Options = ReadonlyArray<readonly [name: string, value: string]>

export interface Documents {
  simulate: Simulation
  motion: Motions
  effective: MethodList
  resonance: Resonance
  inspect: Inspection
  fit: Fits
  compare: Comparisons
  synthetic: { text: string }
  /// Of each option given, in SI units.
  quantity: Record<string, number>
}

/// 0 done; 1 the computation did not succeed and the document says why; 2 bad input.
export type Answer<T extends Task = Task> =
  { status: 0 | 1; document: Documents[T] } | { status: 2; document: Refusal }

export interface Refusal {
  message: string
}

type Numbers = Float64Array
type Maybe = number | null

// simulate

export interface Simulation {
  runs: Run[]
  warnings: string[]
  message?: string
}

/// Of the law without drag, friction and cubic stiffness. What does not exist is 0 (a frequency, the critical
/// damping, the energy's factor of a motion that creeps) or null (what would be divided by 0).
export interface LinearPart {
  natural_frequency: number // [rad/s] undamped
  damped_frequency: number // [rad/s]
  decay_rate: number // [1/s]
  critical_damping: number // [kg/s]
  damping_ratio: Maybe
  quality_factor: Maybe
  resonance_frequency: number // [rad/s]
  energy_factor_per_cycle: number
}

export interface Run {
  method: string
  label: string
  parameters: Parameters
  step: number
  until: number
  tolerance: number
  every: number
  compensated: boolean
  status: RunStatus
  message?: string
  interrupted: boolean
  last_step: number
  counts: { accepted: number; rejected: number; evaluations: number; newton_iterations: number }
  final: { t: number; x: Maybe; v: Maybe; energy: Maybe }
  energy_balance: EnergyBalance | null
  modified_energy?: { start: Maybe; end: Maybe; drift: Maybe; states: number; energy_swing: Maybe }
  measured?: {
    angular_frequency: number
    decay_rate: number
    first_amplitude: number
    last_amplitude: number
    half_cycles: number
  }
  accuracy?: {
    asked: number
    step: number
    frequency_error: Maybe
    decay_error: Maybe
    amplitude_error: number
  }
  /// What the method makes of the law, in one sentence.
  in_words?: string
  effective: Effective | null
  /// These two of linear laws; the limit only where the step is beyond it, null where there is none.
  stable?: boolean
  stability_limit?: Maybe
  energy_factor_per_cycle?: Maybe
  transmissibility?: Transmissibility
  sensor: { noise: number; resolution: number; offset: number; seed: number } | null
  states: States
}

/// What is drawn of runs, much faster than their documents.
export interface Motions {
  runs: Motion[]
  linear_part: LinearPart
  warnings: string[]
}

export interface Motion
  extends Pick<
    Run,
    'method' | 'step' | 'until' | 'status' | 'effective' | 'stable' | 'stability_limit' | 'energy_factor_per_cycle' | 'states'
  > {
  drive_frequency: number
  energy_at_end: Maybe
}

export type RunStatus =
  'reached_end' | 'stopped_by_event' | 'step_limit' | 'step_too_small' | 'no_convergence' | 'not_finite'

export interface Parameters {
  mass: number
  stiffness: number
  damping: number
  drag: number
  friction: number
  cubic: number
  static_friction: number
  drive: string
  drive_amplitude: number
  drive_frequency: number
  drive_phase: number
  unbalance_mass?: number
  eccentricity?: number
  base_displacement?: number
  position: number
  velocity: number
}

export interface States {
  t: Numbers
  x: Numbers
  v: Numbers
  energy: Numbers
  sensor?: Numbers
}

export interface EnergyBalance {
  start: Maybe
  end: Maybe
  drive: Maybe
  damping: Maybe
  drag: Maybe
  friction: Maybe
  method: Maybe
}

export interface Effective {
  decay_rate: Maybe
  angular_frequency: Maybe
  spectral_radius: Maybe
  eigenvalues: [re: number, im: number][]
  steady_state?: { amplitude: Maybe; phase: Maybe }
}

export interface Transmissibility {
  of: 'force' | 'displacement'
  frequency_ratio: number
  ratio: Maybe
  phase_lag: Maybe
  sent: number
  transmitted: Maybe
  simulated: { ratio: Maybe; phase_lag: Maybe; error: Maybe } | null
}

// effective

export interface MethodList {
  methods: Method[]
}

export interface Method {
  name: string
  order: number | null
  implicit: boolean
  symplectic: boolean
  adaptive: boolean
  reversible: boolean
  a_stable: boolean
  source: string
  effective?: Effective
  stable?: boolean
  stability_limit?: Maybe
  energy_factor_per_cycle?: Maybe
  in_words?: string
}

// resonance

/// Asked with the options of simulate and frequencies=FROM:TO:COUNT in rad/s.
export interface Resonance {
  curves: ResonanceCurve[]
}

/// Where `settled` is false the motion grows, never settles or was not tried, and the lists are empty.
export interface ResonanceCurve {
  method: string
  settled: boolean
  /// Why it was not tried: a curve of a law that is not linear is stepped.
  too_many_steps: boolean
  frequency: Numbers
  amplitude: Numbers
  phase: Numbers
}

// inspect

export interface Inspection {
  file: string
  dialect: string
  encoding: string
  separator: string
  decimal: string
  columns: Column[]
  /// The one that is described: that asked for with column=NAME, else what a fit would take, or the first of
  /// several alike.
  column: string | null
  samples: number
  rate: Maybe
  duration: Maybe
  time_column: string | null
  jitter: Maybe
  gaps: { t: number; length: number; run?: number }[]
  outliers: { t: number; value: Maybe; line: number; run?: number }[]
  warnings: string[]
  /// Of that column, one for each run that has it.
  series: InspectedSeries[]
}

/// Missing values are left out, and times rise.
export interface InspectedSeries {
  run: number
  column: string
  observed: string | null
  unit: string // of x; "" where it has no name
  rate: Maybe // [1/s]
  t: Numbers // [s]
  x: Numbers
}

export interface Column {
  name: string
  quantity: string
  unit: string
  run: number
  samples: number
  time_column: string | null
}

// fit

export interface Fits {
  fits: Fit[]
}

export interface Recording {
  file: string
  column: string
  observed: string | null
  run: number
  samples: number
  used: number
  from: Maybe
  to: Maybe
  rate: Maybe
  duration: Maybe
  gaps: number
  outliers: number
}

/// One recording's fit. Of a wrong input only `recording`, `law` (null), `status` and `message` are there.
export interface Fit {
  recording: Recording
  law: string | null
  /// "converged", or why there is no fit.
  status: string
  message?: string
  iterations: number
  between_samples: string | null
  parameters: Record<string, Estimate>
  covariance: { parameters: string[]; matrix: number[][] } | null
  derived: Record<string, Estimate>
  /// The command line that simulates the fitted law.
  simulate: string | null
  residual: { rms: Maybe; normality: Maybe; autocorrelation: Maybe; white: boolean }
  candidates: { law: string; rms: Maybe; bic: Maybe; between_samples?: string }[]
  modes: Mode[]
  held_out?: { from: number; to: number; samples: number; rms: Maybe }
  decay_segments: { from: number; to: number; rate: Maybe; standard_error: Maybe }[]
  decay_rate_mean: Maybe
  decay_rate_mean_standard_error: Maybe
  decay_by_amplitude: {
    amplitude: number
    rate: Maybe
    standard_error: Maybe
    confidence_95: [low: Maybe, high: Maybe]
    law_rate: Maybe
    from: number
    to: number
  }[]
  reynolds: { max: number; standard_error: Maybe; t: number; windows: { t: number; value: number }[] } | null
  keulegan_carpenter: { max: number; standard_error: Maybe; confidence_95: [Maybe, Maybe] } | null
  stiffness_budget: {
    quantity: string
    value: number
    standard_uncertainty: Maybe
    unit: string
    sensitivity: Maybe
    contribution: Maybe
    share: Maybe
  }[]
  monte_carlo: MonteCarlo | null
  plan: RecordingPlan | null
  textbook: Textbook | null
  warnings: string[]
  units: MotionUnits
  /// What the law leaves, in the unit of the displacement.
  displacement_rms: Maybe
  curves: FitCurves | null
}

/// "" where a unit has no name.
export interface MotionUnits {
  measured: string // of the column, and of the residuals
  displacement: string // of x, and of amplitudes
  velocity: string
  energy: string
}

export interface Estimate {
  value: Maybe
  standard_error: Maybe
  confidence_95: [low: Maybe, high: Maybe]
  unit: string
}

export interface Mode {
  angular_frequency: number
  angular_frequency_standard_error: Maybe
  decay_rate: number
  decay_rate_standard_error: Maybe
  amplitude: number
  amplitude_standard_error: Maybe
}

export interface MonteCarlo {
  quantity: string
  trials: number
  seed: number
  mean: number
  standard_deviation: number
  interval_95: [number, number]
  propagated: { value: Maybe; standard_error: Maybe; confidence_95: [Maybe, Maybe] }
  unit: string
}

export interface RecordingPlan {
  quantity: string
  unit: string
  goal: number
  now: number
  met: boolean
  possible: boolean
  duration: Maybe
  best: Maybe
  text: string
}

export interface Textbook {
  logarithmic_decrement: { value: Maybe; standard_error: Maybe; peaks: number; bias: string } | null
  half_power_bandwidth: {
    value: Maybe
    unit: string
    decay_rate: Maybe
    damping_ratio: Maybe
    narrowest: Maybe
    bias: string
  } | null
}

/// One value for each sample used. `measured` is the column, measured less `residual` the fitted law; x and v
/// are the law's displacement from its equilibrium and velocity, `energy` [J] or per mass where none is known.
/// The recording's own velocity and energy follow from its samples alone; empty where it is no displacement, NaN
/// within half a period of its ends.
export interface FitCurves {
  t: Numbers
  measured: Numbers
  residual: Numbers
  x: Numbers
  v: Numbers
  energy: Numbers
  measured_velocity: Numbers
  measured_energy: Numbers
  /// Times [s] of the samples that were set aside as outliers.
  set_aside: Numbers
}

// compare

export interface Comparisons {
  comparisons: Comparison[]
}

export interface Comparison {
  recording: Recording
  status: string
  message?: string
  curves: ComparedCurve[]
  measured_at_rest?: boolean
  explanation?: string
  fit: Omit<Fit, 'curves' | 'units' | 'displacement_rms'>
  warnings: string[]
  /// One for each of `curves`; x is the displacement from the fitted equilibrium, `energy` as of a fit's curves.
  states: { t: Numbers; x: Numbers; v: Numbers; energy: Numbers }[]
}

export interface ComparedCurve {
  label: string
  law: string
  method: string
  rms: Maybe
  r_squared: Maybe
  amplitude_ratio_end: Maybe
  phase_drift: Maybe
  step: number
  law_rms: Maybe
  method_amplitude_ratio: Maybe
  method_phase: Maybe
  diverged: boolean
}
