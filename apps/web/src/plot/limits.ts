// What a plot shows at first: all of what stays bounded, and a few times that of what does not.
import type { Curve, Limits } from './curve'
import { extentOf } from './extent'
import { roundLimits } from './ticks'

/** How much wider than the bounded curves the frame gets for one that grows. */
const room = 3

/** Least and greatest finite value, of any number of values; null where there is none. */
export function endsOf(...lists: Float64Array[]): Limits | null {
  let from = Infinity
  let to = -Infinity
  for (const values of lists) {
    const { least, most } = extentOf(values)
    from = Math.min(from, least)
    to = Math.max(to, most)
  }
  return from <= to ? [from, to] : null
}

const ends = (curves: Curve[], of: 'x' | 'y'): Limits | null => endsOf(...curves.map((curve) => curve[of]))

/** `zero`: the axis begins there, as energies do. */
export function limitsOf(curves: Curve[], of: 'x' | 'y', zero = false, most = 6, growth = room): Limits {
  const all = ends(curves, of)
  if (!all) return zero ? [0, 1] : [-1, 1]
  const bounded = ends(curves.filter((curve) => !curve.unbounded), of)
  let [from, to] = all
  if (bounded && bounded[1] > bounded[0]) {
    const size = growth * Math.max(Math.abs(bounded[0]), Math.abs(bounded[1]))
    from = Math.max(from, Math.min(bounded[0], -size))
    to = Math.min(to, Math.max(bounded[1], size))
  }
  if (zero) from = Math.min(0, from)
  return roundLimits(from, to, most)
}

export const xEnds = (curves: Curve[]): Limits => ends(curves, 'x') ?? [0, 1]

/** How often limits may change: for the first second of a change they follow, then they hold until it rests. */
export class Hold {
  private began = -Infinity
  private last = -Infinity
  private held: Limits | null = null
  next(wanted: Limits, now: number): Limits {
    if (now - this.last > 700) this.began = now
    this.last = now
    if (!this.held || now - this.began < 1000) this.held = wanted
    return this.held
  }
  rest(wanted: Limits): Limits {
    this.held = wanted
    return wanted
  }
}
