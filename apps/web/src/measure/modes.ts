// A mode's numbers as they are read.
import type { Estimate, NaturalMode } from '../core/types'
import { fixed, space } from '../look/numbers'
import { interval, withUncertainty } from './uncertain'

type Part = NaturalMode['shape'][number]

/// "1.00", "−0.52", or "0.52 ∠ 63°" of a part that clearly swings neither with the largest nor against it.
export function partOfShape([re, im]: Part, [, error]: Part = [0, 0]): string {
  if (re === null || im === null) return '–'
  const size = Math.hypot(re, im)
  if (Math.abs(im) <= Math.max(2 * (error ?? 0), 0.15 * size, 0.005)) return fixed(re < -0.005 ? -size : size, 2)
  return `${fixed(size, 2)}${space}∠${space}${fixed((Math.atan2(im, re) * 180) / Math.PI, 0)}°`
}

/// The value with its uncertainty, and the ends of its interval; "–" of what is not known.
export function read({ value, standard_error, confidence_95: [low, high] }: Estimate, scale: number, unit: string, to: string): [value: string, ends: string] {
  if (value === null) return ['–', '']
  const error = standard_error === null ? null : scale * standard_error
  return [withUncertainty(scale * value, error, unit), low === null || high === null || !(high > low) ? '' : interval(scale * low, scale * high, to)]
}
