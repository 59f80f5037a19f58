// The terms of the law beside spring and damper: what their fields are called, and the program's options.
import type { SimulateState } from './state'

export interface Term {
  key: 'drag' | 'friction' | 'cubic' | 'quadratic' | 'oddQuadratic' | 'quintic' | 'vanDerPol' | 'pendulum'
  option: string
  symbol: string
  unit: string // as written on the page
  typed: string // as the program reads it
}

/** Asked for often. */
export const commonTerms: Term[] = [
  { key: 'drag', option: 'drag', symbol: 'd', unit: 'kg/m', typed: 'kg/m' },
  { key: 'friction', option: 'friction', symbol: 'f', unit: 'N', typed: 'N' },
  { key: 'cubic', option: 'cubic', symbol: 'k<sub>3</sub>', unit: 'N/m³', typed: 'N/m^3' },
]
export const rareTerms: Term[] = [
  { key: 'quadratic', option: 'quadratic', symbol: 'k<sub>2</sub>', unit: 'N/m²', typed: 'N/m^2' },
  { key: 'oddQuadratic', option: 'odd-quadratic', symbol: 'k<sub>a</sub>', unit: 'N/m²', typed: 'N/m^2' },
  { key: 'quintic', option: 'quintic', symbol: 'k<sub>5</sub>', unit: 'N/m⁵', typed: 'N/m^5' },
  { key: 'vanDerPol', option: 'van-der-pol', symbol: 'e', unit: 'kg/(m² s)', typed: 'kg/(m^2 s)' },
  { key: 'pendulum', option: 'pendulum', symbol: 'p', unit: 'N', typed: 'N' },
]
export const terms: Term[] = [...commonTerms, ...rareTerms]

export const allZero = (s: SimulateState, of: Term[]): boolean => of.every(({ key }) => s[key] === 0)
