// The words of a lab's steps: where its law is hidden, those of working by hand.
import type { StepWords, teach } from '../words/en/teach'
import type { Lab } from './questions'

export const stepsOf = (lab: Lab, w: typeof teach, byHand: boolean): StepWords[] =>
  w[lab].map((step) => (byHand && step.byHand ? { ...step, ...step.byHand } : step))
