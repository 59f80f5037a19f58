// What the sliders and buttons need to know of the law at once. What a method makes of it comes from the core.
import type { SimulateState } from './state'

/** Undamped angular frequency [rad/s]; 0 where the spring does not pull back. */
export const naturalFrequency = (s: SimulateState): number => Math.sqrt(Math.max(0, s.stiffness / s.mass))
/** Decay rate gamma [1/s]. */
export const decayRate = (s: SimulateState): number => s.damping / (2 * s.mass)
export const criticalDamping = (s: SimulateState): number => 2 * Math.sqrt(Math.max(0, s.stiffness * s.mass))
export const qualityFactor = (s: SimulateState): number => criticalDamping(s) / 2 / s.damping
export const dampingRatio = (s: SimulateState): number => s.damping / criticalDamping(s)

/** Where the steady amplitude is greatest [rad/s]; 0 where damping leaves no peak. */
export function resonance(s: SimulateState): number {
  const square = naturalFrequency(s) ** 2 - 2 * decayRate(s) ** 2
  return square > 0 ? Math.sqrt(square) : 0
}

export const isLinear = (s: SimulateState): boolean => s.drag === 0 && s.friction === 0 && s.cubic === 0
/** The closed form, or what stands in where there is none. */
export const referenceOf = (s: SimulateState): string => (isLinear(s) ? 'exact' : 'dormand-prince')
/** [s]; one where nothing swings. */
export const period = (s: SimulateState): number => (naturalFrequency(s) > 0 ? (2 * Math.PI) / naturalFrequency(s) : 1)
/** The drive's force at `t` [N]. */
export const driveForce = (s: SimulateState, t: number): number => s.driveAmplitude * Math.cos(s.driveFrequency * t)
