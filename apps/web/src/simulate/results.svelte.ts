// What the core says to the state of the page: asked anew at every change, the newest question first.
import { untrack } from 'svelte'
import { ask, askAside, openCore } from '../core/ask'
import { answerAtOnce, learn } from '../core/at_once'
import type { Answer, LinearPart, MethodList, Motion, Options, Resonance } from '../core/types'
import { page } from '../state/page.svelte'
import { isLinear } from './law'
import { coreOptions, resonanceOptions } from './options'
import { resonanceRange } from './ranges'
import type { SimulateState } from './state'

interface Results {
  runs: Motion[]
  linear: LinearPart | null // null until the core has said it
  /** Why there is no newer picture: the core's own words. */
  message: string
  resonance: Resonance['curves']
  limits: Record<string, number> // largest stable step [s] of each method that has one
}
let current: Results = $state.raw({ runs: [], linear: null, message: '', resonance: [], limits: {} })

/** The newest results; a component that reads them follows them. */
export const latest = (): Results => current

function put(part: Partial<Results>): void {
  current = { ...untrack(() => current), ...part }
}

function show(answer: Answer<'motion'>, nothing: boolean): void {
  if (answer.status === 2) put({ message: answer.document.message })
  else put({ runs: nothing ? [] : answer.document.runs, linear: answer.document.linear_part, message: '' })
}

let [turn, shown] = [0, 0]
/** Puts the new curves in place, in the same frame where that is possible. `then`: once they are the newest. */
function simulate(state: SimulateState, then: () => void): void {
  const mine = ++turn
  const options = coreOptions(state)
  const methods = options.filter(([name]) => name === 'method').map(([, name]) => name)
  const nothing = methods.length === 0 // but what the law is known by
  if (nothing) options.push(['method', 'euler-cromer'])
  // Of linear laws every step costs the same; others may take any number of iterations, or of steps of their own.
  const alike = isLinear(state) && !methods.includes('dormand-prince')
  const [kind, steps] = [methods.join(), (Math.max(1, methods.length) * state.until) / state.step]
  const atOnce = alike ? answerAtOnce('motion', options, kind, steps) : null
  if (atOnce) {
    shown = mine
    show(atOnce, nothing)
    return then()
  }
  void ask('motion', options, { channel: 'simulate' }).then((answer) => {
    if (!answer) return
    if (alike) learn(kind, steps, answer.took)
    // The page itself may have been faster with a newer question.
    if (mine < shown) return
    shown = mine
    show(answer, nothing)
    then()
  })
}

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
  const answer = await askCurves(resonanceOptions(state, ...resonanceRange(state, current.linear)))
  if (answer) put({ resonance: answer.status === 2 ? [] : answer.document.curves })
}

let bounding = 0
async function bound(state: SimulateState): Promise<void> {
  const mine = ++bounding
  const { natural_frequency: frequency = 0, damping_ratio: ratio = 0 } = current.linear ?? {}
  if (!isLinear(state) || frequency === 0) return put({ limits: {} })
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
  JSON.stringify({ ...state, position: 0, velocity: 0, until: 0, quantity: '' })
const limitsKey = (s: SimulateState): string => [s.mass, s.stiffness, s.damping, isLinear(s)].join()
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
