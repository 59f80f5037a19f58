// The sentences that a fit tells, with their numbers.
import type { Fit } from '../core/types'
import { percent, significant, space, withUnit } from '../look/numbers'
import type { measure } from '../words/en/measure'
import { english, type NoticeObject } from '../words/said'
import { placesOf, rounded } from './uncertain'
import { scaleFor } from './units'

export interface Sentence {
  kind: 'note' | 'good' | 'core'
  title: string
  text: string
  notice?: NoticeObject // of the core
}

type Words = typeof measure

/// In the order of their weight; the core's own warnings come last. Of a fit that the core doubts only these.
export function storyOf(fit: Fit, words: Words): Sentence[] {
  const own = isDoubted(fit) ? [] : [...decay(fit, words), ...limits(fit, words), ...flow(fit, words)]
  return [...own, ...warnings(fit, words)]
}

/// Whether something speaks against the law, or against its uncertainties.
export const isDoubted = (fit: Pick<Fit, 'notices'>): boolean => fit.notices.some(({ severity }) => severity === 'wrong_if_ignored')

/// The pieces whose swing is larger than the noise.
const swingingOf = (fit: Fit): Fit['decay_by_amplitude'] =>
  fit.decay_by_amplitude.filter(
    ({ rate, standard_error, amplitude }) => rate !== null && standard_error !== null && standard_error > 0 && amplitude > 3 * (fit.displacement_rms ?? 0),
  )

/// Of those the ones that say something one by one: a rate known to a third.
export const piecesOf = (fit: Fit): Fit['decay_by_amplitude'] => swingingOf(fit).filter(({ rate, standard_error }) => 3 * standard_error! < Math.abs(rate!))

export interface RateChange {
  change: number // [1/s] from the smallest amplitude to the largest
  error: number // its standard error
  isSeen: boolean
  most: number // of 95 %, as a part of the mean rate
  amplitudes: [largest: number, smallest: number]
}

/// The line of weighted least squares through the rates of all pieces; chosen by their rates they would not be a fair sample. Null of fewer than three.
export function rateChange(fit: Fit): RateChange | null {
  const [shown, pieces] = [piecesOf(fit), swingingOf(fit)]
  if (shown.length < 3) return null
  const weights = pieces.map(({ standard_error }) => 1 / standard_error! ** 2)
  const all = weights.reduce((sum, weight) => sum + weight)
  const mean = (of: (piece: (typeof pieces)[0]) => number) => pieces.reduce((sum, piece, i) => sum + weights[i]! * of(piece), 0) / all
  const [amplitude, rate] = [mean((piece) => piece.amplitude), mean((piece) => piece.rate!)]
  const spread = mean((piece) => (piece.amplitude - amplitude) ** 2)
  const slope = mean((piece) => (piece.amplitude - amplitude) * (piece.rate! - rate)) / spread
  const amplitudes: [number, number] = [Math.max(...shown.map((piece) => piece.amplitude)), Math.min(...shown.map((piece) => piece.amplitude))]
  const range = amplitudes[0] - amplitudes[1]
  const [change, error] = [slope * range, range / Math.sqrt(all * spread)]
  // Where the pieces scatter about the line by more than their errors, it is not all that they may hide.
  const scatter = (all * mean((piece) => (piece.rate! - rate - slope * (piece.amplitude - amplitude)) ** 2)) / (pieces.length - 2)
  const most = (Math.abs(change) + 2 * error * Math.sqrt(Math.max(1, scatter))) / Math.abs(rate)
  return { change, error, isSeen: Math.abs(change) > 3 * error, most, amplitudes }
}

function decay(fit: Fit, words: Words): Sentence[] {
  const found = rateChange(fit)
  if (!found) return []
  return found.isSeen ? fall(fit, found, words) : fit.law === 'viscous' ? constancy(fit, found, words) : []
}

/// A law whose rate goes the other way than the recording's is no law to quote. One with one rate hides the change: then the pieces say it.
function fall(fit: Fit, { change }: RateChange, words: Words): Sentence[] {
  const pieces = piecesOf(fit)
  const [from, to] = [pieces[0]!, pieces.at(-1)!].map((piece) => (fit.law === 'viscous' ? null : piece.law_rate) ?? piece.rate!) as [number, number]
  if (from > to !== change > 0) return []
  const text = (from > to ? words.story.falls : words.story.rises)(significant(from, 3), significant(to, 3))
  return [{ kind: 'note', title: words.story.notEnough, text }]
}

function constancy(fit: Fit, { most, amplitudes }: RateChange, words: Words): Sentence[] {
  const { factor, unit } = scaleFor(amplitudes[0], fit.units.displacement)
  const [largest, smallest] = amplitudes.map((amplitude) => withUnit(significant(amplitude * factor, 2), unit)) as [string, string]
  const digit = 10 ** (Math.floor(Math.log10(100 * most)) - 1)
  const bound = withUnit(significant(Math.ceil((100 * most) / digit) * digit, 2), '%')
  return most < 0.1
    ? [{ kind: 'good', title: words.story.enough, text: words.story.enoughWhy(largest, smallest, bound) }]
    : [{ kind: 'note', title: words.story.unseen, text: words.story.unseenWhy(largest, smallest, bound) }]
}

function limits(fit: Fit, words: Words): Sentence[] {
  const mass = fit.stiffness_budget.find((part) => part.quantity === 'mass')
  const stiffness = fit.parameters.stiffness
  if (!mass || mass.share === null || !stiffness || stiffness.standard_error === null) return []
  if (mass.share < 0.5) {
    if (mass.standard_uncertainty === 0 || mass.standard_uncertainty === null) return []
    return [{ kind: 'note', title: words.story.timeLimits, text: words.story.timeLimitsWhy(percent(mass.share).slice(1)) }]
  }
  const uncertainty = `${rounded(stiffness.standard_error, placesOf(stiffness.standard_error))}${space}N/m`
  const rest = 1 - mass.share
  const text =
    rest < 0.001 ? words.story.limitsAll(uncertainty) : words.story.limitsWhy(uncertainty, percent(rest, 2).slice(1))
  const title = words.story.limits('k').join('')
  return [{ kind: 'note', title, text }]
}

function flow(fit: Fit, words: Words): Sentence[] {
  if (!fit.reynolds || fit.reynolds.max < 1000 || !fit.law?.includes('drag')) return []
  const largest = significant(fit.reynolds.max, Math.max(3, Math.ceil(Math.log10(fit.reynolds.max))))
  return [{ kind: 'note', title: words.story.reynolds, text: words.story.reynoldsWhy(largest) }]
}

const warnings = (fit: Fit, words: Words): Sentence[] =>
  fit.notices.map((notice) => ({ kind: 'core', title: words.story.core, text: english(notice.text), notice }))
