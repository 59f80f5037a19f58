// How far the sliders go. Fields take whatever the core takes.
import type { Scale } from '../controls/scale'
import type { LinearPart } from '../core/types'
import { isLinear, period } from './law'
import type { SimulateState } from './state'

type Law = LinearPart | null // null: not known yet

/** The next of 1, 2, 5, 10, ... from `value` on. */
export function roundUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value))
  return Number(([1, 2, 5, 10].find((each) => each * power >= value * (1 - 1e-9))! * power).toPrecision(3))
}

const ratio = (least: number, most: number): Scale => ({ least, most, kind: 'ratio' })
const fine = (most: number): Scale => ({ least: 0, most, kind: 'fine' })
const even = (size: number): Scale => ({ least: -size, most: size, kind: 'even' })

const frequency = (law: Law): number => law?.natural_frequency || 1 // [rad/s]

export const ranges = {
  mass: () => ratio(0.01, 100),
  stiffness: () => ratio(0.1, 200),
  damping: (law: Law) => fine(roundUp(Math.max(1, 1.2 * (law?.critical_damping ?? 0)))),
  drag: () => fine(5),
  friction: () => fine(5),
  cubic: () => even(50),
  quadratic: () => even(20),
  oddQuadratic: () => even(20),
  quintic: () => even(50),
  vanDerPol: () => even(5),
  pendulum: () => even(50),
  driveAmplitude: () => fine(10),
  driveFrequency: (law: Law): Scale => ({ least: 0, most: roundUp(1.6 * frequency(law)), kind: 'even' }),
  position: () => even(2),
  secondMass: () => ratio(0.01, 100),
  secondStiffness: () => ratio(0.1, 200),
  coupling: () => fine(20),
  secondPosition: () => even(2),
  velocity: () => even(5),
  step: (law: Law) => {
    const least = 10 ** Math.round(Math.log10(0.003 / frequency(law)))
    return ratio(least, 1000 * least)
  },
  until: (law: Law) => {
    const most = roundUp(100 * period(law))
    return ratio(most / 500, most)
  },
}

/** Of the resonance curve [rad/s]: about the natural frequency, and the drive in it. The peak of a spring that hardens leans to the right. */
export function resonanceRange(s: SimulateState, law: Law, fastest = law): [from: number, to: number] {
  const middle = frequency(law)
  const from = Math.min(middle / 3, s.driveFrequency * 0.9)
  return [Math.max(from, middle / 1000), Math.max(frequency(fastest) * (isLinear(s) ? 5 / 3 : 2), s.driveFrequency * 1.1)]
}
