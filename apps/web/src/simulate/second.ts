// A second mass beside the first, joined to it by a spring. Both are damped at one rate, so that each normal mode moves
// as a single oscillator does: the core runs each by the chosen methods, and the masses' motions are sums of the two.
import type { LinearPart, Motion, ResonanceCurve, States } from '../core/types'
import type { Run, RunStates } from './curves'
import type { SimulateState } from './state'
import { withoutTerms } from './presets'

/** x₁ = first · q, x₂ = second · q in the mode's own coordinate q. */
export interface Mode {
  square: number // [1/s²] of its angular frequency, below 0 where it falls away
  first: number // not negative; the larger of both is 1
  second: number
  mass: number // [kg] its own
}

/** The normal modes of the masses without damping, the slower first: (K − ω² M) φ = 0, two masses and three springs. */
export function modesOf({ mass, stiffness, secondMass, secondStiffness, coupling }: SimulateState): [Mode, Mode] {
  const [a, d] = [(stiffness + coupling) / mass, (secondStiffness + coupling) / secondMass]
  const off = coupling / Math.sqrt(mass * secondMass) // of the matrix made symmetric by the roots of the masses
  const turned = Math.atan2(2 * off, d - a) / 2
  const modes = [turned, turned + Math.PI / 2].map((angle): Mode => {
    let [first, second] = [Math.cos(angle) / Math.sqrt(mass), Math.sin(angle) / Math.sqrt(secondMass)]
    const [c, s] = [Math.cos(angle), Math.sin(angle)]
    const square = a * c * c - 2 * off * s * c + d * s * s
    const size = Math.max(Math.abs(first), Math.abs(second)) * (first < 0 ? -1 : 1)
    ;[first, second] = [first / size, second / size].map((part) => (Math.abs(part) < 1e-15 ? 0 : part)) as [number, number]
    return { square, first, second, mass: mass * first * first + secondMass * second * second }
  }) as [Mode, Mode]
  return modes[0].square <= modes[1].square ? modes : [modes[1], modes[0]]
}

/** The mode as the state of a page with one mass. */
export function stateOfMode(s: SimulateState, mode: Mode): SimulateState {
  const part = (x: number, other: number) => (s.mass * mode.first * x + s.secondMass * mode.second * other) / mode.mass
  return {
    ...s, ...withoutTerms, second: false,
    mass: mode.mass, stiffness: mode.mass * mode.square, damping: (s.damping / s.mass) * mode.mass,
    driveAmplitude: mode.first * s.driveAmplitude, position: part(s.position, s.secondPosition), velocity: part(s.velocity, 0),
  }
}

/** What the modes' states add up to; where one of them ends early, up to there. */
function sumOf(modes: [Mode, Mode], [one, two]: [States, States]): RunStates {
  const size = Math.min(one.t.length, two.t.length)
  function sum(a: Float64Array, by: number, b: Float64Array, and: number): Float64Array {
    const all = new Float64Array(size)
    for (let i = 0; i < size; ++i) all[i] = by * a[i]! + and * b[i]!
    return all
  }
  const [slow, fast] = modes
  return {
    t: one.t.subarray(0, size),
    x: sum(one.x, slow.first, two.x, fast.first), v: sum(one.v, slow.first, two.v, fast.first),
    x2: sum(one.x, slow.second, two.x, fast.second),
    energy: sum(one.energy, 1, two.energy, 1),
  }
}

/** The run of both masses from the runs of the modes by one method. */
export function runOfBoth(modes: [Mode, Mode], [one, two]: [Run, Run]): Run {
  const worse = one.status === 'reached_end' ? two : one
  return {
    ...worse, effective: null, stable: one.stable !== false && two.stable !== false, forces: undefined,
    energy_at_end: one.energy_at_end === null || two.energy_at_end === null ? null : one.energy_at_end + two.energy_at_end,
    states: sumOf(modes, [one.states, two.states]),
    between: one.between && two.between ? sumOf(modes, [one.between, two.between]) : null,
  }
}

/** How far the drive swings the first mass, from how its whole force would swing each mode. */
export function curvesOfBoth(modes: [Mode, Mode], [slow, fast]: ResonanceCurve[][]): ResonanceCurve[] {
  return slow!.flatMap((one) => {
    const two = fast!.find(({ method }) => method === one.method)
    if (!two) return []
    if (!one.settled || !two.settled) return one.settled ? two : one
    const amplitude = one.amplitude.map((size, i) => {
      const [a, b] = [modes[0].first ** 2 * size, modes[1].first ** 2 * two.amplitude[i]!]
      return Math.sqrt(a * a + b * b + 2 * a * b * Math.cos(one.phase[i]! - two.phase[i]!))
    })
    return { ...one, amplitude, phase: new Float64Array(), at_drive: null }
  })
}

/** A mode and what each method makes of it. */
export interface ModeNow {
  linear: LinearPart
  runs: Motion[]
}

/** Where both start for a mode alone, with the largest swing that they have now; [m]. */
export function startOf(mode: Mode, s: SimulateState): Partial<SimulateState> {
  const size = Math.max(Math.abs(s.position), Math.abs(s.secondPosition)) || 0.1
  const round = (value: number) => Number(value.toPrecision(6))
  return { position: round(size * mode.first), secondPosition: round(size * mode.second), velocity: 0, driveAmplitude: 0 }
}

/** The network's file: what the program simulates with --network. */
export function networkFile(s: SimulateState): string {
  const mass = (name: string, kg: number, x: number, more: string[] = []) =>
    ['[[mass]]', `name = "${name}"`, `mass = "${kg} kg"`, `position = "${x} m"`, ...more, '']
  const link = (to: string, values: [string, number, string][], from = '') =>
    ['[[link]]', ...(from ? [`from = "${from}"`] : []), `to = "${to}"`, ...values.map(([name, value, unit]) => `${name} = "${value} ${unit}"`), '']
  const driven = [`drive_amplitude = "${s.driveAmplitude} N"`, `drive_frequency = "${s.driveFrequency} rad/s"`]
  const speed = s.velocity === 0 ? [] : [`velocity = "${s.velocity} m/s"`]
  return [
    ...mass('first', s.mass, s.position, [...speed, ...(s.driveAmplitude === 0 ? [] : driven)]),
    ...mass('second', s.secondMass, s.secondPosition),
    ...link('first', [['stiffness', s.stiffness, 'N/m'], ['damping', s.damping, 'kg/s']]),
    ...link('second', [['stiffness', s.secondStiffness, 'N/m'], ['damping', (s.damping / s.mass) * s.secondMass, 'kg/s']]),
    ...link('second', [['stiffness', s.coupling, 'N/m']], 'first'),
  ].join('\n')
}
