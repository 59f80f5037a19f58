// The core's documents of recordings, their fits and comparisons. SI units throughout.
import type { Maybe, Numbers } from './numbers'
import type { Said } from '../words/said'

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
  warnings: Said[]
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
  message?: Said
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
  warnings: Said[]
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
  message?: Said
  curves: ComparedCurve[]
  measured_at_rest?: boolean
  explanation?: string
  fit: Omit<Fit, 'curves' | 'units' | 'displacement_rms'>
  warnings: Said[]
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
