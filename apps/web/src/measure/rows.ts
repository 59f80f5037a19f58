// The rows of the law's table: which quantities, in which units, with which symbols.
import type { Estimate, Fit } from '../core/types'
import { withUnit } from '../look/numbers'
import type { measure } from '../words/en/measure'
import { grouped, interval, placesOf, rounded, withUncertainty } from './uncertain'
import { scaleFor } from './units'
import { fixed } from '../look/numbers'

export interface Row {
  key: string
  name: string
  symbol: string
  value: string
  interval: string
}

type Words = typeof measure

const withMass = ['stiffness', 'damping', 'drag_constant', 'friction_force', 'cubic_stiffness', 'drag_coefficient']
const withoutMass = ['angular_frequency', 'decay_rate', 'drag', 'friction', 'cubic']

/// A live fit has no Reynolds number.
export function rowsOf(fit: Pick<Fit, 'law' | 'parameters' | 'derived' | 'reynolds'>, words: Words): Row[] {
  const keys = fit.parameters.stiffness ? withMass : withoutMass
  const rows = keys.flatMap((key) => rowOf(key, fit.parameters[key], words))
  rows.push(...rowOf('frequency', fit.derived.frequency, words))
  for (const key of ['drive_frequency', 'drive_amplitude']) rows.push(...rowOf(key, fit.parameters[key], words))
  if (fit.law === 'viscous') rows.push(...rowOf('quality_factor', fit.derived.quality_factor, words))
  if (fit.reynolds) {
    const { max, standard_error, t } = fit.reynolds
    const [name, symbol] = words.quantities.reynolds!
    const value = withUncertainty(max, standard_error)
    rows.push({ key: 'reynolds', name, symbol, value, interval: words.law.at(withUnit(fixed(t, 1), 's')) })
  }
  return rows
}

function rowOf(key: string, estimate: Estimate | undefined, words: Words): Row[] {
  if (!estimate || estimate.value === null) return []
  const { factor, unit } = scaleFor(estimate.value, estimate.unit)
  const [name, symbol] = words.quantities[key] ?? [key.replaceAll('_', ' '), '']
  const uncertainty = estimate.standard_error === null ? null : estimate.standard_error * factor
  const [low, high] = estimate.confidence_95
  const ends = low === null || high === null || uncertainty === null ? '–' : shortest(low * factor, high * factor, words.law.to)
  return [{ key, name, symbol, value: withUncertainty(estimate.value * factor, uncertainty, unit), interval: ends }]
}

/// Where both ends share most of their digits only the last ones of the upper end are written.
function shortest(low: number, high: number, to: string): string {
  const places = placesOf((high - low) / 2)
  if (places < 5) return interval(low, high, to)
  const [a, b] = [rounded(low, places - 1), rounded(high, places - 1)]
  if (firstDifference(a, b) < 4) return `${grouped(a)}\u00a0${to} ${grouped(b)}`
  return `${grouped(a)}\u00a0${to} …${b.slice(firstDifference(a, b) === a.length ? -3 : Math.min(firstDifference(a, b), b.length - 3))}`
}

function firstDifference(a: string, b: string): number {
  let i = 0
  while (i < a.length && a[i] === b[i]) ++i
  return i
}
