// The recording that belongs to the student, the key to it, and what became of the answers.
import { askAside as ask } from '../core/ask'
import { openSynthetic } from '../measure/examples'
import type { MeasureState } from '../measure/state'
import { page } from '../state/page.svelte'
import { change, settle } from '../state/undo.svelte'
import { answerOf, check, type Checked } from './check'
import { keyOf, questions, units, type Key } from './key'
import { nameOf, seedOf } from './seed'
import { recordingOptions, truthOf } from './truth'

const practice = seedOf('practice', '1')

class Own {
  /// Of a class and a student; else the practice recording, the same for all.
  personal = $derived(page.teach.course.trim() !== '' && page.teach.student.trim() !== '')
  /// A class whose student has not said who they are: there is no recording for them yet.
  unknown = $derived(page.teach.course.trim() !== '' && page.teach.student.trim() === '')
  name = $derived(this.personal ? nameOf(page.teach.course, page.teach.student) : '')
  truth = $derived(truthOf(this.personal ? seedOf(page.teach.course, page.teach.student) : practice))
  /// Of the last check, each with the answer that it was of.
  results: (Checked & { of: string })[] = $state([])
  checking = $state(false)
  failed = $state(false)
  right = $derived(questions.filter((_, i) => judged(i)?.verdict === 'right').length)
}

export const own = new Own()

let known: { seed: number; key: Key } | null = null

export async function checkAnswers(): Promise<void> {
  const { truth } = own
  own.checking = true
  own.failed = false
  const key = known?.seed === truth.seed ? known.key : await keyOf(truth, ask).catch(() => null)
  own.checking = false
  if (truth.seed !== own.truth.seed) return
  if (!key) {
    own.failed = true
    return
  }
  known = { seed: truth.seed, key }
  own.results = questions.map((question, i) => ({
    of: typedAt(i),
    ...check(answerAt('values', i), answerAt('uncertainties', i), key[question])
  }))
}

const typedAt = (i: number): string => `${answerAt('values', i)};${answerAt('uncertainties', i)}`

/// What the last check said of an answer, unless it has been changed since.
export function judged(i: number): Checked | undefined {
  const result = own.results[i]
  return result?.of === typedAt(i) ? result : undefined
}

export const answerAt = (of: 'values' | 'uncertainties', i: number): string => page.teach[of].split(';')[i] ?? ''

/// An answer typed with its ± fills both fields.
export function setAnswer(of: 'values' | 'uncertainties', i: number, text: string): void {
  if (text === answerAt(of, i)) return
  const read = answerOf(text, units[questions[i]!])
  const both = of === 'values' && read.uncertainty !== null
  change(`answer ${i} ${of}`, (state) => {
    const put = (where: 'values' | 'uncertainties', what: string) => {
      const all = questions.map((_, j) => state.teach[where].split(';')[j] ?? '')
      all[i] = what.replaceAll(';', '').trim()
      state.teach[where] = all.every((each) => each === '') ? '' : all.join(';')
    }
    put(of, both ? read.value : text)
    if (both) put('uncertainties', read.uncertainty!)
  })
}

/// Makes the student's recording anew and opens it; `settings` say which part of it and which law.
export async function openOwn(settings: Partial<MeasureState> = {}): Promise<boolean> {
  const name = `${own.name || 'practice'}.csv`.replace(/[^\w.-]+/g, '_')
  const opened = await openSynthetic(name, recordingOptions(own.truth), settings)
  if (opened) settle((state) => (state.teach.taken = true))
  return opened
}

/// After a reload: the recording that was open, as it was used.
export async function openAgain(): Promise<void> {
  const { mass, disc, from, to, law, drive } = page.measure
  if (page.teach.taken && !own.unknown) await openOwn({ mass, disc, from, to, law, drive })
}
