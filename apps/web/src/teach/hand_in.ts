// What a student hands in, as one file; and what a teacher reads off thirty of them.
import type { Fit } from '../core/types'
import { numberOf } from '../look/numbers'
import { check, plain, type Checked } from './check'
import { keyOfOne, usualTolerance } from './key_one'
import { keyOfTwo } from './key_two'
import { expectedOf, idsOf, optionsDefaults, optionsOf, questionsIn, stateOf, taskId, tolerant, isTolerance, unpacked, type ClassOptions, type OptionsState } from './options'
import { oscillatorOf } from './own_oscillator'
import { countOf, happens, type Prediction } from './predictions'
import type { AskCore, Key, Lab } from './questions'
import { nameOf, oneForm, seedOf } from './seed'
import { truthOf } from './truth'

export interface Given {
  value: string
  uncertainty: string
}

export interface HandIn {
  cromer: 'hand-in'
  version: 1
  name: string // of the student, as typed
  course: string
  student: string
  options: OptionsState // of the class, as its link has them
  /// By the names of options.ts.
  answers: Record<string, Given>
  predictions: Prediction[]
  fit: { law: string; parameters: Record<string, { value: number | null; standard_error: number | null; unit: string }> } | null
  link: string
}

export function handInOf(
  who: Pick<HandIn, 'name' | 'course' | 'student' | 'options' | 'answers' | 'predictions'>,
  fit: Pick<Fit, 'law' | 'parameters' | 'derived'> | null,
  link: string,
): HandIn {
  const found = fit?.law
    ? Object.entries({ ...fit.parameters, ...fit.derived }).map(
        ([name, { value, standard_error, unit }]) => [name, { value, standard_error, unit }] as const,
      )
    : []
  return { cromer: 'hand-in', version: 1, ...who, fit: fit?.law ? { law: fit.law, parameters: Object.fromEntries(found) } : null, link }
}

/// "hand-in-7F3A-19.json"
export const fileNameOf = ({ course, student }: Pick<HandIn, 'course' | 'student'>): string =>
  `hand-in-${nameOf(course, student)}`.replace(/[^\p{L}\d.-]+/gu, '_') + '.json'

const isText = (value: unknown, most = 400): value is string => typeof value === 'string' && value.length <= most
const longestAnswer = 2000
const longestLink = 20_000 // it holds all settings of all pages

/// Null where the text is no hand-in.
export function readHandIn(text: string): HandIn | null {
  let read: unknown
  try {
    read = JSON.parse(text)
  } catch {
    return null
  }
  if (typeof read !== 'object' || read === null) return null
  const one = read as Partial<HandIn>
  if (one.cromer !== 'hand-in' || one.version !== 1) return null
  if (!isText(one.name) || !isText(one.course) || !isText(one.student) || !isText(one.link ?? '', longestLink)) return null
  const options = readOptions(one.options)
  const answers = idsOf(optionsOf(options)).map((id) => {
    const given: Partial<Given> | undefined = one.answers?.[id]
    return [id, { value: isText(given?.value, longestAnswer) ? given.value : '', uncertainty: isText(given?.uncertainty) ? given.uncertainty : '' }] as const
  })
  return {
    cromer: 'hand-in', version: 1, name: one.name, course: one.course, student: one.student, link: one.link ?? '', options,
    answers: Object.fromEntries(answers), predictions: readPredictions(one.predictions), fit: isText(one.fit?.law) ? one.fit : null,
  }
}

const isLab = (lab: unknown): lab is Lab => lab === 'one' || lab === 'two'

/// What is not as it must be is as where a class has none.
function readOptions(read: Partial<OptionsState> | undefined): OptionsState {
  const { labs, hide, tolerance, tasks } = { ...optionsDefaults, ...read }
  return {
    labs: Array.isArray(labs) && labs.every(isLab) && new Set(labs).size === labs.length ? labs : [],
    hide: hide === true,
    tolerance: isTolerance(tolerance) ? tolerance : 0,
    tasks: typeof tasks === 'string' && unpacked(tasks) ? tasks : '',
  }
}

const readPredictions = (read: unknown): Prediction[] =>
  (Array.isArray(read) ? (read as Partial<Prediction>[]) : []).flatMap((each) => {
    const { lab, step = 0, guess = null } = each ?? {}
    return isLab(lab) && happens(lab, step) !== undefined && (guess === null || [0, 1, 2].includes(guess)) ? [{ lab, step, guess }] : []
  })

/// One and the same student: what they typed last counts.
export const whoIs = ({ course, student, name }: HandIn): string => [course, student, name].map(oneForm).join('\n')

export interface Marked {
  handIn: HandIn
  /// Those that it was marked by.
  options: ClassOptions
  /// Null where the core could not make the key.
  checked: Record<string, Checked> | null
  right: number
  of: number
  /// It was answered under other options than the class has.
  otherOptions: boolean
}

const keys = new Map<string, Key>()

/// The answers of one lab for one seed; null where the core could not be asked. What was made once is kept.
export async function keyOf(lab: Lab, seed: number, ask: AskCore): Promise<Key | null> {
  const name = `${lab} ${seed}`
  const key = keys.get(name) ?? (await (lab === 'one' ? keyOfOne(oscillatorOf(seed), ask) : keyOfTwo(truthOf(seed), ask)))
  if (key) keys.set(name, key)
  return key
}

/// All that a class is asked: of its labs with its tolerance, and of its own tasks. A task that is read has no entry.
export async function keyFor(seed: number, options: ClassOptions, ask: AskCore): Promise<Key | null> {
  const all: Key = {}
  for (const lab of options.labs) {
    const key = await keyOf(lab, seed, ask)
    if (!key) return null
    for (const question of questionsIn(lab, options)) all[question] = tolerant(key[question]!, options)
  }
  options.tasks.forEach((task, i) => {
    const expected = expectedOf(task, options, usualTolerance)
    if (expected) all[taskId(i)] = expected
  })
  return all
}

/// Of one answer.
export function checkGiven({ value, uncertainty }: Given, expected: Key[string]): Checked {
  return expected ? check(value, uncertainty, expected) : plain(value.trim() ? 'given' : 'empty')
}

/// Held against the key that belongs to class and student. `common`: the options that the class has.
export async function mark(handIn: HandIn, ask: AskCore, common: OptionsState = handIn.options): Promise<Marked> {
  const options = optionsOf(common)
  const ids = idsOf(options)
  const otherOptions = JSON.stringify(stateOf(options)) !== JSON.stringify(stateOf(optionsOf(handIn.options)))
  const key = await keyFor(seedOf(handIn.course, handIn.student), options, ask)
  const of = key ? ids.filter((id) => key[id]).length : 0
  if (!key) return { handIn, options, checked: null, right: 0, of, otherOptions }
  const checked = Object.fromEntries(ids.map((id) => [id, checkGiven(handIn.answers[id] ?? { value: '', uncertainty: '' }, key[id])]))
  return { handIn, options, checked, right: ids.filter((id) => checked[id]!.verdict === 'right').length, of, otherOptions }
}

/// What most of a class's hand-ins were answered under.
export function commonOptions(handIns: HandIn[]): OptionsState {
  const texts = handIns.map(({ options }) => JSON.stringify(options))
  const most = [...new Set(texts)].sort((a, b) => texts.filter((text) => text === b).length - texts.filter((text) => text === a).length)[0]
  return most ? (JSON.parse(most) as OptionsState) : optionsDefaults
}

/// What is wrong or missing, as "stiffness: grams": the slip that it looks like, or the verdict.
export const missedOf = ({ checked }: Marked): string[] =>
  Object.entries(checked ?? {}).flatMap(([id, { verdict, slip }]) => (verdict === 'right' || verdict === 'given' ? [] : [`${id}: ${slip || verdict}`]))

/// A spreadsheet takes what begins with = + - @ for a formula, but for numbers.
function cell(text: string): string {
  const safe = /^[=+@-]/.test(text) && Number.isNaN(numberOf(text)) ? `'${text}` : text
  return /[",\r\n;]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe
}

/// All that any of the hand-ins was asked, in order.
export const idsIn = (all: Marked[]): string[] => [...new Set(all.flatMap(({ options }) => idsOf(options)))]

/// One row for each student: who, what was answered, the verdicts. Spreadsheets know UTF-8 by the mark at its beginning.
export function csvOf(all: Marked[]): string {
  const ids = idsIn(all)
  const head = [
    'name', 'class', 'student', 'right', 'of', ...ids.flatMap((id) => [id, `${id} ±`, `${id} verdict`]), 'missed',
    'predictions', 'predictions right', 'without a guess', 'other options', 'law', 'link',
  ]
  const rows = all.map((marked) => {
    const { handIn, checked, right, of, otherOptions } = marked
    const { asked, right: foreseen, without } = countOf(handIn.predictions)
    return [
      handIn.name, handIn.course, handIn.student, String(right), String(of),
      ...ids.flatMap((id) => [handIn.answers[id]?.value ?? '', handIn.answers[id]?.uncertainty ?? '', checked?.[id]?.verdict ?? '']),
      missedOf(marked).join('; '), String(asked), String(foreseen), String(without), otherOptions ? 'yes' : '', handIn.fit?.law ?? '', handIn.link,
    ]
  })
  return `\ufeff${[head, ...rows].map((row) => row.map(cell).join(',')).join('\n')}\n`
}
