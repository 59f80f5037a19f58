// What the core says to the state of the page: asked anew at every change, the newest question first.
import { untrack } from 'svelte'
import { ask, askAside } from '../core/ask'
import type { LinearPart, MethodList, Resonance, Run } from '../core/types'
import { page } from '../state/page.svelte'
import { isLinear } from './law'
import { coreOptions, resonanceOptions } from './options'
import { resonanceRange } from './ranges'
import type { SimulateState } from './state'

interface Results {
  runs: Run[]
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

/** False where a newer question took its place. */
async function simulate(state: SimulateState): Promise<boolean> {
  const options = coreOptions(state)
  const nothing = !options.some(([name]) => name === 'method') // but what the law says of itself
  if (nothing) options.push(['method', 'euler-cromer'])
  const answer = await ask('simulate', options, { channel: 'simulate' })
  if (!answer) return false
  if (answer.status === 2) put({ message: answer.document.message })
  else put({ runs: nothing ? [] : answer.document.runs, linear: answer.document.linear_part, message: '' })
  return true
}

async function resonate(state: SimulateState): Promise<void> {
  if (state.driveAmplitude === 0 || state.methods.length === 0) return put({ resonance: [] })
  const answer = await askAside('resonance', resonanceOptions(state, ...resonanceRange(state, current.linear)), { channel: 'resonance' })
  if (answer) put({ resonance: answer.status === 2 ? [] : (answer.document as Resonance).curves })
}

async function bound(state: SimulateState): Promise<void> {
  const { natural_frequency: frequency = 0, damping_ratio: ratio = 0 } = current.linear ?? {}
  if (!isLinear(state) || frequency === 0) return put({ limits: {} })
  const answer = await askAside(
    'effective',
    [['natural-frequency', String(frequency)], ['damping-ratio', String(ratio)], ['step', String(0.01 / frequency)]],
    { channel: 'effective' },
  )
  if (!answer || answer.status === 2) return
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
  $effect(() => {
    const state = $state.snapshot(page.simulate) as SimulateState
    void simulate(state).then((newest) => {
      if (!newest) return
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
