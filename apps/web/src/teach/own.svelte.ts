// What belongs to the student: a recording and an oscillator, the key to them, and what became of the answers.
import { askAside as ask } from '../core/ask'
import { openSynthetic } from '../measure/examples'
import type { MeasureState } from '../measure/state'
import { withoutTerms } from '../simulate/presets'
import { page } from '../state/page.svelte'
import { change, settle } from '../state/undo.svelte'
import { answerOf, type Checked } from './check'
import { checkGiven, keyFor, type Given } from './hand_in'
import { idsOf, optionsOf, questionsIn, taskId } from './options'
import { oscillatorOf } from './own_oscillator'
import type { Tour } from './tour'
import { questionsOf, units, type Lab, type Question } from './questions'
import { nameOf, seedOf } from './seed'
import { recordingName } from './hidden'
import { recordingOptions, truthOf } from './truth'

const practice = seedOf('practice', '1')

class Own {
  /// Of a class and a student; else the practice recording, the same for all.
  personal = $derived(page.teach.course.trim() !== '' && page.teach.student.trim() !== '')
  /// A class whose student has not said who they are: there is no recording for them yet.
  unknown = $derived(page.teach.course.trim() !== '' && page.teach.student.trim() === '')
  name = $derived(this.personal ? nameOf(page.teach.course, page.teach.student) : '')
  seed = $derived(this.personal ? seedOf(page.teach.course, page.teach.student) : practice)
  truth = $derived(truthOf(this.seed))
  oscillator = $derived(oscillatorOf(this.seed))
  options = $derived(optionsOf(page.teach))
  /// Of a class; without one both are open to everybody.
  labs = $derived<Lab[]>(page.teach.course.trim() === '' ? ['one', 'two'] : this.options.labs)
  /// A class has its labs alone.
  tours = $derived<Tour[]>(page.teach.course.trim() === '' ? [...this.labs, 'three'] : this.labs)
  /// The law of the class's recordings is hidden.
  byHand = $derived(page.teach.course.trim() !== '' && this.options.hideLaw)
  /// What is asked beside the lab that is shown.
  asked = $derived<Question[]>(page.teach.lab === 'three' ? [] : questionsIn(page.teach.lab as Lab, { hideLaw: this.byHand }))
  ids = $derived([...this.asked, ...this.options.tasks.map((_, i) => taskId(i))])
  /// Of the last check, each with the answer that it was of.
  results: Record<string, Checked & { of: string }> = $state({})
  checking = $state(false)
  failed = $state(false)
  /// Of what is asked here and can be checked.
  checkable = $derived(this.ids.filter((id) => (judged(id)?.verdict ?? '') !== 'given' && !this.isRead(id)))
  right = $derived(this.checkable.filter((id) => judged(id)?.verdict === 'right').length)
  private isRead = (id: string) => this.options.tasks.some((task, i) => taskId(i) === id && task.answer.trim() === '')
}

export const own = new Own()

export async function checkAnswers(): Promise<void> {
  const { seed, options, ids } = own
  own.checking = true
  own.failed = false
  const labs: Lab[] = [page.teach.lab as Lab]
  const key = await keyFor(seed, { ...options, labs }, ask).catch(() => null)
  own.checking = false
  if (seed !== own.seed) return
  if (!key) {
    own.failed = true
    return
  }
  for (const id of ids) own.results[id] = { of: typedAt(id), ...checkGiven(answerAt(id), key[id]) }
}

const typedAt = (id: string): string => `${answerAt(id).value};${answerAt(id).uncertainty}`

/// What the last check said of an answer, unless it has been changed since.
export function judged(id: string): Checked | undefined {
  const result = own.results[id]
  return result?.of === typedAt(id) ? result : undefined
}

type Field = 'values' | 'uncertainties' | 'valuesOne' | 'valuesTasks'
/// Where the address has an answer.
function placeOf(id: string): { at: number; values: Field; uncertainties?: Field } {
  const [one, two] = [questionsOf.one, questionsOf.two].map((each) => (each as readonly string[]).indexOf(id)) as [number, number]
  if (two >= 0) return { at: two, values: 'values', uncertainties: 'uncertainties' }
  return one >= 0 ? { at: one, values: 'valuesOne' } : { at: Number(id.split(' ')[1]) - 1, values: 'valuesTasks' }
}

export function answerAt(id: string): Given {
  const { at, values, uncertainties } = placeOf(id)
  const text = (field: Field | undefined) => (field ? (page.teach[field].split(';')[at] ?? '') : '')
  return { value: text(values), uncertainty: text(uncertainties) }
}

/// An answer typed with its ± fills both fields.
export function setAnswer(of: keyof Given, id: string, text: string): void {
  if (text === answerAt(id)[of]) return
  const { at, values, uncertainties } = placeOf(id)
  const read = answerOf(text, units[id as Question] ?? '')
  const both = of === 'value' && uncertainties && read.uncertainty !== null
  change(`answer ${id} ${of}`, (state) => {
    const put = (field: Field, what: string) => {
      const all = state.teach[field].split(';')
      while (all.length <= at) all.push('')
      all[at] = what.replaceAll(';', ',').trim()
      state.teach[field] = all.every((each) => each === '') ? '' : all.join(';')
    }
    if (of === 'uncertainty') put(uncertainties!, text)
    else put(values, both ? read.value : text)
    if (both) put(uncertainties, read.uncertainty!)
  })
}

/// Of all that the class asks.
export const allAnswers = (): Record<string, Given> => Object.fromEntries(idsOf(own.options).map((id) => [id, answerAt(id)]))

/// Makes the student's recording anew and opens it; `settings` say which part of it and which law.
export async function openOwn(settings: Partial<MeasureState> = {}): Promise<boolean> {
  const opened = await openSynthetic(recordingName(own.name), recordingOptions(own.truth), settings)
  if (opened) settle((state) => (state.teach.taken = true))
  return opened
}

/// After a reload: the recording that was open, as it was used.
export async function openAgain(): Promise<void> {
  const { mass, disc, from, to, law, drive } = page.measure
  if (page.teach.taken && !own.unknown) await openOwn({ mass, disc, from, to, law, drive })
}

/// The student's own oscillator in Simulate, at rest and driven far below its resonance.
export function openOscillator(): void {
  const { mass, stiffness, damping, force, step } = own.oscillator
  const natural = Math.sqrt(stiffness / mass)
  change('oscillator', (state) => {
    state.tab = 'simulate'
    Object.assign(state.simulate, {
      ...withoutTerms, mass, stiffness, damping,
      driveAmplitude: force, driveFrequency: 0.5, position: 0, velocity: 0, step, until: Math.ceil((30 * 2 * Math.PI) / natural), quantity: 'position',
      methods: ['exact', 'forward-euler', 'euler-cromer', 'implicit-euler'],
    })
  })
}
