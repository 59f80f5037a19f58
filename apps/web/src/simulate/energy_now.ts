// Where the energy of a motion is: in its speed, in the spring, or lost to what damps it.
import type { States } from '../core/types'
import { valueAtX } from '../plot/decimate'

/** [J] done by the force F cos(wt) from the start on. */
export function workOf({ t, x }: Pick<States, 't' | 'x'>, force: (t: number) => number): Float64Array {
  const work = new Float64Array(t.length)
  for (let i = 1; i < t.length; ++i) work[i] = work[i - 1]! + ((force(t[i]!) + force(t[i - 1]!)) / 2) * (x[i]! - x[i - 1]!)
  return work
}

export interface EnergyNow {
  kinetic: number
  spring: number
  lost: number // since the start; below 0 what a method has added
}

/** [J] at `t`, of states with the work done on them. */
export function energyAt(states: States, work: Float64Array, mass: number, t: number): EnergyNow {
  const at = (values: Float64Array) => valueAtX(states.t, values, t)
  const kinetic = (mass * at(states.v) ** 2) / 2
  const total = at(states.energy)
  return { kinetic, spring: total - kinetic, lost: states.energy[0]! + at(work) - total }
}
