// The forces on the mass, as the core gives them: what they are called and how they are drawn.
import { firstFrom, valueAtX } from '../plot/decimate'
import { extentOf } from '../plot/extent'

interface ForceLook {
  symbol: string // of its coefficient, after the F of force
  colour: string // token, of the arrow
  word: string // token, of its name
  dash: number[]
}

/** In the order in which they stand beside the mass. */
export const forceLooks: Record<string, ForceLook> = {
  spring: { symbol: 'k', colour: 'ink', word: 'ink', dash: [] },
  viscous: { symbol: 'c', colour: 'text3', word: 'text3', dash: [] },
  drag: { symbol: 'd', colour: 'text3', word: 'text3', dash: [5, 2] },
  friction: { symbol: 'f', colour: 'text3', word: 'text3', dash: [2, 2] },
  'van-der-pol': { symbol: 'e', colour: 'text3', word: 'text3', dash: [7, 2, 2, 2] },
  drive: { symbol: '', colour: 'line-drive', word: 'word-drive', dash: [] },
}

/** Of the forces on the mass those that are drawn: all, or the drive alone. */
export const drawnOf = (forces: Record<string, Float64Array> = {}, all: boolean): Record<string, Float64Array> =>
  Object.fromEntries(Object.entries(forces).filter(([name]) => all || name === 'drive'))

export interface Force {
  name: string
  value: number // [N] up is positive, as positions are
}

/** Friction jumps where the motion turns. */
function nearest(times: Float64Array, values: Float64Array, t: number): number {
  const i = firstFrom(times, t)
  return values[i > 0 && !(times[i]! - t < t - times[i - 1]!) ? i - 1 : i] ?? NaN
}

/** At `t` [s]. */
export function forcesAt(forces: Record<string, Float64Array>, times: Float64Array, t: number, smooth: boolean): Force[] {
  const shown = Object.keys(forceLooks).filter((name) => name in forces)
  return shown.map((name) => ({ name, value: name === 'friction' ? nearest(times, forces[name]!, t) : valueAtX(times, forces[name]!, t, smooth) }))
}

/** [N] The largest that acts in the run: the arrows' common scale. */
export const largestOf = (forces: Record<string, Float64Array>): number => Math.max(0, ...Object.values(forces).map((each) => extentOf(each).size))
