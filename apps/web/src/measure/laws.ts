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

const forces: Record<string, string> = {
  viscous: '_c_ _x_′',
  drag: '_d_ |_x_′| _x_′',
  friction: '_f_ sgn _x_′',
  cubic: '_k_₃ _x_³'
}

/// m x″ + c x′ + d |x′| x′ + k x = 0, variables italic; driven with F cos ωt. Of a pendulum x is the angle.
export function equationOf(law: string, driven = false): Part[] {
  const terms = law.split('+')
  const restoring = terms.includes('pendulum') ? '_k_ sin _x_' : '_k_ _x_'
  const damping = terms.map((term) => forces[term]).filter((force) => force && force !== forces.cubic)
  const cubic = terms.includes('cubic') ? [forces.cubic!] : []
  const text = `${['_m_ _x_″', ...damping, restoring, ...cubic].join(' + ')} = ${driven ? '_F_ cos _ωt_' : '0'}`
  return text
    .split('_')
    .map((part, i) => ({ text: part.replaceAll(' ', '\u00a0'), italic: i % 2 === 1 }))
    .filter((part) => part.text !== '')
}
