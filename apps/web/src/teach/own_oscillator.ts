// A student's own oscillator of lab one: driven, damped, and stepped by a method.
import { hashOf, numbersOf } from './seed'

/// SI units.
export interface Oscillator {
  mass: number // [kg]
  stiffness: number // [N/m]
  damping: number // [kg/s]
  force: number // [N] amplitude of the drive
  step: number // [s]
}

/// Of a seed of seed.ts: 0.5 to 2 kg on 5 to 20 N/m, a damping ratio of 0.02 to 0.05, and a step of a hundredth of a period.
export function oscillatorOf(seed: number): Oscillator {
  const next = numbersOf(hashOf(`lab one\n${seed}`))
  const between = (low: number, high: number) => low + (high - low) * next()
  const mass = Math.round(between(5, 20)) / 10
  const stiffness = Math.round(between(5, 20))
  const damping = Number((2 * between(0.02, 0.05) * Math.sqrt(stiffness * mass)).toPrecision(2))
  const force = Math.round(between(5, 20)) / 10
  const step = Math.round((1000 * between(0.05, 0.08)) / Math.sqrt(stiffness / mass)) / 1000
  return { mass, stiffness, damping, force, step }
}
