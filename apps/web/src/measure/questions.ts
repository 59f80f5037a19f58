// The questions that Measure puts to the core, and the command line that asks the program the same.
import type { Options } from '../core/types'
import { asTyped } from '../look/numbers'
import type { measure } from '../words/en/measure'
import type { MeasureState } from './state'

type Settings = Pick<MeasureState, 'column' | 'run' | 'rate' | 'skip' | 'from' | 'to' | 'law' | 'drive' | 'mass' | 'disc' | 'air'>
type Words = typeof measure
export type ReadAs = Pick<MeasureState, 'column' | 'rate' | 'skip'>

/// Options of what is typed beside the law.
export const fieldOptions = { mass: 'mass', disc: 'disc-diameter', air: 'temperature' }

/// What the page calls the options that it sets.
export const optionNames = ({ law, file, recording, quantities }: Words): Record<string, string> => ({
  mass: law.mass,
  'disc-diameter': law.disc,
  temperature: law.air,
  rate: file.rate,
  column: file.column,
  run: file.run,
  from: recording.start,
  to: recording.end,
  law: law.title,
  'drive-frequency': quantities.drive_frequency![0]
})

const given = (pairs: [string, string][]): Options =>
  pairs.map(([name, value]) => [name, asTyped(value)] as const).filter(([, value]) => value !== '')

/// How the file is read, and which column of it.
export const inspectOptions = (state: ReadAs): Options => given(readAs(state))

const readAs = ({ rate, column, skip }: ReadAs): [string, string][] => [
  ['rate', rate],
  ['skip-bad-rows', skip ? 'true' : ''],
  ['column', column],
]

/// Which samples are used. Of several runs one is fitted: the page shows one at a time.
function samplesOf(state: Settings, runs: number): [string, string][] {
  return [
    ...readAs(state),
    ['run', runs > 1 ? String(state.run) : ''],
    ['from', state.from],
    ['to', state.to]
  ]
}

/// `law` takes the place of the state's own, for a quick answer before all laws are compared.
export function fitOptions(state: Settings, runs = 1, law = state.law): Options {
  return given([
    ...samplesOf(state, runs),
    ['law', law],
    ['drive-frequency', state.drive],
    ['mass', state.mass],
    ['disc-diameter', state.disc],
    ['temperature', state.disc && state.air]
  ])
}

/// Modes are sought in all columns of one kind.
export const modesOptions = (state: Settings, runs = 1): Options =>
  given(samplesOf({ ...state, column: '' }, runs))

/// What the law is simulated by beside the recording.
const methods = ['forward-euler', 'euler-cromer'].map((method): [string, string] => ['method', method])

/// The fitted `law` simulated by each method.
export function compareOptions(state: Settings, runs: number, law: string): Options {
  return given([...samplesOf(state, runs), ['law', law], ['mass', state.mass], ...methods])
}

/// A word as a shell reads it back: bare where nothing in it means something to the shell.
export function quoted(word: string): string {
  if (/^[\w.,:+\/=@%-]+$/.test(word)) return word
  return /["$`\\!]/.test(word) ? `'${word.replaceAll("'", `'\\''`)}'` : `"${word}"`
}

export function commandLine(task: 'fit' | 'compare' | 'report' | 'modes', file: string, state: Settings, runs = 1): string {
  const words = ['cromer', task, quoted(file.startsWith('-') ? `./${file}` : file)]
  const options = task === 'modes' ? modesOptions(state, runs) : fitOptions(state, runs)
  for (const [name, value] of [...options, ...(task === 'compare' ? methods : [])]) {
    if (name === 'temperature' && value === '20 °C') continue
    words.push(`--${name}`, ...(name === 'skip-bad-rows' ? [] : [quoted(value)]))
  }
  if (task === 'report') words.push('-o report')
  return words.join(' ')
}
