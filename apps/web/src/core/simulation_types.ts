// The core's documents of simulated motions, of methods and of resonance curves. SI units throughout.
import type { Maybe, Numbers } from './numbers'
import type { Said } from '../words/said'

// simulate

export interface Simulation {
  runs: Run[]
  warnings: Said[]
  message?: Said
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
  message?: Said
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
  warnings: Said[]
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
