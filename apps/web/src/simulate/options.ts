// The state as options of `cromer simulate`: for the core, for a command line, for a study file.
import { isContinuous, isLinear, referenceOf } from './law'
import type { SimulateState } from './state'
import { terms } from './terms'

const mostKept = 20_000

type Option = [name: string, value: string]

/** Law, drive and start; of what is zero only what must be said. */
function lawOptions(s: SimulateState): Option[] {
  const options: Option[] = [['mass', String(s.mass)], ['stiffness', String(s.stiffness)]]
  const some = (name: string, value: number) => value !== 0 && options.push([name, String(value)])
  some('damping', s.damping)
  for (const { key, option } of terms) some(option, s[key])
  if (s.driveAmplitude !== 0) options.push(['drive-amplitude', String(s.driveAmplitude)], ['drive-frequency', String(s.driveFrequency)])
  options.push(['position', String(s.position)])
  some('velocity', s.velocity)
  return options
}

/** The methods a run has, the reference first where it is wanted. */
export function methodsOf(s: SimulateState, withReference = s.methods.includes('exact')): string[] {
  const reference = referenceOf(s)
  const others = s.methods.filter((name) => name !== 'exact' && name !== reference)
  const first = withReference || s.methods.includes(reference)
  return first ? [reference, ...others] : others
}

/** Of a method's steps one in so many is kept. */
export const everyOf = (s: SimulateState): number => Math.max(1, Math.ceil(s.until / s.step / mostKept))
const runMethods = (s: SimulateState): string[] => methodsOf(s, s.methods.includes('exact') || s.quantity === 'difference')

function runOptions(s: SimulateState, methods: string[], step: number): Option[] {
  return [...lawOptions(s), ...methods.map((name): Option => ['method', name]), ['step', String(step)], ['until', String(s.until)]]
}

export function coreOptions(s: SimulateState): Option[] {
  const options = runOptions(s, runMethods(s), s.step)
  if (everyOf(s) > 1) options.push(['every', String(everyOf(s))])
  return options
}

const perPeriod = 64 // points that draw a smooth swing
const mostBetween = 100_000

/** The same run between the steps, of the methods that know it; null where there are none or the steps are fine enough.
    `like`: what is as fast, if not itself. */
export function betweenOptions(s: SimulateState, like = s): Option[] | null {
  const methods = runMethods(s).filter(isContinuous)
  const rate = Math.max(Math.sqrt(Math.abs(like.stiffness) / like.mass), like.damping / like.mass)
  const fastest = Math.max(rate, like.driveAmplitude !== 0 ? like.driveFrequency : 0)
  // a spring that hardens swings faster than its stiffness says
  const wanted = ((isLinear(s) ? 1 : 4) * perPeriod * fastest) / (2 * Math.PI)
  const kept = s.step * everyOf(s)
  const pieces = Math.ceil(kept * Math.min(wanted, mostBetween / s.until))
  return methods.length > 0 && pieces > 1 ? runOptions(s, methods, kept / pieces) : null
}

/** Asks for the forces on the mass, which follows the first method: at the states where it is known best. */
export function askForces(options: Option[], between: Option[] | null): void {
  const follows = options.find(([name]) => name === 'method')!
  const has = between?.some(([name, value]) => name === 'method' && value === follows[1])
  ;(has ? between! : options).push(['forces', follows[1]])
}

/** Where the motion must be stepped until it settles the curve has fewer points. */
export function resonanceOptions(s: SimulateState, from: number, to: number): Option[] {
  const drive: Option[] = [['drive-amplitude', String(s.driveAmplitude)], ['drive-frequency', String(s.driveFrequency || 1)]]
  const law = lawOptions(s).filter(([name]) => !name.startsWith('drive') && name !== 'position' && name !== 'velocity')
  // an odd number of points about the natural frequency, so that a sharp peak is not cut
  const options: Option[] = [...law, ...drive, ['frequencies', `${from}:${to}:${isLinear(s) ? 401 : 81}`], ['step', String(s.step)]]
  // with steps of its own there is no closed form, and nothing to see: it keeps to the exact curve
  for (const method of methodsOf(s)) if (!isLinear(s) || method !== 'dormand-prince') options.push(['method', method])
  return options
}

/** What simulates the same in a terminal. */
export function commandLine(s: SimulateState): string {
  const law: Option[] = s.second ? [['network', 'two.toml']] : lawOptions(s)
  const options = [...law, ...methodsOf(s).map((name): Option => ['method', name])]
  options.push(['step', String(s.step)], ['until', String(s.until)])
  return `cromer simulate ${options.map(([name, value]) => `--${name} ${value}`).join(' ')}`
}

const units: Record<string, string> = {
  mass: 'kg', stiffness: 'N/m', damping: 'kg/s', 'drive-amplitude': 'N', 'drive-frequency': 'rad/s', position: 'm', velocity: 'm/s',
  ...Object.fromEntries(terms.map(({ option, typed }) => [option, typed])),
}

/** A study file for `cromer report`: the same runs and a figure of them. */
export function studyFile(s: SimulateState, title: string, caption: string, names: Record<string, string>): string {
  const lines = [`title = "${title}"`, '', '[[task]]', 'simulate = "run"']
  for (const [name, value] of lawOptions(s)) lines.push(`${name.replaceAll('-', '_')} = "${value} ${units[name]}"`)
  lines.push(`method = [${methodsOf(s).map((name) => `"${name}"`).join(', ')}]`)
  lines.push(`step = "${s.step} s"`, `until = "${s.until} s"`, '')
  lines.push('[[figure]]', 'id = "position"', `title = "${title}"`, `caption = "${caption}"`, 'size = "wide"', 'x = "t"', 'y = "x"')
  lines.push('x_name = "time *t* (s)"', 'y_name = "position *x* (m)"', '')
  methodsOf(s).forEach((name, i) => {
    const role = name === referenceOf(s) ? 'exact' : name
    lines.push('[[figure.curve]]', `of = "run.${i + 1}"`, `role = "${role}"`, `name = "${names[name] ?? name}"`, '')
  })
  return lines.join('\n')
}

