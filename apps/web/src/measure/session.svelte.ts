// The recording that is open, and what the core found in it. None of it is in the address: files stay here.
import { openCore } from '../core/ask'
import type { Answer, Fit, Inspection, Modes, Options, Task } from '../core/types'
import { looks } from '../state/looks.svelte'
import { page } from '../state/page.svelte'
import { toast } from '../state/notices.svelte'
import { settle as settleState } from '../state/undo.svelte'
import { isHidden } from '../teach/hidden'
import { compareOptions, fieldOptions, fitOptions, inspectOptions, modesOptions, optionNames, type ReadAs } from './questions'
import { besideField, ofFile, type Refusal, type Said } from '../words/said'
import { told, words } from '../words/words.svelte'
import { moveTogether, namesOf, runsOf, seriesOf } from './series'
import { measureDefaults } from './state'

export interface File {
  name: string
  bytes: Uint8Array
  /// Where it comes from: the page itself, the clipboard, or a file that its reader has.
  origin: 'simulated' | 'pasted' | 'file'
}

export interface Simulated {
  method: string
  law: string
  step: number
  amplitude: number | null // at the end, of the law's own
  phase: number | null // [rad]
  diverged: boolean
  atRest: boolean // the recording ends at rest: ratios of amplitudes there say nothing
  t: Float64Array
  x: Float64Array
  v: Float64Array
  energy: Float64Array
}

/// Longest file that is read [bytes].
export const longest = 250e6

/// Nothing is refused.
export const nothing: Refusal = { message: '', argument: null, code: '', values: {} }

class Session {
  file: File | null = $state.raw(null)
  inspection: Inspection | null = $state.raw(null)
  names: string[] = $state.raw([]) // of the columns, and of what was computed of them when the file was opened
  /// The fit shown, and that with one constant rate.
  fit: Fit | null = $state.raw(null)
  constant: Fit | null = $state.raw(null)
  simulated: Simulated[] = $state.raw([])
  /// The modes of several columns; null of one column, and until they are found.
  modes: Modes | null = $state.raw(null)
  /// What a constant rate makes of the last swing, as a part of it.
  constantAtEnd: number | null = $state(null)
  /// 'first': no fit of these settings yet; 'more': the laws are still being compared.
  busy: '' | 'reading' | 'first' | 'more' | 'overlay' = $state('')
  /// A file that was not read, with the core's message; what was open before stays.
  refused: { file: File | null; name: string; why: Refusal } | null = $state.raw(null)
  /// Why no simulation of the law stands beside it.
  notSimulated: Said = $state.raw('')
  /// Why there is no fit, or what of the settings was not taken.
  why: Refusal = $state.raw(nothing)
  /// The frame that is shown larger [s].
  frame: { from: number; to: number } | null = $state.raw(null)

  runs = $derived(this.inspection ? runsOf(this.inspection) : 1)
  /// Of a class whose students work by hand: nothing is fitted.
  hidden = $derived(isHidden(this.file))
  series = $derived(this.inspection ? seriesOf(this.inspection, page.measure.run) : null)
}

export const session = new Session()

/// A refusal with the page's own name of the setting at fault.
const named = (why: Refusal): Said => besideField(why, optionNames(words().measure)[why.argument ?? ''])

/// The message of the file that was not read, which begins with its name.
export function refusedText(): string {
  const { name, why } = session.refused ?? { name: '', why: nothing }
  return told(ofFile(name, named(why)))
}

/// A refusal that stands beside its own field.
export const isOfField = ({ argument }: Refusal): boolean => Object.values(fieldOptions).some((option) => option === argument)

/// Why there is no fit, in the page's language.
export const whyNoFit = (): string => told(named(session.why))

/// Each in a worker; as many as the device has processors beside the page's own, each with a file of its own.
const cores: (ReturnType<typeof openCore> | undefined)[] = []
const most = Math.max(1, Math.min(3, (navigator.hardwareConcurrency || 1) - 1))
const mostShared = 50e6 // [bytes] a longer file is in one worker at a time
let asking = 0
let turn = 0

/// What is being computed for older settings is let go of: its workers end.
function newTurn(): number {
  if (asking > 0) {
    for (const core of cores.splice(0)) core?.close()
    asking = 0
  }
  return ++turn
}

/// Null where a newer turn has begun meanwhile. `lane`: questions of different lanes are computed at once where
/// that is possible, else one after another in the order they came.
async function ask<T extends Task>(
  mine: number,
  task: T,
  options: Options,
  file?: File,
  lane = 0
): Promise<Answer<T> | null> {
  if (mine !== turn) return null
  const at = file && file.bytes.length > mostShared ? 0 : lane % most
  const core = (cores[at] ??= openCore())
  ++asking
  const answer = await core.ask(task, options, file && { file: file.bytes, fileName: file.name })
  if (mine !== turn) return null
  --asking
  return answer
}

/// Reads a recording. A bad one leaves what was open before as it was. `settings`: what goes with it.
export async function openFile(file: File, settings: Partial<typeof measureDefaults> = {}): Promise<boolean> {
  const mine = newTurn()
  session.busy = 'reading'
  const { rate = '', column: wanted = '', skip = false } = settings
  const answer = await ask(mine, 'inspect', inspectOptions({ rate, column: wanted, skip }), file)
  if (!answer) return false
  session.busy = ''
  if (answer.status === 2) {
    session.refused = { file, name: file.name, why: answer.document }
    if (session.file) void refit()
    return false
  }
  const inspection = answer.document
  const alike = namesOf(inspection).length > 1
  const column = settings.column ?? (alike ? (inspection.column ?? '') : '')
  clear()
  const before = session.file && { file: session.file, settings: $state.snapshot(page.measure) }
  // What was weighed and measured for one recording is not another's.
  const own = before && before.file.name !== file.name ? { mass: '', disc: '' } : {}
  settleState((state) => Object.assign(state.measure, { column, run: 1, from: '', to: '', law: '', rate: '', skip: false, drive: '' }, own, settings))
  if (before && before.file.name !== file.name) toast(words().measure.opened(file.name), () => void openFile(before.file, before.settings))
  session.refused = null
  session.inspection = inspection
  session.names = namesOf(inspection)
  session.file = file
  settleState((state) => (state.teach.taken = false))
  described = settingsOf({ rate, column, skip })
  return true
}

/// The settings that `session.inspection` is of.
let described = ''
const settingsOf = ({ rate, column, skip }: ReadAs) => JSON.stringify([rate, column, skip])

/// Looks into the file again where another column or rate was chosen. False where that ended it.
async function describe(mine: number, file: File, state: typeof measureDefaults): Promise<boolean> {
  if (settingsOf(state) === described) return true
  const answer = await ask(mine, 'inspect', inspectOptions(state), file)
  if (!answer) return false
  if (answer.status === 2) {
    settle(mine, null, answer.document)
    return false
  }
  clear()
  session.inspection = answer.document
  described = settingsOf(state)
  return true
}

function clear(): void {
  modesAsked = ''
  Object.assign(session, { modes: null, fit: null, constant: null, simulated: [], notSimulated: '', constantAtEnd: null, why: nothing, frame: null })
}

/// A fit, or why the core refused its settings.
type Tried = Fit | { refused: Refusal } | null

const isRefused = (tried: Tried): tried is { refused: Refusal } => tried !== null && 'refused' in tried
const converged = (tried: Tried): tried is Fit => tried !== null && !isRefused(tried) && tried.status === 'converged'

const bic = (fit: Fit) => fit.candidates.find((each) => each.law === fit.law)?.bic ?? Infinity

const patience = 700 // [ms] after which one law is shown before there are two
/// Two laws first, which takes a moment; then, unless one was chosen, all of them.
async function refit(): Promise<void> {
  const { file } = session
  if (!file) return
  const mine = newTurn()
  const state = $state.snapshot(page.measure)
  session.busy = 'first'
  session.simulated = []
  if (!(await describe(mine, file, state))) return
  if (session.hidden) {
    session.constant = null
    return settle(mine, null)
  }
  const runs = session.runs
  const fitOf = async (law: string, lane: number): Promise<Tried> => {
    const answer = await ask(mine, 'fit', fitOptions(state, runs, law), file, lane)
    if (!answer) return null
    if (answer.status === 2) return { refused: answer.document }
    return answer.document.fits[0]!
  }
  void findModes(mine, file, state)
  const began = performance.now()
  const constantAsked = fitOf('viscous', 0)
  const bestAsked = state.law === 'viscous' ? constantAsked : fitOf(state.law || 'viscous+drag', 1)
  const allAsked = state.law === '' ? fitOf('', 2) : null
  const constant = await constantAsked
  if (mine !== turn) return
  if (isRefused(constant)) return refuse(mine, constant.refused)
  session.constant = converged(constant) ? constant : null
  if (allAsked && session.constant && performance.now() - began > patience) {
    show(session.constant)
    session.busy = 'more'
  }
  let best = await bestAsked
  let quick: Fit | undefined
  if (mine !== turn) return
  if (allAsked) {
    quick = [constant, best].filter(converged).sort((a, b) => bic(a) - bic(b))[0]
    if (quick) {
      show(quick)
      session.busy = 'more'
    }
    best = await allAsked
    if (mine !== turn) return
  }
  if (isRefused(best)) return refuse(mine, best.refused)
  // Where the comparison of all laws gave up, the better of two stays, and why is said with it.
  if (best && best.status !== 'converged') return settle(mine, quick ?? null, { ...nothing, message: best.message ?? best.status })
  settle(mine, best)
  if (best && state.overlay) await simulate(mine, best.law!)
}

/// The options that `session.modes` is of.
let modesAsked = ''
async function findModes(mine: number, file: File, state: typeof measureDefaults): Promise<void> {
  const options = modesOptions(state, session.runs)
  const asked = JSON.stringify(options)
  if (asked === modesAsked) return
  if (!moveTogether(session.inspection!, state.run)) {
    session.modes = null
    modesAsked = ''
    return
  }
  const answer = await ask(mine, 'modes', options, file, 1)
  if (!answer) return
  session.modes = answer.status === 2 || answer.document.names.length < 2 ? null : answer.document
  modesAsked = asked
}

/// A setting that the core refuses stands beside its field; the fit before it stays.
function refuse(mine: number, why: Refusal): void {
  settle(mine, why.argument ? session.fit : null, why)
}

function settle(mine: number, fit: Fit | null, why = nothing): void {
  if (mine !== turn) return
  session.busy = ''
  session.why = why
  show(fit)
}

function show(fit: Fit | null): void {
  session.fit = fit
  const t = fit?.curves?.t
  if (!t || t.length < 2) return
  const [first, last] = [t[0]!, t.at(-1)!]
  const { frame } = session
  if (frame && frame.from >= first && frame.to <= last) return
  const period = fit.derived.period?.value ?? (last - first) / 8
  const spacing = session.series?.spacing ?? 0
  // Few enough samples that each is a dot of its own.
  const dots = Math.max(120, 0.34 * looks.width)
  const wide = Math.min(last - first, Math.max(20 * spacing, 2.5 * period, Math.min(8.5 * period, dots * spacing)))
  const from = first + 0.3 * (last - first - wide)
  session.frame = { from, to: from + wide }
}

/// The fitted law stepped by two methods, beside the recording.
async function simulate(mine: number, law: string): Promise<void> {
  session.busy = 'overlay'
  session.notSimulated = ''
  const state = $state.snapshot(page.measure)
  const found: Simulated[] = []
  const answer = await ask(mine, 'compare', compareOptions(state, session.runs, law), session.file!)
  if (mine !== turn) return
  if (answer?.status === 2) session.notSimulated = answer.document.message
  else if (answer) {
    const compared = answer.document.comparisons[0]!
    session.constantAtEnd = compared.curves[0]?.amplitude_ratio_end ?? null
    const atRest = compared.measured_at_rest === true
    compared.curves.forEach(({ method, law, step, method_amplitude_ratio: amplitude, method_phase: phase, diverged }, i) => {
      if (step !== null) found.push({ method, law, step, amplitude, phase, diverged, atRest, ...compared.states[i]! })
    })
  }
  session.simulated = found
  session.busy = ''
}

// What a change of the settings asks for is asked once they rest.
$effect.root(() => {
  let timer = 0
  $effect(() => {
    void JSON.stringify(page.measure)
    void session.file
    void session.hidden
    clearTimeout(timer)
    if (session.file) timer = window.setTimeout(refit, 160)
  })
})
