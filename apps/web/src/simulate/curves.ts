// From runs to what the plots show.
import type { Motion, States } from '../core/types'
import type { Curve } from '../plot/curve'
import { valueAtX } from '../plot/decimate'
import { extentOf } from '../plot/extent'
import { isLinear, referenceOf } from './law'
import { everyOf } from './options'
import type { SimulateState } from './state'

export interface RunStates extends States {
  x2?: Float64Array // [m] of the second mass, where there is one
}

/** `between`: the states at the steps and between them, of a method that knows those. */
export interface Run extends Motion {
  states: RunStates
  between: RunStates | null
}

/** All that is known of it: also between the steps, where that is. */
export const statesOf = ({ between, states }: Run): RunStates => between ?? states

/** Of a method that knows no more, on the line between two steps; NaN after the end. `x2`: NaN without a second mass. */
export function stateAt(run: Run, t: number): { x: number; v: number; x2: number } {
  const [of, smooth] = [statesOf(run), run.between !== null]
  const at = (values: Float64Array) => valueAtX(of.t, values, t, smooth)
  return { x: at(of.x), v: at(of.v), x2: of.x2 ? at(of.x2) : NaN }
}

/** Not to be followed by a plot's limits: it grows by the method's fault. */
export function isUnbounded(run: Run, runs: Run[], s: SimulateState): boolean {
  if (run.status === 'not_finite' || run.stable === false) return true
  const reference = runs.find((each) => each.method === referenceOf(s))
  if (isLinear(s) || !reference || run === reference) return false
  return extentOf(run.states.x).size > 3 * extentOf(reference.states.x).size
}

export type Pick = (states: RunStates) => { x: Float64Array; y: Float64Array }

export const positions: Pick = ({ t, x }) => ({ x: t, y: x })
/** Of the second mass. */
export const secondPositions: Pick = ({ t, x2 }) => ({ x: t, y: x2 ?? new Float64Array() })
export const velocities: Pick = ({ t, v }) => ({ x: t, y: v })
export const energies: Pick = ({ t, energy }) => ({ x: t, y: energy })
export const phases: Pick = ({ x, v }) => ({ x, y: v })

/** x less that of the reference, state by state: both have the same times. */
export function differences(reference: Run | undefined): Pick {
  return ({ t, x }) => {
    const count = reference ? Math.min(x.length, reference.states.x.length) : 0
    const y = new Float64Array(count)
    for (let i = 0; i < count; ++i) y[i] = x[i]! - reference!.states.x[i]!
    return { x: t.subarray(0, count), y }
  }
}

/** One for each run the reader asked for. `note`: said of those that leave the plot. `compared`: at the steps, with the reference. */
export function curvesOf(
  runs: Run[], s: SimulateState, names: Record<string, string>, pick: Pick, note: string, compared = false,
): Curve[] {
  const reference = referenceOf(s)
  const shown = runs.filter(
    ({ method }) => method !== reference || (!compared && (s.methods.includes('exact') || s.methods.includes(reference))),
  )
  return shown.map((run) => {
    const road = run.method === reference && (reference === 'exact' || s.methods.includes('exact'))
    const unbounded = isUnbounded(run, runs, s)
    const { states } = run
    const between = compared ? null : run.between
    return {
      meaning: run.method, name: names[run.method] ?? run.method, road, unbounded, note: unbounded ? note : undefined, ...pick(between ?? states),
      smooth: between !== null, steps: run.between === null && everyOf(s) === 1,
      data: between && between !== states ? () => pick(states) : undefined,
    }
  })
}
