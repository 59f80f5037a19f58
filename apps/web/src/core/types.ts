// What the core answers, task by task: the documents of the program's --json, with long lists of numbers as
// Float64Array. SI units throughout. What may be not finite or unknown is null.
//
// What they consist of is in documents.ts, which is written from the core's own descriptions; here is what the page
// asks for, and what it draws of runs without a document.
import type { Refusal, Said } from '../words/said'
import type { Comparison, Fit, Inspection, Method, Modes, ResonanceCurve, Run, States } from './documents'
import type { Maybe } from './numbers'

export type * from './documents'

export type Task = 'simulate' | 'motion' | 'effective' | 'resonance' | 'inspect' | 'fit' | 'compare' | 'modes' | 'synthetic' | 'quantity'

/// Options of the program's command without dashes, values as typed: ["step", "20 ms"]. One given several
/// times is a list.
export type Options = ReadonlyArray<readonly [name: string, value: string]>

export interface Fits {
  fits: Fit[]
}

export interface Comparisons {
  comparisons: Comparison[]
}

export interface Simulation {
  runs: (Run & { states: States })[]
  warnings: Said[]
  message?: Said
}

export interface MethodList {
  methods: Method[]
}

/// Asked with the options of simulate and frequencies=FROM:TO:COUNT in rad/s.
export interface Resonance {
  curves: ResonanceCurve[]
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
    'method' | 'step' | 'until' | 'status' | 'effective' | 'stable' | 'stability_limit' | 'energy_factor_per_cycle'
  > {
  states: States
  /// [N] those that act, state by state, of the method that the option "forces" names: spring, viscous, drag, friction,
  /// van-der-pol, drive. Their sum is mass times acceleration.
  forces?: Record<string, Float64Array>
  drive_frequency: number
  energy_at_end: Maybe
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

export interface Documents {
  simulate: Simulation
  motion: Motions
  effective: MethodList
  resonance: Resonance
  inspect: Inspection
  fit: Fits
  compare: Comparisons
  modes: Modes
  synthetic: { text: string }
  /// Of each option given, in SI units.
  quantity: Record<string, number>
}

/// 0 done; 1 the computation did not succeed and the document says why; 2 bad input.
export type Answer<T extends Task = Task> =
  { status: 0 | 1; document: Documents[T] } | { status: 2; document: Refusal }
