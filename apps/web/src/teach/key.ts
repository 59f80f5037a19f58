// The answers that a recording has, found by the core on the same motion recorded almost without noise.
import type { Answer, Fits, Comparisons, Options, Task } from '../core/types'
import { massText, discText, recordingOptions, type Truth } from './truth'

export const questions = ['frequency', 'stiffness', 'rate', 'reynolds', 'off'] as const
export type Question = (typeof questions)[number]
/// What each is asked for in.
export const units: Record<Question, string> = { frequency: 'Hz', stiffness: 'N/m', rate: '1/s', reynolds: '', off: '%' }

/// What is right, in the unit asked for, and what a common slip gives in its place.
export interface Expected {
  value: number
  unit: string
  /// Its sign is not asked for.
  unsigned?: boolean
  /// The uncertainty that a careful evaluation cannot do without, and the largest that still says something.
  least: number
  most: number
  slips: { name: string; value: number }[]
}

export type Key = Record<Question, Expected>

export type AskCore = <T extends Task>(
  task: T,
  options: Options,
  asking?: { file?: Uint8Array; fileName?: string }
) => Promise<Answer<T> | null>

const quiet = 1e-5 // [m] noise: a thirtieth of the students' own

/// Null where the core could not be asked.
export async function keyOf(truth: Truth, ask: AskCore): Promise<Key | null> {
  const made = await ask('synthetic', recordingOptions(truth, quiet))
  if (!made || made.status !== 0) return null
  const asking = { file: new TextEncoder().encode(made.document.text), fileName: 'truth.csv' }
  const fit = async (options: Options) => {
    const answer = await ask('fit', options, asking)
    const found = answer && answer.status !== 2 ? (answer.document as Fits).fits[0]! : null
    return found?.status === 'converged' ? found : null
  }
  const whole = await fit([
    ['law', 'viscous+drag'],
    ['mass', massText(truth)],
    ['disc-diameter', discText(truth)]
  ])
  const middle = await fit([['law', 'viscous'], ['from', '30'], ['to', '60']])
  const early = await fit([['law', 'viscous'], ['from', '0'], ['to', '30']])
  const all = await fit([['law', 'viscous']])
  const compared = await ask('compare', [['law', 'viscous+drag']], asking)
  if (!whole || !middle || !early || !all || !compared || compared.status === 2) return null
  const constant = (compared.document as Comparisons).comparisons[0]!.curves[0]!
  const frequency = whole.derived.frequency?.value
  const reynolds = whole.reynolds?.max
  if (!frequency || !reynolds || constant.amplitude_ratio_end === null) return null
  const rate = (each: typeof whole) => each.parameters.decay_rate!.value! // of a fit that converged
  const off = Math.abs(constant.amplitude_ratio_end - 1) * 100
  const massShare = truth.massUncertainty / truth.massRead
  return {
    frequency: {
      value: frequency,
      unit: units.frequency,
      least: 3e-7 * frequency,
      most: 0.01 * frequency,
      slips: [
        { name: 'angular', value: 2 * Math.PI * frequency },
        { name: 'period', value: 1 / frequency }
      ]
    },
    stiffness: {
      value: truth.stiffness,
      unit: units.stiffness,
      least: 0.8 * massShare * truth.stiffness,
      most: 0.03 * truth.stiffness,
      slips: [
        { name: 'grams', value: truth.stiffness * 1000 },
        { name: 'hertz', value: truth.stiffness / (4 * Math.PI ** 2) }
      ]
    },
    rate: {
      value: rate(middle),
      unit: units.rate,
      least: 0.003 * rate(middle),
      most: 0.3 * rate(middle),
      slips: [
        { name: 'first', value: rate(early) },
        { name: 'whole', value: rate(all) },
        { name: 'viscousOnly', value: rate(whole) },
        { name: 'perCycle', value: rate(middle) / frequency }
      ]
    },
    reynolds: {
      value: reynolds,
      unit: units.reynolds,
      least: 0.001 * reynolds,
      most: 0.15 * reynolds,
      slips: [
        { name: 'radius', value: reynolds / 2 },
        { name: 'centimetres', value: reynolds * 100 },
        { name: 'thousands', value: reynolds / 1000 }
      ]
    },
    off: {
      value: off,
      unit: units.off,
      unsigned: true,
      least: 0.05,
      most: off / 2,
      slips: [
        { name: 'fraction', value: off / 100 },
        { name: 'ratio', value: 100 - off }
      ]
    }
  }
}
