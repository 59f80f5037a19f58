// Lab two: the goals of its steps, on what is open in Measure. Where the law is hidden its work is done by hand.
import type { Fit } from '../core/types'
import type { MeasureState } from '../measure/state'
import { near, numberOf } from '../look/numbers'
import type { QuestionTwo } from './questions'

export interface Seen {
  open: boolean
  busy: string
  fit: Pick<Fit, 'law' | 'status' | 'reynolds'> | null
  refused: boolean
  measure: MeasureState
  allRight: boolean
  answered: (question: QuestionTwo) => boolean
}

export interface StepTwo {
  reached: (seen: Seen) => boolean
  byHand?: (seen: Seen) => boolean
  happens?: number // which answer of its prediction, in a recording of the lab
}

const about = (text: string, wanted: number) => near(numberOf(text), wanted, 0.5) // [s]
const isPart = ({ measure }: Seen) => about(measure.from, 30) && about(measure.to, 60)

export const labTwo: StepTwo[] = [
  { reached: ({ open }) => open },
  { reached: ({ open, measure, refused }) => open && /\d\s*(±|\+-)\s*[\d.,]*[1-9]/.test(measure.mass) && /\d/.test(measure.disc) && !refused },
  {
    reached: (seen) => seen.open && isPart(seen),
    byHand: (seen) => seen.open && seen.answered('rate'),
    happens: 1
  },
  {
    reached: ({ fit, busy, measure }) => fit?.status === 'converged' && busy === '' && measure.from === '' && measure.to === '' && measure.law === '',
    byHand: ({ open, answered }) => open && answered('frequency') && answered('stiffness'),
    happens: 1
  },
  {
    reached: ({ fit, measure }) => measure.law === 'viscous' && fit?.law === 'viscous',
    byHand: ({ open, measure }) => open && about(measure.from, 90) && measure.to === '',
    happens: 1
  },
  {
    reached: ({ fit }) => fit?.status === 'converged' && (fit.law?.includes('drag') ?? false) && fit.reynolds !== null,
    byHand: ({ open, answered }) => open && answered('reynolds'),
    happens: 2
  },
  { reached: ({ allRight }) => allRight }
]
