// What a teacher sets for a class. It stands in the class link, and with it in every hand-in.
import { numberOf } from '../look/numbers'
import type { Expected, Lab } from './questions'
import { questionsOf } from './questions'

/// As typed.
export interface OwnTask {
  text: string
  answer: string // empty: read by the teacher
  unit: string
  tolerance: string // [%] empty: the class's own
}

export interface ClassOptions {
  labs: Lab[]
  /// The law is not fitted: students work by hand.
  hideLaw: boolean
  /// [%] so near a value is right whatever its ±; 0: as each lab has it.
  tolerance: number
  tasks: OwnTask[]
}

/// How they stand in the address.
export interface OptionsState {
  labs: string[]
  hide: boolean
  tolerance: number
  tasks: string
}
export const optionsDefaults: OptionsState = { labs: [], hide: false, tolerance: 0, tasks: '' }
export const mostTasks = 10
export const longest = { text: 400, answer: 40, unit: 20, tolerance: 10 }
const fields = ['text', 'answer', 'unit', 'tolerance'] as const

/// Of tasks one text that links take, and that is not read at a glance: their answers are in it.
export function packed(tasks: OwnTask[]): string {
  const rows = tasks.filter(({ text }) => text.trim() !== '').map((task) => fields.map((field) => task[field].trim()))
  if (rows.length === 0) return ''
  const bytes = new TextEncoder().encode(JSON.stringify(rows))
  return btoa(String.fromCharCode(...bytes)).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')
}

/// Null where it is no list of tasks.
export function unpacked(text: string): OwnTask[] | null {
  if (text === '') return []
  try {
    const bytes = Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0))
    const rows: unknown = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes))
    if (!Array.isArray(rows) || rows.length > mostTasks) return null
    const tasks = rows.map((row: unknown) => Object.fromEntries(fields.map((field, i) => [field, (row as unknown[])[i]])) as unknown as OwnTask)
    const isTask = (task: OwnTask) => fields.every((field) => typeof task[field] === 'string' && task[field].length <= longest[field])
    return tasks.every(isTask) ? tasks : null
  } catch {
    return null
  }
}

/// A number where there is one: else it would silently be a text to be read, or the class's tolerance.
export const isTyped = (field: keyof OwnTask, typed: string): boolean =>
  typed.trim() === '' || field === 'text' || field === 'unit' || (field === 'answer' ? Number.isFinite(numberOf(typed)) : numberOf(typed) >= 0)

export const isTolerance = (percent: number): boolean => percent === 0 || (percent >= 0.1 && percent <= 50)

/// A link that names no labs is of lab two, as all once were.
export const optionsOf = ({ labs, hide, tolerance, tasks }: OptionsState): ClassOptions => ({
  labs: labs.length === 0 ? ['two'] : (labs as Lab[]), hideLaw: hide, tolerance, tasks: unpacked(tasks) ?? []
})
export const stateOf = ({ labs, hideLaw, tolerance, tasks }: ClassOptions): OptionsState => ({
  labs: labs.join() === 'two' ? [] : labs, hide: hideLaw, tolerance, tasks: packed(tasks)
})

/// What a lab asks of this class: without a fit nobody can say how far off one constant rate is.
export const questionsIn = (lab: Lab, { hideLaw }: Pick<ClassOptions, 'hideLaw'>) =>
  questionsOf[lab].filter((question) => !(hideLaw && question === 'off'))

export const taskId = (i: number): string => `task ${i + 1}`
/// Names of all answers that a class gives, in order.
export const idsOf = (options: ClassOptions): string[] => [
  ...options.labs.flatMap((lab): string[] => questionsIn(lab, options)), ...options.tasks.map((_, i) => taskId(i))
]

const partOf = (value: number, percent: number) => (Math.abs(value) * percent) / 100

/// With the class's tolerance.
export const tolerant = (expected: Expected, { tolerance }: ClassOptions): Expected =>
  tolerance > 0 ? { ...expected, enough: partOf(expected.value, tolerance) } : expected

/// Null where there is no answer to hold it against.
export function expectedOf(task: OwnTask, options: ClassOptions, otherwise: number): Expected | null {
  const value = numberOf(task.answer)
  if (!Number.isFinite(value)) return null
  const own = numberOf(task.tolerance)
  const percent = own >= 0 ? own : options.tolerance || otherwise
  return { value, unit: task.unit, enough: partOf(value, percent), uncertainty: null, slips: [] }
}
