// The words of a lab's steps: where its law is hidden, those of working by hand.
import type { StepWords, teach } from '../words/en/teach'
import type { Lab } from './questions'

/// A lab, or the two pendulums, of which nothing is asked.
export type Tour = Lab | 'three'
export const doneKeys = { one: 'doneOne', two: 'doneTwo', three: 'doneThree' } as const

export const stepsOf = (lab: Tour, w: typeof teach, byHand: boolean): StepWords[] =>
  w[lab].map((step) => (byHand && step.byHand ? { ...step, ...step.byHand } : step))
