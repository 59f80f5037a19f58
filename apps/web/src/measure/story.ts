// The sentences that a fit tells, with their numbers.
import type { Fit } from '../core/types'
import { percent, significant, space } from '../look/numbers'
import type { measure } from '../words/en/measure'
import { english, type NoticeObject } from '../words/said'
import { placesOf, rounded, withUncertainty } from './uncertain'

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

/// The pieces that say something: a swing larger than the noise, a rate known to a third.
export const piecesOf = (fit: Fit): Fit['decay_by_amplitude'] =>
  fit.decay_by_amplitude.filter(
    ({ rate, standard_error, amplitude }) =>
      rate !== null && standard_error !== null && amplitude > 3 * (fit.displacement_rms ?? 0) && 3 * standard_error < Math.abs(rate),
  )

/// Whether the decay rate depends on the amplitude by more than what pieces of the recording scatter.
export function rateFalls(fit: Fit): boolean {
  const pieces = piecesOf(fit)
  if (pieces.length < 3) return false
  const [first, last] = [pieces[0]!, pieces.at(-1)!]
  const sigma = Math.hypot(first.standard_error!, last.standard_error!)
  return Math.abs(first.rate! - last.rate!) > 3 * sigma
}

function decay(fit: Fit, words: Words): Sentence[] {
  const pieces = piecesOf(fit)
  if (pieces.length < 3) return []
  const ends = [pieces[0]!, pieces.at(-1)!].map((piece) => piece.law_rate ?? piece.rate!)
  if (rateFalls(fit)) {
    // A law with one rate hides the fall: then the pieces themselves say it.
    const [from, to] = fit.law === 'viscous' ? [pieces[0]!.rate!, pieces.at(-1)!.rate!] : ends
    // A law whose rate goes the other way than the recording's is no law to quote.
    if (from! > to! !== pieces[0]!.rate! > pieces.at(-1)!.rate!) return []
    const text = (from! > to! ? words.story.falls : words.story.rises)(significant(from!, 3), significant(to!, 3))
    return [{ kind: 'note', title: words.story.notEnough, text }]
  }
  const rate = fit.parameters.decay_rate
  if (fit.law !== 'viscous' || !rate || rate.value === null || rate.standard_error === null) return []
  const value = withUncertainty(rate.value, rate.standard_error, '1/s')
  return [{ kind: 'good', title: words.story.enough, text: words.story.enoughWhy(value) }]
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
