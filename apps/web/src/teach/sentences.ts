// What is said of a checked answer.
import { percent, significant } from '../look/numbers'
import type { teach } from '../words/en/teach'
import { chance, type Checked } from './check'
import { units, type Question } from './questions'

type Words = (typeof teach)['check']

export const toneOf = ({ verdict }: Pick<Checked, 'verdict'>): string =>
  ({ right: 'good', tooSmall: 'note', tooLarge: 'note', notYet: 'bad', noUncertainty: 'note', noNumber: 'bad' } as Record<string, string>)[verdict] ?? ''

export const nameOfQuestion = (id: string, w: Words): string => w.questions[id as Question].join('').trim()

/// What went wrong: the slip that it looks like, else how the answer is found.
export const missed = ({ slip }: Checked, id: string, w: Words, byHand: boolean): string => w.slips[slip] ?? (byHand ? w.hintsByHand[id] : undefined) ?? w.hints[id] ?? ''

/// As a part of the right value: "0.3 %".
const asPart = (part: number): string => percent(part, 2).replace('+', '')

export function sentenceOf(checked: Checked, id: string, unit: string, w: Words, byHand: boolean): string {
  const { verdict, off, part, above } = checked
  const mine = significant(off ?? 0, 2)
  switch (verdict) {
    case 'right':
      if (off === null) return w.near(part < 1e-9 ? '' : asPart(part))
      return `${off > chance ? w.beyond : w.within(mine)}${id === 'stiffness' ? ` ${w.massLimits}` : ''}`
    case 'tooSmall': return w.tooSmall[id as keyof Words['tooSmall']]
    case 'tooLarge': return w.tooLarge
    case 'noUncertainty': return w.addUncertainty
    case 'noNumber': return w.noNumber(unit)
    case 'given': return w.given
    case 'empty': return ''
  }
  const far = off === null ? part > 1 : off > 10
  const by = off === null
    ? Number.isFinite(part) && !far ? (above ? w.over : w.under)(asPart(part)) : ''
    : far ? (above ? w.farAbove : w.farBelow) : (above ? w.above : w.below)(mine)
  return `${by} ${missed(checked, id, w, byHand)}`.trim()
}

export const unitOf = (id: string): string => units[id as Question] ?? ''
