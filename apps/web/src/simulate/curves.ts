// From runs to what the plots show.
import type { Motion } from '../core/types'
import type { Curve } from '../plot/curve'
import { extentOf } from '../plot/extent'
import { isLinear, referenceOf } from './law'
import type { SimulateState } from './state'

/** Not to be followed by a plot's limits: it grows by the method's fault. */
export function isUnbounded(run: Motion, runs: Motion[], s: SimulateState): boolean {
  if (run.status === 'not_finite' || run.stable === false) return true
  const reference = runs.find((each) => each.method === referenceOf(s))
  if (isLinear(s) || !reference || run === reference) return false
  return extentOf(run.states.x).size > 3 * extentOf(reference.states.x).size
}

export type Pick = (run: Motion) => { x: Float64Array; y: Float64Array }

export const positions: Pick = (run) => ({ x: run.states.t, y: run.states.x })
export const velocities: Pick = (run) => ({ x: run.states.t, y: run.states.v })
export const energies: Pick = (run) => ({ x: run.states.t, y: run.states.energy })
export const phases: Pick = (run) => ({ x: run.states.x, y: run.states.v })

/** x less that of the reference, state by state: both have the same times. */
export function differences(reference: Motion | undefined): Pick {
  return (run) => {
    const count = reference ? Math.min(run.states.x.length, reference.states.x.length) : 0
    const y = new Float64Array(count)
    for (let i = 0; i < count; ++i) y[i] = run.states.x[i]! - reference!.states.x[i]!
    return { x: run.states.t.subarray(0, count), y }
  }
}

/** One for each run the reader asked for. `note`: said of those that leave the plot. */
export function curvesOf(
  runs: Motion[], s: SimulateState, names: Record<string, string>, pick: Pick, note: string, withoutReference = false,
): Curve[] {
  const reference = referenceOf(s)
  const shown = runs.filter(
    ({ method }) => method !== reference || (!withoutReference && (s.methods.includes('exact') || s.methods.includes(reference))),
  )
  return shown.map((run) => {
    const road = run.method === reference && (reference === 'exact' || s.methods.includes('exact'))
    const unbounded = isUnbounded(run, runs, s)
    return { meaning: run.method, name: names[run.method] ?? run.method, road, unbounded, note: unbounded ? note : undefined, ...pick(run) }
  })
}
