// The laws that can be fitted to a free motion, as the core names them, and their equations.
import type { Fit } from '../core/types'

/// In the order in which they are offered.
export const laws = [
  'viscous',
  'viscous+drag',
  'drag',
  'viscous+friction',
  'friction',
  'drag+friction',
  'viscous+cubic',
  'viscous+drag+cubic',
  'viscous+drag+friction'
] as const

/// "viscous + dry friction" of "viscous+friction".
export const nameOfLaw = (law: string, names: Record<string, string>): string =>
  law.split('+').map((term) => names[term] ?? term).join(' + ')

/// A drive was found in it, or given.
export const isDriven = (fit: Pick<Fit, 'parameters'>): boolean => 'drive_frequency' in fit.parameters

export interface Part {
  text: string
  italic: boolean
}

/// m x″ + c x′ + d x′|x′| + k x = 0 of the core's formulas ("c x'", "k2 x^2"), variables italic; driven with F cos ωt. Of
/// a pendulum x is the angle.
export function equationOf(formulas: string[], driven = false): Part[] {
  const forces = formulas.map((formula) => formula.split(', ')[0]!)
  // of an inner force how it changes
  const changes = formulas.flatMap((formula) => formula.split(', ').slice(1))
  const damping = forces.filter((force) => force.includes("x'"))
  const others = forces.filter((force) => !damping.includes(force))
  const motion = `${["m x''", ...damping, ...others].join(' + ')} = ${driven ? 'F cos ωt' : '0'}`
  const text = [motion, ...changes].join(', ').replace(/beta/g, 'β').replace(/gamma/g, 'γ').replaceAll(' - ', ' − ')
  return text
    .split(/(sgn|sin|cos|\p{L}+)/u)
    .map((part, i) => ({ text: typeset(part), italic: i % 2 === 1 && !/^(sgn|sin|cos)$/.test(part) }))
    .filter((part) => part.text !== '')
}

const raised: Record<string, string> = { '^2': '²', '^3': '³', '^5': '⁵', "''": '″', "'": '′' }
const typeset = (part: string): string =>
  part
    .replace(/\^\d|'+/g, (mark) => raised[mark] ?? mark)
    .replace(/^\d/, (digit) => '₀₁₂₃₄₅₆₇₈₉'[Number(digit)]!)
    .replace(/^ka$/, 'kₐ')
    .replaceAll(' ', '\u00a0')
