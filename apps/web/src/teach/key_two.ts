// The answers of lab two: those that a recording has, found by the core on the same motion recorded almost without noise; and what it
// finds in the recording itself, which is right too.
import type { Comparisons, Fit, Fits, Options } from '../core/types'
import { airViscosity } from './air'
import { questionsOf, slipsOf, units, type AskCore, type Expected, type QuestionTwo } from './questions'
import { massText, discText, recordingOptions, type Truth } from './truth'

const quiet = 1e-5 // [m] noise: a thirtieth of the students' own

/// A recording of `truth`, to be fitted; null where the core could not be asked.
async function recorded(truth: Truth, ask: AskCore, noise?: number) {
  const made = await ask('synthetic', recordingOptions(truth, noise))
  if (!made || made.status !== 0) return null
  const asking = { file: new TextEncoder().encode(made.document.text), fileName: 'truth.csv' }
  const fit = async (options: Options): Promise<Fit | null> => {
    const answer = await ask('fit', options, asking)
    const first = answer && answer.status !== 2 ? (answer.document as Fits).fits[0]! : null
    return first?.status === 'converged' ? first : null
  }
  const compare = async (options: Options) => {
    const answer = await ask('compare', options, asking)
    return answer && answer.status !== 2 ? (answer.document as Comparisons).comparisons[0]!.curves : null
  }
  return { fit, compare }
}
type Recorded = NonNullable<Awaited<ReturnType<typeof recorded>>>

interface Found {
  value: number
  error: number // the ± that the page gives
}
const lastDigit = 0.05 // [%] of how far off one constant rate is: the page gives no ± of it

const rateOf = (fit: Fit): Found => found(fit.parameters.decay_rate)
const found = (of: { value: number | null; standard_error: number | null } | undefined): Found =>
  ({ value: of?.value ?? NaN, error: of?.standard_error ?? NaN })

/// What the page says where it is used as lab two asks for.
async function answersIn({ fit, compare }: Recorded, truth: Truth): Promise<(Record<QuestionTwo, Found> & { whole: Fit }) | null> {
  const whole = await fit([['law', 'viscous+drag'], ['mass', massText(truth)], ['disc-diameter', discText(truth)]])
  const middle = await fit([['law', 'viscous'], ['from', '30'], ['to', '60']])
  const constant = (await compare([['law', 'viscous+drag']]))?.[0]
  if (!whole || !middle || !whole.reynolds || constant?.amplitude_ratio_end == null) return null
  return {
    whole,
    frequency: found(whole.derived.frequency),
    stiffness: found(whole.parameters.stiffness),
    rate: rateOf(middle),
    reynolds: { value: whole.reynolds.max, error: whole.reynolds.standard_error ?? NaN },
    off: { value: Math.abs(constant.amplitude_ratio_end - 1) * 100, error: lastDigit }
  }
}

/// Null where the core could not be asked.
export async function keyOfTwo(truth: Truth, ask: AskCore): Promise<Record<QuestionTwo, Expected> | null> {
  const [still, own] = [await recorded(truth, ask, quiet), await recorded(truth, ask)]
  if (!still || !own) return null
  const [right, said] = [await answersIn(still, truth), await answersIn(own, truth)]
  const early = await still.fit([['law', 'viscous'], ['from', '0'], ['to', '30']])
  const all = await still.fit([['law', 'viscous']])
  if (!right || !said || !early || !all) return null
  if (!questionsOf.two.every((each) => Number.isFinite(right[each].value + said[each].value + said[each].error))) return null
  const expected = (question: QuestionTwo, value: number, most: number, slips: [name: string, value: number][], alsoRight = value): Expected => {
    const { value: seen, error: least } = said[question]
    const within = Math.max(2 * least, Math.max(Math.abs(seen - value), Math.abs(alsoRight - value)) + least)
    return { value, unit: units[question], enough: 0, uncertainty: { least, most, within }, slips: slipsOf(slips) }
  }
  const { stiffness } = truth
  const [frequency, rate, reynolds, off] = [right.frequency.value, right.rate.value, right.reynolds.value, right.off.value]
  // What the text asks for takes no account of the damping before the speed is largest.
  const byHand = (2 * Math.PI * frequency * truth.start * truth.disc) / airViscosity
  return {
    frequency: expected('frequency', frequency, 0.01 * frequency, [['angular', 2 * Math.PI * frequency], ['period', 1 / frequency]]),
    stiffness: expected('stiffness', stiffness, 0.03 * stiffness, [['grams', stiffness * 1000], ['hertz', stiffness / (4 * Math.PI ** 2)]]),
    rate: expected('rate', rate, 0.3 * rate, [
      ['first', rateOf(early).value], ['whole', rateOf(all).value], ['viscousOnly', rateOf(right.whole).value], ['perCycle', rate / frequency],
    ]),
    reynolds: expected('reynolds', reynolds, 0.15 * reynolds, [
      ['radius', reynolds / 2], ['centimetres', reynolds * 100], ['thousands', reynolds / 1000],
    ], byHand),
    off: { ...expected('off', off, off / 2, [['fraction', off / 100], ['ratio', 100 - off]]), unsigned: true }
  }
}
