// What the panel says of each method, from what the core found.
import { percent, significant, withUnit } from '../look/numbers'
import type { LinearPart, Motion } from '../core/types'
import { capital } from '../words/said'
import type { Words } from '../words/words.svelte'

export interface Row {
  method: string
  simulated: number | null // decay rate [1/s]; null: it creeps, or has steps of its own
  frequencyError: number | null // part of one
  stable: boolean
  limit: number | null | undefined // [s]
  energyFactor: number | null // a cycle
}

export function rowsOf(runs: Motion[], linear: LinearPart | null): Row[] {
  const own = linear?.damped_frequency ?? 0
  return runs
    .filter((run) => run.method !== 'exact' && run.effective)
    .map((run) => {
      const frequency = run.effective!.angular_frequency
      return {
        method: run.method,
        simulated: nothing(run.effective!.decay_rate, frequency) ? 0 : run.effective!.decay_rate,
        frequencyError: frequency !== null && own > 0 ? frequency / own - 1 : null,
        stable: run.stable !== false,
        limit: run.stability_limit,
        energyFactor: run.energy_factor_per_cycle ?? null,
      }
    })
}

/// What rounding leaves of a method that adds no damping.
const nothing = (rate: number | null, frequency: number | null): boolean => rate !== null && frequency !== null && Math.abs(rate) < 1e-12 * frequency

/** Of the amplitude in a cycle, as a part of one: grown above 0. */
export const change = (energyFactor: number): number => Math.sqrt(energyFactor) - 1
const asPercent = (part: number): string => percent(Math.abs(part), 2).replace('+', '')

export interface Sentence {
  method: string
  lead: string
  text: string
}

/** One sentence on the worst method. */
export function sentenceOf(rows: Row[], linear: LinearPart | null, words: Words): Sentence {
  const w = words.simulate.panel
  const asked = linear?.decay_rate ?? 0
  const digits = (value: number) => fixedLike(value)
  const say = (row: Row, text: (name: string) => string): Sentence => {
    const lead = capital(words.methods[row.method] ?? row.method)
    return { method: row.method, lead, text: text(lead) }
  }
  if (rows.length === 0 || !linear) return { method: '', lead: '', text: w.exactOnly }
  const swinging = rows.filter((row) => row.simulated !== null)
  const off = (row: Row) => Math.abs(row.simulated! - asked)
  const worst = [...swinging].sort((a, b) => off(b) - off(a))[0]
  const isOff = worst && off(worst) > 0.005 * Math.abs(asked) && off(worst) > 1e-6 * linear.natural_frequency && worst.energyFactor !== null
  if (asked < 0) return isOff ? say(worst, (name) => w.otherRate(name, digits(asked), digits(worst.simulated!))) : { method: '', lead: '', text: w.lawGrows }
  const growing = rows.filter((row) => !row.stable).sort((a, b) => (a.simulated ?? -Infinity) - (b.simulated ?? -Infinity))[0]
  if (growing) {
    const limit = withUnit(significant(growing.limit ?? 0, 3), 's')
    const { simulated, energyFactor } = growing
    if (simulated === null || energyFactor === null) return say(growing, (name) => w.growsFast(name, limit))
    const by = asPercent(change(energyFactor))
    return growing.limit
      ? say(growing, (name) => w.growsBelow(name, digits(asked), digits(simulated), by, limit))
      : say(growing, (name) => w.growsAlways(name, digits(-simulated), by))
  }
  if (!worst) return { method: '', lead: '', text: w.creep }
  if (isOff) {
    const loses = asPercent(change(worst.energyFactor!))
    const should = asPercent(change(linear.energy_factor_per_cycle))
    const text = worst.simulated! > asked ? w.adds : w.takes
    if (loses === should) return say(worst, (name) => w.otherRate(name, digits(asked), digits(worst.simulated!)))
    return say(worst, (name) => text(name, digits(asked), digits(worst.simulated!), loses, should))
  }
  const slowest = swinging.reduce((a, b) => (Math.abs(b.frequencyError ?? 0) > Math.abs(a.frequencyError ?? 0) ? b : a))
  return { method: slowest.method, lead: '', text: w.fine(words.methods[slowest.method] ?? '', percent(slowest.frequencyError ?? 0)) }
}

/** Decay rates: four places where that shows three digits. */
export function fixedLike(value: number): string {
  const size = Math.abs(value)
  return size >= 0.01 && size < 100 ? significant(value, size >= 1 ? 5 : size >= 0.1 ? 4 : 3) : significant(value, 3)
}
