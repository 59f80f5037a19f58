// What the core says to the state of the page: asked anew at every change, the newest question first.
import { ask, askAside, openCore } from '../core/ask'
import { answerAtOnce, learn } from '../core/at_once'
import type { Answer, LinearPart, MethodList, Motion, Motions, Options, Resonance } from '../core/types'
import { page } from '../state/page.svelte'
import type { Said } from '../words/said'
import type { Run } from './curves'
import { isContinuous, isLinear } from './law'
import { askForces, betweenOptions, coreOptions, resonanceOptions } from './options'
import { resonanceRange } from './ranges'
import { curvesOfBoth, modesOf, runOfBoth, stateOfMode, type Mode, type ModeNow } from './second'
import type { SimulateState } from './state'

class Results {
  runs: Run[] = $state.raw([])
  linear: LinearPart | null = $state.raw(null) // null until the core has said it; of two masses that of the slower mode
  modes: ModeNow[] = $state.raw([]) // of two masses, the slower first
  /** Why there is no newer picture: the core's own words. */
  message: Said = $state.raw('')
  resonance: Resonance['curves'] = $state.raw([])
  limits: Record<string, number> = $state.raw({}) // largest stable step [s] of each method that has one
}
const [current, settled] = [new Results(), new Results()]

/** The newest results; a component that reads one of them follows it. */
export const latest = (): Results => current
/** The same for what stands beside the motion: once that has been painted, so that it is seen sooner. */
export const later = (): Results => settled

const afterPaint = (then: () => void): void => void requestAnimationFrame(() => setTimeout(then))

function put(part: Partial<Results>): void {
  Object.assign(current, part)
  afterPaint(() => Object.assign(settled, part))
}

/** `between`: the same run between the steps, where that was asked for. */
function runsOf({ runs }: Motions, between: Answer<'motion'> | undefined): Run[] {
  const finer = between && between.status !== 2 ? between.document.runs : runs
  return runs.map((run: Motion): Run => {
    const same = isContinuous(run.method) && finer.find((each) => each.method === run.method)
    return { ...run, between: same ? same.states : null, forces: (same && same.forces) || run.forces }
  })
}

/** The answers of one mass, or those of each of two modes; each may be followed by the same between the steps. */
function show(answers: Answer<'motion'>[], nothing: boolean, modes: [Mode, Mode] | null): void {
  const bad = answers.find((answer) => answer.status === 2)
  if (bad && bad.status === 2) return put({ message: bad.document.message })
  const each = answers.length / (modes ? 2 : 1)
  const documents = answers.map(({ document }) => document as Motions)
  const parts = (modes ?? [null]).map((_, i) => runsOf(documents[i * each]!, each > 1 ? answers[i * each + 1] : undefined))
  const runs = modes ? parts[0]!.map((run, i) => runOfBoth(modes, [run, parts[1]![i]!])) : parts[0]!
  put({
    runs: nothing ? [] : runs,
    linear: documents[0]!.linear_part, message: '',
    modes: modes ? parts.map((part, i) => ({ linear: documents[i * each]!.linear_part, runs: nothing ? [] : part })) : [],
  })
}

let busy = false
let next: (() => Promise<void>) | undefined
/** Of the questions that come while one is with the worker only the newest is put. */
async function oneByOne(question: () => Promise<void>): Promise<void> {
  next = question
  if (busy) return
  busy = true
  try {
    while (next) {
      const now: typeof question = next
      next = undefined
      await now()
    }
  } finally {
    busy = false
  }
}

let [turn, shown] = [0, 0]
/** Puts the new curves in place, in the same frame where that is possible. `then`: once they are the newest. */
function simulate(state: SimulateState, then: () => void): void {
  const mine = ++turn
  const modes = state.second ? modesOf(state) : null
  const parts = modes ? modes.map((mode) => stateOfMode(state, mode)) : [state]
  const nothing = methodsIn(coreOptions(state)).length === 0 // but what the law is known by
  const all = parts.flatMap((part) => {
    const [options, between] = [coreOptions(part), betweenOptions(part, parts.at(-1))]
    if (nothing) options.push(['method', 'euler-cromer'])
    if (!modes) askForces(options, between)
    return between ? [options, between] : [options]
  })
  // Of linear laws every step costs the same; others may take any number of iterations, or of steps of their own.
  const alike = isLinear(state) && !methodsIn(all[0]!).includes('dormand-prince')
  const cost = (asked: Options): [kind: string, steps: number] =>
    [methodsIn(asked).join(), (methodsIn(asked).length * state.until) / Number(new Map(asked).get('step'))]
  const done = (answers: Answer<'motion'>[]) => {
    shown = mine
    show(answers, nothing, modes)
    afterPaint(then)
  }
  const atOnce = alike ? all.map((asked) => answerAtOnce('motion', asked, ...cost(asked))) : [null]
  if (atOnce.every((answer) => answer !== null)) return done(atOnce)
  void oneByOne(async () => {
    const answers = (await Promise.all(all.map((asked) => ask('motion', asked)))).map((answer) => answer!) // of no channel
    if (alike) answers.forEach(({ took }, i) => learn(...cost(all[i]!), took))
    // The page itself may have been faster with a newer question.
    if (mine >= shown) done(answers)
  })
}
const methodsIn = (options: Options): string[] => options.filter(([name]) => name === 'method').map(([, name]) => name)

const patience = 250 // [ms] after which a curve that is no longer wanted is given up
let curves: ReturnType<typeof openCore> | null = null
let asked = { turn: 0, at: 0, open: false }

/** In a core of its own: a law that is not linear may take seconds. Null where a newer question took its place. */
async function askCurves(options: Options): Promise<Answer<'resonance'> | null> {
  if (asked.open && performance.now() - asked.at > patience) {
    curves?.close()
    curves = null
  }
  curves ??= openCore()
  const turn = (asked = { turn: asked.turn + 1, at: performance.now(), open: true }).turn
  const answer = await curves.ask('resonance', options, { channel: 'resonance' })
  if (turn !== asked.turn) return null
  asked.open = false
  return answer
}

async function resonate(state: SimulateState): Promise<void> {
  if (state.driveAmplitude === 0 || state.methods.length === 0) {
    ++asked.turn
    return put({ resonance: [] })
  }
  const range = resonanceRange(state, current.linear, current.modes[1]?.linear)
  const modes = state.second ? modesOf(state) : null
  const parts = modes ? modes.map((mode) => ({ ...stateOfMode(state, mode), driveAmplitude: state.driveAmplitude })) : [state]
  const found: Resonance['curves'][] = []
  for (const part of parts) {
    const answer = await askCurves(resonanceOptions(part, ...range))
    if (!answer) return
    found.push(answer.status === 2 ? [] : answer.document.curves)
  }
  put({ resonance: modes ? curvesOfBoth(modes, found) : found[0]! })
}

let bounding = 0
async function bound(state: SimulateState): Promise<void> {
  const mine = ++bounding
  const { natural_frequency: frequency = 0, damping_ratio: ratio = 0 } = (current.modes[1] ?? current).linear ?? {}
  if (!isLinear(state) || frequency === 0 || (ratio ?? 0) < 0) return put({ limits: {} })
  const answer = await askAside(
    'effective',
    [['natural-frequency', String(frequency)], ['damping-ratio', String(ratio)], ['step', String(0.01 / frequency)]],
    { channel: 'effective' },
  )
  if (!answer || answer.status === 2 || mine !== bounding) return
  const limits: Record<string, number> = {}
  for (const method of (answer.document as MethodList).methods)
    if (typeof method.stability_limit === 'number') limits[method.name] = method.stability_limit
  put({ limits })
}

/** What the resonance curve depends on. */
const resonanceKey = (state: SimulateState): string =>
  JSON.stringify({ ...state, position: 0, secondPosition: 0, velocity: 0, until: 0, quantity: '', forces: false })
const limitsKey = (s: SimulateState): string =>
  [s.mass, s.stiffness, s.damping, isLinear(s), s.second, s.secondMass, s.secondStiffness, s.coupling].join()
const calm = 120 // [ms] of rest before the limits are asked for

/** Keeps the results up to date for as long as the component lives that calls it: first the curves, then the rest. */
export function followState(): void {
  let [resonanceFor, limitsFor, timer] = ['', '', 0]
  // Before the page is written, so that it is written once.
  $effect.pre(() => {
    const state = $state.snapshot(page.simulate) as SimulateState
    simulate(state, () => {
      if (resonanceFor !== (resonanceFor = resonanceKey(state))) void resonate(state)
      clearTimeout(timer)
      if (limitsFor !== limitsKey(state))
        timer = window.setTimeout(() => {
          limitsFor = limitsKey(state)
          void bound(state)
        }, limitsFor ? calm : 0)
    })
    return () => clearTimeout(timer)
  })
}
