// Lab two: the goals of its steps, on what is open in Measure.
import type { Fit } from '../core/types'
import type { MeasureState } from '../measure/state'
import { numberOf } from '../look/numbers'

export interface Seen {
  open: boolean
  busy: string
  fit: Pick<Fit, 'law' | 'status' | 'reynolds'> | null
  refused: boolean
  measure: MeasureState
  allRight: boolean
}

const near = (text: string, wanted: number) => Math.abs(numberOf(text) - wanted) <= 0.5

export const labTwo: ((seen: Seen) => boolean)[] = [
  ({ open }) => open,
  ({ open, measure, refused }) =>
    open && /\d\s*(±|\+-)\s*[\d.,]*[1-9]/.test(measure.mass) && /\d/.test(measure.disc) && !refused,
  ({ open, measure }) => open && near(measure.from, 30) && near(measure.to, 60),
  ({ fit, busy, measure }) =>
    fit?.status === 'converged' && busy === '' && measure.from === '' && measure.to === '' && measure.law === '',
  ({ fit, measure }) => measure.law === 'viscous' && fit?.law === 'viscous',
  ({ fit }) => fit?.status === 'converged' && (fit.law?.includes('drag') ?? false) && fit.reynolds !== null,
  ({ allRight }) => allRight
]
