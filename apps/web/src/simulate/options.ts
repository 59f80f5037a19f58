// The state as options of `cromer simulate`: for the core, for a command line, for a study file.
import { isLinear, referenceOf } from './law'
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

export function coreOptions(s: SimulateState): Option[] {
  const every = Math.ceil(s.until / s.step / mostKept)
  const options = lawOptions(s)
  for (const method of methodsOf(s, s.methods.includes('exact') || s.quantity === 'difference')) options.push(['method', method])
  options.push(['step', String(s.step)], ['until', String(s.until)])
  if (every > 1) options.push(['every', String(every)])
  return options
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
  const options = [...lawOptions(s), ...methodsOf(s).map((name): Option => ['method', name])]
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

