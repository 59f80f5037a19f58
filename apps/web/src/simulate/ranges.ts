// How far the sliders go. Fields take whatever the core takes.
import type { Scale } from '../controls/scale'
import { criticalDamping, naturalFrequency } from './law'
import type { SimulateState } from './state'

/** The next of 1, 2, 5, 10, ... from `value` on. */
export function roundUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value))
  return Number(([1, 2, 5, 10].find((each) => each * power >= value * (1 - 1e-9))! * power).toPrecision(3))
}

const ratio = (least: number, most: number): Scale => ({ least, most, kind: 'ratio' })
const fine = (most: number): Scale => ({ least: 0, most, kind: 'fine' })
const even = (size: number): Scale => ({ least: -size, most: size, kind: 'even' })

export const ranges = {
  mass: (_: SimulateState) => ratio(0.01, 100),
  stiffness: (_: SimulateState) => ratio(0.1, 200),
  damping: (s: SimulateState) => fine(roundUp(Math.max(1, 1.2 * criticalDamping({ ...s, stiffness: Math.abs(s.stiffness) })))),
  drag: (_: SimulateState) => fine(5),
  friction: (_: SimulateState) => fine(5),
  cubic: (_: SimulateState) => even(50),
  driveAmplitude: (_: SimulateState) => fine(10),
  driveFrequency: (s: SimulateState): Scale => ({ least: 0, most: roundUp(1.6 * (naturalFrequency(s) || 1)), kind: 'even' }),
  position: (_: SimulateState) => even(2),
  velocity: (_: SimulateState) => even(5),
  step: (s: SimulateState) => {
    const least = 10 ** Math.round(Math.log10(0.003 / (naturalFrequency(s) || 1)))
    return ratio(least, 1000 * least)
  },
  until: (s: SimulateState) => {
    const most = roundUp(100 * ((2 * Math.PI) / (naturalFrequency(s) || 1)))
    return ratio(most / 500, most)
  },
}

/** Of the resonance curve [rad/s]: about the natural frequency, and the drive in it. */
export function resonanceRange(s: SimulateState): [from: number, to: number] {
  const middle = naturalFrequency(s) || 1
  const from = Math.min(middle / 3, s.driveFrequency * 0.9)
  return [Math.max(from, middle / 1000), Math.max((middle * 5) / 3, s.driveFrequency * 1.1)]
}
