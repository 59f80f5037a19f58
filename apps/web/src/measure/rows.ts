// The rows of the law's table: which quantities, in which units, with which symbols.
import type { Estimate, Fit } from '../core/types'
import { significant, withUnit } from '../look/numbers'
import type { measure } from '../words/en/measure'
import { interval, placesOf, withUncertainty } from './uncertain'
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

/// Where a mass would give forces and none is given. An angle's is a moment of inertia.
export const wantsMass = (fit: Pick<Fit, 'parameters' | 'units'>, mass: string): boolean =>
  fit.units.displacement === 'm' && mass.trim() === '' && !fit.parameters.stiffness

/// A live fit has no Reynolds number.
export function rowsOf(fit: Pick<Fit, 'law' | 'coefficients' | 'parameters' | 'derived' | 'reynolds'>, words: Words): Row[] {
  const row = (key: string, estimate: Estimate | undefined) => rowOf(key, estimate, words)
  // Beside other terms the swing dies down at another rate.
  const named = (key: string) => (key === 'decay_rate' && fit.law !== 'viscous' ? 'viscous_part' : key)
  const rows = fit.coefficients.flatMap((key) => row(key, fit.parameters[key]).map((each) => ({ ...each, name: words.quantities[named(key)]?.[0] ?? each.name })))
  rows.push(...row('frequency', fit.derived.frequency))
  for (const key of ['drive_frequency', 'drive_amplitude']) rows.push(...row(key, fit.parameters[key]))
  if (fit.law === 'viscous') rows.push(...qualityOf(fit.derived.quality_factor, words, row('quality_factor', fit.derived.quality_factor)))
  if (fit.reynolds) {
    const { max, standard_error, t } = fit.reynolds
    const [name, symbol] = words.quantities.reynolds!
    const value = withUncertainty(max, standard_error)
    rows.push({ key: 'reynolds', name, symbol, value, interval: words.law.at(withUnit(fixed(t, 1), 's')) })
  }
  return rows
}

/// Where the damping may be none the quality factor has a lower end alone.
function qualityOf(quality: Estimate | undefined, words: Words, rows: Row[]): Row[] {
  const [least, most] = quality?.confidence_95 ?? [null, null]
  if (least === null || most !== null) return rows
  return rows.map((each) => ({ ...each, value: words.law.above(significant(least, 2)), interval: '–' }))
}

/// Half an interval for its digits. One end may be cut where the quantity ends; and one that reaches far may not take
/// the other beyond the value.
function halfOf(low: number, value: number, high: number): number {
  const longer = Math.max(high - value, value - low), shorter = Math.min(high - value, value - low)
  const unit = 10 ** -placesOf(longer)
  const beyond = Math.round(low / unit) * unit > value || Math.round(high / unit) * unit < value
  return beyond && shorter > 0 ? shorter : longer
}

function rowOf(key: string, estimate: Estimate | undefined, words: Words): Row[] {
  if (!estimate || estimate.value === null) return []
  const { factor, unit } = scaleFor(estimate.value, estimate.unit)
  const [name, symbol] = words.quantities[key] ?? [key.replaceAll('_', ' '), '']
  const uncertainty = estimate.standard_error === null ? null : estimate.standard_error * factor
  const [low, high] = estimate.confidence_95
  const ends = low === null || high === null || uncertainty === null ? '–' : interval(low * factor, high * factor, words.law.to, halfOf(low * factor, estimate.value * factor, high * factor))
  return [{ key, name, symbol, value: withUncertainty(estimate.value * factor, uncertainty, unit), interval: ends }]
}
