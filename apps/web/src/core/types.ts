// What the core answers, task by task: the documents of the program's --json, with long lists of numbers as
// Float64Array. SI units throughout. What may be not finite or unknown is null.
import type { Said } from '../words/said'
import type { Comparisons, Fits, Inspection } from './recording_types'
import type { MethodList, Motions, Resonance, Simulation } from './simulation_types'

export type * from './recording_types'
export type * from './simulation_types'

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
  message: Said
}
