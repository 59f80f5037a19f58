// Turning points of a motion: where its velocity changes sign, between the samples by a straight line.
import type { States } from '../core/types'

/** The first after `t` [s]; null where there is none. */
export function turningAfter({ t, v }: Pick<States, 't' | 'v'>, after: number): number | null {
  for (let i = 1; i < t.length; ++i) {
    if (t[i]! <= after || v[i - 1]! === 0 || Math.sign(v[i]!) === Math.sign(v[i - 1]!)) continue
    const at = t[i - 1]! + ((t[i]! - t[i - 1]!) * v[i - 1]!) / (v[i - 1]! - v[i]!)
    if (at > after * (1 + 1e-9) + 1e-12) return at
  }
  return null
}
