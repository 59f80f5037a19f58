// What a student expected of a step before it was seen: "3:1" is the second answer of step 3, "3:x" that they went on
// without a guess.
import { labOne } from './lab_one'
import { labTwo } from './lab_two'
import type { Lab } from './questions'

export interface Prediction {
  lab: Lab
  step: number
  guess: number | null // which answer; null: none was given
}

/// Which answer is what happens, of each step that asks.
export const happens = (lab: Lab, step: number): number | undefined => (lab === 'one' ? labOne : labTwo)[step - 1]?.happens
const stepsOf = (lab: Lab): number => (lab === 'one' ? labOne : labTwo).length

export const isPrediction = (text: string): boolean => /^[1-9]:[0-2x]$/.test(text)

/// Of one step; undefined where it was not asked yet.
export function predicted(all: string[], step: number): number | null | undefined {
  const found = all.find((each) => each.startsWith(`${step}:`))?.split(':')[1]
  return found === undefined ? undefined : found === 'x' ? null : Number(found)
}

/// The first step up to `now` whose question is still open: what comes after it would give its answer away.
export function stepToPredict(lab: Lab, all: string[], now: number): number | null {
  for (let step = 1; step <= now; ++step) if (happens(lab, step) !== undefined && predicted(all, step) === undefined) return step
  return null
}

export const predictionsOf = (lab: Lab, all: string[]): Prediction[] =>
  Array.from({ length: stepsOf(lab) }, (_, i) => ({ lab, step: i + 1, guess: predicted(all, i + 1) })).filter(
    (each): each is Prediction => each.guess !== undefined && happens(lab, each.step) !== undefined
  )

/// How many were as it happens, and how many were left out.
export const countOf = (all: Prediction[]) => ({
  asked: all.length,
  right: all.filter(({ lab, step, guess }) => guess !== null && guess === happens(lab, step)).length,
  without: all.filter(({ guess }) => guess === null).length
})
