// What the page itself knows of the law; its numbers come from the core.
import type { LinearPart } from '../core/types'
import type { SimulateState } from './state'
import { allZero, terms } from './terms'

/** With a second mass it is linear. */
export const isLinear = (s: SimulateState): boolean => s.second || allZero(s, terms)
/** The closed form, or what stands in where there is none. */
export const referenceOf = (s: SimulateState): string => (isLinear(s) ? 'exact' : 'dormand-prince')
/** Of the methods that know the motion between their steps: the closed form, and the one with dense output. */
export const isContinuous = (method: string): boolean => method === 'exact' || method === 'dormand-prince'
/** [s]; one where nothing swings. */
export const period = (linear: LinearPart | null): number => (linear?.natural_frequency ? (2 * Math.PI) / linear.natural_frequency : 1)
/** The drive's force [N] at a time [s]; null without one. */
export function driveOf({ driveAmplitude, driveFrequency }: SimulateState): ((t: number) => number) | null {
  return driveAmplitude === 0 ? null : (t) => driveAmplitude * Math.cos(driveFrequency * t)
}
