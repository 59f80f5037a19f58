// Where the energy of a motion is: in its speed, in the spring, or lost to what damps it.
import type { States } from '../core/types'
import { valueAtX } from '../plot/decimate'

/** [J] done by the force from the start on: the integral of F v dt by Simpson's rule, the velocity amid two states by the
    cubic through both. */
export function workOf({ t, x, v }: Pick<States, 't' | 'x' | 'v'>, force: (t: number) => number): Float64Array {
  const work = new Float64Array(t.length)
  for (let i = 1; i < t.length; ++i) {
    const [t0, t1, v0, v1] = [t[i - 1]!, t[i]!, v[i - 1]!, v[i]!]
    const amid = (1.5 * (x[i]! - x[i - 1]!)) / (t1 - t0) - (v0 + v1) / 4
    work[i] = work[i - 1]! + ((t1 - t0) / 6) * (force(t0) * v0 + 4 * force((t0 + t1) / 2) * amid + force(t1) * v1)
  }
  return work
}

export interface EnergyNow {
  kinetic: number
  spring: number
  lost: number // since the start; below 0 what a method has added
}

/** [J] at `t`, of states with the work done on them. `smooth`: they are of a motion known between its steps. */
export function energyAt(states: States, work: Float64Array, mass: number, t: number, smooth: boolean): EnergyNow {
  const at = (values: Float64Array) => valueAtX(states.t, values, t, smooth)
  const kinetic = (mass * at(states.v) ** 2) / 2
  const total = at(states.energy)
  return { kinetic, spring: total - kinetic, lost: states.energy[0]! + at(work) - total }
}
