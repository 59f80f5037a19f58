// What a student hands in, as one file; and what a teacher reads off thirty of them.
import type { Fit } from '../core/types'
import { numberOf } from '../look/numbers'
import { check, type Checked } from './check'
import { keyOf, questions, type AskCore, type Key, type Question } from './key'
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
  answers: Record<Question, Given>
  fit: { law: string; parameters: Record<string, { value: number | null; standard_error: number | null; unit: string }> } | null
  link: string
}

export function handInOf(
  who: { name: string; course: string; student: string },
  answers: Record<Question, Given>,
  fit: Pick<Fit, 'law' | 'parameters' | 'derived'> | null,
  link: string,
): HandIn {
  const found = fit?.law
    ? Object.entries({ ...fit.parameters, ...fit.derived }).map(
        ([name, { value, standard_error, unit }]) => [name, { value, standard_error, unit }] as const,
      )
    : []
  return { cromer: 'hand-in', version: 1, ...who, answers, fit: fit?.law ? { law: fit.law, parameters: Object.fromEntries(found) } : null, link }
}

/// "hand-in-7F3A-19.json"
export const fileNameOf = ({ course, student }: Pick<HandIn, 'course' | 'student'>): string =>
  `hand-in-${nameOf(course, student)}`.replace(/[^\p{L}\d.-]+/gu, '_') + '.json'

const isText = (value: unknown, most = 400): value is string => typeof value === 'string' && value.length <= most
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
  const answers = questions.map((question) => {
    const given: Partial<Given> | undefined = one.answers?.[question]
    return [question, { value: isText(given?.value) ? given.value : '', uncertainty: isText(given?.uncertainty) ? given.uncertainty : '' }] as const
  })
  return {
    cromer: 'hand-in', version: 1, name: one.name, course: one.course, student: one.student, link: one.link ?? '',
    answers: Object.fromEntries(answers) as HandIn['answers'], fit: isText(one.fit?.law) ? one.fit : null,
  }
}

/// One and the same student: what they typed last counts.
export const whoIs = ({ course, student, name }: HandIn): string => [course, student, name].map(oneForm).join('\n')

export interface Marked {
  handIn: HandIn
  /// Null where the core could not make the key.
  checked: Record<Question, Checked> | null
  right: number
}

const keys = new Map<number, Key>()

/// The answers of one recording; null where the core could not be asked. What was made once is kept.
export async function keyFor(course: string, student: string, ask: AskCore): Promise<Key | null> {
  const seed = seedOf(course, student)
  const key = keys.get(seed) ?? (await keyOf(truthOf(seed), ask))
  if (key) keys.set(seed, key)
  return key
}

/// Held against the key of the recording that belongs to class and student.
export async function mark(handIn: HandIn, ask: AskCore): Promise<Marked> {
  const key = await keyFor(handIn.course, handIn.student, ask)
  if (!key) return { handIn, checked: null, right: 0 }
  const checked = Object.fromEntries(
    questions.map((question) => [question, check(handIn.answers[question].value, handIn.answers[question].uncertainty, key[question])]),
  ) as Record<Question, Checked>
  return { handIn, checked, right: questions.filter((question) => checked[question].verdict === 'right').length }
}

/// A spreadsheet takes what begins with = + - @ for a formula, but for numbers.
function cell(text: string): string {
  const safe = /^[=+@-]/.test(text) && Number.isNaN(numberOf(text)) ? `'${text}` : text
  return /[",\r\n;]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe
}

/// One row for each student: who, what was answered, the verdicts. Spreadsheets know UTF-8 by the mark at its beginning.
export function csvOf(all: Marked[]): string {
  const head = ['name', 'class', 'student', 'right', ...questions.flatMap((question) => [question, `${question} ±`, `${question} verdict`]), 'law', 'link']
  const rows = all.map(({ handIn, checked, right }) => [
    handIn.name, handIn.course, handIn.student, String(right),
    ...questions.flatMap((question) => [handIn.answers[question].value, handIn.answers[question].uncertainty, checked?.[question].verdict ?? '']),
    handIn.fit?.law ?? '', handIn.link,
  ])
  return `\ufeff${[head, ...rows].map((row) => row.map(cell).join(',')).join('\n')}\n`
}
