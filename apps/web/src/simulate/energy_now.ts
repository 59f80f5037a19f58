// Where the energy of a motion is: in its speed, in the spring, or lost to what damps it.
import type { States } from '../core/types'
import { valueAtX } from '../plot/decimate'

/** [J] done by the force from the start on: the integral of F v dt by Simpson's rule, the velocity amid two states by the
    cubic through both. */
export function workOf({ t, x, v }: Pick<States, 't' | 'x' | 'v'>, force: ((t: number) => number) | null): Float64Array {
  const work = new Float64Array(t.length)
  if (!force) return work
  let before = force(t[0]!) * v[0]!
  for (let i = 1; i < t.length; ++i) {
    const [from, to] = [t[i - 1]!, t[i]!]
    const amid = (1.5 * (x[i]! - x[i - 1]!)) / (to - from) - (v[i - 1]! + v[i]!) / 4
    const after = force(to) * v[i]!
    work[i] = work[i - 1]! + ((to - from) / 6) * (before + 4 * force((from + to) / 2) * amid + after)
    before = after
  }
  return work
}

export interface EnergyNow {
  kinetic: number
  spring: number
  lost: number // since the start; below 0 what a method has added
}

/** [J] What the bars are drawn to: the most that the speed or the spring has in the run, and the most that is lost. */
export interface EnergyScales {
  stored: number
  lost: number
}

/** One scale for all where the spring could hold what is lost. */
export function scalesOf({ v, energy }: Pick<States, 'v' | 'energy'>, work: Float64Array, mass: number): EnergyScales {
  let [stored, lost] = [0, 0]
  for (let i = 0; i < energy.length; ++i) {
    const [total, kinetic] = [energy[i]!, (mass * v[i]! * v[i]!) / 2]
    if (!Number.isFinite(total)) break
    stored = Math.max(stored, kinetic, Math.abs(total - kinetic))
    lost = Math.max(lost, Math.abs(energy[0]! + work[i]! - total))
  }
  return { stored, lost: lost <= stored ? stored : lost }
}

/** [J] at `t`, of states with the work done on them. `smooth`: they are of a motion known between its steps. */
export function energyAt(states: States, work: Float64Array, mass: number, t: number, smooth: boolean): EnergyNow {
  const at = (values: Float64Array) => valueAtX(states.t, values, t, smooth)
  const kinetic = (mass * at(states.v) ** 2) / 2
  const total = at(states.energy)
  return { kinetic, spring: total - kinetic, lost: states.energy[0]! + at(work) - total }
}
