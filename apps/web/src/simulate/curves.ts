// From runs to what the plots show.
import type { Run } from '../core/types'
import type { Curve } from '../plot/curve'
import { isLinear, referenceOf } from './law'
import type { SimulateState } from './state'

const largest = (values: Float64Array): number => {
  let most = 0
  for (const value of values) if (Math.abs(value) > most) most = Math.abs(value)
  return most
}

/** Not to be followed by a plot's limits: it grows by the method's fault. */
export function isUnbounded(run: Run, runs: Run[], s: SimulateState): boolean {
  if (run.status === 'not_finite' || run.stable === false) return true
  const reference = runs.find((each) => each.method === referenceOf(s))
  if (isLinear(s) || !reference || run === reference) return false
  return largest(run.states.x) > 3 * largest(reference.states.x)
}

export type Pick = (run: Run) => { x: Float64Array; y: Float64Array }

export const positions: Pick = (run) => ({ x: run.states.t, y: run.states.x })
export const velocities: Pick = (run) => ({ x: run.states.t, y: run.states.v })
export const energies: Pick = (run) => ({ x: run.states.t, y: run.states.energy })
export const phases: Pick = (run) => ({ x: run.states.x, y: run.states.v })

/** x less that of the reference, state by state: both have the same times. */
export function differences(reference: Run | undefined): Pick {
  return (run) => {
    const count = reference ? Math.min(run.states.x.length, reference.states.x.length) : 0
    const y = new Float64Array(count)
    for (let i = 0; i < count; ++i) y[i] = run.states.x[i]! - reference!.states.x[i]!
    return { x: run.states.t.subarray(0, count), y }
  }
}

/** One for each run the reader asked for. `note`: said of those that leave the plot. */
export function curvesOf(
  runs: Run[], s: SimulateState, names: Record<string, string>, pick: Pick, note: string, withoutReference = false,
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
